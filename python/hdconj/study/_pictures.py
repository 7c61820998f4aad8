# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a study, by matplotlib."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import hdconj

from .._files import write_whole
from ._shards import made_folder
from ._study import Study

GOOD, POOR, BEST = "#1f5fa8", "#b9c4d0", "#d0471f"
_DPI = 140
_ROOM = 52  # characters side by side under a pane
_MOST_UPRIGHT = 26  # words under a pane


def _label(study: Study, name: str) -> str:
    unit = study.frame.attrs["units"].get(name, "")
    return f"{name} [{unit}]" if unit not in ("", "1") else name


def _folded(label: str) -> str:
    """A long name in several lines, each of which ends with a part of it."""
    return re.sub(r"(\S{16,}?_)(?=\S)", r"\1\n", label)


def _fit(words: list[str]) -> bool:
    """Whether words fit side by side under a pane."""
    room = _ROOM / len(words)
    joined = [(len(one) + len(other)) / 2 + 1 for one, other in zip(words, words[1:])]
    return max(len(words[0]), len(words[-1])) <= room + 4 and all(each <= room for each in joined)


def _shortened(words: list[str]) -> tuple[list[str], str]:
    """Words without the parts that all begin and end with, and these around a star; whole where they share little."""
    begin = re.sub(r"[^\W_]*\Z", "", os.path.commonprefix(words))
    end = os.path.commonprefix([word[len(begin) :][::-1] for word in words])[::-1]
    end = re.sub(r"\A[^\W_]*", "", end)
    if len(words) < 2 or len(begin + end) < 3:
        return words, ""
    return [word[len(begin) : len(word) - len(end)] for word in words], f"{begin}*{end}"


def _write_words(pane: Any, words: list[str], key: str) -> int:
    """Words at the places 0, 1 ... of a pane, upright where they do not fit side by side; the length that they need."""
    short, shared = (words, "") if _fit(words) else _shortened(words)
    every, is_upright = -(-len(short) // _MOST_UPRIGHT), not _fit(short)
    pane.set_xticks(range(0, len(short), every), short[::every], fontsize=7, rotation=90 if is_upright else 0)
    pane.set_xlabel(f"{key}\n{shared}" if shared else key)
    return max(map(len, short)) if is_upright else 1


def _say_none(pane: Any) -> None:
    """Says in an empty pane that there is nothing to be seen, in place of scales that mean nothing."""
    pane.text(0.5, 0.5, "no value", transform=pane.transAxes, ha="center", va="center", color="0.4")
    pane.set_xticks([])
    pane.set_yticks([])


def _figure(columns: int, rows: int) -> tuple[Any, Any]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(3.4 * columns + 0.6, 2.9 * rows + 0.3), layout="constrained")
    panes = figure.subplots(rows, columns, squeeze=False)
    for pane in panes.flat:
        pane.locator_params(axis="x", nbins=4)
        pane.ticklabel_format(useOffset=False)
    return figure, panes


def _numeric(study: Study) -> list[str]:
    """Keys whose values are numbers."""
    paths = [key.path for key in study.recipe.keys]
    return [path for path in paths if study.frame[path].dtype.kind in "iuf"]


def keys_picture(study: Study) -> Any:
    """Every figure against every key that varies, words side by side; drives that break a constraint are pale."""
    keys, names = [key.path for key in study.recipe.keys], [name for name, _ in study.recipe.figures]
    if not keys:
        return None
    figure, panes = _figure(len(keys), len(names))
    good, numeric, tallest = study.feasible(), _numeric(study), 1
    for row, name in enumerate(names):
        for column, key in enumerate(keys):
            pane, places = panes[row, column], study.frame[key]
            is_last = row == len(names) - 1
            if is_last:
                pane.set_xlabel(_label(study, key))
            if study.frame[name].isna().all():
                _say_none(pane)
            if key in numeric and (width := places.max() - places.min()) > 0:
                pane.set_xlim(places.min() - 0.05 * width, places.max() + 0.05 * width)  # that of the whole column
            elif key not in numeric:
                places, words = places.astype(str).factorize(sort=True)
                pane.set_xticks(range(len(words)), [""] * len(words))
                pane.set_xlim(-0.5, len(words) - 0.5)
                tallest = max(tallest, _write_words(pane, list(words), key) if is_last else 1)
            for mask, colour, meaning in ((~good, POOR, "breaks a constraint"), (good, GOOD, "keeps all constraints")):
                pane.plot(places[mask], study.frame[name][mask], ".", ms=3, color=colour, label=meaning)
            if column == 0:
                pane.set_ylabel(_folded(_label(study, name)))
    if study.made(study.frame)[~good].any():
        panes[0, -1].legend(fontsize=7, markerscale=2, ncols=2, loc="lower right", bbox_to_anchor=(1, 1))
    figure.set_figheight(figure.get_figheight() + 0.055 * (tallest - 1))
    return figure


