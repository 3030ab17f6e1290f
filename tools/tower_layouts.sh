#!/usr/bin/env bash
# Runs the tower experiment from many seeded starting layouts and counts successes:
#   tools/tower_layouts.sh [COUNT] [FIRST_SEED]
# Needs a built program (./run once). Failed runs are kept in out/tower_layouts/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
count=${1:-10}
first=${2:-1}
program=build/release/bin/smile
[[ -x $program ]] || { echo "run ./run once, it builds $program" >&2; exit 2; }
mkdir -p out/tower_layouts
rebuilt=0
for ((seed = first; seed < first + count; ++seed)); do
  out=$(mktemp -d out/tower_layouts/seed_"$seed".XXXX)
  if "$program" experiment tower --seed "$seed" --no-films --out "$out/run" >"$out/log.txt" 2>&1; then
    rebuilt=$((rebuilt + 1))
    echo "seed $seed: rebuilt, $(grep -o 'mean error [0-9.]* mm' "$out/log.txt")"
    rm -rf "$out"
  else
    echo "seed $seed: failed, see $out"
  fi
done
echo "$rebuilt of $count layouts rebuilt"
((rebuilt == count))
