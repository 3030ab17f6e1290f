#!/usr/bin/env bash
# tools/get_notebook_tools.sh
# Installs what runs notebooks, draws in them, and makes the Python reference (tests/notebooks/requirements.txt)
# into build/notebooks, for tests that are skipped without. 34 MB to download.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/notebooks list=tests/notebooks/requirements.txt
if [[ ! $target/.installed -nt $list ]]; then
  rm -rf "$target"
  # Wheels for Debian's own Python; nothing is compiled.
  /usr/bin/python3 -m pip install --quiet --disable-pip-version-check --no-deps --only-binary :all: \
    --target "$target" -r "$list"
  touch "$target/.installed"
fi
echo "$target"
