# SPDX-License-Identifier: GPL-3.0-or-later
"""Result files by h5py, in the layout of docs/reference/hdf5.md."""

from __future__ import annotations

import os
import zlib
from collections.abc import Iterator
from typing import Any, BinaryIO

import h5py  # type: ignore[import-untyped]
import numpy as np

from ._errors import FileError
from ._files import write_whole
from ._tree import Array, Dataset, Group, dataset

_TEXT = h5py.string_dtype("utf-8")
# Former names of datasets, which format version 2 holds as links (docs/reference/json.md, docs/reference/hdf5.md).
FORMER = frozenset(
    "shown take_up take_up_back share clearing_offset clearing_tip clearing_root backlash_of_clearing raised "
    "tip_widened tip_change contact_share near_share node_share residual rounds whole ladders rungs reference_entry "
    "reaches station height".split()
)


def _write_attributes(place: Any, attrs: Any) -> None:
    for name, value in attrs.items():
        if isinstance(value, bool):
            place.attrs.create(name, value, dtype=np.uint8)
        elif isinstance(value, int):
            place.attrs.create(name, value, dtype=np.int32)
        elif isinstance(value, float):
            place.attrs.create(name, value, dtype=np.float64)
        elif isinstance(value, str):
            place.attrs.create(name, value, dtype=_TEXT)
        else:
            place.attrs.create(name, list(value), shape=(len(value),), dtype=_TEXT)


def _bytes_of(texts: Array) -> Array:
    """Texts in UTF-8, and bytes that are none as they were read."""
    coded = [text.encode("utf-8", "surrogateescape") for text in texts.ravel().tolist()]
    return np.array(coded, dtype=object).reshape(texts.shape)


def _write_group(group: Group, place: Any, outer: dict[str, Any]) -> None:
    scales = dict(outer)

    def scale_of(dim: str, size: int) -> Any:
        if dim not in scales:  # a dimension without numbers, as netCDF-4 has it
            made = place.create_dataset(dim, shape=(size,), dtype=np.int32, track_times=False)
            made.make_scale(f"This is a netCDF dimension but not a netCDF variable.{size:10}")
            scales[dim] = made
        return scales[dim]

    _write_attributes(place, group.attrs)
    for name, entry in group.datasets.items():
        is_text = entry.values.dtype == object
        made = place.create_dataset(
            name, shape=entry.values.shape, dtype=_TEXT if is_text else entry.values.dtype, track_times=False
        )
        if entry.values.size:
            made[...] = _bytes_of(entry.values) if is_text else entry.values
        _write_attributes(made, {"units": entry.units, "long_name": entry.meaning})
        if entry.dims == (name,):
            made.make_scale(name)
            scales[name] = made
            continue
        for i, dim in enumerate(entry.dims):
            made.dims[i].attach_scale(scale_of(dim, entry.values.shape[i]))
    for other, name in group._parts.links.items():
        place[other] = place[name]
    for name, inner in group.groups.items():
        _write_group(inner, place.create_group(name), scales)


# A line behind the end that HDF5 passes over, and that a program which changes the file cuts off.
_MARK = b"hdconj crc32 "


def _checksum_line(file: BinaryIO, size: int) -> bytes:
    crc = 0
    file.seek(0)
    while size > 0 and (block := file.read(min(size, 1 << 20))):
        crc = zlib.crc32(block, crc)
        size -= len(block)
    return _MARK + b"%08x\n" % crc


def _check(name: str) -> None:
    with open(name, "rb") as file:
        size = file.seek(0, os.SEEK_END) - len(_MARK) - 9
        file.seek(max(size, 0))
        line = file.read()
        if size >= 0 and line.startswith(_MARK) and line != _checksum_line(file, size):
            raise FileError(f"{name} is damaged: its bytes do not fit its checksum")


def write(group: Group, file: str | os.PathLike[str]) -> None:
    """Write a result, whole or not at all."""

    def fill(name: str) -> None:
        with h5py.File(name, "w") as made:
            _write_group(group, made, {})
        with open(name, "r+b") as written:
            line = _checksum_line(written, os.path.getsize(name))
            written.write(line)

    write_whole(file, fill)


