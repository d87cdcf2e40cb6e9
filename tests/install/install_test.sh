#!/bin/sh
# Tests the installation, far from the sources: install_test.sh BUILD CONFIGURATION. It runs, checks, reviews and
# reports a project of one scenario; a foreign program finds the library; shells complete; nothing is written into the
# installation.
set -eu
build=$1 configuration=$2
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix="$scratch/a place" # names with spaces must work
failures=0
fail() { echo "FAILED: $*" && failures=$((failures + 1)); }
has() { # has WHAT SAID: checks the last output
  grep -qF -e "$2" "$scratch/out" || { fail "$1 does not say '$2':" && head -n 20 "$scratch/out"; }
}
try() { # try CODE COMMAND...: leaves the output in $scratch/out
  expected=$1 code=0
  shift
  "$@" >"$scratch/out" 2>&1 || code=$?
  [ "$code" = "$expected" ] || { fail "$* ends with $code, not $expected:" && tail -n 20 "$scratch/out"; }
}
listed() { (cd "$prefix" && find . -type f -exec cksum {} + | LC_ALL=C sort -k 3); }

try 0 cmake --install "$build" --config "$configuration" --prefix "$prefix"
listed >"$scratch/before"
morula="$prefix/bin/morula"
unset MORULA_PRESET CI

# A shipped scenario runs from any folder.
mkdir -p "$scratch/project/scenarios"
cd "$scratch/project"
try 0 "$morula" run "$prefix/share/morula/scenarios/thesis/unique-four.yaml" --no-pictures
has "run of a shipped scenario" "checks   all 13 pass ($prefix/share/morula/golden/thesis/unique-four.golden)"
has "run of a shipped scenario" "picture  not compared: the run draws no picture"
try 0 "$morula" check "$prefix/share/morula/scenarios/thesis/unique-four.yaml"
has "check of a shipped scenario" "  ok    images"
hash=$(sed -n 's/^ *state *//p' "$scratch/out")

# A project's result is accepted, changed, waits for a review, and is accepted again.
sed -e '/^summary:/d' -e 's/^name:.*/name: one/' "$here/../browser/evil.yaml" >scenarios/one.yaml
try 0 "$morula" review scenarios/one.yaml --accept --by tests --why 'the first one'
[ -e golden/one.golden ] || fail "no golden in the project"
try 0 "$morula" check
try 0 "$morula" review
sed -i 's/constant: 172/constant: 190/' scenarios/one.yaml
try 1 "$morula" check --reports reports
has "a check that differs" "kept for \`morula review scenarios/one.yaml\`: golden/.pending/one-"
try 1 "$morula" review
has "review" "picture  golden/.pending/one-"
try 0 "$morula" check scenarios/one.yaml --help
try 0 "$morula" review scenarios/one.yaml --accept --by tests --why 'a higher pressure'
if [ -n "$(find golden/.pending -name 'one-*')" ]; then fail "what was accepted still waits"; fi
try 0 "$morula" check
try 0 "$morula" report results/unique-four-20080617 -o page.html --frames 3
if grep -q '<code>\./morula' page.html; then fail "commands of a page do not name the installed program"; fi
grep -q '<code>morula replay \|<code>morula render ' page.html || fail "a page has no commands"

# A program that knows only the installation uses the library.
example="$scratch/example/example"
try 0 cmake -S "$prefix/share/doc/morula/examples/example" -B "$scratch/example" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release
try 0 cmake --build "$scratch/example"
try 0 "$example" "$prefix/share/morula/scenarios/thesis/unique-four.yaml"
has "the example" "state hash $hash"
has "the example" "AB: a5, "
has "the example" "volume [length³]"
try 3 "$example" "$prefix/share/morula/scenarios/thesis/unique-four.yaml" physics.drg=5
has "the example with a wrong key" "--set physics.drg: unknown key; did you mean drag?"
try 1 "$example" "$scratch/no.yaml"
has "the example without a file" "no.yaml"

# Completion of the installed shells, and the manual.
share="$prefix/share"
complete='COMP_WORDS=(morula "$@") COMP_CWORD=$#; _morula 2>/dev/null; echo "${COMPREPLY[@]}"'
completes() { # completes EXPECTED WORD...
  wanted=$1
  shift
  # shellcheck disable=SC2016 # bash expands it
  found=$(bash -c '. "$0"; shift; '"$complete" "$share/bash-completion/completions/morula" - "$@")
  [ "$found" = "$wanted" ] || fail "bash completes '$*' to '$found', not '$wanted'"
}
if command -v bash >/dev/null; then
  completes "study" stu
  completes "plan" study pl
  completes "slurm snakemake parallel" study emit ""
  completes "--seed --seeds" run --seed
  completes "grid aabb-tree spatial-hash brute-force" run --search ""
  completes "scenarios" run sc
fi
if command -v fish >/dev/null; then
  found=$(fish -c "source '$share/fish/vendor_completions.d/morula.fish'; complete -C 'morula study emit '" | tr '\n' ' ')
  [ "$found" = "parallel slurm snakemake " ] || fail "fish completes to '$found'"
fi
if command -v zsh >/dev/null; then zsh -n "$share/zsh/vendor-completions/_morula" || fail "zsh does not read its completion"; fi
if command -v man >/dev/null; then
  try 0 man --warnings -P cat -l "$share/man/man1/morula.1.gz"
  has "the manual" "morula study plan"
  if grep -q 'warning\|<standard input>' "$scratch/out"; then fail "the manual has mistakes" && head -n 5 "$scratch/out"; fi
fi
for verb in $("$morula" internal describe bash | sed -n "s/^ *'') words='\([^']*\)'.*/\1/p"); do
  try 0 "$morula" "$verb" --help
  if [ "$verb" = study ]; then continue; fi
  options=$(sed -nE 's/^  (-., *)?(-.,)?(--[a-z-]+).*/\3/p' "$scratch/out" | sort)
  completed=$(bash -c '. "$0"; shift; '"$complete" "$share/bash-completion/completions/morula" - "$verb" -- | tr ' ' '\n' | grep '^--' | sort)
  [ "$options" = "$completed" ] || fail "completion and help of $verb differ: $options / $completed"
done

listed >"$scratch/after"
diff "$scratch/before" "$scratch/after" || fail "something was written into the installation"

# Pages that hold the simulator, or the message that the simulator for pages was not built.
four=results/unique-four-20080617
if [ -e "$share/morula/wasm/morula.wasm.gz" ]; then
  try 0 "$morula" report $four --rerun -o again.html --frames 2
  rm "$share/morula/wasm/morula.wasm.gz"
fi
if [ -e "$share/morula/wasm/playground.wasm.gz" ]; then
  try 0 "$morula" playground --scenarios scenarios
  has "playground" playground.html
  rm "$share/morula/wasm/playground.wasm.gz"
fi
rm -f again.html playground.html
try 6 "$morula" report $four --rerun -o again.html
has "report --rerun without it" "does not have it"
try 6 "$morula" playground
has "playground without it" "the installation does not have it"
if [ -e again.html ] || [ -e playground.html ]; then fail "what could not be made is there"; fi
[ "$failures" = 0 ] && echo "the installation works away from the sources"
