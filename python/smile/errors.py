"""Errors of the simulator."""

from __future__ import annotations

from typing import NamedTuple


class Diagnostic(NamedTuple):
    """A finding about a file: where it is, what was found, and what was expected."""

    file: str
    line: int
    """1 is the first line; 0: the whole file"""
    element: str
    """for example `block id="B3"`; empty: not about one element"""
    message: str


class SceneError(ValueError):
    """A scene, robot, command or recording that is not valid, with all findings."""

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """All findings, in the order of the files."""
        return self._diagnostics

    @diagnostics.setter
    def diagnostics(self, found: list[tuple[str, int, str, str]]) -> None:
        self._diagnostics = [Diagnostic(*one) for one in found]

    _diagnostics: list[Diagnostic] = []


class Refused(RuntimeError):
    """A command was refused; the world has not changed. The message is the reason."""
