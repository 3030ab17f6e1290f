#!/usr/bin/env bash
# tools/get_python_packages.sh
# Makes the environment build/venv, of Debian's Python and what tests/package/requirements.txt lists of the
# Python package index. Nothing of it is part of SMILE.
set -euo pipefail
cd "$(dirname "$0")/.."

venv=build/venv
if [[ ! $venv/.installed -nt tests/package/requirements.txt ]]; then
  /usr/bin/python3 -m venv --clear "$venv"
  "$venv/bin/python" -m pip install --quiet --disable-pip-version-check -r tests/package/requirements.txt
  touch "$venv/.installed"
fi
