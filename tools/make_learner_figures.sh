#!/usr/bin/env bash
# Draws the figures of docs/learner.md again, with the learner itself. Needs ./run once.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=$PWD/build/release/bin/smile
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
PYTHONPATH=$PWD/python:$PWD/build/release/python /usr/bin/python3 -B tools/learner_figures/make.py "$program" docs/images/learner
