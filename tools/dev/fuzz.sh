#!/usr/bin/env bash
# Fuzzes for a while: every fuzzer gets an equal share of the time.  Findings are kept in build/found/FUZZER
# and named; exit code 1 when there is one, or where a fuzzer does not run.
#
#   tools/dev/fuzz.sh HOURS        0.1 is six minutes
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

hours=${1:-}
if ! [[ "$hours" =~ ^[0-9]+(\.[0-9]+)?$ ]]; then
  echo "usage: tools/dev/fuzz.sh HOURS, for example 0.5" >&2
  exit 2
fi
source tools/dev/debian.sh
mkdir -p build
G31_PACKAGES+=(clang-14 libclang-rt-14-dev)
g31_install_packages build/apt.log

declare -A corpus=()
fuzzers=()
while read -r fuzzer entry seeds; do
  fuzzers+=("$fuzzer")
  corpus[$fuzzer]=$seeds
done < <(sed -nE 's/^ *g31_fuzzer\(([a-z_]+ [a-z_]+ [a-z_]+)\)$/\1/p' tests/fuzz/CMakeLists.txt)
g31_build fuzz "${fuzzers[@]}"

seconds=$(awk -v hours="$hours" -v count="${#fuzzers[@]}" 'BEGIN { printf "%d", hours * 3600 / count + 0.999 }')
if [ "$seconds" -lt 1 ]; then
  echo "tools/dev/fuzz.sh: HOURS is more than 0" >&2
  exit 2
fi
found=0
for fuzzer in "${fuzzers[@]}"; do
  folder=build/found/$fuzzer
  dialect=${corpus[$fuzzer]}
  mkdir -p "$folder/inputs" "$folder/findings"
  echo "$fuzzer: $seconds s"
  # A finding ends one job of -fork; the others go on until the time is up, and the exit code is 0.
  if ! "build/fuzz/tests/fuzz/$fuzzer" "$folder/inputs" "tests/fuzz/corpus/$dialect" \
      "-dict=tests/fuzz/$dialect.dict" "-artifact_prefix=$folder/findings/" -max_len=4096 -timeout=20 \
      -rss_limit_mb=2048 -max_total_time="$seconds" -fork="$(nproc)" \
      -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 >"$folder/log" 2>&1; then
    echo "$fuzzer did not run to its end: $folder/log" >&2
    found=1
  fi
  tail -n 1 "$folder/log"
  for finding in "$folder"/findings/*; do
    if [ -e "$finding" ]; then
      echo "found: $finding"
      found=1
    fi
  done
done
exit "$found"
