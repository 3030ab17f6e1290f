#!/usr/bin/env bash
# Renders the pictures of two hands in docs/editing.md again, with the program itself. Needs ./run once, or SMILE=path/to/smile.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=$(realpath "${SMILE:-build/release/bin/smile}")
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

record() {  # NAME SCENE HAND
  "$program" run "scenes/$2.xml" --commands "examples/two_hands/$1_$3.jsonl" --no-robot --no-pictures \
    --record "$scratch/$1-$3" >"$scratch/out.txt"
}
picture() {  # NAME RIGHT_SCENE OVERLAY_AT MOMENT [CAMERA]: both hands of a person at work
  record "$1" "$1" left
  record "$1" "$2" right
  "$program" edit "$scratch/$1-left" --overlay "$scratch/$1-right" --overlay-at "$3" --no-pictures --out "$scratch/$1"
  "$program" render "$scratch/$1" --at "$4" --camera "${5:-close}" --size 640x400 --demonstrator forearm \
    --out "docs/images/scenes/${1}_two_hands.png"
}
picture tray tray 0 5
picture bunker bunker 1 5.5
picture bolt bolt_held 4 7.3 8,-13,7:0,-1.5,2.5:32
