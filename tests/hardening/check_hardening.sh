#!/usr/bin/env bash
# check_hardening.sh PROGRAM...: whether each is hardened as PLANETREE_HARDENING promises, by what
# readelf says of the file.
set -euo pipefail
export LC_ALL=C

failures=0
check() {
  local what=$1
  shift
  if ! "$@"; then
    echo "FAILED: $program: $what"
    failures=$((failures + 1))
  fi
}

is_position_independent() {
  grep -q 'Type: *DYN' <<<"$header" && grep -q 'FLAGS_1.* PIE' <<<"$dynamic"
}
is_relocated_at_start() {
  grep -q 'GNU_RELRO' <<<"$segments" && grep -Eq '(BIND_NOW|FLAGS_1.* NOW)' <<<"$dynamic"
}
# The last word but one of the line is what may be done with the stack: RW, never RWE.
has_stack_of_data() {
  awk '$1 == "GNU_STACK" { found = 1; if ($0 ~ /RWE/) bad = 1 } END { exit !(found && !bad) }' \
    <<<"$segments"
}
has_no_segment_to_write_and_run() {
  awk '$1 == "LOAD" && $0 ~ /RWE/ { bad = 1 } END { exit bad }' <<<"$segments"
}
has_stack_protector() { grep -q '__stack_chk_fail' <<<"$symbols"; }
has_checked_sizes() { grep -Eq 'UND __[a-z]+_chk(@|$)' <<<"$symbols"; }

for program in "$@"; do
  header=$(readelf -hW "$program")
  segments=$(readelf -lW "$program")
  dynamic=$(readelf -dW "$program")
  symbols=$(readelf -W --dyn-syms "$program" | sed -E 's/ +/ /g')
  check 'is not position independent (PIE)' is_position_independent
  check 'is not relocated at start and then closed (full RELRO)' is_relocated_at_start
  check 'has a stack that can be run' has_stack_of_data
  check 'has memory that can be both written and run' has_no_segment_to_write_and_run
  check 'has no protected stacks (-fstack-protector-strong)' has_stack_protector
  # A small program may have no use for any.
  if [[ $program == */planetree ]]; then
    check 'calls no function of the C library that checks sizes (_FORTIFY_SOURCE)' has_checked_sizes
  fi
done
exit $((failures > 0))
