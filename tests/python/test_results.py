# SPDX-License-Identifier: GPL-3.0-or-later
"""Results as objects: figures, files, tables, pictures, pickles."""

import contextlib
import inspect
import os
import pickle
import re
import stat
import subprocess
import sys

import h5py
import numpy as np
import pytest
from conftest import SOURCE, run_program

import hdconj


@pytest.fixture(scope="module")
def study(coned):
    return hdconj.contact(coned, tilts_deg=[0, 0.1])


def same(first, second):
    assert set(first) == set(second) and first._parts.links == second._parts.links
    assert dict(first.attrs) == dict(second.attrs)
    for name in first.datasets:
        a, b = first.datasets[name], second.datasets[name]
        assert a[1:] == b[1:], name
        assert a.values.tolist() == b.values.tolist() or a.values.tobytes() == b.values.tobytes()
    for name in first.groups:
        same(first.groups[name], second.groups[name])


def test_figures_are_those_of_json(solution):
    geometry = solution.to_dict()["geometry"]
    figures = solution.figures
    for name in ("r_m", "r_0", "space_depth"):
        assert figures[name].value == geometry[f"{name}_mm"]
        assert figures[name].unit == "mm"
        assert figures[name].meaning
    assert figures["space_depth"].error > 0
    assert figures["ratio"].unit == "" and figures["ratio"].error is None


def test_figures_of_columns(study):
    area = study.figures["contact_area"]
    assert area.value is study.contact.contact_area
    assert (area.error >= 0).all() and area.unit == "mm^2"


def test_results_do_not_change(solution):
    with pytest.raises(AttributeError):
        solution.outline = 1
    with pytest.raises(TypeError):
        solution.attrs["drive"] = "other"
    with pytest.raises(KeyError):
        solution["circular_spline/nothing"]
    assert solution["circular_spline/z"] is solution.circular_spline.z


@pytest.mark.parametrize("which", ["solution", "study"])
def test_file_of_python_is_read_back_by_python_and_the_program(which, request, tmp_path):
    result = request.getfixturevalue(which)
    result.to_hdf5(tmp_path / "result.h5")
    again = hdconj.read(tmp_path / "result.h5")
    same(result, again)
    for name, figure in result.groups.get("contact", result.groups["summary"]).figures.items():
        if figure.error is not None and name in again.groups.get("contact", again.groups["summary"]).figures:
            other = again.groups.get("contact", again.groups["summary"]).figures[name]
            assert np.array_equal(other.value, figure.value) and np.array_equal(other.error, figure.error)


def test_files_show_each_figure_under_its_name_only(study, coned, tmp_path):
    """Former names are links to it, in files of the program too."""
    run_program("contact", SOURCE / "data/scenes/type-50-coned.toml", "--set=slices.count=3",
                "--set=contact.flank_points=40", "--tilt=0,0.1", "-o", tmp_path / "result.h5")  # fmt: skip
    stored = hdconj.read(tmp_path / "result.h5")
    assert set(stored.contact) == set(study.contact) and "share" not in set(stored.contact)
    assert stored.contact._parts.links == study.contact._parts.links
    assert stored["contact/share"] is stored.contact.contact_fraction
    assert "take_up" not in stored.contact.figures and "turn_to_contact" in stored.contact.figures
    with h5py.File(tmp_path / "result.h5") as file:
        assert "share" in file["contact"]


def test_former_names_are_those_of_the_pages():
    tables = []
    for page in ("json", "hdf5"):
        text = (SOURCE / f"docs/reference/{page}.md").read_text()
        tables += re.findall(r"^\|.*\| `(\w+)` \|$", text.split("## Former names")[1].split("\n## ")[0], re.M)
    assert set(tables) == hdconj._hdf5.FORMER


def test_the_program_cuts_what_python_wrote(tmp_path):
    scene = hdconj.Scene.load(SOURCE / "data/scenes/type-50.toml")
    hdconj.solve(scene).to_hdf5(tmp_path / "python.h5")
    run_program("solve", SOURCE / "data/scenes/type-50.toml", "-o", tmp_path / "program.h5")
    for name in ("python", "program"):
        run_program("wedm", "--from", tmp_path / f"{name}.h5", "--dialect=csv", "-o", tmp_path / name)
    for file in (tmp_path / "program").glob("*.csv"):
        assert file.read_bytes() == (tmp_path / "python" / file.name).read_bytes()


def test_a_file_that_cannot_be_written_is_not_begun(solution, tmp_path):
    for name in (tmp_path / "nowhere" / "result.h5", tmp_path, ""):
        with pytest.raises(hdconj.FileError, match=re.escape(str(name)) or "empty name") as refused:
            solution.to_hdf5(name)
        assert "tmp" not in str(refused.value).replace(str(tmp_path), "")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.geteuid() != 0, reason="only root makes devices")
