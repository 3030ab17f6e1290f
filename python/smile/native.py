"""Imports the compiled modules of SMILE, and explains failures to do so."""

from __future__ import annotations

import glob
import importlib
import os
import platform
import sys
from typing import Any


def load(name: str) -> Any:
    """Imports a compiled module: of the installed package, or else of a build on the module path.

    Raises ImportError that explains how to get it.
    """
    packaged = f"smile.{name}"
    try:
        try:
            return importlib.import_module(packaged)
        except ModuleNotFoundError as error:
            if error.name != packaged:
                raise
            return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(how_to_get(name, error)) from error


def how_to_get(name: str, error: object) -> str:
    """Returns why a compiled module cannot be loaded, and what to do."""
    text = f"{sys.executable} (Python {platform.python_version()}) cannot load {name}: {error}\n"
    folders = [os.path.dirname(__file__), *sys.path]
    found = [file for folder in folders for file in glob.glob(os.path.join(folder, name + ".*.so"))]
    if not found:
        return text + ("It is built with SMILE if pybind11 is installed; build/release/python must "
                       "be on PYTHONPATH. Or install the package: pip install . in SMILE's folder.")
    return text + (
        f"{', '.join(found)} is built for another Python: set SMILE_PYTHON to that Python, for "
        "example /usr/bin/python3. Or build the module for this Python, in SMILE's folder:\n"
        f"cmake --preset release -U '*Python3*' -DPython3_EXECUTABLE={sys.executable} && "
        f"cmake --build --preset release --target {name}")