def histogram_picture(study: Study) -> Any:
    """How often a figure has a value, with its limits and the share that keeps them."""
    if not any(key.is_random for key in study.recipe.keys):
        return None
    names = [name for name, _ in study.recipe.figures]
    figure, panes = _figure(min(len(names), 3), -(-len(names) // 3))
    for pane in panes.flat[len(names) :]:
        pane.set_axis_off()
    for name, pane in zip(names, panes.flat):
        values = study.frame[name][study.independent()]  # a drive that cannot be made keeps no limits
        found = values.dropna()
        if found.empty:
            _say_none(pane)
        elif found.nunique() == 1:
            pane.plot(2 * [found.iloc[0]], [0, len(found)], color=GOOD, lw=4, solid_capstyle="butt")
            pane.set_xticks([found.iloc[0]])
            pane.set_ylim(bottom=0)
        else:
            pane.hist(found, bins="sturges", color=GOOD, edgecolor="white", linewidth=0.5)
        pane.set_xlabel(_label(study, name))
        pane.set_ylabel("drives")
        low, high = study.recipe.constraints.get(name, (-np.inf, np.inf))
        for limit in (low, high):
            if np.isfinite(limit):
                pane.axvline(limit, color=BEST, lw=1.2)
        if np.isfinite(low) or np.isfinite(high):
            pane.set_title(f"{100 * ((values >= low) & (values <= high)).mean():.1f} % within the limits", fontsize=9)
    return figure


def front_picture(study: Study) -> Any:
    """Pairs of objectives; drives that no other one beats are marked."""
    names = list(study.recipe.objectives)
    if len(names) < 2:
        return None
    pairs = [(a, b) for i, a in enumerate(names) for b in names[i + 1 :]]
    figure, panes = _figure(min(len(pairs), 3), -(-len(pairs) // 3))
    for pane in panes.flat[len(pairs) :]:
        pane.set_axis_off()
    is_good = study.feasible()
    good, poor = study.frame[is_good], study.frame[study.made(study.frame) & ~is_good]
    front = study.best(max(len(good), 1))
    for (a, b), pane in zip(pairs, panes.flat):
        shown = np.ones(len(poor), dtype=bool)  # axes are those of the drives that keep all constraints
        for name, axis in ((a, "x"), (b, "y")):
            span = good[name]
            if len(span) and (width := np.ptp(span)) > 0:
                low, high = span.min() - 0.08 * width, span.max() + 0.08 * width
                getattr(pane, f"set_{axis}lim")(low, high)
                shown &= np.asarray((poor[name] >= low) & (poor[name] <= high))
            aim = "small" if study.recipe.objectives[name] > 0 else "large"
            getattr(pane, f"set_{axis}label")(f"{_folded(_label(study, name))}, to be {aim}")
        if shown.any():
            pane.plot(poor[a][shown], poor[b][shown], ".", ms=3, color=POOR, label="breaks a constraint")
        pane.plot(good[a], good[b], ".", ms=3, color=GOOD, label="keeps all constraints")
        if study.frame[[a, b]].dropna().empty:
            _say_none(pane)
        ordered = front.sort_values(a)
        # no line joins drives of more objectives, or some that differ by less than their errors
        is_line = len(names) == 2 and (ordered[b].is_monotonic_increasing or ordered[b].is_monotonic_decreasing)
        pane.plot(ordered[a], ordered[b], "o-" if is_line else "o", ms=4, lw=0.8, color=BEST, label="beaten by none")
    panes[0, -1].legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1))  # beside the drives
    figure.set_figwidth(figure.get_figwidth() + 1.5)
    return figure


def parallel_picture(study: Study) -> Any:
    """Keys and objectives of the best drives as parallel coordinates, each from its least to its largest value."""
    if not study.recipe.objectives:
        return None
    columns = [*_numeric(study), *study.recipe.objectives]
    best = study.best(50)
    if best.empty or len(columns) < 2:
        return None
    figure, panes = _figure(1, 1)
    figure.set_size_inches(1.5 * len(columns) + 2, 4.2)
    pane = panes[0, 0]
    rows = study.frame[columns].dropna()
    low, span = rows.min(), np.ptp(rows, axis=0)
    scaled = (np.asarray(best[columns]) - np.asarray(low)) / np.where(span > 0, span, 1)
    for i in range(len(scaled) - 1, -1, -1):
        pane.plot(range(len(columns)), scaled[i], color=BEST if i == 0 else GOOD, lw=1.6 if i == 0 else 0.6)
    pane.set_xticks(range(len(columns)), [_label(study, column).replace(".", ".\n") for column in columns], fontsize=7)
    pane.set_yticks([])
    pane.set_ylim(-0.1, 1.1)
    several = f"the best {len(best)} drives; thick: the first of the list"
    pane.set_title(f"{several if len(best) > 1 else 'the best drive'}; axes: all drives with a result", fontsize=9)
    for i, column in enumerate(columns):
        pane.axvline(i, color="0.8", lw=0.6, zorder=0)
        for end, place in ((low[column], -0.04), (low[column] + span[column], 1.04)):
            pane.text(i, place, f"{end:.5g}", ha="center", va="center", fontsize=7, bbox={"color": "white", "pad": 1})
    return figure


def indices_picture(study: Study) -> Any:
    """Indices of Sobol as bars, of the figures whose values differ by more than their errors."""
    state = study.status()
    if study.recipe.method != "saltelli" or state["done"] != state["total"]:
        return None
    table = study.indices()
    names = [name for name in table["figure"].unique() if name not in table.attrs["equal"]]
    if not names:
        return None
    figure, panes = _figure(1, len(names))
    figure.set_figwidth(7)
    for name, pane in zip(names, panes.flat):
        part = table[table["figure"] == name]
        at = np.arange(len(part))
        for shift, word, colour in ((0.2, "first", POOR), (-0.2, "total", GOOD)):
            pane.barh(at + shift, part[word], 0.38, xerr=part[f"{word}_error"], color=colour, label=f"{word} index")
        pane.set_yticks(at, part["key"], fontsize=8)
        blocks, of = table.attrs["blocks"][name], study.recipe.count
        part_of = f",\nfrom {blocks} of {of} blocks" * (blocks < of)
        pane.set_title(f"share of the variance of {name}{part_of}", fontsize=9)
    panes.flat[0].legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1))  # beside the bars
    return figure


