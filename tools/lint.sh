#!/usr/bin/env bash
# Format, layers, and clang-tidy, the files that changed last first (a header counts as its .cpp).
#   tools/lint.sh        every rule of .clang-tidy: about 10 s a file
#   tools/lint.sh quick  the rules that find mistakes cheaply: about 3 s a file; this is what CI runs
# LINT_SECONDS starts no further file after so long, so that CI stays short on a slow machine.
set -euo pipefail
cd "$(dirname "$0")/.."
python3 tools/check_layers.py
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
export BUILD=${BUILD:-build/release}
export RULES=
if [ "${1:-}" = quick ]; then
  RULES='-*,clang-diagnostic-*,bugprone-use-after-move,bugprone-dangling-handle,bugprone-infinite-loop'
  RULES+=',bugprone-sizeof-*,bugprone-string-*,bugprone-integer-division,bugprone-copy-constructor-init'
  RULES+=',bugprone-undefined-memory-manipulation,cppcoreguidelines-init-variables,cppcoreguidelines-slicing'
  RULES+=',google-build-using-namespace,google-explicit-constructor,misc-definitions-in-headers'
  RULES+=',misc-redundant-expression,modernize-use-nullptr,modernize-use-override'
  RULES+=',performance-for-range-copy,performance-unnecessary-value-param'
fi

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
  elif said=$(clang-tidy -p "$BUILD" --quiet ${RULES:+--checks="$RULES"} \
      --extra-arg=-Wno-unknown-warning-option "$1" 2>&1); then
    echo "clean: $1"
  else
    echo "$said"
    return 1
  fi
}
export -f lint_one
log=$BUILD/lint.log
newest_first | xargs -P "$(nproc)" -n 1 bash -c 'lint_one "$0"' >"$log" || { grep -v '^clean:\|^later:' "$log"; exit 1; }
echo "clang-tidy: $(grep -c '^clean:' "$log" || true) files clean, $(grep -c '^later:' "$log" || true) not reached"
