#!/bin/sh
# Builds a preset into build/PRESET and says how far it is.
#
#   sh app/build.sh PRESET [TARGET...] [-DNAME=VALUE...]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
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
