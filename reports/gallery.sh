#!/usr/bin/env bash
# Redraws the pictures of the READMEs from shipped scenarios into reports/gallery, in half a minute. The film needs
# ffmpeg.
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
# Draws the worm's fifteen cells: the real ones, and the results of rules of division (scenarios/worm/README.md).
seen=(--view top --labels name --size 400x300)
draw fifteen-real.png worm/real-fifteen "${seen[@]}"
draw fifteen-measured.png worm/embryo --time 16.7 "${seen[@]}"
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
shares="[{of: P0, share: 0.592}, {of: AB, share: 0.5035}, {of: P1, share: 0.574}, {of: ABa, share: 0.481},
  {of: ABp, share: 0.525}, {of: EMS, share: 0.531}, {of: P2, share: 0.672}, {of: ABal, share: 0.459},
  {of: ABar, share: 0.475}, {of: ABpl, share: 0.578}, {of: ABpr, share: 0.534}, {of: MS, share: 0.496},
  {of: E, share: 0.52}, {of: C, share: 0.463}]"
for plane in longest random; do
  ./morula run scenarios/worm/embryo.yaml --set stop.time=16.7 --set division.plane=$plane \
    --set "division.rules=$shares" --no-check --no-pictures --quiet --db "$scratch/$plane.db"
  ./morula render "$scratch/$plane.db" "${seen[@]}" --quiet -o "reports/gallery/fifteen-$plane.png"
done
