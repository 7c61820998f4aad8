#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks every relative link of the pages: the file exists, and so does the heading that an anchor names.

  links.py SOURCE_DIR   check README.md, CONTRIBUTING.md, CHANGELOG.md and docs/**/*.md
  links.py --control    check the check: a page made to break each rule must be caught
"""
import re
import sys
import tempfile
from pathlib import Path
from urllib.parse import unquote

LINK = re.compile(r"(?<!\\)\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(\s*<?([^)<>\s]+)>?(?:\s+\"[^\"]*\")?\s*\)")
REFERENCE = re.compile(r"^ {0,3}\[[^\]^]+\]:\s*<?(\S+?)>?\s*$", re.M)
OUTSIDE = re.compile(r"[a-z][a-z0-9+.-]*:", re.I)


def pages(root):
    """The pages whose links are checked."""
    named = [root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    return [page for page in named if page.is_file()] + sorted((root / "docs").rglob("*.md"))


def prose(text):
    """The text with code blanked, lines kept."""
    def blank(match):
        return "\n" * match.group().count("\n")

    text = re.sub(r"^(```|~~~).*?^\1[^\n]*$", blank, text, flags=re.M | re.S)
    text = re.sub(r"(?<=\n\n)(?: {4}[^\n]*\n)+", blank, text)
    return re.sub(r"(`+)(?!`)[^\n]*?\1", "", text)


def anchors(text):
    """Names that a page gives to its headings, as GitHub makes them, and those of <a id="...">."""
    found, count = set(), {}
    without_code = re.sub(r"^(```|~~~).*?^\1[^\n]*$", "", text, flags=re.M | re.S)
    for heading in re.findall(r"^#{1,6} +(.+?)(?: +#+)?$", without_code, re.M):
        heading = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        number = count.get(name, 0)
        count[name] = number + 1
        found.add(f"{name}-{number}" if number else name)
    return found | set(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", without_code))


def check(root):
    """All faults below root, and the number of links looked at."""
    faults, looked_at = [], 0
    for page in pages(root):
        text = prose(page.read_text())
        for match in [*LINK.finditer(text), *REFERENCE.finditer(text)]:
            target = match[1]
            if OUTSIDE.match(target):
                continue
            looked_at += 1
            place = f"{page.relative_to(root)}:{text.count(chr(10), 0, match.start(1)) + 1}"
            name, _, anchor = target.partition("#")
            file = page.parent / unquote(name) if name else page
            if target.startswith("/"):
                faults.append(f"{place}: {target} is not relative")
            elif not file.exists():
                faults.append(f"{place}: there is no {target}")
            elif not file.resolve().is_relative_to(root.resolve()):
                faults.append(f"{place}: {target} leads out of the project")
            elif anchor and file.suffix == ".md" and anchor not in anchors(file.read_text()):
                faults.append(f"{place}: {name or page.name} has no heading #{anchor}")
    return faults, looked_at


def control():
    """Each rule, broken once, must be reported; the same pages without the breaks must pass."""
    good = {
        "README.md": "# A\n\nsee [b](docs/b.md#two-words), ![](docs/p.svg), [here](#a), [web](https://x.y/z)\n\n"
                     "    [code](gone.md)\n\nand `[code](gone.md)` too\n",
        "docs/b.md": "# B\n\n## Two words\n\n```\n[code](gone.md)\n# no heading\n```\n\n## `[tilt]`\n\n"
                     "[up](../README.md) [tilt](#tilt) [`[tilt]`](#tilt)\n",
        "docs/p.svg": "",
    }
    breaks = {
        "there is no gone.md": "[x](gone.md)\n",
        "there is no p.png": "![x](p.png)\n",
        "has no heading #three": "[x](b.md#three)\n",
        "has no heading #no-heading": "[x](b.md#no-heading)\n",
        "c.md has no heading #self": "[x](#self)\n",
        "is not relative": "[x](/docs/b.md)\n",
        "leads out of the project": "[x](../../)\n",
        "c.md:3: there is no later.md": "# C\n\n[x](later.md)\n",
        "there is no named.md": "[x]: named.md\n",
        "there is no two.md": "[a\nb](two.md)\n",
    }
    failures = []
    for expected, text in [(None, "")] + list(breaks.items()):
        with tempfile.TemporaryDirectory() as folder:
            for name, content in (good | {"docs/c.md": text}).items():
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(content)
            faults, _ = check(Path(folder))
        if expected is None and faults:
            failures.append(f"good pages are refused: {faults}")
        if expected is not None and not any(expected in fault for fault in faults):
            failures.append(f"not caught: {expected!r} (found {faults})")
    return failures, len(breaks)


if __name__ == "__main__":
    found, count = control() if sys.argv[1] == "--control" else check(Path(sys.argv[1]))
    print(*found, sep="\n")
    print(f"{count} looked at, {len(found)} faults")
    sys.exit(1 if found or count == 0 else 0)
