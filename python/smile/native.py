"""Our compiled modules; and, where one does not load, what to do."""

import glob
import importlib
import os
import platform
import sys


def load(name):
    """Imports the compiled module `name`. An ImportError tells how to get it."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(how_to_get(name, error)) from error


def how_to_get(name, error):
    text = f"{sys.executable} (Python {platform.python_version()}) cannot load {name}: {error}\n"
    found = [file for folder in sys.path for file in glob.glob(os.path.join(folder, name + ".*.so"))]
    if not found:
        return text + ("It is built with SMILE where pybind11 is; build/release/python must be on "
                       "PYTHONPATH.")
    return text + (
        f"There is {', '.join(found)}, for another Python: name that one in SMILE_PYTHON, like "
        "/usr/bin/python3. Or build it for this one as well, in SMILE's folder:\n"
        f"cmake --preset release -U '*Python3*' -DPython3_EXECUTABLE={sys.executable} && "
        f"cmake --build --preset release --target {name}")
