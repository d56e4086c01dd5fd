#!/bin/sh
# Installs what is missing, builds, and runs every test: unit and property tests, the readers of exported files, the
# batch program, the editor headless and with real input, then the sanitizers on a reduced set. Says what takes how
# long. Safe to repeat.
#
#   sh tests/run.sh [--quick]
#
#   --quick   without the sanitizers
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
quick=no
case ${1-} in
'') ;;
--quick) quick=yes ;;
-h | --help)
    sed -n '2,8s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
*)
    echo "run.sh: unknown option $1 (see --help)" >&2
    exit 2
    ;;
esac

jobs=$(nproc)
times=
failed=
began=$(date +%s)
# step NAME COMMAND...: runs it, notes its time and whether it failed, and goes on.
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
    printf '%6d s  in all\n' $(($(date +%s) - began))
    if [ -n "$failed" ]; then
        echo "FAILED:$failed"
        exit 1
    fi
    echo "all tests passed"
    exit 0
}
need() { # a step without which the rest makes no sense
    step "$@"
    [ -z "$failed" ] || finish
}

need 'install packages' sh app/install.sh --tests
need 'build release' sh app/build.sh release -DFOREFRONT_TESTS=ON
step 'tests, release' ctest --test-dir build/release --output-on-failure -j "$jobs"
if [ $quick = no ]; then
    step 'build asan-ubsan' sh app/build.sh asan-ubsan -DFOREFRONT_EDITOR=OFF
    step 'tests, address and undefined-behaviour sanitizers' \
        ctest --test-dir build/asan-ubsan --output-on-failure -j "$jobs" -R '^(unit|batch|fuzz_regression)$'
    step 'build tsan' sh app/build.sh tsan forefront_unit_tests -DFOREFRONT_EDITOR=OFF
    step 'tests, thread sanitizer' \
        build/tsan/tests/forefront_unit_tests '--test-case=*MeshingSession*,*Journal*,*thread*'
fi
finish
