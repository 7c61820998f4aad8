# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of numbers that a scene names, such as a measured tooth: their copies in the folder of a study."""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Container, Iterable, Mapping
from pathlib import Path

from .._scene import Scene, quoted

FOLDER = "files"  # of the copies, in that of the study
# The table that says where the files are that a study names.
TABLE = re.compile(r"""^[ \t]*\[[ \t]*(?:files|"files"|'files')[ \t]*\].*\n?(?:(?![ \t]*\[).*(?:\n|\Z))*""", re.M)


def contents(scenes: Iterable[Scene]) -> dict[str, bytes]:
    """What the files hold that some scenes name, under their names there; without those that cannot be read."""
    named = (file for scene in scenes for file in scene._core.files.values())
    return {name: content for name, content in named if content is not None}


def copies(files: Mapping[str, bytes]) -> dict[str, str]:
    """Name of the copy of each file in the folder of a study, one for each content.

    It is that of the file, unless another content has it, or a study calls another content so.
    """
    of_content: dict[bytes, str] = {}
    for name, content in files.items():
        plain = f"{FOLDER}/{os.path.basename(name)}"
        is_free = plain not in of_content.values() and files.get(plain, content) == content
        copy = plain if is_free else f"{FOLDER}/{checksum(content)[:12]}-{os.path.basename(name)}"
        of_content.setdefault(content, copy)
    return {name: of_content[content] for name, content in files.items()}


def checksum(content: bytes) -> str:
    """SHA-256 of what a file holds."""
    return hashlib.sha256(content).hexdigest()


def renamed(text: str, names: Mapping[str, str]) -> str:
    """A text of JSON with other names where it names files."""
    for name, other in names.items():
        text = text.replace(json.dumps(name), json.dumps(other))
    return text


def placed(scene: Scene, names: Mapping[str, str], paths: Container[str] | None = None) -> Scene:
    """A scene with other names of its files, of all or of those at some paths."""
    files = scene._core.files.items()
    changes = {path: names[name] for path, (name, _) in files if name in names and (paths is None or path in paths)}
    return scene.with_(changes) if changes else scene


def with_table(text: str, names: Mapping[str, str]) -> str:
    """The text of a study with a table [files] in place of the one that it has."""
    lines = "".join(f"{quoted(name)} = {quoted(copy)}\n" for name, copy in names.items() if name != copy)
    return TABLE.sub("", text).rstrip() + "\n" + (f"\n[files]\n{lines}" if lines else "")


def scene_text(scene: Scene, folder: str | os.PathLike[str]) -> str:
    """A scene as text for a file in a folder, where its relative file names start."""
    start, end = Path(scene._source[2]).resolve(), Path(folder).resolve()
    names = {name: os.path.relpath(start / name, end) for name, _ in scene._core.files.values()
             if start != end and not os.path.isabs(name)}  # fmt: skip
    return placed(scene, names).to_toml()
