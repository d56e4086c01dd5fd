#!/bin/sh
# Prints the C++ sources that differ from a commit, for checks of single sources.
#
#   sh tests/changed.sh [COMMIT | --all] PATTERN...
#
#   COMMIT    compare with this commit; default: where the branch left origin/main, or else the previous commit
#   --all     print every source
#   PATTERN   of paths, for git
set -eu
cd "$(dirname "$0")/.."
base=
case ${1-} in
*\** | '') ;;
*)
    base=$1
    shift
    ;;
esac
if [ "$base" = --all ]; then
    exec git ls-files "$@"
fi
if [ -z "$base" ]; then
    base=$(git merge-base HEAD origin/main 2>/dev/null || true)
    if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then
        base=$(git rev-parse -q --verify HEAD~1 || true)
    fi
fi
[ -z "$base" ] || git diff --name-only --diff-filter=d "$base" -- "$@"
