#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a folder of wire files with programs that are not ours (numpy, ezdxf, LinuxCNC's interpreter where it is
installed) and with parsers
written here, rebuilds both faces from each, and sweeps the emitted wire with shapely.

  read_wire.py FOLDER STEM THICKNESS LOWER_GUIDE UPPER_GUIDE DECIMALS CHORD TOLERANCE

CHORD [mm]: what the sampled contour and wire may be off between their points; 0: the wire is not swept and the drawing
is not read.
TOLERANCE [mm]: how far the path that a control makes of a contour with G41 or G42 may be off the wire's.
Prints what is wrong, and what was read.
"""

import re
import shutil
import sys
import tempfile
from pathlib import Path

import numpy as np

try:
    import ezdxf
except ImportError:
    ezdxf = None
try:
    from osgeo import ogr
except ImportError:
    ogr = None
try:
    from shapely.geometry import Polygon
except ImportError:
    Polygon = None

folder, stem = Path(sys.argv[1]), sys.argv[2]
T, h_lower, h_upper = map(float, sys.argv[3:6])
UNIT = 10.0 ** -int(sys.argv[6])
CHORD, TOLERANCE = map(float, sys.argv[7:9])
H = h_lower + T + h_upper
DXF_UNIT, UM = 1e-10, 1e-3

faults, said = [], []


def want(condition, text):
    if not condition:
        faults.append(text)


def lines(name):
    data = (folder / name).read_bytes()
    want(data.isascii() and data.endswith(b"\n") and b"\r" not in data, f"{name}: bytes")
    return data.decode("ascii").splitlines()


def words(text):
    """Letter and number, G words apart."""
    found = {}
    for letter, number in re.findall(r"([A-Z])\s*([-+]?[\d.]+)", re.sub(r"\(.*?\)", "", text)):
        if letter == "G":
            found.setdefault("G", []).append(int(number))
        else:
            want(letter not in found, f"{letter} twice in {text}")
            found[letter] = float(number)
    return found


def faces(lower_guide, upper_guide):
    """Straight line through the guides at z = 0 and z = T, by its height above the lower guide."""
    at = lambda z: lower_guide + (upper_guide - lower_guide) * ((z + h_lower) / H)
    return at(0), at(T)


def xyuv(name, guides):
    rows = [words(line) for line in lines(name)]
    moves = np.array([[row[c] for c in "XYUV"] for row in rows if "X" in row])
    want(all(set(row.get("G", [])) & {0, 1} for row in rows if "X" in row), f"{name}: a move without G0, G1")
    text = (folder / name).read_text().splitlines()
    want(text[0] == "%" and text[-2:] == ["M2", "%"] and "G61" in " ".join(text), f"{name}: frame")
    want(max(map(len, text)) <= 80, f"{name}: long lines")
    numbers = [row["N"] for row in rows if "N" in row]
    want(all(a < b for a, b in zip(numbers, numbers[1:])) and max(numbers, default=0) <= 99999, f"{name}: numbers")
    return faces(moves[:, :2], moves[:, 2:]) if guides else (moves[:, :2], moves[:, 2:])


def relative(name):
    lower, lean = [], []
    for line in lines(name):
        row = words(line)
        if "X" in row:
            lower.append((row["X"], row["Y"]))
            lean.append((row.get("U", 0), row.get("V", 0)))
    want("(" not in (folder / name).read_text(), f"{name}: comment")
    return np.array(lower), np.array(lower) + np.array(lean)


def colon(name):
    paths = ([], [])
    text = lines(name)
    want(text[0] == "G91;" and text[-1] == "M02;" and all(line.endswith(";") for line in text), f"{name}: frame")
    want(len(text) <= 200000 and max(map(len, text)) < 200 and "(" not in "".join(text), f"{name}: limits")
    for line in text[1:-1]:
        if line == "M00;":
            continue
        halves = line[:-1].split(":")
        for path, half in zip(paths, halves * 2 if line.startswith("G92") else halves):
            row = words(half)
            path.append((row["X"], row["Y"]))
    return tuple(np.cumsum(path, axis=0) for path in paths)


def three_b(name, start):
    """The straight lines of 3B: absolute lengths, the longer one counts, L1 to L4 is the quadrant."""
    signs = {"1": (1, 1), "2": (-1, 1), "3": (-1, -1), "4": (1, -1)}
    text = lines(name)
    want(text[-1] == "DD", f"{name}: end")
    at, path = np.array(start, float), [np.array(start, float)]
    for line in text[:-1]:
        if line == "D":
            continue
        match = re.fullmatch(r"B(\d+) B(\d+) B(\d+) G([XY]) L([1-4])", line)
        x, y, count = (int(match[i]) for i in (1, 2, 3))
        want(count == max(x, y) == (x if match[4] == "X" else y), f"{name}: {line}")
        # On an axis the quadrant that the line begins: L1 +x, L2 +y, L3 -x, L4 -y.
        want({"1": x > 0, "2": y > 0, "3": x > 0, "4": y > 0}[match[5]], f"{name}: {line}")
        at = at + UM * np.array(signs[match[5]]) * (x, y)
        path.append(at)
    return np.array(path)


def flat_contour(name):
    """The contour with G41 or G42 on the way in and G40 on the way out, the radius of D, and whether it is G41."""
    rows = [words(line) for line in lines(name)]
    moves = [row for row in rows if "X" in row]
    want(set(moves[1]["G"]) & {41, 42} and 40 in moves[-1]["G"], f"{name}: offset on and off")
    want(
        not any({40, 41, 42} & set(row.get("G", [])) for row in moves[2:-1]), f"{name}: offset switched on the contour"
    )
    radius = float(re.search(rf"set D{moves[1]['D']:g} to ([\d.]+) mm", (folder / name).read_text())[1])
    return np.array([(row["X"], row["Y"]) for row in moves]), radius, 41 in moves[1]["G"]


def control(contour, radius, left):
    """What a control with cutter compensation makes of a contour between its leads: each move's parallel, from where
    it meets the one before to where it meets the next; around the outside of a corner points on the arc about it."""
    along = np.diff(contour, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, None]
    normal = (1 if left else -1) * np.column_stack((-along[:, 1], along[:, 0]))
    path, leaves = [], contour[1] + radius * normal[1]
    for k in range(2, len(contour) - 2):
        a, b = normal[k - 1], normal[k]
        if along[k] @ a > 0:  # turns towards the wire: a point at the radius from both moves
            arrives = contour[k] + radius * (np.linalg.solve((a, b), (1, 1)) if a @ b < 1 else a)
            path.append(arrives)
        else:
            arrives = contour[k] + radius * a
            for share in np.linspace(0, 1, 2 + int(40 * np.arccos(np.clip(a @ b, -1, 1)))):
                spoke = (1 - share) * a + share * b
                path.append(contour[k] + radius * spoke / np.linalg.norm(spoke))
        want((arrives - leaves) @ along[k - 1] > 0, f"move {k} of the contour is too short for the offset")
        leaves = path[-1]
    return np.array(path)


def apart(a, b):
    """Largest distance of a point of one of two lines, or of the middle between two, from the other line."""
    with_middles = lambda line: np.vstack((line, (line[1:] + line[:-1]) / 2))
    return max(distance_to(with_middles(a), b, closed=False).max(), distance_to(with_middles(b), a, closed=False).max())


def stops_of(name):
    """Numbers of the points behind which a program stops; 3B begins at a point that it does not say."""
    points, stops = 1 if name.endswith(".3b") else 0, []
    for line in lines(name):
        if re.fullmatch(r"M0?0;?|D", line):
            stops.append(points - 1)
        elif not line.startswith("(") and ("X" in line or line.startswith("B")):
            points += 1
    return stops


def distance_to(points, line, closed=True):
    """Of each point from the line where that is below 0.1 mm, else more than that. Neighbours in the list of points are
    near each other."""
    ends = np.roll(line, -1, axis=0) if closed else line[1:]
    starts = line if closed else line[:-1]
    least, most = np.minimum(starts, ends), np.maximum(starts, ends)
    nearest = np.full(len(points), np.inf)
    for block in np.array_split(np.arange(len(points)), max(1, len(points) // 50)):
        p = points[block]
        close = np.flatnonzero(((most > p.min(0) - 0.1) & (least < p.max(0) + 0.1)).all(axis=1))
        if not len(close):
            continue
        a, along = starts[close], (ends - starts)[close]
        beside = p[:, None, :] - a
        share = np.clip((beside * along).sum(-1) / np.maximum((along**2).sum(-1), 1e-300), 0, 1)
        nearest[block] = np.linalg.norm(beside - share[..., None] * along, axis=-1).min(axis=1)
    return nearest


def dxf_by_groups(name):
    """Polylines by layer: pairs of lines, code and value. A second reader beside ezdxf."""
    text = lines(name)
    groups = [(int(code), value) for code, value in zip(text[::2], text[1::2])]
    want(groups[-1] == (0, "EOF"), f"{name}: end")
    found, kind, point = {}, "", {}
    for code, value in groups:
        if code == 0:
            if kind == "VERTEX":
                found[point[8]][-1].append((float(point[10]), float(point[20]), float(point[30])))
            elif kind == "POLYLINE":
                found.setdefault(point[8], []).append([])
            kind, point = value, {}
        else:
            point[code] = value
    return {layer: [np.array(line) for line in polylines] for layer, polylines in found.items()}


def dxf_by_ezdxf(name):
    drawing = ezdxf.readfile(folder / name)
    want(drawing.dxfversion == "AC1009", f"{name}: version")
    want(not drawing.audit().errors, f"{name}: audit")
    found = {}
    for line in drawing.modelspace().query("POLYLINE"):
        want(line.is_closed == line.dxf.layer.startswith("PART"), f"{name}: closed")
        found.setdefault(line.dxf.layer, []).append(np.array([tuple(v.dxf.location) for v in line.vertices]))
    want({"START", "SYNC"} <= {e.dxf.layer for e in drawing.modelspace()}, f"{name}: start and sync")
    stops = [e.dxf.start.vec2 for e in drawing.modelspace().query('LINE[layer=="STOP"]')]
    at = exact_stops()
    off = np.array(stops, float).reshape(-1, 2) - at if len(stops) == len(at) else np.inf
    want(np.max(np.abs(off), initial=0) <= DXF_UNIT, f"{name}: stops")
    return found


def dxf_by_gdal(name):
    """GDAL repeats the first vertex of what is closed; SYNC and START are no rings of points."""
    source = ogr.Open(str(folder / name))
    found = {}
    for feature in source.GetLayer(0):
        points = np.array(feature.GetGeometryRef().GetPoints())
        layer = feature.GetField("Layer")
        if layer.startswith(("PART", "WIRE")):
            closed = layer.startswith("PART")
            want(not closed or (points[0] == points[-1]).all(), f"{name}: GDAL: {layer} is not closed")
            found.setdefault(layer, []).append(points[:-1] if closed else points)
    return found


def table(name):
    text = [line for line in lines(name) if not line.startswith("#")]
    columns = text[0].split(",")
    rows = [line.split(",") for line in text[1:]]
    return {c: np.array([r[i] if c == "tag" else float(r[i]) for r in rows]) for i, c in enumerate(columns)}


def pair(rows, what=""):
    get = lambda face: np.column_stack((rows[f"x_{face}{what}"], rows[f"y_{face}{what}"]))
    return get("lower"), get("upper")


def compare(name, read, exact, allowed):
    """Largest drift over the whole path, in units."""
    for face, a, b in zip(("lower", "upper"), read, exact):
        if a.shape != b.shape:
            faults.append(f"{name}: {face} has {len(a)} points, not {len(b)}")
            return
        off = np.abs(a - b).max()
        want(off <= allowed, f"{name}: {face} is off by {off:.3g} mm")
    drift = max(np.linalg.norm(a - b, axis=1).max() for a, b in zip(read, exact))
    said.append((name, drift))


def sweep(name, paths, closed, nominal, cut, allowed):
    """What a round wire leaves of the material against the contour: each lies in the other one grown by what is
    allowed."""
    for face, path, outline in zip(("lower", "upper"), paths, nominal):
        wire, part = Polygon(path[closed]), Polygon(outline)
        want(wire.is_valid and part.is_valid, f"{name}: {face} crosses itself")
        swept = wire.buffer(cut if wire.area < part.area else -cut, 128)
        fits = lambda off: part.buffer(off).contains(swept) and swept.contains(part.buffer(-off))
        least, most = 0, allowed
        want(fits(most), f"{name}: what is cut in the {face} face is off by more than {allowed:.3g} mm")
        for _ in range(5):
            middle = (least + most) / 2
            least, most = (least, middle) if fits(middle) else (middle, most)
        said.append((f"{name} swept, {face}, below", most))


def exact_stops():
    return pair(rows)[0][rows["tag"] == "stop"]


def linuxcnc(names):
    """Moves of each file by name; of a contour with G41 the moves that the interpreter makes of it, with G41.1 in place
    of a table of tools."""
    try:
        import gcode as interpreter
    except ImportError:
        print("LinuxCNC is not installed: its interpreter was not tried")
        return {}

    class Canon:
        """What the interpreter asks of its machine; moves are kept, in inches."""

        def __init__(self):
            self.moves, self.parameter_file = [], str(parameters)

        def straight(self, x, y, z, a, b, c, u, v, w):
            self.moves.append((25.4 * x, 25.4 * y, 25.4 * u, 25.4 * v))

        straight_traverse = straight_feed = straight

        def arc_feed(self, x, y, x_centre, y_centre, turn, *rest):
            """Points on the arc from where the machine is."""
            start, centre = np.array(self.moves[-1][:2]) / 25.4, np.array((x_centre, y_centre))
            angles = [np.arctan2(*(p - centre)[::-1]) for p in (start, np.array((x, y)))]
            sweep = (angles[1] - angles[0]) % (2 * np.pi) - (2 * np.pi if turn < 0 else 0)
            for share in np.linspace(0, 1, 2 + int(40 * abs(sweep)))[1:]:
                angle = angles[0] + share * sweep
                spoke = np.array((np.cos(angle), np.sin(angle)))
                self.straight(*(centre + np.linalg.norm(start - centre) * spoke), *7 * (0,))

        def get_axis_mask(self):
            return 1 | 2 | 64 | 128

        def get_external_length_units(self):
            return 1.0

        get_external_angular_units = get_external_length_units

        def get_tool(self, pocket):
            return (-1,) + 13 * (0,)  # number, offsets, diameter, angles, orientation: none

        def __getattr__(self, name):
            if name.startswith("get_"):
                return lambda *arguments: 0
            return lambda *arguments: None

    paths = {}
    here = Path(tempfile.mkdtemp())
    parameters = here / "linuxcnc.var"
    for name in names:
        parameters.touch()  # the interpreter renames it when it ends
        canon = Canon()
        program = here / name
        text = (folder / name).read_text()
        for number, radius in re.findall(r"set D(\d+) to ([\d.]+) mm", text):
            text = re.sub(rf"(G4[12]) D{number} ", rf"\1.1 D{2 * float(radius):.6f} ", text)
        program.write_text(text)
        result, line = interpreter.parse(str(program), canon, "G21", "")
        want(result <= interpreter.MIN_ERROR, f"{name}, line {line}: LinuxCNC: {interpreter.strerror(result)}")
        paths[name] = np.array(canon.moves)
    shutil.rmtree(here)
    return paths


rows = table(f"{stem}_path.csv")
contour = table(f"{stem}_contour.csv")
nominal = pair(contour)
passes = int(rows["pass"].max())
offsets = {}
for number in range(1, passes + 1):
    these = {key: value[rows["pass"] == number] for key, value in rows.items()}
    exact, tags = pair(these), these["tag"]
    want(tags[0] == "thread" and tags[1] == "lead_in" and tags[-1] == "lead_out", f"pass {number}: tags")
    compare(f"csv, guides, pass {number}", faces(*pair(these, "_guide")), exact, 1e-12)
    for name, read, allowed in (
        (f"{stem}_xyuv_guide_pass{number}.ngc", lambda n: xyuv(n, True), UNIT),
        (f"{stem}_xyuv_face_pass{number}.ngc", lambda n: xyuv(n, False), UNIT),
        (f"{stem}_rel_pass{number}.iso", relative, UNIT),
        (f"{stem}_twoplane_pass{number}.nc", colon, UNIT),
        (
            f"{stem}_lower_pass{number}.3b",
            lambda n: (three_b(n, exact[0][0]), three_b(n.replace("lower", "upper"), exact[0][0])),
            UM,
        ),
    ):
        if name.endswith(".3b") and not (folder / name).exists():
            continue  # its grid is too coarse for the tolerance
        compare(name, read(name), exact, allowed + 1e-12)
        want(stops_of(name) == list(np.flatnonzero(tags == "stop")), f"{name}: stops")
    flat = f"{stem}_2d_pass{number}.iso"
    if (folder / flat).exists():
        contour_2d, radius, left = flat_contour(flat)
        wire = exact[0][1:-1]
        off = apart(control(contour_2d, radius, left), wire)
        want(off <= TOLERANCE, f"{flat}: a control would make a path {off:.3g} mm off the wire's")
        lengths = np.linalg.norm(np.diff(contour_2d, axis=0), axis=1)
        want(lengths.min() >= 2 * UNIT, f"{flat}: a block of {lengths.min():.3g} mm")
        want(min(lengths[0], lengths[-1]) > radius, f"{flat}: leads shorter than the offset")
        stops = contour_2d[stops_of(flat)]
        at = exact[0][tags == "stop"]
        want(
            stops.shape == at.shape and (np.abs(np.linalg.norm(stops - at, axis=1) - radius) <= TOLERANCE).all(),
            f"{flat}: stops",
        )
        said.append((f"{flat}, offset by {radius:g} mm", off))
    name = f"{stem}_xyuv_face_pass{number}.ngc"
    head = (folder / name).read_text()
    offset = float(re.search(r"wire centre ([\d.]+) mm", head)[1])
    closed = np.isin(tags, ("lead_in", "contour", "stop"))
    along = exact[0][closed]
    if np.linalg.norm(along[0] - along[-1]) > 0:
        print(f"pass {number} does not close: it was not swept here")
        continue
    if Polygon is not None and CHORD > 0:
        for each, guides in ((name, False), (name.replace("face", "guide"), True)):
            sweep(each, xyuv(each, guides), closed, nominal, offset, UNIT + CHORD)
if Polygon is None:
    print("shapely is not installed: nothing was swept")

readers = {"groups": dxf_by_groups} if CHORD > 0 else {}
if ezdxf is None:
    print("ezdxf is not installed: not tried")
elif readers:
    readers["ezdxf"] = dxf_by_ezdxf
if ogr is None:
    print("GDAL is not installed: not tried")
elif readers:
    ogr.UseExceptions()
    readers["GDAL"] = dxf_by_gdal
for reader, read in readers.items():
    layers = read(f"{stem}_planes.dxf")
    want(
        set(layers) == {"PART_LOWER", "PART_UPPER", "WIRE_LOWER", "WIRE_UPPER"},
        f"dxf, {reader}: layers {sorted(layers)}",
    )
    for layer, lines_of_layer in layers.items():
        z = T if layer.endswith("UPPER") else 0
        want(all((line[:, 2] == z).all() for line in lines_of_layer), f"dxf, {reader}: height of {layer}")
    compare(
        f"dxf, {reader}, contour", [layers[f"PART_{face}"][0][:, :2] for face in ("LOWER", "UPPER")], nominal, DXF_UNIT
    )
    for number in range(1, passes + 1):
        these = {key: value[rows["pass"] == number] for key, value in rows.items()}
        compare(
            f"dxf, {reader}, pass {number}",
            [layers[f"WIRE_{face}"][number - 1][:, :2] for face in ("LOWER", "UPPER")],
            pair(these),
            DXF_UNIT,
        )

names = [f"{stem}_xyuv_{plane}_pass{number}.ngc" for number in range(1, passes + 1) for plane in ("face", "guide")]
names += [path.name for path in sorted(folder.glob(f"{stem}_2d_pass*.iso"))]
for name, moves in linuxcnc(names).items():
    number = int(re.search(r"pass(\d+)", name)[1])
    these = {key: value[rows["pass"] == number] for key, value in rows.items()}
    planes = moves[:, :2], moves[:, 2:]
    if "_2d_" in name:  # start hole and way in, way out and end
        off = apart(moves[2:-2, :2], pair(these)[0][1:-1])
        want(off <= TOLERANCE, f"LinuxCNC, {name}: {off:.3g} mm off the wire's path")
        said.append((f"LinuxCNC, {name}", off))
        continue
    compare(f"LinuxCNC, {name}", faces(*planes) if "guide" in name else planes, pair(these), UNIT + 1e-9)

for name, drift in said:
    print(f"{name}: {drift * 1000:.4f} um")
print(*faults, sep="\n")
print(f"{len(said)} compared, {len(faults)} faults")
sys.exit(1 if faults else 0)
