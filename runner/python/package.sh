#!/bin/sh
# Packs the Python package that ./morula python has built: python3-morula as a .deb for this Debian's Python, and a wheel, which
# also brings the program along.
#
#   package.sh PYTHON-FOLDER PROGRAM OUT
set -eu
built=$1 program=$2 out=$3
about=$(basename "$built"/morula-*.dist-info)
version=${about#morula-}
version=${version%.dist-info}
architecture=$(dpkg --print-architecture 2>/dev/null || uname -m)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$out"
rm -f "$out"/python3-morula_*.deb "$out"/morula-*.whl

stage() { # FOLDER: the package without what Python makes of it
  mkdir -p "$1"
  cp -r "$built/morula" "$built/$about" "$1"
  find "$1" -name __pycache__ -prune -exec rm -rf {} +
  strip --strip-unneeded "$1"/morula/_morula.*.so
}

stage "$scratch/wheel"
mkdir -p "$scratch/wheel/morula-$version.data/scripts"
cp "$program" "$scratch/wheel/morula-$version.data/scripts/morula"
strip "$scratch/wheel/morula-$version.data/scripts/morula"
: >"$scratch/wheel/$about/RECORD"
/usr/bin/python3 -m wheel pack "$scratch/wheel" --dest-dir "$out"

command -v dpkg-deb >/dev/null || exit 0
root=$scratch/deb
stage "$root/usr/lib/python3/dist-packages"
mkdir -p "$root/DEBIAN" "$root/usr/share/doc/python3-morula" "$scratch/debian"
cp "$(dirname "$0")/../../LICENSE" "$root/usr/share/doc/python3-morula/copyright"
: >"$scratch/debian/control"
libraries=$(cd "$scratch" && dpkg-shlibdeps -O "$root"/usr/lib/python3/dist-packages/morula/_morula.*.so | sed 's/^shlibs:Depends=//')
now=$(/usr/bin/python3 -c 'import sys; print(f"python3 (>= 3.{sys.version_info[1]}), python3 (<< 3.{sys.version_info[1] + 1})")')
cat >"$root/DEBIAN/control" <<END
Package: python3-morula
Version: $version
Architecture: $architecture
Section: python
Maintainer: The Morula authors <authors@morula.org.invalid>
Depends: $libraries, libosmesa6, $now, python3-numpy
Recommends: morula, python3-pandas
Suggests: python3-pytest, python3-matplotlib
Description: simulator of dividing cells, from Python
 Runs Morula's scenarios from Python: state, tables and measures as NumPy arrays
 and DataFrames, the same bits as the program gives; and a plugin for pytest.
END
dpkg-deb --root-owner-group --build "$root" "$out/python3-morula_${version}_$architecture.deb"
