#!/usr/bin/env bash
# tools/get_real_robots.sh
# Installs descriptions of real robots into build/real_robots, for the tests that try them: they are
# skipped without. The packages have their own licenses; nothing of them is part of SMILE. 144 MB.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/real_robots
install() {  # FOLDER PACKAGE
  [[ -d $target/$1 ]] || python3 -m pip install --quiet --no-deps --target "$target" "$2"
}
install cmeel.prefix example-robot-data==6.0.0
install airo_models airo-models==0.0.12
echo "$target/cmeel.prefix/share/example-robot-data/robots"
