#!/bin/sh
# Installs what is missing, builds Forefront and opens the editor. Without a display it meshes the sample in batch mode
# instead and writes the mesh and a picture of it to build/. Safe to repeat; starts within seconds if nothing has changed.
#
#   sh app/run.sh [FILE]
#
#   FILE   project or domain to open; default: a sample
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=app/usage.sh
. "$root/app/usage.sh"
offer_help "$@"
[ $# -le 1 ] || wrong_usage "expected at most one file, got $#"
[ $# -eq 0 ] || [ -f "$1" ] || wrong_usage "file not found: $1"

sh "$root/app/install.sh"
sh "$root/app/build.sh" release -DFOREFRONT_TESTS=OFF
program=$root/build/release/app/forefront

mesh_in_batch() {
    input=${1:-$root/assets/samples/harbour.json}
    name=$(basename "$input")
    name=$root/build/${name%.*}
    echo "Meshing $input in batch mode instead:"
    "$program" mesh "$input" -o "$name.msh" -o "$name.svg"
    if command -v rsvg-convert >/dev/null; then
        rsvg-convert -w 1600 -b white "$name.svg" -o "$name.png"
    fi
    echo "mesh:    $name.msh"
    echo "picture: $name.svg"
    [ ! -f "$name.png" ] || echo "picture: $name.png"
}

if [ -z "${DISPLAY-}" ] && [ -z "${WAYLAND_DISPLAY-}" ]; then
    echo "No display (DISPLAY and WAYLAND_DISPLAY are not set), so the editor cannot open."
    mesh_in_batch "$@"
    exit 0
fi
status=0
"$program" "${1:-$root/assets/samples/harbour.json}" || status=$?
if [ $status -eq 4 ]; then # the window could not be opened
    echo "The editor cannot open a window on display '${DISPLAY-}${WAYLAND_DISPLAY-}'."
    mesh_in_batch "$@"
    exit 0
fi
exit $status
