#!/bin/sh
# Reads exported meshes with deal.II and dolfinx. Their packages are some 250 MB to download and 1.7 GB on disk, so the
# ordinary tests leave them out; the outcome of the last run is kept in heavy_readers.txt.
#
#   sh tests/readers/heavy_readers.sh EXPORT_SAMPLE [RESULT]
#
#   EXPORT_SAMPLE   the program forefront_export_sample of a build with tests
#   RESULT          the file for the outcome, in place of heavy_readers.txt
#
# Exit status 77: packages are missing.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
if [ $# -lt 1 ] || [ $# -gt 2 ] || [ ! -x "$1" ]; then
    sed -n '2,10s/^# \{0,1\}//p' "$0" >&2
    exit 2
fi
packages='libdeal.ii-dev python3-dolfinx-real python3-gmsh g++'
# shellcheck disable=SC2086  # a list of packages
if [ "$(dpkg-query -W -f '${db:Status-Status}\n' $packages 2>/dev/null | grep -cx installed)" != 4 ]; then
    echo "heavy_readers.sh: packages are missing; as root: apt-get install --no-install-recommends $packages" >&2
    exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mpi=$(dirname "$(find /usr/lib -name mpi.h -path '*openmpi*' | head -n 1)")
g++ -std=c++17 -isystem /usr/include/trilinos -isystem "$mpi" "$here/dealii_reader.cpp" -o "$work/dealii_reader" \
    -Wl,--copy-dt-needed-entries -ldeal.ii
/usr/bin/python3 "$here/check_heavy_readers.py" "$1" "$work/dealii_reader" "${2:-$here/heavy_readers.txt}"
