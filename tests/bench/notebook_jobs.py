# SPDX-License-Identifier: GPL-3.0-or-later
"""What a notebook would write for the built-in drive: one stretch of a flank, the whole tooth space, and the union of
tooth positions. notebook.py times them."""

import math

import h5py
import numpy as np
import shapely
import shapely.affinity
from scipy.integrate import quad
from scipy.optimize import brentq
from shapely.geometry import Polygon
from shapely.ops import unary_union

# --- the drive, as its scene gives it -------------------------------------------------------------------------------
m, z_f, z_c, h_a, h_f, wall, w0, n = 0.25, 200, 202, 0.2250, 0.3030, 0.7, 0.25, 2
rho_a, l_a = 0.2701, 0.0982
r_m = m * z_f / 2 - h_f - wall + wall / 2
pitch_line = wall / 2 + h_f
ratio = z_f / z_c
centre = np.array([-l_a, pitch_line])


def w(u):
    return w0 * np.cos(n * u), -n * w0 * np.sin(n * u), -n * n * w0 * np.cos(n * u)


def mean_radius():
    def excess(r_0):
        return (
            quad(
                lambda u: math.hypot(r_0 + w0 * math.cos(n * u), n * w0 * math.sin(n * u)),
                0,
                math.pi / n,
                epsabs=1e-13,
                epsrel=1e-13,
            )[0]
            - r_m * math.pi / n
        )

    return brentq(excess, r_m - w0, r_m, xtol=1e-14)


def poses(u, phi, r_0):
    """Angles and origins of the tooth frame in the circular spline's."""
    d, d1, _ = w(u)
    rho = r_0 + d
    gamma = u - ratio * phi
    theta = gamma - np.arctan(d1 / rho)
    return theta, rho * np.sin(gamma), rho * np.cos(gamma)


def velocity(u, r_0):
    """theta' and q of f = n.(theta' (y, -x) + q)."""
    d, d1, d2 = w(u)
    rho = r_0 + d
    s = np.sqrt(rho**2 + d1**2)
    return 1 - ratio * s / r_m - (rho * d2 - d1**2) / s**2, s - ratio * rho**2 / r_m, ratio * rho * d1 / r_m


def f(angle, u, r_0):
    omega, q_x, q_y = velocity(u, r_0)
    x, y = centre[0] + rho_a * np.cos(angle), centre[1] + rho_a * np.sin(angle)
    return np.cos(angle) * (omega * y + q_x) + np.sin(angle) * (-omega * x + q_y)


def placed(angle, theta, x_0, y_0):
    x, y = centre[0] + rho_a * np.cos(angle), centre[1] + rho_a * np.sin(angle)
    return np.stack(
        [x * np.cos(theta) + y * np.sin(theta) + x_0, -x * np.sin(theta) + y * np.cos(theta) + y_0], axis=-1
    )


# --- three notebooks ------------------------------------------------------------------------------------------------
def with_numpy(count, ends):
    r_0 = mean_radius()
    u = np.linspace(*ends, count)
    # arc length by the cumulative trapezoidal rule on a finer grid, from 0
    fine = np.linspace(0, ends[1], 8 * count)
    d, d1, _ = w(fine)
    speed = np.hypot(r_0 + d, d1)
    length = np.concatenate([[0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(fine))])
    phi = np.interp(u, fine, length) / r_m
    angles = np.linspace(-0.6, 1.5, max(64, count // 8))
    values = f(angles[None, :], u[:, None], r_0)
    i, j = np.nonzero(np.signbit(values[:, 1:]) != np.signbit(values[:, :-1]))
    a, b = values[i, j], values[i, j + 1]
    angle = angles[j] + (angles[j + 1] - angles[j]) * a / (a - b)
    theta, x_0, y_0 = poses(u[i], phi[i], r_0)
    return placed(angle, theta, x_0, y_0)


def with_scipy(count, ends):
    r_0 = mean_radius()
    points = []
    for u in np.linspace(*ends, count):
        phi = (
            quad(
                lambda v: math.hypot(r_0 + w0 * math.cos(n * v), n * w0 * math.sin(n * v)),
                0,
                u,
                epsabs=1e-12,
                epsrel=1e-12,
            )[0]
            / r_m
        )
        angles = np.linspace(-0.6, 1.5, 21)
        values = f(angles, u, r_0)
        for k in np.nonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))[0]:
            angle = brentq(f, angles[k], angles[k + 1], args=(u, r_0), xtol=1e-14)
            theta, x_0, y_0 = poses(u, phi, r_0)
            points.append(placed(angle, theta, x_0, y_0))
    return np.array(points)


