# SPDX-License-Identifier: GPL-3.0-or-later
"""Groups of arrays with units, as the result files hold them (docs/reference/hdf5.md)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple, Union

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]


class Figure(NamedTuple):
    """A number, or a column of numbers, with its estimated error."""

    value: Any
    """In `unit`; an array where the group has one for each case, slice or state."""
    error: Any
    """Estimated error in `unit`; None: the figure is exact or has no estimate."""
    unit: str
    """``""`` or ``"1"`` for a pure number."""
    meaning: str
    """In one line."""


class Dataset(NamedTuple):
    """An array that cannot be written to, and what it means."""

    values: Array
    units: str
    meaning: str
    dims: tuple[str, ...]


class Parts(NamedTuple):
    """All that a group holds."""

    attrs: Mapping[str, Any]
    datasets: Mapping[str, Dataset]
    links: Mapping[str, str]
    groups: Mapping[str, Group]
    figures: tuple[tuple[str, str, str, str, str, bool], ...]


Member = Union["Group", Array]


def frozen(values: Array) -> Array:
    """The same array, which cannot be written to any more."""
    values.flags.writeable = False
    return values


def dataset(values: Any, units: str, meaning: str, dims: tuple[str, ...]) -> Dataset:
    """A dataset of numbers, or of texts as an array of objects."""
    if not isinstance(values, np.ndarray):
        texts = np.empty(len(values), dtype=object)
        texts[:] = values
        values = texts
    return Dataset(frozen(values), units, meaning, tuple(dims))


class Group(Mapping[str, Member]):
    """A group of a result: ``group["contact/map/gap"]``, or ``group.contact.map.gap``.

    Arrays cannot be written to. They view the memory of the result where that holds them, and keep it alive.
    """

    __slots__ = ("_held", "_outer")
    _held: Parts | None
    _outer: Group | None

    def __init__(self, parts: Parts | None = None, outer: Group | None = None) -> None:
        object.__setattr__(self, "_held", parts)
        object.__setattr__(self, "_outer", outer)

    @classmethod
    def _from_layout(cls, layout: tuple[Any, ...], outer: Group | None = None) -> Group:
        """A group of the extension's plain tuples."""
        group = Group(None, outer)
        group._fill(layout)
        return group

    def _fill(self, layout: tuple[Any, ...]) -> Parts:
        attrs, datasets, links, groups, figures = layout
        own = {name: dataset(*entry) for name, entry in datasets.items()}
        inner = {name: Group._from_layout(entry, self) for name, entry in groups.items()}
        view = MappingProxyType
        parts = Parts(view(attrs), view(own), view(links), view(inner), tuple(figures))
        object.__setattr__(self, "_held", parts)
        return parts

    @property
    def _parts(self) -> Parts:
        assert self._held is not None
        return self._held

    @property
    def attrs(self) -> Mapping[str, Any]:
        """Single values and texts."""
        return self._parts.attrs

    @property
    def datasets(self) -> Mapping[str, Dataset]:
        """Arrays with units, meaning and names of dimensions."""
        return self._parts.datasets

    @property
    def groups(self) -> Mapping[str, Group]:
        """Groups in this one."""
        return self._parts.groups

    @property
    def figures(self) -> Mapping[str, Figure]:
        """Figures of this group, each with its error."""
        return {row[0]: self._figure(*row[1:]) for row in self._parts.figures}

    def _figure(self, value: str, error: str, unit: str, meaning: str, is_attribute: bool) -> Figure:
        if value == error:  # one dataset of both
            both = self.datasets[value].values
            return Figure(both[0], both[1], unit, meaning)
        estimate = self._estimate(error, is_attribute) if error else None
        return Figure(self.attrs[value] if is_attribute else self[value], estimate, unit, meaning)

    def _estimate(self, error: str, is_attribute: bool) -> Any:
        """An error; not a number where `estimated` beside it says that there is none, and None where there is none."""
        try:
            if is_attribute:
                return self.attrs[error] if self.attrs.get("estimated", 1) else None
            found, apart = self[error], error.rpartition("/")[0]
        except KeyError:  # where errors stand apart, not every group has them
            return None
        marks = self.groups[apart].datasets.get("estimated") if apart in self.groups else None
        if marks is None or marks.values.all():
            return found
        return frozen(np.where(marks.values != 0, found, np.nan)) if marks.values.any() else None

    def __getitem__(self, path: str) -> Member:
        if not isinstance(path, str):
            raise KeyError(path)
        name, _, rest = path.strip("/").partition("/")
        if name in self.groups:
            return self.groups[name][rest] if rest else self.groups[name]
        entry = self.datasets.get(self._parts.links.get(name, name))
        if entry is None or rest:
            raise KeyError(path)
        return entry.values

    def __iter__(self) -> Iterator[str]:
        yield from self.groups
        yield from self.datasets

    def __len__(self) -> int:
        return len(self.groups) + len(self.datasets)

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("_"):
            try:
                return self[name]
            except KeyError:
                if name in self.attrs:
                    return self.attrs[name]
        raise AttributeError(f"{type(self).__name__} has no {name!r}")

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a result does not change")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self, *self.attrs]

    def __eq__(self, other: object) -> bool:
        return self is other

    __hash__ = object.__hash__

    def __repr__(self) -> str:
        return f"<hdconj.{type(self).__name__}: {', '.join(self)}>"

    def _plain(self) -> tuple[Any, ...]:
        """The tuples that _from_layout() takes."""
        parts = self._parts
        groups = {name: group._plain() for name, group in parts.groups.items()}
        datasets = {name: tuple(entry) for name, entry in parts.datasets.items()}
        return dict(parts.attrs), datasets, dict(parts.links), groups, list(parts.figures)

    def __reduce__(self) -> tuple[Any, ...]:
        return Group._from_layout, (self._plain(),)

    def _scale(self, dim: str) -> Dataset | None:
        """Coordinates of a dimension, of this group or of one around it."""
        if dim in self.datasets and self.datasets[dim].dims == (dim,):
            return self.datasets[dim]
        return self._outer._scale(dim) if self._outer is not None else None

    def to_xarray(self) -> Any:
        """The datasets of this group as an ``xarray.Dataset`` with coordinates, units and meanings."""
        import xarray

        variables = {}
        for name, entry in self.datasets.items():
            variables[name] = (entry.dims, entry.values, {"units": entry.units, "long_name": entry.meaning})
        coordinates = {}
        for dim in {dim for entry in self.datasets.values() for dim in entry.dims}:
            if (scale := self._scale(dim)) is not None:
                coordinates[dim] = (scale.dims, scale.values, {"units": scale.units, "long_name": scale.meaning})
        own = {name: item for name, item in variables.items() if name not in coordinates}
        return xarray.Dataset(own, coordinates, dict(self.attrs))

    def to_pandas(self, dim: str | None = None) -> Any:
        """The columns over one dimension as a ``pandas.DataFrame``; units are in its ``attrs``.

        Parameters
        ----------
        dim : str, optional
            Name of the dimension; default that of the first column.
        """
        import pandas

        columns = {name: entry for name, entry in self.datasets.items() if len(entry.dims) == 1}
        dims = list(dict.fromkeys(entry.dims[0] for entry in columns.values()))
        if dim is not None and dim not in dims:
            raise KeyError(f"no column is over the dimension {dim!r}; known: {', '.join(dims) or 'none'}")
        dim = dim or next(iter(dims), None)
        chosen = {name: entry for name, entry in columns.items() if entry.dims == (dim,)}
        frame = pandas.DataFrame({name: entry.values for name, entry in chosen.items()})
        frame.attrs["units"] = {name: entry.units for name, entry in chosen.items()}
        return frame
