#!/usr/bin/env bash
# tools/get_ros.sh
# Installs Debian's packages of ROS 1 (packages.txt, [ros]), for `smile ros` and its tests, which are skipped
# without. 3 MB.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_packages ros
