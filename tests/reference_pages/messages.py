#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the program says what docs/reference/messages.md says it does: messages.py SOURCE_DIR

Every text in the first column of a table stands in a string of src/, include/ or apps/.
"""
import re
import sys
from pathlib import Path


def strings(root):
    """All strings of the sources; neighbours that the compiler joins are joined."""
    text = ""
    for folder in ("src", "include", "apps"):
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            text += path.read_text() + "\n"
    text = re.sub(r'"\s*\n\s*"', "", text)
    return [found.replace('\\"', '"') for found in re.findall(r'"((?:\\.|[^"\\\n])*)"', text)]


def main(root):
    known = "\n".join(strings(root))
    rows = [line.split("|")[1] for line in (root / "docs/reference/messages.md").read_text().splitlines()
            if line.startswith("| `")]
    quoted = [words for row in rows for words in re.findall(r"`([^`]+)`", row)]
    faults = [f"the program does not say: {words}" for words in quoted if words not in known]
    print(*faults, f"{len(quoted)} messages, {len(faults)} faults", sep="\n")
    return 1 if faults or not quoted else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
