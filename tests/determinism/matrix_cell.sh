#!/usr/bin/env bash
# One cell of the matrix: runs a shipped scene as a configuration asks, and compares it with its golden.
#
#   matrix_cell.sh SCENE TEXT FOLDER COMMAND...
#
# SCENE: such as thesis/unique-four; TEXT: the scene's file of write_scene; COMMAND: from configurations.sh; FOLDER: the
# folder of its programs. Exit codes: 0 equal, 1 different, or the run failed.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
scene=$1 text=$2 folder=$3
shift 3
command=()
alone= # set if the simulator runs without the program
for word; do
  case $word in
    morula) command+=("$folder/morula" check "scenarios/$scene.yaml" --json) ;;
    run_scene) command+=("$folder/run_scene") alone=yes ;;
    *) command+=("$word") ;;
  esac
done
if [ $alone ]; then exec "$here/compare_golden.sh" "$folder" "$scene" "$text" "${command[@]}"; fi

cd "$here/../.."
report=$("${command[@]}") || {
  echo "exit code $?"
  exit 1
}
# Numbers may have tolerances. Bits have none, and must have been compared.
expected=$(sed -n 's/^bits solver //p' "golden/$scene.golden")
actual=$(sed -n '/"check": "bits"/,/}/s/.*"actual": "\(.*\)".*/\1/p' <<<"$report")
if [ -z "$expected" ] || [ "$actual" != "$expected" ]; then
  echo "the bits are '$actual', the golden's '$expected'"
  exit 1
fi