def with_shapely(count, ends, tooth):
    """Union of positions over the whole lobe: the boundary, as points."""
    r_0 = mean_radius()
    shape = Polygon(tooth + [0, pitch_line])
    placed_teeth = []
    for u in np.linspace(-math.pi / n, math.pi / n, count):
        phi = quad(lambda v: math.hypot(r_0 + w0 * math.cos(n * v), n * w0 * math.sin(n * v)), 0, u)[0] / r_m
        theta, x_0, y_0 = poses(u, phi, r_0)
        c, s = math.cos(theta), math.sin(theta)
        placed_teeth.append(shapely.affinity.affine_transform(shape, [c, s, -s, c, x_0, y_0]))
    whole = unary_union(placed_teeth)
    return max(getattr(whole, "geoms", [whole]), key=lambda g: g.area).exterior


# --- the whole tooth space ------------------------------------------------------------------------------------------
# Every segment of the right half of the tooth in all positions of a lobe, and the path of its tip corner; of all these
# points the outermost at their azimuth; mirrored; into a file. Whoever knew beforehand which of them bound the tooth
# space would need no program.
h_t = 0.1900
x_f = -l_a + math.sqrt((rho_a + 0.5145) ** 2 - 0.0671**2)
beside = math.atan2(0.0671, x_f + l_a)  # where the arcs touch, seen from the convex arc's centre
line_from = math.asin(h_t / rho_a)
line_normal = np.array([math.cos(line_from), math.sin(line_from)])
line_start = centre + rho_a * line_normal
line_end = line_start + (h_a - h_t) / math.cos(line_from) * np.array([-math.sin(line_from), math.cos(line_from)])
# centre, radius (negative: hollow), angles of the normal: the convex one goes on inside the tooth, so that between two
# positions there is no gap before the line
arcs = [
    (centre, rho_a, beside, line_from + 0.1),
    (np.array([x_f, pitch_line + 0.0671]), -0.5145, beside, math.asin((h_f + 0.0671) / 0.5145)),
]
lines = [(line_start, line_end, line_normal), (line_end, line_end * [-1, 1], np.array([0.0, 1.0]))]


def f_at(point, normal, u, r_0):
    omega, q_x, q_y = velocity(u, r_0)
    return normal[0] * (omega * point[1] + q_x) + normal[1] * (-omega * point[0] + q_y)


def moved(point, theta, x_0, y_0):
    return np.stack(
        [
            point[0] * np.cos(theta) + point[1] * np.sin(theta) + x_0,
            -point[0] * np.sin(theta) + point[1] * np.cos(theta) + y_0,
        ],
        axis=-1,
    )


def on_arc(arc, angle):
    (x, y), radius = arc[0], arc[1]
    return x + radius * np.cos(angle), y + radius * np.sin(angle)


def outermost(curves):
    """Of curves' points, those that no other curve is outside of; by azimuth. A curve that turns back is several."""
    runs = []
    for curve in curves:
        azimuth = np.arctan2(curve[:, 0], curve[:, 1])
        turns = np.flatnonzero(np.diff(np.sign(np.diff(azimuth))) != 0) + 1
        ends = [0, *turns, len(curve) - 1]
        for first, last in zip(ends, ends[1:]):
            order = first + np.argsort(azimuth[first : last + 1])
            runs.append((azimuth[order], curve[order]))
    kept = []
    for own, (azimuth, points) in enumerate(runs):
        radius = np.hypot(*points.T)
        outside = np.zeros(len(points), bool)
        for other, (a, p) in enumerate(runs):
            if other != own:
                outside |= np.interp(azimuth, a, np.hypot(*p.T), left=0, right=0) > radius
        kept.append(points[~outside & (azimuth >= 0)])
    points = np.concatenate(kept)
    return points[np.argsort(np.arctan2(points[:, 0], points[:, 1]))]


