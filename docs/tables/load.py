#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of load.md, load-errors.md, stiffness.md and thesis.md, from the program's own JSON.

  docs/tables/load.py PROGRAM [--csv] [TABLE ...]

TABLE is any of: stages, curve, prototypes, members, shares, grid, thesis, tilted, surfaces, bearing, fixed, balls,
phases, reliefs, flow, errors, estimates, designs, torques; all of them without one. With --csv a table is comma-
separated, as data/reference/load-TABLE.csv has it, in place of Markdown.
"""

import json
import math
import os
import random
import subprocess
import sys
import tempfile

from contact import ROOT, head, make, row

ELASTIC = os.path.join(
    ROOT, "data/scenes/type-50-elastic.toml"
)  # scene of the tables thesis and surfaces, with 33 slices, and stages


def load(program, *arguments, **keys):
    """The load object of one run, on the built-in scene if no other is given, or what the program says; keys are --set,
    with __ for the dot."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "load", "--json", "--quiet", "-o", os.path.join(folder, "result.h5"), *arguments]
        for key, value in keys.items():
            command += ["--set", key.replace("__", ".") + "=" + str(value)]
        done = subprocess.run(command, capture_output=True, text=True)
        return json.loads(done.stdout)["load"] if done.returncode == 0 else done.stderr.strip()


def figures(case):
    """Cells of one case at the largest torque, each with its stated error."""
    state, error = case["rated"], case["rated_error"]

    def both(key, scale, digits):
        return ["%.*f" % (digits, scale * state[key]), "%.2g" % (scale * error[key])]

    return [
        "%.1f%s" % (case["backlash_offset_um"], "*" if case["side_clearance_increased"] else ""),
        "%.3f" % case["tip_radius_mm"],
        "%.2f" % case["backlash_arcmin"],
        *both("twist_arcmin", 1, 2),
        "%.0f" % state["stiffness_Nm_per_deg"],
        state["teeth"],
        *both("contact_fraction", 100, 4),
        *both("fraction_within_gap", 100, 2),
        *both("largest_force_N", 1, 1),
        "%.0f" % state["largest_pressure_MPa"],
        "%.0f" % state["largest_stress_MPa"],
    ]


COLUMNS = [
    "side clearance [um]",
    "tip circle [mm]",
    "backlash [arcmin]",
    "twist [arcmin]",
    "+-",
    "stiffness [N m/deg]",
    "teeth",
    "pressed flank [%]",
    "+-",
    "gap to 1 um [%]",
    "+-",
    "largest force of a tooth [N]",
    "+-",
    "pressure [MPa]",
    "cup [MPa]",
]


def told(result, *cells):
    if isinstance(result, str):
        print(result, file=sys.stderr)
        row(*cells, "no result", *[""] * (len(COLUMNS) - 1))
        return
    for case in result["cases"]:
        row(*cells, *figures(case))


def one_outline(program, tilt, kind, **keys):
    """One outline at the rated torque, on 33 slices."""
    arguments = ["--surface", "tilted", "--no-curve", f"--tilt={tilt}", "--kind", kind]
    return load(program, ELASTIC, *arguments, slices__count=33, **keys)


def thesis(program):
    head("tilt [deg]", "kind", *COLUMNS)
    for kind in ("radial", "draft"):
        for tilt in (0, 0.1, 0.2, 0.3):
            told(one_outline(program, tilt, kind), tilt, kind)


def stages(program):
    """Two lines through one curve, for different numbers of torques, the last as many as the stiffness needs."""
    head(
        "torques",
        "surface",
        "backlash [arcmin]",
        "K1 [N m/deg]",
        "K2 [N m/deg]",
        "K3 [N m/deg]",
        "first line [N m/deg]",
        "second line [N m/deg]",
        "knee [N m]",
        "off the curve [N m]",
    )
    for points in (5, 8, 10, 13, 20, 0):
        for surface in ("tilted", "per-slice"):
            even = ["--points", str(points)] if points else []
            result = load(program, ELASTIC, "--surface", surface, *even, circular_spline__backlash_offset=0.065)
            stage_row(result["cases"][0], points or "adaptive", surface)


