#!/usr/bin/env bash
# Draws the pictures of the README anew, from shipped scenarios, into reports/gallery: half a minute. The film needs ffmpeg.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
draw() { # NAME SCENARIO OPTION...
  ./morula render "scenarios/$2.yaml" "${@:3}" --quiet -o "reports/gallery/$1"
}
draw growing.gif thesis/elegans-128 --frames 60 --fps 12 --size 360
draw embryo.png worm/embryo --size 440x330
draw cut.png worm/embryo --view front --clip 0,-1,0,0 --colour pressure --scale-bar --size 440x330
draw names.png worm/embryo --view iso --colour clone --labels name --size 440x330
draw sorting.png patterns/sorting --size 440x330
draw volvox.png patterns/volvox --size 440x330
draw box.png organisms/box-shell --size 440x330
