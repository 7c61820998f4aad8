# SPDX-License-Identifier: GPL-3.0-or-later
"""What studies answer: samples, tolerances, indices, the best drives, pictures."""

import math
import os
import time

import numpy as np
import pytest
from conftest import SOURCE

import hdconj

study = pytest.importorskip("hdconj.study")
pytest.importorskip("distributed")
from hdconj.study import _drive  # noqa: E402
from hdconj.study.__main__ import print_indices, print_status, print_table  # noqa: E402
from hdconj.study._expression import Expression  # noqa: E402
from hdconj.study._indices import with_half_widths  # noqa: E402
from hdconj.study._optimise import Search  # noqa: E402
from hdconj.study._pictures import (  # noqa: E402
    draw_all,
    front_picture,
    histogram_picture,
    indices_picture,
    keys_picture,
    parallel_picture,
    tooth_picture,
)
from hdconj.study._front import dominated  # noqa: E402
from hdconj.study._sample import _whole  # noqa: E402
from hdconj.study._study import _ranks  # noqa: E402

FULL = bool(os.environ.get("HDCONJ_FULL"))
HEAD = """
[set]
"solver.tolerance" = 1e-3
[compute]
verb = "solve"
"""


@pytest.fixture(scope="module")
def run(scheduler):
    """Runs a study and opens it."""

    def run(text, folder):
        study.run(study.read_recipe(HEAD + text), folder, scheduler=scheduler, progress=False)
        return study.open(folder)

    return run


def sample(method, count, seed=1):
    return study.read_recipe(
        f"{HEAD}[vary]\na = {{ uniform = [2, 4] }}\nb = {{ normal = [1, 0.1] }}\n"
        f'[sample]\nmethod = "{method}"\ncount = {count}\nseed = {seed}\n[figures]\nab = "a * b"'
    )


@pytest.mark.parametrize("method", ["sobol", "random"])
def test_a_sample_depends_on_seed_and_number_alone(method):
    short, long = sample(method, 37), sample(method, 1000)
    assert [short.values(i) for i in range(37)] == [long.values(i) for i in range(37)]
    assert long.values(3) != sample(method, 1000, 2).values(3)


@pytest.mark.parametrize("method", ["sobol", "random", "lhs"])
def test_distributions(method):
    made = sample(method, 2048)
    values = np.array([[made.values(i)[name] for name in ("a", "b")] for i in range(made.drives)])
    assert values[:, 0].min() >= 2 and values[:, 0].max() <= 4
    assert values.mean(axis=0) == pytest.approx([3, 1], abs=0.05)
    assert values.std(axis=0) == pytest.approx([2 / math.sqrt(12), 0.1], rel=0.1)


@pytest.mark.parametrize("grade, low, high", [("js7", 24.9895, 25.0105), ("h7", 24.979, 25), ("H6", 25, 25.013)])
def test_classes_of_tolerance_are_those_of_iso_286(grade, low, high):
    made = study.read_recipe(
        f'{HEAD}[vary]\n"circular_spline.inner_radius" = {{ nominal = 25, tolerance = "{grade}" }}\n'
        '[figures]\na = "1.0"'
    )
    key = made.keys[0]
    assert key.value(0) == pytest.approx(low, abs=1e-9) and key.value(1) == pytest.approx(high, abs=1e-9)
    # The zone is six standard deviations wide, less what the ends cut off.
    assert key.value(0.8413) - key.value(0.5) == pytest.approx((high - low) / 6, rel=0.01)


def test_a_grid_and_its_xarray(run, tmp_path):
    found = run(
        '[vary]\n"flexspline.wall" = { from = 0.6, to = 0.8, count = 3 }\n'
        '"solver.kinematics" = { list = ["exact", "first-order"] }\n"drive.flexspline_teeth" = { list = [198, 200] }\n'
        '"drive.circular_spline_teeth" = "drive.flexspline_teeth + 2"\n"circular_spline.inner_radius" = '
        '"25.025 + (drive.flexspline_teeth - 200) * 0.125"\n[sample]\nmethod = "grid"\n[figures]\nr = "solve.r_m"',
        tmp_path,
    )
    assert len(found.frame) == 12 and (found.frame["code"] == "").all(), found.frame
    cube = found.to_xarray()
    assert dict(cube.sizes) == {"flexspline.wall": 3, "solver.kinematics": 2, "drive.flexspline_teeth": 2}
    one = cube.sel({"flexspline.wall": 0.6, "solver.kinematics": "exact", "drive.flexspline_teeth": 200})
    alone = hdconj.solve(hdconj.Scene().with_({"flexspline.wall": 0.6, "solver.tolerance": 1e-3}))
    assert float(one["r"]) == alone.figures["r_m"].value
    found.to_csv(tmp_path / "rows.csv")
    assert (tmp_path / "rows.csv").read_text().count("\n") == 13


def test_a_grid_whose_list_has_a_value_twice(run, tmp_path):
    keys = "[vary]\na = { list = [1, 2, 1] }\nb = { list = [3, 4] }\n"
    found = run(f'{keys}[sample]\nmethod = "grid"\n[figures]\nc = "a * b"', tmp_path)
    assert len(found.frame) == 6
    assert found.to_xarray()["c"].values.tolist() == [[3, 4], [6, 8]]


MIXED = """
[vary]
"flexspline.profile.concave_offset" = { list = [FIRST] }
n = { list = [1, 2.5] }
[sample]
method = "grid"
[figures]
r = "solve.r_m"
n2 = "n * n"
[objectives]
r = "max"
"""