def stage_row(case, *cells):
    row(
        *cells,
        "%.2f" % case["backlash_arcmin"],
        *("%.0f" % math.radians(case["catalogue"][f"K{i}_Nm_per_rad"]) for i in (1, 2, 3)),
        "%.0f" % case["first_stage_Nm_per_deg"],
        "%.0f" % case["second_stage_Nm_per_deg"],
        "%.1f" % case["knee_Nm"],
        "%.2g" % case["stages_rms_Nm"],
    )


def curve(program):
    """The torque-twist curve of one outline and of an outline per slice, with a side clearance of 65 um."""
    head("surface", "torque [N m]", "twist [arcmin]", "+-", "stiffness [N m/deg]", "+-")
    for surface in ("tilted", "per-slice"):
        result = load(program, ELASTIC, "--surface", surface, circular_spline__backlash_offset=0.065)
        for state in result["cases"][0]["curve"]:
            if state["torque_Nm"] > 0:
                row(
                    surface,
                    "%.4g" % state["torque_Nm"],
                    "%.2f" % state["twist_arcmin"],
                    "%.2g" % state["error"]["twist_arcmin"],
                    "%.0f" % state["stiffness_Nm_per_deg"],
                    "%.2g" % state["error"]["stiffness_Nm_per_deg"],
                )


def prototypes(program):
    """The computed rows beside the two prototypes of the thesis."""
    head(
        "tilt [deg]",
        "side clearance [um]",
        "backlash [arcmin]",
        "+-",
        *(words for name in ("K1", "K2", "K3") for words in (name + " [N m/deg]", "+-")),
        "first line [N m/deg]",
        "+-",
        "second line [N m/deg]",
        "+-",
    )
    for tilt, clearance in ((0, 0.075), (0.2, "auto")):
        case = load(
            program, ELASTIC, "--surface", "tilted", f"--tilt={tilt}", circular_spline__backlash_offset=clearance
        )["cases"][0]
        slopes = [case["catalogue"][f"K{i}{end}_Nm_per_rad"] for i in (1, 2, 3) for end in ("", "_error")]
        lines = [case[f"{line}_stage{end}_Nm_per_deg"] for line in ("first", "second") for end in ("", "_error")]
        row(
            tilt,
            "%.1f" % case["backlash_offset_um"],
            "%.2f" % case["backlash_arcmin"],
            "%.1g" % case["backlash_error_arcmin"],
            *("%.0f" % math.radians(each) for each in slopes),
            *("%.0f" % each for each in lines),
        )


# What a drive has beside rigid balls, each on top of those before. No maker's data: the page stiffness.md says where
# each value comes from.
MEMBERS = [
    ("teeth and cup", {}),
    ("22 rigid balls", {"bearing__balls": 22}),
    ("balls by Hertz", {"bearing__ball_diameter": 4.762}),
    ("bearing clearance", {"bearing__clearance": 0.01}),
    ("body of the circular spline", {"compliance__outer_radius": 35}),
    ("flange", {"compliance__flange": 200000}),
    ("hub", {"compliance__hub": 300000}),
    ("shaft", {"compliance__shaft": 25000}),
]


def members(program):
    """Stiffness with one member of the drive after the other, side clearance 65 um."""
    slopes = [words for name in ("K1", "K2", "K3") for words in (name + " [N m/rad]", "+-")]
    lines = ["first line [N m/deg]", "second line [N m/deg]"]
    head("surface", "with", "backlash [arcmin]", "twist [arcmin]", "+-", *slopes, "lost motion [arcmin]", "+-", *lines)
    for surface in ("tilted", "per-slice"):
        keys = {"circular_spline__backlash_offset": 0.065}
        for name, more in MEMBERS:
            keys.update(more)
            case = load(program, ELASTIC, "--surface", surface, **keys)["cases"][0]
            found = case["catalogue"]
            row(
                surface,
                name,
                "%.2f" % case["backlash_arcmin"],
                "%.2f" % case["rated"]["twist_arcmin"],
                "%.2g" % case["rated_error"]["twist_arcmin"],
                *("%.4g" % found[f"K{i}{end}_Nm_per_rad"] for i in (1, 2, 3) for end in ("", "_error")),
                "%.2f" % found["lost_motion_arcmin"],
                "%.2g" % found["lost_motion_error_arcmin"],
                *("%.0f" % case[f"{line}_stage_Nm_per_deg"] for line in ("first", "second")),
            )


