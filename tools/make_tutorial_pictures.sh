#!/usr/bin/env bash
# Makes the pictures of docs/tutorials, by doing what the tutorials say. Needs ./run once, or
# SMILE=path/to/smile; the picture of the report needs chromium and Pillow.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
project=$PWD
export SMILE=${SMILE:-$project/build/release/bin/smile}
[[ -x $SMILE ]] || { echo "run ./run once, it builds $SMILE" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p docs/images/tutorials

for tutorial in first-demonstration robot-program evaluate-two-learners scene-with-a-mechanism; do
  folder=$scratch/$tutorial
  mkdir "$folder"
  for name in scenes matlab python; do ln -s "$project/$name" "$folder/"; done
  printf '#!/bin/sh\n[ "$1" = studio ] || exec "$SMILE" "$@"\n' >"$folder/run"
  chmod +x "$folder/run"
  # The same blocks as in tests/docs/documents_test.cc.
  python3 - "docs/tutorials/$tutorial.md" "$folder" <<'PYTHON'
import pathlib, re, subprocess, sys
document, folder = map(pathlib.Path, sys.argv[1:])
for language, purpose, text in re.findall(r"^```(\S*) ?(.*?)\n(.*?)^```$", document.read_text(), re.M | re.S):
    if "." in purpose:
        file = folder / purpose
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)
    elif language == "sh":
        subprocess.run(["bash", "-c", "set -e\n" + text], cwd=folder, check=purpose != "fails")
PYTHON
done

cp "$scratch/first-demonstration/first.png" "$scratch/robot-program/stacked.png" \
  "$scratch/scene-with-a-mechanism/cabinet.png" docs/images/tutorials/
chromium --headless --no-sandbox --hide-scrollbars --window-size=1120,895 \
  --log-level=3 --screenshot="$scratch/report.png" "file://$scratch/evaluate-two-learners/compared/report.html"
/usr/bin/python3 -c 'import sys; from PIL import Image
Image.open(sys.argv[1]).convert("RGB").quantize(128, Image.Quantize.MAXCOVERAGE).save(sys.argv[2], optimize=True)' \
  "$scratch/report.png" docs/images/tutorials/report.png
