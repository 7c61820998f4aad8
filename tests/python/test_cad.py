# SPDX-License-Identifier: GPL-3.0-or-later
"""Rings as solids: closed, of the volume of the outlines, and the same after a trip through a STEP file."""

import os
import re
from collections import defaultdict

import numpy as np
import pytest
import hdconj

pytest.importorskip("OCP")

FULL = "HDCONJ_FULL" in os.environ


def read_back(file):
    """The solids of a STEP file by Open CASCADE: volumes, and largest coordinates to a hundredth of a mm."""
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer

    from hdconj import _step

    reader = STEPControl_Reader()
    assert reader.ReadFile(str(file)).name == "IFSelect_RetDone"
    with _step._quiet():
        reader.TransferRoots()
    found, solids = TopExp_Explorer(reader.OneShape(), TopAbs_ShapeEnum.TopAbs_SOLID), []
    while found.More():
        box = Bnd_Box()
        BRepBndLib.Add_s(found.Current(), box, False)
        assert _step.is_sound(found.Current())
        corner = box.CornerMax()
        solids.append((_step.volume_of(found.Current()), (corner.X(), corner.Y(), corner.Z())))
        found.Next()
    return solids


def shells_are_closed(file):
    """Reads the text: in each closed shell every edge is used twice, once in each direction."""
    entities = dict(re.findall(r"#(\d+)\s*=\s*([^;]*);", file.read_text()))

    def numbers(entity):
        return re.findall(r"#(\d+)", entities[entity])

    shells = [name for name, entity in entities.items() if entity.startswith("CLOSED_SHELL")]
    for shell in shells:
        uses = defaultdict(list)
        for face in numbers(shell):
            for bound in numbers(face)[:-1]:
                turned = entities[bound].rstrip(" )").endswith(".F.")
                loop = numbers(bound)[0]
                for oriented in numbers(loop):
                    edge = numbers(oriented)[-1]
                    uses[edge].append(entities[oriented].rstrip(" )").endswith(".T.") != turned)
        assert uses and all(sorted(each) == [False, True] for each in uses.values())
    return len(shells)


@pytest.fixture(scope="module")
def drive():
    """Of few teeth, so that solids are made soon; on a cone where it has slices."""
    return hdconj.design(ratio=30, diameter=50).scene.with_({"solver.tolerance": 1e-5})


@pytest.fixture(scope="module")
def solved(drive):
    return hdconj.solve(drive)


@pytest.fixture(scope="module")
def cone(drive):
    return drive.with_({"coning.model": "linear", "coning.bottom_to_middle": 8.0, "coning.apex_height": 0.4})


TEETH = 60, 62


def wall_area(solved):
    steps = np.diff(solved.circular_spline.outline, axis=1)
    width = solved.scene.to_dict()["circular_spline"]["width"]
    return TEETH[1] * width * np.linalg.norm(steps, axis=2).sum(axis=1).max()


def test_straight_ring(solved, tmp_path):
    file = tmp_path / "ring.step"
    (ring,) = solved.to_step(file)
    assert ring.name == "circular-spline" and ring.is_sound and ring.between is None
    assert ring.deviation <= 1e-3
    # The walls are no farther from the outlines than that.
    assert ring.volume.error <= wall_area(solved) * ring.deviation
    assert ring.volume.error < 2e-5 * ring.volume.value
    ((volume, corner),) = read_back(file)
    assert volume == pytest.approx(ring.volume.value, rel=1e-7)
    root = np.linalg.norm(solved.circular_spline.outline[0], axis=1).max()
    assert corner == pytest.approx((1.4 * root, 1.4 * root, 5.14 / 2), abs=0.01)
    assert shells_are_closed(file) == 1
    assert os.listdir(tmp_path) == ["ring.step"]


@pytest.mark.parametrize("surface, tilt", [("tilted", "radial"), ("tilted", "draft"), ("ruled", None)])
def test_tilted_and_ruled_rings(cone, surface, tilt, tmp_path):
    changes = {"slices.count": 3, "slices.surface": surface}
    if tilt:
        changes |= {"tilt.angle_deg": 0.2, "tilt.kind": tilt}
    (ring,) = hdconj.solve(cone.with_(changes)).to_step(tmp_path / "ring.step", outer_radius=35)
    assert ring.is_sound and ring.deviation <= 1e-3
    assert ring.between < 1e-5 if tilt == "draft" else ring.between is None
    assert ring.volume.error < 2e-5 * ring.volume.value


def test_tolerance_is_kept(solved, tmp_path):
    fine, rough = (solved.to_step(tmp_path / "ring.step", tolerance=each)[0] for each in (1e-4, 1e-2))
    assert fine.deviation <= 1e-4 < rough.deviation <= 1e-2
    assert fine.volume.error < rough.volume.error


def test_loft_of_slices(cone, tmp_path):
    """More slices leave less between them; what is left is stated."""
    between = []
    for count in (5, 9, 17) if FULL else (5, 9):
        solved = hdconj.solve(cone.with_({"slices.count": count, "slices.surface": "per-slice"}))
        (ring,) = solved.to_step(tmp_path / "ring.step", outer_radius=35, tolerance=2e-3)
        assert ring.is_sound and ring.deviation <= 2e-3
        assert ring.volume.error < wall_area(solved) * ring.deviation
        between.append(ring.between)
    assert all(later < 0.5 * earlier for earlier, later in zip(between, between[1:]))
    ((volume, _),) = read_back(tmp_path / "ring.step")
    assert volume == pytest.approx(ring.volume.value, rel=1e-6)


