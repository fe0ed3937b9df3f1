#!/usr/bin/env bash
# Format, layers, and clang-tidy on the files that the build knows.
set -euo pipefail
cd "$(dirname "$0")/.."
python3 tools/check_layers.py
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
cmake --preset release -Wno-dev >/dev/null
git ls-files 'src/*.cpp' 'apps/*.cpp' | xargs -P "$(nproc)" -n 4 clang-tidy -p build/release --quiet --extra-arg=-Wno-unknown-warning-option
