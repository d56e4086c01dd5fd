#!/bin/sh
# Measures how many lines of the core its tests execute, and fails below 90 %. Leaves the report in build/coverage/report:
# coverage.html (one page a file, beside it) and coverage.txt.
#
#   sh tests/coverage.sh
set -eu
cd "$(dirname "$0")/.."
minimum=90
if ! command -v gcovr >/dev/null; then
    echo "coverage: gcovr not found; run: sh app/install.sh --tests" >&2
    exit 1
fi
sh app/build.sh coverage forefront forefront_unit_tests forefront_fuzz_regression
find build/coverage -name '*.gcda' -delete
ctest --test-dir build/coverage --output-on-failure --progress -j "$(nproc)" -R '^(unit/|batch$|trace$|fuzz_regression$)'
mkdir -p build/coverage/report
gcovr --root . --object-directory build/coverage --filter core/ -j "$(nproc)" --exclude-throw-branches \
    --html-details build/coverage/report/coverage.html --txt build/coverage/report/coverage.txt \
    --print-summary --fail-under-line $minimum
echo "coverage: see build/coverage/report/coverage.html"
