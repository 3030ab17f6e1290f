#!/usr/bin/env bash
# Draws the pictures of docs/other-simulators.md again: the tower that the shipped demonstration builds, from one camera, in SMILE and
# in other programs that draw without a screen. Needs ./run once, or SMILE=path/to/smile; tools/get_mujoco.sh, Debian's python3-opengl
# and python3-pil; Chromium and web/node_modules.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${SMILE:-build/release/bin/smile}
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
pictures=docs/images/simulators
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$pictures"

"$program" run scenes/tower.xml --commands examples/tower.jsonl --json >"$scratch/end.json"
/usr/bin/python3 tools/simulator_pictures/scene_at_end.py scenes/tower.xml "$scratch/end.json" "$scratch/tower.xml"
"$program" render "$scratch/tower.xml" --no-robot --camera visitor --size 640x400 --out "$pictures/smile.png"
"$program" export "$scratch/tower.xml" --no-robot --to mjcf --out "$scratch/tower.mjcf.xml"
MUJOCO_GL=egl PYTHONPATH=build/mujoco /usr/bin/python3 -B tools/simulator_pictures/draw_mujoco.py "$scratch/tower.mjcf.xml" "$pictures/mujoco.png"
"$program" export "$scratch/tower.xml" --no-robot --to gltf --out "$scratch/tower.glb"
node web/test/draw_gltf.mjs "$scratch/tower.glb" "$pictures/three.png"
