#!/bin/sh
# Runs clang-tidy on the sources that differ from a commit, at most 24 of them so that it stays within minutes.
#
#   sh tests/tidy.sh [COMMIT | --all]
#
#   COMMIT   compare with this commit; default: where the branch left origin/main, or else the previous commit
#   --all    check every source file, which takes about an hour
set -eu
cd "$(dirname "$0")/.."
rm -f build/tidy/checked.txt
limit=24
[ "${1-}" != --all ] || limit=100000
files=$(sh tests/changed.sh "$@" 'core/*.cpp' 'ui/*.cpp' 'app/*.cpp')
count=$(printf '%s' "$files" | grep -c . || true)
if [ "$count" -eq 0 ]; then
    echo "tidy: no changed sources"
    exit 0
fi
if [ "$count" -gt "$limit" ]; then
    echo "tidy: $count sources have changed; checking the first $limit (sh tests/tidy.sh --all checks every one)"
fi
# clang reads neither joined sources nor g++'s precompiled headers.
sh tests/configure_alone.sh
# g++'s own warning options are unknown to clang.
printf '%s\n' "$files" | head -n "$limit" |
    xargs -n 1 -P "$(nproc)" clang-tidy -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option \
        --extra-arg=-Wno-ignored-optimization-argument
printf '%s\n' "$files" | head -n "$limit" >build/tidy/checked.txt
echo "tidy: checked"
