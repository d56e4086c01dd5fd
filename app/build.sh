#!/bin/sh
# Builds a preset of CMakePresets.json into build/PRESET, with ccache if it is installed. Prints its progress and how long
# it took.
#
#   sh app/build.sh PRESET [TARGET...] [-DNAME=VALUE...]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=app/usage.sh
. "$root/app/usage.sh"
offer_help "$@"
case ${1--} in
-*) wrong_usage "expected a preset, got '${1-}'" ;;
esac
if [ -z "${CMAKE_CXX_COMPILER_LAUNCHER-}" ] && command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi
preset=$1
shift
targets=
settings=
for word in "$@"; do
    case $word in
    -D*) settings="$settings $word" ;;
    *) targets="$targets --target $word" ;;
    esac
done
cd "$root"
started=$(date +%s)
log=build/$preset/configure.log
mkdir -p "build/$preset"
# shellcheck disable=SC2086  # words to be split
if ! cmake --preset "$preset" $settings >"$log" 2>&1; then
    cat "$log" >&2
    exit 1
fi
echo "building build/$preset ..."
# shellcheck disable=SC2086
cmake --build --preset "$preset" $targets
echo "built build/$preset in $(($(date +%s) - started)) s"
