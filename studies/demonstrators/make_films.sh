#!/usr/bin/env bash
# make_films.sh: makes the films of this study again, each demonstration with three demonstrators.
# Run it in the root of the project.
set -euo pipefail
study=studies/demonstrators
recordings=$(mktemp -d)
trap 'rm -r "$recordings"' EXIT
for task in tower box bridge; do
  scene=scenes/$task.xml commands=examples/$task.jsonl
  if [[ $task == bridge ]]; then scene=$study/bridge.xml commands=$study/bridge.jsonl; fi
  # The films show no robot, and the table as participants first see it.
  grep -v '"do":"robot"\|"do":"joint_angles"' "$commands" > "$recordings/$task.jsonl"
  ./run run "$scene" --commands "$recordings/$task.jsonl" --no-robot --no-pictures --record "$recordings/$task"
  for demonstrator in invisible ghost forearm; do
    ./run render "$recordings/$task" --out "$study/films/$task-$demonstrator.mp4" --demonstrator "$demonstrator" \
      --size 480x360 --rate 15 --camera 0,-12,14:0,0.9,0:50
  done
done