def tooth_picture(study: Study) -> Any:
    """The teeth of the best drive beside those of the first one, as they stand at the major axis."""
    if not study.recipe.objectives or not len(best := study.best(1)):
        return None
    recipe = study.recipe
    figure, panes = _figure(1, 1)
    figure.set_size_inches(7, 3.6)
    pane = panes[0, 0]
    drives = {"first": recipe.first, "best": recipe.restored(best.iloc[0])}
    for (word, values), colour in zip(drives.items(), ("0.55", BEST)):
        try:
            solution = hdconj.solve(recipe.scene_of(recipe.linked(values)))
        except (hdconj.InputError, hdconj.NumericalError):
            continue
        tooth, space = solution.flexspline.outline, solution.circular_spline.outline
        outline = space[len(space) // 2]
        height = sum(solution.figures[name].value for name in ("pitch_line", "r_0", "w0"))
        pane.plot(tooth[:, 0], tooth[:, 1] + height, "--", color=colour, lw=1.2, label=f"{word}: flexspline")
        pane.plot(outline[:, 0], outline[:, 1], "-", color=colour, lw=1.2, label=f"{word}: circular spline")
    pane.set_aspect("equal")
    pane.set_xlabel("x [mm]")
    pane.set_ylabel("distance from the axis [mm]")
    pane.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1))
    return figure


PICTURES: dict[str, Callable[[Study], Any]] = {
    "keys": keys_picture,
    "histograms": histogram_picture,
    "front": front_picture,
    "parallel": parallel_picture,
    "indices": indices_picture,
    "tooth": tooth_picture,
}


def draw_all(study: Study, folder: str | os.PathLike[str] | None = None) -> list[Path]:
    """Writes every picture that the study has something for; default into its folder ``pictures``."""
    from matplotlib import rc_context

    place = made_folder(Path(folder) if folder is not None else study.folder.place / "pictures")
    written = []
    with rc_context({"text.parse_math": False}):  # a $ in a name is no formula
        for name, draw in PICTURES.items():
            figure = draw(study) if len(study.frame) else None
            if figure is not None:
                written.append(place / f"{name}.png")
                write_whole(written[-1], partial(figure.savefig, dpi=_DPI, format="png"))
    return written
