#!/usr/bin/env bash
# What must hold on every commit: tests, layers, format, clang-tidy, a minute of nonsense for readers.
set -euo pipefail
cd "$(dirname "$0")/.."
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ctest --preset verify
tools/lint.sh 16 64
FUZZ_SEED=1 FUZZ_SECONDS=60 tools/fuzz.sh
