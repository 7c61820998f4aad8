# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies that cannot be run are refused with all faults, before anything is computed."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import hdconj

study = pytest.importorskip("hdconj.study")
pytest.importorskip("distributed")
from hdconj.study import _drive, _faults, _run, _shards, _store  # noqa: E402
from hdconj.study.__main__ import _parser, main  # noqa: E402
from hdconj.study._expression import Expression  # noqa: E402

GOOD = """
[vary]
"flexspline.wall" = { from = 0.6, to = 0.8 }
[sample]
method = "sobol"
count = 8
[compute]
verb = "solve"
[figures]
land = "solve.land_width"
"""
FLANK = '"flexspline.wall" = { from = 0.6, to = 0.8 }'
# What is replaced in the good study, by what, and what the refusal says.
BAD = [
    ("[vary]", "[vary", "no TOML"),
    ("[sample]", "[sampel]", "sampel: unknown table (write sample)"),
    ("[sample]", "[extra]\n[sample]", "extra: unknown table (known: scene, set, vary, "),
    ("\n[vary]", 'base = "drive.toml"\n[vary]', "base: unknown key (known: scene, set, vary, "),
    ("[sample]", "scene = 3\n[sample]", "vary.scene = 3: a single value does not vary (write scene = "),
    ("\n[vary]", 'scene = "nowhere.toml"\n[vary]', "there is no such file"),
    ("\n[vary]", "scene = 3\n[vary]", "scene = 3: is no file name"),
    ("[sample]", '[set]\n"flexspline.wal" = 1\n[sample]', "scene flexspline.wal = 1: unknown key (write wall)"),
    ("[sample]", '[set]\n"flexspline.wall" = 1\n[sample]', "the key stands under [set] too (remove one of them)"),
    (FLANK, "", "nothing varies"),
    (FLANK, '"flexspline.wal" = { from = 0.6, to = 0.8 }', "vary.flexspline.wal = 0.7: unknown key (write wall)"),
    (FLANK, '"flexspine.wall" = { from = 0.6, to = 0.8 }', "unknown table"),
    (FLANK, '"flexspline.wall" = { from = 0.8, to = 0.6 }', "from = 0.8 is not below to = 0.6"),
    (FLANK, '"flexspline.wall" = { from = -0.6, to = 0.6 }', "must be above 0 (write a length in mm above 0"),
    (FLANK, '"flexspline.wall" = { from = "a", to = 0.6 }', "from and to are not two numbers"),
    (FLANK, '"flexspline.wall" = { from = 0.6 }', "from and to are not two numbers"),
    (FLANK, '"flexspline.wall" = { from = 0.6, to = nan }', "from and to are not two numbers"),
    (FLANK, '"flexspline.wall" = { from = 0.6, to = 0.8, count = 1 }', "count = 1 makes no grid"),
    (FLANK, '"flexspline.wall" = { from = 0.6, to = 0.8, step = 0 }', "step = 0 divides no range"),
    (FLANK, '"flexspline.wall" = { from = 0.6, to = 0.8, step = 0.1, count = 3 }', "both step and count"),
    (
        FLANK,
        '"flexspline.wall" = { from = 0.6, to = 0.8, points = 3 }',
        "unknown word points (with from go: count, step, to)",
    ),
    (FLANK, '"flexspline.wall" = { from = 0.6, to = 0.8, list = [1] }', "several laws at once"),
    (FLANK, '"flexspline.wall" = { count = 3 }', "no law (write one of from and to, list, normal, uniform, nominal)"),
    (FLANK, '"flexspline.wall" = 0.7', "a single value does not vary (write it under [set])"),
    (FLANK, "x = 3", 'vary.x = 3: a single value does not vary (write x = "3")'),
    (FLANK, '"flexspline.wall" = [0.6, 0.7]', "is a list without its law (write { list = [0.6, 0.7] })"),
    (FLANK, '"flexspline.wall" = { list = [] }', "no list of values"),
    (FLANK, '"flexspline.wall" = { list = [0.7, "thin"] }', "= thin: text where a length belongs"),
    (FLANK, '"solver.kinematics" = { list = ["exact", "exactly"] }', "unknown word"),
    (
        FLANK,
        '"drive.flexspline_teeth" = { from = 190, to = 210 }',
        "takes whole numbers only (write from = 190, to = 210, step = 1)",
    ),
    *(
        (FLANK, f"{FLANK}\n{keys}", f"takes whole numbers only (write {remedy}")
        for keys, remedy in (
            ('x = { normal = [5, 1] }\n"slices.count" = "x"', "round(x))"),
            ('x = { from = 1, to = 3 }\n"slices.count" = "x"', "round(x))"),
            ('x = { from = 1, to = 3, step = 0.25 }\n"slices.count" = "x"', "round(x))"),
            ('"slices.count" = { list = [5, 5.5] }', "whole numbers)"),
            ('"slices.count" = { from = 1, to = 3, step = 0.25 }', "from = 1, to = 3, step = 1)"),
        )
    ),
    (
        FLANK,
        '"slices.count" = { normal = [5, 1] }',
        'whole numbers only (let a name vary in its place, such as x, and write "slices.count" = "round(x)")',
    ),
    (FLANK, "wall = { from = 0.6, to = 0.8 }", 'wall: no link and no figure uses this name (write "flexspline.wall"'),
    (FLANK, "walls = { from = 0.6, to = 0.8 }", '(write "flexspline.wall" if that key is meant, or remove it)'),
    (FLANK, "x = { from = 0.6, to = 0.8 }", "uses this name (use it in a link or a figure, or remove it)"),
    (FLANK, '"flexspline.wall" = { normal = 0.7 }', "normal = 0.7 is not two numbers"),
    (FLANK, '"flexspline.wall" = { normal = [0.7, 0] }', "the standard deviation 0.0 is not above 0"),
    (FLANK, '"flexspline.wall" = { normal = [0.7, 0.1], limits = [0.8, 0.6] }', "the limits [0.8, 0.6] are empty"),
    (FLANK, '"flexspline.wall" = { uniform = [0.8, 0.6] }', "the interval [0.8, 0.6] is empty"),
    (FLANK, '"flexspline.wall" = { nominal = 0.7 }', "no tolerance (write h, H or js and a grade from 5 to 11"),
    (FLANK, '"flexspline.wall" = { nominal = 0.7, tolerance = "g6" }', "tolerance = g6 is no class that is known here"),
    (FLANK, '"flexspline.wall" = { nominal = 900, tolerance = "h6" }', "nominal = 900 is no size"),
    *(
        (FLANK, f'"{key}" = {{ nominal = {nominal}, tolerance = "js7" }}',
         f"vary.{key}: tolerances of ISO 286 are those of lengths in mm, and this key takes {wanted}")
        for key, nominal, wanted in (
            ("tilt.angle_deg", 0.2, "an angle in degrees (write normal = [MEAN, DEVIATION], or from and to)"),
            ("load.torque", 28, "a number from"), ("flexspline.cup.poissons_ratio", 0.3, "a number from 0 to 0.499 ("),
            ("slices.count", 9, "a whole number from 1 to 1000 ("),
        )
    ),
    (FLANK, FLANK + '\n"tilt.angle_deg" = "2 * flexspline.wal"', "unknown name flexspline.wal (write flexspline.wall)"),
    *(
        (FLANK, f'{FLANK}\nx = "2 * {name}"', f"{name} is not written in the scene ({remedy}")
        for name, remedy in (
            *(
                (name, f'write "{name}" under [set], {wanted}; docs/reference/scene.md says what holds while it is a')
                for name, wanted in (
                    ("contact.contact_gap", "a length in mm, at least 1e-09"),
                    ("flexspline.neutral_offset", "a length in mm"),
                    ("flexspline.profile.convex_rise", "a length in mm"),
                    ("flexspline.inner_radius", "a length in mm above 0"),
                )
            ),
            *(
                (f"{table}.{key}", f"leave the name out: the scene has no [{table}], an effect that this key would")
                for table, key in (("tilt", "angle_deg"), ("errors", "profile_slope"))
            ),
            ("errors.flexspline.eccentricity", "leave the name out: the scene has no [errors], an effect that this"),
        )
    ),
    (FLANK, f'{FLANK}\nx = "flexspline.wall * contact.gaps"', "unknown name contact.gaps (known: "),
    (FLANK, FLANK + '\n"tilt.angle_deg" = "2 *"', "no expression: invalid syntax"),
    (FLANK, FLANK + '\n"tilt.angle_deg" = "2 + tilt.x^2"', "^ is no operation (write 2 + tilt.x ** 2)"),
    (
        FLANK,
        FLANK + '\n"slices.count" = "4 * flexspline.wall"',
        "vary.slices.count = 2.8: takes whole numbers only (write round(4 * flexspline.wall))",
    ),
    *(
        (FLANK, f"x = {{ list = [-1, -2] }}\ny = {{ from = 1, to = 2 }}\n{links}", said)
        for links, said in (
            (
                'z = "y"\n"flexspline.wall" = "0.9 / x * z"',
                "line 6: vary.flexspline.wall = 0.9 / x * z: gives -1.35 at x = -1, y = 1.5: must be above 0 "
                "(change the ranges of x and y, or the link)",
            ),
            ('"flexspline.wall" = "0.9 / x"', "gives -0.9 at x = -1: must be above 0 (change the range of x, or the l"),
            ('"flexspline.wall" = "-0.9"', "flexspline.wall = -0.9: gives -0.9: must be above 0 (change the link)"),
            ('"flexspine.wall" = "y"', "line 5: vary.flexspine.wall = y: unknown table (write [flexspline])"),
            ('"flexspline.wal" = "y"', "line 5: vary.flexspline.wal = y: unknown key (write wall)"),
            ('"solver.kinematics" = "y"', "belongs (links compute numbers: let this key vary by { list = [A, B] })"),
        )
    ),
    (FLANK, FLANK + '\n"tilt.angle_deg" = "open(1)"', "unknown function 'open'"),
    (FLANK, FLANK + '\n"tilt.angle_deg" = "[1, 2]"', "'[1, 2]' is no arithmetic"),
    *(
        ('"solve.land_width"', f'"2 * {text}"', f"line 10: figures.land = 2 * {text}: {reason}")
        for text, reason in (
            ("min(solve.land_width)", "min takes two arguments or more, not 1 (write min(x, y))"),
            ("sqrt(solve.land_width, 2)", "sqrt takes one argument, not 2 (write sqrt(x))"),
            ("hypot()", "hypot takes one argument or more, not 0 (write hypot(x, y))"),
            ("round(1, 2, 3)", "round takes one argument or two, not 3 (write round(x, y))"),
        )
    ),
    (FLANK, FLANK + '\n"tilt.angle_deg" = "1 if 2 else 3"', "is no arithmetic"),
    *(
        (
            FLANK,
            f'{FLANK}\n"wave_generator.radial_deformation" = "{text}"',
            f"{text}: has no value in the middle of all that varies nor at an end: {cause} (change the link, or the",
        )
        for text, cause in (
            ("sqrt(-1 - flexspline.wall)", "math domain error"),
            ("1 / (flexspline.wall - flexspline.wall)", "float division by zero"),
            ("flexspline.wall * 1e308 * 1e10", "is no finite number"),
        )
    ),
    (FLANK, FLANK + '\na = "b + 1"\nb = "a + 1"', "the links go in a circle"),
    (FLANK, '"tilt.angle_deg" = "0.1"', "links alone do not vary"),
    (FLANK, FLANK + '\na = "1 / 0"', "vary.a = 1 / 0: has no value: division by zero"),
    (FLANK, FLANK + '\n"drive.name" = "wave_generator.family"', "wave_generator.family is no number (links compute"),
    (FLANK, FLANK + '\nw = { list = ["a", "b"] }\na = "2 * w"', "vary.a = 2 * w: w is no number"),
    (
        FLANK,
        FLANK + "\n[vary.flexspline]\nwall = { from = 0.6, to = 0.7 }",
        "vary.flexspline.wall: the key stands in line 5 too (remove one)",
    ),
    (
        FLANK,
        FLANK + "\nflexspline = { wall = { from = 0.6, to = 0.7 } }",
        "vary.flexspline.wall: the key stands in line 4 too (remove one)",
    ),
    (
        FLANK,
        FLANK + '\n[vary.wave_generator]\nradial_deformation = "w"',
        "vary.wave_generator.radial_deformation = w: unknown name w",
    ),
    *(
        (FLANK, FLANK + f'\n"{name}" = {{ from = 0, to = 1 }}', f"vary.{name}: is no name that an expression can use "
         f"(write another one, such as {other})")
        for name, other in (
            ("pi", "pi_1"), ("sqrt", "sqrt_1"), ("lambda", "lambda_1"), ("a-b", "a_b"), ("1st", "n1st"),
            ("\u00b5", "\u03bc"),
        )
    ),
    (FLANK, FLANK + "\nx = { from = 0, to = HUGE }", "from and to are not two numbers"),
    (FLANK, FLANK + "\nx = { from = 0, to = 1, step = HUGE }", "0... divides no range"),
    (FLANK, FLANK + "\nx = { from = -1.7e308, to = 1.7e308 }", "is too wide (write numbers up to 1e300)"),
    (FLANK, FLANK + "\nx = { list = [HUGE] }", "no list of values"),
    (FLANK, FLANK + '\nx = "HUGE"', "0...: a number that is not finite"),
    (FLANK, FLANK + f'\nx = "{990 * "-"}1"', "more than 100 operations in each other"),
    (FLANK, FLANK + f'\nx = "{240 * "not "}1"', "more than 100 operations in each other"),
    (FLANK, '"flexspline.wall=3" = { from = 0, to = 1 }', 'vary."flexspline.wall=3": is no path of a key'),
    (FLANK, '"flexspline.wall\\n" = { from = 0, to = 1 }', 'vary."flexspline.wall\\n": is no path of a key'),
    (FLANK, '"flexspline.wall.x" = { from = 0.6, to = 0.7 }', "vary.flexspline.wall.x = 0.6"),
    (FLANK, FLANK + '\nx = "0.7 * drive.name"', "vary.x = 0.7 * drive.name: drive.name is no number"),
    ("[figures]", '[figures]\nbad = "solve.land_width * drive.name"', "drive.name: drive.name is no num"),
    (FLANK, '"." = { from = 0, to = 1 }', 'vary.".": is no path of a key (write words with dots between them'),
    ("[sample]", '[set]\n"drive.name=x" = 3\n[sample]', 'set."drive.name=x": is no path of a key'),
    (FLANK, '"flexspline.wall" = { from = 0.6, to = 0.8, count = 1000000000 }', "a whole number from 2 to 10000000"),
    (FLANK, '"flexspline.wall" = { from = 0.6, to = 0.8, step = 1e-9 }', "points (write a number from 2.2e-08)"),
    ("count = 8", "count = 1000000000", "is more than 10000000 (write a whole number from 1 to 10000000)"),
    ('"sobol"\ncount = 8', '"saltelli"\ncount = 8388608', "makes 25165824 drives, more than 10000000 (write at most 2"),
    ("[figures]", "[optimise]\npopulation = 1000000\n[figures]", "generations = 25: is more than 10 (write a whole"),
    ("count = 8", "count = 0", "must be a whole number (write a whole number from 1"),
    ("count = 8", "count = 8.0", "sample.count = 8.0: must be a whole number"),
    ("count = 8", "count = 8\nseed = -1", "sample.seed = -1: must be a whole number"),
    ("count = 8", "cuont = 8", "sample.cuont: unknown key (write count)"),
    ('"sobol"', '"sobel"', "sample.method = sobel: unknown word (write one of grid, sobol, lhs, random, saltelli)"),
    ('"sobol"', '"grid"', "a grid counts itself"),
    ('method = "sobol"\ncount = 8', 'method = "grid"', "has no points of a grid (add count = N"),
    ('"sobol"\ncount = 8', '"saltelli"\ncount = 9', "must be a power of 2"),
    ('"solve"', '"solves"', "compute.verb = solves: unknown verb (write one of solve, contact, load"),
    ('verb = "solve"', 'verb = "solve"\nerrors = 1', "compute.errors = 1: must be true or false"),
    ('verb = "solve"', 'verb = "solve"\nload = { torque = 3 }', "options of a verb that is not computed"),
    ('verb = "solve"', 'verb = "solve"\nsolve = { torque = 3 }', "compute.solve.torque = 3: unknown option"),
    *(
        ('verb = "solve"', f'verb = ["solve", "kontact"]\n{options}', said)
        for options, said in (
            ("load = { curve = 1 }", "compute.load.curve = 1: is of another type (write true or false)"),
            ("load = { curve = 1 }", '(write verb = ["solve", "contact", "load"], or remove it)'),
            ('contact = { surfaces = "foo" }', "contact.surfaces = foo: is no word"),
            ("contact = { kurve = 1 }", "compute.contact.kurve = 1: unknown option"),
        )
    ),
    ('verb = "solve"', 'verb = "xyz"\nload = { curve = 1 }', "compute.load.curve = 1: is of another type"),
    ('verb = "solve"', 'verb = "solve"\nsolve = 3', "compute.solve = 3: is no table (write solve = {"),
    *(
        ('verb = "solve"', f'verb = "{verb}"\n{verb} = {{ {option} }}', said)
        for verb, option, said in (
            ("contact", 'revolution = "x"', "contact.revolution = x: is of another type (write a whole number)"),
            ("contact", 'tilts_deg = ["a"]', 'contact.tilts_deg = ["a"]: is of another type (write '),
            ("contact", 'best_deg = [0, "a"]', "is of another type (write [a number, a number])"),
            ("contact", 'surfaces = "foo"', "contact.surfaces = foo: is no word"),
            ("load", "curve = 1", "load.curve = 1: is of another type (write true or false)"),
            ("load", "torque = nan", "load.torque = nan: is of another type (write a number)"),
            ("load", "points = 0", "compute.load.points = 0: "),
            ("load", 'kinds = "foo"', "load.kinds = foo: is no word"),
        )
    ),
    ('verb = "solve"', 'verb = "contact"\ncontact = { tilts_deg = [0, 1] }', "a drive has one case"),
    ('verb = "solve"', 'verb = "contact"', '(write verb = ["contact", "solve"] under [compute])'),
    (
        'verb = "solve"',
        'verb = "contact"\ncontact = { best_deg = [0.1, 0.1] }',
        "(write best_deg=[FROM, TO] with FROM below TO)",
    ),
    (
        'verb = "solve"',
        'verb = "load"\nload = { points = 4, curve = false }',
        "compute.load.points = 4: curve=False leaves no curve",
    ),
    ('verb = "solve"', 'verb = "load"\nload = { measured = 3 }', "is of another type (write a text in quotes)"),
    ('verb = "solve"', 'verb = "solve"\nsurvivors = 3', "nothing says which drives survive"),
    ("[figures]", "[figures]\n1st = 'solve.land_width'", "is no name of a figure"),
    ("[figures]", "[figures]\nland_error = 'solve.land_width'", "not _error at its end"),
    ("[figures]", "[figures]\nrank = 'solve.land_width'", "figures.rank: the rows have a column of this name already"),
    (FLANK, FLANK + "\nland = { list = [1, 2] }", "vary.land: the rows have a column of this name already"),
    (FLANK, FLANK + "\nland_error = '2 * 3'", "vary.land_error: the rows have a column of this name already"),
    (FLANK, FLANK + "\ncause = { list = [1, 2] }", "vary.cause: the rows have a column of this name already"),
    ("[figures]", "[figures]\na = 'contact.backlash'", "contact is not computed"),
    ("[figures]", "[figures]\na = '1 / 0'", "figures.a = 1 / 0: has no value: division by zero"),
    ("[figures]", "[figures]\na = 3", "figures.a = 3: no expression in quotes"),
    ("[figures]", "[figures]\na = { value = '3', units = 'um' }", "unknown word units (write unit)"),
    ("[figures]", "[figures]\na = { unit = 'um' }", "figures.a = { unit = \"um\" }: no expression in quotes"),
    ("[figures]", "[figures]\na = { value = '3', unit = 1 }", "the unit is no text in quotes (write unit = "),
    ('[figures]\nland = "solve.land_width"', "", "no figure is wanted"),
    (
        "[figures]",
        "[constraints]\nlnd = { min = 3 }\n[figures]",
        "constraints.lnd: no figure of the study (write land)",
    ),
    ("[figures]", "[constraints]\nland = 3\n[figures]", "no limits (write { min = A }"),
    ("[figures]", "[constraints]\nland = { min = 'a' }\n[figures]", "a limit is no number"),
    ("[figures]", "[constraints]\nland = { min = 3, max = 2 }\n[figures]", "min is not below max"),
    ("[figures]", "[constraints]\nland = { min = 3, max = 3 }\n[figures]", "(write a min below the max)"),
    ("[figures]", "[objectives]\nland = 'more'\n[figures]", 'objectives.land = more: no aim (write "min" or "max")'),
    ("[figures]", "[optimise]\nmethod = 'nsga'\n[figures]", "write one of nsga2, cmaes, random"),
    ("[figures]", "[optimise]\nseed = 2\n[figures]", "line 9: optimise: nothing says what is better (write [obj"),
    (
        '[figures]\nland = "solve.land_width"',
        '[objectives]\nland = "max"\ndepth = "max"\n[optimise]\nmethod = "cmaes"\n[figures]\n'
        'land = "solve.land_width"\ndepth = "solve.space_depth"',
        "line 13: optimise.method = cmaes: takes one objective, not land, depth (write nsga2, or one figure for both)",
    ),
    ("[figures]", "[files]\na = 3\n[figures]", "files.a = 3: is no file name (write NAME = \"FILE.csv\")"),
    ("\n[vary]", "files = { a = 'a.csv' }\n[vary]", "files: is no table of its own (write [files] on a line"),
    ("[figures]", "[optimise]\npopulation = 1\n[figures]", "write a whole number from 2"),
]


