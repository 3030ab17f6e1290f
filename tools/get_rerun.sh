#!/usr/bin/env bash
# tools/get_rerun.sh
# Installs Rerun (MIT or Apache-2.0) into build/rerun, with its viewer, for the export `rrd` and its test, which is
# skipped without. 250 MB to download, 720 MB there.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/rerun
packages=(rerun-sdk==0.41.0 pyarrow==26.0.1 numpy==2.4.6 pillow==13.0.0 attrs==26.1.0 psutil==7.2.2 typing-extensions==4.15.0)
if [[ $(cat "$target/packages.txt" 2>/dev/null) != "${packages[*]}" ]]; then
  rm -rf "$target"
  /usr/bin/python3 -m pip install --quiet --no-deps --target "$target" "${packages[@]}"
  echo "${packages[*]}" >"$target/packages.txt"
fi
echo "$target"
