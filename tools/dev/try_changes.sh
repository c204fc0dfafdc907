#!/usr/bin/env bash
# Tries counted changes of the fuzzers' seeds, always the same ones, a process for each core.
#
#   tools/dev/try_changes.sh BUILD TIMES     build/sanitize 24: 24 times as many as a test run, some two minutes of
#                                            processor time
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

build=${1:?BUILD}
export G31_FUZZ_EFFORT=${2:?TIMES}
export UBSAN_OPTIONS=print_stacktrace=1

share() {
  G31_FUZZ_SHARE=$1/$(nproc) "$build/tests/fuzz/fuzz_test" --gtest_filter='Fuzz.Any*' >"$build/changes-$1.log" 2>&1
}

processes=()
for number in $(seq "$(nproc)"); do
  share "$number" &
  processes+=($!)
done
failed=0
for number in $(seq "$(nproc)"); do
  if ! wait "${processes[number - 1]}"; then
    failed=1
    tail -n 60 "$build/changes-$number.log" >&2
    echo "with the changed text above it: G31_FUZZ_TRACE=1 G31_FUZZ_EFFORT=$2 G31_FUZZ_SHARE=$number/$(nproc)" \
      "$build/tests/fuzz/fuzz_test --gtest_filter='Fuzz.Any*'" >&2
  fi
done
exit "$failed"
