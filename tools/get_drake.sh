#!/usr/bin/env bash
# tools/get_drake.sh
# Installs Drake (BSD-3-Clause) into build/drake, for the picture that tools/make_simulator_pictures.sh draws of SDFormat; nothing else
# needs it. 42 MB to download.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/drake version=1.51.1  # the last one for Debian's Python 3.11
if [[ ! -d $target/drake-$version.dist-info ]]; then
  # It is compiled: for the Python that draws. Of what it depends on, only numpy is needed for pictures.
  /usr/bin/python3 -m pip install --quiet --no-deps --upgrade --target "$target" "drake==$version"
fi
echo "$target"
