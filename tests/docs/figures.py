#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the figures of the pages with the files that they come from, and these with the program.

    figures.py SOURCE_DIR                  the pages against data/reference
    figures.py SOURCE_DIR --control        changes figures of pages and files in a copy: each change must be caught
    figures.py SOURCE_DIR --fresh PROGRAM  makes the files again; with HDCONJ_LONG set, also those that take long

A comment below a paragraph, a list or a table names the source of its figures. Browsers do not show it:

    <!-- from: load-thesis.csv [kind=radial] twist +-, teeth; [tilt=0.3, kind=draft] twist / [tilt=0] twist * 100 -->
    <!-- by: tests/cli/cup_export.cpp -->
    <!-- given: table 4-1 of the thesis -->
    <!-- inputs: 0.2°, 28 N m -->

`from` names columns of a file (its folder is data/reference where it has none), of the rows in brackets or of all rows.
A file that is left out is the one named before, and the end of a column's name may be left out. `+-` after a column is
its error, the column that follows, and `+-` before it the error alone. A figure whose error is more than a third of it
never stands without that error. Signs / * + - between such terms, or numbers,
compute from left to right. Row by row, these values stand in the text in this order, each rounded to the digits that
the text shows and at most 6 % off. `by` names sources that hold the figures, tests as a rule; a test source in code,
such as `law/union`, does the same. `given` says where figures come from that no run made. `inputs` is for a whole page:
what its author chose. On the pages of COVERED, and README, each figure has a source. A figure is a number with a
decimal point or a unit, outside of code and headings. A number that chooses a row, as 0.3 above, is an input too.

