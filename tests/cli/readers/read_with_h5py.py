#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads results with programs that are not ours: h5py, ezdxf.

  read_with_h5py.py RESULT.h5 [RESULT.dxf]

Checks the layout of docs/reference/hdf5.md and that the DXF file is sound and says the same. Prints one line, or
what is wrong.
"""

import re
import sys
from pathlib import Path

import h5py
import numpy as np

from faults import verdict, want

UNITS = {"mm", "mm^2", "rad", "1", "s", "N", "N mm", "N/mm", "N mm/rad", "MPa"}
ROOT = {
    "format": str,
    "format_version": np.integer,
    "program_version": str,
    "git_revision": str,
    "build": str,
    "date": str,
    "drive": str,
    "given": str,
    "scene": str,
    "threads": np.integer,
    "plan": str,
    "stages": np.ndarray,
}
BRANCH = {
    "segment": np.integer,
    "segment_name": str,
    "kind": str,
    "begins": str,
    "ends": str,
    "on_boundary": np.integer,
}
DXF_ROUNDING = 1e-10  # mm


def check_attributes(place, wanted):
    for name, kind in wanted.items():
        want(name in place.attrs, f"{place.name} has no attribute {name}")
        if name in place.attrs:
            want(isinstance(place.attrs[name], kind), f"{place.name}: {name} is {type(place.attrs[name])}, not {kind}")


def check_units(file):
    count = 0

    def look(name, item):
        nonlocal count
        if isinstance(item, h5py.Dataset):
            count += 1
            if b"not a netCDF variable" in item.attrs.get("NAME", b""):
                return  # a dimension without numbers
            want(item.attrs.get("long_name"), f"{name} has no long_name")
            want(item.attrs.get("units") in UNITS, f"{name}: units are {item.attrs.get('units')!r}")
            if item.dtype.kind == "f":
                want(np.isfinite(item[()]).all(), f"{name}: not finite")
            want(item.chunks is None, f"{name}: not contiguous")

    file.visititems(look)
    return count


def check_shapes(file):
    spline = file["circular_spline"]
    k, n, two = spline["outline"].shape
    want(two == 2 and spline["z"].shape == (k,), "outline and z do not match")
    want((np.diff(spline["outline"][:, :, 0]) >= -1e-12).all() or k == 0, "outline is not in order of increasing x")
    want(((spline["landmarks"][()] >= 0) & (spline["landmarks"][()] < n)).all(), "landmarks are no indices")
    want(file["flexspline/outline"].shape[1:] == (2,), "flexspline/outline is not (n,2)")
    want(file["neutral_curve"].shape[1:] == (2,), "neutral_curve is not (n,2)")
    want(file["timing/stage"].shape == file["timing/seconds"].shape, "timing does not match")
    want(all(isinstance(s, str) for s in file["timing/stage"].asstr()[()]), "stages are no texts")
    zones = file["conjugate_zones"]
    want({len(zones[name]) for name in zones} == {len(zones["phi"])}, "columns of conjugate_zones differ")
    pieces = spline["pieces"]
    want({len(pieces[name]) for name in pieces} == {len(pieces["kind"])}, "columns of pieces differ")
    want((pieces["last"][()] < n).all() and (pieces["first"][()] <= pieces["last"][()]).all(), "pieces are no ranges")


def check_branches(file):
    names = sorted(file["envelope"])
    want(names == [f"branch_{i:03d}" for i in range(len(names))], f"branches are called {names}")
    for name in names:
        branch = file["envelope"][name]
        n = len(branch["u"])
        check_attributes(branch, BRANCH)
        want(set(branch) == {"u", "phi", "t", "point"}, f"{name} holds {list(branch)}")
        want(branch["phi"].shape == branch["t"].shape == (n,) and branch["point"].shape == (n, 2), f"{name}: shapes")
        want(branch.attrs["kind"] in ("regular", "corner"), f"{name}: kind {branch.attrs['kind']}")
    return len(names)


def check_contact(file):
    contact = file["contact"]
    cases = [name for name in contact if name.startswith("case_")]
    columns = {name for name in contact if isinstance(contact[name], h5py.Dataset)}
    want({len(contact[name]) for name in columns} == {len(cases)}, "columns of contact differ")
    for name in cases:
        want(
            {len(contact[name][column]) for column in contact[name] if column != "revolution"}
            == {len(contact[name]["z"])},
            f"columns of {name} differ",
        )
    s, two, k, p = contact["map/gap"].shape
    lengths = (len(contact["map/angle"]), 2, len(contact["map/z"]), len(contact["map/flank_position"]))
    want((s, two, k, p) == lengths, "map")
    mesh = file["circular_spline/surface"]
    want(mesh["points"].shape[1:] == (3,) and mesh["quads"].shape == (len(mesh["part"]), 4), "mesh")


def check_load(file):
    load = file["load"]
    cases = [name for name in load if name.startswith("case_")]
    columns = {name for name in load if isinstance(load[name], h5py.Dataset)}
    want({len(load[name]) for name in columns} == {len(cases)}, "columns of load differ")
    for name in cases:
        curve, flanks = load[name]["curve"], load[name]["map"]
        named = set(curve) - {"error", "state"}
        want(len({len(curve[column]) for column in named}) == 1 and named <= columns, f"columns of {name} differ")
        errors = curve["error"]
        want(
            {len(errors[column]) for column in errors} == {len(curve["twist"])}
            and set(errors) <= named | {"estimated"},
            f"errors of {name} differ",
        )
        want(
            {flanks[column].shape for column in ("force", "line_load", "pressure", "gap", "flank_position")}
            == {(len(flanks["angle"]), 2, len(flanks["z"]))},
            f"map of {name}",
        )
    shape = load["shape"]
    want(
        {shape[column].shape for column in ("u_r", "u_t", "u_z", "stress")} == {(len(shape["phi"]), len(shape["r"]))},
        "shape",
    )
    want(
        shape["cells"].shape[1:] == (4,)
        and shape["cells"][()].max() < len(shape["r"])
        and len(shape["z"]) == len(shape["r"]),
        "cells",
    )
    want(0 <= load.attrs["written_case"] < len(cases), "written_case")


def check_documented(file):
    pages = Path(__file__).parents[3] / "docs" / "reference"
    text = (pages / "hdf5.md").read_text()
    former = re.findall(r"^\| `\w+` \| `\w+` \| `(\w+)` \|$", (pages / "json.md").read_text(), re.MULTILINE)
    known = {name + end for name in former for end in ("", "_error", "_count")}
    known |= set(re.findall(r"`([^`]+)`", text)) | {n.split("/")[-1] for n in re.findall(r"`(/[^`]+)`", text)}
    found = set(file.attrs)

    def look(name, item):
        last = name.split("/")[-1]
        if isinstance(item, h5py.Dataset):
            found.add(last)
        elif not last.startswith(("branch_", "case_")):
            want(f"/{last}" in text or f"/{name}" in text, f"docs/reference/hdf5.md does not name the group {name}")
        found.update(item.attrs)

    file.visititems(look)
    want(found <= known, f"docs/reference/hdf5.md does not name {sorted(found - known)}")


def polylines(file, layer):
    return [[v.dxf.location for v in e.vertices] for e in file.modelspace().query("POLYLINE") if e.dxf.layer == layer]


def check_dxf(name, result):
    import ezdxf

    drawing = ezdxf.readfile(name)
    audit = drawing.audit()
    want(not audit.errors and not audit.fixes, f"ezdxf finds {audit.errors} {audit.fixes}")
    want(drawing.dxfversion == "AC1009" and drawing.units == 4, "not R12 in mm")
    outlines = polylines(drawing, "CIRCULAR_SPLINE")
    want(len(outlines) == len(result["circular_spline/z"]), "not one polyline for each slice")
    for got, wanted, z in zip(outlines, result["circular_spline/outline"][()], result["circular_spline/z"][()]):
        want(np.abs(np.array(got) - np.c_[wanted, np.full(len(wanted), z)]).max() <= DXF_ROUNDING, "outline differs")
    summary = result["summary"].attrs
    tooth = result["flexspline/outline"][()] + [0, summary["r_0_mm"] + summary["w0_mm"] + summary["pitch_line_mm"]]
    want(
        np.abs(np.array(polylines(drawing, "FLEXSPLINE_TOOTH")[0])[:, :2] - tooth).max() <= DXF_ROUNDING,
        "tooth differs",
    )
    neutral = np.array(polylines(drawing, "NEUTRAL_CURVE")[0])[:, :2]
    want(np.abs(neutral - result["neutral_curve"][()]).max() <= DXF_ROUNDING, "neutral curve differs")
    closed = {e.dxf.layer: e.is_closed for e in drawing.modelspace()}
    want(closed == {"CIRCULAR_SPLINE": False, "FLEXSPLINE_TOOTH": False, "NEUTRAL_CURVE": True}, f"closed: {closed}")


def main(arguments):
    with h5py.File(arguments[0], "r") as file:
        want(file.attrs["format"] == "hdconj" and file.attrs["format_version"] == 2, "not our format")
        check_attributes(file, ROOT)
        datasets = check_units(file)
        check_shapes(file)
        branches = check_branches(file)
        if "contact" in file:
            check_contact(file)
        if "load" in file:
            check_load(file)
        check_documented(file)
        want("r_0_mm" in file["summary"].attrs, "no summary")
        if len(arguments) > 1:
            check_dxf(arguments[1], file)
    return verdict(datasets, f"{datasets} datasets, {branches} branches")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
