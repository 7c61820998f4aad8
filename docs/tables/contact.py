#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables about contact, from the program's own JSON: docs/tables/contact.py PROGRAM [--csv] [TABLE ...]

TABLE is any of: surfaces, slices, elastic, tilt, gap, best, best-elastic, thesis, liu, effects; all of them
without one. With --csv a table is comma-separated, as data/reference/contact-TABLE.csv has it, in place of Markdown.
"""

import csv
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
COARSE = [-1, -0.8, -0.6, -0.4, -0.2, -0.1, 0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1, 1.2, 1.4, 1.6, 1.8, 2]
SURFACES = ("tilted", "ruled", "per-slice")
LINEAR, ELASTIC = "type-50-coned", "type-50-elastic"

CSV = "--csv" in sys.argv
if CSV:
    sys.argv.remove("--csv")


def contact(program, scene, *arguments, **keys):
    """The contact object of one run, or what the program says; keys are --set, with __ for the dot."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            program,
            "contact",
            os.path.join(ROOT, "data/scenes", scene + ".toml"),
            "--json",
            "--quiet",
            "-o",
            os.path.join(folder, "result.h5"),
            *arguments,
        ]
        for key, value in keys.items():
            command += ["--set", key.replace("__", ".") + "=" + str(value)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            return done.stderr.strip()
        return json.loads(done.stdout)["contact"]


def one_case(program, scene, *arguments, **keys):
    """The only case of a run, or what the program says."""
    result = contact(program, scene, *arguments, **keys)
    return result if isinstance(result, str) else result["cases"][0]


def row(*cells):
    """Zeros of rounding have no sign."""
    cells = [re.sub(r"^-(0(\.0+)?)(?= |$)", r"\1", str(cell)) for cell in cells]
    if CSV:
        csv.writer(sys.stdout, lineterminator="\n").writerow(cells)
    else:
        print("| " + " | ".join(cells) + " |")
    sys.stdout.flush()


def head(*cells):
    row(*cells)
    if not CSV:
        print("|" + "---|" * len(cells))


COLUMNS = (
    "overlap [um]",
    "+-",
    "least side clearance [um]",
    "+-",
    "tip circle [mm]",
    "more root clearance [um]",
    "+-",
    "side clearance [um]",
    "backlash [arcmin]",
    "+-",
    "backlash [um]",
    "teeth",
    "contact [%]",
    "+-",
)


def figures(case):
    """Cells of one case in the order of COLUMNS."""
    if isinstance(case, str):
        print(case, file=sys.stderr)
        return ["cannot be made"] + [""] * (len(COLUMNS) - 1)
    state, cells = case["state"], []
    for value, error in (
        (-case["closest_flank"]["clearance_um"], case["clearance_error_um"]),
        (case["least_side_clearance_um"], case["least_side_clearance_error_um"]),
    ):
        cells += ["%.2f" % value, "%.1g" % error]
    cells += [
        "%.4f" % case["least_tip_radius_mm"],
        "%.2f" % case["least_root_clearance_um"],
        "%.1g" % case["least_root_clearance_error_um"],
        "%.2f" % case["backlash_offset_um"],
    ]
    cells += ["%.2f" % state["backlash_arcmin"], "%.1g" % state["backlash_error_arcmin"], "%.1f" % state["backlash_um"]]
    return cells + [
        state["teeth"],
        "%.4g" % (100 * state["contact_fraction"]),
        "%.2g" % (100 * state["contact_fraction_error"]),
    ]


def table(program, names, runs):
    """One row a run: cells that name it, scene, options, keys."""
    head(*names, *COLUMNS)
    for cells, scene, options, keys in runs:
        row(*cells, *figures(one_case(program, scene, *options, **keys)))


def surfaces(program):
    """The three surfaces; the last columns say how far a ruled one is from the outlines of its slices."""
    head("surface", "axial shift", *COLUMNS, "deviation [um]", "+-")
    for shift in ("none", "mapped"):
        for surface in SURFACES:
            case = one_case(program, LINEAR, "--surface", surface, coning__axial_shift=shift)
            row(
                surface,
                shift,
                *figures(case),
                "%.1f" % case["ruled_deviation_um"],
                "%.1g" % case["ruled_deviation_error_um"],
            )


def slices(program):
    table(
        program,
        ("slices",),
        [((count,), LINEAR, ("--surface", "per-slice"), {"slices__count": count}) for count in (3, 5, 9, 17, 33, 65)],
    )


def elastic(program):
    """The bent cup: the three surfaces, and one outline with a tilt of 0.2 deg."""
    table(
        program,
        ("surface", "kind", "tilt [deg]"),
        [((surface, "radial", 0), ELASTIC, ("--surface", surface), {}) for surface in SURFACES]
        + [
            (("tilted", kind, 0.2), ELASTIC, ("--surface", "tilted", "--kind", kind, "--tilt=0.2"), {})
            for kind in ("radial", "draft")
        ],
    )


def tilt(program):
    table(
        program,
        ("surface", "kind", "axial shift", "tilt [deg]"),
        [
            (
                (surface, kind, shift, angle),
                LINEAR,
                ("--surface", surface, "--kind", kind, f"--tilt={angle}"),
                {"coning__axial_shift": shift},
            )
            for surface, kind in (
                ("tilted", "radial"),
                ("tilted", "draft"),
                ("ruled", "radial"),
                ("per-slice", "radial"),
            )
            for shift in ("none", "mapped")
            for angle in COARSE
        ],
    )


def gap(program):
    """Contact area with 1 and 20 um as the limit of the gap, small tilts."""
    table(
        program,
        ("kind", "contact gap [um]", "tilt [deg]"),
        [
            (
                (kind, limit, angle),
                LINEAR,
                ("--surface", "tilted", "--kind", kind, f"--tilt={angle}"),
                {"contact__contact_gap": limit / 1000},
            )
            for kind in ("radial", "draft")
            for limit in (1, 20)
            for angle in (0, 0.1, 0.2, 0.3)
        ],
    )


def best_tilts(program, scene):
    head(
        "kind",
        "contact gap [um]",
        "most contact at [deg]",
        "contact [%]",
        "+-",
        "least side clearance at [deg]",
        "least side clearance [um]",
        "+-",
    )
    for kind in ("radial", "draft"):
        for limit in (1, 20) if scene == LINEAR else (1,):
            found = contact(
                program,
                scene,
                "--surface",
                "tilted",
                "--kind",
                kind,
                "--best",
                "--tilt=-1,1.2",
                contact__contact_gap=limit / 1000,
            )
            if isinstance(found, str):
                sys.exit(found)
            area, offset = found["best"]
            row(
                kind,
                limit,
                "%.3f" % area["tilt_deg"],
                "%.2g" % (100 * area["contact_fraction"]),
                "%.1g" % (100 * area["contact_fraction_error"]),
                "%.3f" % offset["tilt_deg"],
                "%.2f" % offset["least_side_clearance_um"],
                "%.1g" % offset["least_side_clearance_error_um"],
            )


def best(program):
    best_tilts(program, LINEAR)


def best_elastic(program):
    best_tilts(program, ELASTIC)


def thesis(program):
    """Tilts of table 4-1 with a side clearance of 45 um, for limits up to where the flanks count as touching."""
    tilts = (0, 0.1, 0.2, 0.3)
    head("kind", "axial shift", "contact gap [um]", *[f"{t} deg [%]" for t in tilts], "order")
    for kind in ("radial", "draft"):
        for shift in ("none", "mapped"):
            for limit in (1, 5, 10, 20, 25):
                values = [
                    one_case(
                        program,
                        LINEAR,
                        "--surface",
                        "tilted",
                        "--kind",
                        kind,
                        f"--tilt={angle}",
                        coning__axial_shift=shift,
                        contact__contact_gap=limit / 1000,
                        circular_spline__backlash_offset=0.045,
                    )["state"]["contact_fraction"]
                    for angle in tilts
                ]
                ranked = sorted(zip(tilts, values), key=lambda pair: pair[1])
                row(kind, shift, limit, *["%.3g" % (100 * v) for v in values], " < ".join(str(t) for t, _ in ranked))


def liu(program):
    table(
        program,
        ("width [mm]", "surface"),
        [
            ((width, surface), "liu-2025-coned", ("--surface", surface), {"circular_spline__width": float(width)})
            for width in (6, 10, 15)
            for surface in ("tilted", "per-slice")
        ],
    )


def effects(program):
    """Each effect added to the flat pair by itself."""
    nine = {"slices__count": 9}
    cone = {**nine, "coning__model": "linear", "coning__bottom_to_middle": 9, "coning__apex_height": 0.43}
    leaning = {**nine, "tilt__angle_deg": 0.2}
    changes = [
        ("none", {}),
        ("first-order kinematics", {"solver__kinematics": "first-order"}),
        ("side clearance of 10 um", {"circular_spline__backlash_offset": 0.01}),
        ("9 equal slices", nine),
        ("radial tilt of 0.2 deg", {**leaning, "tilt__kind": "radial"}),
        ("draft of 0.2 deg", {**leaning, "tilt__kind": "draft"}),
        *((f"cone: {surface}", {**cone, "slices__surface": surface}) for surface in SURFACES),
    ]
    table(program, ("effect",), [((name,), "type-50", (), keys) for name, keys in changes])


TABLES = {
    "surfaces": surfaces,
    "slices": slices,
    "elastic": elastic,
    "tilt": tilt,
    "gap": gap,
    "best": best,
    "best-elastic": best_elastic,
    "thesis": thesis,
    "liu": liu,
    "effects": effects,
}
LONG = ("tilt", "thesis", "best", "best-elastic", "gap")


def make(tables, long, usage):
    """Prints the tables that the command line names, each as CSV with its command in the head."""
    if len(sys.argv) < 2 or any(name not in tables for name in sys.argv[2:]):
        sys.exit(usage)
    script = "docs/tables/" + os.path.basename(sys.argv[0])
    for name in sys.argv[2:] or tables:
        print(
            f"# made by{' (long)' if name in long else ''}: {script} PROGRAM --csv {name}"
            if CSV
            else f"\n<!-- {name} -->\n"
        )
        tables[name](sys.argv[1])
        sys.stdout.flush()


if __name__ == "__main__":
    make(TABLES, LONG, __doc__)