@pytest.mark.parametrize("values", ['0.7, "tangent"', '"tangent", 0.7'])
def test_a_list_of_numbers_and_words(run, tmp_path, values):
    """Its column is text whatever the order; scenes have the number again, and a picture has both as words."""
    found = run(MIXED.replace("FIRST", values), tmp_path)
    assert sorted(found.frame["flexspline.profile.concave_offset"]) == ["0.7", "0.7", "tangent", "tangent"]
    assert (found.frame["code"] == "").all()
    for number in range(4):
        kept = found.recipe.restored(found.frame.iloc[number])
        assert kept == found.recipe.values(number) and [*map(type, kept.values())] == [
            *map(type, found.recipe.values(number).values())
        ]
    assert [file.name for file in draw_all(found)] == ["keys.png", "parallel.png", "tooth.png"]
    words, numbers = keys_picture(found).axes[2:]
    assert [label.get_text() for label in words.get_xticklabels()] == ["0.7", "tangent"]
    assert {x for line in words.lines for x in line.get_xdata()} == {0, 1}
    assert {x for line in numbers.lines for x in line.get_xdata()} == {1, 2.5}
    assert parallel_picture(found).axes[0].get_title().startswith("the best 4 drives; thick")
    found.frame = found.frame[:1]
    assert parallel_picture(found).axes[0].get_title() == "the best drive; axes: all drives with a result"


def test_a_study_of_words_has_pictures(run, tmp_path):
    text = MIXED.replace("[FIRST]", '["tangent"]').replace("n = { list = [1, 2.5] }", "").replace('n2 = "n * n"', "")
    assert [file.name for file in draw_all(run(text, tmp_path))] == ["keys.png", "tooth.png"]


def test_fewer_drives_than_before(run, tmp_path):
    """The study is what it is now: rows of more drives stay, and do not count."""
    text = '[vary]\na = { from = 0, to = 1 }\n[figures]\nb = "a"\n[objectives]\nb = "max"\n[sample]\ncount = '
    all_rows = run(text + "20", tmp_path).frame
    found = run(text + "8", tmp_path)
    state = found.status()
    assert (state["done"], state["total"], state["seconds_left"]) == (8, 8, 0)
    assert found.frame.equals(all_rows[:8]) and found.best(20)["sample"].max() < 8
    assert run(text + "20", tmp_path).frame.equals(all_rows)


def test_figures_use_keys_that_do_not_vary(run, tmp_path):
    text = '[vary]\n"flexspline.wall" = { list = [0.6, 0.7] }\n[figures]\nland = "solve.land_width / drive.module"\n'
    found = run(text, tmp_path)
    whole = hdconj.solve(hdconj.Scene().with_({"flexspline.wall": 0.6, "solver.tolerance": 1e-3}))
    assert found.frame["land"][0] == whole.figures["land_width"].value / 0.25


def test_the_best_are_different_drives(run, tmp_path):
    """A list has few values, so that samples repeat them."""
    text = "[vary]\na = { list = [1, 2, 3] }\n[sample]\ncount = 20\n[figures]\nb = 'a'\nc = '-a'\n[objectives]\n"
    for number, aims in enumerate((text + "b = 'min'\n", text + "b = 'min'\nc = 'min'\n")):
        assert list(run(aims, tmp_path / str(number)).best(5)["a"]) == [1, 2, 3]


@pytest.mark.parametrize("method, is_sample", [("random", True), ("grid", False)])
def test_a_share_has_an_interval_where_drives_are_a_sample(run, tmp_path, capsys, method, is_sample):
    text = '[vary]\na = { list = [1, 2] }\n[figures]\nb = "a"\n[constraints]\nb = { max = 1 }\n[sample]\nmethod = "X"'
    print_status(run(text.replace('"X"', f'"{method}"'), tmp_path))
    told = capsys.readouterr().out
    assert "% keep all constraints" in told and ("confidence" in told) == is_sample


def test_a_figure_without_a_value_breaks_no_constraint_of_another_one(run, tmp_path, capsys):
    """Half of the drives have no lnk; those between 0 and 1 keep the limit of fine."""
    text = (
        '[vary]\nx = { normal = [0, 1] }\n[sample]\ncount = 128\n[figures]\nlnk = "sqrt(x)"\nfine = "x"\n'
        "[constraints]\nfine = { max = 1 }\n"
    )
    found = run(text, tmp_path)
    assert found.yield_of()[0] == pytest.approx(0.841, abs=0.01)
    lacking = int((found.frame["x"] < 0).sum())
    print_status(found)
    assert f"128 of 128 drives, 0 that cannot be made, {lacking} that lack a figure\n" in capsys.readouterr().out
    found.recipe = study.read_recipe(HEAD + text + '[objectives]\nlnk = "min"')
    assert found.feasible().sum() == ((found.frame["x"] >= 0) & (found.frame["x"] <= 1)).sum()


FAILING = """
[vary]
"flexspline.wall" = { from = 0.6, to = 0.8 }
"wave_generator.radial_deformation" = { from = 0.02, to = 0.27 }
[sample]
count = 24
[figures]
depth = { value = "1000 * solve.space_depth", unit = "um" }
land = "solve.land_width"
[objectives]
depth = "max"
"""