@pytest.mark.parametrize("old, new, said", BAD, ids=range(len(BAD)))
def test_refused(old, new, said):
    assert old in GOOD
    with pytest.raises(hdconj.InputError) as refused:
        study.read_recipe(GOOD.replace(old, new.replace("HUGE", "1" + 400 * "0")))
    assert said in str(refused.value)


def test_a_link_is_offered_numbers_each_once():
    with pytest.raises(hdconj.InputError) as refused:
        study.read_recipe(GOOD.replace(FLANK, FLANK + '\nx = "2 * qqq"'))
    (fault,) = refused.value.faults
    known = fault.remedy.removeprefix("known: ").split(", ")
    assert len(known) == len(set(known)) and "flexspline.wall" in known
    assert "x" not in known and "drive.name" not in known


def test_a_path_that_is_none_is_told_with_its_line():
    with pytest.raises(hdconj.InputError) as refused:
        study.read_recipe(GOOD.replace(FLANK, FLANK + '\n\n"a b" = { list = [1, 2] }'))
    assert str(refused.value).startswith('line 5: vary."a b": is no path of a key')


def test_a_scene_that_is_no_toml_is_told(tmp_path, capsys):
    (tmp_path / "drive.toml").write_text("[drive\n")
    (tmp_path / "study.toml").write_text('scene = "drive.toml"' + GOOD + '\nwide = "2 * land"')
    assert main(["check", str(tmp_path / "study.toml")]) == 2
    said = capsys.readouterr().err
    assert "1 fault" in said and "drive.toml" in said and "not TOML" in said
    with pytest.raises(hdconj.InputError, match="not TOML"):
        hdconj.Scene.load(tmp_path / "drive.toml").to_dict()


