#!/bin/sh
# Compares Forefront with Gmsh, Netgen and CGAL on the cases of peer_cases.py: speed and quality, as a Markdown table.
# Installs the other meshers from Debian; one that cannot be installed is reported and left out.
#
#   sh tests/bench/peers.sh [PROGRAM]      PROGRAM: build/release/app/forefront
#
# Takes about five minutes. For what is timed, and how the meshes are measured, see peer_table.py.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release/app/forefront}
[ -x "$program" ] || {
    echo "peers.sh: program not found: $program; build it with: sh app/build.sh release" >&2
    exit 1
}
python=/usr/bin/python3 # Debian's own, which finds Debian's modules
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

as_root=
[ "$(id -u)" -eq 0 ] || as_root=sudo
installed() { dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null | grep -q '^installed'; }
version() { dpkg-query -W -f='${Version}' "$1" 2>/dev/null | sed 's/.*really//; s/[-+].*//' || true; }
# have PEER PACKAGE COMMAND...: installs the package if it is missing, and includes the peer if the command then works.
listed=no
peers=
versions=
have() {
    peer=$1
    package=$2
    shift 2
    if ! installed "$package"; then
        [ $listed = yes ] || $as_root apt-get update >>"$work/log" 2>&1 || true
        listed=yes
        $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$package" \
            >>"$work/log" 2>&1 || true
    fi
    if ! installed "$package"; then
        echo "peers.sh: $peer is left out: cannot install the Debian package $package" >&2
    elif ! "$@" >"$work/log" 2>&1; then
        echo "peers.sh: $peer is left out: $(tail -n 1 "$work/log")" >&2
    else
        peers="$peers $peer"
        versions="$versions, $peer $(version "$package")"
    fi
}
have Gmsh python3-gmsh "$python" -c "import gmsh"
have Netgen python3-netgen "$python" -c "import netgen.geom2d"
have CGAL libcgal-dev g++ -O3 -DNDEBUG -std=c++20 "$here/peer_cgal.cpp" -o "$work/peer_cgal" -lgmp -lmpfr

echo "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores," \
    "$(sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release), one thread each$versions."
echo
# shellcheck disable=SC2086 # split into words on purpose
"$python" "$here/peer_table.py" "$program" "$work" $peers
