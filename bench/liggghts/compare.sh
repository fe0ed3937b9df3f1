#!/usr/bin/env bash
# SPDX-License-Identifier: MPL-2.0
# porefines' particles against LIGGGHTS 3.8 on the same spheres, in turn on this machine.
#   bench/liggghts/compare.sh [--quick] [--ranks "1 2"] [-o FOLDER]
# Installs LIGGGHTS (Debian package) where it is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$root/bench/need_packages.sh"
need_packages liggghts python3-numpy python3-scipy
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1
export DEM_SPEED=${DEM_SPEED:-$root/build/release/bench/dem_speed}
[ -x "$DEM_SPEED" ] || { echo "no program at $DEM_SPEED: run cmake --build --preset release --target dem_speed"; exit 2; }
exec /usr/bin/python3 "$here/compare.py" "$@"
