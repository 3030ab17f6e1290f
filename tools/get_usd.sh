#!/usr/bin/env bash
# tools/get_usd.sh
# Installs OpenUSD (TOST-1.0, an open license made from Apache-2.0) into build/usd, for the test of exported scenes, which is skipped
# without. 205 MB.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/usd version=26.5
if [[ ! -d $target/usd_core-$version.dist-info ]]; then
  # It is compiled: for the Python that runs the tests.
  /usr/bin/python3 -m pip install --quiet --no-deps --upgrade --target "$target" "usd-core==$version"
fi
echo "$target"