def shares(program):
    """What the twist at 28 N m consists of with all of them."""
    head("surface", "member", "stiffness [N m/rad]", "twist [arcmin]", "share [%]")
    keys = {"circular_spline__backlash_offset": 0.065}
    for _, more in MEMBERS:
        keys.update(more)
    for surface in ("tilted", "per-slice"):
        for each in load(program, ELASTIC, "--surface", surface, "--no-curve", **keys)["cases"][0]["members"]:
            row(
                surface,
                each["name"],
                "%.4g" % each["stiffness_Nm_per_rad"] if each["stiffness_Nm_per_rad"] else "-",
                "%.2f" % each["twist_arcmin"],
                "%.1f" % (100 * each["fraction"]),
            )


def grid(program):
    """The number of slices, with one outline and its least side clearance."""
    head("slices", *COLUMNS)
    for count in (9, 17, 33):
        told(load(program, ELASTIC, "--surface", "tilted", "--no-curve", slices__count=count), count)


def tilted(program):
    """One outline with a side clearance of 80 um for all tilts, and with a negative tilt."""
    head("asked [um]", "tilt [deg]", "kind", *COLUMNS)
    runs = [("least", -0.3, "radial", {})] + [
        (80, tilt, kind, {"circular_spline__backlash_offset": 0.08})
        for kind in ("radial", "draft")
        for tilt in (0, 0.1, 0.2, 0.3)
    ]
    for asked, tilt, kind, keys in runs:
        told(one_outline(program, tilt, kind, **keys), asked, tilt, kind)


def surfaces(program):
    head("asked [um]", "surface", *COLUMNS)
    for clearance in (0, 40, 65):
        for surface in ("tilted", "ruled", "per-slice"):
            told(
                load(
                    program,
                    ELASTIC,
                    "--no-curve",
                    "--surface",
                    surface,
                    slices__count=33,
                    circular_spline__backlash_offset=clearance / 1000,
                ),
                clearance,
                surface,
            )


def bearing(program):
    head("bearing", "coning [deg]", *COLUMNS)
    variants = [
        ("ring 1.2 mm", {}),
        ("ring 0.8 mm", {"bearing__ring_thickness": 0.8}),
        ("ring 1.6 mm", {"bearing__ring_thickness": 1.6}),
        ("balls 3000 N/mm^2", {"bearing__radial_stiffness": 3000}),
        ("balls 1000 N/mm^2", {"bearing__radial_stiffness": 1000}),
        ("balls 300 N/mm^2", {"bearing__radial_stiffness": 300}),
        ("balls 100 N/mm^2", {"bearing__radial_stiffness": 100}),
        ("balls free along the axis", {"bearing__axially": "free"}),
        ("fit +5 um", {"bearing__fit": 0.005}),
        ("fit -5 um", {"bearing__fit": -0.005}),
        ("side clearance 80 um", {"circular_spline__backlash_offset": 0.08}),
    ]
    for name, keys in variants:
        keys = {"circular_spline__backlash_offset": 0.065, **keys}
        result = load(program, "--no-curve", **keys)
        told(result, name, "" if isinstance(result, str) else "%.3f" % result["cup"]["coning_major_deg"])


def fixed(program):
    """The bearing's part alone: an outline of the linear cone, which does not follow the bearing."""
    head("bearing", "coning [deg]", *COLUMNS)
    for name, keys in [
        ("ring 1.2 mm", {}),
        ("ring 0.8 mm", {"bearing__ring_thickness": 0.8}),
        ("ring 1.6 mm", {"bearing__ring_thickness": 1.6}),
        ("balls 3000 N/mm^2", {"bearing__radial_stiffness": 3000}),
        ("balls 1000 N/mm^2", {"bearing__radial_stiffness": 1000}),
        ("balls free along the axis", {"bearing__axially": "free"}),
        ("fit +5 um", {"bearing__fit": 0.005}),
        ("fit -5 um", {"bearing__fit": -0.005}),
        ("cam_oversize -5 um", {"bearing__cam_oversize": -0.005}),
        ("23 balls", {"bearing__balls": 23}),
    ]:
        keys = {
            "circular_spline__backlash_offset": 0.09,
            "coning__model": "linear",
            "coning__bottom_to_middle": 9.0,
            **keys,
        }
        result = load(program, "--no-curve", **keys)
        told(result, name, "" if isinstance(result, str) else "%.3f" % result["cup"]["coning_major_deg"])


