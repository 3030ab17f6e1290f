#!/usr/bin/env bash
# clang-tidy over our own sources, as .clang-tidy says. Looks at each room as one file, the way the
# sanitizer build compiles it, so that the libraries' headers are read once per room and not per file.
# The rooms with the most files come first, so that no long one is left over when all else is done.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/asan}
[[ -f $build/build.ninja ]] || cmake --preset asan -B "$build"
find "$build/src" -path '*Unity/unity_*_cxx.cxx' -not -path '*_test.dir/*' -printf '%s %p\n' |
  sort -k1,1nr -k2 | cut -d' ' -f2- | xargs -P "$(nproc)" -n 1 clang-tidy --quiet --config-file=.clang-tidy -p "$build" --header-filter='/src/[a-z_]+/[^/]+$' \
    --extra-arg=-Wno-unknown-warning-option
