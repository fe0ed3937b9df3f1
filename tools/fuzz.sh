#!/usr/bin/env bash
# Feeds every reader with nonsense under the sanitizers: FUZZ_SECONDS (default 60) for each target.
# Seeds are in tests/fuzz/corpus/<name>; what is found goes to build/fuzz/found/<name>.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${FUZZ_SECONDS:-60}
cmake --preset fuzz -Wno-dev >/dev/null
targets=()
for source in tests/fuzz/fuzz_*.cpp; do
  targets+=("$(basename "$source" .cpp)")
done
cmake --build --preset fuzz --target "${targets[@]}"
for target in "${targets[@]}"; do
  name=${target#fuzz_}
  work=build/fuzz/found/$name
  mkdir -p "$work/corpus" "$work/crashes"
  echo "$target: $seconds s"
  program=$(find build/fuzz -type f -name "$target" -perm -u+x | head -n 1)
  "$program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=65536 -verbosity=0 \
    -print_final_stats=1 -artifact_prefix="$work/crashes/" "$work/corpus" "tests/fuzz/corpus/$name"
done
echo "nothing found"