The head of a file says `# made by: COMMAND`, run in SOURCE_DIR with PROGRAM put in, or `# made by (long): COMMAND`. A
fresh file may differ by 1 in the last digit of a number, or by the error beside it.
"""
import csv
import operator
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from run_pages import NUMBER, last_digit

COVERED = ("docs/explanation",)
NOT_COVERED = ("docs/explanation/architecture.md",)
MARK = re.compile(r"<!--\s*(from|by|given|inputs):(.*?)-->", re.S)
SIGNS = {"/": operator.truediv, "*": operator.mul, "+": operator.add, "-": operator.sub}
UNIT = re.compile(r"\s?(%|°|'(?![a-z])|um\b|mm\b|deg\b|arcmin|GPa|MPa|N\b|ms\b|s\b|MB\b|ns\b|rad\b|times\b|million\b)")
TERM = re.compile(r"(?:(?P<file>\S+\.csv)\s*)?(?:\[(?P<rows>[^\]=]+=[^\]]*)\]\s*)?(?P<columns>.+)", re.S)


class Block:
    """A stretch of a page without blank lines, and the marks below it."""

    def __init__(self, page, line, text):
        self.page, self.line, self.text, self.marks = page, line, text, []

    def numbers(self):
        """Matches of all numbers outside of code, with commas between thousands taken out."""
        text = re.sub(r"`[^`]*`|\]\([^)]*\)|<!--.*?-->", lambda m: " " * len(m[0]), self.text, flags=re.S)
        return text, list(re.finditer(rf"(?<![\w.])[-+]?\d{{1,3}}(?:,\d{{3}})+(?![\w,])|{NUMBER.pattern}", text))


def blocks_of(page, text):
    """Blocks of a page; code and headings are none."""
    text = re.sub(r"^```.*?^```$", lambda m: "\n" * m[0].count("\n"), text, flags=re.S | re.M)
    text = re.sub(r"^(#.*|    .*)$", "", text, flags=re.M)
    found = []
    for part in re.finditer(r"(?:^.*\S.*\n?)+", text, flags=re.M):
        body = part[0]
        line = text.count("\n", 0, part.start()) + 1
        at = 0
        for mark in MARK.finditer(body):
            if body[at:mark.start()].strip():
                found.append(Block(page, line + body.count("\n", 0, at), body[at:mark.start()]))
            if found:
                found[-1].marks.append((mark[1], " ".join(mark[2].split())))
            at = mark.end()
        if body[at:].strip():
            found.append(Block(page, line + body.count("\n", 0, at), body[at:]))
    return found


class Table:
    """A comma-separated file with its head of comments."""

    def __init__(self, path):
        lines = path.read_text().splitlines()
        self.head = [line for line in lines if line.startswith("#")]
        self.columns, *self.rows = csv.reader(line for line in lines if line and not line.startswith("#"))

    def maker(self):
        """The command that makes the file, and whether it takes long; None without one."""
        found = next(filter(None, (re.match(r"# made by( \(long\))?: (.*)", line) for line in self.head)), None)
        return (found[2], bool(found[1])) if found else None

    def column(self, name):
        """Index of a column."""
        names = [re.sub(r" \[.*\]$", "", each) for each in self.columns]
        begin = [at for at, each in enumerate(self.columns) if each.startswith(name)]
        found = [at for at, each in enumerate(self.columns) if name in (each, names[at])] or begin
        if not found or (found == begin and len(begin) > 1 and name not in names):
            raise ValueError(f"no column, or several, are '{name}' of {', '.join(self.columns)}")
        return found[0]

    def cells(self, rows, columns):
        """Text of the cells of the chosen rows, row by row, and whether each is an error."""
        chosen = self.rows
        for each in filter(None, (rows or "").split(",")):
            name, _, values = each.partition("=")
            at, allowed = self.column(name.strip()), [value.strip() for value in values.split("|")]
            chosen = [row for row in chosen if any(same_cell(row[at], value) for value in allowed)]
        wanted = []
        for name in columns.split(","):
            before, name, behind = re.fullmatch(r"\s*(\+-\s)?(.*?)(\s\+-)?\s*", name, re.S).groups()
            at = self.column(name)
            wanted += [at + 1] if before else [at, at + 1] if behind else [at]
            if not before and not behind:
                self.refuse_unknown(chosen, at)
        if not chosen:
            raise ValueError(f"no row has {rows}")
        return [(row[at], self.columns[at].startswith("+-")) for row in chosen for at in wanted]

    def refuse_unknown(self, rows, at):
        """Raises where a figure of a column is hardly known, so that its error must stand beside it."""
        for row in rows if self.columns[at + 1:at + 2] == ["+-"] else ():
            value, error = value_of(row[at]), value_of(row[at + 1])
            if value and error is not None and abs(error) > abs(value) / 3:
                raise ValueError(f"{row[at]} is known to +- {row[at + 1]} only: write the error too")


def value_of(cell):
    """The number in a cell, or None."""
    found = NUMBER.search(cell.rstrip("*"))
    return float(found[0]) if found else None


def same_cell(cell, wanted):
    """Whether a cell is the wanted text or number."""
    number = value_of(wanted)
    return cell == wanted or (number is not None and NUMBER.fullmatch(cell) is not None and float(cell) == number)


def expected_values(mark, source):
    """(what, value, whether it is an error) of each value that a `from` mark names."""
    table, name, found = None, "", []
    for part in mark.split(";"):
        ways, signs = [], re.findall(r"\s([-+*/])\s", part)
        for term in re.split(r"\s[-+*/]\s", part):
            if NUMBER.fullmatch(term.strip()):
                ways.append([(float(term), False)])
                continue
            match = TERM.fullmatch(term.strip())
            if match["file"]:
                name = match["file"]
                table = Table(source / name if "/" in name else source / "data/reference" / name)
            if table is None:
                raise ValueError("the mark begins with the name of a file")
            cells = table.cells(match["rows"], match["columns"])
            ways.append([(value_of(cell), is_error) for cell, is_error in cells])
        if any(value is None for way in ways for value, _ in way):
            raise ValueError(f"a cell of {part.strip()} holds no number")
        values = ways[0]
        for sign, way in zip(signs, ways[1:]):
            count = max(len(values), len(way))
            values = [(SIGNS[sign](a, b), False) for (a, _), (b, _) in
                      zip(values * (count // len(values)), way * (count // len(way)))]
        found += [(f"{name}: {part.strip()}", *value) for value in values]
    return found


def shown_value(match):
    """Value of a number of the text."""
    return float(match[0].replace(",", ""))


def distance(match, value, is_error):
    """How far a number of the text is from this value, relative; None where it is not the value rounded.

    A value may not be rounded so much that another would do; an error may be rounded to a digit."""
    shown, digit = shown_value(match), last_digit(match[0].replace(",", ""))
    off, size = abs(shown - value), max(abs(value), 1e-300)
    most = (digit if digit < 1 else 0) if shown == 0 else (0.35 if is_error else 0.06) * size
    return off / size if off <= min(0.501 * digit, most) + 1e-12 * size else None


def best_places(expected, numbers):
    """Where the expected values stand among the numbers: in order, as near as can be; as many as there are."""
    ways = {-1: (0.0, [])}  # last place -> cost and places so far
    for _, value, is_error in expected:
        longer, least = {}, None
        for place, match in enumerate(numbers):
            if place - 1 in ways and (least is None or ways[place - 1][0] < least[0]):
                least = ways[place - 1]
            off = distance(match, value, is_error)
            if least is not None and off is not None:
                longer[place] = (least[0] + off, [*least[1], place])
        if not longer:
            break
        ways = longer
    return min(ways.values(), key=lambda way: way[0])[1]


def chosen_by(marks):
    """The values by which `from` marks choose rows."""
    rows = re.findall(r"\[([^\]]*=[^\]]*)\]", " ".join(content for kind, content in marks if kind == "from"))
    values = [value for each in rows for pair in each.split(",") for value in pair.partition("=")[2].split("|")]
    return {float(value) for value in values if NUMBER.fullmatch(value.strip())}


def faults_of(block, source, inputs):
    """Faults of one block, and the spans of the numbers from files; no `inputs`: a page not COVERED."""
    text, numbers = block.numbers()
    where = f"{block.page}:{block.line}"
    faults, claimed = [], set()
    named = {each for each, match in enumerate(numbers)
             if " ".join(text[match.start():].split()).startswith(inputs or ())}
    for kind, content in block.marks:
        try:
            if kind == "by":
                missing = [each for each in content.split(", ") if not (source / each).exists()]
                faults += [f"{where}: there is no {each}" for each in missing]
            expected = expected_values(content, source) if kind == "from" else []
            free = [each for each in range(len(numbers)) if each not in claimed | named]
            placed = best_places(expected, [numbers[each] for each in free])
            if len(placed) < len(expected):
                what, value, _ = expected[len(placed)]
                rest = ", ".join(numbers[each][0] for each in free[placed[-1] + 1 if placed else 0:])
                faults.append(f"{where}: {what} is {value:.6g}; the text has {rest or 'no more number'}")
            claimed |= {free[place] for place in placed}
        except (OSError, ValueError) as error:
            faults.append(f"{where}: {content}: {error}")
    tests = re.findall(r"`((?:cli|hard|law|reference|unit)/[\w/]+)`", block.text)
    missing = [each for each in tests if not (source / f"tests/{each}.cpp").exists()]
    faults += [f"{where}: there is no tests/{each}.cpp" for each in missing]
    if inputs is not None and not tests and not any(kind in ("by", "given") for kind, _ in block.marks):
        chosen = chosen_by(block.marks)
        lonely = []
        for number, match in enumerate(numbers):
            is_figure = "." in match[0].rstrip(".") or UNIT.match(text, match.end())
            is_input = shown_value(match) in chosen or number in named
            lonely += [match[0]] if number not in claimed and is_figure and not is_input else []
        faults += [f"{where}: {', '.join(lonely)}: names no source, see tests/docs/figures.py"] if lonely else []
    return faults, [numbers[i].span() for i in sorted(claimed)]


def pages_of(source):
    """Tuples of a page's name, its blocks and the inputs that it names; None in their place if it is not COVERED."""
    for page in [source / "README.md", *sorted((source / "docs").rglob("*.md"))]:
        name = page.relative_to(source).as_posix()
        blocks = blocks_of(name, page.read_text())
        marks = [text for block in blocks for kind, text in block.marks if kind == "inputs"]
        named = [value.strip() for text in marks for value in text.split(",")]
        covered = name == "README.md" or (name.startswith(COVERED) and name not in NOT_COVERED)
        yield name, blocks, tuple(named) if covered else None


