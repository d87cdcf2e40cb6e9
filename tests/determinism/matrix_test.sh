#!/usr/bin/env bash
# Tests the matrix in a small tree, with stand-ins for our programs that give chosen hashes: the table is right, and no
# difference is missed.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tree="$scratch/a tree" # names with spaces must work
tests=$tree/tests/determinism
failures=0

check() { # WHAT EXPECTED ACTUAL
  if [ "$2" != "$3" ]; then
    printf 'FAILED: %s\n  expected: %s\n  actual:   %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
  fi
}
matrix() { # leaves the table's rows in $rows, its last lines in $end
  code=0
  out=$("$tests/matrix.sh" "$tree/build" "$@" 2>"$scratch/err") || code=$?
  rows=$(grep -E 'same|OTHER|–' <<<"$out" | grep -v 'the same, ' | tr -s ' ' | sed 's/ $//' || :)
  end=$(grep 'the same, ' <<<"$out" || :)
}
program() { # FILE, its text on stdin
  mkdir -p "$(dirname "$1")"
  { printf '#!/bin/sh\n' && cat; } >"$1"
  chmod +x "$1"
}

mkdir -p "$tests" "$tree/scenarios/a" "$tree/golden/a"
cp "$here"/{matrix,matrix_cell,compare_golden}.sh "$here/reverse_keys.awk" "$tests"
for scene in one two; do
  printf 'name: %s\nseed: 1\nphysics:\n  drag: 1\n  mesh: {icosphere: 2, coarsen: 0.2}\n' $scene >"$tree/scenarios/a/$scene.yaml"
  printf 'bits solver hash-of-%s\nstep_hash 0 start-of-%s\n' $scene $scene >"$tree/golden/a/$scene.golden"
done
program "$tree/build/tests/determinism/hash_program" <<<'echo narrow'
program "$tree/build/tests/determinism/write_scene" <<<'cat "$1"'
program "$tree/build/morula" <<'END'
scene=$(basename "$2" .yaml) hash=hash-of-$scene code=0
case "$*" in
  *one*--wrong*) hash=another code=1 ;;
  *one*--unseen*) hash=another ;;
  *one*--silent*) exit 0 ;;
  *two*--crash*) kill -SEGV $$ ;;
esac
if [ "$(pwd -P)" != "${FOLDER:-$(pwd -P)}" ] || ! head -n 1 "$2" | grep -q "${FIRST:-name}"; then hash=elsewhere; fi
printf '{"results": [\n {\n "check": "counts",\n "actual": "3"\n },\n {\n "check": "bits",\n "actual": "%s",\n "tolerance": "exact"\n }\n]}\n' "$hash"
exit $code
END
program "$tests/build_as.sh" <<'END'
case $1 in broken) echo "no semicolon"; exit 1 ;; absent) echo "cc is not installed"; exit 77 ;; esac
mkdir -p "$2"
cat >"$2/run_scene" <<'PROGRAM'
#!/bin/sh
scene=$(sed -n 's/name: //p' "$3")
echo "bits solver hash-of-$scene"
echo "step_hash 0 start-of-one" # for every scene
PROGRAM
chmod +x "$2/run_scene"
END

table() { cat >"$tests/configurations.sh"; }
table <<'END'
configuration "as it is" ordinary all morula
configuration "reversed" ordinary all env -C "$work/reversed" FIRST=physics "FOLDER=$work/reversed" morula
END
matrix
check "all the same" "as it is same same
reversed same same" "$rows"
check "all the same: exit code" 0 "$code"
check "all the same: the count" "4 the same, 0 other, 0 not run" "$end"

for wrong in wrong unseen silent; do
  table <<<"configuration fine ordinary all morula
    configuration odd ordinary all morula --$wrong"
  matrix
  check "$wrong: the table" "fine same same
odd OTHER same" "$rows"
  check "$wrong: exit code" 1 "$code"
done
table <<<'configuration crash ordinary all morula --crash'
matrix
check "a crash is no sameness" "crash same OTHER" "$rows"

table <<'END'
configuration fine ordinary all morula
configuration alone alone all run_scene --isa narrow
configuration "not here" absent all morula
configuration wide ordinary all morula --isa avx2
END
matrix
check "the simulator alone; what cannot be run here says why" "fine same same
alone same OTHER
not here – – –: cc is not installed
wide – – –: this processor, or this build, has no avx2" "$rows"
check "what cannot be run here: the count" "3 the same, 1 other, 4 not run" "$end"

matrix here
check "nothing has been run: exit code" 1 "$code"
matrix fine wide
check "only the rows that are asked for" "fine same same
wide – – –: this processor, or this build, has no avx2" "$rows"
check "what is not here is no difference" 0 "$code"
matrix nothing
check "no such row: exit code" 2 "$code"
check "no such row: which there are" 1 "$(grep -c '  not here' "$scratch/err")"

table <<<'configuration fine ordinary all morula
  configuration broken broken all morula'
matrix
check "a build that fails" "fine same same
broken – – –: the build failed: $tree/build/matrix/broken.log" "$rows"
check "a build that fails: exit code" 1 "$code"

table <<<'configuration fine ordinary all morula'
echo "count cells 4" >"$tree/golden/a/one.golden"
matrix
check "a golden without a hash" "fine OTHER same" "$rows"

[ "$failures" = 0 ] && echo "the matrix behaves"
