#!/usr/bin/env bash
# The tests that must pass on every commit.
set -euo pipefail
cd "$(dirname "$0")/.."
python3 tools/check_layers.py
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
exec ctest --preset verify
