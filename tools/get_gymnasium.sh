#!/usr/bin/env bash
# tools/get_gymnasium.sh
# Installs Gymnasium into build/gymnasium, for the test of smile.gym, which is skipped without. 5 MB.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/gymnasium
packages=(gymnasium==1.4.0 cloudpickle==3.1.3 Farama-Notifications==0.0.6 typing_extensions==4.16.0)
if [[ ! -d $target/gymnasium-1.4.0.dist-info ]]; then
  # None of them is compiled: they serve any Python.
  python3 -m pip install --quiet --no-deps --upgrade --target "$target" "${packages[@]}"
fi
echo "$target"