def test_the_good_study_is_good():
    assert study.read_recipe(GOOD).drives == 8
    assert len(BAD) >= 40


def test_a_byte_order_mark_changes_nothing(tmp_path):
    """Of a scene and of a study: some editors begin a file with one."""
    plain = hdconj.Scene()
    marked = hdconj.Scene.from_toml("\ufeff" + plain.to_toml())
    (tmp_path / "drive.toml").write_text(plain.to_toml(), encoding="utf-8-sig")
    loaded = hdconj.Scene.load(tmp_path / "drive.toml")
    assert marked.to_toml() == loaded.to_toml() == plain.to_toml() and marked == plain
    assert marked.to_dict() == loaded.to_dict() == plain.to_dict()
    file = tmp_path / "study.toml"
    file.write_text('scene = "drive.toml"\n' + GOOD, encoding="utf-8-sig")
    good = study.load_recipe(file)
    row = _drive.row_of(good, (0, good.first), False)[0]
    same = study.read_recipe(GOOD)
    assert row["code"] == "" and row == _drive.row_of(same, (0, same.first), False)[0]
    _store.Folder(tmp_path / "out").write_scene(tmp_path / "best.toml", good, good.first)
    assert not hdconj.Scene.load(tmp_path / "best.toml").check() and study.read_recipe("\ufeff" + GOOD).drives == 8
    wrong = GOOD.replace('"sobol"', '"sobel"').lstrip()
    with pytest.raises(hdconj.InputError, match="line 4: sample.method"):
        study.read_recipe("\ufeff" + wrong)