def test_units_and_axes_where_drives_cannot_be_made(run, tmp_path):
    """The drive in the middle is none of those that can be made: their shards have the units."""
    found = run(FAILING, tmp_path)
    assert 0 < (found.frame["code"] == "").sum() < 24 and found.about["first"]
    keys = ["flexspline.wall", "wave_generator.radial_deformation"]
    assert found.frame.attrs["units"] == {**dict.fromkeys(keys, "mm"), "depth": "um", "land": "mm"}
    labels = [pane.get_xlabel() for pane in keys_picture(found).axes]
    assert [label for label in labels if label] == [f"{key} [mm]" for key in keys]
    cube = found.to_xarray()
    assert all(cube[key].attrs["units"] == "mm" for key in keys)
    assert cube["land"].attrs["units"] == cube["land_error"].attrs["units"] == "mm"
    assert cube["depth"].attrs["units"] == "um"
    pane = parallel_picture(found).axes[0]
    drawn = [line.get_ydata() for line in pane.lines if len(line.get_ydata()) == 3]
    assert len(drawn) > 1 and np.min(drawn) >= 0 and np.max(drawn) <= 1
    made = found.frame[found.frame["code"] == ""]["wave_generator.radial_deformation"]
    ends = [text.get_text() for text in pane.texts[2:4]]
    assert ends == [f"{made.min():.5g}", f"{made.max():.5g}"]


def test_expressions():
    known = {"a.b": 2.0, "c": 3}
    for text in ("1 + 2 * a.b", "-c ** 2 / 4", "max(a.b, c) - min(1, c)", "sqrt(c) * sin(pi / a.b)", "c // 2 + c % 2"):
        meant = {"sqrt": math.sqrt, "sin": math.sin, "pi": math.pi, "c": 3, "max": max, "min": min}
        assert Expression(text)(known) == eval(text.replace("a.b", "2.0"), meant)
    value, error = Expression("a.b * c").with_error(known, {"a.b": 0.1, "c": 0.2})
    assert value == 6 and error == pytest.approx(2.1 * 3.2 - 6)
    assert math.isnan(Expression("a.b * c").with_error(known, {"c": math.nan})[1])
    with pytest.raises(ArithmeticError):
        Expression("9.0 ** 9 ** 9")({})


def test_errors_of_figures_change_together():
    """The error of an expression of several figures bounds what all corners of their intervals give."""
    known = {name: 1.0 + i for i, name in enumerate("abcdefg")}
    errors = dict.fromkeys(known, 0.1)
    for text, error in (
        ("a * b", 1.1 * 2.1 - 2), ("a / b", 1.1 / 1.9 - 0.5), ("c * (a - b)", 3.1 * 1.2 - 3), ("3 * a", 0.3),
        ("a + b + c + d + e + f + g", 0.7), ("max(a, b)", 0.1), ("1 / (1 + a ** 2)", 1 / 1.81 - 0.5),
    ):  # fmt: skip
        assert Expression(text).with_error(known, errors)[1] == pytest.approx(error, abs=1e-12), text
    assert math.isnan(Expression("max(b, a)").with_error(known, {"a": math.nan, "b": 0.1})[1])


@pytest.mark.parametrize("text", [
    "1 / a", "b / a", "1 / a ** 2", "1 / abs(a)", "1 / (a * b)", "a ** -1", "1 / (b - c)", "b // a", "b % a", "1 / -a",
    "1 / sqrt(a + 0.15)", "tan(pi / 2 + a)", "b / (a / c)",
])  # fmt: skip
def test_an_error_over_a_pole_is_not_determined(text):
    """The divisor may be zero, though both of its ends are not."""
    value, error = Expression(text).with_error({"a": 0.05, "b": 1.0, "c": 1.1}, {"a": 0.2, "b": 0.1, "c": 0.1})
    assert math.isfinite(value) and math.isnan(error)


def test_yield_and_pictures(run, tmp_path):
    found = run(
        '[vary]\n"flexspline.wall" = { normal = [0.7, 0.01] }\n[sample]\ncount = 256\n[figures]\n'
        'wall = "flexspline.wall"\nland = "solve.land_width"\n[constraints]\nwall = { min = 0.69, max = 0.71 }',
        tmp_path,
    )
    share, low, high = found.yield_of()
    assert low < share < high and share == pytest.approx(math.erf(1 / math.sqrt(2)), abs=0.02)
    assert [file.name for file in draw_all(found)] == ["keys.png", "histograms.png"]


THREE = """
[vary]
x = { normal = [0.5, 0.1] }
"drive.name" = { list = ["a rather long word", "another one"] }
[sample]
count = 16
[figures]
f = "x"
g = "1 - x"
a_long_name_of_a_figure_of_the_study = "x ** 2"
same = "3.0"
[constraints]
f = { max = 0.5 }
[objectives]
f = "min"
g = "min"
a_long_name_of_a_figure_of_the_study = "min"
"""


def test_what_pictures_show(run, tmp_path):
    """Words once, colours with their meaning, long names folded, no line over three objectives, no wide constant."""
    found = run(THREE, tmp_path)
    figure = keys_picture(found)
    words = [[label.get_text() for label in pane.get_xticklabels()] for pane in figure.axes[1::2]]
    assert words == [["", ""]] * 3 + [["a rather long word", "another one"]]
    colours = {text.get_text() for text in figure.axes[1].get_legend().get_texts()}
    assert colours == {"breaks a constraint", "keeps all constraints"}
    assert figure.axes[4].get_ylabel() == "a_long_name_of_a_\nfigure_of_the_study"
    assert all(line.get_linestyle() == "None" for pane in front_picture(found).axes for line in pane.lines)
    constant = histogram_picture(found).axes[3]
    assert not constant.patches and list(constant.lines[0].get_xdata()) == [3, 3]


