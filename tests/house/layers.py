#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks every #include against cmake/layers.txt, and whether the headers of std that a file needs are included.

  layers.py SOURCE_DIR    check the sources
  layers.py --control     check the check: sources made to break each rule must be caught
"""
import re
import sys
import tempfile
from pathlib import Path

from sources import without_comments

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)


def read_rules(path):
    rooms, public, outside, faults = {}, {}, {}, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        kind, _, rest = line.partition(" ")
        name, _, names = rest.partition(":")
        known = [n for n in names.split() if n not in rooms]
        if kind == "room":
            # Only rooms above: so the graph cannot have a cycle.
            faults += [f"layers.txt:{number}: room {name} names {n}, which is not above it" for n in known]
            rooms[name.strip()] = set(names.split())
        elif kind == "public":
            faults += [f"layers.txt:{number}: public headers of the unknown room {names.strip()}"
                       for _ in [0] if names.strip() not in rooms]
            public |= {header + ".hpp": names.strip() for header in name.split()}
        elif kind == "outside":
            faults += [f"layers.txt:{number}: {name} names the unknown room {n}" for n in known]
            outside[name.strip()] = set(names.split())
        else:
            faults.append(f"layers.txt:{number}: neither room, public nor outside: {line}")
    return rooms, public, outside, faults


def room_of(path, public):
    """Room of a path relative to the source folder: include/hdconj/<room>/..., src/<room>/..., apps/..., or a public
    header."""
    parts = path.parts
    if parts[0] == "apps":
        return "apps"
    first = 2 if parts[:2] == ("include", "hdconj") else 1
    if len(parts) > first + 1:
        return parts[first]
    return public.get(parts[first]) if first == 2 else None


def resolve(root, source, target):
    """The file of ours that an #include names, or None."""
    for candidate in (source.parent / target, root / "include" / target, root / "src" / target):
        if candidate.is_file() and candidate.resolve().is_relative_to(root):
            return candidate.resolve()
    return None


def standard_names():
    """{name in std: header}."""
    table = (Path(__file__).parent / "standard_names.txt").read_text()
    rows = [line.split(":") for line in table.splitlines() if not line.startswith("#")]
    return {name: header for header, names in rows for name in names.split()}


def missing_standard(path, text, reached, headers):
    """Headers of std that a file needs, and that neither it nor what it includes of ours includes.

    A precompiled header would hide that; and what Eigen or fmt happen to include is nobody's promise.
    """
    used = {name for name in re.findall(r"\bstd::(\w+)", without_comments(text)) if name in headers}
    included = {target for file in reached | {path} for kind, target in INCLUDE.findall(file.read_text())
                if kind == "<"}
    return sorted((headers[name], name) for name in used if headers[name] not in included)


def reached_from(path, graph):
    """What a file includes of ours, and what that includes."""
    reached, waiting = set(), list(graph.get(path, []))
    while waiting:
        file = waiting.pop()
        if file not in reached:
            reached.add(file)
            waiting += graph.get(file, [])
    return reached