def test_all_faults_at_once_with_their_lines():
    text = GOOD.replace("0.6", "-0.6").replace("sobol", "sobel").replace("count = 8", "count = 0")
    with pytest.raises(hdconj.InputError) as refused:
        study.read_recipe(text)
    assert [(fault.path, fault.line) for fault in refused.value.faults] == [
        ("vary.flexspline.wall", 3), ("sample.method", 5), ("sample.count", 6),
    ]  # fmt: skip


EVERYWHERE = """scene = "nothere.toml"
[set]
"flexspline.wal" = 1
[vary]
"tilt.angel_deg" = { from = 0, to = 1 }
y = "2 * flexspline.thick"
[sample]
method = "sobel"
[compute]
verb = "load"
load = { surfaces = "foo", points = 0, measured = "nothere.csv" }
[figures]
land = "solve.land_width"
[constraints]
land = { min = 3, max = 2 }
[objectives]
land = "much"
[optimise]
method = "best"
"""


def test_no_fault_hides_another_one():
    """Each in its line, which is that of its table: land stands in three of them, method in two."""
    with pytest.raises(hdconj.InputError) as refused:
        study.read_recipe(EVERYWHERE.partition("\n")[2])
    assert [(fault.path, fault.line) for fault in refused.value.faults] == [
        ("scene flexspline.wal", 2), ("vary.tilt.angel_deg", 4), ("vary.y", 5), ("sample.method", 7),
        ("compute.load.measured", 10), ("compute.load.points", 10), ("compute.load.surfaces", 10),
        ("figures.land", 12), ("constraints.land", 14), ("objectives.land", 16), ("optimise.method", 18),
    ]  # fmt: skip
    said = str(refused.value)
    assert "constraints.land = { min = 3, max = 2 }: min" in said
    assert "unknown name flexspline.thick (write flexspline.wall)" in said
    with pytest.raises(hdconj.InputError, match="scene nothere.toml: there is no such file"):
        study.read_recipe(EVERYWHERE)


