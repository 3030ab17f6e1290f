#!/usr/bin/env bash
# Renders the pictures of the documents again, with the program itself. Needs ./run once.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=build/release/bin/smile
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p docs/images
"$program" experiment um --out "$scratch/um" --no-films
"$program" render "$scratch/um/imitation" --out docs/images/um.png --size 960x540
