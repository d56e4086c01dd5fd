#!/bin/sh
# Checks the format of all C++ sources with clang-format, without changing them.
#
#   sh tests/format.sh [--fix]
#
#   --fix   reformat the sources instead
set -eu
cd "$(dirname "$0")/.."
case ${1-} in
'') how='--dry-run -Werror' ;;
--fix) how=-i ;;
*)
    sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac
# shellcheck disable=SC2086  # words to be split
git ls-files -z '*.cpp' '*.hpp' | xargs -0 -n 20 -P "$(nproc)" clang-format $how
echo "format: $(git ls-files '*.cpp' '*.hpp' | wc -l) files are formatted"
