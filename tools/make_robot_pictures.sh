#!/usr/bin/env bash
# Renders the pictures of the robot in docs/robot.md again, with the program itself and ffmpeg. Needs ./run once.
#   tools/make_robot_pictures.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${1:-build/release/bin/smile}
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Hardly a table, so that the robot is seen whole; arms as the vendor's neutral pose has them.
cat > "$scratch/robot.xml" <<END
<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml" xspan="0.01" yspan="0.01"/>
END
record() {  # MOOD
  cat > "$scratch/$1.jsonl" <<END
{"do": "joint_angles", "left": [0, -0.55, 0, 0.75, 0, 1.26, 0], "right": [0, -0.55, 0, 0.75, 0, 1.26, 0]}
{"do": "face", "mood": "$1"}
{"do": "wait", "seconds": 0.05}
END
  "$program" run "$scratch/robot.xml" --commands "$scratch/$1.jsonl" --record "$scratch/$1" --no-pictures --no-symbols
}
take() {  # MOOD NAME CAMERA SIZE
  "$program" render "$scratch/$1" --camera "$3" --size "$4" --out "$scratch/$2.png"
}
join() {  # OUT NAME...
  local out=$1 inputs=()
  shift
  for name in "$@"; do inputs+=(-i "$scratch/$name.png"); done
  ffmpeg -loglevel error -y "${inputs[@]}" -filter_complex "hstack=$#" -compression_level 100 "$out"
}

moods=(idle watching working puzzled done)
for mood in "${moods[@]}"; do
  record "$mood"
  take "$mood" "face_$mood" "0,14,9.5:0,-0.5,8.6:15" 240x180
done
take watching front "0,40,4:0,-2.05,1.8:31" 360x360
take watching side "40,-1,4:0,-1,1.8:31" 360x360
take watching top "0,0,42:0,-0.01,0:31" 360x360
take watching angle "20,28,16:-1.5,-1.5,1.8:33" 360x360
mkdir -p docs/images
join docs/images/baxter.png front side top angle
join docs/images/baxter_faces.png "${moods[@]/#/face_}"
