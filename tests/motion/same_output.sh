#!/usr/bin/env bash
# same_output.sh PROGRAM ARGUMENT -- COMMAND...: both must print the same, which must not be little.
set -euo pipefail
program=$1 argument=$2
shift 3
expected=$(mktemp) found=$(mktemp)
trap 'rm -f "$expected" "$found"' EXIT
"$program" "$argument" >"$expected"
"$@" >"$found"
(($(wc -l <"$expected") > 1000)) || { echo "too little was asked"; exit 1; }
diff "$expected" "$found" | head -20
cmp "$expected" "$found"
