#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of docs/explanation/contact.md, from the program's own JSON: docs/tables/contact.py PROGRAM [--csv] [TABLE ...]

TABLE is any of: surfaces, slices, tilt, best, thesis, clearances, liu; all of them without one. With --csv a table is
comma-separated, as data/reference/contact-TABLE.csv has it, in place of Markdown.
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


def contact(program, scene, *arguments, **keys):
    """The contact object of one run; keys are --set, with __ for the dot."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "contact", os.path.join(ROOT, "data/scenes", scene + ".toml"), "--json", "--quiet",
                   "-o", os.path.join(folder, "result.h5"), *arguments]
        for key, value in keys.items():
            command += ["--set", key.replace("__", ".") + "=" + str(value)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            return done.stderr.strip()
        return json.loads(done.stdout)["contact"]


def cases(program, scene, tilts, *arguments, **keys):
    """One case per tilt, each from a run of its own: a tilt that has no answer does not take the others with it."""
    found = []
    for tilt in tilts:
        result = contact(program, scene, f"--tilt={tilt}", *arguments, **keys)
        found.append((tilt, result if isinstance(result, str) else result["cases"][0]))
    return found


def share(state):
    return "%.2g" % (100 * state["contact_fraction"]) if state["contact_fraction"] > 0 else "0"


CSV = "--csv" in sys.argv
if CSV:
    sys.argv.remove("--csv")


def row(*cells):
    """Zeros of rounding have no sign."""
    cells = [re.sub(r"^-(0\.0+)(?= |$)", r"\1", str(cell)) for cell in cells]
    if CSV:
        csv.writer(sys.stdout, lineterminator="\n").writerow(cells)
    else:
        print("| " + " | ".join(cells) + " |")


def head(*cells):
    row(*cells)
    if not CSV:
        print("|" + "---|" * len(cells))


def surfaces(program):
    head("surface", "axial shift", "clearance as made [um]", "least side clearance [um]", "tip circle [mm]", "further root [um]",
         "side clearance used [um]", "play [arcmin]", "teeth", "share [%]", "+- [%]")
    for shift in ("none", "mapped"):
        for surface in ("tilted", "ruled", "per-slice"):
            case = contact(program, "type-50-coned", "--surface", surface, coning__axial_shift=shift)["cases"][0]
            state = case["state"]
            row(surface, shift, "%.2f +- %.1g" % (case["closest_flank"]["clearance_um"], case["clearance_error_um"]),
                "%.2f +- %.1g" % (case["least_side_clearance_um"], case["least_side_clearance_error_um"]), "%.4f" % case["least_tip_radius_mm"],
                "%.2f +- %.1g" % (case["least_root_clearance_um"], case["least_root_clearance_error_um"]), "%.2f" % case["backlash_offset_um"],
                "%.2f +- %.1g" % (state["backlash_arcmin"], state["backlash_error_arcmin"]), "%d (%d ... %d)" % (state["teeth"], state["teeth_least"], state["teeth_most"]),
                share(state), "%.1g" % (100 * state["contact_fraction_error"]))


def slices(program):
    head("slices", 'axial_shift "none"', '"mapped"')
    for count in (3, 5, 9, 17, 33, 65):
        found = [contact(program, "type-50-coned", "--surface", "per-slice", slices__count=count, coning__axial_shift=shift)["cases"][0]["state"]
                 for shift in ("none", "mapped")]
        row(count, *["%.3g +- %.1g" % (100 * each["contact_fraction"], 100 * each["contact_fraction_error"]) for each in found])


def tilt(program):
    head("surface", "kind", "axial shift", "tilt [deg]", "smallest clearance [um]", "least side clearance [um]", "tip circle [mm]",
         "further root clearance [um]", "backlash of the least side clearance [arcmin]", "contact area [%]", "teeth")
    for surface, kind in (("tilted", "radial"), ("tilted", "draft"), ("ruled", "radial"), ("per-slice", "radial")):
        for shift in ("none", "mapped"):
            for angle, case in cases(program, "type-50-coned", COARSE, "--surface", surface, "--kind", kind, coning__axial_shift=shift):
                if isinstance(case, str):
                    print(case, file=sys.stderr)
                    row(surface, kind, shift, angle, "cannot be made", *[""] * 6)
                    continue
                row(surface, kind, shift, angle, "%.1f" % case["closest_flank"]["clearance_um"], "%.2f" % case["least_side_clearance_um"],
                    "%.4f" % case["least_tip_radius_mm"], "%.1f" % case["least_root_clearance_um"], "%.2f" % case["backlash_of_least_side_clearance_arcmin"],
                    share(case["state"]), case["state"]["teeth"])


def best(program):
    head("kind", "axial shift", "contact_gap [um]", "largest area: tilt [deg]", "share [%]", "least side clearance: tilt [deg]", "offset [um]")
    for kind in ("radial", "draft"):
        for shift in ("none", "mapped"):
            for gap in (1, 20):
                found = contact(program, "type-50-coned", "--surface", "tilted", "--kind", kind, "--best", "--tilt=-1,2" if kind == "radial" else "--tilt=-1,1.2",
                                coning__axial_shift=shift, contact__contact_gap=gap / 1000)
                if isinstance(found, str):
                    row(kind, shift, gap, found, "", "", "")
                    continue
                where = {each["goal"]: each for each in found["best"]}
                area, offset = where["contact area"], where["least side clearance"]
                bound = {True: " (at the bound)", False: ""}
                row(kind, shift, gap, "%.3f%s" % (area["tilt_deg"], bound[area["on_bound"]]), "%s +- %.1g" % (share(area), 100 * area["contact_fraction_error"]),
                    "%.3f%s" % (offset["tilt_deg"], bound[offset["on_bound"]]), "%.2f +- %.1g" % (offset["least_side_clearance_um"], offset["least_side_clearance_error_um"]))


def thesis(program):
    """Tilts of Table 4-1 with the prototypes' play, for limits up to where the flanks count as touching."""
    tilts = (0, 0.1, 0.2, 0.3)
    head("kind", "axial shift", "contact_gap [um]", *[f"{t} deg [%]" for t in tilts], "order")
    for kind in ("radial", "draft"):
        for shift in ("none", "mapped"):
            for gap in (1, 5, 10, 20, 25):
                found = cases(program, "type-50-coned", tilts, "--surface", "tilted", "--kind", kind, coning__axial_shift=shift,
                              contact__contact_gap=gap / 1000, circular_spline__backlash_offset=0.045)
                values = [case["state"]["contact_fraction"] for _, case in found]
                ranked = sorted(zip(tilts, values), key=lambda pair: pair[1])
                row(kind, shift, gap, *["%.3g" % (100 * v) for v in values], " < ".join(str(t) for t, _ in ranked))


