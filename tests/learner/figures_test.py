"""The figures of docs/learner.md are those that the learner at work draws.

    figures_test.py SMILE SOURCE
"""

import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

PROGRAM, SOURCE = sys.argv[1], Path(sys.argv[2])
SVG = "{http://www.w3.org/2000/svg}"


class FiguresTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        subprocess.run([sys.executable, "-B", SOURCE / "tools/learner_figures/make.py", PROGRAM, folder], check=True,
                       stdout=subprocess.DEVNULL)
        cls.drawn = {it.name: ElementTree.parse(it).getroot() for it in folder.iterdir()}
        kept = SOURCE / "docs/images/learner"
        cls.kept = {it.name: ElementTree.parse(it).getroot() for it in kept.iterdir()}

    def test_all_are_in_the_document(self):
        text = (SOURCE / "docs/learner.md").read_text()
        self.assertEqual(sorted(re.findall(r"images/learner/(\w+\.svg)", text)), sorted(self.drawn))
        self.assertEqual(sorted(self.kept), sorted(self.drawn))

    def test_say_what_the_kept_ones_say(self):
        for name, drawn in self.drawn.items():
            with self.subTest(name):
                for kind in ("image", "polygon"):
                    self.assertEqual(len(drawn.findall(SVG + kind)), len(self.kept[name].findall(SVG + kind)))
                self.assertEqual(words_in(drawn), words_in(self.kept[name]), "run tools/make_learner_figures.sh")
        self.assertIn("only a means: nothing of it is kept", words_in(self.drawn["explain.svg"]))


def words_in(figure):
    """Returns the lines of text in a figure, but for the values of numbers."""
    return [re.sub("[0-9]", "0", it.text) for it in figure.iter(SVG + "text")]


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
