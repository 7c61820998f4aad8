#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the cup of a load study with meshio and compares it with the shape in the HDF5 file of the same study.

  read_cup.py (RESULT.h5 CUP.vtu TURNS) ...    TURNS: how often the shape is to be found around the ring

Prints of each cup what is wrong, and one line that says what was read.
"""

import sys

import h5py
import meshio
import numpy as np

from faults import faults, want


def volumes(points, cells):
    """Of hexahedra and wedges, by tetrahedra about the first point of each; positive where the cells are numbered as
    VTK says."""
    total, least = 0.0, np.inf
    for block in cells:
        corners = points[block.data]
        if block.type == "hexahedron":
            tetrahedra = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
        else:
            # meshio turns VTK's wedges, whose first triangle looks away from the second, the other way round.
            tetrahedra = [(0, 1, 2, 3), (2, 1, 4, 3), (2, 4, 5, 3)]
        each = sum(
            np.einsum(
                "ij,ij->i",
                np.cross(corners[:, b] - corners[:, a], corners[:, c] - corners[:, a]),
                corners[:, d] - corners[:, a],
            )
            / 6
            for a, b, c, d in tetrahedra
        )
        total += each.sum()
        least = min(least, each.min())
    return total, least


def read_cup(result, cup, turns):
    faults.clear()
    with h5py.File(result) as file:
        shape = {name: data[()] for name, data in file["load/shape"].items()}
        sectors = int(file["load"].attrs["sectors"])
    mesh = meshio.read(cup)
    turns = int(turns)
    angles = len(shape["phi"]) * turns
    corners = np.unique(shape["cells"])
    want(len(mesh.points) == angles * len(corners), f"{len(mesh.points)} points")
    filled = shape["phi"][-1] - shape["phi"][0] + shape["phi"][1] - shape["phi"][0]
    closed = turns in (1, sectors) and np.isclose(filled * turns, 2 * np.pi)
    want(
        sum(len(block.data) for block in mesh.cells) == (angles if closed else angles - 1) * len(shape["cells"]),
        "number of cells",
    )
    # Each point of the file back to its node and angle, by place alone.
    radius, phi = np.hypot(mesh.points[:, 0], mesh.points[:, 1]), np.arctan2(mesh.points[:, 0], mesh.points[:, 1])
    period = 2 * np.pi / turns
    seen = set()
    for i in range(len(mesh.points)):
        node = int(np.argmin((shape["r"] - radius[i]) ** 2 + (shape["z"] - mesh.points[i, 2]) ** 2))
        off = np.abs(np.exp(1j * (shape["phi"] - phi[i]) * (turns if turns > 1 else 1)) - 1)
        angle = int(np.argmin(off))
        want(
            abs(shape["r"][node] - radius[i]) < 1e-9 and shape["z"][node] == mesh.points[i, 2] and off[angle] < 1e-9,
            f"point {i} is no node of the section",
        )
        seen.add((node, angle, round(phi[i] / period * 1000)))
        out, along = np.array([np.sin(phi[i]), np.cos(phi[i])]), np.array([np.cos(phi[i]), -np.sin(phi[i])])
        at = np.isclose(shape["r"], shape["r"][node]) & np.isclose(
            shape["z"], shape["z"][node]
        )  # nodes in one place move together
        wanted = [
            [*(u * out + v * along), w]
            for u, v, w in zip(shape["u_r"][angle][at], shape["u_t"][angle][at], shape["u_z"][angle][at])
        ]
        moved = mesh.point_data["displacement"][i]
        want(min(np.abs(np.array(w) - moved).max() for w in wanted) < 1e-12, f"point {i} moves elsewhere")
        if "stress" in shape:
            want(mesh.point_data["von_mises"][i] in shape["stress"][angle][at], f"point {i} has another stress")
    want(len(seen) == len(mesh.points), "points in one place")
    want("stress" in shape or "von_mises" not in mesh.point_data, "a stress that was not computed")
    total, least = volumes(mesh.points, mesh.cells)
    want(least > 0, "cells of negative volume")
    # Pappus for chords: every element's area times the way of its centre, sin(h)/h less than around the circle.
    quads = shape["cells"]
    r, z = shape["r"][quads], shape["z"][quads]
    cross = r * np.roll(z, -1, 1) - np.roll(r, -1, 1) * z
    moment = ((r + np.roll(r, -1, 1)) * cross).sum(axis=1) / 6
    step = shape["phi"][1] - shape["phi"][0]
    wanted = moment.sum() * np.sin(step) * (angles if closed else angles - 1)
    want(abs(total - wanted) < 1e-9 * wanted, f"volume {total}, not {wanted}")
    for fault in faults[:20]:
        print(f"{cup}: {fault}")
    print(
        f"{cup}: {len(mesh.points)} points, {' and '.join(sorted({block.type for block in mesh.cells}))}, "
        f"{total:.3f} mm^3, {len(faults)} faults"
    )
    return len(faults)


def main(names):
    found = [read_cup(*names[i : i + 3]) for i in range(0, len(names), 3)]
    return 1 if any(found) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
