#!/usr/bin/env bash
# run.sh NODE FILE...: the browser tests. A browser that draws in software on a busy machine may miss
# what a person would not: a file that fails is tried once more, and says so.
set -uo pipefail
node=$1
shift
failed=0
for file in "$@"; do
  "$node" --test "$file" && continue
  echo "# $file: once more"
  "$node" --test "$file" || failed=1
done
exit $failed
