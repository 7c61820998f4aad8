#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""read_bent_cup.py FILE.vtu: the bent cup as meshio sees it."""

import sys

import meshio
import numpy as np

mesh = meshio.read(sys.argv[1])
(cells,) = mesh.cells
assert cells.type == "hexahedron20", cells.type
points, u, stress = mesh.points, mesh.point_data["displacement"], mesh.point_data["von_mises"].ravel()
assert len(points) == len(u) == len(stress)
assert np.isfinite(points).all() and np.isfinite(u).all() and np.isfinite(stress).all()

# every corner tetrahedron of a hexahedron has a positive volume: no element is turned inside out
corners = points[cells.data[:, :8]]
for at, a, b, c in ((0, 1, 3, 4), (6, 5, 7, 2)):
    volume = np.einsum(
        "ij,ij->i",
        np.cross(corners[:, a] - corners[:, at], corners[:, b] - corners[:, at]),
        corners[:, c] - corners[:, at],
    )
    assert (volume > 0).all(), (at, volume.min(), volume.max())
# a side's middle lies between its ends
for k, (a, b) in enumerate(
    ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
):
    middle = points[cells.data[:, 8 + k]]
    ends = (points[cells.data[:, a]] + points[cells.data[:, b]]) / 2
    length = np.linalg.norm(points[cells.data[:, a]] - points[cells.data[:, b]], axis=1)
    assert (np.linalg.norm(middle - ends, axis=1) < 0.2 * length).all(), k

r = np.hypot(points[:, 0], points[:, 1])
phi = np.arctan2(points[:, 0], points[:, 1])
inner = (abs(r - r[abs(points[:, 2]) < 1e-6].min()) < 1e-6) & (abs(points[:, 2]) < 1e-6)
u_r = (u[:, 0] * points[:, 0] + u[:, 1] * points[:, 1]) / r
major, minor = inner & (abs(phi) < 1e-6), inner & (abs(phi - np.pi / 2) < 1e-6)
assert 0.2 < u_r[major].max() < 0.3, u_r[major]
assert -0.3 < u_r[minor].max() < -0.15, u_r[minor]
assert abs(u[(points[:, 2] < -8.4) & (r < 14)]).max() < 0.01
assert 250 < stress.max() < 800 and stress.min() >= 0, stress.max()
print(len(points), "points,", len(cells.data), "elements, largest stress", stress.max())
