#!/bin/sh
# Installs what is missing, builds Forefront and opens the editor. Without a display it meshes the sample in batch mode
# instead and writes the mesh and a picture of it to build/. Safe to repeat; starts within seconds if nothing has changed.
#
#   sh app/run.sh [FILE]
#
#   FILE   project or domain to open; default: a sample
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
case ${1-} in
-h | --help)
    sed -n '2,7s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
esac
if [ $# -gt 1 ]; then
    echo "run.sh: expected at most one file, got $# (see --help)" >&2
    exit 2
fi
if [ $# -eq 1 ] && [ ! -f "$1" ]; then
    echo "run.sh: file not found: $1" >&2
    exit 2
fi

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
