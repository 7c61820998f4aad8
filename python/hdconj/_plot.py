# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings of results, by matplotlib; one of the tooth space as SVG, without it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from . import _results
from ._errors import Fault, InputError, fault_text


def _labelled(ax: Any, x: str, y: str) -> None:
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if len(ax.get_legend_handles_labels()[1]) > 1:
        ax.legend()


def _case_names(group: Any) -> list[str]:
    names = zip(group.surface, group.kind, strict=True)
    return [f"{surface}, {kind}" if kind else str(surface) for surface, kind in names]


def _solution(result: Any, ax: Any) -> None:
    """The tooth space of each slice, the branches behind it, and the tooth at the major axis."""
    for name, branch in result.envelope.groups.items():
        ax.plot(*branch.point.T, color="0.75", linewidth=0.8, label="envelope" if name == "branch_000" else None)
    for z, outline in zip(result.circular_spline.z, result.circular_spline.outline, strict=True):
        ax.plot(*outline.T, label=f"circular spline, z = {z:g} mm")
    spline = result.circular_spline.outline
    margin = 0.3 * (spline[..., 1].max() - spline[..., 1].min())
    ax.set_xlim(spline[..., 0].min(), spline[..., 0].max())
    ax.set_ylim(spline[..., 1].min() - margin, spline[..., 1].max() + margin)
    ax.set_aspect("equal")
    _labelled(ax, "x [mm]", "y [mm]")


def _contact(result: Any, ax: Any) -> None:
    """Contact area of each surface and kind against tilt, as shares of the flanks."""
    contact = result.contact
    error = contact.get("contact_fraction_error")  # None: errors were not asked for
    for case in dict.fromkeys(_case_names(contact)):
        of_case = [i for i, name in enumerate(_case_names(contact)) if name == case]
        ax.errorbar(
            contact.tilt[of_case] * (180 / math.pi),
            contact.contact_fraction[of_case] * 100,
            error[of_case] * 100 if error is not None else None,
            fmt="o-",
            capsize=3,
            label=case,
        )
    _labelled(ax, "tilt [deg]", "contact area [% of the flanks]")


def _load(result: Any, ax: Any) -> None:
    """Torque against twist of each case."""
    load = result.load
    for i, case in enumerate(_case_names(load)):
        curve = load[f"case_{i:03}/curve"]
        order = curve.torque.argsort()
        twist = curve.twist[order] * (180 * 60 / math.pi)
        ax.plot(twist, curve.torque[order] / 1000, ".-", label=f"{case}, {load.tilt[i] * 180 / math.pi:g} deg")
    _labelled(ax, "twist of the circular spline [arcmin]", "torque [N m]")


def _running(result: Any, ax: Any) -> None:
    """Transmission error of each sequence over its positions, the mean left out."""
    for name in sorted(key for key in result.running if key.startswith("sequence_")):
        sequence = result.running[name]
        to_arcsec = 180 * 3600 / math.pi
        label = f"{sequence.attrs['span']}, {sequence.attrs['torque_Nmm'] / 1000:g} N m"
        error = (sequence.error - sequence.error.mean()) * to_arcsec
        ax.plot(sequence.angle * (180 / math.pi), error, ".-", label=label)
    _labelled(ax, "angle of the wave generator [deg]", "transmission error [arcsec]")


def _wire(result: Any, ax: Any) -> None:
    """The contour and the first pass in both faces of the first set-up."""
    part = result.set_up_1
    for face in ("lower", "upper"):
        ax.plot(*part[face].T, linewidth=0.8, label=f"part, {face} face")
        ax.plot(*part[f"pass_1/{face}"].T, linewidth=0.8, label=f"wire, {face} face")
    ax.set_aspect("equal")
    _labelled(ax, "x [mm]", "y [mm]")


def _accuracy(result: Any, ax: Any) -> None:
    """Error against time of every method."""
    records = result.to_pandas()
    for (study, method), rows in records.groupby(["study", "method"]):
        ax.loglog(rows["seconds"], rows["error"], "o", label=f"{study}: {method}")
    _labelled(ax, "time [s]", "error [mm]")


def _inspection(result: Any, ax: Any) -> None:
    """Deviations along the flanks."""
    points = result.inspection.points
    for side in ("left", "right"):
        chosen = (points.flank == side) & (points.fate == "used")
        ax.plot(points.arc_length[chosen], points.deviation[chosen] * 1000, ".", label=f"{side} flanks")
    _labelled(ax, "arc length from the root [mm]", "deviation [um]")


def _neutral_curve(result: Any, ax: Any) -> None:
    """The neutral curve and the surface of the cam."""
    for name in ("neutral_curve", "inner_surface"):
        ax.plot(*result[name].T, label=name.replace("_", " "))
    ax.set_aspect("equal")
    _labelled(ax, "x [mm]", "y [mm]")


def _measurement(result: Any, ax: Any) -> None:
    """The samples of the test rig."""
    ax.plot(result.twist * (180 * 60 / math.pi), result.torque / 1000, ".")
    _labelled(ax, "twist at the output [arcmin]", "torque [N m]")


_DRAWINGS: dict[type, Callable[[Any, Any], None]] = {
    _results.Solution: _solution,
    _results.ContactStudy: _contact,
    _results.LoadStudy: _load,
    _results.RunStudy: _running,
    _results.WireProgram: _wire,
    _results.Accuracy: _accuracy,
    _results.NeutralCurve: _neutral_curve,
    _results.Inspection: _inspection,
    _results.Measurement: _measurement,
}


def draw(result: _results.Result, ax: Any = None) -> Any:
    """Draws a result into axes of matplotlib, by default new ones, and returns them."""
    drawing = _DRAWINGS.get(type(result))
    if drawing is None:
        name = type(result).__name__
        faults = (Fault("result", 0, name, f"{name} has no drawing", "draw its drive: solve(result.scene).plot()"),)
        raise InputError(faults, fault_text(faults))
    if ax is None:
        import matplotlib.pyplot as plt

        ax = plt.figure().add_subplot()
    drawing(result, ax)
    ax.set_title(result.scene.name)
    return ax


def outline_svg(result: _results.Result) -> str | None:
    """The tooth space of each slice as SVG; None where the result has none."""
    if "circular_spline" not in result.groups:
        return None
    outlines = result.groups["circular_spline"].datasets["outline"].values
    left, right = outlines[..., 0].min(), outlines[..., 0].max()
    bottom, top = outlines[..., 1].min(), outlines[..., 1].max()
    lines = (
        "".join(f'<polyline points="{" ".join(f"{x:.5f},{-y:.5f}" for x, y in outline)}"/>' for outline in outlines)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="480" viewBox="{left} {-top} {right - left} {top - bottom}">'
        f'<g fill="none" stroke="#1f77b4" stroke-width="{(right - left) / 400}">{lines}</g></svg>'
    )
