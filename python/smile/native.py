"""Imports the compiled modules of SMILE, and explains failures to do so."""

import glob
import importlib
import os
import platform
import sys


def load(name):
    """Imports the compiled module `name`. An ImportError explains how to get it."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(how_to_get(name, error)) from error


def how_to_get(name, error):
    text = f"{sys.executable} (Python {platform.python_version()}) cannot load {name}: {error}\n"
    found = [file for folder in sys.path for file in glob.glob(os.path.join(folder, name + ".*.so"))]
    if not found:
        return text + ("It is built with SMILE if pybind11 is installed; build/release/python must "
                       "be on PYTHONPATH.")
    return text + (
        f"{', '.join(found)} is built for another Python: set SMILE_PYTHON to that Python, for "
        "example /usr/bin/python3. Or build the module for this Python, in SMILE's folder:\n"
        f"cmake --preset release -U '*Python3*' -DPython3_EXECUTABLE={sys.executable} && "
        f"cmake --build --preset release --target {name}")
