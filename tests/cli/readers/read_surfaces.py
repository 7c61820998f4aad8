#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the surfaces of a contact study with programs that are not ours: meshio where it is installed, else xml, h5py,
struct.

  read_surfaces.py RESULT.h5 TOOTH RING    TOOTH.xdmf, .stl, .vtk of one space, RING.xdmf, .stl, .vtk of all

Prints what is wrong, and one line that says what was read.
"""

import struct
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

import h5py
import numpy as np

from faults import verdict, want

try:
    import meshio
except ImportError:
    meshio = None

SINGLE = 4e-6  # mm, rounding of single precision at 25 mm
TOLERANCE = 1e-4  # mm, what leaving out points may move the surface


def xdmf(name):
    """Points, quads, part; the way the format's description says."""
    root = ElementTree.parse(name).getroot()
    want(root.tag == "Xdmf" and root.get("Version") == "3.0" and len(root) == 1 and len(root[0]) == 1, f"{name}: frame")

    def read(item):
        file, dataset = item.text.split(":")
        with h5py.File(Path(name).parent / file) as heavy:
            data = heavy[dataset][()]
        want(data.shape == tuple(int(d) for d in item.get("Dimensions").split()), f"{name}: {dataset} is {data.shape}")
        want(data.dtype.itemsize == int(item.get("Precision")), f"{name}: precision of {dataset}")
        want({"Float": "f", "Int": "i"}[item.get("NumberType")] == data.dtype.kind, f"{name}: type of {dataset}")
        return data

    grid = {part.tag: part for part in root[0][0]}
    want(grid["Topology"].get("TopologyType") == "Quadrilateral", f"{name}: cells")
    return tuple(read(grid[tag][0]) for tag in ("Geometry", "Topology", "Attribute"))


def stl(name):
    """Normals and corners of the triangles."""
    data = Path(name).read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    want(len(data) == 84 + 50 * count and not data.startswith(b"solid"), f"{name}: size")
    rows = np.frombuffer(data, np.dtype([("numbers", "<f4", (4, 3)), ("rest", "<u2")]), count, 84)["numbers"].astype(
        float
    )
    return rows[:, 0], rows[:, 1:]


def vtk(name):
    """Points, quads and what belongs to them by name."""
    data = Path(name).read_bytes()
    place, found = 0, {}

    def line():
        nonlocal place
        end = data.index(b"\n", place)
        text, place = data[place:end].decode(), end + 1
        return text

    def block(kind, count):
        nonlocal place
        values = np.frombuffer(data, kind, count, place)
        place += values.nbytes
        want(line() == "", f"{name}: no line end after numbers")
        return values

    want(line() == "# vtk DataFile Version 3.0", f"{name}: first line")
    line()
    want(line() == "BINARY" and line() == "DATASET UNSTRUCTURED_GRID", f"{name}: kind")
    count = int(line().split()[1])
    found["points"] = block(">f8", 3 * count).reshape(-1, 3)
    cells, size = (int(n) for n in line().split()[1:])
    quads = block(">i4", size).reshape(-1, 5)
    want((quads[:, 0] == 4).all() and len(quads) == cells, f"{name}: cells")
    found["quads"] = quads[:, 1:]
    want((block(">i4", int(line().split()[1])) == 9).all(), f"{name}: kinds of cells")
    while place < len(data):
        words = line().split()
        if words[0] == "SCALARS":
            want(line() == "LOOKUP_TABLE default", f"{name}: lookup table")
            found[words[1]] = block({"int": ">i4", "double": ">f8"}[words[2]], rows)
        else:
            rows = int(words[1])
    return found


def normals(corners):
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def check_sheet(name, quads, boundary):
    """Each edge has one cell on either side, or lies on the rim; cells agree on which side is outside."""
    edges = Counter((a, b) for quad in quads.tolist() for a, b in zip(quad, quad[1:] + quad[:1]))
    want(max(edges.values()) == 1, f"{name}: neighbours disagree on the outside")
    rim = sum((b, a) not in edges for a, b in edges)
    want(rim == boundary, f"{name}: {rim} edges on the rim, not {boundary}")


