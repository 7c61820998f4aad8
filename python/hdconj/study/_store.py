# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder of a study: shards, what they were made by, and a lock."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import platform
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import hdconj

from .. import _files
from .._errors import FileError, Fault, InputError, fault_text
from ._data_files import FOLDER, copies, placed, scene_text, with_table
from ._keys import Value
from ._recipe import Recipe
from ._shards import FORMAT, made_folder, read_shards, schema_of, told, write_whole

_PACKAGES = ("numpy", "scipy", "pyarrow", "dask", "distributed", "SALib", "pymoo")


def refuse(path: object, reason: str, remedy: str) -> InputError:
    """A single fault as an error."""
    faults = (Fault(str(path), 0, "", reason, remedy),)
    return InputError(faults, fault_text(faults))


class Folder:
    """The folder of a study."""

    def __init__(self, place: str | os.PathLike[str]) -> None:
        if not os.fspath(place):
            raise refuse("folder of the study", "has an empty name", "name a folder, such as out")
        self.place = Path(place)
        self.rows = self.place / "rows"

    def about(self) -> dict[str, Any]:
        """What study.json says; a fault where there is no study."""
        try:
            found = json.loads((self.place / "study.json").read_text())
        except (FileNotFoundError, NotADirectoryError, ValueError):
            found = None
        except OSError as error:
            raise refuse(self.place, f"cannot be read: {error.strerror}", "name a folder that you may read") from None
        words = ("kind", "identity", "program")
        if not isinstance(found, dict) or not all(isinstance(found.get(word), str) for word in words):
            if (self.place / "study.json").is_file():
                reason = "is damaged, or was not written by hdconj study"
                raise refuse(self.place / "study.json", reason, "name another folder")
            raise refuse(self.place, "is no folder of a study", "name what -o of hdconj study run named")
        return found

    def refuse_foreign(self) -> None:
        """Refuses a folder that holds anything and is no study; a run that ended at once may have left a lock."""
        if (self.place / "study.json").exists():
            self.about()
            return
        if not self.place.exists():
            return
        if not self.place.is_dir():
            raise refuse(self.place, "is a file", "name a folder that is empty or not there")
        found = {file.name for file in self.place.iterdir() if not file.name.startswith(".study.json.")}
        if self.rows.is_dir() and not any(self.rows.iterdir()):
            found.discard("rows")
        if foreign := sorted(found - {"lock"}):
            raise refuse(
                self.place, f"holds {foreign[0]}, which is of no study", "name a folder that is empty or not there"
            )

    def part(self, name: str) -> Path:
        """A folder in it, made where it is not there."""
        return made_folder(self.place / name)

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Holds the folder for one run; a second one is refused. The lock goes with the process that has it."""
        self.refuse_foreign()
        self.part("rows")
        try:
            lock = open(self.place / "lock", "a+b", buffering=0)
        except OSError as error:
            raise FileError(told(self.place, "cannot be used", error)) from error
        with lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                lock.seek(0)
                holder = lock.read().decode(errors="replace").strip() or "another run"
                raise refuse(self.place, f"is in use by {holder}", "wait for it, or name another folder") from None
            try:
                lock.truncate(0)
                lock.write(f"process {os.getpid()} on {platform.node()}".encode())
            except OSError as error:
                raise FileError(told(self.place, "cannot be written", error)) from error
            yield

    def is_running(self) -> bool:
        """Whether a run has the folder."""
        try:
            with open(self.place / "lock") as lock:
                fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except FileNotFoundError:
            return False
        except OSError:
            return True
        return False

    def same(self, recipe: Recipe, kind: str) -> dict[str, Any] | None:
        """What study.json says of this study; None where the folder has none yet, a fault where it is another's."""
        if not (self.place / "study.json").exists():
            return None
        about, ours = self.about(), identity_of(recipe, kind)
        for name, meaning in (("kind", "verb"), ("identity", "study"), ("program", "version of hdconj")):
            if about.get(name) != ours[name]:
                raise refuse(self.place, f"holds rows of another {meaning}", "name another folder")
        return about

    def begin(self, recipe: Recipe, kind: str) -> dict[str, Any]:
        """Makes the folder the one of this study, or finds that it is. Call it while it is locked."""
        about = self.same(recipe, kind) or {
            **identity_of(recipe, kind),
            "scene_sha256": hashlib.sha256(recipe.scene.to_toml().encode()).hexdigest(),
            **machine(),
        }
        self.note(about)  # first: from here on the folder is the study's
        names = copies(recipe.files)
        if names:
            self.part(FOLDER)
        for name, copy in names.items():
            write_whole(self.place / copy, recipe.files[name])
        scene = placed(recipe.scene, names).to_toml()
        write_whole(self.place / "scene.toml", scene.encode("utf-8", "surrogateescape"))
        write_whole(self.place / "study.toml", with_table(_own_scene(recipe), names).encode())
        return about

    def write_scene(self, file: Path, recipe: Recipe, values: Mapping[str, Value]) -> None:
        """Writes the scene of a drive, whose files are found from where it stands.

        Options of verbs that are no keys of it stand in its head.
        """
        head = "".join(
            f"# The figures of the study are those of hdconj.{verb}(SCENE, "
            f"{', '.join(f'{name}={value!r}' for name, value in options.items())}).\n"
            for verb, options in recipe.verbs if options
        )  # fmt: skip
        text = (head + scene_text(recipe.scene_of(values), file.parent)).encode("utf-8", "surrogateescape")
        _files.write_whole(file, lambda name: Path(name).write_bytes(text))

    def note(self, about: Mapping[str, Any]) -> None:
        """Writes study.json."""
        write_whole(self.place / "study.json", (json.dumps(about, indent=1) + "\n").encode())

    def missing(self, recipe: Recipe, numbers: Sequence[int], folder: Path | None = None) -> list[int]:
        """Which samples have no row yet; shards that are broken or another study's are removed."""
        there: set[int] = set()
        for table, _ in read_shards(folder or self.rows, self.about(), schema_of(recipe).names, mend=True):
            there.update(table.column("sample").to_pylist())
        return [number for number in numbers if number not in there]


def _own_scene(recipe: Recipe) -> str:
    """The study's text with the scene that lies beside it, so that the folder alone says everything."""
    if isinstance(recipe.tables.get("scene"), dict):
        return recipe.text
    head = re.match(r"(?:(?![ \t]*\[)[^\n]*\n)*", recipe.text)  # the lines before the first table
    end = head.end() if head else 0
    given = re.sub(r"^[ \t]*[\"']?scene[\"']?[ \t]*=[^\n]*\n", "", recipe.text[:end], flags=re.M)
    return 'scene = "scene.toml"\n' + given + recipe.text[end:]


def identity_of(recipe: Recipe, kind: str) -> dict[str, Any]:
    """What rows of one folder have in common."""
    program = f"{hdconj.__version__} {hdconj._core.revision}"
    return {"identity": recipe.identity(), "kind": kind, "program": program, "format": FORMAT}


def machine() -> dict[str, Any]:
    """What computes: versions, revision, machine."""
    packages = {}
    for name in _PACKAGES:
        try:
            packages[name] = version(name)
        except PackageNotFoundError:
            continue
    return {
        "build": hdconj._core.build,
        "python": sys.version.split()[0],
        "packages": packages,
        "machine": {"system": platform.platform(), "processor": platform.machine(), "cores": os.cpu_count()},
    }
