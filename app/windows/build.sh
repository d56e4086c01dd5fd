#!/bin/sh
# Builds the library and the batch program for 64-bit Windows into build/mingw with Debian's g++-mingw-w64. The libraries
# that Debian has no Windows packages of, pugixml and libpng, are built from Debian's sources into build/mingw-libraries.
# Then the program meshes and verifies every sample under wine; the meshes must be those of Linux (tests/pinned/meshes.txt),
# except where the mathematical functions of the C library have other last digits.
#
#   sh app/windows/build.sh [--without-wine]
#
#   --without-wine   only build
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
# shellcheck source=app/usage.sh
. "$root/app/usage.sh"
wine=yes
for option in "$@"; do
    case $option in
    --without-wine) wine= ;;
    *)
        offer_help "$option"
        wrong_usage "unknown option $option"
        ;;
    esac
done
sh "$root/app/install.sh" --headless --windows ${wine:+--wine}

libraries=$root/build/mingw-libraries
mkdir -p "$libraries/source/lists/partial"
log=$libraries/log
quietly() {
    "$@" >"$log" 2>&1 || {
        cat "$log" >&2
        exit 1
    }
}

# Headers only: those of this system.
if [ ! -f "$libraries/include/headers" ]; then
    mkdir -p "$libraries/include" "$libraries/share/cmake"
    cp -rL /usr/include/CLI /usr/include/toml++ /usr/include/eigen3 "$libraries/include"
    cp -rL /usr/share/cmake/CLI11 /usr/share/eigen3/cmake "$libraries/share/cmake"
    rm -rf "$libraries/share/eigen3"
    mkdir -p "$libraries/share/eigen3"
    mv "$libraries/share/cmake/cmake" "$libraries/share/eigen3/cmake"
    touch "$libraries/include/headers"
fi

# library SOURCE OPTION...: fetches a Debian source package, builds it and installs it into $libraries.
library() {
    name=$1
    [ ! -f "$libraries/source/$name.built" ] || return 0
    echo "building $name ..."
    rm -rf "$libraries/source/$name"
    mkdir "$libraries/source/$name"
    cd "$libraries/source/$name"
    quietly apt_source source --download-only "$name"
    quietly tar -xf ./*.orig.tar.* --strip-components=1
    shift
    quietly cmake -G Ninja -B build -DCMAKE_TOOLCHAIN_FILE="$root/app/windows/mingw.cmake" -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_INSTALL_PREFIX="$libraries" -DCMAKE_STAGING_PREFIX="$libraries" -DBUILD_SHARED_LIBS=OFF "$@"
    quietly cmake --build build
    quietly cmake --install build
    touch "$libraries/source/$name.built"
}
# The lists of Debian's sources, kept apart from those of this system.
# shellcheck source=/dev/null
. /etc/os-release
cat >"$libraries/source/debian.sources" <<END
Types: deb-src
URIs: ${FOREFRONT_DEBIAN_MIRROR:-http://deb.debian.org/debian}
Suites: $VERSION_CODENAME
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
END
apt_source() {
    apt-get -o Dir::Etc::sourcelist="$libraries/source/debian.sources" -o Dir::Etc::sourceparts=- \
        -o Dir::State::lists="$libraries/source/lists" -o Dir::Cache::srcpkgcache= -o Dir::Cache::pkgcache= \
        -o APT::Sandbox::User=root "$@"
}
if [ ! -f "$libraries/source/libpng1.6.built" ] || [ ! -f "$libraries/source/pugixml.built" ]; then
    quietly apt_source update
fi
library pugixml
library libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF

cd "$root"
sh app/build.sh mingw forefront
program=build/mingw/app/forefront.exe
echo "$program, $(($(stat -c %s "$program") / 1024)) KB"
[ -n "$wine" ] || exit 0

# Debian's package wine64 has it in no folder of programs.
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
WINEPREFIX=$root/build/mingw-wine
WINEDEBUG=-all
export WINEPREFIX WINEDEBUG
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
other_digits='airfoil cylinder dam flap gear joint machine wing'
checked=0
same=0
for sample in assets/samples/*.json; do
    name=$(basename "$sample" .json)
    expected=$(sed -n "s/^$name fast default \([0-9a-f]*\) .*/\1/p" tests/pinned/meshes.txt | head -n 1)
    "$wine" "$program" mesh "$sample" --method fast --improve default --verify --quiet -o "$out/mesh.msh" \
        --stats "$out/stats.json" 2>"$out/errors" || {
        cat "$out/errors" >&2
        echo "build.sh: $sample is not meshed under wine" >&2
        exit 1
    }
    if grep -q "\"$expected\"" "$out/stats.json"; then
        same=$((same + 1))
    elif ! printf ' %s ' "$other_digits" | grep -Fq " $name "; then
        echo "build.sh: the mesh of $sample differs from the one on Linux, $expected" >&2
        exit 1
    fi
    checked=$((checked + 1))
done
echo "$checked samples are meshed under $("$wine" --version), $same as on Linux"