def check_pages(source):
    """Faults of all pages, and how many figures come from files."""
    faults, count = [], 0
    for _, blocks, inputs in pages_of(source):
        for block in blocks:
            more, claimed = faults_of(block, source, inputs)
            faults, count = faults + more, count + len(claimed)
    return faults, count


def with_other_digit(number):
    """The number with its last digit changed by 3."""
    at = re.search(r"\d(?=\D*$)", number.partition("e")[0]).start()
    return number[:at] + str((int(number[at]) + 3) % 10) + number[at + 1:]


def control(source):
    """Figures of pages and files that can be changed without a fault."""
    missed, count = [], 0
    for name, blocks, inputs in pages_of(source):
        for block in blocks:
            right = block.text
            for begin, end in faults_of(block, source, inputs)[1]:
                block.text = right[:begin] + with_other_digit(right[begin:end]) + right[end:]
                count += 1
                if not faults_of(block, source, inputs)[0]:
                    missed.append(f"{name}:{block.line}: {right[begin:end]} may become {block.text[begin:end]}")
            block.text = right
    for path in sorted((source / "data/reference").glob("*.csv")):
        table = Table(path)
        right = [table.columns, *table.rows]
        moved = [[NUMBER.sub(lambda m: repr(3 * float(m[0]) + 1), cell) for cell in row] for row in right[1:]]
        wrong = {"its own rows": (right, False), "other figures": ([right[0], *moved], True),
                 "a missing row": (right[:-1], True), "another column": ([["x", *right[0][1:]], *right[1:]], True)}
        for what, (rows, is_wrong) in wrong.items() if table.maker() else ():
            count += 1
            missed += [f"{path.name}: {what}"] if bool(differences(path.name, table, rows)) != is_wrong else []
    return missed, count