def balls(program):
    head(
        "balls",
        "force on the cup [N]",
        "coning [deg]",
        "largest ball assembled",
        "at 28 N m",
        "carry",
        "twist [arcmin]",
        "pressed flank [%]",
    )
    for count in (None, 200, 100, 50, 22, 23):
        keys = {"circular_spline__backlash_offset": 0.065, **({"bearing__balls": count} if count else {})}
        result = load(program, "--no-curve", **keys)
        if isinstance(result, str):
            sys.exit(result)
        unit, state = "ball_force_N" + ("" if count else "_per_mm"), result["cases"][0]["rated"]
        row(
            count or "line",
            "%.0f" % result["cup"]["wave_generator_force_N"],
            "%.4f" % result["cup"]["coning_major_deg"],
            "%.4g" % result["cup"][unit],
            "%.4g" % state[unit],
            state["balls"],
            "%.2f" % state["twist_arcmin"],
            "%.4f" % (100 * state["contact_fraction"]),
        )


PHASES = 6  # places of the balls, evenly over the distance of two of them
# Of a figure: path in the load object, and words
OF_BALLS = [
    (("cup", "wave_generator_force_N"), "force on the cup"),
    (("cup", "coning_major_deg"), "coning"),
    (("rated", "twist_arcmin"), "twist"),
    (("rated", "largest_force_N"), "largest force of a tooth"),
    (("rated", "wave_generator_force_N"), "force on the cup at 28 N m"),
    (("rated", "largest_stress_MPa"), "stress of the cup at 28 N m"),
]


def phases(program):
    """Single balls in place of a line: by how much figures change in the mean of all places of the balls, and by how
    much they vary with the place (largest less smallest), both in percent of what a line of balls gives. Without an
    outer edge of teeth in play, an outline per slice."""

    def found(result):
        if isinstance(result, str):
            sys.exit(result)
        parts = {"cup": result["cup"], "rated": result["cases"][0]["rated"]}
        return [parts[part][name] for (part, name), _ in OF_BALLS]

    options = ["--surface", "per-slice", "--no-curve", "--no-errors"]
    head("ring [mm]", "balls", "distance [mm]", *(words + end for _, words in OF_BALLS for end in (" [%]", " varies [%]")))
    for ring in (1.2, 0.8):
        keys = {"circular_spline__backlash_offset": 0.04, "bearing__ring_thickness": ring}
        line = found(load(program, *options, **keys))
        for count in (100, 50, 30, 23, 22, 18, 14, 10):
            places = [
                found(
                    load(
                        program,
                        *options,
                        **keys,
                        bearing__balls=count,
                        bearing__ball_phase_deg=360 / count * place / PHASES,
                    )
                )
                for place in range(PHASES)
            ]
            cells = []
            for base, *values in zip(line, *places):
                cells += [
                    "%.2f" % (100 * (sum(values) / PHASES / base - 1)),
                    "%.2f" % (100 * (max(values) - min(values)) / base),
                ]
            row(ring, count, "%.2f" % (2 * math.pi * (23.997 - ring) / count), *cells)


TIP = {"tip_relief__amount": 0.004, "tip_relief__from_height": 0.1}
RELIEFS = {
    "none": {},
    "tip 4 um": TIP,
    "ends 2 um": {"end_relief__amount": 0.002, "end_relief__length": 2},
    "ends 4 um": {"end_relief__amount": 0.004, "end_relief__length": 2},
    "tip and ends 4 um": {**TIP, "end_relief__amount": 0.004, "end_relief__length": 2},
}


