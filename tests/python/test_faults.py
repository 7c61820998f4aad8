# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input is refused with the faults of the program, word by word."""

import ast
import enum
import json
import math
import os
import re
import subprocess
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from conftest import SOURCE, run_program

import hdconj

TEETH = SOURCE / "data/measured/flexspline-teeth.csv"
WANTED = SOURCE / "data/scenes/type-50-wanted.toml"


@pytest.fixture(scope="session")
def bad_scenes(tmp_path_factory):
    """The tables of bad scenes of the program's own tests, a file for each."""
    folder = tmp_path_factory.mktemp("bad")
    writer = os.environ["HDCONJ_CLI_TESTS"]
    environment = {**os.environ, "HDCONJ_BAD_SCENES": str(folder)}
    subprocess.run([writer, "[write-bad-scenes]"], env=environment, check=True, capture_output=True)
    return sorted(folder.iterdir())


def as_json(item):
    """JSON has no tuples and no bytes that are no UTF-8."""
    if isinstance(item, tuple):
        return list(item)
    return item.encode("utf-8", "surrogateescape").decode("utf-8", "replace") if isinstance(item, str) else item


def test_same_faults_with_the_same_text(bad_scenes):
    assert len(bad_scenes) > 100
    for file in bad_scenes:
        scene = hdconj.Scene.load(file)
        said = run_program("check", file, "--json", status=2)
        faults = json.loads(said.stdout)["faults"]
        ours = [fault._asdict() for fault in scene.check()]
        assert [{name: fault[name] for name in ours[0]} for fault in faults] == [
            {name: as_json(item) for name, item in fault.items()} for fault in ours
        ], file.name
        with pytest.raises(hdconj.InputError) as refused:
            hdconj.solve(scene)
        assert refused.value.faults == scene.check()
        assert str(refused.value) == said.stderr.split("\n", 1)[1].rstrip("\n"), file.name


def test_changes_are_those_of_set():
    scene = hdconj.Scene().with_({"flexspline.wall": -1, "drive.modul": 0.25, "solver.kinematics": "exactly"})
    said = run_program(
        "check", "--set=flexspline.wall=-1", "--set=drive.modul=0.25", "--set=solver.kinematics=exactly", status=2
    )
    with pytest.raises(hdconj.InputError) as refused:
        hdconj.solve(scene)
    assert str(refused.value) == said.stderr.split("\n", 1)[1].rstrip("\n").replace("--set: ", "with_(): ")
    assert {fault.origin for fault in scene.check()} == {"--set"}


@pytest.mark.parametrize("changes", [{"tilt": None}, {"a wall": 0.8}, {"solver.kinematics": {1}}])
def test_remedies_of_changes_can_be_followed(changes):
    scene = hdconj.Scene().with_(changes)
    (fault,) = scene.check()
    *_, remedy = re.findall(r"with_\((.*?)\)", fault.remedy)
    assert hdconj.Scene().with_({"tilt.angle_deg": 0.2}).with_(ast.literal_eval(remedy)).check() == ()
    with pytest.raises(hdconj.InputError) as refused:
        hdconj.solve(scene)
    assert refused.value.faults == (fault,) and fault.remedy in str(refused.value)
    assert "--" not in str(refused.value)


def test_numerical_failure():
    said = run_program("solve", "--set=wave_generator.radial_deformation=0.05", status=1)
    with pytest.raises(hdconj.NumericalError) as failed:
        hdconj.solve(hdconj.Scene().with_({"wave_generator.radial_deformation": 0.05}))
    assert failed.value.code == "no-land" and failed.value.stage == "region"
    assert failed.value.set[0].startswith("wave_generator.radial_deformation=")
    assert f"hdconj: {failed.value}\n" in said.stderr


def test_a_dialect_that_does_not_fit(tmp_path):
    """Its remedy is the tolerance that the program looks for; a dialect of the scene's counts as named."""
    scene = hdconj.Scene().with_({"tilt.angle_deg": 0.2})
    said = run_program("wedm", "--tilt=0.2", "--dialect=3b", "-o", tmp_path / "a", status=1)
    for call in (
        lambda: hdconj.wedm(scene, dialects="3b"),
        lambda: hdconj.wedm(scene.with_({"wedm.dialects": "3b"})),
    ):
        with pytest.raises(hdconj.NumericalError) as failed:
            call()
        assert failed.value.remedy == "write wedm.tolerance = 0.0008, or another dialect"
        assert f"hdconj: {failed.value}\n" in said.stderr
    hdconj.wedm(scene.with_({"wedm.tolerance": 0.0008}), dialects="3b", folder=tmp_path / "b")
    assert list((tmp_path / "b").glob("*.3b"))
    left_out = hdconj.wedm(scene)
    said = run_program("wedm", "--tilt=0.2", "--json", "-o", tmp_path / "c")
    assert left_out.to_dict()["left_out"] == json.loads(said.stdout)["left_out"] != []