def test_a_grid_has_a_largest_size():
    """Its size is counted however large it is."""
    keys = "\n".join(f"k{i} = {{ from = 0, to = 1, count = 1000 }}" for i in range(9))
    with pytest.raises(hdconj.InputError, match=f"the grid has {10**27} drives, more than 10000000"):
        study.read_recipe(GOOD.replace(FLANK, keys).replace('"sobol"\ncount = 8', '"grid"'))


def test_a_link_may_stand_in_a_table_of_its_key():
    keys = 'w = { list = [0.7] }\n[vary.flexspline]\nwall = "w"\n[vary.solver]\ntolerance = "1e-3 * w"'
    good = study.read_recipe(GOOD.replace(FLANK, keys))
    assert [path for path, _ in good.links] == ["flexspline.wall", "solver.tolerance"]


def test_a_link_that_is_whole_makes_a_count():
    """Powers and quotients are numbers of floating point."""
    keys = FLANK + '\nk = { list = [1, 2] }\n"slices.count" = "2 ** k + 1"\n"drive.flexspline_teeth" = "400 / 2"'
    good = study.check(study.read_recipe(GOOD.replace(FLANK, keys)))
    scene = good.scene_of(good.linked(good.first)).to_dict()
    assert (scene["slices"]["count"], scene["drive"]["flexspline_teeth"]) == (3, 200)


def test_whole_numbers_may_have_a_decimal_point():
    """As those of links, which are numbers of floating point; a remedy is followed here."""
    for keys in (
        '"slices.count" = { list = [5.0, 7.0] }', '"slices.count" = { from = 1, to = 5, step = 2.0 }',
        '"slices.count" = { from = 1, to = 5, step = 1 }', 'x = { normal = [5, 1] }\n"slices.count" = "round(x)"',
    ):  # fmt: skip
        good = study.read_recipe(GOOD.replace(FLANK, keys))
        assert good.scene_of(good.linked(good.first)).to_dict()["slices"]["count"] in (3, 5)


def test_points_of_a_range_are_decimal_numbers():
    """They are those that one writes, and none is beyond the end, which a key may not take."""
    for law, points in (
        ("0.3, to = 1.5, step = 0.2", [0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.5]),
        ("0, to = 0.3, step = 0.1", [0, 0.1, 0.2, 0.3]),
        ("0, to = 1, count = 11", [i / 10 for i in range(11)]),
        ("0, to = 0.8999999999999999, step = 0.3", [0, 0.3, 0.6, 0.8999999999999999]),
        ("2, to = 7, step = 2", [2, 4, 6]),
        ("-1e-3, to = 1e-3, step = 1e-3", [-1e-3, 0, 1e-3]),
        ("1e300, to = 2e300, step = 5e299", [1e300, 1.5e300, 2e300]),
    ):
        text = GOOD.replace(FLANK, f"{FLANK}\nx = {{ from = {law} }}").replace("land_width", "land_width + x")
        assert list(study.read_recipe(text).keys[1].values) == points, law


def test_large_numbers_are_numbers():
    text = GOOD.replace(FLANK, FLANK + "\nx = { from = 0, to = 100000000000000000000 }")
    good = study.read_recipe(text.replace("solve.land_width", "solve.land_width + x"))
    assert good.first["x"] == 5e19


@pytest.mark.parametrize(
    "old, new, said",
    [
        ("solve.land_width", "solve.land_widht", "unknown figure solve.land_widht (write solve.land_width)"),
        ("solve.land_width", "2 * land_width", "unknown figure land_width (write solve.land_width)"),
        ("solve.land_width", "tilt.angle_deg", "tilt.angle_deg (leave the name out: the scene has no [tilt], an"),
    ],
)
def test_figures_are_those_of_the_first_drive(old, new, said):
    with pytest.raises(hdconj.InputError) as refused:
        study.check(study.read_recipe(GOOD.replace(old, new)))
    assert said in str(refused.value)


