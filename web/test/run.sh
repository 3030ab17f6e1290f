#!/usr/bin/env bash
# run.sh NODE FILE: a file of browser tests. A browser that draws in software on a busy machine may miss
# what a person would not: a file that fails is tried once more, and says so.
set -uo pipefail
"$1" --test "$2" && exit
echo "# $2: once more"
exec "$1" --test "$2"
