#!/bin/sh
# Tests the start script ./morula in a small tree, with stand-ins for apt, cmake and ctest that log their calls: when
# does it install, configure and build, and when not?
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tree="$scratch/a tree" # names with spaces must work
calls=$scratch/calls
failures=0

check() { # WHAT EXPECTED ACTUAL
  if [ "$2" != "$3" ]; then
    printf 'FAILED: %s\n  expected: %s\n  actual:   %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
  fi
}

# Runs ./morula and leaves stdout, stderr, exit code and calls behind.
start() {
  : >"$calls"
  code=0
  PATH="$scratch/bin:$PATH" "$tree/morula" "$@" >"$scratch/out" 2>"$scratch/err" || code=$?
  out=$(cat "$scratch/out")
  called=$(tr '\n' ';' <"$calls")
}

later() { # waits for the file system's clock before
  sleep 0.02
  "$@"
}

forget() { # removes packages
  for package; do grep -vxF -e "$package" "$installed" >"$scratch/rest" && mv "$scratch/rest" "$installed"; done
}

stand_in() { # NAME, its text on stdin
  { printf '#!/bin/sh\n' && cat; } >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}

mkdir -p "$scratch/bin" "$tree/core/base" "$tree/reports" "$tree/runner" "$tree/.git/logs"
cp "$source/morula" "$source/.packages" "$tree"
touch "$tree/CMakeLists.txt" "$tree/CMakePresets.json" "$tree/core/base/a.h" "$tree/core/base/b.h" "$tree/.git/logs/HEAD"
export MORULA_TEST_SCRATCH="$scratch" # the stand-ins write into this folder
unset MORULA_PRESET
installed=$scratch/installed
sed -n '/^\[build\]/,/^\[test\]/s/^\([a-z0-9+.-]*\).*/\1/p' "$source/.packages" | sed '/^$/d' >"$installed"

# npm is a stand-in from elsewhere: Debian's npm conflicts with other packages of it.
for_tests=$(awk '/^\[/ { wanted = $1 == "[test]"; next } wanted && /^[a-z]/ && $1 != "npm" { printf "%s%s", space, $1; space = " " }' "$source/.packages")
stand_in npm </dev/null

stand_in dpkg-query <<'END'
shift 3
for package; do grep -qxF -e "$package" "$MORULA_TEST_SCRATCH/installed" && printf '%s:installed ' "$package"; done
exit 1 # the real program fails for unknown packages
END
stand_in apt-get <<'END'
[ "$1 $2" = "-y -o" ] && shift 3
echo "apt-get $*" >>"$MORULA_TEST_SCRATCH/calls"
[ "$1" = update ] && touch "$MORULA_TEST_SCRATCH/updated"
[ "$1" = install ] && [ ! -e "$MORULA_TEST_SCRATCH/updated" ] && exit 100
[ "$1" = install ] && shift 2 && printf '%s\n' "$@" >>"$MORULA_TEST_SCRATCH/installed"
exit 0
END
stand_in id <<'END'
echo "${MORULA_TEST_ID:-0}"
END
stand_in cmake <<'END'
case $1 in
  --preset)
    with= tests=OFF python=OFF
    case "$*" in *-DBUILD_TESTING=ON*) with=" with tests" tests=ON ;; esac
    case "$*" in *-DMORULA_PYTHON=ON*) with="$with with Python" python=ON ;; esac
    echo "configure $2$with" >>"$MORULA_TEST_SCRATCH/calls"
    mkdir -p "build/$2"
    touch "build/$2/build.ninja"
    printf '%s\n' "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "BUILD_TESTING:BOOL=$tests" \
      "MORULA_PYTHON:BOOL=$python" >"build/$2/CMakeCache.txt"
    ;;
  --build)
    echo "build $4" >>"$MORULA_TEST_SCRATCH/calls"
    mkdir "$MORULA_TEST_SCRATCH/busy" || echo "TWO AT ONCE" >>"$MORULA_TEST_SCRATCH/calls"
    sleep "${MORULA_TEST_BUILD_TIME:-0}"
    rmdir "$MORULA_TEST_SCRATCH/busy"
    [ -e "$MORULA_TEST_SCRATCH/broken" ] && printf 'quiet part\nFAILED: a.o\nno semicolon\n' && exit 1
    made=$2/morula word=program
    if [ "$4" = morula-run ]; then made=$2/morula-run word=alone; fi
    printf '#!/bin/sh\necho "%s $*"\nexit 3\n' $word >"$made"
    chmod +x "$made"
    ;;
