#!/bin/sh
# Checks that ui/ and app/window/ compile with the Dear ImGui of another folder, such as a newer version. Nothing is built.
#
#   sh ui/check_imgui.sh FOLDER [FILE...]
#
#   FOLDER   sources of Dear ImGui, as they are published: imgui.h, backends/, misc/
#   FILE     only these of our sources; default: all
#
# Needs a configured build/release, for the generated headers.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
if [ $# -eq 0 ] || [ ! -f "$1/imgui.h" ]; then
    sed -n '2,9s/^# \{0,1\}//p' "$0"
    exit 2
fi
imgui=$(cd "$1" && pwd)
shift
cd "$root"
# shellcheck disable=SC2046  # our names have no blanks
[ $# -gt 0 ] || set -- $(find ui app/window -name '*.cpp' | sort)
grep 'define IMGUI_VERSION ' "$imgui/imgui.h"
cmake --build build/release --target forefront_glad forefront_headers_core forefront_headers_drawing >/dev/null
flags=$(pkg-config --cflags freetype2 stb xcb)
failed=0
for file in "$@"; do
    # shellcheck disable=SC2086  # words to be split
    "${CXX:-c++}" -std=c++20 -fsyntax-only -w -I. -I"$imgui" -I"$imgui/backends" -I"$imgui/misc/freetype" -I"$imgui/misc/cpp" \
        -Ibuild/release/core/include/core -Ibuild/release/ui/glad/include $flags -DGLFW_INCLUDE_NONE \
        -DFOREFRONT_FONT_ROOT='"/usr/share/fonts"' -DFOREFRONT_ASSETS_INSTALLED='"/usr/share/forefront"' "$file" ||
        failed=$((failed + 1))
done
echo "$# files, $failed do not compile"
[ "$failed" -eq 0 ]
