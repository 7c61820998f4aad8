#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of the pages and compares what they print with what the pages show.

    run_pages.py PROGRAM SOURCE_DIR [PAGE...]    README, CONTRIBUTING and all pages of docs, or those named
    run_pages.py PROGRAM SOURCE_DIR --control    breaks a page in several ways: each must be caught

A page runs in a fresh folder that holds a copy of data/; `hdconj` is PROGRAM. In a fenced block marked ```console a
line that begins with `$ ` is a command (a backslash at its end continues it), the lines below it are what it prints on
standard output and standard error. A line `...` stands for any number of lines, `...` within a line for any words. No
lines below a command: what it prints is not compared. Words after ```console:

    exit=2         the exit status that the commands must have; 0 without it
    needs=h5py     a program or Python module without which the block is not tried
    short=A,B      words added to the calls of hdconj, which then take less time; not with HDCONJ_FULL=1 in the
                   environment

A fenced block marked with a language and file=NAME is written to NAME before the commands that follow it.

Code within a line is a command too if it begins with `hdconj`, a verb and an argument. It must succeed; what it prints
is not compared. A word in capitals, or `...`, stands for what the reader puts in: such a command is not run.

Lines are equal where their words are, and their numbers agree: within 1 in the last digit that the page shows; within
2 % before the units ms and s; within the error that follows after `+-`. That error itself may differ by a factor of 2.
"""
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.\d*|\.\d+|\d+)(?:e[-+]?\d+)?(?![\w]|\.\d)")
INLINE = re.compile(r"`(hdconj\s+[a-z]+\s[^`]*)`")
PLACEHOLDER = re.compile(r"\.\.\.|\b[A-Z]{3,}\b")
TIMEOUT_S = 240


class Block:
    """A fenced block: its language, the words after it, its lines and where it begins."""

    def __init__(self, info, line):
        words = info.split()
        self.language = words[0] if words else ""
        self.options = dict(word.partition("=")[::2] for word in words[1:])
        self.line = line
        self.lines = []


def inline_blocks(text, begin):
    """The commands within the lines of a text that begins at line `begin`, each as a block of its own."""
    for match in INLINE.finditer(text):
        if not PLACEHOLDER.search(match[1]):
            block = Block("console", begin + text.count("\n", 0, match.start()))
            block.lines.append("$ " + " ".join(match[1].split()))
            yield block


def blocks_of(text):
    """All fenced blocks of a page and the commands between them, in order."""
    found, block, prose, begin = [], None, [], 1
    for number, line in enumerate([*text.splitlines(), "```"], 1):
        if block is None and line.startswith("```"):
            found += inline_blocks("\n".join(prose), begin)
            block = Block(line[3:], number)
        elif block is not None and line.startswith("```"):
            found.append(block)
            block, prose, begin = None, [], number + 1
        elif block is not None:
            block.lines.append(line)
        else:
            prose.append(line)
    if block is None:
        raise ValueError(f"line {found[-1].line}: the fenced block does not end")
    return found


def shortened(command, block):
    """The command with the words that make it short, where it is a call of hdconj and not all is to be run."""
    words = block.options.get("short", "").replace(",", " ")
    whole = not words or os.environ.get("HDCONJ_FULL") == "1" or not command.startswith("hdconj ")
    return command if whole else f"{command} {words}"


def commands_of(block):
    """Tuples of line number, command and the lines shown below it."""
    found, continues = [], False
    for number, line in enumerate(block.lines, block.line + 1):
        if continues:
            found[-1][1] += "\n" + line
            continues = line.endswith("\\")
        elif line.startswith("$ "):
            found.append([number, line[2:], []])
            continues = line.endswith("\\")
        elif found:
            found[-1][2].append(line)
        else:
            raise ValueError(f"line {number}: a console block begins with a command")
    return found


def last_digit(number):
    """The size of 1 in the last digit of a number as written."""
    mantissa, _, exponent = number.partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def tokens_of(line):
    """Words and numbers of a line, in pieces without white space."""
    found, at = [], 0
    for match in NUMBER.finditer(line):
        found += [*((word, None) for word in line[at:match.start()].split()), (match[0], float(match[0]))]
        at = match.end()
    return found + [(word, None) for word in line[at:].split()]


def allowed(tokens, at):
    """How far the printed number may be from token `at` of a shown line."""
    text, value = tokens[at]
    before = tokens[at - 1][0] if at else ""
    after = tokens[at + 1][0] if at + 1 < len(tokens) else ""
    far = 1.001 * last_digit(text)
    if before.endswith("+-"):
        far = max(far, abs(value))
    elif after == "+-" and at + 2 < len(tokens) and tokens[at + 2][1] is not None:
        far = max(far, abs(tokens[at + 2][1]))
    return max(far, 0.02 * abs(value)) if re.match(r"(ms|s)\b", after) else far


def same_line(shown, printed):
    """Whether a printed line is what the page shows."""
    return agree(tokens_of(shown), 0, tokens_of(printed), 0)


def agree(ours, i, theirs, j):
    """Whether the shown tokens from i on are the printed ones from j on."""
    while i < len(ours):
        (text, value), (other, other_value) = ours[i], theirs[j] if j < len(theirs) else (None, None)
        if text == "...":
            return i + 1 == len(ours) or any(agree(ours, i + 1, theirs, k) for k in range(j, len(theirs)))
        if value is None or other_value is None:
            if text != other:
                return False
        elif abs(value - other_value) > allowed(ours, i):
            return False
        i, j = i + 1, j + 1
    return j == len(theirs)


def first_difference(shown, printed):
    """The first shown line that is not printed where it should be; None where there is none."""
    shown = [line for line in shown if line.strip()]
    printed = [line for line in printed if line.strip()]
    at, skips = 0, False
    stretches, stretch = [], []
    for line in shown + [None]:
        if line is None or line.strip() == "...":
            stretches.append(stretch)
            stretch = []
        else:
            stretch.append(line)
    for number, stretch in enumerate(stretches):
        last = len(printed) - len(stretch)
        if number == len(stretches) - 1 and number > 0 and stretch:
            at = max(at, last)  # the last lines shown are the last lines printed
        places = range(at, max(last, at) + 1) if skips else [at]
        place = next((p for p in places if matches(stretch, printed, p)), None)
        if place is None:
            return worst_line(stretch, printed, places)
        at, skips = place + len(stretch), True
    if stretches[-1] and at < len(printed):
        return f"not shown, but printed: {printed[at]}"
    return None


def matches(stretch, printed, at):
    """Whether the printed lines from `at` on are the stretch."""
    return at + len(stretch) <= len(printed) and all(map(same_line, stretch, printed[at:]))


def worst_line(stretch, printed, places):
    """Names the line at which the longest agreement ends."""
    best, where = -1, 0
    for place in places:
        agreed = 0
        while (agreed < len(stretch) and place + agreed < len(printed)
               and same_line(stretch[agreed], printed[place + agreed])):
            agreed += 1
        if agreed > best:
            best, where = agreed, place
    other = printed[where + best] if where + best < len(printed) else "(nothing)"
    return f"shown:   {stretch[min(best, len(stretch) - 1)]}\n      printed: {other}"


def is_there(name, program):
    """Whether a program or a Python module of this name is there, perhaps beside the program."""
    return (shutil.which(name) is not None or Path(program).with_name(name).is_file() or
            importlib.util.find_spec(name) is not None)


def environment(folder, program):
    """Where `hdconj` is the program and `python3` the interpreter that runs this script."""
    tools = folder / "tools"
    tools.mkdir()
    for name, target in (("hdconj", program), ("python3", sys.executable)):
        (tools / name).write_text(f'#!/bin/sh\nexec "{target}" "$@"\n')
        (tools / name).chmod(0o755)
    return {**os.environ, "PATH": f"{tools}{os.pathsep}{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}


def run_command(command, status, shown, folder, env):
    """Runs one command; what is wrong with it, or None."""
    try:
        done = subprocess.run(["/bin/sh", "-c", command], cwd=folder, env=env, timeout=TIMEOUT_S, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except subprocess.TimeoutExpired:
        return f"takes more than {TIMEOUT_S} s"
    if done.returncode != status:
        return f"exit status {done.returncode}, not {status}:\n{done.stdout[-2000:]}"
    return first_difference(shown, done.stdout.splitlines()) if any(line.strip() for line in shown) else None


def run_page(name, text, program, source):
    """Runs one page; returns how many commands were run, the faults and what was not tried."""
    count, faults, missing = 0, [], []
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "work"
        shutil.copytree(source / "data", folder / "data")
        env = environment(Path(scratch), program)
        for block in blocks_of(text):
            if "file" in block.options:
                (folder / block.options["file"]).write_text("\n".join(block.lines) + "\n")
            if block.language != "console":
                continue
            need = block.options.get("needs")
            if need and not is_there(need, program):
                missing.append(f"{name}:{block.line}: {need}")
                continue
            for line, command, shown in commands_of(block):
                count += 1
                run = shortened(command, block)
                wrong = run_command(run, int(block.options.get("exit", 0)), shown, folder, env)
                if wrong:
                    faults.append(f"{name}:{line}: $ {run}\n      {wrong}")
    return count, faults, missing


def pages_of(source):
    """README, CONTRIBUTING and all pages of docs."""
    return [source / "README.md", source / "CONTRIBUTING.md", *sorted((source / "docs").rglob("*.md"))]


CONTROL = """```console
$ hdconj check --plan
{plan}
```
```console exit={status}
$ hdconj solve --set flexspline.wall=-1{more}
```
Within a line: `hdconj check --plan{inline}`, and `hdconj solve SCENE` is no command.
"""


def control(program, source):
    """A page that is right must pass, and each of its broken forms must be caught."""
    done = subprocess.run([program, "check", "--plan"], capture_output=True, text=True, check=True)
    plan = list(filter(str.strip, done.stdout.splitlines()))
    number = next(at for at, line in enumerate(plan) if NUMBER.search(line))
    changed = [*plan]
    changed[number] = NUMBER.sub(lambda m: repr(float(m[0]) * 1.5 + 1), plan[number], count=1)
    right = {"plan": "\n".join(plan), "status": 2, "more": "", "inline": ""}
    skipped = {"plan": f"...\n{plan[number].rpartition(' ')[0]} ...\n..."}
    forms = {"right": {}, "right, with lines skipped": skipped,
             "a number": {"plan": "\n".join(changed)}, "a word": {"plan": "\n".join(plan[:-1] + ["x" + plan[-1]])},
             "a line too many": {"plan": "\n".join(plan + ["and more"])},
             "a line too few": {"plan": "\n".join(plan[:-1])},
             "an exit status": {"status": 0}, "an option within a line": {"inline": " --nonesuch"},
             "a command": {"more": "\n$ hdconj nonesuch-verb; exit 9"},
             "a line after skipped ones": {"plan": "...\nno such line"}}
    failed = []
    for what, change in forms.items():
        faults = run_page(what, CONTROL.format(**{**right, **change}), program, source)[1]
        if bool(faults) == what.startswith("right"):
            failed.append(f"{what}: {faults[0] if faults else 'not caught'}")
    return failed


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    program, source = str(Path(arguments[0]).resolve()), Path(arguments[1]).resolve()
    if "--control" in arguments:
        failed = control(program, source)
        print("\n".join(failed) or "every break of the page was caught")
        return bool(failed)
    all_faults, all_missing = [], []
    for page in [(source / name).resolve() for name in arguments[2:]] or pages_of(source):
        name = page.relative_to(source).as_posix()
        count, faults, missing = run_page(name, page.read_text(), program, source)
        print(f"{name}: {count} commands, {len(faults)} faults", flush=True)
        all_faults += faults
        all_missing += missing
    if os.environ.get("CI"):  # there everything must be tried but what tests/not_tried.txt allows: our own package
        all_faults += [f"{what} is missing" for what in all_missing if not what.endswith(": hdconj")]
    print("\n".join(all_faults or [f"NOT TRIED: {what}" for what in all_missing]))
    return bool(all_faults)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
