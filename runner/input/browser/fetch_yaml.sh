#!/bin/sh
# The sources of yaml-cpp, from which the playground's reader is built for WebAssembly: fetch_yaml.sh FOLDER makes FOLDER/yaml-cpp, unless it
# is there. Debian's source package, by a list of its own, so that this machine's lists stay as they are. Exit codes: 0 it is there, 77 there
# is no apt-get or no dpkg-source, 1 it could not be fetched.
set -eu
mkdir -p "$1"
folder=$(cd "$1" && pwd)
if [ -e "$folder/yaml-cpp" ]; then exit 0; fi
command -v apt-get >/dev/null && command -v dpkg-source >/dev/null || exit 77
work=$folder/yaml-fetch
rm -rf "$work"
mkdir -p "$work/lists/partial"
cd "$work"
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  if [ -e "$list" ]; then sed -n 's/^deb /deb-src /p' "$list"; fi
done >own.list
for list in /etc/apt/sources.list.d/*.sources; do
  if [ -e "$list" ]; then sed 's/^Types:.*/Types: deb-src/' "$list" && echo; fi
done >own.sources
set -- -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/parts" -o Dir::State::Lists="$work/lists" -o APT::Sandbox::User=root
mkdir parts
cp own.list own.sources parts
apt-get "$@" -q update && apt-get "$@" -q source --download-only yaml-cpp || exit 1
dpkg-source --no-check -x ./*.dsc source || exit 1
mv source "$folder/yaml-cpp"
rm -rf "$work"
