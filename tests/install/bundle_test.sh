#!/bin/sh
# Tests the bundle for other Linux systems in a root that has the C library, a shell and nothing else: bundle_test.sh BUILD
# CONFIGURATION. Skipped without root, since it changes the root.
set -eu
build=$1 configuration=$2
source=$(cd "$(dirname "$0")/../.." && pwd)
[ "$(id -u)" = 0 ] || { echo "skipped: chroot needs root" && exit 77; }
ldconfig -p | grep -q 'libOSMesa\.so\.8 ' || { echo "skipped: there is no libOSMesa.so.8" && exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --config "$configuration" --prefix "$scratch/installed" >/dev/null
"$source/runner/install/bundle.sh" "$scratch/installed" "$scratch/morula-test-linux.tar.xz"

root=$scratch/root
mkdir -p "$root/tmp" "$root/bin"
tar -C "$root" -xf "$scratch/morula-test-linux.tar.xz"
for program in sh dirname readlink; do
  path=$(readlink -f "$(command -v $program)")
  cp "$path" "$root/bin/$program"
  ldd "$path" | grep -o '/[^ ]*' | while read -r library; do mkdir -p "$root$(dirname "$library")" && cp -L "$library" "$root$library"; done
done
libc=$(dirname "$(ldd /bin/sh | sed -n 's/.*libc\.so\.6 => \([^ ]*\) .*/\1/p')")
for library in libm.so.6 libdl.so.2 librt.so.1 libpthread.so.0; do cp -L "$libc/$library" "$root$libc"; done
chroot "$root" /bin/sh -c 'cd /tmp && PATH=/bin /morula-test-linux/morula run /morula-test-linux/share/morula/scenarios/thesis/unique-four.yaml' \
  >"$scratch/out" 2>&1 || { cat "$scratch/out" && exit 1; }
for word in 'all 14 pass' organism.png; do
  grep -qF "$word" "$scratch/out" || { echo "FAILED: no '$word':" && cat "$scratch/out" && exit 1; }
done
picture=$(find "$root/tmp/results" -name organism.png)
[ "$(head -c 4 "$picture" | tail -c 3)" = PNG ] || { echo "FAILED: no picture" && exit 1; }
echo "the bundle ($(wc -c <"$scratch/morula-test-linux.tar.xz") bytes) runs and draws in a root with the C library alone"
