#!/bin/sh
# Bundles an installation with all libraries that it needs but the C library's: for Linux systems with this glibc or a later one.
#
#   bundle.sh INSTALLATION OUT.tar.xz
set -eu
from=$1 out=$2
name=$(basename "$out" .tar.xz)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
to=$scratch/$name
mkdir -p "$to/lib"
cp -r "$from/bin" "$from/share" "$to"
strip "$to/bin/morula"

# The program loads OSMesa only when it draws.
osmesa=$(ldconfig -p | sed -n 's/.*libOSMesa\.so\.8 .*=> //p' | head -n 1)
[ -n "$osmesa" ] || { echo "there is no libOSMesa.so.8 to bundle" >&2 && exit 6; }
ldd "$to/bin/morula" "$osmesa" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' | sort -u | while read -r library; do
  case $(basename "$library") in
    libc.so.* | libm.so.* | libdl.so.* | librt.so.* | libpthread.so.* | libresolv.so.* | ld-linux*) ;;
    *) cp -L "$library" "$to/lib" ;;
  esac
done
cp -L "$osmesa" "$to/lib"
fonts=/usr/share/fonts/truetype/dejavu
mkdir -p "$to/share/fonts" && cp "$fonts/DejaVuSans.ttf" "$fonts/DejaVuSans-Bold.ttf" "$fonts/DejaVuSansMono.ttf" "$to/share/fonts"
cat >"$to/fonts.conf" <<'END'
<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig><dir prefix="relative">share/fonts</dir></fontconfig>
END
cat >"$to/morula" <<'END'
#!/bin/sh
# Starts the program with the libraries beside it.
here=$(dirname "$(readlink -f "$0")")
LD_LIBRARY_PATH=$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LD_LIBRARY_PATH
if [ ! -e /etc/fonts/fonts.conf ]; then export FONTCONFIG_FILE="$here/fonts.conf"; fi
exec "$here/bin/morula" "$@"
END
chmod +x "$to/morula"
mkdir -p "$(dirname "$out")"
tar -C "$scratch" --owner=0 --group=0 -I "xz -2 -T0" -cf "$out" "$name"