@pytest.mark.parametrize("keys, where", [
    ('"load.torque" = { list = [5, 20] }', "vary"), ('T = { list = [5, 20] }\n"load.torque" = "T"', "vary"),
    ('a = { list = [5, 20] }\n[set]\n"load.torque" = 20', "set"),
])  # fmt: skip
def test_an_option_in_place_of_a_key_that_is_given_is_refused(keys, where):
    """The rows would show torques that were not computed."""
    text = f'[vary]\n{keys}\n[compute]\nverb = "load"\nload = {{ torque = 28 }}\n[figures]\ntwist = "load.twist"'
    said = rf"compute.load.torque = 28: stands in place of load.torque, which stands under \[{where}\] too \(remove one"
    with pytest.raises(hdconj.InputError, match=said):
        study.read_recipe(text)
    study.read_recipe(text, computed=True)  # rows that are there can be read


def test_a_study_that_is_computed_may_have_a_name_without_use():
    """Folders of versions that took such names can be opened."""
    text = GOOD.replace("[vary]", "[vary]\nx = { from = 0, to = 1 }")
    with pytest.raises(hdconj.InputError, match="no link and no figure uses this name"):
        study.read_recipe(text)
    assert [key.path for key in study.read_recipe(text, computed=True).keys][0] == "x"


TORQUE = """
[vary]
"load.torque" = { list = [5.0, 10.0] }
[compute]
verb = "load"
load = { curve = false, measured = "rig.csv" }
[figures]
half = "load.torque / 2"
"""


def test_a_name_that_means_two_things_is_refused():
    """The key is in N m, the figure in N mm, whether the key varies or not; a name of the study may stand for it."""
    text = TORQUE.replace(', measured = "rig.csv"', "")
    alone = text.replace('"load.torque" = { list = [5.0, 10.0] }', '"tilt.angle_deg" = { list = [0, 0.1] }')
    said = r'load.torque is a key of the scene and a figure \(write a name for the key under \[vary\], such as x = "l'
    for given in (text, alone.replace("curve = false", "curve = false, torque = 5")):
        with pytest.raises(hdconj.InputError, match=said):
            study.check(study.read_recipe(given))
        named = given.replace("[compute]", 'x = "load.torque"\n[compute]').replace('"load.torque / 2"', '"x / 2"')
        good = study.read_recipe(named)
        assert _drive.row_of(good, (0, good.first), False)[0]["half"] == 2.5


def test_a_middle_drive_that_cannot_be_made_stops_no_study():
    """A name that means two things is told in the rows, where no drive shows it before."""
    text = GOOD.replace(FLANK, '"wave_generator.radial_deformation" = { list = [0.15, 0.25] }')
    text = text.replace('"solve.land_width"', '"solve.land_width / wave_generator.radial_deformation"')
    with pytest.raises(hdconj.InputError, match="unknown figure solve.land_widht"):
        study.check(study.read_recipe(text.replace("land_width", "land_widht")))
    good = study.check(study.read_recipe(text))
    codes = [_drive.row_of(good, (0, {good.keys[0].path: value}), False)[0]["code"] for value in (0.15, 0.25)]
    assert codes[0] not in ("", "figure") and codes[1] == ""
    given = study.read_recipe(TORQUE.replace(', measured = "rig.csv"', ""))
    row = _drive.row_of(given, (0, given.first), False)[0]
    assert (row["code"], row["cause"]) == ("figure", "load.torque / 2: load.torque is a key of the scene and a figure")


SELDOM = GOOD.replace(FLANK, '"wave_generator.radial_deformation" = { list = [0.15, 0.151, 0.25] }')
SELDOM = SELDOM.replace('"sobol"\ncount = 8', '"grid"') + '[objectives]\nland = "max"\n'


@pytest.mark.parametrize("verb", ["run", "optimise"])
def test_the_first_drive_that_can_be_made_shows_names(scheduler, tmp_path, monkeypatch, verb):
    """Where none was found before: a warning until then, and a misspelt figure ends what would lack it everywhere."""
    monkeypatch.setattr(_run, "_TRIES", 0)
    compute = getattr(study, verb)
    for name, folder in (("land_widht", "wrong"), ("land_width", "right")):
        recipe = study.read_recipe(SELDOM.replace("land_width", name) + "[optimise]\npopulation = 8\ngenerations = 1\n")
        with pytest.warns(_faults.UncheckedNames, match="the drive in the middle cannot be made, so the names of figu"):
            study.check(recipe)
        with pytest.warns(_faults.UncheckedNames):
            if folder == "right":
                compute(recipe, tmp_path / folder, scheduler=scheduler, progress=False)
                continue
            with pytest.raises(hdconj.InputError, match=r"unknown figure solve.land_widht \(write solve.land_width\)"):
                compute(recipe, tmp_path / folder, scheduler=scheduler, progress=False)
    assert not study.open(tmp_path / "right").about["unchecked"]
    assert "land_widht" not in str(study.open(tmp_path / "wrong").frame["cause"].tolist())


def test_status_says_what_figures_lack_and_that_names_are_unchecked(scheduler, tmp_path, capsys):
    """The commonest figure without a value, and why; that no drive could be made to check the names."""
    lacking = GOOD.replace('land = "solve.land_width"', 'a = "sqrt(flexspline.wall - 0.65)"\nb = "sqrt(a_b - 0.99)"')
    lacking = lacking.replace("[vary]", "[vary]\na_b = { from = 0, to = 1 }")
    unmade = SELDOM.replace(", 0.25]", "]").replace("land_width", "land_widht")
    for text, said in (
        (lacking, " figure b = sqrt(a_b - 0.99): "),
        (unmade, "the drive in the middle and 1 more cannot be made, so the names of figures are unchecked: "),
    ):
        file, folder = tmp_path / f"{len(text)}.toml", str(tmp_path / str(len(text)))
        file.write_text(text)
        assert main(["run", str(file), "-o", folder, "--scheduler", scheduler]) == 0
        shown = capsys.readouterr()
        assert said in shown.out and (text == lacking or said in shown.err)
        assert main(["status", folder]) == 0
        assert capsys.readouterr().out == shown.out


def test_a_measured_curve_that_is_not_there_is_named(tmp_path):
    with pytest.raises(hdconj.InputError, match=r"compute.load.measured = .*rig.csv: cannot be read"):
        study.check(study.read_recipe(TORQUE, "study", tmp_path))


