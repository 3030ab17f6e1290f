#!/usr/bin/env bash
# tools/get_real_robots.sh
# Installs descriptions of real robots into build/real_robots, for the tests that try them: they are
# skipped without. The package has its own licenses; nothing of it is part of SMILE. 131 MB.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/real_robots
package=example-robot-data==6.0.0
if [[ ! -d $target/cmeel.prefix ]]; then
  python3 -m pip install --quiet --no-deps --target "$target" "$package"
fi
echo "$target/cmeel.prefix/share/example-robot-data/robots"
