#!/usr/bin/env bash
# tools/get_ros.sh
# Installs Debian's packages of ROS 1 (packages.txt, [ros]), for `smile ros` and its tests, which are skipped
# without; and OpenCV, for `smile ros calibrate`, which is most of what is downloaded.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_packages ros
