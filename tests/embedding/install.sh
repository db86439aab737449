#!/bin/sh
# install.sh CMAKE BUILD WORK EXAMPLE CC CXX: installs BUILD, moves the installation, and builds and runs EXAMPLE
# against it, by find_package and by pkg-config.
set -eu
cmake=$1 build=$2 work=$3 example=$4 cc=$5 cxx=$6
here=$(cd "$(dirname "$0")" && pwd)
. "$here/clients.sh"
rm -rf "$work"
mkdir -p "$work"
DESTDIR= "$cmake" --install "$build" --prefix "$work/first" >"$work/log"
mv "$work/first" "$work/moved"
clients "$work/moved" "$work"
