#!/bin/sh
# The experiment of section 7.7 from a bare machine: 2,000 points of a curve on the Clifford torus in R^4, their mesh
# and its persistent homology. Leaves clifford.pers (the diagram) and clifford.svg (barcode and diagram) in this
# directory.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)

missing=
command -v cmake >/dev/null || missing="$missing cmake"
command -v make >/dev/null || command -v ninja >/dev/null || missing="$missing make"
command -v c++ >/dev/null || command -v g++ >/dev/null || command -v clang++ >/dev/null || missing="$missing g++"
if [ -n "$missing" ]; then
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        # Only what is missing; stdout stays for the result.
        apt-get update >&2
        # shellcheck disable=SC2086
        DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing >&2
    else
        echo "please install:$missing" >&2
        exit 1
    fi
fi

build=$root/build
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DNETMESH_BUILD_TESTS=OFF >&2
cmake --build "$build" --target netmesh_tool -- -j2 >&2

"$build/netmesh" sample clifford -n 2000 | "$build/netmesh" persist - --filter complete --tau 3.08 \
    -o clifford.pers --svg clifford.svg
echo "wrote clifford.pers and clifford.svg"
