# SPDX-License-Identifier: GPL-3.0-or-later
"""What the verbs return."""

from __future__ import annotations

import html
import json
import os
from typing import Any, NamedTuple, Self

from . import _core, _hdf5
from ._errors import Fault, InputError, fault_text
from ._scene import Scene
from ._tree import Figure, Group, Parts


class StepSolid(NamedTuple):
    """A solid of a STEP file, as :meth:`Result.to_step` wrote it.

    Attributes
    ----------
    name : str
        "circular-spline" or "flexspline".
    volume : Figure
        In mm^3; its error is the difference to the volume between the outlines themselves.
    deviation : float
        Largest distance in mm of the walls from the outlines of the slices.
    between : float or None
        Largest distance in mm from outlines between the slices: those that the program computes
        half way. Only of a circular spline that :func:`hdconj.solve` has not solved they are every
        second slice, for a surface without them. None where the wall is straight from plane to plane.
    is_sound : bool
        Whether Open CASCADE's own checks find a closed solid.
    """

    name: str
    volume: Figure
    deviation: float
    between: float | None
    is_sound: bool


class Result(Group):
    """Result of a verb: the groups and arrays of its file (docs/reference/hdf5.md), and its figures.

    Nothing is copied until it is asked for. A result does not change.
    """

    __slots__ = ("_made", "_scene", "_words")
    _made: _core.Result | None
    _scene: Scene
    _words: tuple[str, str, tuple[str, ...], float] | None
    _main = ""  # group that holds the figures of the verb itself

    @classmethod
    def _computed(cls, made: _core.Result, scene: Scene) -> Self:
        result = cls()
        for name, value in (("_made", made), ("_scene", scene), ("_words", None)):
            object.__setattr__(result, name, value)
        return result

    @classmethod
    def _restored(cls, layout: tuple[Any, ...], scene: Scene, words: tuple[str, str, tuple[str, ...], float]) -> Self:
        result = cls()
        for name, value in (("_made", None), ("_scene", scene), ("_words", words)):
            object.__setattr__(result, name, value)
        result._fill(layout)
        return result

    def __reduce__(self) -> tuple[Any, ...]:
        words = (self.json(), self.text(), self.missing, self.wall_seconds)
        return type(self)._restored, (self._plain(), self._scene, words)

    @property
    def _parts(self) -> Parts:
        if self._held is not None:
            return self._held
        assert self._made is not None
        return self._fill(self._made.layout())

    @property
    def scene(self) -> Scene:
        """The scene that was computed."""
        return self._scene

    def json(self) -> str:
        """The summary as ``--json`` of the program prints it (docs/reference/json.md)."""
        return self._made.json() if self._made is not None else self._words[0]  # type: ignore[index]

    def text(self) -> str:
        """The summary as the program prints it."""
        return self._made.text() if self._made is not None else self._words[1]  # type: ignore[index]

    def to_dict(self) -> dict[str, Any]:
        """:meth:`json` as dictionaries."""
        summary: dict[str, Any] = json.loads(self.json())
        return summary

    @property
    def missing(self) -> tuple[str, ...]:
        """Cases that have no result, each with its cause."""
        return tuple(self._made.missing) if self._made is not None else self._words[2]  # type: ignore[index]

    @property
    def wall_seconds(self) -> float:
        """Wall time of the computation in s."""
        return self._made.seconds if self._made is not None else self._words[3]  # type: ignore[index]

    @property
    def figures(self) -> dict[str, Figure]:
        """Figures of the drive and of the verb, each with its error."""
        found = dict(super().figures)
        for name in ("summary", self._main):
            if name in self.groups:
                found.update(self.groups[name].figures)
        return found

    def to_hdf5(self, file: str | os.PathLike[str]) -> None:
        """Write the result file that the program would write, by h5py.

        Raises
        ------
        InputError
            Of a :class:`Design`, which is a scene: write ``design.scene.to_toml()``, its rows are in :meth:`json`.
        """
        if isinstance(self, Design):
            reason, remedy = "a Design has no result file", "write design.scene.to_toml(), or solve(design.scene)"
            faults = (Fault("result", 0, "Design", reason, remedy),)
            raise InputError(faults, fault_text(faults))
        _hdf5.write(self, file)

    def report(self, file: str | os.PathLike[str]) -> None:
        """Write one HTML page (:func:`report`) of this result; of a verb that no page shows, of its scene.

        Raises
        ------
        InputError
            Of a :class:`NeutralCurve`: a page shows the drive that ``hdconj solve --completed DRIVE.toml`` writes.
        """
        from ._verbs import report

        is_shown = isinstance(self, (Solution, ContactStudy, LoadStudy, RunStudy))
        report(self if is_shown else self._scene, file)

    def to_xarray(self) -> Any:
        """All groups as an ``xarray.DataTree``."""
        import xarray

        def walk(group: Group, path: str) -> Any:
            own = Group.to_xarray(group) if isinstance(group, Result) else group.to_xarray()
            yield path, own
            for name, inner in group.groups.items():
                yield from walk(inner, f"{path.rstrip('/')}/{name}")

        return xarray.DataTree.from_dict(dict(walk(self, "/")))

    def to_pandas(self, dim: str | None = None) -> Any:
        """The main table of the verb as a ``pandas.DataFrame``; units are in its ``attrs``."""
        group = self[self._main] if self._main else self
        assert isinstance(group, Group)
        return Group.to_pandas(group, dim)

    def to_step(
        self,
        file: str | os.PathLike[str],
        *,
        part: str = "circular-spline",
        tolerance: float = 1e-3,
        outer_radius: float | None = None,
        deformed: bool | None = None,
    ) -> tuple[StepSolid, ...]:
        """Write rings as solids into a STEP file in mm; needs the extra ``cad``.

        Along an outline walls are cubic B-splines. From slice to slice they are straight where the
        slices are, else cubic. Both rings are as wide as the circular spline. The major axis is y,
        and z is 0 in the middle of the bearing.

        Parameters
        ----------
        file : path
            NAME.step.
        part : str
            "circular-spline", "flexspline" (its toothed ring), or "assembly": both in mesh.
        tolerance : float
            Largest distance in mm of the walls from the outlines of the slices.
        outer_radius : float, optional
            Of the circular spline's ring in mm; None: the scene's ``compliance.outer_radius``, or
            1.4 times its root radius.
        deformed : bool, optional
            The flexspline as it lies on the wave generator without load; None: in the assembly only.

        Returns
        -------
        tuple of StepSolid
            In the order in which they were written.
        """
        try:
            from . import _cad
        except ImportError as error:
            raise ImportError("to_step() needs Open CASCADE: pip install 'hdconj[cad]'") from error
        return _cad.to_step(self, file, part, tolerance, outer_radius, deformed)

    def plot(self, ax: Any = None) -> Any:
        """Draw the result with matplotlib.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Axes to draw into; default new ones.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        InputError
            Of a :class:`Design`, which has no drawing: draw ``solve(design.scene)``.
        """
        from . import _plot

        return _plot.draw(self, ax)

    def __bool__(self) -> bool:
        """True: a result that has no groups is one too."""
        return True

    def __repr__(self) -> str:
        return f"<hdconj.{type(self).__name__} of {self._scene.name!r}>"

    def _repr_html_(self) -> str:
        rows = []
        for name, figure in self.figures.items():
            if getattr(figure.value, "ndim", 0):
                continue
            error = "" if figure.error is None else f"&plusmn; {figure.error:.2g}"
            unit = "" if figure.unit == "1" else html.escape(figure.unit)
            rows.append(
                f"<tr><td>{html.escape(name)}</td><td>{figure.value:.9g}</td><td>{error}</td><td>{unit}</td>"
                f"<td>{html.escape(figure.meaning)}</td></tr>"
            )
        head = "<tr><th>figure</th><th>value</th><th>error</th><th>unit</th><th>meaning</th></tr>"
        return f"<p>{html.escape(repr(self))}</p><table>{head}{''.join(rows)}</table>"

    def _repr_svg_(self) -> str | None:
        from . import _plot

        return _plot.outline_svg(self)


