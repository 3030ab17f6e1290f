#!/usr/bin/env python3
"""Writes anew what the documents and the studio's page have from the program's tables.

In docs/ that is what stands between a line `<!-- smile ARGUMENTS -->` and the next `<!-- -->`.

    tools/generate.py [PROGRAM]    build/dev/bin/smile if not given
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

    def told(arguments):
        return subprocess.run([program, *arguments.split()], check=True, capture_output=True, text=True).stdout

    for file, arguments in FILES.items():
        (ROOT / file).write_text(told(arguments))
    for document in sorted((ROOT / "docs").glob("*.md")):
        text = document.read_text()
        new = PART.sub(lambda part: f"{part[1]}{part[2]}\n{told(part[1])}\n", text)
        if new != text:
            document.write_text(new)


main()
