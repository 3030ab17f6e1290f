"""Tests that every public name of the package is described, and that the reference is made without a warning.

Usage: reference_test.py PROJECT_FOLDER BUILD_FOLDER. The second test is skipped without what
tools/get_notebook_tools.sh and tools/get_gymnasium.sh install.
"""

import importlib
import inspect
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, BUILD = Path(sys.argv[1]), Path(sys.argv[2])
TOOLS = [PROJECT / "build/notebooks", PROJECT / "build/gymnasium"]
sys.path.append(str(TOOLS[1]))

import smile  # noqa: E402


def public_names():
    """Names with what they stand for: of the package, and the members of its classes."""
    modules = ["smile", "smile.brain_values", "smile.motion"] + (["smile.gym"] if TOOLS[1].is_dir() else [])
    for module in map(importlib.import_module, modules):
        for name in getattr(module, "__all__", [one for one in vars(module) if not one.startswith("_")]):
            value = getattr(module, name)
            if not (inspect.isclass(value) or inspect.isroutine(value)):
                continue
            if not value.__module__.partition(".")[0].startswith("smile"):
                continue
            yield f"{module.__name__}.{name}", value
            for member, what in vars(value).items() if inspect.isclass(value) else ():
                is_field = member in getattr(value, "_fields", ()) or issubclass(value, BaseException)
                if not member.startswith("_") and not is_field:
                    yield f"{module.__name__}.{name}.{member}", what


class ReferenceTest(unittest.TestCase):
    maxDiff = None

    def test_every_public_name_is_described(self):
        names = dict(public_names())
        self.assertGreater(len(names), 100)
        described = {name: inspect.getdoc(value) or "" for name, value in names.items()}
        # What pybind11 writes by itself is only the signature.
        empty = [name for name, text in described.items()
                 if not re.sub(r"(?m)^\w+\(.*\) -> .*$|^\d+\. .*$|^Overloaded function\.$", "", text).strip()]
        self.assertEqual(empty, [])

    @unittest.skipUnless(all(folder.is_dir() for folder in TOOLS), "tools/get_notebook_tools.sh installed nothing")
    def test_is_made_without_a_warning(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([PROJECT / "tools/make_python_reference.sh", folder], text=True,
                                  env=os.environ | {"SMILE_BUILD": str(BUILD)},
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            pages = {path.relative_to(folder).as_posix() for path in Path(folder).rglob("*.html")}
            self.assertLessEqual({"smile.html", "smile/brain_values.html", "smile/gym.html", "smile/motion.html"}, pages)
            page = (Path(folder) / "smile.html").read_text()
            for name in smile.__all__:
                self.assertIn(f'id="{name}"', page)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
