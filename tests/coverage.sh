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
  ctest --preset coverage || echo "coverage: some tests failed; what they reached counts" >&2
fi

tracefile="$build/coverage.json"
if [[ "${1:-}" != --report || ! -e "$tracefile" ]]; then
  gcovr --root . --object-directory "$build" --filter surface/ --filter render/ --filter sim_bridge/ \
    --exclude-unreachable-branches --gcov-ignore-parse-errors --json "$tracefile" -j "$(nproc)" "$build"
fi
gcovr --root . --add-tracefile "$tracefile" --html-details "$build/coverage.html"
status=0
for room in surface:90 render:80 sim_bridge:90; do
  echo "== ${room%:*}/, asked: ${room#*:} % of lines"
  gcovr --root . --add-tracefile "$tracefile" --filter "${room%:*}/" --sort-uncovered \
    --fail-under-line "${room#*:}" || status=1
done
exit "$status"
