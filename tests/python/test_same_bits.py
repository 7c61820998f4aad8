# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays and figures of the package are those of the program, bit by bit."""

import json
import pickle

import h5py
import pytest
from conftest import SCENES, SOURCE, run_program, same_bits, without_clock

import hdconj

CONED = ["slices.count=3", "contact.flank_points=40"]


def compare(result, words, tmp_path):
    file = tmp_path / "program.h5"
    said = run_program(*words, "-o", file, "--json")
    with h5py.File(file) as stored:
        same_bits(result, stored)
    assert without_clock(result.to_dict()) == without_clock(json.loads(said.stdout))


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.stem)
def test_solve(scene, tmp_path):
    compare(hdconj.solve(scene), ["solve", scene], tmp_path)


def test_neutral_curve(tmp_path):
    scene = SOURCE / "data/scenes/type-50-wanted.toml"
    compare(hdconj.find_neutral_curve(scene), ["solve", scene], tmp_path)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.stem)
def test_contact(scene, tmp_path):
    quick = {"slices.count": 3, "contact.flank_points": 40, "circular_spline.width": 7}
    changes = [f"--set={key}={value}" for key, value in quick.items()]
    asked = hdconj.Scene.load(scene).with_(quick)
    try:
        study = hdconj.contact(asked, tilts_deg=[0, 0.1], kinds="radial")
    except hdconj.InputError as error:
        said = run_program("contact", scene, *changes, "--tilt=0,0.1", "--kind=radial", status=2)
        assert str(error).replace("with_(): ", "--set: ") in said.stderr
        return
    except hdconj.NumericalError as error:
        said = run_program("contact", scene, *changes, "--tilt=0,0.1", "--kind=radial", status=1)
        assert str(error) in said.stderr
        return
    file = tmp_path / "program.h5"
    run_program(
        "contact", scene, *changes, "--tilt=0,0.1", "--kind=radial", "-o", file, status=1 if study.missing else 0
    )
    with h5py.File(file) as stored:
        same_bits(study, stored)


def test_best_tilt_and_revolution(coned, tmp_path):
    scene = SOURCE / "data/scenes/type-50-coned.toml"
    words = ["contact", scene, *(f"--set={key}" for key in CONED), "--surface=tilted", "--best", "--tilt=0,1"]
    words.append("--revolution=3")
    study = hdconj.contact(coned, surfaces="tilted", tilts_deg=[0, 1], best_deg=(0, 1), revolution=3)
    compare(study, words, tmp_path)


def test_contact_without_errors(coned, tmp_path):
    scene = SOURCE / "data/scenes/type-50-coned.toml"
    words = ["contact", scene, *(f"--set={key}" for key in CONED), "--no-errors"]
    study = hdconj.contact(coned, errors=False)
    compare(study, words, tmp_path)
    figure = study.contact.figures["contact_fraction"]
    assert figure.error is None
    assert (figure.value == hdconj.contact(coned).contact.figures["contact_fraction"].value).all()
    with pytest.raises(AttributeError):
        study.contact.contact_fraction_error  # noqa: B018


def test_load_without_errors(tmp_path):
    quick = hdconj.load(hdconj.Scene().with_({"slices.count": 3}), torque=10, curve=False, errors=False)
    compare(quick, ["load", "--set=slices.count=3", "--torque=10", "--no-curve", "--no-errors"], tmp_path)


def test_load(tmp_path):
    scene = hdconj.Scene().with_({"slices.count": 3})
    study = hdconj.load(scene, points=2)
    compare(study, ["load", "--set=slices.count=3", "--points=2"], tmp_path)


def test_run(tmp_path):
    scene = hdconj.Scene().with_({"slices.count": 1, "friction.flanks": 0.08, "running.torques": [10.0]})
    study = hdconj.run(scene, torque=10, positions=4, errors=False)
    words = ["--set=slices.count=1", "--set=friction.flanks=0.08", "--set=running.torques=[10.0]"]
    compare(study, ["run", *words, "--torque=10", "--positions=4", "--no-errors"], tmp_path)
    assert 0.5 < study.running.losses.efficiency[1] < 1


