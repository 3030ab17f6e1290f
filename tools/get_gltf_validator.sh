#!/usr/bin/env bash
# tools/get_gltf_validator.sh
# Installs Khronos' validator of glTF (Apache-2.0) into build/gltf_validator, for the test of exported demonstrations, which is
# skipped without. 0.4 MB.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/gltf_validator version=2.0.0-dev.3.10
mkdir -p "$target"
if ! grep -qs "\"version\": \"$version\"" "$target/node_modules/gltf-validator/package.json"; then
  npm install --no-audit --no-fund --silent --prefix "$target" "gltf-validator@$version"
fi
echo "$target"
