#!/usr/bin/env bash
# Renders the pictures of docs/scenes.md again, with the program itself. Needs ./run once, or SMILE=path/to/smile.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${SMILE:-build/release/bin/smile}
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
pictures=docs/images/scenes
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$pictures"

picture() {  # SUBJECT NAME
  local robot=()
  [[ -d $1 ]] || robot=(--no-robot)  # a recording has its own, or none
  "$program" render "$1" --out "$pictures/$2.png" --camera close --size 640x400 "${robot[@]}"
}
for file in scenes/*.xml; do
  name=$(basename "$file" .xml)
  case $name in
    tower_robot | small_tower | desk | bolt_held | *_arm) continue ;;
    strings | scissors | scissors_robot | everything)  # strings sink before they are seen
      "$program" run "$file" --seconds 3 --no-robot --record "$scratch/$name-settled" >"$scratch/$name.txt"
      picture "$scratch/$name-settled" "$name"
      ;;
    *) picture "$file" "$name" ;;
  esac
done
# The desk, with the robot that works there.
"$program" render scenes/desk.xml --robot tern --out "$pictures/desk.png" --camera side --size 640x400
"$program" run scenes/desk.xml --robot tern --brain python/examples/desk/desk.py --record "$scratch/desk" --no-pictures >"$scratch/desk.txt"
"$program" render "$scratch/desk" --out "$pictures/desk_after.png" --camera side --size 640x400
# and when the script that belongs to a scene is done
for script in examples/{um,row,bridge,box,hatch,drive,scissors,cover,sizes,pyramid,bricks,pieces,pedestal,unstack,swap,beside,hanoi,ball,lid,plank}.jsonl examples/scenes/*.jsonl; do
  name=$(basename "$script" .jsonl)
  "$program" run "scenes/$name.xml" --commands "$script" --no-robot --record "$scratch/$name" >"$scratch/$name.txt"
  picture "$scratch/$name" "${name}_after"
done
