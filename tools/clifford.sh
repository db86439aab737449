#!/bin/sh
# The experiment of section 7.7 from a bare machine: 2,000 points of a curve on the Clifford torus in R^4, their mesh
# and its persistent homology. Leaves clifford.pers (the diagram) and clifford.svg (barcode and diagram) in this
# directory and prints the holes that are certified to exist.
# On a Debian, as root, it first installs what is missing; otherwise it says what that is and changes nothing.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)

missing=
command -v cmake >/dev/null || missing="$missing cmake"
command -v make >/dev/null || command -v ninja >/dev/null || missing="$missing make"
command -v c++ >/dev/null || command -v g++ >/dev/null || command -v clang++ >/dev/null || missing="$missing g++"
if [ -n "$missing" ]; then
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        # Only what is missing, and zlib, with which the tool reads .gz; stdout stays for the result.
        apt-get update >&2
        # shellcheck disable=SC2086
        DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing zlib1g-dev >&2
    else
        echo "please install:$missing" >&2
        echo "on a Debian: sudo apt-get install --no-install-recommends$missing" >&2
        exit 1
    fi
fi

build=$root/build
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DNETMESH_BUILD_TESTS=OFF >&2
cmake --build "$build" --target netmesh_tool --parallel "$(getconf _NPROCESSORS_ONLN)" >&2

"$build/netmesh" sample clifford -n 2000 | "$build/netmesh" persist - --filter complete --tau 3.08 --bounds \
    -o clifford.pers --svg clifford.svg
echo "certified to exist, however short, whatever the mesh (a torus has two holes of degree 1 and one of degree 2):"
awk '$1 >= 1 && $NF == "exists" { printf "  degree %d: born at radius %.3f, dies at %.3f\n", $1, $2, $3 }' clifford.pers
echo "wrote clifford.pers and clifford.svg (open it in a browser)"
