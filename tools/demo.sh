#!/bin/sh
# The bundled cases: an etched chip from its image to its permeability, then fines that clog one.
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
echo "4. Fines of 9 um in a smaller window, for a minute or two: some pass, some are caught."
FINES=cases/fines
if [ ! -f "$FINES/chip.png" ]; then
  "$PF" generate micromodel --size "0.3 mm" "0.2 mm" --pixel-size "1 um" --grain "40 um" \
    --porosity 0.5 --throat "9 um" --seed 2021 -o "$FINES/chip.png"
fi
mpirun --oversubscribe -n "$RANKS" "$PF" run "$FINES/case.toml" -o "$OUT/fines"

echo
echo "Done in $(value wall_time_s "%.1f") s of simulation. What you have now:"
echo "  permeability   $(value permeability_darcy "%.4g") darcy"
echo "  porosity       $(value porosity "%.4f")"
echo "  $OUT/speed.png, pressure.png     pictures of the flow"
echo "  $OUT/geometry/                   pictures and numbers of the pores"
echo "  $OUT/summary.json                every number"
echo "  $OUT/fields.xdmf                 opens in ParaView"
"$PF" report "$OUT" >/dev/null
"$PF" report "$OUT/fines" >/dev/null
fines() {
  printf "$2" "$(sed -n "s/^ *\"$1\": \([^,]*\),*$/\1/p" "$OUT/fines/summary.json")"
}
echo "and of the fines: $(fines particles_injected "%d") came in, $(fines particles_out "%d") left, k/k0 is $(fines permeability_ratio "%.3f") now:"
echo "  $OUT/fines/particles.png         where they are: piping, bridging, clogged"
echo "  $OUT/fines/movie.mp4             how they came there"
echo "  $OUT/fines/clogging.csv          which throat clogged when, by whom"
echo "  $OUT/fines/series.csv            k/k0, concentrations, spread against pore volumes"
echo "  $OUT/fines/tracks.csv            every fine's way"
echo
echo "Open in a browser, also offline: everything above on one page, with plots and a player of the fines"
echo "  $OUT/fines/report.html, $OUT/report.html"
echo
echo "Next: put your own image and its pixel size into a copy of $CASE/case.toml, and"
echo "  $PF run CASE.toml --dry-run   tells what it will cost before it runs."
