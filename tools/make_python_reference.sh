#!/usr/bin/env bash
# tools/make_python_reference.sh [FOLDER]
# Writes the reference of the Python package as pages, by default into build/python_reference. Needs the package (of
# the build PRESET, by default release) and what tools/get_notebook_tools.sh installs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=${1:-build/python_reference}
build=${SMILE_BUILD:-build/release}
export PYTHONPATH=python:$build/python:build/notebooks:build/gymnasium PYTHONDONTWRITEBYTECODE=1
# Any warning ends it.
exec /usr/bin/python3 -W error - "$folder" <<'END'
import sys
import types
import typing
from pathlib import Path

import pdoc
import smile
import smile.experiment
import smile.recording

# Annotations name a type of a package that need not be there.
pandas = types.SimpleNamespace(DataFrame=type("DataFrame", (), {"__module__": "pandas"}))
smile.experiment.pandas = smile.recording.pandas = pandas
# pdoc finds names in the dictionaries of modules: those of `smile` are imported when they are first used, and
# annotations name some that only type checkers import.
values = {name: getattr(smile, name) for name in smile.__all__}
vars(smile).update(values)
for name, value in values.items():
    for module in [one for one in sys.modules.values() if one.__name__.startswith("smile.")]:
        if isinstance(value, type):
            vars(module).setdefault(name, value)
    if hasattr(value, "_fields"):  # annotations of a named tuple are text
        value.__new__.__annotations__ = typing.get_type_hints(value)
pdoc.render.configure(template_directory=Path("tools/reference"), footer_text=f"SMILE {smile.__version__}")
# That of smile.datasets would need the packages of tools/get_dataset_readers.sh.
pdoc.pdoc("smile", "smile.brain_values", "smile.gym", "smile.motion", output_directory=Path(sys.argv[1]))
print(Path(sys.argv[1]) / "smile.html")
END