FOLDERS = """
[vary]
x = { normal = [0.5, 0.1] }
"drive.name" = { list = [NAMES] }
[sample]
count = 16
[figures]
f = "x"
none = "log(x - 100)"
[objectives]
f = "min"
none = "min"
"""


@pytest.mark.parametrize("count, length", [(2, 3), (3, 30), (3, 80), (40, 4)])
def test_words_of_pictures_do_not_lie_over_each_other(run, tmp_path, count, length):
    """However many and long they are; what all share is said once. A figure without any value has no scales."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    names = [f"data/a{chr(97 + i % 26) * length}{i}.csv" for i in range(count)]
    found = run(FOLDERS.replace("NAMES", ", ".join(f'"{name}"' for name in names)), tmp_path)
    figure = keys_picture(found)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    pane = figure.axes[-1]
    labels = [label for label in pane.get_xticklabels() if label.get_text()]
    boxes = [label.get_window_extent(canvas.get_renderer()) for label in labels]
    assert len(labels) > 1 and not any(one.overlaps(other) for one, other in zip(boxes, boxes[1:]))
    assert pane.get_window_extent().height > 100
    begin, star, end = pane.get_xlabel().partition("\n")[2].partition("*")
    assert {f"{begin}{label.get_text()}{end}" for label in labels} <= set(names) and bool(star) == (count * length > 9)
    assert len({axis.get_xlim() for axis in figure.axes[1::2]}) == 1
    empty = [*figure.axes[2:], histogram_picture(found).axes[1], front_picture(found).axes[0]]
    assert [axis.texts[0].get_text() for axis in empty] == 4 * ["no value"]
    assert not any(len(axis.get_yticks()) for axis in empty) and not len(empty[0].get_xticks())


def test_indices_of_a_sum(run, tmp_path):
    """Var(3 a + b) is nine parts of a and one of b."""
    found = run(
        '[vary]\na = { uniform = [0, 1] }\nb = { uniform = [0, 1] }\n[sample]\nmethod = "saltelli"\ncount = 128\n'
        '[figures]\ny = "3 * a + b"',
        tmp_path,
    )
    table = found.indices()
    assert list(table["key"]) == ["a", "b"]
    assert list(table["first"]) == pytest.approx([0.9, 0.1], abs=0.05)
    assert list(table["total"]) == pytest.approx([0.9, 0.1], abs=0.05)
    assert [file.name for file in draw_all(found)][-1] == "indices.png"
    picture = indices_picture(found)
    picture.draw_without_rendering()
    (pane,) = picture.axes
    assert pane.get_legend().get_window_extent().x0 >= pane.get_window_extent().x1  # covers no bar
    assert table.attrs["blocks"] == {"y": 128}

    # A study that runs, or has lost a shard: what is left of its blocks is not taken for whole ones.
    gone = found.frame["sample"].between(30, 44)
    found.frame = found.frame[~gone].reset_index(drop=True)
    part = found.indices()
    assert part.attrs["blocks"] == {"y": 123}  # samples 28 to 47 are those of five
    assert list(part["total"]) == pytest.approx([0.9, 0.1], abs=0.05)


@pytest.mark.parametrize("keys, count", [(4, 8), (8, 16)])
def test_half_widths_of_indices_hold(keys, count):
    """One of 20 intervals of 95 % may miss. The indices of one key are exact, however few blocks there are."""
    misses, places = [], np.arange(keys)
    weights = 1 / (1 + places)
    for seed in range(20):
        drives = _whole("saltelli", count, seed, keys).reshape(count, keys + 2, keys)
        for key in places:
            assert with_half_widths(drives[..., key])[key] == pytest.approx([1, 0, 1, 0], abs=1e-12)
        first, of_first, total, of_total = with_half_widths(drives @ weights).T
        share = weights**2 / (weights**2).sum()
        assert (first >= 0).all() and (total <= 1).all()
        misses += [*(abs(first - share) > of_first), *(abs(total - share) > of_total)]
    assert np.mean(misses) < 0.1


def test_indices_say_from_what_they_are(run, tmp_path, capsys):
    """Blocks may lack a drive, and values may differ within their errors alone."""
    found = run(
        '[vary]\na = { uniform = [0, 1] }\nb = { uniform = [0, 1] }\n[sample]\nmethod = "saltelli"\ncount = 32\n'
        '[figures]\ny = "sqrt(3 * a + b - 1)"\nz = "a"\nsame = "0 * a"\nnone = "sqrt(a - 2)"',
        tmp_path,
    )
    found.frame["z_error"] = 0.5
    print_indices(found)
    y, z, same, none = capsys.readouterr().out.splitlines()
    blocks = found.indices().attrs["blocks"]["y"]
    assert 2 < blocks < 32 and y.startswith("y: a matters most") and y.endswith(f", from {blocks} of 32 blocks")
    equal = "no key matters, its values differ by no more than their errors"
    assert (z, same) == (f"z: {equal}", f"same: {equal}")
    assert none == "none: too few drives for indices, from 0 of 32 blocks"
    titles = [pane.get_title() for pane in indices_picture(found).axes]
    assert titles == [f"share of the variance of y,\nfrom {blocks} of 32 blocks"]
    found.frame["z_error"] = 0.4
    print_indices(found)
    assert "z: a matters most" in capsys.readouterr().out


def test_an_error_that_was_not_estimated_is_no_number():
    for verb, result in (("solve", hdconj.solve()), ("contact", hdconj.contact(errors=False))):
        values, errors, _ = _drive.figures_of(verb, result, False)
        assert set(errors) == set(values) and all(math.isnan(error) for error in errors.values())


@pytest.mark.parametrize("verb, options", [
    ("solve", {}), ("contact", {}), ("contact", {"errors": False}),
    ("load", {"torque": 5, "curve": False}), ("load", {"torque": 5, "curve": False, "errors": False}),
])  # fmt: skip
def test_figures_of_a_row_are_those_of_the_result(verb, options):
    """Workers read them without the arrays of the result: the same values, errors and units."""
    scene = hdconj.Scene.load(os.path.join(os.environ["HDCONJ_SOURCE"], "data/scenes/type-50-elastic.toml"))
    small = {"slices.count": 3, "contact.flank_points": 20, "solver.tolerance": 1e-3}
    result = getattr(hdconj, verb)(scene.with_(small), **options)
    values, errors, units = _drive.figures_of(verb, result, True)
    assert len(result.figures) > 20
    for name, figure in result.figures.items():
        assert units[f"{verb}.{name}"] == figure.unit
        value, error = (np.asarray(np.nan if each is None else each, dtype=float).reshape(-1)[-1]
                        for each in (figure.value, figure.error))  # fmt: skip
        assert np.array_equal(values[f"{verb}.{name}"], value, equal_nan=True), name
        assert np.array_equal(errors.get(f"{verb}.{name}", np.nan), error, equal_nan=True), name
    assert f"{verb}.conjugate_zone_length" in values
    assert f"{verb}.conjugate_zone_length" not in _drive.figures_of(verb, result, True, {f"{verb}.r_m"})[0]


def test_figures_of_inner_groups_have_one_value():
    """Those over slices and members have several, none of which is the drive's; of several torques the last counts."""
    scene = hdconj.Scene.load(SOURCE / "data/scenes/type-50-elastic.toml")
    small = scene.with_({"slices.count": 3, "contact.flank_points": 20, "solver.tolerance": 1e-3})
    options = {"contact": {"errors": False}, "load": {"torque": 5, "points": 2, "errors": False}}
    for verb, several in (("contact", {"z", "amplitude", "flank_clearance"}), ("load", {"members.twist"})):
        result = getattr(hdconj, verb)(small, **options[verb])
        values = _drive.figures_of(verb, result, False)[0]
        inner = dict(figures_in(result[verb], verb))
        assert {f"{verb}.case_000.{name}" for name in several} <= {*inner} - {*values}
        for path, value in inner.items():
            is_over_torques = path.startswith("load.case_000.curve.")
            assert (path in values) == (is_over_torques or np.size(value) == 1), path
            assert path not in values or np.array_equal(values[path], np.ravel(value)[-1], equal_nan=True), path
        assert not {*inner} & {*_drive.figures_of(verb, result, False, {f"{verb}.backlash"})[0]}


