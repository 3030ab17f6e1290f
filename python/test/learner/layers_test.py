"""Tests how the learner in python/learner and its twin in matlab/learner are divided: into the same parts, which use only
those before them, and small files."""

import ast
import re
import unittest
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[3]
LEARNER = PROJECT / "python/learner"
TWIN = PROJECT / "matlab/learner"
PARTS = ["constants", "things", "see", "watch", "relate", "explain", "act", "match", "check", "plan", "learner"]
MAX_LINES = 79


def part_of(file):
    return file.relative_to(LEARNER).parts[0].removesuffix(".py")


def part_of_twin(file):
    if file.parent != TWIN:
        return file.relative_to(TWIN).parts[0]
    return "constants" if file.stem == "constants" else "learner"


def called_in(script):
    """Returns the names of the functions of other files that a script of Octave calls or takes handles of: a set, which
    contains variables, too."""
    code = re.sub(r"'[^'\n]*'", "''", re.sub(r"%.*", "", script))
    called = {name for pair in re.findall(r"(?<![\w.])([A-Za-z]\w*)\s*\(|@([A-Za-z]\w*)", code) for name in pair}
    signatures = re.findall(r"^\s*function\b(.*)", code, re.MULTILINE)  # functions of its own, and arguments
    return called - set(re.findall(r"\w+", " ".join(signatures)))


class LayersTest(unittest.TestCase):
    def setUp(self):
        self.files = sorted(LEARNER.rglob("*.py"))

    def test_each_part_uses_only_those_before_it(self):
        self.assertEqual({part_of(file) for file in self.files}, set(PARTS))
        for file in self.files:
            for node in ast.walk(ast.parse(file.read_text())):
                used = node.module.split(".")[0] if isinstance(node, ast.ImportFrom) else ""
                if used in PARTS:
                    self.assertLessEqual(PARTS.index(used), PARTS.index(part_of(file)),
                                         f"{file.relative_to(LEARNER)} uses {node.module}")

    def test_each_file_is_small_and_says_what_it_is(self):
        for file in self.files:
            text = file.read_text()
            self.assertLessEqual(len(text.splitlines()), MAX_LINES, file)
            self.assertTrue(ast.get_docstring(ast.parse(text)), file)

    def test_the_twin_has_the_same_parts_each_of_small_files_that_use_only_those_before_it(self):
        files = {file.stem: file for file in TWIN.rglob("*.m")}
        self.assertEqual({part_of_twin(file) for file in files.values()}, set(PARTS))
        for name, file in files.items():
            script = file.read_text()
            self.assertLessEqual(len(script.splitlines()), MAX_LINES, file)
            for used in called_in(script) & set(files) - {name}:
                self.assertLessEqual(PARTS.index(part_of_twin(files[used])), PARTS.index(part_of_twin(file)),
                                     f"{file.relative_to(TWIN)} uses {files[used].relative_to(TWIN)}")

    def test_each_file_is_in_the_table_of_the_documentation(self):
        rows = [row.split("|") for row in (PROJECT / "docs/learner.md").read_text().splitlines() if row.startswith("| ")]
        part, listed = "", set()
        for _, folder, _, names, *_ in [row for row in rows if len(row) == 5]:
            part = folder.strip(" `") or part
            listed |= {f"{part}/{name.strip(' `')}" for name in names.split(",") if name.strip()}
        files = {f"{part_of(file)}/{file.stem}" for file in self.files if file.parent != LEARNER and file.stem != "__init__"}
        self.assertEqual(files - listed, set())
        self.assertEqual({it for it in listed if it.split("/")[0] in PARTS} - files, set())


if __name__ == "__main__":
    unittest.main()