def test_a_device_stays_a_device(solution, tmp_path):
    device = tmp_path / "node"
    os.mknod(device, 0o600 | stat.S_IFCHR, os.makedev(1, 3))
    solution.to_hdf5(device)
    assert device.is_char_device() and list(tmp_path.iterdir()) == [device]


def test_a_pipe_takes_the_whole_file(solution, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    with open(tmp_path / "copy.h5", "wb") as copy, subprocess.Popen(["cat", tmp_path / "pipe"], stdout=copy):
        solution.to_hdf5(tmp_path / "pipe")
    assert hdconj.read(tmp_path / "copy.h5").circular_spline.outline.size


def test_what_is_no_result_file_is_a_file_error(solution, tmp_path):
    solution.to_hdf5(tmp_path / "whole.h5")
    (tmp_path / "cut.h5").write_bytes((tmp_path / "whole.h5").read_bytes()[:5000])
    (tmp_path / "text.h5").write_text("no result")
    for name in ("cut.h5", "text.h5", "nowhere.h5", "."):
        with pytest.raises(hdconj.FileError, match=re.escape(str(tmp_path / name))):
            hdconj.read(tmp_path / name)


@pytest.mark.parametrize("part", ["xy", "circular_spline/point", "conjugate_zones/zone", "envelope/branch_000/u"])
def test_a_file_that_lacks_what_others_refer_to_is_a_file_error(part, solution, tmp_path):
    solution.to_hdf5(tmp_path / "result.h5")
    with h5py.File(tmp_path / "result.h5", "r+") as file:
        shape = file[part].shape
        del file[part]
    with pytest.raises(hdconj.FileError, match="result.h5: parts of it are missing"):
        hdconj.read(tmp_path / "result.h5")
    with pytest.raises(hdconj.InputError, match="parts of it are missing"):
        hdconj.report(tmp_path / "result.h5", tmp_path / "page.html")
    with h5py.File(tmp_path / "result.h5", "r+") as file:
        file[part] = np.zeros(shape)
    with contextlib.suppress(hdconj.FileError):  # HDF5 may put it where the former one was
        hdconj.read(tmp_path / "result.h5")


def test_a_result_is_no_scene(solution):
    for given in solution, solution.circular_spline:
        with pytest.raises(TypeError, match="write result.scene"):
            hdconj.contact(given)


def test_wrong_keys_of_a_result(solution):
    assert 3 not in solution
    with pytest.raises(KeyError):
        solution[3]
    with pytest.raises(KeyError, match="'nodim'; known: .*zone"):
        solution.conjugate_zones.to_pandas("nodim")


@pytest.mark.parametrize("which", ["solution", "study"])
def test_pickle(which, request):
    result = request.getfixturevalue(which)
    again = pickle.loads(pickle.dumps(result))
    assert type(again) is type(result)
    same(result, again)
    assert again.json() == result.json() and again.scene == result.scene
    assert set(again.figures) == set(result.figures)
    with pytest.raises(ValueError):
        again.circular_spline.z[0] = 1


def test_pickled_errors():
    with pytest.raises(hdconj.InputError) as refused:
        hdconj.solve(hdconj.Scene().with_({"drive.module": -1}))
    again = pickle.loads(pickle.dumps(refused.value))
    assert again.faults == refused.value.faults and str(again) == str(refused.value)


def test_xarray(study):
    pytest.importorskip("xarray")
    tree = study.to_xarray()
    gaps = tree["contact/map"].to_dataset()["gap"]
    assert gaps.dims == ("angle", "flank", "z", "flank_position")
    assert gaps.attrs["units"] == "mm"
    assert np.array_equal(gaps.sel(flank="left").values, study.contact.map.gap[:, 0])
    assert np.array_equal(gaps["z"], study.contact.map.z)


def test_pandas(study, solution):
    pytest.importorskip("pandas")
    table = study.to_pandas()
    assert len(table) == 2 and table.attrs["units"]["contact_area"] == "mm^2"
    assert list(table["contact_area"]) == list(study.contact.contact_area)
    zones = solution.to_pandas()
    for name in ("u", "phi", "t"):
        assert np.array_equal(zones[[f"{name}_begin", f"{name}_end"]], solution.conjugate_zones[name])
    assert zones.attrs["units"]["u_end"] == "rad"
    running = hdconj.run(torque=0)
    assert list(running.to_pandas()["error"]) == list(running.running.sequence_000.error)
    paths = hdconj.wedm()
    wire = paths.to_pandas()
    assert np.array_equal(wire[["upper_x", "upper_y"]], paths.set_up_1.pass_1.upper)
    assert wire.attrs["units"]["upper_x"] == "mm" and len(wire["tooth"]) == len(wire)
    designed = hdconj.design(100, diameter=50)
    assert list(designed.to_pandas()["name"]) == [row["name"] for row in designed.to_dict()["rows"]]
    with pytest.raises(KeyError, match="'nodim'; known: row"):
        designed.to_pandas("nodim")


@pytest.mark.parametrize("which", ["solution", "study"])
def test_plot(which, request):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    result = request.getfixturevalue(which)
    ax = result.plot()
    assert ax.get_lines() and ax.get_xlabel() and ax.get_title() == result.scene.name
    assert result.plot(ax=ax) is ax


def test_plot_of_a_neutral_curve_and_of_a_design(tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    found = hdconj.find_neutral_curve(SOURCE / "data/scenes/type-50-wanted.toml")
    assert len(found.plot().get_lines()) == 2
    with pytest.raises(hdconj.InputError, match="--completed DRIVE.toml"):
        found.report(tmp_path / "page.html")
    designed = hdconj.design(100, diameter=50)
    with pytest.raises(hdconj.InputError, match="Design has no drawing"):
        designed.plot()
    with pytest.raises(hdconj.InputError, match="Design has no result file"):
        designed.to_hdf5(tmp_path / "design.h5")
    assert not (tmp_path / "design.h5").exists()
    assert designed and designed.wall_seconds > 0


def test_a_designed_name_is_quoted_as_toml_wants_it():
    made = hdconj.design(100, diameter=50, name='a"b\\c')
    assert made.scene.check() == ()
    assert made.scene.name == 'a"b\\c'


def test_pages_of_a_notebook(solution):
    page = solution._repr_html_()
    assert "space_depth" in page and "&plusmn;" in page
    drawing = solution._repr_svg_()
    assert drawing.count("<polyline") == len(solution.circular_spline.z)


def test_every_function_is_documented_with_its_units():
    for name in hdconj.__all__:
        assert inspect.getdoc(getattr(hdconj, name)), name
    for name in ("solve", "contact", "load", "run", "wedm", "accuracy", "inspect", "read_measured", "design"):
        text = inspect.getdoc(getattr(hdconj, name))
        for argument in inspect.signature(getattr(hdconj, name)).parameters:
            assert argument in text, (name, argument)
        assert "Returns\n-------" in text


def test_types():
    pytest.importorskip("mypy")
    checked = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--cache-dir", os.devnull,
         "--config-file", SOURCE / "python/pyproject.toml", SOURCE / "python/hdconj"],
        capture_output=True,
        text=True,
    )
    assert checked.returncode == 0, checked.stdout


