#!/usr/bin/env bash
# Lets random hands work, undo and redo, and checks that every undo is exact and every replay identical:
#   tools/random_sessions.sh [COUNT] [SECONDS_EACH]
# Needs built tests (./test once).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=build/dev/bin/smile_recorder_test
[[ -x $program ]] || { echo "run ./test once, it builds $program" >&2; exit 2; }
SMILE_SESSIONS=${1:-30} SMILE_SESSION_SECONDS=${2:-60} "$program" --gtest_filter='UndoTest.RandomSessions*'
