"""A folder that appears complete, or not at all."""

from __future__ import annotations

import errno
import fcntl
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def new_folder(folder: Path) -> Iterator[Path]:
    """Yields a folder beside `folder`, which gets that name when the block ends without an error, and
    is removed otherwise. What a killed process left there is removed by the next one.

    Raises FileExistsError if `folder` exists, or another process is making it.
    """
    refuse_existing(folder)
    folder.parent.mkdir(parents=True, exist_ok=True)
    partial = folder.with_name(folder.name + ".partial")
    lock_file = folder.with_name(folder.name + ".partial.lock")
    with lock_file.open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise FileExistsError(errno.EEXIST, "is being made by another process", str(folder)) from None
        try:
            shutil.rmtree(partial, ignore_errors=True)
            partial.mkdir()
            yield partial
            _write_through(partial)
            refuse_existing(folder)
            partial.rename(folder)
        finally:
            shutil.rmtree(partial, ignore_errors=True)
            lock_file.unlink(missing_ok=True)


def refuse_existing(folder: Path) -> None:
    """Raises FileExistsError if there is something of that name."""
    if folder.exists() or folder.is_symlink():
        raise FileExistsError(errno.EEXIST, "exists, expected a new folder", str(folder))


def _write_through(folder: Path) -> None:
    """Waits until all files are on the disk: a rename must not survive what it names."""
    for path in sorted(folder.rglob("*")):
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
