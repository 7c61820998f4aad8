# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder of a study: shards as Parquet files that appear whole, what they were made by, and a lock."""

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

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

import hdconj

from .. import _files
from .._errors import FileError, Fault, InputError, fault_text
from .._scene import Scene
from ._data_files import FOLDER, copies, renamed, scene_text
from ._drive import Row
from ._keys import as_text
from ._recipe import Recipe

FORMAT = 1
_NAME = re.compile(r"rows-(\d{9})-(\d{9})\.parquet")
_WORDS = ("code", "stage", "place", "cause")
_PACKAGES = ("numpy", "scipy", "pyarrow", "dask", "distributed", "SALib", "pymoo")


def refuse(path: object, reason: str, remedy: str) -> InputError:
    """A single fault as an error."""
    faults = (Fault(str(path), 0, "", reason, remedy),)
    return InputError(faults, fault_text(faults))


def schema_of(recipe: Recipe) -> Any:
    """Columns of the rows: sample, keys, figures and their errors, what went wrong."""
    fields = [pa.field("sample", pa.int64())]
    for key in recipe.keys:
        kind = pa.string() if key.is_text else pa.bool_() if isinstance(key.middle, bool) else pa.float64()
        fields.append(pa.field(key.path, kind))
    fields += [pa.field(path, pa.float64()) for path, _ in recipe.links]
    for name, _ in recipe.figures:
        fields += [pa.field(name, pa.float64()), pa.field(f"{name}_error", pa.float64())]
    return pa.schema([*fields, *(pa.field(word, pa.string()) for word in _WORDS)])


def _column(values: Sequence[Any], field: Any) -> Any:
    if pa.types.is_floating(field.type):
        return pa.array(np.array([np.nan if v is None else float(v) for v in values]), field.type)
    if pa.types.is_string(field.type):
        return pa.array(["" if v is None else as_text(v) for v in values], field.type)
    return pa.array(values, field.type)


def table_of(rows: Sequence[Row], schema: Any) -> Any:
    """Rows as a table of Arrow; what a drive has not is not a number."""
    return pa.table([_column([row.get(field.name) for row in rows], field) for field in schema], schema=schema)


def digest(table: Any) -> str:
    """A checksum of names and values, the same whatever the file looks like."""
    made = hashlib.sha256()
    for name in table.column_names:
        column = table.column(name).combine_chunks()
        made.update(name.encode() + b"\0")
        if pa.types.is_string(column.type):
            made.update("\0".join(column.to_pylist()).encode("utf-8", "surrogateescape"))
        else:
            made.update(column.to_numpy(zero_copy_only=False).tobytes())
    return made.hexdigest()


def write_whole(file: Path, text: bytes) -> None:
    """A file that is there whole or not at all."""
    temporary = file.with_name(f".{file.name}.{os.getpid()}")
    try:
        with open(temporary, "wb") as out:
            out.write(text)
            out.flush()
            os.fsync(out.fileno())
        os.replace(temporary, file)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise FileError(
            f"{file}: cannot be written: {error.strerror or error}; what was written before is kept"
        ) from None


def write_shard(folder: Path, rows: Sequence[Row], schema: Any, about: Mapping[str, Any]) -> Path:
    """Writes the rows of consecutive samples; `about` goes into the file beside their checksum."""
    table = table_of(rows, schema)
    words = json.dumps({**about, "rows_sha256": digest(table), "format": FORMAT})
    sink = pa.BufferOutputStream()
    pq.write_table(table.replace_schema_metadata({b"hdconj": words.encode()}), sink, compression="zstd")
    file = folder / f"rows-{rows[0]['sample']:09d}-{rows[-1]['sample']:09d}.parquet"
    write_whole(file, sink.getvalue().to_pybytes())
    return file


def read_shard(file: Path) -> tuple[Any, dict[str, Any]] | None:
    """The rows of a file and what is written beside them; None where it is not what was written."""
    try:
        table = pq.read_table(file, partitioning=None)
        about: dict[str, Any] = json.loads((table.schema.metadata or {})[b"hdconj"])
    except (OSError, ValueError, KeyError, pa.ArrowException):
        return None
    return (table, about) if about.get("rows_sha256") == digest(table) else None


def read_shards(folder: Path, mend: bool = False) -> Iterator[tuple[Any, dict[str, Any]]]:
    """All shards that are whole, in order of samples; `mend` removes the others, so that they are made again."""
    upto = -1
    for file in sorted(folder.glob("rows-*.parquet")):
        named = _NAME.fullmatch(file.name)
        found = read_shard(file) if named else None
        numbers = found[0].column("sample").to_pylist() if found else []
        if found and numbers and numbers[0] > upto and numbers[-1] == int(named[2]):  # type: ignore[index]
            upto = numbers[-1]
            yield found
        elif mend:
            file.unlink()


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
        try:
            (self.place / name).mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise FileError(f"{self.place / name}: cannot be made: {error.strerror}") from None
        return self.place / name

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Holds the folder for one run; a second one is refused. The lock goes with the process that has it."""
        self.refuse_foreign()
        self.part("rows")
        try:
            lock = open(self.place / "lock", "a+b", buffering=0)
        except OSError as error:
            raise FileError(f"{self.place}: cannot be used: {error.strerror}") from None
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
                raise FileError(f"{self.place}: cannot be written: {error.strerror}") from None
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
        scene = renamed(recipe.scene.to_toml(), names)
        write_whole(self.place / "scene.toml", scene.encode("utf-8", "surrogateescape"))
        write_whole(self.place / "study.toml", renamed(_own_scene(recipe), names).encode())
        return about

    def write_scene(self, file: Path, scene: Scene) -> None:
        """Writes the scene of a drive, whose files are found from where it stands."""
        text = scene_text(scene, file.parent).encode("utf-8", "surrogateescape")
        _files.write_whole(file, lambda name: Path(name).write_bytes(text))

    def note(self, about: Mapping[str, Any]) -> None:
        """Writes study.json."""
        write_whole(self.place / "study.json", (json.dumps(about, indent=1) + "\n").encode())

    def missing(self, numbers: Sequence[int], folder: Path | None = None) -> list[int]:
        """Which samples have no row yet; broken shards are removed."""
        there: set[int] = set()
        for table, _ in read_shards(folder or self.rows, mend=True):
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