@pytest.mark.parametrize("given, missing, law", [
    ('"tilt.kind" = "draft"', "tilt.angle_deg", "{ from = 0.0, to = 0.3, count = 3 }"),
    ('"end_relief.length" = 1.0', "end_relief.amount", "{ from = 0.001, to = 0.002 }"),
])  # fmt: skip
def test_a_key_that_varies_need_not_stand_in_the_scene(given, missing, law):
    """The tables are whole in the drives."""
    text = GOOD.replace(FLANK, f'"{missing}" = {law}\n[set]\n{given}')
    assert study.read_recipe(text).keys[0].path == missing
    with pytest.raises(hdconj.InputError, match=f"scene {missing}: this key is missing"):
        study.read_recipe(text.replace(f'"{missing}" = {law}', FLANK))


def test_a_drive_that_cannot_be_made_is_no_fault():
    """Arcs that do not meet, teeth that do not fit: rows, not reasons to refuse the study."""
    for law in (
        '"flexspline.profile.convex_radius" = { from = 0.2, to = 0.9 }',
        '"drive.circular_spline_teeth" = { from = 201, to = 204, step = 1 }',
    ):
        study.read_recipe(GOOD.replace(FLANK, law))


@pytest.mark.parametrize(
    "link", ["1 / (w - 0.7)", "1e200 ** (1.2 / w)", "log(w - 0.75)", "(0.8 - w) * 1e308 * 1e10"]
)
def test_a_link_without_a_value_is_a_row(link):
    """Middle drive or not: the study is good, and the row says which link."""
    text = f'"flexspline.wall" = {{ list = [0.7, 0.8] }}\nw = "flexspline.wall"\na = "{link}"'
    good = study.check(study.read_recipe(GOOD.replace(FLANK, text)))
    row = _drive.row_of(good, (0, good.first), False)[0]
    assert (row["code"], row["place"]) == ("link", "a") and link in row["cause"]


def test_a_value_of_a_link_that_its_key_does_not_take_is_a_row():
    """As one where the link has no value; another value of the same link makes a drive."""
    text = 'x = { list = [-1, 0, 1] }\n"flexspline.wall" = "0.7 / x"'
    good = study.check(study.read_recipe(GOOD.replace(FLANK, text)))
    rows = [_drive.row_of(good, (i, {"x": x}), False)[0] for i, x in enumerate((-1, 0, 1))]
    assert [(row["code"], row["place"]) for row in rows] == [*2 * [("link", "flexspline.wall")], ("", "")]
    assert rows[0]["cause"] == "0.7 / x gives -0.7: must be above 0" and rows[0]["flexspline.wall"] == -0.7
    assert rows[2]["land"] == hdconj.solve().figures["land_width"].value


def test_a_figure_without_a_value_keeps_the_others():
    """In the middle drive too; an error that leaves the domain of a function is not known."""
    figures = 'bad = "log(solve.land_width - 1)"\nland = "solve.land_width"\none = "1.0"'
    text = GOOD.replace('land = "solve.land_width"', figures)
    good = study.check(study.read_recipe(text))
    row = _drive.row_of(good, (0, good.first), False)[0]
    assert (row["code"], row["place"]) == ("figure", "bad") and "log(solve.land_width - 1)" in row["cause"]
    assert row["land"] > 0.1 and row["one"] == 1 and "bad" not in row
    endless = study.read_recipe(GOOD.replace("solve.land_width", "solve.land_width * 1e308 * 1e10"))
    row = _drive.row_of(endless, (0, endless.first), False)[0]
    assert (row["code"], row["place"]) == ("figure", "land") and "is no finite number" in row["cause"]
    assert "land" not in row
    value, error = Expression("sqrt(x)").with_error({"x": 0.01}, {"x": 0.02})
    assert value == pytest.approx(0.1) and error != error


@pytest.mark.parametrize("words, said", [
    (["run", "STUDY", "-o", ""], "has an empty name (name a folder"),
    (["run", "STUDY", "-o", "."], "holds study.toml, which is of no study (name a folder that is empty"),
    (["optimise", "STUDY", "-o", "."], "holds study.toml, which is of no study"),
    (["run", "STUDY", "-o", "STUDY"], "is a file (name a folder"),
    (["run", "STUDY", "-o", "out", "--jobs", "-1"], "--jobs = -1: is no number of processes (write 0"),
    (["run", "STUDY", "-o", "out", "--shard-seconds", "nan"], "--shard-seconds = nan: is no time"),
    *(
        (["run", "STUDY", "-o", "out", "--scheduler", address],
         f"--scheduler = {address}: is no address of a scheduler (write tcp://HOST:PORT, such as tcp://host:8786)")
        for address in ("bla", "no://bla:1", "tcp://bla")
    ),
    (["run", "STUDY", "-o", "out", "--jobs", "2147483648"], "--jobs: 2147483648 is more than 2147483647"),
    (["best", "made", "-n", "2147483648"], "-n: 2147483648 is more than 2147483647"),
    (["best", "made", "-n", "-3"], "-n: -3 is less than one (write a whole number from 1)"),
    (["best", "made", "-n", "1", "--csv", "rows.csv", "--scene", "best.toml"], "nothing says what is better"),
])  # fmt: skip
def test_a_refused_command_writes_nothing(tmp_path, monkeypatch, capsys, words, said):
    monkeypatch.chdir(tmp_path)
    Path("study.toml").write_text(GOOD + ('[objectives]\nland = "max"\n' if words[0] == "optimise" else ""))
    if words[0] == "best":
        good = study.load_recipe("study.toml")
        with _store.Folder("made").locked():
            _store.Folder("made").begin(good, "run")
    before = {file: file.read_bytes() for file in tmp_path.rglob("*") if file.is_file()}
    try:
        status = main([word.replace("STUDY", "study.toml") for word in words])
    except SystemExit as refused:  # of the command line
        status = refused.code
    assert status == 2
    assert said in capsys.readouterr().err
    assert before == {file: file.read_bytes() for file in tmp_path.rglob("*") if file.is_file()}


