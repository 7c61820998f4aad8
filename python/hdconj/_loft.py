# SPDX-License-Identifier: GPL-3.0-or-later
"""Outlines of slices as surfaces: B-splines along the outline, straight or cubic from slice to slice."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline
from scipy.spatial import KDTree

from ._tree import Array

SHARP = 0.1  # rad; a chord turns by less where the outline is round
FEWEST = 32  # points of an outline between two cuts
STRAIGHT = 1e-5  # mm; slices so near to straight lines between the end planes are on them


class Strip(NamedTuple):
    """A surface over the arc length of an outline and z: poles of a B-spline in both."""

    poles: Array
    """(along z, along the outline, xyz) in mm"""
    knots: Array
    """Along the outline, ends repeated."""
    z_knots: Array
    degree: int
    z_degree: int

    def turned(self, angle: float) -> Strip:
        """The same, turned clockwise about the axis."""
        cosine, sine = np.cos(angle), np.sin(angle)
        turn = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
        return self._replace(poles=self.poles @ turn)


class Fit(NamedTuple):
    """Curves through the same piece of all outlines, with the same knots."""

    poles: Array
    """(slice, pole, xy) in mm"""
    knots: Array
    degree: int
    deviation: float
    """Largest distance from the outlines in mm."""


def fit(points: Array, tolerance: float) -> Fit:
    """Few poles that stay within a distance of polylines (slice, point, xy); both ends are met.

    The distance is taken at points and middles of chords with the same parameter, which is no less than the true one.
    Where half as many poles as points do not suffice, the polylines themselves.
    """
    place, points = _with_middles(points)
    count = len(place)
    middle = (place[1:] + place[:-1]) / 2
    chords = (points[:, 1:] + points[:, :-1]) / 2
    spans = 1
    while spans + 3 < count / 2:
        inner = place[np.linspace(0, count - 1, spans + 1).round().astype(int)[1:-1]]
        knots = np.concatenate([np.zeros(4), inner, np.ones(4)])
        basis = BSpline.design_matrix(place, knots, 3).toarray()
        poles = np.empty((len(points), basis.shape[1], 2))
        poles[:, 0], poles[:, -1] = points[:, 0], points[:, -1]
        rest = points - np.einsum("ij,kjx->kix", basis[:, [0, -1]], poles[:, [0, -1]])
        flat = rest.transpose(1, 0, 2).reshape(count, -1)
        found = np.linalg.lstsq(basis[:, 1:-1], flat, rcond=None)[0]
        poles[:, 1:-1] = found.reshape(-1, len(points), 2).transpose(1, 0, 2)
        off = [np.einsum("ij,kjx->kix", basis, poles) - points]
        off.append(np.einsum("ij,kjx->kix", BSpline.design_matrix(middle, knots, 3).toarray(), poles) - chords)
        deviation = max(float(np.linalg.norm(each, axis=2).max()) for each in off)
        if deviation <= tolerance:
            return Fit(poles, knots, 3, deviation)
        spans += max(1, spans // 2)
    return Fit(points, np.concatenate([[0], place, [1]]), 1, 0)


def _with_middles(points: Array) -> tuple[Array, Array]:
    """Places 0 ... 1 along polylines (slice, point, xy), and the points, with more of them on long chords."""
    steps = np.linalg.norm(np.diff(points, axis=1), axis=2).mean(axis=0)
    keep = np.concatenate([[True], steps > 0])
    points, steps = points[:, keep], steps[steps > 0]
    parts = np.ceil(FEWEST * steps / steps.sum()).astype(int)
    at = np.concatenate([i + np.arange(count) / count for i, count in enumerate(parts)] + [[len(parts)]])
    first = np.minimum(at.astype(int), len(parts) - 1)
    share = (at - first)[:, None]
    place = np.interp(at, np.arange(len(parts) + 1), np.concatenate([[0], np.cumsum(steps)]) / steps.sum())
    place[-1] = 1
    return place, (1 - share) * points[:, first] + share * points[:, first + 1]


def is_straight(z: Array, points: Array) -> bool:
    """Whether all slices (slice, point, xy) lie on straight lines between the first and the last."""
    if len(z) < 3:
        return True
    share = ((z - z[0]) / (z[-1] - z[0]))[:, None, None]
    return bool(np.abs(points - points[0] - share * (points[-1] - points[0])).max() < STRAIGHT)


def loft(found: Fit, z: Array, straight: bool) -> Strip:
    """The surface through the curves of the slices at z."""
    poles = np.concatenate([found.poles, np.broadcast_to(z[:, None, None], (*found.poles.shape[:2], 1))], axis=2)
    if straight:
        return Strip(poles[[0, -1]], found.knots, np.repeat(z[[0, -1]], 2), found.degree, 1)
    across: Any = make_interp_spline(z, poles, min(3, len(z) - 1))
    return Strip(across.c, found.knots, across.t, found.degree, across.k)


def cuts(points: Array, marks: Array, least: float) -> Array:
    """Numbers of the points where outlines (slice, point, xy) are cut: both ends, marks, and sharp corners.

    Where two would be nearer than `least` in mm, the latter is left out.
    """
    steps = np.diff(points, axis=1)
    turn = np.zeros(points.shape[1])
    before, after = steps[:, :-1], steps[:, 1:]
    cross = before[..., 0] * after[..., 1] - before[..., 1] * after[..., 0]
    turn[1:-1] = np.abs(np.arctan2(cross, (before * after).sum(axis=2))).max(axis=0)
    arc = np.concatenate([[0], np.cumsum(np.linalg.norm(steps, axis=2).max(axis=0))])
    last = points.shape[1] - 1
    chosen = [0]
    for number in sorted({*np.flatnonzero(turn > SHARP).tolist(), *(int(mark) for mark in marks)}):
        if arc[number] - arc[chosen[-1]] > least and arc[last] - arc[number] > least:
            chosen.append(number)
    return np.array([*chosen, last])


def distance(points: Array, curve: Array) -> float:
    """Largest distance of points (n, 2) from a polyline (m, 2)."""
    nearest = KDTree(curve).query(points)[1]
    found = np.full(len(points), np.inf)
    for first in (np.maximum(nearest - 1, 0), np.minimum(nearest, len(curve) - 2)):
        begin, along = curve[first], curve[first + 1] - curve[first]
        share = ((points - begin) * along).sum(axis=1) / np.maximum((along * along).sum(axis=1), 1e-300)
        foot = begin + np.clip(share, 0, 1)[:, None] * along
        found = np.minimum(found, np.linalg.norm(points - foot, axis=1))
    return float(found.max())


def area(points: Array) -> Any:
    """Areas of closed polygons (..., point, xy), positive."""
    ahead = np.roll(points, -1, axis=-2)
    return np.abs((points[..., 0] * ahead[..., 1] - points[..., 1] * ahead[..., 0]).sum(axis=-1)) / 2