def test_faults_of_a_measurement(tmp_path):
    (tmp_path / "loop.csv").write_text("torque [N m], angle [ells]\n1, 2\n")
    with pytest.raises(hdconj.InputError, match="ells"):
        hdconj.load(measured=tmp_path / "loop.csv")
    with pytest.raises(hdconj.InputError, match="write one of cup, circular-spline"):
        hdconj.read_measured(SOURCE / "data/measured/torque-twist.csv", output_member="hub")


def test_a_rig_is_told_where_it_is_named(tmp_path):
    """Constants of the rig are arguments of read_measured() alone."""
    (tmp_path / "loop.csv").write_text("current [A], angle [deg]\n1, 2\n")
    for call, said in ((hdconj.read_measured, "such as torque_constant=0.119"),
                       (lambda file: hdconj.load(measured=file), "read_measured(FILE, torque_constant=0.119)")):
        with pytest.raises(hdconj.InputError) as refused:
            call(tmp_path / "loop.csv")
        assert said in str(refused.value) and "--" not in str(refused.value)


def test_a_missing_file_stays_missing_whatever_is_changed(tmp_path):
    missing = hdconj.Scene.load(tmp_path / "nowhere.toml")
    assert missing.with_({"flexspline.wall": 0.6}).check() == missing.check()
    (tmp_path / "empty.toml").touch()
    changed = hdconj.Scene.load(tmp_path / "empty.toml").with_({"flexspline.wall": 0.6})
    assert "drive" in [fault.path for fault in changed.check()]


def test_missing_file():
    assert "nowhere.toml" in hdconj.Scene.load("nowhere.toml").check()[0].path
    with pytest.raises(hdconj.InputError, match="nowhere.toml"):
        hdconj.solve("nowhere.toml")


def test_wrong_words_are_faults():
    with pytest.raises(hdconj.InputError, match="write one of tilted, ruled, per-slice"):
        hdconj.contact(surfaces=["level"])


@pytest.mark.parametrize(
    ("option", "call"),
    [
        ("revolution", lambda page: hdconj.contact(revolution=-1)),
        ("revolution", lambda page: hdconj.contact(revolution=10**9)),
        ("revolution", lambda page: hdconj.report(None, page, parts="contact", revolution=-3)),
        ("tilts_deg", lambda page: hdconj.report(None, page, tilts_deg=[0.2])),
        ("curve", lambda page: hdconj.report(None, page, parts="contact", curve=False)),
        ("points", lambda page: hdconj.load(torque=20, points=10**9)),
        ("torque", lambda page: hdconj.load(torque=0)),
        ("torque", lambda page: hdconj.load(torque=-5)),
        ("torque", lambda page: hdconj.load(torque=np.array(-5.0))),
        ("positions", lambda page: hdconj.run(positions=10**9)),
        ("sample", lambda page: hdconj.accuracy(sample=-1)),
        ("repeats", lambda page: hdconj.accuracy(repeats=-1)),
        ("tilts_deg", lambda page: hdconj.contact(tilts_deg=[math.nan])),
        ("best_deg", lambda page: hdconj.contact(best_deg=(0.1, 0.1))),
        ("best_deg", lambda page: hdconj.contact(best_deg=(0, 0.1), surfaces="ruled")),
        ("kinds", lambda page: hdconj.contact(kinds="draft", surfaces="ruled")),
        ("points", lambda page: hdconj.load(torque=20, points=4, curve=False)),
        ("measured", lambda page: hdconj.load(torque=20, measured="nowhere.csv")),
        ("file", lambda page: hdconj.read_measured("nowhere.csv")),
        ("studies", lambda page: hdconj.accuracy(studies="foo")),
        ("points", lambda page: hdconj.inspect(None, "nowhere.csv")),
        ("diameter", lambda page: hdconj.design(100)),
        ("length_ratio", lambda page: hdconj.design(100, diameter=50, length_ratio=3)),
        ("scenes", lambda page: hdconj.report([], page)),
        ("file", lambda page: hdconj.report(None, page.with_suffix(".txt"))),
        ("dialects", lambda page: hdconj.wedm(dialects="foo")),
        ("name", lambda page: hdconj.design(100, diameter=50, name="a\nb")),
        ("probe", lambda page: hdconj.inspect(None, TEETH, probe=math.nan)),
        ("plane", lambda page: hdconj.inspect(None, TEETH, plane=math.inf)),
        ("wave_generator.family", lambda page: hdconj.find_neutral_curve(hdconj.Scene())),
        ("wave_generator.family", lambda page: hdconj.solve(WANTED)),
        ("verb", lambda page: hdconj.Scene().plan("wedm")),
        ("verb", lambda page: hdconj.Scene.load(WANTED).plan("load")),
    ],
)
def test_limits_of_arguments(option, call, tmp_path):
    with pytest.raises(hdconj.InputError) as refused:
        call(tmp_path / "page.html")
    assert [fault.path for fault in refused.value.faults] == [option]
    assert refused.value.faults[0].reason and refused.value.faults[0].remedy
    assert refused.value.faults[0].remedy in str(refused.value)
    assert "--" not in str(refused.value).replace("hdconj solve --completed", "")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("said", "call"),
    [
        (r"with_\(\) takes a mapping", lambda: hdconj.Scene().with_(["tilt"])),
        (r"with_\(\) takes a mapping", lambda: hdconj.Scene().with_(None)),
        (r"from_dict\(\) takes a mapping", lambda: hdconj.Scene.from_dict([1])),
        (r"the key 1 of a scene", lambda: hdconj.Scene.from_dict({"drive": {1: 2}})),
        (r"from_toml\(\) takes text, not bytes", lambda: hdconj.Scene.from_toml(b"")),
        (r"tilts_deg takes a number or several", lambda: hdconj.contact(tilts_deg="0.1")),
        (r"tilts_deg takes a number, not 'a'", lambda: hdconj.contact(tilts_deg=[0, "a"])),
        (r"surfaces takes text, not 3", lambda: hdconj.contact(surfaces=[3])),
        (r"best_deg takes two numbers", lambda: hdconj.contact(best_deg=(0, 0.1, 0.2))),
        (r"revolution takes a whole number", lambda: hdconj.contact(revolution=2**40)),
        (r"torque takes a number, not '5'", lambda: hdconj.load(torque="5")),
        (r"errors takes True or False, not 'no'", lambda: hdconj.load(errors="no")),
        (r"positions takes a whole number up to \d+, not 2.5", lambda: hdconj.run(positions=2.5)),
        (r"part takes text, not None", lambda: hdconj.inspect(None, "points.csv", part=None)),
        (r"ratio takes a number, not '100'", lambda: hdconj.design("100", diameter=50)),
        (r"diameter takes a number, not '50'", lambda: hdconj.design(100, diameter="50")),
        (r"family takes text, not 3", lambda: hdconj.design(100, diameter=50, family=3)),
    ],
)
def test_wrong_types_say_what_is_expected(said, call):
    with pytest.raises(TypeError, match=said):
        call()


