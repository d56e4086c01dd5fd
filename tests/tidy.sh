#!/bin/sh
# Runs clang-tidy on the sources that differ from a commit, at most 24 of them so that it stays within minutes.
#
#   sh tests/tidy.sh [COMMIT | --all]
#
#   COMMIT   compare with this commit; default: where the branch left origin/main, or else the previous commit
#   --all    check every source file, which takes about an hour
set -eu
cd "$(dirname "$0")/.."
limit=24
base=${1-}
if [ "$base" = --all ]; then
    files=$(git ls-files 'core/*.cpp' 'ui/*.cpp' 'app/*.cpp')
    limit=100000
else
    if [ -z "$base" ]; then
        base=$(git merge-base HEAD origin/main 2>/dev/null || true)
        if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then
            base=$(git rev-parse -q --verify HEAD~1 || true)
        fi
    fi
    if [ -z "$base" ]; then
        echo "tidy: there is no earlier commit to compare with; nothing to check"
        exit 0
    fi
    files=$(git diff --name-only --diff-filter=d "$base" -- 'core/*.cpp' 'ui/*.cpp' 'app/*.cpp')
fi
count=$(printf '%s' "$files" | grep -c . || true)
if [ "$count" -eq 0 ]; then
    echo "tidy: no changed sources"
    exit 0
fi
if [ "$count" -gt "$limit" ]; then
    echo "tidy: $count sources have changed; checking the first $limit (sh tests/tidy.sh --all checks every one)"
fi
# clang reads neither joined sources nor g++'s precompiled headers; without them, missing #includes are found, too.
mkdir -p build/tidy
if ! cmake --preset release -B build/tidy -DFOREFRONT_PCH=OFF -DCMAKE_UNITY_BUILD=OFF >build/tidy/configure.log 2>&1; then
    cat build/tidy/configure.log >&2
    exit 1
fi
cmake --build build/tidy --target forefront_glad # its header is generated
# g++'s own warning options are unknown to clang.
printf '%s\n' "$files" | head -n "$limit" |
    xargs -n 1 -P "$(nproc)" clang-tidy -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option \
        --extra-arg=-Wno-ignored-optimization-argument
echo "tidy: checked"