def check_inwards(name, points, quads, part):
    """The root faces the axis."""
    corners = points[quads]
    facing = (normals(corners)[:, :2] * corners.mean(axis=1)[:, :2]).sum(axis=1)
    want((facing[part == 2] <= 0).all() and (facing[part == 2] < 0).any(), f"{name}: the root does not face the axis")


def distance(points, line):
    """Largest distance of 2-D points from a polyline."""
    a, b = line[:-1], line[1:]
    along = b - a
    length = np.maximum((along**2).sum(axis=1), 1e-30)
    share = np.clip(((points[:, None] - a) * along).sum(axis=2) / length, 0, 1)
    return np.sqrt(((points[:, None] - a - share[..., None] * along) ** 2).sum(axis=2).min(axis=1)).max()


class Gaps:
    """Gaps of the map at points of one space in its own frame. Stations are of the middle slice."""

    def __init__(self, file):
        spline, contact = file["circular_spline"], file["contact/map"]
        self.z, self.outline, self.marks = (spline[name][()] for name in ("z", "outline", "landmarks"))
        self.position, self.gap = contact["flank_position"][()], contact["gap"][()]
        middle = self.outline[len(self.z) // 2]
        self.length = np.r_[0, np.cumsum(np.hypot(*np.diff(middle, axis=0).T))]

    def at(self, points, space):
        """NaN off the flanks."""
        slices = np.abs(self.z - points[:, 2:]).argmin(axis=1)
        found = np.full(len(points), np.nan)
        for i, k in enumerate(slices):
            j = int(((self.outline[k] - points[i, :2]) ** 2).sum(axis=1).argmin())
            for flank, (land, end) in enumerate(((self.marks[0], self.marks[1]), (self.marks[4], self.marks[3]))):
                if min(land, end) <= j <= max(land, end):
                    station = (self.length[j] - self.length[land]) / (self.length[end] - self.length[land])
                    found[i] = np.interp(station, self.position, self.gap[space, flank, k])
        return found


def fullest_spaces(file):
    """Those with the largest contact on the driving side but for rounding."""
    contact = file["contact"]
    inside = contact["map/gap"][()] <= contact.attrs["contact_gap_mm"]
    along = np.trapz(inside.astype(float), contact["map/flank_position"][()], axis=3)
    over = np.trapz(along, contact["map/z"][()], axis=2)
    over = over[:, 1] if over[:, 1].any() else over[:, 0]
    return np.flatnonzero(over >= over.max() * (1 - 1e-9))


def same(a, b):
    return np.array_equal(np.asarray(a, float), np.asarray(b, float), equal_nan=True)


def check_meshio(name, points, cells, **data):
    mesh = meshio.read(name)
    want(same(mesh.points, points), f"{name}: meshio reads other points")
    want(same(mesh.cells[0].data, cells), f"{name}: meshio reads other cells")
    for key, values in data.items():
        read = mesh.point_data.get(key, mesh.cell_data.get(key, [None])[0])
        want(read is not None and same(np.ravel(read), values), f"{name}: meshio reads another {key}")


def main(result, tooth, ring):
    with h5py.File(result) as file:
        z, outline = file["circular_spline/z"][()], file["circular_spline/outline"][()]
        slices, across = outline.shape[:2]
        teeth = int(round(2 * np.pi / np.diff(np.sort(file["contact/map/angle"][()])).mean()))

        points, quads, part = xdmf(tooth + ".xdmf")
        want(
            same(points, np.dstack([outline, np.repeat(z, across).reshape(slices, across, 1)]).reshape(-1, 3)),
            "the surface is not the slices",
        )
        check_sheet("tooth.xdmf", quads, 2 * (across - 1) + 2 * (slices - 1))
        check_inwards("tooth.xdmf", points, quads, part)
        want(set(part) == {0, 1, 2, 3}, f"parts {set(part)}")

        all_points, all_quads, all_part = xdmf(ring + ".xdmf")
        columns = len(all_points) // slices
        check_sheet("ring.xdmf", all_quads, 2 * columns)
        check_inwards("ring.xdmf", all_points, all_quads, all_part)
        want(columns % teeth == 0 and 5 < columns // teeth < across, f"{columns} points round the ring")
        one = all_points[: columns // teeth, :2]
        want(
            distance(outline[0], np.r_[one, all_points[columns // teeth : columns // teeth + 1, :2]]) <= TOLERANCE,
            "the ring's first space is not the outline",
        )

        for name, surface in ((tooth, None), (ring, (all_points, all_quads))):
            found = vtk(name + ".vtk")
            if surface:
                want(
                    same(found["points"], surface[0]) and same(found["quads"], surface[1]),
                    f"{name}: VTK and XDMF differ",
                )
            check_inwards(name + ".vtk", found["points"], found["quads"], found["part"])
            normal, corners = stl(name + ".stl")
            area = np.linalg.norm(normals(corners), axis=1) / 2
            both = normals(found["points"][found["quads"]]), normals(found["points"][found["quads"][:, [0, 2, 3]]])
            wanted = sum(np.linalg.norm(half, axis=1).sum() for half in both) / 2
            want(abs(area.sum() - wanted) <= 1e-5 * wanted, f"{name}.stl: area {area.sum()}, not {wanted}")
            unit = normals(corners) / (2 * area[:, None])
            want(np.abs(unit - normal).max() < 1e-5, f"{name}.stl: normals")
            want(len(area) <= 2 * len(found["quads"]), f"{name}.stl: too many triangles")
            check_stl_corners(name, corners, found["points"])
            if meshio:
                check_meshio(name + ".vtk", found["points"], found["quads"], gap=found["gap"], part=found["part"])
                want(
                    len(meshio.read(name + ".stl").cells[0].data) == len(area),
                    f"{name}.stl: meshio reads other triangles",
                )
        if meshio:
            check_meshio(tooth + ".xdmf", points, quads, part=part)
            check_meshio(ring + ".xdmf", all_points, all_quads, part=all_part)

        found = vtk(tooth + ".vtk")
        gaps = Gaps(file)
        every = [gaps.at(found["points"], space) for space in fullest_spaces(file)]
        want(
            any(np.allclose(found["gap"], each, rtol=0, atol=1e-12, equal_nan=True) for each in every),
            "gaps of the tooth are not those of the space with the largest contact",
        )
        want(0 < np.isfinite(found["gap"]).sum() < len(found["gap"]), "no gaps, or gaps off the flanks")
        check_ring_gaps(file, gaps, vtk(ring + ".vtk"), columns, teeth)
    with_meshio = "meshio" if meshio else "no meshio"
    return verdict(len(quads), f"{len(quads)} and {len(all_quads)} quads, {with_meshio}")


def check_stl_corners(name, corners, points):
    """Each corner is a point of the mesh."""
    known = {tuple(point) for point in points.astype("<f4").tolist()}
    want(
        {tuple(corner) for corner in corners.reshape(-1, 3).tolist()} <= known,
        f"{name}.stl: corners differ from points",
    )


def check_ring_gaps(file, gaps, found, columns, teeth):
    """Some spaces of the ring: their gaps are those that the map has where they stand."""
    wave_generator = file["contact/wave_generator"][file["contact"].attrs["written_case"]]
    angles = file["contact/map/angle"][()]
    count = columns // teeth
    for space in (0, 1, teeth // 3, teeth - 1):
        turned = 2 * np.pi * space / teeth
        c, s = np.cos(turned), np.sin(turned)
        rows = slice(columns + space * count, columns + (space + 1) * count)
        x, y, z = found["points"][rows].T
        where = np.angle(np.exp(1j * (turned - wave_generator)))
        number = int(np.abs(np.angle(np.exp(1j * (angles - where)))).argmin())
        wanted = gaps.at(np.c_[x * c - y * s, x * s + y * c, z], number)
        want(
            np.allclose(found["gap"][rows], wanted, rtol=0, atol=1e-9, equal_nan=True), f"gaps of space {space} differ"
        )


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
