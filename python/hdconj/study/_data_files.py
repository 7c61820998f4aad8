# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of numbers that a scene names, such as a measured tooth: their copies in the folder of a study."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from .._scene import Scene, quoted
from ._keys import Key

FOLDER = "files"  # of the copies, in that of the study


def _named(tables: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, str]]:
    """Keys of a scene that name a file, and the names."""
    for word, item in tables.items():
        if isinstance(item, dict):
            yield from _named(item, f"{before}{word}.")
        elif word == "file" and isinstance(item, str):
            yield f"{before}{word}", item


def contents(scene: Scene, keys: tuple[Key, ...]) -> dict[str, bytes]:
    """What the files hold that the drives of a study read, under their names in the scene and in lists of [vary].

    A file that cannot be read is left out: a study that names it is refused before its first drive.
    """
    names = [name for _, name in _named(scene.to_dict())]
    names += [str(value) for key in keys if key.path.endswith(".file") for value in key.values]
    found = {}
    for name in names:
        file = Path(scene._source[2], name)
        if file.is_file() and os.access(file, os.R_OK):
            found[name] = file.read_bytes()
    return found


def copies(files: Mapping[str, bytes]) -> dict[str, str]:
    """Name of the copy of each file in the folder of a study; files of one name and several contents are kept apart."""
    first: dict[str, bytes] = {}
    found = {}
    for name, content in files.items():
        base = os.path.basename(name)
        is_first = first.setdefault(base, content) == content
        found[name] = f"{FOLDER}/{base if is_first else f'{checksum(content)[:12]}-{base}'}"
    return found


def checksum(content: bytes) -> str:
    """SHA-256 of what a file holds."""
    return hashlib.sha256(content).hexdigest()


def renamed(text: str, names: Mapping[str, str]) -> str:
    """A text of TOML or JSON with other names where it names files."""
    for name, other in names.items():
        for written in (json.dumps(name), json.dumps(name, ensure_ascii=False), f"'{name}'"):
            text = text.replace(written, quoted(other))
    return text


def scene_text(scene: Scene, folder: str | os.PathLike[str]) -> str:
    """A scene as text for a file in a folder, where its relative file names start."""
    start, end = Path(scene._source[2]).resolve(), Path(folder).resolve()
    names = {path: os.path.relpath(start / name, end) for path, name in _named(scene.to_dict())
             if start != end and not os.path.isabs(name)}  # fmt: skip
    return (scene.with_(names) if names else scene).to_toml()