def test_numbers_of_numpy_are_numbers(coned):
    given = {"tilts_deg": np.float32(0.125), "revolution": np.int64(2), "errors": np.bool_(False)}
    plain = hdconj.contact(coned, tilts_deg=0.125, revolution=2, errors=False)
    for numbers in given, {name: np.array(number) for name, number in given.items()}:
        assert (hdconj.contact(coned, **numbers).contact.contact_area == plain.contact.contact_area).all()


def test_one_tilt_is_a_list_of_one(coned):
    for one in (0.1, np.array(0.1)):
        assert hdconj.contact(coned, tilts_deg=one, errors=False).contact.contact_area.size == 1


def test_advice_of_a_tip_circle_can_be_followed():
    (fault,) = hdconj.Scene().with_({"drive.module": 10000}).check()
    low, high = re.search(r"a radius between (\S+) and (\S+)", fault.remedy).groups()
    assert float(low) < float(high.rstrip(","))


def test_scene_goes_through_text_and_dictionaries():
    scene = hdconj.Scene.load(SOURCE / "data/scenes/arc-chain.toml")
    assert scene.check() == ()
    again = hdconj.Scene.from_dict(scene.to_dict())
    assert again.check() == ()
    assert again.to_dict() == scene.to_dict()
    bits = [hdconj.solve(each).circular_spline.outline.tobytes() for each in (scene, again)]
    assert bits[0] == bits[1]
    assert hdconj.Scene.from_toml(scene.to_toml()).to_toml() == scene.to_toml()


class Count(enum.IntEnum):
    NINE = 9


@pytest.mark.parametrize(
    ("given", "value"),
    [
        (Count.NINE, 9), (np.int8(9), 9), (np.bool_(True), True), (Fraction(3, 4), 0.75), (np.longdouble(0.75), 0.75),
        (np.array(0.75, np.longdouble), 0.75), (np.array([0.75, 1], np.longdouble), [0.75, 1.0]),
        (Path("points.csv"), "points.csv"), ("\U0001f642 \U00020bb7", "\U0001f642 \U00020bb7"),
        ("\0\t\n\x1f\"\\\x7f\x85\xe9\u2028\ufeff", "\0\t\n\x1f\"\\\x7f\x85\xe9\u2028\ufeff"),
        ({"\U0001f642": "\x7f"}, {"\U0001f642": "\x7f"}),
    ],
)  # fmt: skip
def test_values_of_keys(given, value):
    scenes = hdconj.Scene().with_({"drive.name": given}), hdconj.Scene.from_dict({"drive": {"name": [given]}})
    found = [scene.to_dict()["drive"]["name"] for scene in scenes]
    assert repr(found) == repr([value, [value]])  # 9 is not 9.0


def test_change_and_removal_of_a_key():
    scene = hdconj.Scene().with_({"tilt.angle_deg": 0.2, "tilt.kind": "radial"})
    assert scene.to_dict()["tilt"] == {"angle_deg": 0.2, "kind": "radial"}
    assert "tilt" not in scene.with_({"tilt": None}).to_dict()
    assert scene == hdconj.Scene().with_({"tilt.angle_deg": 0.2}).with_({"tilt.kind": "radial"})
    with pytest.raises(AttributeError):
        scene.name = "other"
