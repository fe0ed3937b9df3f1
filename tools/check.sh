#!/usr/bin/env bash
# What must hold on every commit: layers, format, tests, and a minute of nonsense for the readers.
set -euo pipefail
cd "$(dirname "$0")/.."
python3 tools/check_layers.py
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ctest --preset verify
FUZZ_SEED=1 FUZZ_SECONDS=60 tools/fuzz.sh
