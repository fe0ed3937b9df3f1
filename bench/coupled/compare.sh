#!/usr/bin/env bash
# SPDX-License-Identifier: MPL-2.0
# A coupled step of porefines against one of the thesis's kind, and what a pore volume costs with each.
#   bench/coupled/compare.sh [--steps N] [-o FOLDER]
# Installs OpenFOAM and LIGGGHTS (Debian packages) where they are missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$root/bench/need_packages.sh"
need_packages openfoam liggghts python3-numpy python3-scipy python3-pil time
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export PF=${PF:-$root/build/release/porefines}
[ -x "$PF" ] || { echo "no program at $PF: run make build, or set PF"; exit 2; }
export PYTHONPATH=$root/bench/openfoam:$root/bench/liggghts
exec /usr/bin/python3 "$here/compare.py" "$@"
