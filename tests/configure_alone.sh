#!/bin/sh
# Configures build/tidy, which compiles every source alone, for checks of single sources.
#
#   sh tests/configure_alone.sh [-DNAME=VALUE...]
set -eu
cd "$(dirname "$0")/.."
mkdir -p build/tidy
if ! cmake --preset release -B build/tidy -DFOREFRONT_PCH=OFF -DCMAKE_UNITY_BUILD=OFF "$@" >build/tidy/configure.log 2>&1
then
    cat build/tidy/configure.log >&2
    exit 1
fi
cmake --build build/tidy --target forefront_glad # its header is generated
