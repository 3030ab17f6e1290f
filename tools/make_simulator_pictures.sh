#!/usr/bin/env bash
# Draws the pictures of docs/other-simulators.md again: the tower that the shipped demonstration builds, from one camera, in SMILE and
# in other programs, all without a screen. Needs ./run once, or SMILE=path/to/smile, and
#   mjcf  tools/get_mujoco.sh; Debian's python3-opengl and python3-pil
#   gltf  Chromium and web/node_modules
#   urdf  tools/get_ros.sh; Debian's rviz, xvfb and python3-pil
#   sdf   tools/get_drake.sh; Debian's python3-numpy and python3-pil
#   usd   tools/get_blender.sh; Debian's python3-numpy
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${SMILE:-build/release/bin/smile}
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
pictures=docs/images/simulators
scripts=tools/simulator_pictures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$pictures"

"$program" run scenes/tower.xml --commands examples/tower.jsonl --json >"$scratch/end.json"
/usr/bin/python3 $scripts/scene_at_end.py scenes/tower.xml "$scratch/end.json" "$scratch/tower.xml"
"$program" render "$scratch/tower.xml" --no-robot --camera visitor --size 640x400 --out "$pictures/smile.png"
export_tower() {  # FORMAT FILE
  "$program" export "$scratch/tower.xml" --no-robot --to "$1" --out "$scratch/$2"
}
export_tower mjcf tower.mjcf.xml
MUJOCO_GL=egl PYTHONPATH=build/mujoco /usr/bin/python3 -B $scripts/draw_mujoco.py "$scratch/tower.mjcf.xml" "$pictures/mujoco.png"
export_tower gltf tower.glb
node web/test/draw_gltf.mjs "$scratch/tower.glb" "$pictures/three.png"
export_tower urdf tower.urdf
PYTHONPATH=python/test /usr/bin/python3 -B $scripts/draw_rviz.py "$scratch/tower.urdf" "$scratch/tower.xml" "$pictures/rviz.png"
export_tower sdf tower.sdf
PYTHONPATH=build/drake /usr/bin/python3 -B $scripts/draw_drake.py "$scratch/tower.sdf" "$pictures/drake.png"
export_tower usd tower.usda
PYTHONPATH=build/blender /usr/bin/python3 -B $scripts/draw_blender.py "$scratch/tower.usda" "$pictures/blender.png" >"$scratch/blender.txt"
