#!/usr/bin/env bash
# Hands made-up bytes to everything that takes bytes from outside, with libFuzzer, and counts what
# breaks. Needs a bare Debian 12 and installs what is missing. New inputs go to build/fuzz/inputs, where
# the next run goes on; the inputs that broke something to build/fuzz/findings.
#
#   bash scripts/fuzz.sh SECONDS              all targets, for so long each, as many at once as there
#                                             are processors
#   bash scripts/fuzz.sh SECONDS TARGET...    those of tests/fuzz/targets that are named
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

usage() { say "usage: bash scripts/fuzz.sh SECONDS [TARGET...]"; exit 2; }

[[ ${1:-} =~ ^[1-9][0-9]*$ ]] || usage
seconds=$1
shift
known=()
for source in tests/fuzz/targets/*.cpp; do known+=("$(basename "$source" .cpp)"); done
targets=("$@")
if (($# == 0)); then targets=("${known[@]}"); fi
for target in "${targets[@]}"; do
  if [[ ! -f tests/fuzz/targets/$target.cpp ]]; then
    say "there is no target '$target'. There are ${known[*]}."
    exit 2
  fi
done

folder=build/fuzz

# Runs one target until its time is over or it has found something. An input may take ten seconds, and
# memory in proportion: no target needs nearly as much at once as it gets here. Entropic schedules cost
# the targets with trees more time than the runs themselves.
run_target() {
  local target=$1 inputs=$folder/inputs/$1 findings=$folder/findings/$1
  local options=(-max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=64 -entropic=0
                 -print_final_stats=1 -artifact_prefix="$findings/")
  mkdir -p "$inputs" "$findings"
  if [[ -f tests/fuzz/dictionaries/$target.dict ]]; then
    options+=(-dict="tests/fuzz/dictionaries/$target.dict")
  fi
  "$folder/bin/fuzz_$target" "${options[@]}" "$inputs" "tests/fuzz/corpus/$target" \
    >"$folder/logs/$target" 2>&1 || echo "$?" >"$folder/logs/$target.failed"
}

# row TARGET: its line of the table, from its log.
row() {
  local target=$1 log=$folder/logs/$1 executions coverage elapsed findings=0
  executions=$(sed -nE 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)
  coverage=$(grep -aoP 'cov: \K[0-9]+' "$log" | tail -n 1) || true
  elapsed=$(<"$log.seconds")
  if [[ -f $log.failed ]]; then findings=1; fi
  printf '%-16s %12s %8s %9s %9d\n' "$target" "${executions:--}" \
         "$(printf '%d.%d' $((elapsed / 60)) $((elapsed % 60 / 6)))" "${coverage:--}" "$findings"
}

# tell TARGET: what it has found, where the input lies, and how to see it again.
tell() {
  local target=$1 log=$folder/logs/$1 input
  say "$target has found something; all it said is in $log:"
  grep -aE -A 3 'BROKEN PROMISE|ERROR: |runtime error|SUMMARY|terminate called' "$log" |
    head -n 12 >&2 || true
  input=$(grep -aoP 'Test unit written to \K.*' "$log" | tail -n 1) || true
  if [[ -n $input ]]; then
    say "to see it again:  $folder/bin/fuzz_$target $input"
    say "to keep it:       add the file to tests/fuzz/corpus/$target, where ctest runs it"
  fi
}

require_packages build fuzz
say "building in $folder"
cmake --preset fuzz
cmake --build "$folder" --parallel "$(nproc)" --target fuzz_targets
mkdir -p "$folder/logs"
rm -f "$folder"/logs/*

say "running ${#targets[@]} targets for $seconds s each"
for target in "${targets[@]}"; do
  while (($(jobs -rp | wc -l) >= $(nproc))); do wait -n || true; done
  {
    start=$SECONDS
    run_target "$target"
    echo $((SECONDS - start)) >"$folder/logs/$target.seconds"
  } &
done
wait

printf '%-16s %12s %8s %9s %9s\n' target executions minutes coverage findings
open=0
for target in "${targets[@]}"; do
  row "$target"
  if [[ -f $folder/logs/$target.failed ]]; then open=$((open + 1)); fi
done
for target in "${targets[@]}"; do
  if [[ -f $folder/logs/$target.failed ]]; then tell "$target"; fi
done
printf 'open findings: %d\n' "$open"
exit $((open > 0))