def figures_in(group, path):
    """Figures of the groups in a group."""
    for name, inner in group.groups.items():
        yield from ((f"{path}.{name}.{figure}", found.value) for figure, found in inner.figures.items())
        yield from figures_in(inner, f"{path}.{name}")


def test_better_is_beyond_the_error():
    values = np.array([[1.0, 1.0], [1.05, 1.0], [1.3, 1.0], [0.5, 2.0]])
    assert list(dominated(values, np.full((4, 2), 0.1))) == [False, False, True, False]
    assert list(dominated(values, np.zeros((4, 2)))) == [False, True, True, False]
    assert list(dominated(values, np.full((4, 2), np.nan))) == [False, True, True, False]
    assert _ranks(np.array([1.0, 1.05, 1.3, 1.31]), np.full(4, 0.1)) == [1, 1, 3, 3]


def test_an_unknown_error_claims_no_difference():
    """It counts as the largest that is known among other drives, and gives no rank."""
    values, errors = np.array([[1.0, 1.0], [1.15, 1.0], [1.3, 1.0]]), np.array([[0.1, 0.0], [np.nan] * 2, [np.nan] * 2])
    assert list(dominated(values, errors)) == [False, False, True]
    assert _ranks(values[:, 0], errors[:, 0]) == [1, None, None]
    assert _ranks(np.array([1.0, 1.1, 1.2, 1.35]), np.array([np.nan, 0.1, 0.1, 0.1])) == [None, 2, 2, 4]
    assert _ranks(np.array([1.0, 2.0]), np.full(2, np.nan)) == [None, None]


@pytest.mark.parametrize("objectives", [2, 3])
def test_beaten_designs_are_those_that_one_beats(objectives):
    """As the definition says, with ties, errors, and errors that are not known; and quickly of many designs."""
    draws = np.random.default_rng(objectives)
    for number in range(40):
        values = draws.integers(0, 6, (50, objectives)) / 3 if number % 2 else draws.random((50, objectives))
        errors = draws.random((50, objectives)) * draws.choice([0, 0.03, 1])
        errors[draws.random(errors.shape) < 0.2] = np.nan
        known = np.where(np.isnan(errors), np.nanmax(errors, axis=0), errors)
        beaten = [((values <= value).all(axis=1) & (values + known < value - error).any(axis=1)).any()
                  for value, error in zip(values, known)]  # fmt: skip
        assert list(dominated(values, errors)) == beaten
    many = draws.random((30000, objectives))
    begin = time.process_time()
    assert 0 < (~dominated(many, np.zeros_like(many))).sum() < 1000
    assert time.process_time() - begin < 10