def _with_pairs(frame: Any, group: Group, names: tuple[str, ...], parts: tuple[str, str]) -> Any:
    """A table of a group, with two columns for each dataset of pairs."""
    for name in names:
        for part, values in zip(parts, group.datasets[name].values.T):
            frame[f"{name}_{part}"] = values
            frame.attrs["units"][f"{name}_{part}"] = group.datasets[name].units
    return frame


class Solution(Result):
    """Result of :func:`hdconj.solve`: the conjugate circular spline."""

    __slots__ = ()

    def to_pandas(self, dim: str | None = None) -> Any:
        """The conjugate zones as a ``pandas.DataFrame``, with begin and end of u, phi and t."""
        zones = self.groups["conjugate_zones"]
        return _with_pairs(zones.to_pandas(dim or "zone"), zones, ("u", "phi", "t"), ("begin", "end"))


class ContactStudy(Result):
    """Result of :func:`hdconj.contact`: one column entry for each surface, kind and tilt."""

    __slots__ = ()
    _main = "contact"


class LoadStudy(Result):
    """Result of :func:`hdconj.load`: the drive under torque."""

    __slots__ = ()
    _main = "load"


class RunStudy(Result):
    """Result of :func:`hdconj.run`: the drive while it turns."""

    __slots__ = ()
    _main = "running"

    def to_pandas(self, dim: str | None = None) -> Any:
        """The positions of the first sequence as a ``pandas.DataFrame``; units are in its ``attrs``."""
        return self.groups["running"].groups["sequence_000"].to_pandas(dim)