def clearances(program):
    head("tilt [deg]", "z = -3.5, program [um]", "design", "z = +3.5, program [um]", "design")
    expected = {0: (-78, -81), 0.2: (-88, -72), 0.77: (-117, -48), 1.67: (-157, -3)}
    for angle, case in cases(program, "type-50-coned", expected, "--surface", "tilted", "--kind", "radial", coning__axial_shift="none"):
        ends = [case["slices"][0], case["slices"][-1]]
        row(angle, "%.2f" % ends[0]["flank"]["clearance_um"], expected[angle][0],
            "%.2f (root %.2f)" % (ends[1]["flank"]["clearance_um"], ends[1]["root"]["clearance_um"]), expected[angle][1])


def liu(program):
    head("width [mm]", "surface", "clearance of the flanks [um]", "at z [mm]", "of the bottom [um]", "least side clearance [um]", "share [%]")
    for width in (6, 10, 15):
        for surface in ("tilted", "per-slice"):
            case = contact(program, "liu-2025-coned", "--surface", surface, circular_spline__width=float(width))["cases"][0]
            row(width, surface, "%.2f" % case["closest_flank"]["clearance_um"], "%g" % case["closest_flank"]["z_mm"],
                "%.2f" % min(each["root"]["clearance_um"] for each in case["slices"]), "%.2f" % case["least_side_clearance_um"],
                share(case["state"]))


TABLES = {"surfaces": surfaces, "slices": slices, "tilt": tilt, "best": best, "thesis": thesis, "clearances": clearances, "liu": liu}


def main():
    if len(sys.argv) < 2 or any(name not in TABLES for name in sys.argv[2:]):
        sys.exit(__doc__)
    for name in sys.argv[2:] or TABLES:
        if not CSV:
            print(f"\n<!-- {name} -->\n")
        TABLES[name](sys.argv[1])
        sys.stdout.flush()


if __name__ == "__main__":
    main()
