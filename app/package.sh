#!/bin/sh
# Builds the Debian packages forefront, libforefront, libforefront-dev and python3-forefront into build/package and checks
# them: lintian without errors or warnings, and the desktop's validators.
#
#   sh app/package.sh [FOLDER]
#
#   FOLDER   where the packages are copied; default: they stay in build/package
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=app/usage.sh
. "$root/app/usage.sh"
offer_help "$@"
case ${1-} in
-*) wrong_usage "unknown option $1" ;;
esac
[ $# -le 1 ] || wrong_usage "expected at most one folder, got $#"

folder=
if [ $# -eq 1 ]; then
    mkdir -p "$1"
    folder=$(cd "$1" && pwd)
fi
sh "$root/app/install.sh" --packages
packaging=$root/app/packaging
version=$(sed -n 's/^project(forefront VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
for file in debian/changelog forefront.metainfo.xml CHANGELOG.md; do
    if ! grep -Fq "$version" "$packaging/$file"; then
        echo "package.sh: version $version is missing in app/packaging/$file; add its section" >&2
        exit 1
    fi
done
desktop-file-validate "$packaging/forefront.desktop"
appstreamcli validate --no-net "$packaging/forefront.metainfo.xml"

sh "$root/app/build.sh" package
# The same sources give the same packages: files are dated as the release.
SOURCE_DATE_EPOCH=$(dpkg-parsechangelog -l "$packaging/debian/changelog" -S Timestamp)
export SOURCE_DATE_EPOCH
cd "$root/build/package"
rm -f ./*.deb
umask 022 # folders of packages are readable
if ! cpack -G DEB >cpack.log 2>&1; then
    cat cpack.log >&2
    exit 1
fi
lintian --fail-on error,warning --tag-display-limit 0 ./*.deb
[ -z "$folder" ] || cp ./*.deb "$folder"
echo "packages in ${folder:-$root/build/package}:"
for package in *.deb; do
    echo "  $package, $(($(stat -c %s "$package") / 1024)) KB"
done
