#!/bin/sh
# install.sh CMAKE BUILD WORK EXAMPLE CC CXX: installs BUILD, moves the installation, and builds and runs EXAMPLE
# against it, by find_package and by pkg-config.
set -eu
cmake=$1 build=$2 work=$3 example=$4 cc=$5 cxx=$6
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
DESTDIR= "$cmake" --install "$build" --prefix "$work/first" >"$work/log"
mv "$work/first" "$work/moved"

"$cmake" -S "$here/installed" -B "$work/build" "-DCMAKE_PREFIX_PATH=$work/moved" "-DEXAMPLE=$example" \
    "-DCMAKE_C_COMPILER=$cc" "-DCMAKE_CXX_COMPILER=$cxx" >>"$work/log"
"$cmake" --build "$work/build" >>"$work/log"
"$work/build/client_c" | grep "certified ratio"
"$work/build/client_cpp"

if ! command -v pkg-config >/dev/null; then
    echo "pkg-config is not installed; its part is SKIPPED"
    exit 0
fi
PKG_CONFIG_PATH=$(dirname "$(find "$work/moved" -name netmesh.pc)")
export PKG_CONFIG_PATH
"$cc" -std=c99 -pedantic -Wall -Wextra -Werror "$example" $(pkg-config --cflags --libs netmesh) -o "$work/by_pkg_config"
"$work/by_pkg_config" | grep "certified ratio"
[ "$(pkg-config --modversion netmesh)" = "$("$work/moved/bin/netmesh" --version | sed 's/[^0-9.]*\([0-9.]*\).*/\1/')" ]
