#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules that hold for each file of the project, one function per rule.

  sources.py SOURCE_DIR   check the sources
  sources.py --control    check the check: a file made to break each rule must be caught
"""
import os
import re
import sys
import tempfile
from pathlib import Path

CODE = (".hpp", ".cpp", ".py", ".cmake", ".sh")
OTHER_TEXT = (".toml", ".txt", ".md", ".json", ".in", ".yml", ".yaml", ".csv")
EDGES = ("src/io/", "src/file/", "src/figures/", "src/report/")  # rooms that write and do not compute
SKIPPED = {".git", "build", "out", "__pycache__", ".cache", "third_party"}


def files(root):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(each for each in folders if each not in SKIPPED and not each.startswith("build-"))
        for path in (Path(folder) / name for name in sorted(names)):
            if path.is_file():
                yield path, path.relative_to(root).as_posix()


def without_comments(text):
    """C++ text with comments and strings blanked, lines kept."""
    pattern = r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"'
    return re.sub(pattern, lambda m: "\n" * m.group().count("\n"), text, flags=re.S)


def licence(root):
    """Each source file names its licence in its first lines."""
    faults = []
    for path, name in files(root):
        if path.suffix in CODE or path.name in ("CMakeLists.txt", "run"):
            if not any("SPDX-License-Identifier: GPL-3.0-or-later" in line for line in
                       path.read_text(errors="replace").splitlines()[:3]):
                faults.append(f"{name}: no SPDX line among its first three")
    return faults


def machine_paths(root):
    """No file names a place that exists on one machine only. (The patterns are written so as not to match here.)"""
    pattern = re.compile(r"(?<![\w.$}>)*])/(?:[h]ome|[r]oot|[U]sers|[w]ork|[m]nt|[o]pt)/|\b[A-Z]:\\\w")
    faults = []
    for path, name in files(root):
        if path.suffix in CODE + OTHER_TEXT or path.name in ("CMakeLists.txt", "run"):
            for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
                if pattern.search(line):
                    faults.append(f"{name}:{number}: path of one machine: {line.strip()}")
    return faults


def listed(root):
    """Each .cpp below src/, apps/ and tests/ stands in the CMakeLists.txt of its folder or of one above."""
    faults = []
    for path, name in files(root):
        if path.suffix != ".cpp" or name.split("/")[0] not in ("src", "apps", "tests"):
            continue
        for folder in path.parents:
            lists = folder / "CMakeLists.txt"
            if lists.is_file():
                text = re.sub(r"#.*", "", lists.read_text())
                relative = path.relative_to(folder).as_posix()
                if re.search(rf'(?<![\w./-]){re.escape(relative)}(?![\w./-])', text):
                    break
            if folder == root:
                faults.append(f"{name}: is in no CMake list, so nothing compiles it")
                break
    return faults


def tolerances(root):
    """No bare small number in the numerics: a tolerance has a name and a reason.

    That is: `constexpr double name = 1e-9;` with a comment on that line or the one before. The exceptions stand in
    tests/house/small_numbers.txt: file, number, reason. An exception that is not needed any more is a fault as well.
    """
    named = re.compile(r"^\s*(?:inline |static )*constexpr double \w+ = [\d.]+e-\d+;", re.I)
    exceptions, faults = {}, []
    allowed = root / "tests" / "house" / "small_numbers.txt"
    for line in allowed.read_text().splitlines() if allowed.is_file() else []:
        if line.strip() and not line.startswith("#"):
            name, number, reason = (line.split(None, 2) + ["", ""])[:3]
            exceptions[name, number] = False
            if not reason:
                faults.append(f"small_numbers.txt: {name} {number} has no reason")
    for path, name in files(root):
        numeric = name.startswith(("include/", "src/")) and not name.startswith(EDGES)
        if path.suffix not in (".hpp", ".cpp") or not numeric:
            continue
        text = path.read_text()
        commented = [""] + text.splitlines()
        for number, line in enumerate(without_comments(text).splitlines(), 1):
            if named.match(line) and any("//" in near for near in commented[number - 1:number + 1]):
                continue
            for small in re.findall(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)[eE]-\d+", line):
                if (name, small) in exceptions:
                    exceptions[name, small] = True
                else:
                    faults.append(f"{name}:{number}: bare {small}: name it and say where it comes from")
    faults += [f"small_numbers.txt: {name} has no {number} any more"
               for (name, number), used in exceptions.items() if not used]
    return faults


def test_names(root):
    """No test case is named so that ctest cannot run it: Catch2 takes "-..." for an option, CMake ";" for two names."""
    faults = []
    for path, name in files(root):
        if path.suffix == ".cpp" and name.startswith("tests/"):
            text = path.read_text()
            titles = re.findall(r'TEST_CASE\(\s*"([^"]*)"', text)
            titles += [" | ".join(row) for row in re.findall(r'HARD_ROW\(\s*"([^"]*)",\s*"([^"]*)",\s*"([^"]*)"', text)]
            for title in titles:
                if title.startswith("-") or ";" in title:
                    faults.append(f'{name}: ctest cannot run a test case named "{title}"')
    return faults


def guarded(root):
    """Each header is guarded, by `#pragma once` before its first include."""
    faults = []
    for path, name in files(root):
        if path.suffix == ".hpp":
            directives = re.findall(r"^#\s*(\w+ ?\w*)", without_comments(path.read_text()), flags=re.M)
            if not directives or directives[0] != "pragma once":
                faults.append(f"{name}: its first directive is not #pragma once")
    return faults


def merged(root):
    """No file has a conflict of versions left in it."""
    return [f"{name}:{number}: a conflict of versions" for path, name in files(root)
            if path.suffix in CODE + OTHER_TEXT or path.name in ("CMakeLists.txt", "run")
            for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1)
            if re.match(r"(?:<{7}|>{7}|\|{7}) |={7}$", line) and not path.suffix == ".md"]


def pointers(root):
    """A file of ours that a page names in backticks is there."""
    named = re.compile(r"`((?:apps|cmake|data|docs|include|src|tests)/[a-z0-9_./-]+\."
                       r"(?:[ch]pp|py|txt|toml|csv|md|sh|cmake))`")
    return [f"{name}: there is no {file}" for path, name in files(root) if path.suffix == ".md"
            for file in named.findall(path.read_text()) if not (root / file).exists()]


def matchers(root):
    """Names that the two versions of Catch2 have in different places come from tests/support/catch.hpp alone."""
    pattern = re.compile(r"\bCatch::(?!getResultCapture)\w+")
    return [f"{name}:{number}: {found[0]} is not in both versions of Catch2: take it from support/catch.hpp"
            for path, name in files(root) if path.suffix in (".cpp", ".hpp") and name.startswith("tests/")
            for number, line in enumerate(without_comments(path.read_text()).splitlines(), 1)
            if (found := pattern.search(line)) and not name.startswith("tests/support/catch")]


RULES = (licence, machine_paths, merged, pointers, listed, tolerances, test_names, guarded, matchers)

SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
GOOD = {
    "src/CMakeLists.txt": "# SPDX-License-Identifier: GPL-3.0-or-later\nset(a\n  a/x.cpp)\n",
    "src/a/x.cpp": SPDX + '// 1e-9 in a comment, "1e-9" /* 1e-9 */\nchar const* s = "1e-9 // no";\ndouble h = 1e9;\n'
                   "// roundings of the sum\nconstexpr double tiny = 1e-9;\n",
}
LISTS = {"tests/CMakeLists.txt": GOOD["src/CMakeLists.txt"]}
BREAKS = [
    (licence, {"include/a.hpp": "#pragma once\nint a;\n"}),
    (guarded, {"include/a.hpp": SPDX + "int a;\n"}),
    (guarded, {"include/a.hpp": SPDX + "#include <cmath>\n#pragma once\n"}),
    (merged, {"src/b.hpp": SPDX + "#pragma once\n" + "<" * 7 + " mine\n" + ">" * 7 + " theirs\n"}),
    (pointers, {"README.md": "see `src/a/gone.cpp`\n"}),
    (machine_paths, {"README.md": "see /" + "home/me/file\n"}),
    (listed, {"src/a/y.cpp": SPDX}),
    (listed, {"src/x.cpp": SPDX}),
    (listed, {"src/a/y.cpp": SPDX, "src/CMakeLists.txt": GOOD["src/CMakeLists.txt"] + "# a/y.cpp\n"}),
    (tolerances, {"src/a/x.cpp": SPDX + "double const h = 2.5e-9;\n"}),
    (tolerances, {"src/a/x.cpp": SPDX + "int i;\nconstexpr double h = 1e-9;\n"}),
    (tolerances, {"src/a/x.cpp": SPDX + "// why\nif (a < 1e-9)\n"}),
    (test_names, LISTS | {"tests/a/x.cpp": SPDX + 'TEST_CASE("--set")\n'}),
    (test_names, LISTS | {"tests/a/x.cpp": SPDX + 'HARD_ROW("a", "b", "right; exact")\n'}),
    (matchers, LISTS | {"tests/x.hpp": SPDX + "#pragma once\nauto m = Catch::Contains(a);\n"}),
    (tolerances, {"tests/house/small_numbers.txt": "src/a/x.cpp 1e-9 not there\n"}),
]


def control(rules, good, breaks):
    """Each break must be caught by its rule and by no other; the good tree passes them all."""
    failures = []
    for rule, broken in [(None, {})] + breaks:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, text in (good | broken).items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            for other in rules:
                found = other(root)
                if bool(found) != (other is rule):
                    failures.append(f"{other.__name__} on {sorted(broken)}: {found or 'found nothing'}")
    return failures, len(breaks)


def check(rules, root):
    found = [fault for rule in rules for fault in rule(root)]
    return found, sum(1 for _ in files(root))


def main(rules, good, breaks):
    itself = sys.argv[1] == "--control"
    faults, count = control(rules, good, breaks) if itself else check(rules, Path(sys.argv[1]).resolve())
    print(*faults, sep="\n")
    print(f"{count} looked at, {len(faults)} faults")
    sys.exit(1 if faults or count == 0 else 0)


if __name__ == "__main__":
    main(RULES, GOOD, BREAKS)
