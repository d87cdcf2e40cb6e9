#!/usr/bin/env bash
# Compares every shipped scene's results with its golden in all configurations that must not matter.
# ./morula test --matrix calls this.
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
ordinary=$(cd "$1" && pwd)
shift
patterns=("$@")
work=$ordinary/matrix
slowest=(large/four-thousand-cells thesis/elegans-1024-physics thesis/elegans-128) # 220 s, 90 s and 20 s in one thread

names=() builds=() sets=() commands=() # one entry per row
is_wanted() {
  local pattern
  if [ ${#patterns[@]} = 0 ]; then return 0; fi
  for pattern in "${patterns[@]}"; do
    case $1 in *"$pattern"*) return 0 ;; esac
  done
  return 1
}
configuration() {
  is_wanted "$1" || return 0
  names+=("$1") builds+=("$2") sets+=("$3")
  shift 3
  commands+=("$(printf '%q ' "$@")")
}
. "$here/configurations.sh"
if [ ${#names[@]} = 0 ]; then
  patterns=()
  . "$here/configurations.sh"
  printf 'no configuration is called like that; there are:\n' >&2
  printf '  %s\n' "${names[@]}" >&2
  exit 2
fi

is_left_out() { # ROW SCENE
  case ${sets[$1]}:$2 in
    all:*) return 1 ;;
    *:"${slowest[0]}" | *:"${slowest[1]}" | short:"${slowest[2]}") return 0 ;;
    quick:*) is_long "$2" ;;
    *) return 1 ;;
  esac
}

# Returns success for a scene whose steps and cells, by its golden, take an emulated processor more than ten minutes.
is_long() { # SCENE
  awk '$1 == "count" { n[$2] = $3 } END { exit !(n["steps"] * n["cells"] > 300000) }' "$root/golden/$1.golden"
}

# Prints the folder of a build's programs.
folder() {
  case $1 in
    ordinary) echo "$ordinary" ;;
    wasm-*) echo "$ordinary/wasm" ;; # shared with the modules for pages
    *) echo "$work/$1" ;;
  esac
}

# Prints the reason if a row cannot be run, after building what the row needs. Exit code 1 if the build failed, else 0.
prepare() { # ROW
  local command=${commands[$1]} build=${builds[$1]} target=morula isa said code=0
  case $command in
    qemu-aarch64*) command -v qemu-aarch64 >/dev/null || { echo "qemu-aarch64 is not installed" && return; } ;;
    node*) command -v node >/dev/null || { echo "node is not installed" && return; } ;;
    setarch*) setarch -R true 2>/dev/null || { echo "forbidden here" && return; } ;;
    *LOCPATH=*)
      mkdir -p "$work/locales"
      localedef -i de_DE -f UTF-8 "$work/locales/de_DE.UTF-8" 2>/dev/null || { echo "this locale is not installed" && return; }
      ;;
  esac
  for isa in avx2 avx512; do
    case "$build $command" in
      *-$isa' '* | *"--isa $isa "*) grep -qx $isa <<<"$isas" || { echo "this processor, or this build, has no $isa" && return; } ;;
    esac
  done
  if [ "$build" = ordinary ]; then return; fi
  case $command in *run_scene*) target=run_scene ;; esac
  echo "building: ${names[$1]}" >&2
  said=$("$here/build_as.sh" "$build" "$(folder "$build")" $target) || code=$?
  case $code in
    0) ;;
    77) echo "$said" ;;
    *)
      echo "$said" >&2
      echo "the build failed: $(folder "$build").log"
      return 1
      ;;
  esac
}

# Runs a cell of the matrix, and leaves its word and its log in $work/cells.
run() { # ROW SCENE
  local cell=$1-${2//\//-} word=same command
  eval "command=(${commands[$1]})"
  "$here/matrix_cell.sh" "$2" "$work/scenes/$2" "$(folder "${builds[$1]}")" "${command[@]}" >"$work/cells/$cell.log" 2>&1 ||
    word=OTHER
  echo $word >"$work/cells/$cell"
  echo "$word: ${names[$1]}: $2" >&2
  if [ $word = OTHER ]; then head -n 8 "$work/cells/$cell.log" | sed 's/^/  /' >&2; fi
}

rm -rf "$work/cells" "$work/scenes" "$work/reversed"
mkdir -p "$work/cells" "$work/scenes" "$work/reversed"
# A scenario that must stop (check.fails) has no golden, and no bits to compare.
has_golden() { while read -r scene; do if [ -e "$root/golden/$scene.golden" ]; then echo "$scene"; fi; done; }
mapfile -t scenes < <(cd "$root/scenarios" && find . -name '*.yaml' | sed 's|^\./||; s|\.yaml$||' | LC_ALL=C sort | has_golden)
cp -R "$root/scenarios" "$work/reversed/scenarios"
ln -s "$root/golden" "$work/reversed/golden"
for scene in "${scenes[@]}"; do
  mkdir -p "$work/scenes/$(dirname "$scene")"
  "$ordinary/tests/determinism/write_scene" "$root/scenarios/$scene.yaml" >"$work/scenes/$scene" || exit 1
  awk -f "$here/reverse_keys.awk" "$root/scenarios/$scene.yaml" >"$work/reversed/scenarios/$scene.yaml"
  if cmp -s "$root/scenarios/$scene.yaml" "$work/reversed/scenarios/$scene.yaml"; then
    echo "scenarios/$scene.yaml reads the same backward: reverse_keys.awk does nothing to it" >&2
    exit 1
  fi
done

isas=$("$ordinary/tests/determinism/hash_program" --isas) || exit 1
why=()
broken=0
for row in "${!names[@]}"; do why[row]=$(prepare "$row") || broken=1; done

# The slowest scenes begin first, so that no core waits for one at the end.
mapfile -t order < <(for scene in "${slowest[@]}" "${scenes[@]}"; do printf '%s\n' "${scenes[@]}" | grep -xF -e "$scene"; done | awk '!seen[$0]++')
for scene in "${order[@]}"; do
  for row in "${!names[@]}"; do
    if [ -n "${why[row]}" ] || is_left_out "$row" "$scene"; then continue; fi
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n; done
    run "$row" "$scene" &
  done
done
wait

same=0 other=0 absent=0
printf '\n'
for i in "${!scenes[@]}"; do printf '%2d  %s\n' $((i + 1)) "${scenes[i]}"; done
printf '\n%-24s' ''
for i in "${!scenes[@]}"; do printf ' %-5d' $((i + 1)); done
printf '\n'
for row in "${!names[@]}"; do
  printf '%-24s' "${names[row]}"
  note=${why[row]:+–: ${why[row]}}
  for scene in "${scenes[@]}"; do
    case $(cat "$work/cells/$row-${scene//\//-}" 2>/dev/null) in
      same) same=$((same + 1)) && printf ' same ' ;;
      OTHER) other=$((other + 1)) && printf ' OTHER' ;;
      *) absent=$((absent + 1)) && note=${note:-–: would take too long} && printf ' –    ' ;;
    esac
  done
  printf '  %s\n' "$note"
done
printf '\n%d the same, %d other, %d not run\n' $same $other $absent
if [ $other -gt 0 ]; then echo "what they said: $work/cells"; fi
[ $other = 0 ] && [ $broken = 0 ] && [ $same -gt 0 ]
