#!/usr/bin/env bash
# Format, layers, and clang-tidy, the files that changed last first (a header counts as its .cpp, or
# as one that includes it).
#   tools/lint.sh        every rule of .clang-tidy on every file: about 10 s each
#   tools/lint.sh 10 40  every rule on 10 files, on 40 more those that find mistakes cheaply, about
#                        3 s each: numbers, not seconds, so that it covers the same on any machine
set -euo pipefail
cd "$(dirname "$0")/.."
python3 tools/check_layers.py
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
export BUILD=${BUILD:-build/release}
export FULL=${1:-1000000}
quick=${2:-0}
QUICK='-*,clang-diagnostic-*,bugprone-use-after-move,bugprone-dangling-handle,bugprone-infinite-loop'
QUICK+=',bugprone-sizeof-*,bugprone-string-*,bugprone-integer-division,bugprone-copy-constructor-init'
QUICK+=',bugprone-undefined-memory-manipulation,cppcoreguidelines-init-variables,cppcoreguidelines-slicing'
QUICK+=',google-build-using-namespace,google-explicit-constructor,misc-definitions-in-headers'
QUICK+=',misc-redundant-expression,modernize-use-nullptr,modernize-use-override'
QUICK+=',performance-for-range-copy,performance-unnecessary-value-param'
export QUICK

newest_first() {
  { git diff --name-only HEAD -- src apps; git log --format= --name-only -- src apps; git ls-files src apps; } |
    awk '!seen[$0]++' | while read -r file; do
      source=${file%.?pp}.cpp
      if [ -f "$source" ]; then
        echo "$source"
      elif [ -f "$file" ] && [ "${file##*.}" = hpp ]; then
        { git grep -l "\"${file#src/}\"" -- 'src/*.cpp' 'apps/*.cpp' || true; } | head -n 1
      fi
    done | grep '\.cpp$' | awk '!seen[$0]++ { print ++n, $0 }'
}
lint_one() {
  local rules=()
  [ "$1" -le "$FULL" ] || rules=(--checks="$QUICK")
  if said=$(clang-tidy -p "$BUILD" --quiet "${rules[@]}" --extra-arg=-Wno-unknown-warning-option "$2" 2>&1); then
    echo "clean: $2"
  else
    echo "$said"
    return 1
  fi
}
export -f lint_one
log=$BUILD/lint.log
newest_first >"$log.files"
head -n $((FULL + quick)) "$log.files" | xargs -P "$(nproc)" -n 2 bash -c 'lint_one "$0" "$1"' >"$log" ||
  { grep -v '^clean:' "$log"; exit 1; }
all=$(wc -l <"$log.files")
clean=$(grep -c '^clean:' "$log")
echo "clang-tidy: $clean of $all files clean, the $((FULL < clean ? FULL : clean)) changed last by every rule; see $log"