esac
END
stand_in ctest <<'END'
echo "ctest $*"
exit 8
END

start run "a b"
check "the first call of run configures, and builds the program of this verb alone" "configure release;build morula-run;" "$called"
check "it says so" 1 "$(grep -c 'building the verb run, which takes some minutes' "$scratch/err")"
check "this program runs" "alone run a b" "$out"
start run && check "the second call of run does nothing but start it" "" "$called"
later touch "$tree/core/base/a.h" && start run && check "after an edit it is built" "build morula-run;" "$called"

start check "a b"
check "the first call of another verb builds the whole program" "build morula;" "$called"
check "stdout belongs to the program, which gets the arguments" "program check a b" "$out"
check "the program's exit code passes through" 3 "$code"
start run && check "from then on it runs, too" "program run" "$out"

start run
check "the second call does nothing but start the program" "" "$called"
check "and says nothing" "" "$(cat "$scratch/err")"

later touch "$tree/core/base/a.h" && start && check "after an edit it builds" "build morula;" "$called"
later rm "$tree/core/base/b.h" && start && check "after a deletion it builds" "build morula;" "$called"
later touch -d 2001-01-01 "$tree/runner/old.cpp" && start && check "after an old file came it builds" "build morula;" "$called"
later touch "$tree/.git/logs/HEAD" && start && check "after a commit it builds" "build morula;" "$called"
later touch "$tree/CMakeLists.txt" && start && check "after a change of the build it builds" "build morula;" "$called"
later touch "$tree/CMakePresets.json" && start && check "after a change of presets it configures" "configure release;build morula;" "$called"
later rm "$tree/build/release/morula" && start && check "without the program it builds" "build morula;" "$called"
start && check "and then it rests" "" "$called"

later mv "$tree" "$scratch/moved" && tree="$scratch/moved" && start
check "in another place it configures anew" "configure release;build morula;" "$called"

ln -s "$tree/morula" "$scratch/link"
(cd / && PATH="$scratch/bin:$PATH" exec "$scratch/link" x >"$scratch/out") || :
check "it may be called through a link, from elsewhere" "program x" "$(cat "$scratch/out")"

MORULA_PRESET=dev start && check "another preset" "configure dev;build morula;" "$called"
MORULA_PRESET=../dev start && check "a preset that is a path is refused" 2 "$code"

later touch "$scratch/broken" "$tree/core/base/a.h" && start run
check "a build that fails" 70 "$code"
check "does not start the old program" "" "$out"
check "shows what failed, and not the rest" "FAILED: a.o no semicolon" "$(grep -v '^morula:' "$scratch/err" | tr '\n' ' ' | sed 's/ $//')"
start && check "is tried again" "build morula;" "$called"
rm "$scratch/broken" && start && check "until it succeeds" 3 "$code"

forget g++
start && check "packages are not looked at when nothing is to be built" "" "$called"
later touch "$tree/core/base/a.h"
stand_in sudo <<'END'
echo "sudo" >>"$MORULA_TEST_SCRATCH/calls"
exec "$@"
END
start
check "a missing package is installed, and the lists fetched only because that failed" \
  "apt-get install --no-install-recommends g++;apt-get update;apt-get install --no-install-recommends g++;build morula;" "$called"
check "it says so" "morula: installing with apt-get: g++ " "$(head -n 1 "$scratch/err")"

MORULA_TEST_ID=1000 start test -R unit
check "test: everything is built, with tests; sudo if not root; the test packages too" \
  "sudo;apt-get install --no-install-recommends $for_tests;configure release with tests;build all;" "$called"
ctest="ctest --test-dir $tree/build/release --no-tests=error --output-on-failure --parallel 3"
check "test: ctest gets the arguments" "$ctest --label-exclude only-with-all -R unit" "$out"
check "test: ctest's exit code passes through" 8 "$code"
start && check "test: the program is built with everything" "" "$called"
start test --all -R unit
check "test: tests are configured once" "build all;" "$called"
check "test --all: no test is left out" "$ctest -R unit" "$out"
later touch "$tree/core/base/a.h" && start && check "test: tests stay configured" "build morula;" "$called"

