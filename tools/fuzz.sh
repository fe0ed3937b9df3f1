#!/usr/bin/env bash
# Feeds every reader with nonsense under the sanitizers, all at once, for FUZZ_SECONDS (default 60).
# Seeds are in tests/fuzz/corpus/<name>; what is found goes to build/fuzz/found/<name>. With FUZZ_SEED a
# run begins alike every time and keeps nothing from the one before (CI does so).
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${FUZZ_SECONDS:-60}
cmake --preset fuzz -Wno-dev >/dev/null
targets=()
for source in tests/fuzz/fuzz_*.cpp; do
  targets+=("$(basename "$source" .cpp)")
done
cmake --build --preset fuzz --target "${targets[@]}"

fuzz() {
  local name=${1#fuzz_}
  local work=build/fuzz/found/$name
  [ -z "${FUZZ_SEED:-}" ] || rm -rf "$work/corpus"
  mkdir -p "$work/corpus" "$work/crashes"
  local program
  program=$(find build/fuzz -type f -name "$1" -perm -u+x | head -n 1)
  "$program" -max_total_time="$seconds" -timeout=30 -rss_limit_mb=2048 -max_len=65536 -verbosity=0 \
    -seed="${FUZZ_SEED:-0}" -print_final_stats=1 -artifact_prefix="$work/crashes/" "$work/corpus" \
    "tests/fuzz/corpus/$name" >"$work/log" 2>&1
}
declare -A job
for target in "${targets[@]}"; do
  fuzz "$target" &
  job[$target]=$!
done
failed=0
for target in "${targets[@]}"; do
  log=build/fuzz/found/${target#fuzz_}/log
  if wait "${job[$target]}"; then
    echo "$target: nothing found in $(awk '/number_of_executed_units/ {print $2}' "$log") inputs"
  else
    failed=1
    tail -n 40 "$log"
    echo "$target: found something; it is in build/fuzz/found/${target#fuzz_}/crashes"
  fi
done
exit $failed
