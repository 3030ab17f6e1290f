#!/usr/bin/env bash
# tools/get_mujoco.sh
# Installs MuJoCo (Apache-2.0) into build/mujoco, for the tests of exported scenes, which are skipped without. 32 MB.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/mujoco
packages=(mujoco==4.0.0 mujoco_core==4.0.0)
if [[ ! -d $target/mujoco-4.0.0.dist-info ]]; then
  # It is compiled: for the Python that runs the tests. Of what it depends on, only numpy is needed without a viewer.
  /usr/bin/python3 -m pip install --quiet --no-deps --upgrade --target "$target" "${packages[@]}"
fi
echo "$target"
