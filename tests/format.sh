#!/bin/sh
# Checks the format of all C++ sources with clang-format, without changing them.
#
#   sh tests/format.sh [--fix]
#
#   --fix   reformat the sources instead
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=app/usage.sh
. app/usage.sh
case ${1-} in
'') how='--dry-run -Werror' ;;
--fix) how=-i ;;
*)
    offer_help "$1"
    wrong_usage "unknown option $1"
    ;;
esac
# shellcheck disable=SC2086  # words to be split
git ls-files -z '*.cpp' '*.hpp' | xargs -0 -n 20 -P "$(nproc)" clang-format $how
echo "format: $(git ls-files '*.cpp' '*.hpp' | wc -l) files are formatted"
