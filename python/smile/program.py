"""The program `smile` that belongs to this package."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from smile.native import load


def path() -> Path:
    """Returns the path of the program: in the installed package, or of the build of the modules."""
    packaged = Path(__file__).parent / "bin/smile"
    if packaged.exists():
        return packaged
    built = Path(load("smile_simulator_native").__file__).parent.parent / "bin/smile"
    if built.exists():
        return built
    raise RuntimeError(f"the program is neither {packaged} nor {built}, expected one of them")


def main() -> None:
    """Becomes the program, which runs brains in Python with this interpreter."""
    os.environ.setdefault("SMILE_PYTHON", sys.executable)
    program = os.fspath(path())
    os.execv(program, [program, *sys.argv[1:]])


if __name__ == "__main__":
    main()