TWO = """
[vary]
x = { from = 0.0, to = 1.0 }
y = { from = 0.0, to = 1.0 }
[figures]
f = "(x - 0.3) ** 2 + (y - 0.6) ** 2"
g = "(x - 0.7) ** 2 + (y - 0.6) ** 2"
[objectives]
f = "min"
"""
SEARCH = '[optimise]\nmethod = "{}"\npopulation = 10\ngenerations = {}\nseed = 3\n'


@pytest.fixture(scope="module")
def search(scheduler):
    """Searches for the best drives and opens what was found."""

    def search(text, method, generations, folder, population=10):
        options = SEARCH.format(method, generations).replace("population = 10", f"population = {population}")
        sought = study.read_recipe(text + options)
        study.optimise(sought, folder, scheduler=scheduler, progress=False)
        return study.open(folder)

    return search


@pytest.mark.parametrize("method", ["nsga2", "cmaes"])
def test_a_search_goes_on_where_it_was(search, tmp_path, method):
    whole = search(HEAD + TWO, method, 6, tmp_path / "whole").frame
    assert len(whole) == 6 * 10
    search(HEAD + TWO, method, 2, tmp_path / "parts")
    again = search(HEAD + TWO, method, 6, tmp_path / "parts").frame
    assert whole.equals(again)
    assert whole["f"].min() < 0.01


NARROW = TWO + "[constraints]\ng = { max = 0.0002 }\n"


def told(sought, generations):
    """A search that is told what its drives of NARROW are worth, without workers; what it asked for."""
    algorithm, asked = Search(sought), []
    while len(asked) < generations and (units := algorithm.ask()) is not None:
        asked.append(units)
        f, g = (((units - centre) ** 2).sum(axis=1) for centre in ((0.3, 0.6), (0.7, 0.6)))
        algorithm.tell(f[:, None], np.maximum(g - 0.0002, 0) / 0.0002)
    return asked


def test_cmaes_finds_the_drives_that_keep_the_constraints():
    """No early drive does: how far each is from keeping them leads there."""
    sought = study.read_recipe(HEAD + NARROW + SEARCH.format("cmaes", 30))
    asked = told(sought, 30)
    assert len(asked) == 30 and np.array_equal(asked, told(sought, 30))
    keeps = [((units - (0.7, 0.6)) ** 2).sum(axis=1) <= 0.0002 for units in asked]
    assert not any(each.any() for each in keeps[:3]) and keeps[-1].any()
    best = min(units[kept, 0].min() for units, kept in zip(asked, keeps) if kept.any())
    assert best == pytest.approx(0.7 - math.sqrt(0.0002), abs=1e-3)


def test_cmaes_goes_on_where_no_early_drive_can_be_made():
    algorithm = Search(study.read_recipe(HEAD + NARROW + SEARCH.format("cmaes", 20)))
    for _ in range(20):
        assert algorithm.ask() is not None
        algorithm.tell(np.full((10, 1), np.nan), np.full(10, 1e30))


def test_a_search_that_ends_early_says_so(search, tmp_path, capsys, monkeypatch):
    own = Search.ask
    monkeypatch.setattr(Search, "ask", lambda self: own(self) if self.algorithm.n_iter in (None, 1, 2) else None)
    print_status(search(HEAD + TWO, "cmaes", 5, tmp_path))
    said = capsys.readouterr().out
    assert "the search ended after 2 of 5 generations: the drives of CMA-ES differ too little to go on" in said
    monkeypatch.undo()
    print_status(search(HEAD + TWO, "cmaes", 5, tmp_path))
    assert "ended" not in capsys.readouterr().out


def test_pareto_set(search, tmp_path):
    """Points between (0.3, 0.6) and (0.7, 0.6) are beaten by none."""
    found = search(HEAD + TWO + 'g = "min"\n', "nsga2", 8, tmp_path)
    best = found.best(20)
    assert (abs(best["y"] - 0.6) < 0.2).all() and best["x"].between(0.2, 0.8).all()
    assert len(list((tmp_path / "pareto").glob("*.toml"))) == len(found.best(200))
    assert hdconj.Scene.load(tmp_path / "best.toml").check() == ()
    assert {"front.png", "parallel.png", "tooth.png"} <= {file.name for file in draw_all(found)}
    tooth, space = (line.get_ydata() for line in tooth_picture(found).axes[0].lines[:2])
    assert max(tooth) < max(space)  # the tip is below the root of the space


def test_all_of_a_large_pareto_set_are_written(search, tmp_path):
    """No drive beats another one here; best.toml is the one nearest to the best of both."""
    text = HEAD + '[vary]\nx = { from = 0, to = 1 }\n"flexspline.wall" = "0.6 + 0.1 * x"\n'
    text += '[figures]\nf = "x"\ng = "1 / (0.01 + x)"\n[objectives]\nf = "min"\ng = "min"\n'
    found = search(text, "random", 2, tmp_path, population=125)
    assert len(list((tmp_path / "pareto").glob("*.toml"))) == len(found.frame) == 250
    f, g = ((found.frame[name] - found.frame[name].min()) / np.ptp(found.frame[name]) for name in "fg")
    wanted = found.recipe.scene_of(found.values(found.frame.iloc[int((f * f + g * g).argmin())]))
    assert hdconj.Scene.load(tmp_path / "best.toml").to_toml() == wanted.to_toml()


