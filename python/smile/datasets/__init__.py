"""Datasets for imitation learning, made from recordings and checked (docs/datasets.md).

    from smile.datasets import export, examine, merge
    export(["out/tower"], "tower-dataset")
    for finding in examine("tower-dataset"): print(finding)

Needs pyarrow. The same from a shell: `python3 -m smile.datasets --help`.
"""

from smile.datasets.doctor import Finding, examine
from smile.datasets.episode import ACTIONS
from smile.datasets.exporting import FORMATS, Report, export
from smile.datasets.merging import merge

__all__ = ["ACTIONS", "FORMATS", "Finding", "Report", "examine", "export", "merge"]