def written(points, name):
    whole = np.concatenate([points[::-1] * [-1, 1], points])
    with h5py.File(name, "w") as result:
        result["outline"] = whole
    return whole


def runs_of(key):
    """Where points of one branch follow each other: grid rows without a gap."""
    return np.flatnonzero(np.diff(key) != 1) + 1


def whole_numpy(count, name):
    r_0 = mean_radius()
    u = np.linspace(-math.pi / n, math.pi / n, count)
    fine = np.linspace(0, math.pi / n, 4 * count)
    d, d1, _ = w(fine)
    speed = np.hypot(r_0 + d, d1)
    length = np.concatenate([[0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(fine))])
    phi = np.sign(u) * np.interp(np.abs(u), fine, length) / r_m
    theta, x_0, y_0 = poses(u, phi, r_0)
    curves = []

    def add(i, points):
        order = np.argsort(i, kind="stable")
        curves.extend(part for part in np.split(points[order], runs_of(i[order])) if len(part) > 1)

    for arc in arcs:
        angles = np.linspace(arc[2], arc[3], max(16, count // 64))
        values = f_at(on_arc(arc, angles[None, :]), (np.cos(angles)[None, :], np.sin(angles)[None, :]), u[:, None], r_0)
        i, j = np.nonzero(np.signbit(values[:, 1:]) != np.signbit(values[:, :-1]))
        a, b = values[i, j], values[i, j + 1]
        angle = angles[j] + (angles[j + 1] - angles[j]) * a / (a - b)
        points = moved(on_arc(arc, angle), theta[i], x_0[i], y_0[i])
        first = np.concatenate([[True], np.diff(i) != 0])  # several roots in one position are of several branches
        add(i[first], points[first])
        add(i[~first], points[~first])
    for start, end, normal in lines:
        a, b = f_at(start, normal, u, r_0), f_at(end, normal, u, r_0)
        touches = np.signbit(a) != np.signbit(b)
        # to the line's end in the next position
        i = np.flatnonzero(touches | np.roll(touches, 1) | np.roll(touches, -1))
        share = np.clip(a[i] / (a[i] - b[i]), 0, 1)[:, None]
        point = (start + share * (end - start)).T
        add(i, moved(point, theta[i], x_0[i], y_0[i]))
    curves.append(moved(line_end, theta, x_0, y_0))
    return written(outermost(curves), name)


def whole_scipy(count, name):
    r_0 = mean_radius()
    found, on_line = {}, ([], [])
    for k, u in enumerate(np.linspace(-math.pi / n, math.pi / n, count)):
        phi = (
            quad(
                lambda v: math.hypot(r_0 + w0 * math.cos(n * v), n * w0 * math.sin(n * v)),
                0,
                u,
                epsabs=1e-12,
                epsrel=1e-12,
            )[0]
            / r_m
        )
        pose = poses(u, phi, r_0)
        for which, arc in enumerate(arcs):

            def on(angle):
                return f_at(on_arc(arc, angle), (np.cos(angle), np.sin(angle)), u, r_0)

            angles = np.linspace(arc[2], arc[3], 11)
            values = on(angles)
            for root, j in enumerate(np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))):
                angle = brentq(on, angles[j], angles[j + 1], xtol=1e-14)
                found.setdefault((which, root), []).append((k, moved(on_arc(arc, angle), *pose)))
        for which, (start, end, normal) in enumerate(lines):
            a, b = f_at(start, normal, u, r_0), f_at(end, normal, u, r_0)
            on_line[which].append(
                ((a < 0) != (b < 0), moved(start + min(max(a / (a - b), 0), 1) * (end - start), *pose))
            )
        found.setdefault((4, 0), []).append((k, moved(line_end, *pose)))
    for which, positions in enumerate(on_line):
        touches = np.array([touch for touch, _ in positions])
        # to the line's end in the next position
        found[2 + which, 0] = [
            (k, positions[k][1]) for k in np.flatnonzero(touches | np.roll(touches, 1) | np.roll(touches, -1))
        ]
    curves = []
    for points in found.values():
        row, place = np.array([k for k, _ in points]), np.array([p for _, p in points])
        curves.extend(part for part in np.split(place, runs_of(row)) if len(part) > 1)
    return written(outermost(curves), name)