def reliefs(program):
    """What reliefs do to force and pressure at edges and ends, on 33 slices: tips from 0.1 mm on, ends over 2 mm."""
    head(
        "surface",
        "relief",
        "backlash [arcmin]",
        "twist [arcmin]",
        "+-",
        "teeth",
        "largest force of a tooth [N]",
        "+-",
        "pressure [MPa]",
        "+-",
        "at z [mm]",
        "at an end",
    )
    for surface, clearance in (("per-slice", 0.04), ("tilted", 0.065)):
        for name, keys in RELIEFS.items():
            keys = {"slices__count": 33, "circular_spline__backlash_offset": clearance, **keys}
            result = load(program, ELASTIC, "--no-curve", "--surface", surface, **keys)
            if isinstance(result, str):
                print(result, file=sys.stderr)
                row(surface, name, "no result", *[""] * 9)
                continue
            case = result["cases"][0]
            state, error = case["rated"], case["rated_error"]
            row(
                surface,
                name,
                "%.2f" % case["backlash_arcmin"],
                "%.2f" % state["twist_arcmin"],
                "%.2g" % error["twist_arcmin"],
                state["teeth"],
                "%.1f" % state["largest_force_N"],
                "%.2g" % error["largest_force_N"],
                *pressure_cells(state["largest_pressure_MPa"], error["largest_pressure_MPa"]),
                "%.2f" % state["pressure_z_mm"],
                "yes" if case["pressure_at_edge"] else "no",
            )


def pressure_cells(value, error):
    """Those of a largest pressure and its error, which it has away from edges and ends alone."""
    return ("not determined", "") if error is None else ("%.0f" % value, "%.2g" % error)


def flow(program):
    """What a flow pressure does to one outline, on 33 slices."""
    head(
        "flow pressure [MPa]",
        "twist [arcmin]",
        "+-",
        "teeth",
        "largest force of a tooth [N]",
        "+-",
        "largest line load [N/mm]",
        "+-",
        "flows [%]",
    )
    for pressure in (None, 4000, 2700, 2000):
        keys = {"slices__count": 33, "circular_spline__backlash_offset": 0.065}
        keys.update({"flow__pressure": pressure} if pressure else {})
        case = load(program, ELASTIC, "--no-curve", "--surface", "tilted", **keys)["cases"][0]
        state, error = case["rated"], case["rated_error"]
        row(
            pressure or "none",
            "%.2f" % state["twist_arcmin"],
            "%.2g" % error["twist_arcmin"],
            state["teeth"],
            "%.1f" % state["largest_force_N"],
            "%.2g" % error["largest_force_N"],
            "%.1f" % state["largest_line_load_N_per_mm"],
            "%.2g" % error["largest_line_load_N_per_mm"],
            "%.0f" % (100 * state["flowing_fraction"]),
        )


def cam_deviation(waves):
    """2 um of the cosine of so many times the angle from the major axis."""
    rows = [[angle, 0.002 * round(math.cos(math.radians(waves * angle)), 9)] for angle in range(0, 360, 5)]
    return {"errors__wave_generator__cam_deviation": rows}


def errors(program):
    """What errors of making and assembly do to twist and forces, with one outline."""
    head("errors", "backlash [arcmin]", "twist [arcmin]", "+-", "stiffness [N m/deg]", "+-", "teeth", "force [N]", "+-")
    both = {f"errors__{ring}__pitch_deviation": 0.002 for ring in ("flexspline", "circular_spline")}
    variants = [
        ("none", {}),
        *((f"pitch 2 um, seed {seed}", {**both, "errors__seed": seed}) for seed in (1, 2, 3)),
        ("flexspline 5 um eccentric", {"errors__flexspline__eccentricity": 0.005}),
        ("circular spline 5 um eccentric", {"errors__circular_spline__eccentricity": 0.005}),
        *(
            (
                f"circular spline wobbles by 0.02 deg, phase {phase} deg",
                {"errors__circular_spline__wobble_deg": 0.02, "errors__circular_spline__wobble_phase_deg": phase},
            )
            for phase in (0, 90)
        ),
        ("profile slope +3 um", {"errors__profile_slope": 0.003}),
        ("profile slope -3 um", {"errors__profile_slope": -0.003}),
        ("circular spline's profile slope +3 um", {"errors__circular_spline__profile_slope": 0.003}),
        ("circular spline's profile slope -3 um", {"errors__circular_spline__profile_slope": -0.003}),
        *(
            (
                f"wave generator 5 um eccentric, phase {phase} deg",
                {
                    "errors__wave_generator__eccentricity": 0.005,
                    "errors__wave_generator__eccentricity_phase_deg": phase,
                },
            )
            for phase in (0, 90)
        ),
        *((f"cam deviates by 2 um, {waves} waves in a turn", cam_deviation(waves)) for waves in (2, 3)),
    ]
    for name, keys in variants:
        keys = {"circular_spline__backlash_offset": 0.08, **keys}
        case = load(program, ELASTIC, "--no-curve", "--surface", "tilted", **keys)["cases"][0]
        state, error = case["rated"], case["rated_error"]
        row(
            name,
            "%.2f" % case["backlash_arcmin"],
            "%.2f" % state["twist_arcmin"],
            "%.2g" % error["twist_arcmin"],
            "%.0f" % state["stiffness_Nm_per_deg"],
            "%.2g" % error["stiffness_Nm_per_deg"],
            state["teeth"],
            "%.1f" % state["largest_force_N"],
            "%.2g" % error["largest_force_N"],
        )


