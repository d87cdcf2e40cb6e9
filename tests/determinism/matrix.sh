#!/usr/bin/env bash
# One hash per shipped scene over everything that must not matter: each configuration runs each scene and compares it with
# its golden. ./morula test --matrix calls this.
#
#   matrix.sh BUILD [PATTERN...]
#
# BUILD: where the ordinary build lies, whole. PATTERN: only configurations whose names contain one of them. The other
# builds and the logs of all runs go into BUILD/matrix. Exit codes: 0 the same everywhere, 1 not so, 2 usage.
set -uo pipefail
here=$(dirname "$(readlink -f "$0")")
root=$(cd "$here/../.." && pwd)
if [ $# -eq 0 ] || [ ! -x "$1/morula" ]; then
  sed -n '5,8s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
ordinary=$(cd "$1" && pwd) work=$ordinary/matrix
shift
jobs=$(nproc)
minutes=thesis/elegans-1024-physics # in one thread
half_a_minute=thesis/elegans-128
rm -rf "$work/cells" "$work/reversed" "$work/scenes"
mkdir -p "$work/cells"
mapfile -t scenes < <(cd "$root/scenarios" && find . -name '*.yaml' | sed 's|^\./||; s|\.yaml$||' | LC_ALL=C sort)

names=() builds=() sets=() commands=() why=() # of the rows; why: it cannot be run here
configuration() {
  local pattern
  for pattern in ${patterns[@]+"${patterns[@]}"} ''; do
    case $1 in *"$pattern"*) break ;; esac
  done
  if [ -z "$pattern" ] && [ ${#patterns[@]} -gt 0 ]; then return; fi
  names+=("$1") builds+=("$2") sets+=("$3") why+=("")
  shift 3
  commands+=("$(printf '%q ' "$@")")
}
patterns=("$@")
. "$here/configurations.sh"
if [ ${#names[@]} -eq 0 ]; then
  patterns=()
  . "$here/configurations.sh"
  printf 'no configuration is called like that; there are:\n' >&2
  printf '  %s\n' "${names[@]}" >&2
  exit 2
fi

is_left_out() { # ROW SCENE
  case ${sets[$1]}:$2 in
    all:*) return 1 ;;
    *:$minutes | short:$half_a_minute) return 0 ;;
  esac
  return 1
}

# Where a build's programs lie.
folder() { if [ "$1" = ordinary ]; then echo "$ordinary"; else echo "$work/$1"; fi; }

# Says why a row cannot be run here, if so. Builds what it needs.
prepare() { # ROW
  local command=${commands[$1]} build=${builds[$1]} target=morula said code=0
  case $command in
    *qemu-aarch64*) command -v qemu-aarch64 >/dev/null || { echo "qemu-aarch64 is not installed" && return; } ;;
    setarch*) setarch -R true 2>/dev/null || { echo "forbidden here" && return; } ;;
    *LOCPATH=*)
      mkdir -p "$work/locales"
      localedef -i de_DE -f UTF-8 "$work/locales/de_DE.UTF-8" 2>/dev/null || [ -e "$work/locales/de_DE.UTF-8" ] ||
        { echo "localedef does not know it" && return; }
      ;;
  esac
  for isa in avx2 avx512; do
    case "$command $build" in
      *"--isa $isa"* | *-$isa) grep -qx $isa <<<"$isas" || { echo "this processor, or this build, has no $isa" && return; } ;;
    esac
  done
  if [ "$build" = ordinary ]; then return; fi
  case $command in *run_scene*) target=run_scene ;; esac
  echo "building: ${names[$1]}" >&2
  said=$("$here/build_as.sh" "$build" "$work/$build" $target) || code=$?
  if [ $code = 0 ]; then return; fi
  if [ $code != 77 ]; then echo "$said" >&2 && said="the build failed: $work/$build.log"; fi
  echo "$said"
  return $code
}

# Leaves the word for a cell, and what was said, in $work/cells.
run() { # ROW SCENE
  local name=${2//\//-} word=same command
  eval "command=(${commands[$1]})"
  "$here/matrix_cell.sh" "$2" "$work/scenes/$name" "$(folder "${builds[$1]}")" "${command[@]}" >"$work/cells/$1-$name.log" 2>&1 ||
    word=OTHER
  echo $word >"$work/cells/$1-$name"
  echo "$word: ${names[$1]}: $2" >&2
}

isas=$("$ordinary/tests/determinism/hash_program" --isas)
for scene in "${scenes[@]}"; do
  mkdir -p "$work/scenes" "$work/reversed/scenarios/$(dirname "$scene")"
  "$ordinary/tests/determinism/write_scene" "$root/scenarios/$scene.yaml" >"$work/scenes/${scene//\//-}" || exit 1
  awk -f "$here/reverse_keys.awk" "$root/scenarios/$scene.yaml" >"$work/reversed/scenarios/$scene.yaml"
  if cmp -s "$root/scenarios/$scene.yaml" "$work/reversed/scenarios/$scene.yaml"; then
    echo "scenarios/$scene.yaml reads the same backward: reverse_keys.awk does nothing to it" >&2
    exit 1
  fi
done
(cd "$root/scenarios" && find . -name '*.dna' -exec cp --parents {} "$work/reversed/scenarios" \;)
ln -s "$root/golden" "$work/reversed/golden"

broken=0
for row in "${!names[@]}"; do
  code=0
  why[row]=$(prepare "$row") || code=$?
  case $code in 0 | 77) ;; *) broken=1 ;; esac
done
# The longest first, so that no core has to wait at the end.
for scene in $minutes $half_a_minute $(printf '%s\n' "${scenes[@]}" | grep -vxF -e $minutes -e $half_a_minute); do
  for row in "${!names[@]}"; do
    if [ -n "${why[row]}" ] || is_left_out "$row" "$scene"; then continue; fi
    while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do wait -n; done
    run "$row" "$scene" &
  done
done
wait

letters=abcdefghijklmnopqrstuvwxyz
same=0 other=0 absent=0
printf '\n'
for i in "${!scenes[@]}"; do printf '%s  %s\n' "${letters:i:1}" "${scenes[i]}"; done
printf '\n%-24s' ''
for i in "${!scenes[@]}"; do printf ' %-6s' "${letters:i:1}"; done
printf '\n'
for row in "${!names[@]}"; do
  printf '%-24s' "${names[row]}"
  note=${why[row]}
  for scene in "${scenes[@]}"; do
    cell=$work/cells/$row-${scene//\//-}
    word=$(cat "$cell" 2>/dev/null) || word=–
    case $word in
      same) same=$((same + 1)) ;;
      OTHER) other=$((other + 1)) ;;
      *) absent=$((absent + 1)) note=${note:-–: it takes too long here} ;;
    esac
    printf ' %s%*s' "$word" $((6 - ${#word})) ''
  done
  printf ' %s\n' "$note"
done
printf '\n%d the same, %d other, %d not run\n' $same $other $absent
if [ $other -gt 0 ]; then echo "what they said: $work/cells"; fi
[ $other = 0 ] && [ $broken = 0 ] && [ $same -gt 0 ]
