#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules on the size of things and on names, one function per rule.

  shape.py SOURCE_DIR   check the sources
  shape.py --control    check the check: a tree made to break each rule must be caught

Exceptions stand in tests/house/exceptions.txt, one a line: rule, place, reason. An exception that no fault needs any
more is a fault itself.
"""
import re
import shutil
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

from layers import INCLUDE, reached_from, read_rules, resolve, room_of
from sources import CODE, files, main, without_comments

LONGEST_FUNCTION = 60  # lines from its opening to its closing brace
LONGEST_FILE = 299
LONGEST_LINE = 120
LONGEST_MARKDOWN_LINE = 100
LONG_CODE = 60
FULLEST_FOLDER = 36  # files
OURS = ("include", "src", "apps")
TYPE = re.compile(r"\b(?:class|struct|union|enum(?: class| struct)?)\s+(\w+)\s*(?:final\s*)?(?::[^:]|$)")
NO_FUNCTION = {"if", "for", "while", "switch", "catch", "return", "sizeof", "decltype", "alignas", "noexcept",
               "requires", "static_assert", "defined", "operator"}


def cpp(root, folders=OURS):
    for path, name in files(root):
        if path.suffix in (".hpp", ".cpp") and name.split("/")[0] in folders:
            yield path, name


def exceptions(root, rule):
    """{place: reason} of one rule."""
    listed = root / "tests" / "house" / "exceptions.txt"
    rows = [line.split(None, 2) for line in (listed.read_text().splitlines() if listed.is_file() else [])
            if line.strip() and not line.startswith("#")]
    return {row[1]: row[2] for row in rows if len(row) == 3 and row[0] == rule}


def except_named(root, rule, faults):
    """The faults [(place, message)] whose place is no exception, and the exceptions that no fault needs."""
    allowed = exceptions(root, rule)
    places = {place for place, _ in faults}
    return ([message for place, message in faults if place not in allowed] +
            [f"exceptions.txt: {rule} {place} is no fault any more" for place in allowed if place not in places])


class Scanner:
    """Reads C++ text as a tree of braces and notes namespaces, types, functions and declarations at namespace scope.

    It knows no more of the grammar than our own format needs: what stands before a brace says what the brace opens.
    """

    def __init__(self, text):
        text = re.sub(r"'(?:\\.|[^'\\\n])'", "0", without_comments(text))
        text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.M)  # directives
        self.namespaces = []  # (line, full name)
        self.functions = []  # (line, name, lines from { to })
        self.declared = []  # (line, full namespace, kind, name, whether defined)
        head, head_line, line, depth = "", 1, 1, 0
        open_braces = []  # (kind, name, line, head before)
        for c in text:
            if c == "\n":
                line += 1
            if c == "(":
                depth += 1
            elif c == ")":
                depth -= 1
            if c == "{" and depth == 0:
                kind, name = self.opened(head, open_braces)
                if kind == "namespace":
                    self.namespaces.append((line, self.where(open_braces, name)))
                elif kind in ("type", "function"):
                    self.declare(open_braces, head_line, kind, name, True)
                open_braces.append((kind, name, line, head))
                head = head + "{" if kind == "value" else ""
            elif c == "}" and depth == 0 and open_braces:
                kind, name, first, before = open_braces.pop()
                if kind == "function":
                    self.functions.append((first, name, line - first + 1))
                head = before + "{}" if kind == "value" else ";" if kind == "type" else ""
            elif c == ";" and depth == 0:
                self.declaration(open_braces, head_line, head)
                head = ""
            else:
                if not head.strip():
                    head_line = line
                head += c

    @staticmethod
    def plain(head):
        """The head without attributes, template parameters and labels of access."""
        head = re.sub(r"\[\[.*?\]\]|\b(?:public|private|protected)\s*:(?!:)|^;", " ", head.strip(), flags=re.S)
        head = re.sub(r"\boperator\s*([^\s\w(]+|\(\s*\)|\w+)\s*(?=\()", lambda m: "operator_" + str(len(m[1])), head)
        while True:  # innermost <...> first
            shorter = re.sub(r"<[^<>(){};=]*(?:=[^<>(){};]*)?>", "", head)
            if shorter == head:
                return " ".join(head.split())
            head = shorter

    def opened(self, head, open_braces):
        if any(kind in ("function", "value") for kind, *_ in open_braces):
            return "inner", ""
        plain = self.plain(head)
        match = re.match(r"(?:inline )?namespace\b\s*([\w:]*)$", plain)
        if match:
            return "namespace", match[1] or "{anonymous}"
        if plain.startswith('extern'):
            return "namespace", ""
        name = self.function_name(plain)
        if name:
            return "function", name
        match = TYPE.search(plain)
        if match and "(" not in plain.replace("alignas(", ""):
            return "type", match[1]
        return "value", ""

    @staticmethod
    def function_name(plain):
        """The name of the function that a head declares, or nothing: an initialiser, say."""
        depth, before = 0, ""
        for c in plain:  # before the first parenthesis
            if c == "(":
                break
            before += c
        else:
            return ""
        if re.search(r"(?<![=!<>])=(?!=)", before):
            return ""
        match = re.search(r"(~?[\w:~]+)\s*$", before)
        if not match or match[1] in NO_FUNCTION:
            return ""
        rest = plain[len(before):]
        for end, c in enumerate(rest):
            depth += (c == "(") - (c == ")")
            if depth == 0:
                break
        rest = rest[end + 1:].strip()
        if rest.startswith(":") and not re.search(r"[\)}]\s*$", rest):
            return ""  # `a{` in a list of member initialisers
        return match[1]

    @staticmethod
    def where(open_braces, *more):
        names = [name for kind, name, *_ in open_braces if kind == "namespace" and name] + [m for m in more if m]
        return "::".join(names)

    def declare(self, open_braces, line, kind, name, defined):
        if all(k == "namespace" for k, *_ in open_braces):
            self.declared.append((line, self.where(open_braces), kind, name, defined))

    def declaration(self, open_braces, line, head):
        if not all(kind == "namespace" for kind, *_ in open_braces):
            return
        plain = self.plain(head)
        if re.match(r"(?:using|typedef|extern template|template|friend|static_assert)\b",
                    plain.replace("template ", "", 1)):
            match = re.match(r"using (\w+) =", plain)
            if match:
                self.declare(open_braces, line, "type", match[1], True)
            return
        match = re.match(r"(?:class|struct|union|enum(?: class)?) (\w+)(?: : [\w:]+)?$", plain)
        if match:
            self.declare(open_braces, line, "type", match[1], False)
        else:
            name = self.function_name(plain)
            if name:
                self.declare(open_braces, line, "function", name, False)


def scanned(root, cache={}):
    """{name: Scanner} of each C++ file of ours."""
    if root not in cache:
        cache.clear()
        cache[root] = {name: Scanner(path.read_text()) for path, name in cpp(root)}
    return cache[root]


def short_functions(root):
    """No function is longer than a screen."""
    faults = []
    for name, scanner in scanned(root).items():
        for line, function, length in scanner.functions:
            if length > LONGEST_FUNCTION:
                faults.append((f"{name}:{function}", f"{name}:{line}: {function} has {length} lines"))
    return except_named(root, "function", faults)


def short_files(root):
    """No file is long without a reason, which a line `// Long: ...` among its first twenty gives."""
    faults = []
    for path, name in cpp(root):
        lines = path.read_text().splitlines()
        if len(lines) > LONGEST_FILE and not any(re.match(r"//+ Long: \w", line) for line in lines[:20]):
            faults.append(f"{name}: has {len(lines)} lines and no line // Long: <reason> in its head")
    return faults


def short_lines(root):
    """No line of a program is wider than the format allows; scripts that draw the docs are free."""
    faults = []
    for path, name in files(root):
        if name.split("/")[0] != "docs" and (path.suffix in CODE or path.name in ("CMakeLists.txt", "run")):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                if len(line) > LONGEST_LINE and not re.search(r"https?://\S{60}", line):
                    faults.append((f"{name}:{number}", f"{name}:{number}: has {len(line)} columns"))
    return except_named(root, "line", faults)


def markdown_lines(root):
    """Prose keeps to a width that can be read in a terminal; tables, code, links and pictures are as wide as they
    are."""
    faults = []
    for path, name in files(root):
        if path.suffix != ".md":
            continue
        code = False
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if line.lstrip().startswith(("```", "~~~")):
                code = not code
            elif (not code and len(line) > LONGEST_MARKDOWN_LINE and not line.lstrip().startswith(("|", "<", "#", "!["))
                  and " " in line.lstrip(" >*-0123456789.")[:LONGEST_MARKDOWN_LINE]
                  and not re.search(r"\]\(\S+\)|https?://", line) and not line.startswith("    ")
                  and all(len(span) < LONG_CODE for span in re.findall("`([^`]*)`", line))):
                faults.append(f"{name}:{number}: has {len(line)} columns")
    return faults


def small_folders(root):
    """No folder holds more files than one overlooks."""
    count = defaultdict(int)
    for path, name in files(root):
        if name.split("/")[0] in OURS + ("tests", "cmake", "docs"):
            count[path.parent.relative_to(root).as_posix()] += 1
    faults = [(folder, f"{folder}: holds {number} files") for folder, number in count.items()
              if number > FULLEST_FOLDER]
    return except_named(root, "folder", faults)


def clang_format_14():
    """Name of that program; None where there is none, or one of another version, which formats otherwise."""
    for name in ("clang-format-14", "clang-format"):
        if shutil.which(name):
            said = subprocess.run([name, "--version"], capture_output=True, text=True).stdout
            return name if "version 14." in said else None
    return None


def formatted(root):
    """clang-format 14 would change nothing."""
    program = clang_format_14()
    if not (root / ".clang-format").is_file() or not program:
        return []
    names = [path for path, _ in cpp(root, OURS + ("tests",))]
    result = subprocess.run([program, "--dry-run", "-Werror", "--style=file", *names], capture_output=True, text=True)
    found = re.finditer(r"^(\S+?):\d+:\d+: error:", result.stderr, re.M)
    bad = {Path(m[1]).relative_to(root).as_posix() for m in found}
    return [f"{name}: clang-format would change it" for name in sorted(bad)]


def rooms(root):
    """Rooms, and which room a public header belongs to."""
    table = root / "cmake" / "layers.txt"
    known, public, _, _ = read_rules(table) if table.is_file() else ({}, {}, {}, [])
    return known, public


def public_names(root):
    """Names that the headers for users declare in namespace hdconj."""
    return {declared[3] for name, scanner in scanned(root).items() if re.fullmatch(r"include/hdconj/\w+\.hpp", name)
            for declared in scanner.declared if declared[1] == "hdconj"}


def namespaces_follow_folders(root):
    """Headers for users and the room base speak in hdconj, each other room in hdconj::<room>, apps in hdconj::cli.

    A room defines in hdconj only what a header for users declares there, and declares other rooms' types at most.
    """
    _, public = rooms(root)
    users, faults = public_names(root), []
    for name, scanner in scanned(root).items():
        room = room_of(Path(name), public)
        home = "hdconj::cli" if room == "apps" else f"hdconj::{room}"
        for line, namespace, kind, declared, defined in scanner.declared:
            space = re.sub(r"(?:::|^)\{anonymous\}.*", "", namespace)
            free = room == "base" or re.fullmatch(r"include/hdconj/\w+\.hpp", name)
            inside = (space + "::").startswith(home + "::") or (free and space == "hdconj")
            forward = kind == "type" and not defined
            outside = space.split("::")[0] in ("std", "fmt", "Eigen", "H5")
            facade = space == "hdconj" and declared.split("::")[0] in users
            local = namespace.startswith("{anonymous}") or namespace == "" and declared in ("main",)
            hidden = space != namespace and space in ("hdconj",)
            if not (inside or forward or outside or facade or local or hidden):
                faults.append((f"{name}:{declared}",
                               f"{name}:{line}: {declared} is declared in {space or 'no namespace'}, not in {home}"))
    return except_named(root, "namespace", faults)


def one_room_per_name(root):
    """No type and no function at namespace scope has the name of one in another room."""
    _, public = rooms(root)
    homes = defaultdict(dict)
    for name, scanner in scanned(root).items():
        room = room_of(Path(name), public)
        for line, namespace, kind, declared, defined in scanner.declared:
            forward = kind == "type" and not defined
            if "{anonymous}" in namespace or forward or "::" in declared or not namespace.startswith("hdconj"):
                continue
            if name.endswith(".cpp") and namespace == "hdconj":
                continue  # the definition of what a header for users declares
            if "operator" not in declared:
                homes[declared].setdefault(room, f"{name}:{line}")
    faults = [(declared, f"{declared} is a name in several rooms: {', '.join(sorted(places.values()))}")
              for declared, places in homes.items() if len(places) > 1]
    return except_named(root, "name", faults)


def declared_names(root):
    """{full name of ours: headers that declare it}: types, functions and constants at namespace scope."""
    names = defaultdict(set)
    constant = re.compile(r"^(?:inline )?constexpr [^=;({]*?(\w+)(?:\[\])?(?: =|\{)", re.M)
    for name, scanner in scanned(root).items():
        if name.endswith(".hpp"):
            for _, namespace, _, declared, _ in scanner.declared:
                if namespace.startswith("hdconj") and "{anonymous}" not in namespace and "::" not in declared:
                    names[f"{namespace}::{declared}"].add(name)
            if scanner.namespaces:
                for declared in constant.findall((root / name).read_text()):
                    names[f"{scanner.namespaces[0][1]}::{declared}"].add(name)
    return names


def candidates(qualifier, word, room):
    """Full names that a name in the text of a room may stand for: types, and whatever is qualified."""
    if not qualifier:
        return [f"hdconj::{room}::{word}", f"hdconj::{word}"] if word[0].isupper() else []
    if qualifier.startswith("std::") or qualifier.split("::")[-2][:1].isupper():  # a member of a type
        return []
    full = qualifier if qualifier.startswith("hdconj::") else f"hdconj::{qualifier}"
    return [f"{full}{word}", f"hdconj::{room}::{qualifier}{word}"]


def includes_what_it_uses(root):
    """Each file includes what declares the names of ours that it uses, itself or by what it includes.

    With HDCONJ_UNITY the compiler does not see that: what another source included serves as well.
    """
    _, public = rooms(root)
    names = declared_names(root)
    graph = {path: [found for kind, target in INCLUDE.findall(path.read_text()) if kind == '"'
                    for found in [resolve(root, path, target)] if found] for path, _ in cpp(root)}
    faults = set()
    for path, name in cpp(root):
        room = room_of(Path(name), public)
        reached = {file.relative_to(root).as_posix() for file in reached_from(path, graph)} | {name}
        text = re.sub(r"^\s*#.*$", "", without_comments(path.read_text()), flags=re.M)
        for qualifier, word in re.findall(r"(?<![\w.:>])((?:\w+::)*)(\w+)\b", text):
            full = next((c for c in candidates(qualifier, word, room) if c in names), None)
            if full and not names[full] & reached:
                faults.add(f"{name}: uses {full} without {' or '.join(sorted(names[full]))}")
    return sorted(faults)


def tests_mirror_rooms(root):
    """Unit tests lie in folders that are named as the rooms that they test."""
    known, _ = rooms(root)
    folders = {name.split("/")[2] for _, name in files(root) if re.match(r"tests/unit/\w+/", name)}
    strays = {name for _, name in files(root) if re.fullmatch(r"tests/unit/[^/]+\.cpp", name)}
    return ([f"tests/unit/{folder}: there is no room of that name" for folder in sorted(folders - set(known))] +
            [f"{name}: is in no room's folder" for name in sorted(strays)])


RULES = (short_functions, short_files, short_lines, markdown_lines, small_folders, formatted,
         namespaces_follow_folders, one_room_per_name, includes_what_it_uses,
         tests_mirror_rooms)

SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
GOOD = {
    "cmake/layers.txt": "room base:\nroom low: base\nroom high: low\npublic face: high\n",
    ".clang-format": "DisableFormat: true\n",
    "include/hdconj/face.hpp": SPDX + "namespace hdconj {\nstruct Face {\n    int a = 1;\n};\nFace make(int);\n}\n",
    "src/high/make.cpp": SPDX + '#include "hdconj/face.hpp"\n'
                         "namespace hdconj {\nFace make(int) {\n    return {};\n}\n}\n",
    "src/low/a.hpp": SPDX + "namespace hdconj::high {\nstruct B;\n}\n\nnamespace hdconj::low {\n"
                     "template <class T>\nvoid low_a(T = {}) {}\n"
                     "struct A {\n    A() : a{1}, b{2} {}\n    int a, b;\n};\n}\n",
    "src/high/b.hpp": SPDX + "namespace hdconj::high {\nstruct B {};\nint high_b();\n}\n",
    "README.md": "Short.\n\n| " + "wide " * 30 + "|\n",
}


def body(lines):
    return "{\n" + "    a();\n" * (lines - 2) + "}\n"


BREAKS = [
    (short_functions, {"src/low/f.cpp": SPDX + "namespace hdconj::low {\nvoid f() " + body(61) + "}\n"}),
    (short_functions, {"src/low/f.cpp": SPDX + "namespace hdconj::low {\nstruct S {\n    S() : a{1}, b(2) " +
                       body(61).replace("\n", "\n    ") + "int a, b;\n};\n}\n"}),
    (short_functions, {"tests/house/exceptions.txt": "function src/low/a.hpp:A is not long\n"}),
    (short_files, {"src/low/f.hpp": SPDX + "\n" * 299}),
    (short_lines, {"src/low/f.hpp": SPDX + "// " + "a" * 118 + "\n"}),
    (markdown_lines, {"docs/a.md": "word " * 21 + "\n"}),
    (small_folders, {f"docs/{i}.txt": "\n" for i in range(37)}),
    (namespaces_follow_folders, {"src/low/f.hpp": SPDX + "namespace hdconj {\nint low_f();\n}\n"}),
    (namespaces_follow_folders, {"src/low/f.hpp": SPDX + "namespace hdconj::high {\nint low_f();\n}\n"}),
    (namespaces_follow_folders, {"src/low/f.hpp": SPDX + "int low_f();\n"}),
    (one_room_per_name, {"src/high/f.hpp": SPDX + "namespace hdconj::high {\nint low_a();\n}\n"}),
    (one_room_per_name, {"src/high/f.hpp": SPDX + "namespace hdconj::high {\nstruct A {};\n}\n"}),
]
BREAKS += [
    (includes_what_it_uses, {"src/low/f.hpp": SPDX + "namespace hdconj::low {\nusing C = low::A;\n}\n"}),
    (includes_what_it_uses, {"src/high/f.cpp": SPDX + "namespace hdconj::high {\nFace a;\n}\n"}),
    (tests_mirror_rooms, {"tests/unit/attic/a.cpp": SPDX}),
    (tests_mirror_rooms, {"tests/unit/a.cpp": SPDX}),
]
if clang_format_14():
    BREAKS.append((formatted, {".clang-format": "BasedOnStyle: Google\n",
                               "src/low/f.hpp": SPDX + "// a\n  // b\n"}))

if __name__ == "__main__":
    main(RULES, GOOD, BREAKS)
