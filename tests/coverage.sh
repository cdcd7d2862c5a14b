#!/usr/bin/env bash
# Line coverage of the libraries by all tests:
#   tests/coverage.sh            builds with the preset `coverage`, runs ctest, prints a table
#   tests/coverage.sh --report   prints the table anew from the last run
# Fails below 90 % of surface/ and sim_bridge/ or 80 % of render/. The table's last column names the
# lines that no test reaches; build/coverage/coverage.html shows them. Needs gcovr.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v gcovr >/dev/null || { echo "coverage: gcovr is missing: apt-get install gcovr" >&2; exit 1; }

build=build/coverage
if [[ "${1:-}" != --report ]]; then
  cmake --preset coverage -DSEAWAY_BENCHMARKS=OFF
  cmake --build --preset coverage
  find "$build" -name '*.gcda' -delete
  # Counters are plain (-fprofile-update=single) and exact all the same: each test keeps to one core,
  # where no two threads count at once.
  cores=($(python3 -c 'import os; print(*sorted(os.sched_getaffinity(0)))'))
  shares=()
  for index in "${!cores[@]}"; do
    # Archives that count want a consumer that counts: that of an installed tree does not.
    taskset --cpu-list "${cores[$index]}" ctest --preset coverage \
      --exclude-regex '^Package.install$' --output-log "$PWD/$build/tests_$index.log" \
      --tests-information "$((index + 1)),,${#cores[@]}" >/dev/null &
    shares+=($!)
  done
  for share in "${shares[@]}"; do
    wait "$share" || echo "coverage: some tests failed; what they reached counts" >&2
  done
  tail -n 20 "$build"/tests_*.log
fi

tracefile="$build/coverage.json"
if [[ "${1:-}" != --report || ! -e "$tracefile" ]]; then
  gcovr --root . --object-directory "$build" --filter surface/ --filter render/ --filter sim_bridge/ \
    --exclude-directories CompilerId --exclude-unreachable-branches --gcov-ignore-parse-errors \
    --json "$tracefile" -j "$(nproc)" "$build"
fi
gcovr --root . --add-tracefile "$tracefile" --html-details "$build/coverage.html"
status=0
for room in surface:90 render:80 sim_bridge:90; do
  echo "== ${room%:*}/, asked: ${room#*:} % of lines"
  gcovr --root . --add-tracefile "$tracefile" --filter "${room%:*}/" --sort-uncovered \
    --fail-under-line "${room#*:}" || status=1
done
exit "$status"
