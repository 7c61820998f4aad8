# SPDX-License-Identifier: GPL-3.0-or-later
"""Both rings of a drive as solids, from the arrays of its result."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn

import numpy as np
from scipy.interpolate import make_interp_spline

from . import _core, _loft, _results, _step, _verbs
from ._errors import Fault, InputError
from ._tree import Array, Figure

if TYPE_CHECKING:
    from ._results import Result

PARTS = ("circular-spline", "flexspline", "assembly")
RIM = 1.4  # outer radius of a ring whose scene gives none, over its root radius


class _Ring(NamedTuple):
    solid: Any
    exact: float
    """Volume between the outlines in mm^3."""
    deviation: float
    between: float | None


def _refuse(path: str, value: str, reason: str, remedy: str) -> NoReturn:
    said = f"{path} = {value}" if value else path
    raise InputError((Fault(path, 0, value, reason, remedy),), f"{said}: {reason}; {remedy}")


def _teeth(result: Result, member: str) -> int:
    return int(result.scene.to_dict()["drive"][f"{member}_teeth"])


def _planes(result: Result) -> Array:
    """Heights of the slices; of one slice both ends of the width."""
    z = np.asarray(result["circular_spline/z"])
    if len(z) > 1:
        return z
    width = result.scene.to_dict().get("circular_spline", {}).get("width")
    if width is None:
        _refuse("circular_spline.width", "", "a ring of one slice has no width", "write it in mm into the scene")
    return np.array([-width / 2, width / 2])


def _turned(points: Array, angle: float) -> Array:
    """Clockwise about the axis."""
    cosine, sine = np.cos(angle), np.sin(angle)
    turned: Array = points @ np.array([[cosine, -sine], [sine, cosine]])
    return turned


def _volume(z: Array, outlines: Array) -> float:
    """Inside of closed outlines (slice, point, xy): Simpson's rule where the wall is straight from plane to plane."""
    if _loft.is_straight(z, outlines):
        a, m, b = (float(_loft.area(each)) for each in (outlines[0], outlines[[0, -1]].mean(axis=0), outlines[-1]))
        return float(z[-1] - z[0]) * (a + 4 * m + b) / 6
    areas: Any = make_interp_spline(z, _loft.area(outlines), min(3, len(z) - 1))
    return float(areas.integrate(z[0], z[-1]))


def _between(result: Result, z: Array, outlines: Array) -> float | None:
    """Distance of a surface cubic from slice to slice from outlines that it has not seen.

    Those of a solution are the program's own half way between the slices. Those of another result are every second
    slice, for a surface through the rest: an upper bound.
    """
    if _loft.is_straight(z, outlines):
        return None
    if isinstance(result, _results.Solution):
        finer = _verbs.solve(result.scene.with_({"slices.count": 2 * len(z) - 1}))
        unseen = np.asarray(finer["circular_spline/z"])[1::2], np.asarray(finer["circular_spline/outline"])[1::2]
    else:
        unseen = z[1:-1:2], outlines[1:-1:2]
        z, outlines = z[::2], outlines[::2]
    surface: Any = make_interp_spline(z, outlines, min(3, len(z) - 1))
    return max(_loft.distance(outline, surface(height)) for height, outline in zip(*unseen))


def _closed(walls: list[_loft.Strip]) -> list[_loft.Strip]:
    """Each wall ends where the next begins, to the last bit."""
    following = [*walls[1:], walls[0]]
    return [
        wall._replace(poles=np.concatenate([wall.poles[:, :-1], after.poles[:, :1]], axis=1))
        for wall, after in zip(walls, following)
    ]


