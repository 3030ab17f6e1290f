#!/usr/bin/env python3
"""Regenerates the parts of the documents and of the studio's page that come from the program's tables.

In docs/, such a part lies between a line `<!-- smile ARGUMENTS -->` and the next `<!-- -->`.

    tools/generate.py [PROGRAM]    default: build/dev/bin/smile
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PART = re.compile(r"(?<=^<!-- smile )([^\n]*)( -->\n).*?(?=^<!-- -->$)", re.DOTALL | re.MULTILINE)
FILES = {
    "web/src/commands.ts": "commands --typescript",
    "web/src/messages.ts": "protocol --typescript",
}


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/dev/bin/smile"

    def output(arguments):
        return subprocess.run([program, *arguments.split()], check=True, capture_output=True, text=True).stdout

    for file, arguments in FILES.items():
        (ROOT / file).write_text(output(arguments))
    for document in sorted((ROOT / "docs").glob("*.md")):
        text = document.read_text()
        new = PART.sub(lambda part: f"{part[1]}{part[2]}\n{output(part[1])}\n", text)
        if new != text:
            document.write_text(new)


main()