def estimates(program):
    """Distance to a grid four times finer over the estimate, of twelve random drives that chose no factor."""
    wish = random.Random(7117)
    drives = []
    for _ in range(12):
        keys, arguments = random_drive(wish)
        drives.append((keys, arguments + ["--torque", "%.6g" % 10 ** wish.uniform(0.7, 1.8)]))
    over_estimates(program, drives)


def designs(program):
    """The same of 36 drives of `hdconj design` that chose no factor: 20 to 100 mm, ratios 50 to 160."""
    wish = random.Random(4)
    with tempfile.TemporaryDirectory() as folder:
        drives = []
        for number in range(36):
            diameter = wish.choice([20, 25, 32, 40, 50, 63, 80, 100])
            ratio = wish.choice([50, 60, 80, 100, 120, 160])
            length = wish.choice([0.2, 0.25, 0.4, 0.6, 0.8])
            clearance = round(wish.choice([0.08, 0.16, 0.26, 0.4]) * diameter / (2 * ratio), 4)
            surface = wish.choice(["tilted", "ruled", "per-slice"])
            torque = "%.4g" % (28 * (diameter / 50) ** 3 * 10 ** wish.uniform(-0.5, 0.5))
            scene = os.path.join(folder, "%d.toml" % number)
            sizes = ["--diameter", diameter, "--ratio", ratio, "--length-ratio", length, "--clearance", clearance]
            subprocess.run([program, "design", *map(str, sizes), "--quiet", "-o", scene], check=True)
            drives.append(({}, [scene, "--surface", surface, "--torque", torque]))
        over_estimates(program, drives)