def _circular_spline(result: Result, tolerance: float, outer_radius: float | None) -> _Ring:
    z, teeth = _planes(result), _teeth(result, "circular_spline")
    outlines = np.asarray(result["circular_spline/outline"])
    outlines = np.broadcast_to(outlines, (len(z), *outlines.shape[1:]))
    root = float(np.linalg.norm(outlines, axis=2).max())
    outer = outer_radius or result.scene.to_dict().get("compliance", {}).get("outer_radius") or RIM * root
    if not outer > root:
        _refuse("outer_radius", f"{outer:g}", "the ring ends inside of its teeth", f"write more than {root:.6g} mm")
    straight = _loft.is_straight(z, outlines)
    ends = _loft.cuts(outlines, np.asarray(result["circular_spline/landmarks"]), 5 * tolerance)
    found = [_loft.fit(outlines[:, a : b + 1], tolerance) for a, b in zip(ends[:-1], ends[1:])]
    strips = [_loft.loft(each, z, straight) for each in found]
    pitch = 2 * np.pi / teeth
    walls = _closed([strip.turned(pitch * i) for i in range(teeth) for strip in strips])
    hole = np.concatenate([_turned(outlines, pitch * i) for i in range(teeth)], axis=1)
    low, high = float(z[0]), float(z[-1])
    return _Ring(
        _step.solid_of(_step.Loop(float(outer), False), _step.Loop(walls, True), low, high),
        np.pi * outer**2 * (high - low) - _volume(z, hole),
        max(each.deviation for each in found),
        _between(result, z, outlines),
    )


def _poses(result: Result, z: Array, pitches: float, deformed: bool) -> Array:
    """Sine, cosine and origin (tooth, plane, 4) of the teeth's frames, or of places that far behind them."""
    teeth = _teeth(result, "flexspline")
    if deformed:
        planes = z if len(np.asarray(result["circular_spline/z"])) > 1 else np.zeros(1)
        found = np.asarray(_core.flexspline_poses(result.scene._core, planes.tolist(), pitches))
        rows = found.reshape(teeth, len(planes), 4)
    else:
        phi = 2 * np.pi * (np.arange(teeth) + pitches) / teeth
        r_m = result.figures["r_m"].value
        rows = np.stack([np.sin(phi), np.cos(phi), r_m * np.sin(phi), r_m * np.cos(phi)], axis=1)[:, None]
    return np.asarray(np.broadcast_to(rows, (teeth, len(z), 4)))


def _placed(points: Array, poses: Array) -> Array:
    """Points (n, 2) of a frame in poses (..., 4): (..., n, 2)."""
    sine, cosine, x, y = (poses[..., i, None] for i in range(4))
    px, py = points.T
    return np.stack([cosine * px + sine * py + x, cosine * py - sine * px + y], axis=-1)


def _roots(result: Result, tooth: Array, places: Array, middles: Array) -> Array:
    """Points (tooth, plane, point, xy) from each tooth's right foot to the left one of the next.

    A parabola through the wall's own place half way between the teeth.
    """
    radius = result.figures["r_m"].value
    height = np.hypot(tooth[[0, -1], 0], radius + tooth[[0, -1], 1]).mean() - radius
    feet = _placed(tooth[[0, -1]], places)
    dips = _placed(np.array([[0, height]]), middles)[:, :, 0]
    through = np.stack([feet[:, :, 1], dips, np.roll(feet[:, :, 0], -1, axis=0)])
    share = np.linspace(0, 1, 9)
    weights = np.stack([(1 - share) * (1 - 2 * share), 4 * share * (1 - share), share * (2 * share - 1)], axis=1)
    roots: Array = np.einsum("sj,jtkx->tksx", weights, through)
    roots[:, :, 0], roots[:, :, -1] = through[0], through[2]
    return roots


def _rim(points: Array, z: Array, tolerance: float, straight: bool) -> tuple[list[_loft.Strip], Array]:
    """Walls through closed curves (plane, point, xy), in four parts, and their outlines."""
    count = points.shape[1]
    curve: Any = make_interp_spline(
        np.arange(count + 1), np.concatenate([points, points[:, :1]], axis=1), 3, bc_type="periodic", axis=1
    )
    outlines = curve(np.linspace(0, count, 8 * count + 1))
    outlines[:, -1] = outlines[:, 0]
    ends = np.linspace(0, 8 * count, 5).round().astype(int)
    found = [_loft.fit(outlines[:, a : b + 1], tolerance) for a, b in zip(ends[:-1], ends[1:])]
    return _closed([_loft.loft(each, z, straight) for each in found]), outlines


