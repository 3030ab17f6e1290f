#!/usr/bin/env bash
# tools/make_golden_recordings.sh [PROGRAM]
# Makes the recordings of tests/golden/recordings that do not exist yet: one per example script and per mechanism,
# without pictures. Existing ones stay as they are: a recording made once must open and replay to the same bits for
# ever, and tests/integration/golden_test.cc says so. A new mechanism gets a script in tests/golden/scripts and a line
# below. PROGRAM is build/release/bin/smile unless given.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=$(realpath "${1:-build/release/bin/smile}")
[[ -x $program ]] || { echo "run ./run once; it builds $program" >&2; exit 2; }
golden=$PWD/tests/golden/recordings scripts=$PWD/tests/golden/scripts
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# golden NAME COMMAND...: runs COMMAND, which makes the recording $scratch/NAME or $scratch/out/NAME, and keeps it.
golden() {
  local name=$1 made
  shift
  if [[ -e $golden/$name ]]; then return; fi
  "$program" "$@" >"$scratch/out.txt" || { cat "$scratch/out.txt"; exit 1; }
  mkdir -p "$golden"
  made=$scratch/$name
  if [[ ! -e $made ]]; then made=$scratch/out/$name; fi
  cp -r "$made" "$golden/$name"
  find "$golden/$name" -name '*.png' -delete
  find "$golden/$name" -type d -empty -delete
  echo "made $name"
}

# record NAME SCENE SCRIPT [OPTION...]
record() {
  local name=$1 scene=$2 script=$3
  shift 3
  golden "$name" run "scenes/$scene.xml" --commands "$script" --record "$scratch/$name" --no-pictures "$@"
}

# The examples. To stay small, only those that need a robot have one, and only some have the symbols of the classic view.
for script in examples/*.jsonl examples/scenes/*.jsonl; do
  name=$(basename "$script" .jsonl)
  case $name in
    robot_poses) record "$name" tower "$script" ;;
    tower) record "$name" "$name" "$script" ;;
    um | controls | screws) record "$name" "$name" "$script" --no-robot ;;
    strings | scissors) ;;  # long: shorter ones are below
    bricks | pieces | pedestal | pyramid | sizes | unstack | swap | beside | hanoi | ball | lid | plank) ;;  # as in row and bridge
    dock | row) record "$name" "$name" "$script" --no-robot --no-symbols --seconds 10 ;;
    *) record "$name" "$name" "$script" --no-robot --no-symbols ;;
  esac
done

# The mechanisms that no example shows.
record hands tower "$scripts/hands.jsonl" --no-robot
record strings strings "$scripts/strings.jsonl" --no-robot --no-symbols
record scissors scissors "$scripts/scissors.jsonl" --no-robot --no-symbols
record shapes everything "$scripts/shapes.jsonl" --no-robot --no-symbols
record robot tower "$scripts/robot.jsonl"
record kinematic tower "$scripts/robot.jsonl" --kinematic
record friction_grasp tower "$scripts/robot.jsonl" --friction-grasp
record classic tower "$scripts/robot.jsonl" --classic
record electric tower "$scripts/electric.jsonl" --gripper electric
record tern tower "$scripts/tern.jsonl" --robot tern
record presses controls "$scripts/presses.jsonl" --no-robot --no-symbols

# Firm contacts (physics version 5): what falls, rests, slides and rolls; a gripper; a hand that carries a lid.
record firm_shapes everything "$scripts/shapes.jsonl" --no-robot --no-symbols
record firm_robot tower "$scripts/robot.jsonl"
record firm_lidbox lidbox examples/scenes/lidbox.jsonl --no-robot --no-symbols
record firm_presses controls "$scripts/presses.jsonl" --no-robot --no-symbols
record firm_scissors scissors "$scripts/firm_scissors.jsonl" --no-robot --no-symbols

# Loads (physics version 6): a tower that is taken apart, block by block.
record loads_unstack unstack examples/unstack.jsonl --no-robot --no-symbols --seconds 10

# Robots at work: a gripper presses a switch, and closes on a tool that cuts; other grippers and numbers of arms.
record robot_press tower "$scripts/robot_press.jsonl" --robot tern
record robot_cut tower "$scripts/robot_cut.jsonl" --robot tern
record three_arms tower "$scripts/three_arms.jsonl" --robot tests/robots/three_arms.urdf
if [[ ! -e $golden/jaws ]]; then
  # Its side file is made here, in a folder of its own.
  XDG_DATA_HOME=$scratch/data "$program" robots add five tests/robots/five.urdf >"$scratch/out.txt"
  XDG_DATA_HOME=$scratch/data record jaws tower "$scripts/jaws.jsonl" --robot five
fi

# Recordings made of others: begun, undone and redone in the middle; continued from an earlier step; edited; corrected;
# imported.
golden branches run scenes/tower.xml --commands "$scripts/branches.jsonl" --recordings "$scratch" --no-pictures --no-robot
golden spawn run scenes/tower.xml --commands "$scripts/spawn.jsonl" --recordings "$scratch" --no-pictures --no-robot
golden displace run scenes/tower.xml --commands "$scripts/displace.jsonl" --recordings "$scratch" --no-pictures --no-robot
golden neighbors run scenes/tower.xml --commands "$scripts/neighbors.jsonl" --recordings "$scratch" --no-pictures --no-robot
if [[ ! -e $golden/continued ]]; then
  cp -r "$golden/branches" "$scratch/continued"
  golden continued checkout "$scratch/continued" --at 1 --commands "$scripts/continued.jsonl"
fi
golden edited edit "$golden/box" --drop 3-4 --max-pause 0.5 --speed 1.5 --no-pictures --out "$scratch/edited"
golden corrected correct "$golden/tern" --at 0.6 --commands "$scripts/corrected.jsonl" --out "$scratch/corrected"
if [[ ! -e $golden/imported ]]; then
  # As the 2015 program left it: only the numbered texts and folders.
  mkdir "$scratch/classic_view"
  cp "$golden"/tower/*.txt "$scratch/classic_view"
  for text in "$scratch"/classic_view/*.txt; do mkdir "${text%.txt}"; done
  golden imported import "$scratch/classic_view" --scene scenes/tower.xml --out "$scratch/imported"
fi
# A robot that imitates: it grasps, carries and releases. Its commands are in the log, so it replays without its program.
# The first part of it is enough: it ends before the tower stands, and `imitate` says so.
if [[ ! -e $golden/imitation ]]; then
  "$program" experiment tower --brain python/learner/learner.py --no-films --out "$scratch/whole"
  "$program" imitate "$scratch/whole/demonstration" scenes/tower_robot.xml --brain python/learner/learner.py --seconds 11 \
             --no-pictures --out "$scratch/out" || true
  golden imitation check scenes/tower_robot.xml
fi

# The hash at the end of each example, as `smile run` prints it.
for script in examples/*.jsonl examples/scenes/*.jsonl; do
  name=$(basename "$script" .jsonl)
  grep -qs "^$name " "$golden/hashes.txt" && continue
  scene=$name options=(--no-robot)
  case $name in
    robot_poses) scene=tower options=() ;;
    tower) options=() ;;
  esac
  "$program" run "scenes/$scene.xml" --commands "$script" --json "${options[@]}" |
    sed -nE "s/^  \"hash\": \"([0-9a-f]+)\",/$name \1/p" >>"$golden/hashes.txt"
done
du -sh "$golden"
