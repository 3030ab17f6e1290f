#!/usr/bin/env python3
"""Builds the Python package as pip does, and installs it into the environment of this Python.

The wheel is made of the source distribution, so that a file missing there is missed. What was compiled
before is kept in build/package; only what changed is compiled again. Needs what
tools/get_python_packages.sh installs:

    build/venv/bin/python tools/build_python_package.py
"""

import subprocess
import sys
import tarfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "build/package"
SOURCE = WORK / "source"
KEPT = SOURCE / "build/package"  # what was compiled


def pip(*arguments):
    subprocess.run([sys.executable, "-m", "pip", "--disable-pip-version-check", *map(str, arguments)], check=True)


def make_source_distribution():
    """Returns the .tar.gz that the build backend makes of this folder."""
    folder = WORK / "sdist"
    program = "import sys; from scikit_build_core.build import build_sdist; print(build_sdist(sys.argv[1]))"
    made = subprocess.run([sys.executable, "-c", program, folder], cwd=ROOT, check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    return folder / made.splitlines()[-1]


def unpack(archive):
    """Makes SOURCE contain the files of an archive. A file of the same bytes keeps its time, by which ninja
    knows that it has not changed: those within the archive are all the same."""
    files = set()
    with tarfile.open(archive) as tar:
        for member in tar:
            if not member.isfile():
                continue
            path = SOURCE / Path(*Path(member.name).parts[1:])
            files.add(path)
            content = tar.extractfile(member).read()
            if path.exists() and path.read_bytes() == content:
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            path.chmod(member.mode | 0o600)
    for path in SOURCE.rglob("*"):
        if path.is_file() and path not in files and KEPT not in path.parents:
            path.unlink()


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    unpack(make_source_distribution())
    for old in WORK.glob("*.whl"):
        old.unlink()
    # The tools are those of this environment; verbose, as ninja says how far it is.
    pip("wheel", "--verbose", "--no-build-isolation", "--no-deps", "--wheel-dir", WORK, SOURCE)
    (wheel,) = WORK.glob("*.whl")
    pip("install", "--quiet", "--no-deps", "--force-reinstall", wheel)


if __name__ == "__main__":
    main()