def _between_teeth(result: Result, z: Array, tooth: Array, teeth: Array) -> float:
    """Distance of teeth (tooth, plane, point, xy) made cubic over z from those half way between the planes."""
    finer = np.linspace(z[0], z[-1], 2 * len(z) - 1)
    surface: Any = make_interp_spline(z, teeth, min(3, len(z) - 1), axis=1)
    off = surface(finer[1::2]) - _placed(tooth, _poses(result, finer, 0.0, True)[:, 1::2])
    return float(np.linalg.norm(off, axis=-1).max())


def _flexspline(result: Result, tolerance: float, deformed: bool) -> _Ring:
    z, figures = _planes(result), result.figures
    tooth = np.asarray(result["flexspline/outline"]) + [0, figures["pitch_line"].value]
    places, middles = (_poses(result, z, pitches, deformed) for pitches in (0.0, 0.5))
    roots = _roots(result, tooth, places, middles)
    ends = _loft.cuts(tooth[None], np.array([]), 5 * tolerance)
    found = [_loft.fit(tooth[None, a : b + 1], tolerance) for a, b in zip(ends[:-1], ends[1:])]
    teeth = _placed(tooth, places)
    outline = np.concatenate([teeth, roots], axis=2).transpose(1, 0, 2, 3).reshape(len(z), -1, 2)
    straight = _loft.is_straight(z, outline)
    walls = []
    for place, root in zip(places, roots):
        own = [each._replace(poles=_placed(each.poles[0], place)) for each in found]
        walls += [_loft.loft(each, z, straight) for each in [*own, _loft.fit(root, tolerance)]]
    inner, r_m = float(figures["flexspline_inner_radius"].value), figures["r_m"].value
    low, high = float(z[0]), float(z[-1])
    hole, empty = _step.Loop(inner, True), np.pi * inner**2 * (high - low)
    if deformed:
        wall = np.stack([_placed(np.array([[0, inner - r_m]]), each)[:, :, 0] for each in (places, middles)], axis=1)
        strips, curves = _rim(wall.reshape(-1, len(z), 2).transpose(1, 0, 2), z, tolerance, straight)
        hole, empty = _step.Loop(strips, True), _volume(z, curves)
    solid = _step.solid_of(_step.Loop(_closed(walls), False), hole, low, high)
    between = None if straight else _between_teeth(result, z, tooth, teeth)
    return _Ring(solid, _volume(z, outline) - empty, max(each.deviation for each in found), between)


def to_step(
    result: Result,
    file: str | os.PathLike[str],
    part: str,
    tolerance: float,
    outer_radius: float | None,
    deformed: bool | None,
) -> tuple[_results.StepSolid, ...]:
    """See :meth:`hdconj.Result.to_step`."""
    if part not in PARTS:
        _refuse("part", part, "is no word that this argument takes", f"write one of {', '.join(PARTS)}")
    if not tolerance > 0:
        _refuse("tolerance", f"{tolerance:g}", "must be above 0", "write a distance in mm such as 1e-3")
    if "circular_spline" not in result.groups:
        raise TypeError(f"{result!r} has no outlines: write those of solve() or contact()")
    rings = {}
    if part != "flexspline":
        rings["circular-spline"] = _circular_spline(result, tolerance, outer_radius)
    if part != "circular-spline":
        rings["flexspline"] = _flexspline(result, tolerance, part == "assembly" if deformed is None else deformed)
    _step.write({name: ring.solid for name, ring in rings.items()}, file)
    made = []
    for name, ring in rings.items():
        volume = _step.volume_of(ring.solid)
        figure = Figure(volume, abs(volume - ring.exact), "mm^3", "volume; error: difference to that of the outlines")
        made.append(_results.StepSolid(name, figure, ring.deviation, ring.between, _step.is_sound(ring.solid)))
    return tuple(made)