def find_cycle(graph):
    """One cycle of a graph {node: [nodes]}, or []."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return []
        path.append(node)
        for following in graph.get(node, []):
            cycle = visit(following)
            if cycle:
                return cycle
        path.pop()
        done.add(node)
        return []

    for node in graph:
        cycle = visit(node)
        if cycle:
            return cycle
    return []


def check(root):
    """All faults below root, and the number of includes looked at."""
    root = root.resolve()
    rooms, public, outside, faults = read_rules(root / "cmake" / "layers.txt")
    graph, looked_at = {}, 0
    sources = sorted(p for folder in ("include", "src", "apps") for p in (root / folder).rglob("*")
                     if p.suffix in (".hpp", ".cpp", ".h", ".in"))
    for source in sources:
        name = source.relative_to(root)
        room = room_of(name, public)
        if room not in rooms:
            faults.append(f"{name}: is in no room of cmake/layers.txt")
            continue
        text = source.read_text()
        graph[source] = []
        for match in INCLUDE.finditer(text):
            looked_at += 1
            place = f"{name}:{text.count(chr(10), 0, match.start()) + 1}"
            target = match.group(2)
            ours = resolve(root, source, target)
            if ours is not None:
                graph[source].append(ours)
                other = room_of(ours.relative_to(root), public)
                if other != room and other not in rooms[room]:
                    faults.append(f"{place}: room {room} must not include room {other} ({target})")
                continue
            if target.startswith("hdconj/"):
                faults.append(f"{place}: there is no {target}")
            for beginning, allowed in outside.items():
                if not target.startswith(beginning):
                    continue
                if name.parts[0] == "include":
                    faults.append(f"{place}: {target} must not appear in include/")
                elif room not in allowed:
                    faults.append(f"{place}: room {room} must not include {target}")
    headers = standard_names()
    for source in graph:
        faults += [f"{source.relative_to(root)}: uses std::{name} without <{header}>" for header, name in
                   missing_standard(source, source.read_text(), reached_from(source, graph), headers)]
    cycle = find_cycle(graph)
    if cycle:
        faults.append("cycle: " + " -> ".join(str(p.relative_to(root)) for p in cycle))
    return faults, looked_at


def control():
    """Each rule, broken once, must be reported; the same tree without the breaks must pass."""
    rules = "room low:\nroom high: low\npublic face: high\noutside hidden/: high\noutside Eigen/src:\n"
    good = {
        "include/hdconj/low/a.hpp": "#include <vector>\n",
        "include/hdconj/high/b.hpp": '#include "hdconj/low/a.hpp"\n',
        "src/high/b.cpp": '#include "hdconj/high/b.hpp"\n#include <hidden/x.h>\n#include "private.hpp"\n',
        "src/high/private.hpp": "",
        "include/hdconj/face.hpp": '#include "hdconj/low/a.hpp"\n',
    }
    breaks = {
        "room low must not include room high": {"src/low/c.cpp": '# include "hdconj/high/b.hpp"\n'},
        "room low must not include hidden": {"src/low/c.cpp": "#include <hidden/x.h>\n"},
        "must not appear in include/": {"include/hdconj/high/c.hpp": "#include <hidden/x.h>\n"},
        "must not include Eigen/src": {"src/high/c.cpp": "#include <Eigen/src/Core/Map.h>\n"},
        "room low must not include room high (hdconj/face.hpp)": {"src/low/c.cpp": '#include "hdconj/face.hpp"\n'},
        "stray.hpp: is in no room": {"include/hdconj/stray.hpp": "\n"},
        "public headers of the unknown room": {"cmake/layers.txt": rules + "public other: attic\n"},
        "is in no room": {"src/attic/c.cpp": "\n"},
        "there is no hdconj/": {"src/low/c.cpp": '#include "hdconj/low/gone.hpp"\n'},
        "uses std::vector without <vector>": {"src/high/c.cpp": "std::vector<int> v;\n"},
        "uses std::sort without <algorithm>": {
            "src/high/b.cpp": '#include "hdconj/low/a.hpp"\nstd::vector v = std::sort();'},
        "cycle: ": {"src/low/c.hpp": '#include "d.hpp"\n', "src/low/d.hpp": '#include "c.hpp"\n'},
        "which is not above it": {"cmake/layers.txt": rules.replace("room low:", "room low: high")},
        "neither room, public nor outside": {"cmake/layers.txt": rules + "rom low:\n"},
    }
    failures = []
    for expected, files in [(None, {})] + list(breaks.items()):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in ({"cmake/layers.txt": rules} | good | files).items():
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            faults, _ = check(Path(folder))
        if expected is None and faults:
            failures.append(f"a good tree is refused: {faults}")
        if expected is not None and not any(expected in fault for fault in faults):
            failures.append(f"not caught: {expected!r} (found {faults})")
    return failures, len(breaks)


if __name__ == "__main__":
    found, count = control() if sys.argv[1] == "--control" else check(Path(sys.argv[1]))
    print(*found, sep="\n")
    print(f"{count} looked at, {len(found)} faults")
    sys.exit(1 if found or count == 0 else 0)
