#!/bin/sh
# Installs what is missing, builds, and runs every test: format, unit and property tests, the programs that read exported
# files, the batch program, the installed library, the editor with and without a window, then the sanitizers and
# clang-tidy. Prints how long each step takes. Safe to repeat.
#
#   sh tests/run.sh [--quick | --thorough]
#
# Unit tests run with the address sanitizer only, in a build that also checks invariants, unless an option says otherwise.
#
#   --quick      skip the sanitizers and clang-tidy; unit tests run in the optimised build
#   --thorough   run unit tests in both builds, and the editor's tests with the sanitizers too; compile every source
#                alone; read exported files with OpenFOAM, FEniCSx, deal.II and QGIS where they are installed, and
#                renew their records in tests/readers; install the Debian packages into a bare root; build for Windows
#                and mesh the samples under wine. Takes much longer
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
# shellcheck source=app/usage.sh
. "$root/app/usage.sh"
quick=no
thorough=no
case ${1-} in
'') ;;
--quick) quick=yes ;;
--thorough)
    thorough=yes
    ;;
*)
    offer_help "$1"
    wrong_usage "unknown option $1"
    ;;
esac

jobs=$(nproc)
times=
failed=
failed_tests=
began=$(date +%s)
# step NAME COMMAND...: runs the command, records its time and whether it failed, and continues either way.
step() {
    name=$1
    shift
    echo
    echo "== $name"
    start=$(date +%s)
    result=ok
    "$@" || result=FAILED
    seconds=$(($(date +%s) - start))
    times="$times$(printf '%6d s  %-7s %s' "$seconds" "$result" "$name")
"
    [ $result = ok ] || failed="$failed
  $name"
}
finish() {
    echo
    echo "== times"
    printf '%s' "$times"
    printf '%6d s  total\n' $(($(date +%s) - began))
    if [ -n "$failed" ]; then
        echo "FAILED:$failed"
        [ -z "$failed_tests" ] || printf 'tests that failed:\n%s' "$failed_tests"
        exit 1
    fi
    echo "all tests passed"
    exit 0
}
need() { # a step that the others depend on
    step "$@"
    [ -z "$failed" ] || finish
}
# shellcheck disable=SC2317  # called by step
run_tests() { # run_tests PRESET [CTEST OPTION...]
    preset=$1
    shift
    logs=build/$preset/Testing/Temporary
    rm -f "$logs/LastTestsFailed.log"
    ctest --test-dir "build/$preset" --output-on-failure --progress -j "$jobs" "$@" && return
    # Named again at the end, with the cases that failed, where a log that was cut still shows them.
    [ ! -f "$logs/LastTestsFailed.log" ] || failed_tests="$failed_tests$(
        sed "s|^[0-9]*:|  $preset: |" "$logs/LastTestsFailed.log"
        awk '/^TEST CASE:/ { name = $0 } /^=====/ { name = "" } /ERROR:/ && name { print name; name = "" }' \
            "$logs/LastTest.log" | sed 's/^TEST CASE: */    /' | sort -u
    )
"
    return 1
}

# Programs too large to be installed for every run; see the results of the last runs in tests/readers.
# shellcheck disable=SC2317  # called by step
large_readers() { # large_readers NAME: runs its check, and keeps the record of a run that passed
    code=0
    sample=build/release/tests/forefront_export_sample
    record=build/release/tests/$1.txt
    case $1 in
    heavy_readers) sh tests/readers/heavy_readers.sh "$sample" "$record" || code=$? ;;
    *) /usr/bin/python3 "tests/readers/check_$1.py" "$sample" "$record" || code=$? ;;
    esac
    [ "$code" != 0 ] || cp "$record" "tests/readers/$1.txt"
    [ "$code" != 77 ] || echo "$1: not checked"
    [ "$code" = 0 ] || [ "$code" = 77 ]
}

need 'install packages' sh app/install.sh --tests
step 'format' sh tests/format.sh
unit=ON
[ $quick = yes ] || [ $thorough = yes ] || unit=OFF
need 'build release' sh app/build.sh release -DFOREFRONT_TESTS=ON -DFOREFRONT_UNIT_TESTS=$unit
step 'tests, release' run_tests release
if [ $thorough = yes ]; then
    for reader in openfoam xdmf qgis heavy_readers; do
        step "exported files read: $reader" large_readers $reader
    done
fi
if [ $quick = no ]; then
    programs=forefront_unit_tests
    cases=unit
    editor=OFF
    if [ $thorough = yes ]; then
        programs="$programs forefront_ui_tests"
        cases='(unit|ui)'
        editor=ON
    fi
    # shellcheck disable=SC2086  # a list of programs
    step 'build with address and undefined-behaviour sanitizers' sh app/build.sh asan-ubsan \
        forefront forefront_fuzz_regression $programs -DFOREFRONT_EDITOR=$editor
    step 'tests with address and undefined-behaviour sanitizers' \
        run_tests asan-ubsan -R "^($cases/|batch/|trace\$|fuzz_regression\$)" -LE slow
    # shellcheck disable=SC2086
    step 'build with thread sanitizer' sh app/build.sh tsan $programs -DFOREFRONT_EDITOR=$editor
    step 'tests with thread sanitizer' run_tests tsan -R "^$cases/" -L threads
    step 'clang-tidy on changed files' sh tests/tidy.sh
    if [ $thorough = yes ]; then
        step 'all sources compiled alone' sh tests/alone.sh --all
        step 'build Debian packages' sh app/package.sh
        step 'packages in a bare Debian 12' sh tests/package/bare_root.sh
        step 'program for Windows under wine' sh app/windows/build.sh
    else
        step 'changed sources compiled alone' sh tests/alone.sh --after-tidy
    fi
fi
finish
