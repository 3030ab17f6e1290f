#!/usr/bin/env bash
# tools/get_blender.sh
# Installs Blender's Python package (GPL-3.0) into build/blender, for the picture that tools/make_simulator_pictures.sh draws
# of USD; nothing else needs it. 360 MB to download.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/blender version=4.5.15  # with long-term support, for Debian's Python 3.11
if [[ ! -d $target/bpy-$version.dist-info ]]; then
  # It is compiled: for the Python that draws.
  /usr/bin/python3 -m pip install --quiet --no-deps --upgrade --target "$target" "bpy==$version"
fi
echo "$target"
