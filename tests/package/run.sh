#!/usr/bin/env bash
# tests/package/run.sh TEST [ARGUMENT...]
# Runs a test with the installed Python package; skips it (77) where there is none.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
python=build/venv/bin/python
if [[ ! -x build/venv/bin/smile ]]; then
  echo "skipped: no Python package is installed in build/venv, see tools/build_python_package.py"
  exit 77
fi
unset PYTHONPATH VIRTUAL_ENV SMILE_PYTHON
exec "$PWD/$python" -B "$@"