@pytest.mark.parametrize("words, said", [
    (["run", "STUDY", "-o", "afile/x"], "afile/x/rows: cannot be made: Not a directory (name a folder that you may"),
    (["run", "STUDY", "-o", "x" * 300], "File name too long (name a folder that you may write)"),
    (["picture", "made", "-o", "afile"], "afile: is a file (name a folder)"),
    (["picture", "made", "-o", "afile/x"], "afile/x: cannot be made: Not a directory (name a folder that you may"),
    (["best", "made", "--csv", "nowhere/x.csv"], "nowhere/x.csv: the folder nowhere does not exist (create it: mkdir"),
    (["best", "made", "--csv", "made"], "made: is a folder (write a file name in it)"),
])  # fmt: skip
def test_a_file_that_cannot_be_written_says_what_to_write(tmp_path, monkeypatch, capsys, words, said):
    """Running again does not help, so nobody is told to."""
    monkeypatch.chdir(tmp_path)
    Path("study.toml").write_text(GOOD)
    Path("afile").write_text("")
    with _store.Folder("made").locked():
        _store.Folder("made").begin(study.load_recipe("study.toml"), "run")
    assert main([word.replace("STUDY", "study.toml") for word in words]) == 1
    told = capsys.readouterr().err
    assert said in told and "run again" not in told and "Errno" not in told
    assert not [file for file in tmp_path.rglob("*.csv")]


def test_best_says_that_no_drive_keeps_the_constraints(tmp_path, capsys):
    (tmp_path / "study.toml").write_text(
        GOOD.replace("count = 8", "count = 2") + '[constraints]\nland = { max = 0.0 }\n[objectives]\nland = "max"\n'
    )
    study.run(tmp_path / "study.toml", tmp_path / "made", jobs=1, progress=False)
    assert main(["best", str(tmp_path / "made"), "--scene", str(tmp_path / "best.toml")]) == 1
    said = capsys.readouterr()
    assert "none of its drives keeps all constraints" in said.err
    assert not said.out
    assert not (tmp_path / "best.toml").exists()


def test_a_closed_pipe_ends_a_command_quietly(tmp_path):
    """Whoever reads has enough, as head -1 has."""
    (tmp_path / "study.toml").write_text(GOOD)
    with _store.Folder(tmp_path / "made").locked():
        _store.Folder(tmp_path / "made").begin(study.load_recipe(tmp_path / "study.toml"), "run")
    reader, writer = os.pipe()
    os.close(reader)
    words = [sys.executable, "-m", "hdconj.study", "status", tmp_path / "made"]
    done = subprocess.run(words, stdout=writer, stderr=subprocess.PIPE, text=True)
    os.close(writer)
    assert (done.returncode, done.stderr) == (1, "")


@pytest.mark.parametrize("figure, why", [
    ("sqrt(solve.land_width - 9)", "has a value of each objective"), ("solve.land_width", "keeps all constraints"),
])  # fmt: skip
def test_why_a_study_has_no_best_drive(tmp_path, capsys, figure, why):
    text = GOOD.replace("count = 8", "count = 1").replace("solve.land_width", figure)
    good = study.read_recipe(text + '[objectives]\nland = "max"\n[constraints]\nland = { max = 0.0 }')
    with _store.Folder(tmp_path).locked():
        about = _store.Folder(tmp_path).begin(good, "run")
        own = {word: about[word] for word in _shards.IDENTITY}
        row = _drive.row_of(good, (0, good.first), False)[0]
        _shards.write_shard(tmp_path / "rows", [row], _shards.schema_of(good), {"units": {}, "seconds": 1, **own})
    assert main(["best", str(tmp_path)]) == 1
    assert capsys.readouterr().err == f"hdconj study: {tmp_path}: none of its drives {why}\n"


@pytest.mark.parametrize("about", ["{}", "[1]", "3", "null", '{"kind": 3}', "{"])
def test_a_folder_whose_study_json_is_none_is_refused(tmp_path, capsys, about):
    (tmp_path / "study.toml").write_text(GOOD)
    (tmp_path / "study.json").write_text(about)
    for words in (["status", str(tmp_path)], ["run", str(tmp_path / "study.toml"), "-o", str(tmp_path)]):
        assert main(words) == 2
        assert "study.json: is damaged, or was not written by hdconj study" in capsys.readouterr().err


def test_a_folder_that_cannot_be_read_says_why(tmp_path):
    (tmp_path / "study.json").symlink_to("study.json")  # for ever: root may read all else
    with pytest.raises(hdconj.InputError, match="cannot be read: Too many levels of symbolic links"):
        study.open(tmp_path)


def test_arguments_of_python_are_told_by_their_names(tmp_path):
    good = study.read_recipe(GOOD + '[objectives]\nland = "max"\n')
    with pytest.raises(hdconj.InputError, match="^jobs = -1: .*\n?shard_seconds = 1.0: is no time"):
        study.run(good, tmp_path / "made", jobs=-1, shard_seconds=1)
    for call in (study.run, study.optimise):
        with pytest.raises(TypeError, match="jobs takes a whole number"):
            call(good, tmp_path / "made", jobs="2")
    with _store.Folder(tmp_path / "made").locked():
        _store.Folder(tmp_path / "made").begin(good, "run")
    with pytest.raises(hdconj.InputError, match="count: 0 is less than one"):
        study.open(tmp_path / "made").best(0)


STUDIES = sorted(Path(os.environ["HDCONJ_SOURCE"], "data/studies").glob("*.toml"))


@pytest.mark.parametrize("file", STUDIES, ids=lambda file: file.stem)
def test_the_studies_that_come_with_the_program(file):
    assert study.check(file).drives > 0


def test_bash_completes_the_command():
    """data/completion/hdconj.bash knows the verbs of hdconj study and their long options, no more and no fewer."""
    parser = _parser()
    verbs = next(action.choices for action in parser._actions if action.choices)
    assert completed("") == set(verbs)
    for name, verb in verbs.items():
        options = {option for action in verb._actions for option in action.option_strings if option.startswith("--")}
        assert completed(name, "--") == options


def completed(*words):
    """What bash offers for the last word after hdconj study."""
    file = Path(os.environ["HDCONJ_SOURCE"], "data/completion/hdconj.bash")
    script = (f'source "{file}"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _hdconj; '
              'printf "%s\\n" "${COMPREPLY[@]}"')  # fmt: skip
    command = ["bash", "-c", script, "bash", "hdconj", "study", *words]
    return set(subprocess.run(command, capture_output=True, text=True, check=True).stdout.split())