def torques(program):
    """The same of 60 drives of `hdconj design`, 20 to 100 mm and ratios 30 to 160, at 13 torques from 4 % of theirs on."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(60):
            keys, arguments = random_design(program, random.Random(2000 + number), os.path.join(folder, f"{number}.toml"))
            here, there = (load(program, *arguments, "--points", "10", **{**keys, **grid}) for grid in (COARSE, FINE))
            if isinstance(here, str) or isinstance(there, str):
                print(here if isinstance(here, str) else there, file=sys.stderr)
                continue
            for state, fine in same_torques(here["cases"][0]["curve"], there["cases"][0]["curve"]):
                for name, error in state["error"].items():
                    if name not in {*NOT_COMPARED} - {"teeth"} and error is not None and (error or state[name] != fine[name]):
                        found.setdefault(name, []).append(abs(state[name] - fine[name]) / max(1e-300, error))
            print(arguments, file=sys.stderr, flush=True)
    write_ratios("states", found)


COARSE = {"slices__count": 9}
FINE = {"slices__count": 33, "contact__flank_points": 400, "bearing__circles": 25}


def random_design(program, wish, scene):
    """Keys and options of a random drive of `hdconj design`, whose scene is written."""
    diameter = round(20 * 5 ** wish.random(), 1)
    ratio = wish.choice([30, 40, 50, 60, 80, 100, 120, 160])
    length = round(wish.uniform(0.2, 0.8), 2)
    clearance = wish.choice([None, None, 0, 0.02, 0.04, 0.08])  # in modules
    surface = wish.choice(["tilted", "ruled", "per-slice", "ruled"])
    torque = "%.3g" % (28 * (diameter / 50) ** 3 * 10 ** wish.uniform(-0.5, 0.5))
    sizes = ["--diameter", diameter, "--ratio", ratio, "--length-ratio", length]
    if clearance is not None:
        sizes += ["--clearance", round(clearance * diameter / 2 / ratio, 4)]
    subprocess.run([program, "design", *map(str, sizes), "--quiet", "-o", scene], check=True)
    return {}, [scene, "--surface", surface, "--torque", torque]


def same_torques(here, there):
    """States of both curves at the same torque above zero, where the first has errors; largest stresses have none but
    at the last."""
    for state in here:
        for fine in there:
            torque = state["torque_Nm"]
            if torque > 0 and state["error"] and math.isclose(torque, fine["torque_Nm"]):
                yield {**state, "error": {k: e for k, e in state["error"].items() if k != "largest_stress_MPa"}}, fine


def over_estimates(program, drives):
    """Distance to a grid four times finer over the estimate, by figure. @param drives: keys and options of each"""
    found = {}
    for keys, arguments in drives:
        here, there = (load(program, *arguments, "--points", "1", **{**keys, **grid}) for grid in (COARSE, FINE))
        if isinstance(here, str) or isinstance(there, str):
            print(here if isinstance(here, str) else there, file=sys.stderr)
            continue
        for name, error, value, true in compared(here, there):
            found.setdefault(name, []).append(abs(value - true) / max(1e-300, error))
        print(arguments, {name: "%.2f" % ratios[-1] for name, ratios in found.items()}, file=sys.stderr, flush=True)
    write_ratios("drives", found)


def write_ratios(of, found):
    """A row a figure. @param of: what there is a ratio of each of"""
    head("figure", of, "within the estimate", "above a tenth of it", "largest", "median")
    for name, ratios in found.items():
        middle = sorted(ratios)[len(ratios) // 2]
        inside = sum(0.1 <= r <= 1 for r in ratios)
        row(name, len(ratios), sum(r <= 1 for r in ratios), inside, "%.2f" % max(ratios), "%.2f" % middle)


# Counts, and figures that stand twice, in another unit or under a former name.
NOT_COMPARED = "flowing_fraction teeth balls carrying_fraction node_share contact_share near_share stiffness_Nm_per_rad".split()


def compared(here, there):
    """Name, stated error, value and the finer grid's value of each figure of a drive."""
    a, b = here["cases"][0], there["cases"][0]
    for name in a["rated_error"] or {}:
        if name not in NOT_COMPARED and a["rated_error"][name] is not None:
            yield name, a["rated_error"][name], a["rated"][name], b["rated"][name]
    yield "backlash_arcmin", a["backlash_error_arcmin"], a["backlash_arcmin"], b["backlash_arcmin"]
    if a.get("catalogue") and b.get("catalogue"):
        for name in ("K1", "K2", "K3"):
            values = [each["catalogue"][name + "_Nm_per_rad"] for each in (a, b)]
            yield name, a["catalogue"][name + "_error_Nm_per_rad"], *values
        values = [each["catalogue"]["lost_motion_arcmin"] for each in (a, b)]
        yield "lost_motion_arcmin", a["catalogue"]["lost_motion_error_arcmin"], *values
    for name, error in (here["cup"]["error"] or {}).items():
        yield "cup_" + name, error, here["cup"][name], there["cup"][name]


def random_drive(wish):
    """Keys and options of a random drive on the base of type-50."""
    surface = wish.choice(["tilted", "tilted", "tilted", "ruled", "per-slice"])
    tilt = wish.choice([0, 0, 0.1, 0.2, 0.3])
    kind = wish.choice(["radial", "draft"]) if surface == "tilted" else "radial"
    keys = {
        "wave_generator__radial_deformation": wish.uniform(0.25, 0.275),
        "flexspline__wall": wish.uniform(0.45, 0.9),
        "circular_spline__backlash_offset": wish.choice([0.0, 0.02, 0.04, 0.065, 0.09]),
        "contact__wave_generator_angle_deg": wish.uniform(0, 1.8),
        "slices__count": wish.choice([3, 5, 9]),
    }
    return keys, ["--surface", surface] + ([f"--tilt={tilt}", "--kind", kind] if tilt else [])


TABLES = {
    "stages": stages,
    "curve": curve,
    "prototypes": prototypes,
    "members": members,
    "shares": shares,
    "grid": grid,
    "thesis": thesis,
    "tilted": tilted,
    "surfaces": surfaces,
    "bearing": bearing,
    "fixed": fixed,
    "balls": balls,
    "phases": phases,
    "reliefs": reliefs,
    "flow": flow,
    "errors": errors,
    "estimates": estimates,
    "designs": designs,
    "torques": torques,
}

if __name__ == "__main__":
    make(TABLES, set(TABLES) - {"grid"}, __doc__)
