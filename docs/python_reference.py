#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/reference/python.md from the documentation of the package hdconj, which must be importable.

    python_reference.py            writes the page
    python_reference.py --check    fails where the page is not what would be written
"""
import inspect
import itertools
import sys
import textwrap
from pathlib import Path

import hdconj

PAGE = Path(__file__).parent / "reference/python.md"
HEAD = """# Python

The package `hdconj`. [Compute in Python](../how-to/compute-in-python.md) shows how it is used.
`docs/python_reference.py` makes this page from the package.
"""


COLUMNS = 98


def block(text):
    """Documentation as it stands, so that its columns stay. A paragraph with a longer line is filled again."""
    lines = []
    for indent, run in itertools.groupby(text.splitlines(), lambda line: line[: len(line) - len(line.lstrip())] if line
                                         else None):
        run = list(run)
        if max(map(len, run)) > COLUMNS:
            run = textwrap.wrap(" ".join(map(str.strip, run)), COLUMNS, initial_indent=indent,
                                subsequent_indent=indent)
        lines += run
    return "```text\n" + "\n".join(lines) + "\n```\n"


def members(kind):
    """Public methods and properties that the class itself documents, and what their documentation says."""
    for name, member in vars(kind).items():
        target = member.fget if isinstance(member, property) else getattr(member, "__func__", member)
        if not name.startswith("_") and inspect.getdoc(target) and callable(target):
            called = not isinstance(member, property)
            yield name + ("()" if called else ""), inspect.getdoc(target)


def page():
    parts = [HEAD]
    functions = [name for name in hdconj.__all__ if inspect.isfunction(getattr(hdconj, name))]
    parts.append("## Functions\n")
    for name in functions:
        parts.append(f"### {name}\n\n{block(inspect.getdoc(getattr(hdconj, name)))}")
    parts.append("## Classes\n")
    for name in hdconj.__all__:
        kind = getattr(hdconj, name)
        if not inspect.isclass(kind):
            continue
        parts.append(f"### {name}\n\n{block(inspect.getdoc(kind))}")
        rows = [f"{member}: {words.splitlines()[0]}" for member, words in members(kind)]
        if rows:
            parts.append("\n".join(line for row in rows for line in textwrap.wrap(
                f"- `{row.replace(': ', '`: ', 1)}", COLUMNS, subsequent_indent="  ")) + "\n")
        for member, words in members(kind):
            if "Parameters\n---" in words:
                parts.append(f"#### {name}.{member}\n\n{block(words)}")
    return "\n".join(parts)


def main(arguments):
    if "--check" in arguments:
        if PAGE.read_text() != page():
            print(f"{PAGE.name} is not what docs/python_reference.py writes: run it")
            return 1
        return 0
    PAGE.write_text(page())
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
