#!/usr/bin/env bash
# tools/get_training_packages.sh
# Makes the environment build/training, of Debian's Python, JAX for the CPU, Optax and Gymnasium, with which
# examples/push learns. Nothing of it is part of SMILE, nor of ./test, which tries the example where it is
# there. 150 MB to download, 600 MB there.
set -euo pipefail
cd "$(dirname "$0")/.."

venv=build/training
packages=(jax==0.7.2 jaxlib==0.7.2 optax==0.2.8 gymnasium==1.4.0 numpy==2.4.6)
if [[ $(cat "$venv/packages.txt" 2>/dev/null) != "${packages[*]}" ]]; then
  /usr/bin/python3 -m venv --clear "$venv"
  "$venv/bin/python" -m pip install --quiet --disable-pip-version-check "${packages[@]}"
  echo "${packages[*]}" >"$venv/packages.txt"
fi
echo "$venv"