class WireProgram(Result):
    """Result of :func:`hdconj.wedm`: paths of the wire in both faces, set-up by set-up."""

    __slots__ = ()
    _main = "set_up_1"

    def to_pandas(self, dim: str | None = None) -> Any:
        """The moves of the first pass as a ``pandas.DataFrame``, with x and y of the wire in both faces."""
        moves = self.groups["set_up_1"].groups["pass_1"]
        return _with_pairs(moves.to_pandas(dim), moves, ("lower", "upper"), ("x", "y"))


class Accuracy(Result):
    """Result of :func:`hdconj.accuracy`: one record for each run."""

    __slots__ = ()
    _main = "records"


class NeutralCurve(Result):
    """Result of :func:`hdconj.find_neutral_curve`: the curve on which two given teeth touch."""

    __slots__ = ()
    _main = "wanted_curve"


class Inspection(Result):
    """Result of :func:`hdconj.inspect`: measured points against the nominal outline."""

    __slots__ = ()
    _main = "inspection"

    def to_pandas(self, dim: str | None = None) -> Any:
        """The measured points and their deviations as a ``pandas.DataFrame``."""
        points = self["inspection/points"]
        assert isinstance(points, Group)
        return points.to_pandas(dim)


class Measurement(Result):
    """Result of :func:`hdconj.read_measured`: a torque-twist curve and what it says."""

    __slots__ = ()

    def _kept(self) -> _core.Result:
        if self._made is None:
            raise ValueError("a measurement that was pickled cannot be compared with: read its file again")
        return self._made


class Design(Result):
    """Result of :func:`hdconj.design`; the drive is :attr:`scene`, its rows are in :meth:`to_dict`."""

    __slots__ = ()

    def to_pandas(self, dim: str | None = None) -> Any:
        """The rows of the design as a ``pandas.DataFrame``; it has no other dimension."""
        import pandas

        if dim not in (None, "row"):
            raise KeyError(f"no column is over the dimension {dim!r}; known: row")
        return pandas.DataFrame(self.to_dict()["rows"])