def _plain(value: Any) -> Any:
    """An attribute as a result has it."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "surrogateescape")
    if isinstance(value, np.ndarray) and value.dtype == object:
        return [_plain(item) for item in value]
    if isinstance(value, np.uint8):
        return bool(value)
    return value.item() if isinstance(value, np.generic) else value


def _dim(stored: Any, scales: Any) -> str:
    """Name of a dimension, which is that of its scale."""
    name = scales[0].name if len(scales) else stored.name
    if name is None:  # the scale is no longer in the file
        raise KeyError(stored.name)
    return str(name).rsplit("/", 1)[-1]


def _read_dataset(stored: Any) -> Dataset:
    is_text = h5py.check_string_dtype(stored.dtype) is not None
    values: Array = stored.asstr(errors="surrogateescape")[...] if is_text else stored[...]
    about = [_plain(stored.attrs.get(name, "")) for name in ("units", "long_name")]
    return dataset(values, about[0], about[1], tuple(_dim(stored, scales) for scales in stored.dims))


def _derived(attrs: dict[str, Any], datasets: dict[str, Dataset], apart: Any) -> Iterator[tuple[Any, ...]]:
    """Figures by their names: NAME with NAME_error, or with NAME in the group `error`."""
    for name, entry in datasets.items():
        if name.endswith("_error") or entry.values.dtype == object:
            continue
        if f"{name}_error" in datasets:
            yield name, name, f"{name}_error", entry.units, entry.meaning, False
        elif apart is not None and name in apart:
            yield name, name, f"error/{name}", entry.units, entry.meaning, False
    for name in attrs:
        words = name.split("_")
        for i in range(1, len(words) + 1):
            if (error := "_".join([*words[:i], "error", *words[i:]])) in attrs:
                yield "_".join(words[:i]), name, error, "_".join(words[i:]), "", True


def _is_former(name: str) -> bool:
    return name.removesuffix("_error").removesuffix("_count") in FORMER


def _read_group(place: Any) -> tuple[Any, ...]:
    attrs = {name: _plain(value) for name, value in place.attrs.items()}
    datasets: dict[str, Dataset] = {}
    groups = {}
    links: dict[str, str] = {}
    first: dict[Any, str] = {}
    for name in sorted(place, key=lambda name: (_is_former(name), name)):
        member = place[name]
        if isinstance(member, h5py.Group):
            groups[name] = _read_group(member)
            continue
        if bytes(member.attrs.get("NAME", b"")).startswith(b"This is a netCDF dimension but not"):
            continue
        same = first.setdefault(h5py.h5o.get_info(member.id).addr, name)
        if same != name:
            links[name] = same
        else:
            datasets[name] = _read_dataset(member)
    figures = list(_derived(attrs, datasets, place.get("error")))
    return attrs, datasets, links, groups, figures


def read(file: str | os.PathLike[str]) -> Group:
    """Read a result file of the program or of :meth:`Result.to_hdf5`.

    Parameters
    ----------
    file : path
        HDF5, in the layout of docs/reference/hdf5.md.

    Returns
    -------
    Group
        The root, with the arrays in memory. A file tells figures by their errors: a group has
        those whose error it holds, such as ``read(file)["load"].figures``. The root has none, and
        ``summary`` has attributes only.

    Raises
    ------
    FileError
        It cannot be read, is no HDF5 file or is cut off, lacks parts, or its bytes are not those that were written.
    """
    name = os.fspath(file)
    try:
        _check(name)
        with h5py.File(name, "r") as stored:
            try:
                return Group._from_layout(_read_group(stored))
            except (KeyError, RuntimeError, TypeError, ValueError) as error:  # of h5py, where references lead nowhere
                cause = "parts of it are missing or damaged"
                raise FileError(f"{name}: {cause}; name a file that hdconj or to_hdf5() wrote") from error
    except FileError:
        raise
    except OSError as error:
        cause = f"cannot read: {error.strerror}" if error.strerror else f"is no HDF5 file, or is cut off: {error}"
        raise FileError(f"{name or '(empty name)'}: {cause}; name a file that hdconj or to_hdf5() wrote") from error
