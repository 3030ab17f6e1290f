#!/usr/bin/env bash
# tools/get_training_packages.sh
# Makes the environment build/training, of Debian's Python, JAX for the CPU, Optax and Gymnasium, with which
# examples/push learns, and h5py and pyarrow for examples/policy. Nothing of it is part of SMILE, nor of ./test,
# which tries the examples where it is there. 200 MB to download, 800 MB there.
set -euo pipefail
cd "$(dirname "$0")/.."

venv=build/training
packages=(jax==0.7.2 jaxlib==0.7.2 optax==0.2.8 gymnasium==1.4.0 numpy==2.4.6 h5py==3.13.0 pyarrow==19.0.1)
if [[ $(cat "$venv/packages.txt" 2>/dev/null) != "${packages[*]}" ]]; then
  /usr/bin/python3 -m venv --clear "$venv"
  "$venv/bin/python" -m pip install --quiet --disable-pip-version-check "${packages[@]}"
  echo "${packages[*]}" >"$venv/packages.txt"
fi
echo "$venv"