@pytest.mark.parametrize("first, second", [("h5py", "hdconj"), ("hdconj", "h5py")])
def test_no_second_hdf5(first, second, tmp_path):
    code = (
        f"import {first}, {second}\n"
        f"hdconj.solve().to_hdf5({str(tmp_path / 'a.h5')!r})\n"
        f"print(len(h5py.File({str(tmp_path / 'a.h5')!r})['neutral_curve']))\n"
        "print(sorted({line.split('/')[-1].strip() for line in open('/proc/self/maps') if 'libhdf5' in line\n"
        "              and 'libhdf5_hl' not in line}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    lines = done.stdout.splitlines()
    assert lines[0] == "720"
    assert lines[1].count("libhdf5") == 1
    linked = subprocess.run(["ldd", hdconj._core.__file__], capture_output=True, text=True, check=True)
    assert "hdf5" not in linked.stdout


IN_THE_CUP = ("coning_major", "coning_minor", "wave_generator_force", "largest_stress")


def test_what_was_not_estimated_has_no_error():
    """A load without errors leaves them out, as a contact does; the file keeps zeros and their mark."""
    scene = hdconj.Scene.load(SOURCE / "data/scenes/type-50-elastic.toml")
    small = {"slices.count": 3, "contact.flank_points": 20, "solver.tolerance": 1e-3}
    for errors in (True, False):
        result = hdconj.load(scene.with_(small), torque=5, curve=False, errors=errors)
        curve = result["load/case_000/curve"]
        columns = (result.figures["twist"], result.load.figures["twist"], curve.figures["twist"])
        for figure in (*columns, result.figures["backlash"], *(result.load.cup.figures[name] for name in IN_THE_CUP)):
            assert np.all(np.asarray(figure.error) > 0) if errors else figure.error is None
        assert list(result["load/error/estimated"]) == [errors] and (result["load/error/twist"][0] > 0) == errors
    whole = hdconj.contact(scene.with_({**small, "slices.count": 2}), errors=False)
    assert whole.figures["contact_area"].error is None
