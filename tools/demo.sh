#!/bin/sh
# The bundled case from an image to its permeability: draw the chip, look at it, run it.
set -eu
cd "$(dirname "$0")/.."
PF=${PF:-build/release/porefines}
CASE=cases/micromodel
OUT=${OUT:-out/micromodel}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
RANKS=${RANKS:-2}

if [ ! -f "$CASE/micromodel.png" ]; then
  echo "1. Drawing an etched chip: irregular grains, porosity 0.5, no throat under 12 um."
  "$PF" generate micromodel --size "1.2 mm" "0.9 mm" --pixel-size "2 um" --grain "60 um" \
    --porosity 0.5 --throat "12 um" --seed 2021 -o "$CASE/micromodel.png"
else
  echo "1. The chip is there: $CASE/micromodel.png"
fi
echo
echo "2. Looking at the geometry as porefines understands it."
"$PF" inspect "$CASE/case.toml" -o "$OUT/geometry"
echo
echo "3. Solving the flow on $RANKS processes."
mpirun --oversubscribe -n "$RANKS" "$PF" run "$CASE/case.toml" -o "$OUT"

value() {
  printf "$2" "$(sed -n "s/^ *\"$1\": \([^,]*\),*$/\1/p" "$OUT/summary.json")"
}
echo
echo "Done in $(value wall_time_s "%.1f") s of simulation. What you have now:"
echo "  permeability   $(value permeability_darcy "%.4g") darcy"
echo "  porosity       $(value porosity "%.4f")"
echo "  $OUT/speed.png, pressure.png     pictures of the flow"
echo "  $OUT/geometry/                   pictures and numbers of the pores"
echo "  $OUT/summary.json                every number"
echo "  $OUT/fields.xdmf                 opens in ParaView"
echo
echo "Next: put your own image and its pixel size into a copy of $CASE/case.toml, and"
echo "  $PF run CASE.toml --dry-run   tells what it will cost before it runs."
