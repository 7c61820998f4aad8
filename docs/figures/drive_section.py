# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/figures/drive-section.svg: a drive in section with cone, tilt and slices, a tooth space, kinds of tilt.

usage: drive_section.py OUTPUT.svg     (standard library only)

Not to scale: cone, tilt and clearance are enlarged until they can be seen.
"""

import math
import sys

INK, GREY, RED, BLUE, GREEN = "#202020", "#909090", "#c03020", "#2060c0", "#208040"
STEEL, PALE = "#d8dde4", "#f3e3d8"


class Drawing:
    """Collects SVG elements; y points up, as in the frames of the program."""

    def __init__(self, width, height):
        self.height = height
        self.items = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'font-family="sans-serif" font-size="13">',
            f'<rect width="{width}" height="{height}" fill="white"/>',
            '<defs><marker id="tip" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="7" markerHeight="7" '
            'orient="auto-start-reverse"><path d="M0,1L10,5L0,9z"/></marker></defs>',
        ]

    def at(self, point):
        return f"{point[0]:.1f},{self.height - point[1]:.1f}"

    def path(self, points, stroke=INK, fill="none", width=1.5, dash="", closed=False, arrow=""):
        d = "M" + "L".join(self.at(p) for p in points) + ("Z" if closed else "")
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        ends = {"": "", "end": ' marker-end="url(#tip)"', "both": ' marker-start="url(#tip)" marker-end="url(#tip)"'}
        self.items.append(
            f'<path d="{d}" stroke="{stroke}" fill="{fill}" stroke-width="{width}"{dashes}{ends[arrow]}/>'
        )

    def text(self, point, words, anchor="start", colour=INK, size=13, bold=False):
        x, y = self.at(point).split(",")
        weight = ' font-weight="bold"' if bold else ""
        self.items.append(
            f'<text x="{x}" y="{y}" text-anchor="{anchor}" fill="{colour}" font-size="{size}"{weight}>'
            f"{words}</text>"
        )

    def label(self, words, place, target):
        """Words with a thin line to what they name, from that end of the words which is nearer."""
        right = place[0] + 7 * len(words)
        begin = (right + 2, place[1] + 4) if target[0] > right else (place[0] - 3, place[1] + 4)
        if place[0] < target[0] < right:
            begin = (target[0], place[1] + (14 if target[1] > place[1] else -4))
        self.path([begin, target], width=0.8, arrow="end")
        self.text(place, words)

    def save(self, name):
        with open(name, "w", encoding="utf8") as file:
            file.write("\n".join(self.items) + "\n</svg>\n")


def section(d):
    """The drive in section above its axis: the axis is horizontal, the open end on the right."""
    axis, bottom, rim = 420, 90, 560  # height of the axis; the cup's outer bottom face, its open end
    first, last = 380, 500  # face width
    middle = (first + last) / 2
    slope = math.tan(math.radians(9))  # of the cone, enlarged

    def wall(x, above):  # height of a fibre of the coned wall
        return axis + 150 + above + slope * (x - bottom)

    tilt = math.tan(math.radians(6))

    def spline(x):  # height of the circular spline's tip line
        return wall(middle, 44) + tilt * (x - middle)

    d.text((40, 772), "Section along the axis, at the major axis", bold=True, size=15)
    outer = axis + 318
    d.path([(first, outer), (last, outer), (last, spline(last)), (first, spline(first))], fill=PALE, closed=True)
    cup = [
        (bottom, axis + 40),
        (bottom, wall(bottom, 10)),
        (first, wall(first, 10)),
        (first, wall(first, 34)),
        (last, wall(last, 34)),
        (last, wall(last, 10)),
        (rim, wall(rim, 10)),
        (rim, wall(rim, 0)),
        (bottom + 14, wall(bottom + 14, 0)),
        (bottom + 14, axis + 40),
    ]
    d.path(cup, fill=STEEL, closed=True)
    d.path([(first, spline(first) - 19), (last, spline(last) - 19)], width=0.9, dash="5 3")
    d.path(
        [(bottom, axis + 160), (rim, axis + 160), (rim, axis + 150), (bottom, axis + 150)],
        stroke=GREY,
        dash="4 4",
        width=1,
    )
    top = wall(middle - 44, 0)
    d.path(
        [(middle - 44, axis + 60), (middle - 44, top), (middle + 44, top), (middle + 44, axis + 60)],
        fill="#e8e8e8",
        closed=True,
    )
    d.path([(middle - 44, top - 16), (middle + 44, top - 16)], width=1)
    d.path([(middle - 44, top - 52), (middle + 44, top - 52)], width=1)
    for x in (middle - 20, middle + 20):
        points = [(x + 18 * math.cos(a), top - 34 + 18 * math.sin(a)) for a in (math.pi * k / 12 for k in range(24))]
        d.path(points, closed=True, fill="white", width=1)
    d.path([(40, axis), (620, axis)], width=1, dash="14 4 3 4", arrow="end")
    d.text((626, axis - 4), "z")
    d.path([(middle, axis - 8), (middle, outer + 12)], width=1, stroke=BLUE, dash="8 3 2 3")
    d.text((middle, axis - 24), "z = 0: middle of the bearing", "middle", BLUE)
    for k in range(5):
        x = first + k * (last - first) / 4
        d.path([(x, wall(x, 2)), (x, outer + 4)], stroke=BLUE, width=0.9)
    d.label("slices z_k: planes across the axis", (590, 742), (last, outer - 6))
    d.label("circular spline", (590, 718), (last - 14, outer - 36))
    d.label("root of its tooth space, turned by the tilt β", (590, 694), (last, spline(last)))
    d.label("flexspline tooth; dashed: tip of the circular spline", (590, 670), (last - 8, wall(last - 8, 28)))
    d.label("coned wall of the cup", (590, 640), (rim, wall(rim, 4)))
    d.label("undeformed cup", (590, axis + 150), (rim, axis + 152))
    d.label("bearing and cam: the wave generator", (590, axis + 100), (middle + 44, axis + 84))
    d.label("cup's bottom", (150, axis + 60), (bottom + 14, axis + 70))
    d.label("apex z_a: here the wall does not move", (40, axis + 250), (bottom + 2, wall(bottom, 12)))
    d.label("radial deformation", (180, axis + 120), (338, wall(338, -20)))
    d.path([(first - 60, spline(middle)), (last, spline(middle))], stroke=RED, width=1, dash="4 3")
    d.path([(first - 60, spline(first - 60)), (first, spline(first))], stroke=RED, width=1, dash="4 3")
    d.text((first - 74, spline(middle) - 7), "β", colour=RED, size=15)
    d.path([(340, axis + 160), (340, wall(340, 10))], stroke=RED, width=1.2, arrow="both")
    d.text((rim + 2, axis + 24), "open end", "middle")
    d.path([(rim, axis + 38), (rim, wall(rim, -6))], width=0.6, stroke=GREY)


def space(shift_up=0.0, offset=0.0):
    """The outline of a tooth space from mid-land to mid-land, moved up, or along its normal."""
    a = math.radians(22)
    half_land, half_bottom, depth = 52.0, 28.0, 100.0
    slant = depth * math.tan(a)
    corner = half_bottom + slant
    side = offset / math.cos(a)
    up = offset + shift_up

    def flank(y):  # x of the right flank at height y
        return corner - (y - shift_up) * math.tan(a) + side

    right = [(flank(depth + up), depth + up), (flank(up), up), (corner + half_land / 2, up)]
    return [(-x, y) for x, y in reversed(right)] + right


def tooth(d):
    """A tooth in its space, in the plane of a slice."""
    x0, y0 = 200, 150
    d.text((40, 345), "One slice: a tooth in its space", bold=True, size=15)
    outline = [(x0 + x, y0 + y) for x, y in space()]
    left, right = outline[0][0], outline[-1][0]
    d.path(outline + [(right, y0 + 150), (left, y0 + 150)], fill=PALE, stroke="none", closed=True)
    d.path(outline)
    inner = [(x0 + 0.82 * x, y0 + y - 18) for x, y in space()[1:-1]]
    d.path(
        [(x0 - 120, y0 - 52), (inner[0][0] - 4, y0 - 30)] + inner + [(inner[-1][0] + 4, y0 - 30), (x0 + 120, y0 - 52)],
        fill=STEEL,
    )
    d.path([(left - 8, y0), (right + 8, y0)], width=0.8, dash="6 3", stroke=BLUE)
    d.path([(x0, y0 - 64), (x0, y0 + 160)], width=0.8, dash="12 3 2 3")
    d.path([(x0 - 100, y0 + 30), (x0 + 100, y0 + 30)], width=0.8, dash="2 3", stroke=GREEN)
    d.label("land", (40, y0 - 26), (left + 14, y0 - 1))
    d.label("tip circle", (318, y0 - 20), (right + 6, y0))
    d.label("pitch line", (318, y0 + 26), (x0 + 96, y0 + 30))
    d.label("flank of the circular spline", (290, y0 + 66), (x0 + 48, y0 + 62))
    d.label("root (bottom of the space)", (290, y0 + 130), (x0 + 20, y0 + 101))
    d.path([(x0 - 45, y0 + 42), (x0 - 53, y0 + 39)], stroke=RED, width=2.4)
    d.label("gap", (36, y0 + 66), (x0 - 52, y0 + 42))
    d.label("flexspline tooth", (318, y0 - 46), (x0 + 62, y0 - 26))


def tilts(d):
    """The same outline of z = 0 moved in two ways."""
    d.text((478, 345), "Two kinds of tilt: the outline at z = 0 and at z &gt; 0", bold=True, size=15)
    for x0, name, words, moved in (
        (590, "radial", "along the radius", space(shift_up=24)),
        (800, "draft", "along the normal", space(offset=24)),
    ):
        y0 = 165
        d.path([(x0 + x, y0 + y) for x, y in space()])
        d.path([(x0 + x, y0 + y) for x, y in moved], stroke=RED)
        a = math.radians(22)
        for x, y in ((0, 100), (49, 48), (-49, 48), (86, 0), (-86, 0)):
            step = (0, 24)
            if name == "draft" and abs(x) == 49:
                step = (math.copysign(24 * math.cos(a), x), 24 * math.sin(a))
            d.path([(x0 + x, y0 + y), (x0 + x + step[0], y0 + y + step[1])], stroke=BLUE, width=1.2, arrow="end")
        d.text((x0, y0 - 28), f'kind = "{name}"', "middle")
        d.text((x0, y0 - 48), "each point moves by z tan β", "middle", size=12)
        d.text((x0, y0 - 64), words, "middle", size=12)
    d.text((695, 66), "black: z = 0, red: a slice towards the open end", "middle", size=12)


def main(output):
    drawing = Drawing(920, 800)
    section(drawing)
    tooth(drawing)
    tilts(drawing)
    drawing.save(output)


if __name__ == "__main__":
    main(*sys.argv[1:])
