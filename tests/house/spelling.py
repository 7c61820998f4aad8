#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs codespell over the pages and the sources; exit status 77 where it is not installed.

  spelling.py SOURCE_DIR   check README.md, CONTRIBUTING.md, CHANGELOG.md, docs, src, include and apps
  spelling.py --control    check the check: a misspelt word must be caught
"""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

CHECKED = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs", "src", "include", "apps")
SKIPPED = 77  # SKIP_RETURN_CODE of the test


def faults_in(root):
    """The misspelt words below root, one a line."""
    names = [name for name in CHECKED if (root / name).exists()]
    result = subprocess.run(["codespell", *names], cwd=root, capture_output=True, text=True)
    return (result.stdout + result.stderr).splitlines()


def control():
    """A good page passes, and a misspelt word is named."""
    failures = []
    for text, expected in (("The tooth.\n", False), ("It " + "reci" + "eves.\n", True)):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "README.md").write_text(text)
            if bool(faults_in(Path(folder))) != expected:
                failures.append(f"{'not caught' if expected else 'refused'}: {text!r}")
    return failures


if __name__ == "__main__":
    if not shutil.which("codespell"):
        print("codespell is not installed: cmake/debian-packages.txt, [test]")
        sys.exit(SKIPPED)
    found = control() if sys.argv[1] == "--control" else faults_in(Path(sys.argv[1]))
    print(*found, f"{len(found)} faults", sep="\n")
    sys.exit(1 if found else 0)
