#!/usr/bin/env bash
# tools/make_stubs.sh [FOLDER]
# Writes the types of the compiled modules, as the installed package has them (tools/build_python_package.py),
# into python/smile, or into another folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=${1:-python/smile}
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
for module in smile_brain_native smile_motion_native smile_simulator_native; do
  build/venv/bin/python -B -m pybind11_stubgen --exit-code --output-dir "$made" "smile.$module"
done
mkdir -p "$folder"
cp "$made"/smile/*.pyi "$folder"
