#!/usr/bin/env bash
# SPDX-License-Identifier: MPL-2.0
# porefines against OpenFOAM on the same voxels, one core each: time, memory, permeability.
#   bench/openfoam/compare.sh [--large] [--snappy] [--runs N] [-o FOLDER]
# Installs OpenFOAM (Debian package, about 300 MB on disk) where it is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$root/bench/need_packages.sh"
need_packages openfoam python3-numpy python3-pil time
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export PF=${PF:-$root/build/release/porefines}
[ -x "$PF" ] || { echo "no program at $PF: run make build, or set PF"; exit 2; }
exec /usr/bin/python3 "$here/compare.py" "$@"
