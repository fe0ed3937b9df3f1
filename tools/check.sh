#!/usr/bin/env bash
# What must hold on every commit: tests, comparisons with exact and published numbers, layers, format,
# clang-tidy, a minute of nonsense for readers.
set -euo pipefail
cd "$(dirname "$0")/.."
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ctest --preset verify
build/release/porefines validate --quick -o build/validate
tools/lint.sh 10 40  # more would not leave room for the tests in 25 minutes; make lint does all
FUZZ_SEED=1 FUZZ_SECONDS=60 tools/fuzz.sh
