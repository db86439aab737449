# Sourced by install.sh and package.sh: clients PREFIX WORK builds and runs $example against the installation in PREFIX,
# by find_package and by pkg-config. Reads $cmake, $cc, $cxx and $here, this folder.
clients() {
    prefix=$1 work=$2
    version=$("$prefix/bin/netmesh" --version | sed 's/[^0-9.]*\([0-9.]*\).*/\1/')
    "$cmake" -S "$here/installed" -B "$work/build" "-DCMAKE_PREFIX_PATH=$prefix" "-DEXAMPLE=$example" \
        "-DVERSION=$version" "-DCMAKE_C_COMPILER=$cc" "-DCMAKE_CXX_COMPILER=$cxx" >>"$work/log"
    "$cmake" --build "$work/build" >>"$work/log"
    # That of this prefix, and not one that the machine has.
    case $(sed -n 's/^netmesh_DIR:PATH=//p' "$work/build/CMakeCache.txt") in "$prefix"/*) ;; *) exit 1 ;; esac
    "$work/build/client_c" | grep "H1: born"
    "$work/build/client_cpp"

    if ! command -v pkg-config >/dev/null; then
        echo "pkg-config is not installed; its part is SKIPPED"
        return
    fi
    PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name netmesh.pc)")
    export PKG_CONFIG_PATH
    "$cc" -std=c11 -pedantic -Wall -Wextra -Werror "$example" $(pkg-config --cflags --libs netmesh) \
        -o "$work/by_pkg_config"
    "$work/by_pkg_config" | grep "H1: born"
    [ "$(pkg-config --modversion netmesh)" = "$version" ]
}
