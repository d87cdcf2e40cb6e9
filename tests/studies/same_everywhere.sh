#!/usr/bin/env bash
# Checks that every way to run a study gives the same merged database, byte for byte after VACUUM INTO, except the table
# `timing`.
#
#   same_everywhere.sh MORULA WAY
#     WAY   jobs: one job and two; shards: five on different "machines", merged twice in shuffled order; killed: kill -9
#           at twenty random moments; snakemake, parallel, slurm: by the files of `morula study emit`
#
# Exit codes: 0 equal, 1 different, 2 usage, 77 a program is not installed.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
if [ $# -ne 2 ]; then
  sed -n '2,9s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
MORULA=$(readlink -f "$1")
way=$2
export MORULA
dir=$(mktemp -d)
# shellcheck source=tests/studies/slurm.sh
. "$here/slurm.sh"
finish() {
  stop_slurm
  rm -rf "$dir"
}
trap finish EXIT
cp "$here"/small.yaml "$here"/small.study.yaml "$dir"
cd "$dir"

skip() {
  echo "skipped: $*"
  exit 77
}
fail() {
  echo "$*"
  exit 1
}
needs() {
  local tool
  for tool; do if ! command -v "$tool" >/dev/null; then skip "$tool is not installed"; fi; done
}
needs sqlite3

study() { "$MORULA" study "$@" --quiet; }

# Prints the database without times and machines, after VACUUM INTO.
plain() { # FROM TO
  cp "$1" "$2.copy"
  rm -f "$2"
  sqlite3 "$2.copy" "DELETE FROM timing; VACUUM INTO '$2'"
  rm "$2.copy"
}
same() { # FOLDER
  plain "$1/study.db" "$1.db"
  cmp whole.db "$1.db" || fail "$1: another database than with one job"
  if find "$1" -name '.morula-*' | grep .; then fail "$1: a draft was left behind"; fi
  echo "$1: the same"
}
lint() { # FILE [SHELL]
  if command -v shellcheck >/dev/null; then shellcheck "$@"; else echo "shellcheck is not installed: $1 is not looked at"; fi
  if grep -n "$dir\|$MORULA" "$1"; then fail "$1 names a place of this machine"; fi
}

study run small.study.yaml --out whole >whole.txt
plain whole/study.db whole.db
[ "$(sqlite3 whole/study.db "SELECT count(*) FROM task WHERE status = 'done'")" = 48 ] || fail "not all is done: $(cat whole.txt)"
[ "$(sqlite3 whole/study.db 'PRAGMA integrity_check')" = ok ] || fail "the merged database is damaged"
[ -z "$(sqlite3 whole/study.db 'PRAGMA foreign_key_check')" ] || fail "rows of the merged database hang in the air"

case $way in
  jobs)
    study run small.study.yaml --out two --jobs 2 >/dev/null
    same two
    study merge whole >/dev/null # a second merge changes nothing
    same whole
    ;;
  shards)
    for i in 1 2 3 4 5; do study run small.study.yaml --out "machine$i" --shard $i/5 >/dev/null; done
    if study merge machine1 machine2 machine4 >some.txt; then fail "runs are missing, and merge says nothing"; fi
    grep -q 'missing' some.txt || fail "merge does not say what is missing"
    study merge machine1 machine4 machine2 machine5 machine3 >/dev/null
    same machine1
    study merge machine3 machine5/tasks machine1/tasks/*.db machine4 machine2 machine4 >/dev/null
    same machine3
    ;;
  killed)
    RANDOM=8 killed=0 starts=0
    while [ $killed -lt 20 ]; do
      starts=$((starts + 1))
      [ $starts -lt 200 ] || fail "$killed kills hit in $starts starts"
      "$MORULA" study run small.study.yaml --out killed --jobs 2 --quiet >/dev/null &
      process=$!
      sleep "0.$(printf %03d $((RANDOM % 400 + 40)))"
      kill -9 $process 2>/dev/null || :
      if wait $process 2>/dev/null; then # it ended before the kill: some of its results are removed
        find killed/tasks -name '*[0-7].db' -delete
      else
        killed=$((killed + 1))
      fi
    done
    for file in killed/tasks/*.db; do
      [ -e "$file" ] || continue # on a busy machine no run has ended
      [ "$(sqlite3 "$file" 'PRAGMA integrity_check')" = ok ] || fail "$file is damaged"
    done
    study run small.study.yaml --out killed >/dev/null
    same killed
    echo "$killed kills in $starts starts"
    ;;
  snakemake)
    needs snakemake
    mkdir snakes
    study emit snakemake small.study.yaml --out snakes >/dev/null
    if grep -n "$dir\|$MORULA" snakes/Snakefile; then fail "the Snakefile names a place of this machine"; fi
    XDG_CACHE_HOME=$dir/cache snakemake --snakefile snakes/Snakefile --cores 2 --quiet all --nolock >snakes.txt 2>&1 ||
      fail "$(tail -n 30 snakes.txt)"
    same snakes
    ;;
  parallel)
    needs parallel
    study emit parallel small.study.yaml --out beside --jobs 6 >/dev/null
    lint beside/parallel.sh
    HOME=$dir sh beside/parallel.sh --jobs 2 >parallel.txt 2>&1 || fail "$(tail -n 30 parallel.txt)"
    [ "$(wc -l <beside/parallel.log)" = 7 ] || fail "the job log has not 6 jobs: $(cat beside/parallel.log)"
    same beside
    ;;
  slurm)
    study emit slurm small.study.yaml --out cluster --jobs 4 >/dev/null
    lint cluster/study.sbatch
    if start_slurm "$dir/slurm"; then
      sbatch --parsable cluster/study.sbatch >job
      for ((i = 0; i < 600; ++i)); do
        if [ -z "$(squeue --noheader)" ]; then break; fi
        sleep 0.1
      done
      echo "under Slurm $(sinfo --version | cut -d ' ' -f 2), job $(cat job)"
    else
      echo "under a stand-in for sbatch"
      "$here/stand_in_sbatch.sh" cluster/study.sbatch
    fi
    study status cluster >status.txt || fail "$(cat status.txt cluster/*.log)"
    study merge cluster >/dev/null
    same cluster
    ;;
  *)
    echo "$way: no such way" >&2
    exit 2
    ;;
esac