def test_a_search_that_finds_nothing_leaves_no_best(search, tmp_path):
    limits = "[constraints]\nf = {{ max = {} }}\n"
    text = HEAD + TWO + 'g = "min"\n'
    search(text + limits.format(3), "random", 2, tmp_path)
    assert (tmp_path / "best.toml").exists() and list((tmp_path / "pareto").iterdir())
    found = search(text + limits.format(-1), "random", 2, tmp_path)
    assert len(found.frame) == 20 and not found.feasible().any()
    assert not (tmp_path / "best.toml").exists() and not list((tmp_path / "pareto").iterdir())


def test_a_refused_search_leaves_the_folder_as_it_was(search, tmp_path):
    text, limits = HEAD + TWO + 'g = "min"\n', "[constraints]\nf = {{ max = {} }}\n"
    search(text + limits.format(1), "nsga2", 3, tmp_path)
    before = (tmp_path / "study.toml").read_text()
    with pytest.raises(hdconj.InputError, match="asks for other drives"):
        search(text + limits.format(0.1), "nsga2", 4, tmp_path)
    assert (tmp_path / "study.toml").read_text() == before
    assert len(search(text + limits.format(1), "nsga2", 4, tmp_path).frame) == 40


@pytest.mark.parametrize("left", [0, 5, 60, 150])
def test_a_search_goes_on_where_a_generation_is_damaged(search, tmp_path, left):
    whole = search(HEAD + TWO, "nsga2", 3, tmp_path).frame
    file = tmp_path / "asked" / "000001.npy"
    content = file.read_bytes()
    file.write_bytes(content[:left])
    assert search(HEAD + TWO, "nsga2", 3, tmp_path).frame.equals(whole)
    assert file.read_bytes() == content


def test_another_search_is_refused_where_rows_are_lost(search, tmp_path):
    text, limits = HEAD + TWO + 'g = "min"\n', "[constraints]\nf = {{ max = {} }}\n"
    search(text + limits.format(1), "nsga2", 3, tmp_path)
    for shard in (tmp_path / "rows").iterdir():
        shard.unlink()
    with pytest.raises(hdconj.InputError, match="asks for other drives"):
        search(text + limits.format(0.1), "nsga2", 3, tmp_path)


OPTIONS = """
scene = "SCENE"
[set]
"slices.count" = 3
"contact.flank_points" = 20
"circular_spline.backlash_offset" = "auto"
"solver.tolerance" = 1e-3
[vary]
"wave_generator.radial_deformation" = { from = 0.248, to = 0.252 }
[compute]
verb = "load"
load = { torque = 5, tilts_deg = [0.1], surfaces = "tilted", curve = false }
[figures]
twist = "load.twist"
at = "2 * tilt.angle_deg"
[objectives]
twist = "min"
"""


def test_the_best_scene_has_what_options_say(search, tmp_path):
    """Alone it gives the figures of the table; an option that is no key of a scene stands in its head."""
    text = OPTIONS.replace("SCENE", str(SOURCE / "data/scenes/type-50-elastic.toml"))
    found = search(text, "random", 1, tmp_path, population=2)
    best = found.best(1).iloc[0]
    assert best["code"] == "" and best["at"] == 0.2
    for scene in (tmp_path / "best.toml", found.scene(int(best["sample"]))):
        assert hdconj.load(scene, curve=False).figures["twist"].value[0] == best["twist"]
    head = "# The figures of the study are those of hdconj.load(SCENE, curve=False).\n"
    assert (tmp_path / "best.toml").read_text().startswith(head)


def test_options_in_which_verbs_differ_stay_options():
    text = OPTIONS.replace('verb = "load"', 'verb = ["load", "contact"]')
    text = text.replace("SCENE", str(SOURCE / "data/scenes/type-50-elastic.toml"))
    found = study.read_recipe(text.replace('at = "2 * tilt.angle_deg"', ""))
    assert dict(found.verbs)["load"] == {"tilts_deg": [0.1], "surfaces": "tilted", "curve": False}
    assert found.scene.to_dict()["load"]["torque"] == 5 and "tilt" not in found.scene.to_dict()


SURVIVING = """
scene = "SCENE"
[set]
"slices.count" = 3
"contact.flank_points" = 20
[vary]
"wave_generator.radial_deformation" = { from = 0.23, to = 0.27 }
[sample]
count = COUNT
[compute]
verb = "contact"
survivors = SURVIVORS
[figures]
area = "contact.contact_area"
[objectives]
area = "AIM"
"""


def test_survivors_are_those_of_the_study_as_it_is(scheduler, tmp_path, capsys):
    def run(count, survivors, aim):
        text = SURVIVING.replace("SCENE", str(SOURCE / "data/scenes/type-50-coned.toml"))
        text = text.replace("COUNT", str(count)).replace("SURVIVORS", str(survivors)).replace("AIM", aim)
        study.run(study.read_recipe(text), tmp_path, scheduler=scheduler, progress=False)
        return study.open(tmp_path)

    few = run(1, 1, "max")
    assert few.best(5)["area"].tolist() == [few.frame["area"].max()] and few.best()["area_error"].notna().all()
    more = run(8, 0, "max")
    assert more.frame["area"].max() > few.frame["area"].max()
    assert more.best(1)["area"][0] == more.frame["area"].max()
    least = run(8, 2, "min")
    assert least.best(5)["area"].tolist() == sorted(least.frame["area"])[:5]
    best = least.best(5)
    assert best["area_error"].notna().tolist() == best["rank"].notna().tolist() == [True, True, False, False, False]
    print_table(best)
    said = capsys.readouterr()
    assert [line.split()[0] for line in said.out.splitlines()[3:]] == ["-"] * 3
    assert "units: wave_generator.radial_deformation [mm], area [mm^2]\n" in said.err
    assert "whose error is not known has no rank" in said.err


