#!/bin/sh
# package.sh CMAKE BUILD WORK EXAMPLE CC CXX: makes the Debian packages of BUILD, looks at what they say and hold,
# unpacks them into a folder and builds and runs EXAMPLE against that, by find_package and by pkg-config. As root it
# also installs and purges them in a system of their own. lintian has its say where it is installed.
set -eu
cmake=$1 build=$2 work=$3 example=$4 cc=$5 cxx=$6
here=$(cd "$(dirname "$0")" && pwd)
. "$here/clients.sh"
cpack=$(dirname "$cmake")/cpack
for program in "$cpack" dpkg dpkg-deb; do
    command -v "$program" >/dev/null || { echo "$program is not installed: SKIPPED"; exit 0; }
done
fail() { echo "$*"; exit 1; }

rm -rf "$work"
mkdir -p "$work/root" "$work/packages"
# Of what is built: with the generator of Makefiles cpack would build all first.
(cd "$work/packages" &&
    "$cpack" -G DEB -D CPACK_CMAKE_GENERATOR=Ninja --config "$build/CPackConfig.cmake" -B "$work/packages") \
    >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
tool=$(find "$work/packages" -maxdepth 1 -name 'netmesh_*.deb')
library=$(find "$work/packages" -maxdepth 1 -name 'libnetmesh-dev_*.deb')
[ -f "$tool" ] && [ -f "$library" ] || fail "not one package of each: $tool $library"

# What they say. The library needs nothing; the tool needs the system's libraries.
version=$("$build/netmesh" --version | sed 's/[^0-9.]*\([0-9.]*\).*/\1/')
for package in "$tool" "$library"; do
    dpkg-deb --info "$package" >>"$work/log"
    [ "$(dpkg-deb -f "$package" Version)" = "$version-1" ] || fail "$package: not version $version-1"
    [ "$(dpkg-deb -f "$package" Architecture)" = "$(dpkg --print-architecture)" ] || fail "$package: architecture"
    case $(dpkg-deb -f "$package" Maintainer) in ?*' <'?*@?*'>') ;; *) fail "$package: no maintainer" ;; esac
    [ "$(dpkg-deb -f "$package" Description | wc -l)" -gt 3 ] || fail "$package: no description"
done
[ "$(dpkg-deb -f "$tool" Package Section)" = "$(printf 'Package: netmesh\nSection: math')" ] || fail "name, section"
[ "$(dpkg-deb -f "$library" Package Section)" = "$(printf 'Package: libnetmesh-dev\nSection: libdevel')" ] ||
    fail "name, section"
[ -z "$(dpkg-deb -f "$library" Depends)" ] || fail "the library depends on $(dpkg-deb -f "$library" Depends)"
case $(dpkg-deb -f "$tool" Depends) in *libc6*libstdc++6*) ;; *) fail "the tool does not name its libraries" ;; esac

# What they hold: each file in one of them, the tool by itself.
contents() { dpkg-deb --fsys-tarfile "$1" | tar -t | grep -v '/$' | sort; }
contents "$tool" >"$work/tool"
contents "$library" >"$work/library"
cat >"$work/expected" <<END
./usr/bin/netmesh
./usr/share/bash-completion/completions/netmesh
./usr/share/man/man1/netmesh-check.1.gz
./usr/share/man/man1/netmesh-delaunay.1.gz
./usr/share/man/man1/netmesh-distance.1.gz
./usr/share/man/man1/netmesh-homology.1.gz
./usr/share/man/man1/netmesh-mesh.1.gz
./usr/share/man/man1/netmesh-persist.1.gz
./usr/share/man/man1/netmesh-pieces.1.gz
./usr/share/man/man1/netmesh-sample.1.gz
./usr/share/man/man1/netmesh-size.1.gz
./usr/share/man/man1/netmesh-vineyard.1.gz
./usr/share/man/man1/netmesh.1.gz
./usr/share/zsh/site-functions/_netmesh
END
grep -v '^./usr/share/doc/netmesh/' "$work/tool" | diff "$work/expected" - || exit 1
for file in include/netmesh.h include/netmesh.hpp include/netmesh/mesh.h; do
    grep -qx "./usr/$file" "$work/library" || fail "$file is in no package"
done
for file in libnetmesh.a netmesh.pc netmesh-config.cmake netmesh-config-version.cmake netmesh-targets.cmake; do
    [ "$(grep -c "^./usr/lib/.*/*$file\$" "$work/library")" -eq 1 ] || fail "$file is not in the package once"
done
! grep -v '^./usr/\(include\|lib\|share/doc/libnetmesh-dev\)/' "$work/library" || fail "files at odd places"
for package in netmesh libnetmesh-dev; do
    for file in copyright changelog.gz changelog.Debian.gz; do
        cat "$work/tool" "$work/library" | grep -qx "./usr/share/doc/$package/$file" || fail "$package: no $file"
    done
done

# What they give.
dpkg -x "$tool" "$work/root"
dpkg -x "$library" "$work/root"
clients "$work/root/usr" "$work"

if [ "$(id -u)" -eq 0 ]; then
    system=$work/system
    mkdir -p "$system/var/lib/dpkg/info" "$system/var/lib/dpkg/updates"
    : >"$system/var/lib/dpkg/status"
    # Its libraries are those of the machine, which that system does not know of.
    dpkg --root="$system" --log=/dev/null -i "$library" >>"$work/log"
    dpkg --root="$system" --log=/dev/null --force-depends -i "$tool" >>"$work/log" 2>&1
    "$system/usr/bin/netmesh" --version
    dpkg --root="$system" --log=/dev/null -P netmesh libnetmesh-dev >>"$work/log"
    [ -z "$(find "$system" -name '*netmesh*')" ] || fail "not all is gone after purging"
fi
if command -v lintian >/dev/null; then
    lintian --fail-on error "$tool" "$library" >"$work/lintian" 2>&1 || { cat "$work/lintian"; exit 1; }
    sed 's/^/lintian: /' "$work/lintian"
else
    echo "lintian is not installed; it was not asked"
fi