@pytest.mark.parametrize("member", ["cup", "circular-spline"])
def test_load_beside_a_measurement(member, tmp_path):
    file = SOURCE / "data/measured/torque-twist.csv"
    scene = hdconj.Scene().with_({"slices.count": 3})
    rig = {"torque_constant": 0.119, "counts_per_turn": 2000}
    measured = hdconj.read_measured(file, scene, output_member=member, **rig)
    study = hdconj.load(scene, torque=10, curve=False, errors=False, measured=measured)
    words = ["load", "--set=slices.count=3", "--torque=10", "--no-curve", "--no-errors", f"--measured={file}"]
    words += [f"--{name.replace('_', '-')}={value}" for name, value in rig.items()]
    compare(study, [*words, f"--output-member={member}"], tmp_path)
    assert study.to_dict()["load"]["measured"] == measured.to_dict()
    assert "knee between them [N m]" in measured.text()
    value, error, unit, _ = measured.figures["backlash"]
    assert (value, error, unit) == (*measured["backlash"], "rad")
    with pytest.raises(ValueError, match="read its file again"):
        hdconj.load(scene, measured=pickle.loads(pickle.dumps(measured)))


def test_load_beside_a_file(tmp_path):
    """A file alone is read as the program reads it without options of the rig."""
    loop = "".join(f"{0.1 * t}, {t + (0.5 if rising else -0.5)}\n" for t, rising in cycle())
    (tmp_path / "loop.csv").write_text("torque [N m], angle [arcmin]\n" + loop)
    scene = hdconj.Scene().with_({"slices.count": 3})
    study = hdconj.load(scene, torque=10, curve=False, errors=False, measured=tmp_path / "loop.csv")
    words = ["load", "--set=slices.count=3", "--torque=10", "--no-curve", "--no-errors"]
    compare(study, [*words, f"--measured={tmp_path / 'loop.csv'}"], tmp_path)


def cycle():
    """Torques 0, 10, 0, -10, 0 and whether they rise."""
    way = [*range(0, 11), *range(9, -11, -1), *range(-9, 1)]
    return [(t, i <= 10 or i > 30) for i, t in enumerate(way)]


def test_inspect(solution, tmp_path):
    outline = solution.flexspline.outline[:: max(1, len(solution.flexspline.outline) // 60)]
    radius = solution.summary.r_m_mm + solution.summary.pitch_line_mm
    points = tmp_path / "points.csv"
    points.write_text("x [mm], y [mm]\n" + "".join(f"{x!r}, {y + radius!r}\n" for x, y in outline.tolist()))
    result = hdconj.inspect(None, points, register="datum")
    compare(result, ["inspect", points, "--register=datum"], tmp_path)


def test_wedm(tmp_path):
    scene = SOURCE / "data/scenes/type-50.toml"
    made = hdconj.wedm(scene, folder=tmp_path / "python", dialects=["csv"])
    run_program("wedm", scene, "--dialect=csv", "-o", tmp_path / "program")
    files = sorted(path.name for path in (tmp_path / "program").iterdir())
    assert files == sorted(path.name for path in (tmp_path / "python").iterdir())
    for name in files:
        if name.endswith(".csv"):
            assert (tmp_path / "program" / name).read_bytes() == (tmp_path / "python" / name).read_bytes()
    path = made["set_up_1/pass_1/lower"]
    assert path.shape == (made.set_up_1.pass_1.figures["blocks"].value + 1, 2)


def test_design(tmp_path):
    made = hdconj.design(ratio=100, diameter=50, name="mine")
    run_program("design", "--ratio=100", "--diameter=50", "-o", tmp_path / "mine.toml")
    assert (tmp_path / "mine.toml").read_text() == made.scene.to_toml()
    assert made.scene.check() == ()


def test_accuracy_has_the_layout_of_the_program(tmp_path):
    study = hdconj.accuracy(studies="motion-model", sample=0, quick=True, repeats=1)
    run_program("accuracy", "--study=motion-model", "--sample=0", "--quick", "--repeats=1", "-o", tmp_path / "records")
    stored = hdconj.read(tmp_path / "records/records.h5")
    assert set(stored.records) == set(study.records)
    assert list(stored.records.error) == list(study.records.error)
