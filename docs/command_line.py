#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/reference/command-line.md from the help texts of the program.

  command_line.py HDCONJ           write the page
  command_line.py HDCONJ --check   compare the page with the program; exit status 1 where they differ
"""
import difflib
import re
import subprocess
import sys
import textwrap
from pathlib import Path

PAGE = Path(__file__).resolve().parent / "reference" / "command-line.md"
WIDTH = 96  # of a line of code, which Markdown indents by four columns more

HEAD = """\
# Command line

This page holds the help texts of the program, word for word. `docs/command_line.py HDCONJ` writes
it, and a test fails where page and program differ. `hdconj VERB --help` prints the same text.

A verb says what to compute, and the scene file follows the verb. Without a scene file the program
computes the built-in drive. The keys that `--set` changes are on the page [scene](scene.md).

| exit status | meaning |
|---|---|
| 0 | done |
| 1 | failed: the message says at which step, where and why |
| 2 | the scene or the command line is wrong; nothing was computed |

Results go to standard output and to files. Messages, notes and the progress bar go to standard
error. [Messages](messages.md) lists the usual refusals with their remedies.
"""


def help_text(program, *verb):
    """What `hdconj [VERB] --help` prints."""
    return subprocess.run([program, *verb, "--help"], capture_output=True, text=True, check=True).stdout.rstrip()


def verbs(program):
    """The verbs of the program with their short descriptions, in its own order."""
    listed = help_text(program).split("Subcommands:\n", 1)[1].split("\n\n", 1)[0]
    return dict(line.split(None, 1) for line in listed.splitlines())


def options(program, verb):
    """The options of a verb, long and short."""
    listed = help_text(program, verb).split("Options:\n", 1)[1].split("\n\n", 1)[0]
    heads = re.findall(r"^  (-\S+)", listed, re.M)
    return [name for head in heads for name in head.split(",") if name.startswith("-")]


def narrow(line):
    """Wraps a line; a column of descriptions keeps its place."""
    if len(line) <= WIDTH:
        return [line]
    column = re.match(r" {2,}\S+(?: \S+)*? {2,}(?=\S)|\s*", line).end()
    return textwrap.wrap(line, WIDTH, subsequent_indent=" " * column, break_long_words=False, break_on_hyphens=False)


def as_code(text):
    """The text as an indented block of code."""
    lines = [part for line in text.splitlines() for part in narrow(line)]
    return "\n".join(("    " + line).rstrip() for line in lines)


def page(program):
    """The whole page."""
    whole = help_text(program)
    footer = whole.split("\n\nExamples:", 1)[1]
    parts = [HEAD, "## hdconj\n", as_code(whole), ""]
    for verb, what in verbs(program).items():
        text = help_text(program, verb).replace("\n\nExamples:" + footer, "")
        parts += [f"## hdconj {verb}\n", what[0].upper() + what[1:] + ".\n", as_code(text.split("\n", 1)[1]), ""]
    return "\n".join(parts).rstrip() + "\n"


def main(program, *rest):
    text = page(program)
    if rest != ("--check",):
        PAGE.write_text(text)
        return 0
    stored = PAGE.read_text()
    print(*difflib.unified_diff(stored.splitlines(), text.splitlines(), "page", "program", lineterm=""), sep="\n")
    if stored != text:
        print(f"run {Path(__file__).name} {program} and look at what has changed")
    return 0 if stored == text else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
