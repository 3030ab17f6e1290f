"""Runs the notebooks of docs/notebooks in a kernel of their own, and compares what they print with what is written there.

Usage: notebooks_test.py PROJECT_FOLDER [--update]

--update writes the new output into the notebooks. Outputs of cells with the tag `live`, the page and films, are
not kept: forges do not show them. Needs what tools/get_notebook_tools.sh and tools/get_gymnasium.sh install;
skipped (77) without.
"""

import os
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv[1])
FOLDER = PROJECT / "docs/notebooks"
TOOLS = [PROJECT / "build/notebooks", PROJECT / "build/gymnasium"]
MOST_BYTES = 300_000  # of all notebooks

if not all(folder.is_dir() for folder in TOOLS):
    print("skipped: tools/get_notebook_tools.sh and tools/get_gymnasium.sh have installed nothing")
    sys.exit(77)
sys.path[:0] = map(str, TOOLS)
# The kernel is found in the first, and finds its modules by the second.
os.environ["JUPYTER_PATH"] = str(TOOLS[0] / "share/jupyter")
os.environ["PYTHONPATH"] = os.pathsep.join([*map(str, TOOLS), os.environ.get("PYTHONPATH", "")])
os.environ["JUPYTER_PLATFORM_DIRS"] = "1"

import nbclient  # noqa: E402
import nbformat  # noqa: E402


def texts(cell):
    """What a cell prints, and what a reader sees as text of its value."""
    printed = "".join(one["text"] for one in cell.outputs if one["output_type"] == "stream")
    values = [one["data"]["text/plain"] for one in cell.outputs
              if "data" in one and "image/png" not in one["data"] and "text/html" not in one["data"]]
    return printed, values


def kinds(cell):
    return {kind for one in cell.outputs for kind in one.get("data", {})}


def run(path):
    """Returns a notebook as it is, and as it is after a run in a folder of its own."""
    kept, ran = nbformat.read(path, 4), nbformat.read(path, 4)
    with tempfile.TemporaryDirectory() as folder:
        nbclient.NotebookClient(ran, timeout=300, kernel_name="python3",
                                resources={"metadata": {"path": folder}}).execute()
    return kept, ran


def update():
    for path in sorted(FOLDER.glob("*.ipynb")):
        kept, ran = run(path)
        for number, (old, new) in enumerate(zip(kept.cells, ran.cells)):
            if old.cell_type != "code":
                continue
            old.outputs = [] if "live" in old.metadata.get("tags", ()) else new.outputs
            old.execution_count = None
            for output in old.outputs:
                output.pop("execution_count", None)
                if output["output_type"] == "execute_result":
                    output["output_type"] = "display_data"
                if "image/png" in output.get("data", {}):  # a forge shows nothing else
                    output["data"] = {"image/png": output["data"]["image/png"]}
        nbformat.write(kept, path)
        print(path, path.stat().st_size)


class NotebooksTest(unittest.TestCase):
    def test_run_and_give_what_is_written(self):
        paths = sorted(FOLDER.glob("*.ipynb"))
        self.assertEqual(len(paths), 5)
        for path in paths:
            kept, ran = run(path)
            for old, new in zip(kept.cells, ran.cells):
                if old.cell_type != "code":
                    continue
                with self.subTest(notebook=path.name, cell=old.source):
                    if "live" in old.metadata.get("tags", ()):
                        self.assertEqual(old.outputs, [])
                        self.assertIn("text/html", kinds(new))
                        continue
                    self.assertEqual(texts(new), texts(old))
                    self.assertEqual("image/png" in kinds(new), "image/png" in kinds(old))
            pictures = sum("image/png" in kinds(cell) for cell in kept.cells if cell.cell_type == "code")
            self.assertGreaterEqual(pictures, 2, path)

    def test_keep_the_repository_small(self):
        self.assertLess(sum(path.stat().st_size for path in FOLDER.iterdir()), MOST_BYTES)


if __name__ == "__main__":
    if "--update" in sys.argv:
        update()
    else:
        unittest.main(argv=sys.argv[:1])
