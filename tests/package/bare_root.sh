#!/bin/sh
# Installs the Debian packages of build/package into a bare Debian 12 root, as a user of that system would, and uses each:
# a mesh by the program, files by the components for HDF5 and GDAL, the editor's window with its icons under Xvfb, a
# consumer of the library built with CMake and with pkg-config, a mesh from Python. All meshes of one domain must be the
# same. Finally, removing the packages must leave no file behind. Needs root and a network; takes some minutes.
#
#   sh tests/package/bare_root.sh [FOLDER]
#
#   FOLDER   where the packages are, and where bare_root.png, a picture of the window, is written; default: build/package
# shellcheck disable=SC2016  # words in single quotes are for the shell in the root
set -eu
here=$(cd "$(dirname "$0")" && pwd)
packages=$(cd "${1:-$here/../../build/package}" && pwd)
fail() {
    echo "bare_root.sh: $*" >&2
    exit 1
}
[ "$(id -u)" -eq 0 ] || fail "must run as root: it installs packages into a root of its own"
for name in forefront forefront-hdf5 forefront-gdal libforefront0.3 libforefront-dev python3-forefront; do
    set -- "$packages/${name}"_*.deb
    [ -f "$1" ] || fail "$name is missing in $packages; build it with: sh app/package.sh"
done

top=$(mktemp -d)
root=$top/root
display=
clean_up() {
    [ -z "$display" ] || kill "$display" 2>/dev/null || true
    rm -rf --one-file-system "$top"
}
trap clean_up EXIT
trap 'exit 3' INT TERM
log=$top/log
quietly() {
    "$@" >"$log" 2>&1 || {
        cat "$log" >&2
        fail "$* failed"
    }
}
in_root() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
installed() { in_root dpkg-query -f '${Package}\n' -W | wc -l; }

echo "+ bare Debian 12"
quietly mmdebstrap --variant=minbase --mode=root --include=ca-certificates bookworm "$root"
[ -e "$root/etc/resolv.conf" ] || cp /etc/resolv.conf "$root/etc/"
before=$(installed)
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
quietly in_root apt-get update

echo "+ apt install ./forefront*.deb"
quietly in_root sh -c 'apt-get install -y --no-install-recommends /packages/forefront_*.deb'
echo "  $(($(installed) - before)) packages, forefront among them"
in_root forefront mesh /usr/share/forefront/assets/samples/plate.json -o /tmp/plate.msh --stats /tmp/plate.stats >/dev/null
in_root forefront check /tmp/plate.msh >/dev/null || fail "forefront check refuses the mesh"

echo "+ components"
hash_of() { in_root forefront check "$1" --stats - | sed -n 's/.*"hash": "\([^"]*\)".*/\1/p'; }
cat >"$root/tmp/lake.kml" <<'END'
<kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><name>lake</name><Polygon><outerBoundaryIs><LinearRing>
<coordinates>10,60 10.1,60 10.1,60.05 10,60.05 10,60</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>
</Document></kml>
END
for file in plate.xdmf lake.vtu; do
    case $file in
    plate.xdmf) set -- convert /tmp/plate.msh ;;
    lake.vtu) set -- mesh /tmp/lake.kml --projection local ;;
    esac
    ! in_root forefront "$@" -o "/tmp/$file" >"$log" 2>&1 || fail "$file is written without its component"
    grep -q missing-component "$log" || fail "without its component: $(cat "$log")"
done
quietly in_root sh -c 'apt-get install -y --no-install-recommends /packages/forefront-hdf5_*.deb /packages/forefront-gdal_*.deb'
quietly in_root forefront convert /tmp/plate.msh -o /tmp/plate.xdmf
quietly in_root forefront mesh /tmp/lake.kml --projection local -o /tmp/lake.vtu
[ "$(hash_of /tmp/plate.xdmf)" = "$(hash_of /tmp/plate.msh)" ] || fail "XDMF does not give the same mesh back"
echo "  XDMF and KML; without the components, the messages name them"

echo "+ window"
Xvfb -displayfd 3 -screen 0 1600x1000x24 -ac 3>"$top/display" 2>/dev/null &
display=$!
for _ in 1 2 3 4 5 6 7 8 9 10; do
    [ -s "$top/display" ] && break
    sleep 0.5
done
number=:$(cat "$top/display")
(exec chroot "$root" env -i PATH=/usr/bin HOME=/root DISPLAY="$number" LIBGL_ALWAYS_SOFTWARE=1 forefront \
    /usr/share/forefront/assets/samples/harbour.json --state-file /tmp/state.json 2>"$top/window") &
window=$!
for _ in $(seq 60); do
    [ -s "$root/tmp/state.json" ] && break
    sleep 0.5
done
sleep 3
DISPLAY=$number import -window root "$packages/bare_root.png" || fail "the screen cannot be copied"
kill "$window" 2>/dev/null || true
wait "$window" || true
! grep -i 'not found\|cannot' "$top/window" || fail "the window complains"
[ -s "$root/tmp/state.json" ] || fail "no window: $(cat "$top/window")"
colours=$(identify -format %k "$packages/bare_root.png")
[ "$colours" -gt 500 ] || fail "the window is nearly empty: $colours colours"
echo "  $packages/bare_root.png, $colours colours"

echo "+ Python"
quietly in_root sh -c 'apt-get install -y --no-install-recommends /packages/python3-forefront_*.deb'
python=$(in_root python3 -c '
import forefront
mesh = forefront.mesh([(0, 0), (4, 0), (4, 3), (0, 3)], "0.05 + 0.1*x")
assert not mesh.nodes.flags.owndata
print(f"{mesh.hash:016x}")')

echo "+ consumer"
quietly in_root sh -c 'apt-get install -y --no-install-recommends /packages/libforefront*.deb cmake make g++ pkg-config'
mkdir "$root/consumer"
sed -n '/^```cpp$/,/^```$/{/^```/d;p}' "$here/../../README.md" >"$root/consumer/consumer.cpp"
cat >"$root/consumer/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(Forefront 0.3 REQUIRED)
add_executable(consumer consumer.cpp)
target_link_libraries(consumer Forefront::core)
END
quietly in_root sh -c 'cd /consumer && cmake -B build && cmake --build build && build/consumer && mv rectangle.msh cmake.msh'
quietly in_root sh -c 'cd /consumer && c++ -std=c++20 consumer.cpp -o by_pc $(pkg-config --cflags --libs forefront) && ./by_pc'
cmp "$root/consumer/cmake.msh" "$root/consumer/rectangle.msh" || fail "CMake and pkg-config give different meshes"
cpp=$(hash_of /consumer/rectangle.msh)
if [ -z "$cpp" ] || [ "$cpp" != "$python" ]; then
    fail "the hash is $cpp from C++ and $python from Python"
fi
echo "  hash $cpp from C++, Python and the program"

echo "+ apt purge"
ours='forefront forefront-hdf5 forefront-gdal libforefront0.3 libforefront-dev python3-forefront'
quietly in_root sh -c "dpkg -L $ours | grep -i forefront >/tmp/files; apt-get purge -y $ours"
left=$(in_root sh -c 'while read -r file; do [ ! -e "$file" ] || echo "$file"; done </tmp/files')
[ -z "$left" ] || fail "left behind: $left"
echo "the packages work in a bare Debian 12"