def test_surface_of_a_contact_study(cone, tmp_path):
    """Slices of a study have been seen by nothing else: every second one is left out to judge the rest."""
    study = hdconj.contact(cone.with_({"slices.count": 5, "contact.flank_points": 40}), surfaces="per-slice")
    (ring,) = study.to_step(tmp_path / "ring.step", outer_radius=35, tolerance=2e-3)
    assert ring.is_sound and 0 < ring.between < 0.1


def test_deformed_flexspline_follows_the_neutral_curve(solution):
    """Frames of the teeth, and of places between them, stand on the curve, normal to it."""
    curve = np.concatenate([solution.neutral_curve, solution.neutral_curve[:1]])
    around = np.unwrap(np.arctan2(curve[:, 0], curve[:, 1]))
    for pitches in (0.0, 0.5, -0.25):
        rows = np.array(hdconj._core.flexspline_poses(solution.scene._core, [0.0], pitches)).reshape(200, 4)
        own = np.arctan2(rows[:, 2], rows[:, 3]) % (2 * np.pi)
        radius = np.interp(own, around, np.hypot(*curve.T))
        assert np.hypot(rows[:, 2], rows[:, 3]) == pytest.approx(radius, abs=1e-4)
        steps = np.roll(rows[:, 2:], -1, axis=0) - np.roll(rows[:, 2:], 1, axis=0)
        along = np.abs((steps * rows[:, :2]).sum(axis=1))  # the first two are the direction of y
        assert along.max() < 2e-3 * np.linalg.norm(steps, axis=1).min()
    assert rows[0, 2] < 0  # a quarter of a pitch before the major axis
    first = hdconj._core.flexspline_poses(solution.scene._core, [0.0], 0.0)[:4]
    assert first == pytest.approx([0, 1, 0, solution.summary.r_0_mm + 0.25], abs=1e-9)


def test_assembly_in_mesh(solved, tmp_path):
    file = tmp_path / "drive.step"
    spline, flexspline = solved.to_step(file, part="assembly")
    assert [spline.name, flexspline.name] == ["circular-spline", "flexspline"]
    assert spline.is_sound and flexspline.is_sound and flexspline.deviation <= 1e-3
    assert flexspline.volume.error < 2e-4 * flexspline.volume.value
    assert shells_are_closed(file) == 2
    text = file.read_text()
    assert "'circular-spline'" in text and "'flexspline'" in text
    _, (volume, corner) = read_back(file)
    assert volume == pytest.approx(flexspline.volume.value, rel=1e-6)
    at_rest = solved.summary.r_m_mm + solved.summary.pitch_line_mm + solved.summary.addendum_mm
    assert corner[1] == pytest.approx(at_rest + solved.summary.w0_mm, abs=0.05)  # the major axis
    assert corner[0] == pytest.approx(at_rest - solved.summary.w0_mm, abs=0.05)


def test_deformed_flexspline_of_slices(cone, tmp_path):
    solved = hdconj.solve(cone.with_({"slices.count": 5, "slices.surface": "per-slice"}))
    (ring,) = solved.to_step(tmp_path / "ring.step", part="flexspline", deformed=True, tolerance=2e-3)
    assert ring.is_sound and 0 < ring.between < 1e-3
    assert ring.volume.error < 1e-3 * ring.volume.value


def test_teeth_touch_their_spaces_and_do_not_enter_them(solved):
    path = pytest.importorskip("matplotlib.path")
    from hdconj import _cad

    outline = solved.circular_spline.outline[0]
    void = path.Path(np.concatenate([_cad._turned(outline, 2 * np.pi * i / TEETH[1]) for i in range(TEETH[1])]))
    poses = _cad._poses(solved, np.zeros(1), 0.0, True)[:, 0]
    assert len(poses) == TEETH[0]

    def is_free(factor):
        tooth = solved.flexspline.outline * factor + [0, solved.summary.pitch_line_mm]
        return void.contains_points(_cad._placed(tooth, poses).reshape(-1, 2)).all()

    assert is_free(1 - 1e-4) and not is_free(1 + 1e-3)


def test_undeformed_flexspline(solved, tmp_path):
    (ring,) = solved.to_step(tmp_path / "ring.step", part="flexspline")
    assert ring.is_sound and ring.volume.error < 2e-4 * ring.volume.value
    ((_, corner),) = read_back(tmp_path / "ring.step")
    at_rest = solved.summary.r_m_mm + solved.summary.pitch_line_mm + solved.summary.addendum_mm
    assert corner[0] == pytest.approx(at_rest, abs=0.05)


def test_bad_arguments(solution, tmp_path):
    for words in ({"part": "cup"}, {"tolerance": 0}, {"outer_radius": 20.0}):
        with pytest.raises(hdconj.InputError) as refused:
            solution.to_step(tmp_path / "ring.step", **words)
        assert refused.value.faults[0].path == next(iter(words)) and refused.value.faults[0].remedy
    narrow = hdconj.solve(hdconj.Scene().with_({"circular_spline.width": None}))
    with pytest.raises(hdconj.InputError, match="circular_spline.width"):
        narrow.to_step(tmp_path / "ring.step")
    with pytest.raises(TypeError, match="no outlines"):
        hdconj.wedm().to_step(tmp_path / "ring.step")
    with pytest.raises(hdconj.FileError, match="nowhere"):
        solution.to_step(tmp_path / "nowhere" / "ring.step")
    assert list(tmp_path.iterdir()) == []