def test_as_many_survive_behind_a_front_of_one(run, tmp_path):
    """With several objectives the next fronts follow until there are as many as the study asks for."""
    text = "survivors = 3\n" + TWO.replace("(x - 0.7) ** 2 + (y - 0.6) ** 2", "2 * ((x - 0.3) ** 2 + (y - 0.6) ** 2)")
    text = text.replace('"min"', '"min"\ng = "min"').replace("[figures]", "[sample]\ncount = 8\n[figures]")
    found = run(text, tmp_path)
    assert len(found.best()) == 1
    again = found.candidates(3)
    assert again["f"].tolist() == sorted(found.frame["f"])[:3]
    stored = [row for rows, _ in found._shards("survivors") for row in rows.to_pylist()]
    assert sorted(row["sample"] for row in stored) == sorted(again["sample"])


def test_a_name_with_dollars_is_drawn(run, tmp_path):
    text = TWO.replace('"min"', '"min"\ng = "max"').replace("[figures]", "[sample]\ncount = 4\n[figures]")
    text = text.replace('g = "(x - 0.7) ** 2 + (y - 0.6) ** 2"', 'g = { value = "x", unit = "$_a$b_$" }')
    found = run(text, tmp_path)
    assert draw_all(found, tmp_path / "pictures")


def test_all_of_the_best_are_listed_and_drawn(search, tmp_path):
    """Not the survivors alone, which are computed again."""
    text = HEAD + "survivors = 2\n" + TWO.replace('"min"', '"min"\ng = "min"\nland = "max"')
    text = text.replace("[objectives]", 'land = "solve.land_width"\n[objectives]')
    found = search(text, "random", 2, tmp_path)
    best = found.best(100)
    assert len(best) > 2
    assert len(list((tmp_path / "pareto").iterdir())) == len(best)
    (beaten_by_none,) = (line for line in front_picture(found).axes[0].lines if line.get_label() == "beaten by none")
    assert len(beaten_by_none.get_xdata()) == len(best)


SLICE = """
[vary]
"flexspline.profile.convex_radius" = { from = 0.24, to = 0.30, COUNT }
"flexspline.profile.concave_rise" = { from = 0.03, to = 0.10, COUNT }
[figures]
zones = "solve.conjugate_zone_length"
land = "solve.land_width"
[constraints]
land = { min = 0.15 }
[objectives]
zones = "max"
"""


@pytest.fixture(scope="module")
def gridded(run, tmp_path_factory):
    """The best of a grid on a slice of type-50, and what the grid does not see."""
    points = 41 if FULL else 13
    text = SLICE.replace("COUNT", f"count = {points}") + '[sample]\nmethod = "grid"\n'
    grid = run(text, tmp_path_factory.mktemp("grid"))
    values = grid.frame.pivot(index=grid.recipe.keys[0].path, columns=grid.recipe.keys[1].path, values="zones")
    return grid.best(1).iloc[0], np.nanmax(np.abs(np.diff(np.asarray(values), axis=1)))


@pytest.mark.parametrize("method", ["nsga2", "cmaes"])
def test_search_against_brute_force(search, gridded, tmp_path, method):
    """On a slice of type-50 a search finds what the grid finds, or better."""
    other = search(HEAD + SLICE.replace(", COUNT", ""), method, 12, tmp_path).best(1).iloc[0]
    best, step = gridded
    assert other["zones"] >= best["zones"] - min(step, 0.02 * best["zones"])
    assert other["land"] >= 0.15


CONTACT = """
scene = "SCENE"
[set]
"slices.count" = 3
"slices.surface" = "tilted"
"contact.flank_points" = 20
"solver.tolerance" = 1e-4
[vary]
"tilt.angle_deg" = { from = 0.0, to = 0.3, COUNT }
"flexspline.profile.convex_radius" = { from = 0.26, to = 0.29, COUNT }
[compute]
verb = "contact"
survivors = 1
[figures]
clearance = { value = "1000 * contact.least_side_clearance", unit = "um" }
[objectives]
clearance = "min"
"""


@pytest.fixture(scope="module")
def gridded_contacts(scheduler, tmp_path_factory):
    """Contacts of a slice of type-50, and the grid over it."""
    text = CONTACT.replace("SCENE", os.path.join(os.environ["HDCONJ_SOURCE"], "data/scenes/type-50-coned.toml"))
    points = 41 if FULL else 13
    of_grid = text.replace("COUNT", f"count = {points}") + '[sample]\nmethod = "grid"\n'
    folder = tmp_path_factory.mktemp("contacts")
    study.run(study.read_recipe(of_grid), folder, scheduler=scheduler, progress=False)
    return text.replace(", COUNT", ""), study.open(folder)


@pytest.mark.parametrize("method", ["nsga2", "cmaes"] if FULL else ["cmaes"])
def test_search_of_contacts_against_brute_force(search, gridded_contacts, tmp_path, method):
    """On a slice of type-50 a search of 200 drives finds the grid's least side clearance within its error, or less."""
    text, grid = gridded_contacts
    best, other = grid.best(1).iloc[0], search(text, method, 20, tmp_path).best(1).iloc[0]
    assert best["clearance"] < grid.frame["clearance"].median() - 1
    assert best["clearance_error"] < 0.1 and other["clearance_error"] < 0.1
    assert other["clearance"] <= best["clearance"] + best["clearance_error"] + other["clearance_error"]
