#!/usr/bin/env bash
# What must hold on every commit: layers, format, tests; a minute of nonsense for the readers; clang-tidy
# on what changed last, as many files as four minutes allow (`make lint` takes all).
set -euo pipefail
cd "$(dirname "$0")/.."
python3 tools/check_layers.py
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ctest --preset verify
FUZZ_SEED=1 FUZZ_SECONDS=60 tools/fuzz.sh
LINT_SECONDS=${LINT_SECONDS:-240} tools/lint.sh
