#!/bin/sh
# Installs the Debian 12 packages that Forefront needs and that are not installed yet. If none is missing, it takes less
# than a second and needs no root.
#
#   sh app/install.sh [--headless] [--tests] [--packages] [--windows] [--wine]
#
#   --headless   only what the library and the batch program need, no graphics
#   --tests      also what the tests need, including the programs that read exported files (tests/packages.txt)
#   --packages   also what app/package.sh needs
#   --windows    also what app/windows/build.sh needs
#   --wine       also what runs its programs
# shellcheck disable=SC2086  # lists of packages are split into words on purpose
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=app/usage.sh
. "$root/app/usage.sh"

core='g++ cmake ninja-build pkg-config libcli11-dev libtomlplusplus-dev libpugixml-dev libpng-dev libeigen3-dev'
editor='libimgui-dev python3-glad libglfw3-dev libglm-dev libstb-dev libfreetype-dev libxcb1-dev libegl-dev libgl-dev
    libopengl-dev libgl1-mesa-dri libegl-mesa0 libglx-mesa0 libstb0 fonts-inter fonts-dejavu-core'
tests='doctest-dev nlohmann-json3-dev libboost-dev libmuparser-dev python3 xvfb xauth xdotool xclip x11-utils imagemagick
    librsvg2-bin libhdf5-dev libgdal-dev ccache clang clang-format clang-tidy desktop-file-utils doxygen gcovr git pybind11-dev
    python3-pybind11 python3-dev python3-numpy python3-pytest python3-setuptools python3-wheel python3-build python3-pip'
packages='libhdf5-dev libgdal-dev dpkg-dev lintian mmdebstrap fakeroot file appstream desktop-file-utils librsvg2-bin pybind11-dev python3-dev python3-numpy'
windows='g++-mingw-w64-x86-64-posix libz-mingw-w64-dev dpkg-dev'

wanted="$core $editor"
for option in "$@"; do
    case $option in
    --headless) wanted=$core ;;
    --tests | --packages | --windows | --wine) ;;
    *)
        offer_help "$option"
        wrong_usage "unknown option $option"
        ;;
    esac
done
for option in "$@"; do
    if [ "$option" = --packages ]; then
        wanted="$wanted $packages"
    fi
    if [ "$option" = --windows ]; then
        wanted="$wanted $windows"
    fi
    if [ "$option" = --wine ]; then
        wanted="$wanted wine64"
    fi
    if [ "$option" = --tests ]; then
        wanted="$wanted $tests"
        if [ -f "$root/tests/packages.txt" ]; then
            wanted="$wanted $(sed 's/#.*//' "$root/tests/packages.txt")"
        fi
    fi
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "install.sh: not a Debian system; install the equivalents of these Debian packages:" $wanted >&2
    exit 1
fi
present=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p' || true)
missing=$(printf '%s\n' $wanted | sort -u | while read -r package; do
    printf '%s\n' "$present" | grep -Fqx "$package" || printf '%s ' "$package"
done)
if [ -z "$missing" ]; then
    echo "packages: all $(printf '%s\n' $wanted | sort -u | wc -l) are installed"
    exit 0
fi

echo "packages missing: $missing"
as_root=
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "install.sh: sudo not found; run as root: apt-get install --no-install-recommends $missing" >&2
        exit 1
    fi
    as_root=sudo
fi
apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3 "$@"
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
run() {
    echo "+ apt-get $1 ..."
    if ! apt "$@" >"$log" 2>&1; then
        cat "$log" >&2
        return 1
    fi
}
size_before=$(df -Pk /usr | awk 'NR == 2 { print $3 }')
install_missing() { run install -y --no-install-recommends $missing; }
# The package lists are fetched only if they are missing or outdated.
if ! apt-get -s install --no-install-recommends $missing >/dev/null 2>&1; then
    run update
    install_missing
elif ! install_missing 2>/dev/null; then
    run update
    install_missing
fi
size_after=$(df -Pk /usr | awk 'NR == 2 { print $3 }')
echo "packages: installed, $(((size_after - size_before) / 1024)) MB"
