# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of numbers that a scene names, such as a measured tooth: their copies in the folder of a study."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Mapping
from pathlib import Path

from .._scene import Scene, quoted

FOLDER = "files"  # of the copies, in that of the study


def contents(scenes: Iterable[Scene]) -> dict[str, bytes]:
    """What the files hold that some scenes name, under their names there; without those that cannot be read."""
    named = (file for scene in scenes for file in scene._core.files.values())
    return {name: content for name, content in named if content is not None}


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
    names = {path: os.path.relpath(start / name, end) for path, (name, _) in scene._core.files.items()
             if start != end and not os.path.isabs(name)}  # fmt: skip
    return (scene.with_(names) if names else scene).to_toml()
