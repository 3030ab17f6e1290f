#!/usr/bin/env bash
# Makes the pictures of docs/scenes.md anew, with the program itself. Needs ./run once, or SMILE=path/to/smile.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${SMILE:-build/release/bin/smile}
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
pictures=docs/images/scenes
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$pictures"

# picture SUBJECT NAME CAMERA: eye sees what faces the demonstrator, nice sees it from behind, top from above
picture() {
  "$program" render "$1" --out "$pictures/$2.png" --camera "$3" --size 640x400 --no-robot
}
# scene CAMERA NAME…: as the file has them
scene() {
  for name in "${@:2}"; do picture "scenes/$name.xml" "$name" "$1"; done
}
# settled CAMERA NAME…: three seconds later
settled() {
  for name in "${@:2}"; do
    "$program" run "scenes/$name.xml" --seconds 3 --no-robot --record "$scratch/$name-settled" \
      >"$scratch/$name.txt"
    picture "$scratch/$name-settled" "$name" "$1"
  done
}
# after CAMERA NAME…: when the script that belongs to it is done
after() {
  for name in "${@:2}"; do
    "$program" run "scenes/$name.xml" --commands "examples/scenes/$name.jsonl" --no-robot \
      --record "$scratch/$name" >"$scratch/$name.txt"
    picture "$scratch/$name" "${name}_after" "$1"
  done
}

scene nice shapes rings mallet stacks walls meshes
scene eye tower letters um um_robot workbench containers lidbox controls dial screws valve dock panel
settled eye strings everything
scene nice trapdoor
after nice trapdoor
after eye lidbox strings controls dial screws valve dock panel
