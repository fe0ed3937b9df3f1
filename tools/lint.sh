#!/usr/bin/env bash
# Format, layers, and clang-tidy, the files that changed last first (a header counts as its .cpp).
# LINT_SECONDS stops after so long without starting another file: CI sees what is new, `make lint` sees all.
set -euo pipefail
cd "$(dirname "$0")/.."
python3 tools/check_layers.py
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
export BUILD=${BUILD:-build/release}

newest_first() {
  { git diff --name-only HEAD -- src apps; git log --format= --name-only -- src apps; git ls-files src apps; } |
    sed 's/\.hpp$/.cpp/' | grep '\.cpp$' | awk '!seen[$0]++' | while read -r file; do
      if [ -f "$file" ]; then echo "$file"; fi
    done
}
export LINT_UNTIL=$(($(date +%s) + ${LINT_SECONDS:-1000000}))
lint_one() {
  if [ "$(date +%s)" -ge "$LINT_UNTIL" ]; then
    echo "later: $1"
  elif said=$(clang-tidy -p "$BUILD" --quiet --extra-arg=-Wno-unknown-warning-option "$1" 2>&1); then
    echo "clean: $1"
  else
    echo "$said"
    return 1
  fi
}
export -f lint_one
log=$BUILD/lint.log
newest_first | xargs -P "$(nproc)" -n 1 bash -c 'lint_one "$0"' >"$log" || { grep -v '^clean:\|^later:' "$log"; exit 1; }
echo "clang-tidy: $(grep -c '^clean:' "$log") files clean, $(grep -c '^later:' "$log" || true) not reached"
