#!/bin/sh
# Checks that sources compile alone: without precompiled headers and not joined with others, so that each one includes
# what it uses. Nothing is linked. At most 120 of them, spread over the list, so that it stays within minutes.
#
#   sh tests/alone.sh [--after-tidy] [COMMIT | --all]
#
#   --after-tidy   leave out the sources that tests/tidy.sh has just read, which needs the same includes
#   COMMIT         check the sources that differ from this commit; default: where the branch left origin/main, or else
#                  the previous commit
#   --all          check every source, which takes about a quarter of an hour
set -eu
cd "$(dirname "$0")/.."
limit=120
known=/dev/null
if [ "${1-}" = --after-tidy ]; then
    shift
    [ ! -f build/tidy/checked.txt ] || known=build/tidy/checked.txt
fi
[ "${1-}" != --all ] || limit=100000
files=$(sh tests/changed.sh "$@" 'core/*.cpp' 'ui/*.cpp' 'app/*.cpp' 'tests/*.cpp')
files=$(printf '%s\n' "$files" | grep -Fvx -f $known || true)
if [ -z "$files" ]; then
    echo "alone: no changed sources"
    exit 0
fi
count=$(printf '%s\n' "$files" | wc -l)
if [ "$count" -gt "$limit" ]; then
    echo "alone: $count sources have changed; checking $limit (sh tests/alone.sh --all checks every one)"
fi
sh tests/configure_alone.sh -DFOREFRONT_TESTS=ON
printf '%s\n' "$files" |
    awk -v count="$count" -v limit="$limit" 'count <= limit || int(NR * limit / count) > int((NR - 1) * limit / count)' |
    python3 tests/structure/compile_alone.py build/tidy/compile_commands.json
