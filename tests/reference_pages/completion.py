#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks data/completion/hdconj.bash: completion.py HDCONJ

It knows the verbs and the options of the program, no more and no fewer, and bash completes them.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))
from command_line import help_text, options, verbs  # noqa: E402

FILE = ROOT / "data" / "completion" / "hdconj.bash"
ALONE = {"help", "study", "version"}  # verbs that the program does not list; tests/python has the options of study


def completed(*words):
    """What bash offers for the last of some words."""
    script = (f'source "{FILE}"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _hdconj; '
              'printf "%s\\n" "${COMPREPLY[@]}"')
    result = subprocess.run(["bash", "-c", script, "bash", *words], capture_output=True, text=True, check=True)
    return set(result.stdout.split())


def main(program):
    faults = []
    known = verbs(program)
    offered = completed("hdconj", "")
    if offered != set(known) | ALONE:
        faults.append(f"verbs: {sorted(offered ^ (set(known) | ALONE))}")
    for verb in known:
        expected = {name for name in options(program, verb) if name.startswith("--")}
        offered = completed("hdconj", verb, "--")
        if offered != expected:
            faults.append(f"options of {verb}: {sorted(offered ^ expected)}")
    if completed("hdconj", "contact", "--kind", "d") != {"draft"}:
        faults.append("--kind d is not completed to draft")
    told = re.search(r"what else is computed: ([a-z, ]+) \[", " ".join(help_text(program, "report").split()))
    offered = completed("hdconj", "report", "--with", "")
    if not told or offered != set(told[1].split(", ")):
        faults.append(f"words of --with: {sorted(offered)}")
    print(*faults, f"{len(known)} verbs, {len(faults)} faults", sep="\n")
    return 1 if faults or not known else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if shutil.which("bash") else 77)
