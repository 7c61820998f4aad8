# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/figures/tooth-FAMILY.svg: the tooth of each family's scene with the parameters of its keys.

usage: tooth_families.py HDCONJ FOLDER     (needs h5py and gnuplot; run from the project's folder)
"""

import math
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import h5py

RED, BLUE, GREY = "#c03020", "#2060c0", "#808080"
SCENES = ["straight", "involute", "cycloid", "s-tooth", "arc-chain", "bezier", "b-spline", "points", "type-50"]


class Figure:
    """gnuplot commands for one tooth; lengths in mm, y from the pitch line."""

    def __init__(self, outline):
        self.outline = outline
        self.lines, self.plots, self.data = [], [], []
        self.right = [(x, y) for x, y in outline if x >= 0]

    def half_width(self, y):
        for (xa, ya), (xb, yb) in zip(self.right, self.right[1:]):
            if min(ya, yb) <= y <= max(ya, yb) and ya != yb:
                return xa + (xb - xa) * (y - ya) / (yb - ya)
        return self.right[-1][0]

    def line(self, a, b, colour=GREY, dash=2, width=1):
        self.lines.append(
            f"set arrow from {a[0]},{a[1]} to {b[0]},{b[1]} nohead front lw {width} dt {dash} lc rgb '{colour}'"
        )

    def dimension(self, a, b, text, offset=(0.6, 0)):
        self.lines.append(
            f"set arrow from {a[0]},{a[1]} to {b[0]},{b[1]} heads front size 0.012,20 filled lw 1 lc rgb 'black'"
        )
        self.label(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), text, offset)

    def label(self, p, text, offset=(0.6, 0), colour="black"):
        self.lines.append(
            f"set label \"{text}\" at {p[0]},{p[1]} offset {offset[0]},{offset[1]} front tc rgb '{colour}'"
        )

    def curve(self, points, style):
        self.data.append("\n".join(f"{x:.5f} {y:.5f}" for x, y in points))
        self.plots.append(style)

    def circle(self, centre, radius, colour=BLUE, dash=2):
        self.curve(
            [
                (centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t))
                for t in (math.pi * k / 45 for k in range(91))
            ],
            f"with lines lw 1 dt {dash} lc rgb '{colour}'",
        )

    def marks(self, points, colour=BLUE, size=0.6):
        self.curve(points, f"with points pt 7 ps {size} lc rgb '{colour}'")

    def arc(self, centre, radius, start, end, text, offset=(0.6, 0)):
        self.curve(
            [
                (
                    centre[0] + radius * math.cos(start + (end - start) * k / 20),
                    centre[1] + radius * math.sin(start + (end - start) * k / 20),
                )
                for k in range(21)
            ],
            "with lines lw 1 lc rgb 'black'",
        )
        middle = (start + end) / 2
        self.label((centre[0] + radius * math.cos(middle), centre[1] + radius * math.sin(middle)), text, offset)


def angle_at(figure, p, alpha, text):
    """The angle between the vertical and the flank at p, drawn below it."""
    reach = 0.19
    figure.line(p, (p[0], p[1] - reach))
    figure.line(p, (p[0] + reach * math.sin(alpha), p[1] - reach * math.cos(alpha)), RED)
    figure.arc(p, 0.8 * reach, -math.pi / 2, -math.pi / 2 + alpha, text, (-0.5, -0.8))


def draw_straight(f, p, scene):
    angle_at(f, (p["thickness"] / 2, 0), math.radians(p["pressure_angle_deg"]), "α")


def draw_involute(f, p, scene):
    r = scene["drive"]["module"] * scene["drive"]["flexspline_teeth"] / 2
    angle_at(f, (p["thickness"] / 2, 0), math.radians(p["pressure_angle_deg"]) - p["thickness"] / (2 * r), "α")


def draw_cycloid(f, p, scene):
    x, above, below = p["thickness"] / 2, p["addendum_rolling_radius"], p["dedendum_rolling_radius"]
    f.circle((x, above), above)
    f.circle((x, -below), below)
    f.dimension((x, above), (x + above * 0.8, above + above * 0.6), "ρ_a", (0.3, -0.4))
    f.dimension((x, -below), (x + below * 0.8, -below - below * 0.6), "ρ_f", (0.3, 0.4))


def draw_s_tooth(f, p, scene):
    d = scene["drive"]
    size = d["module"] * (d["circular_spline_teeth"] - d["flexspline_teeth"]) / 2
    n, kappa, alpha = scene["wave_generator"]["waves"], p["deflection"], math.radians(p["pressure_angle_deg"])
    k = n * math.tan(alpha)
    start = math.atan(k) + math.acos(min(1, 1 / (kappa * math.hypot(1, k))))
    locus = lambda e: (size / n * (e - kappa * math.sin(e)), size * kappa * math.cos(e))
    x0, y0 = locus(start)
    whole = [(p["thickness"] / 2 + (x0 - x) / 2, (y0 - y) / 2) for x, y in (locus(math.pi * i / 60) for i in range(61))]
    f.curve(whole, f"with lines lw 1 dt 2 lc rgb '{BLUE}'")
    f.label(whole[-1], "half the locus, η = π", (-13, 0.6), BLUE)
    f.marks([(p["thickness"] / 2, 0)])
    f.label((p["thickness"] / 2, 0), "M", (0.8, 0.6), BLUE)
    angle_at(f, (p["thickness"] / 2, 0), alpha, "α")


def chain(p):
    at, normal, joints, centres = (p["tip_thickness"] / 2, p["addendum"]), math.radians(p["tip_angle_deg"]), [], []
    joints.append(at)
    for row in p["pieces"]:
        if len(row) == 1:
            at = (at[0] + row[0] * math.sin(normal), at[1] - row[0] * math.cos(normal))
        else:
            radius, sweep = row[0], math.radians(row[1])
            centre = (at[0] - radius * math.cos(normal), at[1] - radius * math.sin(normal))
            normal -= math.copysign(sweep, radius)
            if row is p["pieces"][-1]:
                normal = math.asin((-p["dedendum"] - centre[1]) / radius)
            at = (centre[0] + radius * math.cos(normal), centre[1] + radius * math.sin(normal))
            centres.append((centre, radius, at))
        joints.append(at)
    return joints, centres


def draw_arc_chain(f, p, scene):
    joints, centres = chain(p)
    f.marks(joints)
    for number, (a, b) in enumerate(zip(joints, joints[1:]), 1):
        y = (a[1] + b[1]) / 2
        f.label((f.half_width(y) + 0.06, y), f"row {number}", (0, 0.2), BLUE)
    tip, angle = joints[0], math.radians(p["tip_angle_deg"])
    f.line(tip, (tip[0], tip[1] - 0.13))
    f.line(tip, (tip[0] + 0.13 * math.sin(angle), tip[1] - 0.13 * math.cos(angle)), RED)
    f.arc(tip, 0.1, -math.pi / 2, -math.pi / 2 + angle, "tip angle", (-6, -1))
    f.dimension((-tip[0], tip[1] + 0.02), (tip[0], tip[1] + 0.02), "tip thickness", (-4, 0.6))


def draw_bezier(f, p, scene):
    points = [tuple(q) for q in p["points"]]
    f.curve(points, f"with linespoints pt 7 ps 0.6 lw 1 dt 2 lc rgb '{BLUE}'")
    for i, q in enumerate(points, 1):
        f.label(q, f"{i}", (1, 0.7), BLUE)


def draw_points(f, p, scene):
    if "file" in p:
        text = pathlib.Path("data/scenes", p["file"]).read_text().splitlines()
        points = [tuple(map(float, row.split(","))) for row in text if row and row[0] not in "#x"]
    else:
        points = [tuple(q) for q in p["points"]]
    f.marks(points, BLUE, 0.5)


def draw_arcs(f, p, scene):
    o1 = (-p["convex_offset"], p.get("convex_rise", 0))
    reach = p["convex_radius"] + p["concave_radius"]
    o2 = (math.sqrt(reach**2 - (p["concave_rise"] - o1[1]) ** 2) + o1[0], p["concave_rise"])
    joint = math.atan2(o2[1] - o1[1], o2[0] - o1[0])
    f.marks([o1, o2])
    f.label(o1, "O_1", (-1, -0.9), BLUE)
    f.label(o2, "O_2", (-1, 0.9), BLUE)
    a = (o1[0] + p["convex_radius"] * math.cos(0.35), o1[1] + p["convex_radius"] * math.sin(0.35))
    b = (o2[0] - p["concave_radius"] * math.cos(0.3), o2[1] - p["concave_radius"] * math.sin(0.3))
    f.dimension(o1, a, "ρ_a", (0, 0.7))
    f.dimension(o2, b, "ρ_f", (0, -0.8))
    f.line(o1, o2, BLUE)
    f.line((-0.4, p["tip_line_from"]), (f.half_width(p["tip_line_from"]), p["tip_line_from"]))
    f.dimension((-0.36, 0), (-0.36, p["tip_line_from"]), "h_t")
    del joint


DRAW = {
    "straight": draw_straight,
    "involute": draw_involute,
    "cycloid": draw_cycloid,
    "s-tooth": draw_s_tooth,
    "arc-chain": draw_arc_chain,
    "bezier": draw_bezier,
    "b-spline": draw_points,
    "points": draw_points,
    "double-circular-arc": draw_arcs,
}


def thinned(points, tolerance=2e-4):
    """The polygon with fewer points, none moved and none left out that lies further than the tolerance from it."""
    (xa, ya), (xb, yb) = points[0], points[-1]
    length = math.hypot(xb - xa, yb - ya) or 1
    worst, at = max((abs((x - xa) * (yb - ya) - (y - ya) * (xb - xa)) / length, i) for i, (x, y) in enumerate(points))
    if worst <= tolerance or len(points) < 3:
        return [points[0], points[-1]]
    return thinned(points[: at + 1]) + thinned(points[at:])[1:]


def draw(program, scene_name, folder, output):
    path = f"data/scenes/{scene_name}.toml"
    scene = tomllib.loads(pathlib.Path(path).read_text())
    p = scene["flexspline"]["profile"]
    result = folder / "tooth.h5"
    subprocess.run([program, "solve", path, "-o", result, "--quiet"], check=True)
    with h5py.File(result) as h:
        outline = [tuple(q) for q in h["/flexspline/outline"][:]]
    top, bottom = max(y for _, y in outline), min(y for _, y in outline)
    f = Figure(outline)
    wide = 0.74 if p["family"] == "double-circular-arc" else 0.47
    f.line((-0.46, 0), (wide - 0.02, 0))
    f.label((wide - 0.13, 0), "pitch line", (0, -0.7), GREY)
    f.line((0, bottom - 0.02), (0, top + 0.04))
    f.line((-0.46, top), (0, top), GREY, 3)
    f.line((-0.46, bottom), (0, bottom), GREY, 3)
    f.dimension((-0.42, 0), (-0.42, top), "h_a")
    f.dimension((-0.42, bottom), (-0.42, 0), "h_f")
    if "thickness" in p:
        f.dimension((-p["thickness"] / 2, 0), (p["thickness"] / 2, 0), "s", (-2, 0.6))
    DRAW[p["family"]](f, p, scene)
    data = folder / "tooth.dat"
    shown = thinned(outline)
    data.write_text("\n\n\n".join(["\n".join(f"{x:.5f} {y:.5f}" for x, y in shown)] + f.data) + "\n")
    file = output / f"tooth-{p['family']}.svg"
    plots = [
        f"'{data}' index 0 title 'tooth' with filledcurves fc rgb '#e8e6e0'",
        "'' index 0 with lines lw 2.5 lc rgb 'black'",
    ]
    plots += [f"'' index {i} {style}" for i, style in enumerate(f.plots, 1)]
    commands = [
        "set encoding utf8",
        f"set terminal svg size {int(620 * (wide + 0.5) / 0.97)},480 font 'sans,13' background rgb 'white'",
        f"set output '{file}'",
        "unset border; unset tics; set size ratio -1; set key off",
        f"set xrange [-0.5:{wide}]; set yrange [{bottom - (0.14 if p['family'] == 'cycloid' else 0.06)}:{top + 0.12}]",
        "set lmargin 1; set rmargin 1; set tmargin 1; set bmargin 1",
        *f.lines,
        "plot " + ", ".join(plots),
    ]
    subprocess.run(["gnuplot"], input="\n".join(commands).encode(), check=True)


def main(program, output):
    with tempfile.TemporaryDirectory() as name:
        for scene in SCENES:
            draw(program, scene, pathlib.Path(name), pathlib.Path(output))


if __name__ == "__main__":
    main(*sys.argv[1:])
