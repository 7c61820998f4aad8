#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the commands of the pages that run_pages.py does not run: those that build, install, test or measure.

    other_commands.py SOURCE_DIR             README, CONTRIBUTING and all pages of docs
    other_commands.py SOURCE_DIR --control   changes each word that is judged: each change must be caught

A command is code, indented or within a line, that begins with one of PROGRAMS or with a path of the source tree. What
its words name must exist: presets, targets, labels and names of tests, tags, variables, paths, and whatever stands
behind a script of ours: its options and choices. Words in capitals and numbers stand for what the reader puts in.
"""
import json
import re
import shlex
import sys
from pathlib import Path

from run_pages import pages_of

PROGRAMS = ("cmake", "ctest", "gdb", "valgrind", "gnuplot", "hdconj_bench", "hdconj_threads")
CODE = re.compile(r"^ {4,}(\S[^`\n]*)$|`([^`]+)`", re.M)
PLACEHOLDER = re.compile(r"(.*\b)?[A-Z_]{3,}(\b.*)?|[\d.]+")
PATH = re.compile(r"(\./\w+\.sh|(\.ci|apps|build|cmake|data|docs|include|src|tests)/[\w./-]*)")
OURS = re.compile(r"(docs|tests)/\S+\.(py|sh)")


class Tree:
    """What the source tree offers."""

    def __init__(self, source):
        self.source = source
        self.presets = json.loads((source / "CMakePresets.json").read_text())
        files = [*source.glob("*"), *(each for top in ("apps", "cmake", "tests") for each in (source / top).rglob("*"))]
        self.build_files = "\n".join(path.read_text() for path in files
                               if path.name == "CMakeLists.txt" or path.suffix in (".cmake", ".py", ".sh"))
        self.tests = "\n".join(path.read_text() for path in (source / "tests").rglob("*.cpp"))

    def preset(self, words, name):
        """Whether the program that begins these words has a preset of this name."""
        kind = "test" if words[0] == "ctest" else "build" if "--build" in words else "configure"
        return any(each["name"] == name and not each.get("hidden") for each in self.presets[kind + "Presets"])

    def target(self, name):
        """Whether a CMake file makes this target."""
        return bool(re.search(rf"(add_executable|add_custom_target|hdconj_tool_target)\({name}\b", self.build_files)
                    or (name.endswith("_tests") and f"hdconj_tests({name.removesuffix('_tests')} " in self.build_files))

    def label(self, name):
        """Whether tests carry this label."""
        return bool(re.search(rf"LABELS [^\n]*\b{name}\b|hdconj_tests\({name} ", self.build_files))

    def test(self, pattern):
        """Whether the name of a test holds this pattern."""
        return self.label(pattern) or bool(re.search(rf'TEST_CASE\("[^"\n]*{pattern}', self.tests))

    def path(self, word):
        """Whether the source tree, or a build of a preset, has this path."""
        built = re.fullmatch(r"build/(\w[\w-]*)(?:/bin|/docs/html|/(?:bin|tests)/(\w+))?", word)
        if not built:
            return (self.source / word).exists()
        return self.preset(["cmake"], built[1]) and (not built[2] or self.target(built[2]))

    def known_to(self, script, word):
        """Whether a script of ours has this word."""
        return bool(re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", (self.source / script).read_text()))

    def judge_of(self, words, at):
        """The function that judges the word at this place of a command; None where nothing is to be judged."""
        word, before = words[at], words[at - 1] if at else ""
        options = {"--preset": lambda name: self.preset(words, name), "--target": self.target, "-L": self.label,
                   "-R": self.test}
        script = next(filter(OURS.fullmatch, words[:at]), None)
        variable = re.match(r"(-D)?HDCONJ_\w+=", word)
        if before in options:
            return options[before]
        if variable:
            return lambda name: re.match(r"(?:-D)?(\w+)", name)[1] in self.build_files
        if PLACEHOLDER.fullmatch(word):
            return None
        if word.startswith("hdconj_"):
            return self.target
        if word.startswith("["):
            return self.tests.__contains__
        if PATH.fullmatch(word):
            return self.path
        return (lambda name: self.known_to(script, name)) if script else None


def commands_of(text):
    """Tuples of line and words of each command in the code of a page."""
    text = re.sub(r"^```.*?^```$", lambda match: "\n" * match[0].count("\n"), text, flags=re.S | re.M)
    for match in CODE.finditer(text):
        code = " ".join((match[1] or match[2]).partition("#")[0].split())
        for part in code.split(" && "):
            begin = re.sub(r"^(\w+=\S+ )+", "", part).partition(" ")[0]
            if begin in PROGRAMS or PATH.fullmatch(begin):
                yield text.count("\n", 0, match.start()) + 1, shlex.split(part)


def judged_words(source):
    """Tuples of page, line, word and the function that judges it, for all pages."""
    tree = Tree(source)
    for page in pages_of(source):
        for line, words in commands_of(page.read_text()):
            for at, word in enumerate(words):
                judge = tree.judge_of(words, at)
                if judge:
                    yield f"{page.relative_to(source)}:{line}", word, judge


def changed(word):
    """The word with its name changed."""
    name, equals, value = word.partition("=")
    return name[:-1] + "Q" + equals + value


def main(arguments):
    """Runs what the arguments ask for; the exit status."""
    if not arguments:
        sys.exit(__doc__)
    words = list(judged_words(Path(arguments[0]).resolve()))
    if "--control" in arguments:
        kept = [(place, word) for place, word, judge in words if judge(changed(word))]
        faults = [f"{place}: {word} may become {changed(word)}" for place, word in kept]
    else:
        faults = [f"{place}: there is no {word}" for place, word, judge in words if not judge(word)]
    print("\n".join([f"{len(words)} words of commands judged", *faults]))
    return bool(faults) or not words


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
