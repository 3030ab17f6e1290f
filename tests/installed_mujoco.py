"""MuJoCo for tests, as tools/get_mujoco.sh installs it; the test ends as skipped (77) where it is not.

To be imported by a test whose first argument is the project's folder, before anything that imports MuJoCo.
"""

import sys
from pathlib import Path

sys.path.append(str(Path(sys.argv[1]).resolve() / "build/mujoco"))
try:
    import mujoco
except ImportError:
    print("skipped: MuJoCo is not installed, see tools/get_mujoco.sh")
    sys.exit(77)

__all__ = ["mujoco"]