mkdir -p "$tree/tests/determinism"
printf '#!/bin/sh\necho "matrix $*"\nexit 1\n' >"$tree/tests/determinism/matrix.sh" && chmod +x "$tree/tests/determinism/matrix.sh"
start test --matrix "gcc -O0" clang
check "test --matrix: everything is built" "build all;" "$called"
check "test --matrix: it gets the build and the arguments" "matrix $tree/build/release gcc -O0 clang" "$out"
check "test --matrix: its exit code passes through" 1 "$code"

mkdir -p "$tree/core/wasm" "$tree/runner/input/browser"
printf '#!/bin/sh\necho "fetch $1" >>"$MORULA_TEST_SCRATCH/calls"\n' >"$tree/runner/input/browser/fetch_yaml.sh"
chmod +x "$tree/runner/input/browser/fetch_yaml.sh"
printf '#!/bin/sh\nmkdir -p "$1" && touch "$1/morula.wasm.gz"\necho "wasm $1" >>"$MORULA_TEST_SCRATCH/calls"\nexit "${MORULA_TEST_WASM-0}"\n' >"$tree/core/wasm/build.sh"
chmod +x "$tree/core/wasm/build.sh"
forget emscripten nodejs file
start wasm
check "wasm: what it needs is installed, and the program is not built" "apt-get install --no-install-recommends emscripten nodejs;fetch $tree/build/release/wasm;wasm $tree/build/release/wasm;" "$called"
check "wasm: it says where it is" "$tree/build/release/wasm/morula.wasm.gz" "$out"
MORULA_TEST_WASM=1 start wasm
check "wasm: what fails is our fault" 70 "$code"

stand_in cpack <<'END'
echo "cpack" >>"$MORULA_TEST_SCRATCH/calls"
for last; do :; done
mkdir -p "$last" && touch "$last/a.deb" "$last/a.tar.gz"
END
mkdir -p "$tree/runner/python"
printf '#!/bin/sh\ntouch "$3/a.whl"\n' >"$tree/runner/python/package.sh" && chmod +x "$tree/runner/python/package.sh"
mkdir -p "$tree/runner/install"
printf '#!/bin/sh\ntouch "$2"\n' >"$tree/runner/install/bundle.sh" && chmod +x "$tree/runner/install/bundle.sh"
start package
check "package: everything is built first" \
  "apt-get install --no-install-recommends file python3-wheel;build all;configure release with Python;build python-package;cpack;" "$called"
made=$tree/build/release/packages/a
check "package: it says what it made" "$made.deb $made.tar.gz $made.whl $tree/build/release/packages/morula-linux-$(uname -m).tar.xz" "$(echo $out)"
start python
check "python: what it needs is configured once" "build python-package;" "$called"
check "python: it says where the package is" "$tree/build/release/python" "$out"
start python tests
check "python: takes nothing more" 2 "$code"

: >"$installed" && later touch "$tree/core/base/a.h" && rm "$scratch/bin/sudo"
if [ ! -e /usr/bin/sudo ]; then
  MORULA_TEST_ID=1000 start
  check "neither root nor sudo: exit code" 6 "$code"
  check "neither root nor sudo: nothing is tried" "" "$called"
  check "neither root nor sudo: says what to ask for" 1 "$(grep -c 'apt-get install --no-install-recommends g++ cmake' "$scratch/err")"
fi
start && later touch "$tree/core/base/a.h"

: >"$calls"
export MORULA_TEST_BUILD_TIME=0.3
for n in 1 2 3; do (PATH="$scratch/bin:$PATH" "$tree/morula" $n >"$scratch/out$n" 2>&1 || :) & done
wait
check "of several at once, one builds" "build morula;" "$(tr '\n' ';' <"$calls")"
for n in 1 2 3; do check "of several at once, each runs" "program $n" "$(grep '^program' "$scratch/out$n")"; done

[ "$failures" = 0 ] && echo "the start script behaves"