def numbers_agree(old, new, error):
    """Whether two cells have the same words, and numbers that agree; `error` is the text beside the old one."""
    if NUMBER.sub("", old) != NUMBER.sub("", new):
        return False
    inner = re.search(r"\+- (\S+)", old)
    far = max(value_of(error or "0") or 0, float(inner[1]) if inner else 0)
    return all(abs(float(a[0]) - float(b[0])) <= max(1.001 * max(last_digit(a[0]), last_digit(b[0])), far)
               for a, b in zip(NUMBER.finditer(old), NUMBER.finditer(new)))


def fresh_faults(path, program, source):
    """What a file and the program's fresh answer differ in; None where the file takes too long."""
    table = Table(path)
    command, is_long = table.maker()
    if is_long and not os.environ.get("HDCONJ_LONG"):
        return None
    words = [program if word == "PROGRAM" else word for word in shlex.split(command)]
    done = subprocess.run([sys.executable, *words], cwd=source, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode:
        return [f"{path.name}: status {done.returncode} of {command}"]
    lines = [line for line in done.stdout.splitlines() if line and not line.startswith("#")]
    return differences(path.name, table, list(csv.reader(lines)))


def differences(name, table, new):
    """What the rows of a stored table and fresh ones differ in, heads included."""
    old = [table.columns, *table.rows]
    if len(old) != len(new) or any(len(a) != len(b) for a, b in zip(old, new)):
        return [f"{name}: {len(new)} fresh rows, {len(old)} stored; or their columns differ"]
    faults = []
    for a, b in zip(old, new):
        for at, (left, right) in enumerate(zip(a, b)):
            beside = a[at + 1] if at + 1 < len(a) and old[0][at + 1].startswith("+-") else ""
            is_error = old[0][at].startswith("+-")
            near = is_error and value_of(left) and 0.5 <= (value_of(right) or 0) / value_of(left) <= 2
            if not near and not numbers_agree(left, right, beside):
                faults.append(f"{name}: {old[0][at]} of {', '.join(a[:2])}: stored {left}, fresh {right}")
    return faults


def main(arguments):
    """Runs what the arguments ask for; the exit status."""
    if not arguments:
        sys.exit(__doc__)
    source = Path(arguments[0]).resolve()
    if "--control" in arguments:
        faults, count = control(source)
        print(f"{count} figures changed, {len(faults)} changes not caught")
    elif "--fresh" in arguments:
        program, faults = str(Path(arguments[2]).resolve()), []
        for path in sorted((source / "data/reference").glob("*.csv")):
            if Table(path).maker():
                found = fresh_faults(path, program, source)
                print(f"{path.name}: {'takes long, not made' if found is None else len(found)}", flush=True)
                faults += found or []
    else:
        faults, count = check_pages(source)
        print(f"{count} figures of the pages come from files")
    print("\n".join(faults))
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
