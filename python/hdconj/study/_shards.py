# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of a study as Parquet files that appear whole and say whose they are."""

from __future__ import annotations

import errno
import hashlib
import json
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from .._errors import FileError
from ._drive import Row
from ._keys import as_text
from ._recipe import Recipe

FORMAT = 1
IDENTITY = ("identity", "kind")  # what study.json and the metadata of all its shards have in common
# Errors of a file that stay when the same is tried again, as a full disk does not.
LASTING = {errno.EACCES, errno.EPERM, errno.EROFS, errno.ENOENT, errno.ENOTDIR, errno.EISDIR, errno.EEXIST,
           errno.ENAMETOOLONG, errno.ELOOP}  # fmt: skip
_NAME = re.compile(r"rows-(\d{9})-(\d{9})\.parquet")
_WORDS = ("code", "stage", "place", "cause")


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


def is_lasting(error: BaseException) -> bool:
    """Whether a file cannot be written until another one is named, or the rights are others."""
    return isinstance(error, OSError) and (error.errno in LASTING or is_lasting(error.__cause__ or ValueError()))


def told(place: Path, what: str, error: OSError) -> str:
    """What cannot be done with a file or folder, why, and what to do where trying again does not help."""
    remedy = " (name a folder that you may write)" if is_lasting(error) else ""
    return f"{place}: {what}: {error.strerror or error}{remedy}"


def made_folder(place: Path) -> Path:
    """A folder, made where it is not there."""
    try:
        place.mkdir(parents=True, exist_ok=True)
    except FileExistsError as error:
        raise FileError(f"{place}: is a file (name a folder)") from error
    except OSError as error:
        raise FileError(told(place, "cannot be made", error)) from error
    return place


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
        with suppress(OSError):
            temporary.unlink(missing_ok=True)
        raise FileError(f"{told(file, 'cannot be written', error)}; what was written before is kept") from error


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


def read_shards(
    folder: Path, own: Mapping[str, Any] | None = None, columns: Sequence[str] = (), mend: bool = False
) -> Iterator[tuple[Any, dict[str, Any]]]:
    """All shards that are whole, in order of samples; `mend` removes the others, so that they are made again.

    Those of another study than `own` says, which is what study.json holds, or with other columns are not taken. Shards
    of former versions do not say whose they are.
    """
    upto = -1
    for file in sorted(folder.glob("rows-*.parquet")):
        named = _NAME.fullmatch(file.name)
        found = read_shard(file) if named else None
        if found and own is not None and not _is_of(found, own, columns):
            found = None
        numbers = found[0].column("sample").to_pylist() if found else []
        if found and numbers and numbers[0] > upto and numbers[-1] == int(named[2]):  # type: ignore[index]
            upto = numbers[-1]
            yield found
        elif mend:
            file.unlink()


def _is_of(shard: tuple[Any, dict[str, Any]], own: Mapping[str, Any], columns: Sequence[str]) -> bool:
    table, about = shard
    return table.column_names == list(columns) and all(about.get(word, own[word]) == own[word] for word in IDENTITY)
