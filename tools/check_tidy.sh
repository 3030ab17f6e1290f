#!/usr/bin/env bash
# clang-tidy over our own sources, as .clang-tidy says. Looks at each room as one file, the way the
# sanitizer build compiles it, so that the libraries' headers are read once per room and not per file;
# and at files with options of their own, apart from a library's.
# The rooms with the most files come first, so that no long one is left over when all else is done.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/asan}
cmake --preset asan -B "$build"  # the rooms may have changed since
mapfile -t files < <(
  grep -oP '"file": "\K[^"]*/src/(CMakeFiles/[^"]*/Unity/unity_[^"]*_cxx.cxx|[a-z_]*/[^"/]*[.]cc)' "$build/compile_commands.json" |
  grep -v -e '_test[.]dir/' -e 'asio_sources' | xargs stat -c '%s %n' | sort -k1,1nr -k2 | cut -d' ' -f2-)
for i in "${!files[@]}"; do printf '%s\n' "$((i + 1))/${#files[@]}" "${files[i]}"; done |
  xargs -P "$(nproc)" -n 2 bash -c 'clang-tidy --quiet --config-file=.clang-tidy -p "$0" --header-filter="/src/[a-z_]+/[^/]+$" \
    --extra-arg=-Wno-unknown-warning-option "$2" && echo "[$1] $2"' "$build"
