#!/usr/bin/env bash
# Fails, naming the lines, when C++ files are not laid out as .clang-format says.
# tools/check_format.sh --fix lays them out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mapfile -t files < <(find src tests matlab python -name '*.h' -o -name '*.cc' | sort)
if [[ ${1:-} == --fix ]]; then
  clang-format -i "${files[@]}"
else
  clang-format --dry-run -Werror "${files[@]}"
fi
