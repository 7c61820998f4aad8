# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of `report`: of scenes, of result files, of results, and of both in one page."""

import json
from pathlib import Path

import h5py
import pytest
from conftest import SOURCE, run_program

import hdconj

SCENE = {"slices.count": 3, "circular_spline.width": 2.0}


def drives_of(page):
    text = Path(page).read_text()
    start = text.index('id="data">') + len('id="data">')
    return json.loads(text[start : text.index("</script>", start)])["drives"]


def test_result_files_and_scenes_in_one_page(tmp_path):
    contact = hdconj.contact(hdconj.Scene().with_(SCENE), tilts_deg=[0, 0.1])
    contact.to_hdf5(tmp_path / "contact.h5")
    missing = hdconj.report(
        [tmp_path / "contact.h5", str(SOURCE / "data/scenes/s-tooth.toml")], tmp_path / "both.html", parts="design"
    )
    read, computed = drives_of(tmp_path / "both.html")
    assert "contact.h5" in read["origin"]
    assert computed["origin"] == ""
    assert set(read["results"]) == {"solve", "contact"}
    assert read["teeth"] is not None
    assert computed["design"]["rows"]
    assert read["design"]["rows"]  # of the scene that the file holds
    assert missing == []


def test_a_result_reports_its_own_numbers(tmp_path):
    contact = hdconj.contact(hdconj.Scene().with_(SCENE), tilts_deg=[0, 0.1])
    contact.report(tmp_path / "own.html")
    (drive,) = drives_of(tmp_path / "own.html")
    groups = drive["results"]["contact"]["groups"]["contact"]["groups"]
    assert {"case_000", "case_001"} <= set(groups)  # both tilts that were asked for


TABLE = SOURCE / "data/scenes/cam-table.toml"


def test_a_result_holds_the_files_that_its_scene_names(tmp_path, monkeypatch):
    (tmp_path / "sub").mkdir()
    for ending, more in ((".toml", b""), (".csv", b"# \xb5\n")):  # not all is UTF-8
        (tmp_path / f"sub/cam-table{ending}").write_bytes(TABLE.with_suffix(ending).read_bytes() + more)
    monkeypatch.chdir(tmp_path)
    solution = hdconj.solve("sub/cam-table.toml")
    hdconj.report("sub/cam-table.toml", "computed.html")
    (tmp_path / "sub/cam-table.csv").unlink()
    solution.report("own.html")
    solution.to_hdf5("python.h5")
    hdconj.report("python.h5", "read.html")
    run_program("report", "python.h5", "-o", "program.html")
    (computed,) = drives_of("computed.html")
    for page in ("own.html", "read.html", "program.html"):
        (drive,) = drives_of(page)
        assert drive["teeth"] == computed["teeth"]
    assert hdconj.read("python.h5")["scene_files/name"].tolist() == ["cam-table.csv"]


def test_a_scene_of_dictionaries_has_a_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    scene = hdconj.Scene.load(TABLE)
    assert scene.check() == ()
    assert hdconj.Scene.from_dict(scene.to_dict(), folder=scene.folder).check() == ()
    assert "cannot be read" in hdconj.Scene.from_dict(scene.to_dict()).check()[0].reason


def test_a_drive_that_cannot_be_solved_leaves_the_others(tmp_path):
    tight = hdconj.Scene().with_({"circular_spline.backlash_offset": 0.065, "drive.name": "tight"})
    missing = hdconj.report([tight, None], tmp_path / "some.html")
    assert len(missing) == 1
    assert missing[0].startswith("tight: ")
    assert len(drives_of(tmp_path / "some.html")) == 1
    with pytest.raises(hdconj.NumericalError):
        hdconj.report([tight, tight], tmp_path / "none.html")
    assert not (tmp_path / "none.html").exists()


@pytest.mark.parametrize("option", [{"tilts_deg": 0.1}, {"revolution": 3}, {"curve": False}])
def test_options_that_change_a_scene_are_refused_for_results(tmp_path, option):
    (name,) = option
    with pytest.raises(hdconj.InputError, match=f"{name}.*only result files are given"):
        hdconj.report(hdconj.solve(), tmp_path / "page.html", parts=["contact", "load"], **option)
    assert not (tmp_path / "page.html").exists()


def test_a_cut_file_and_a_bad_scene_are_refused_together(tmp_path):
    hdconj.solve().to_hdf5(tmp_path / "whole.h5")
    whole = (tmp_path / "whole.h5").read_bytes()
    (tmp_path / "cut.h5").write_bytes(whole[: len(whole) // 2])
    bad = hdconj.Scene().with_({"drive.module": -1})
    with pytest.raises(hdconj.InputError) as caught:
        hdconj.report([tmp_path / "cut.h5", bad], tmp_path / "none.html")
    assert "cut.h5" in str(caught.value)
    assert "drive.module" in str(caught.value)
    assert not (tmp_path / "none.html").exists()


def test_a_damaged_file_is_refused_and_one_without_checksum_read(tmp_path):
    for name in ("python.h5", "program.h5"):
        file = tmp_path / name
        if name == "python.h5":
            hdconj.solve().to_hdf5(file)
        else:
            run_program("solve", "-q", "-o", file)
        whole = file.read_bytes()
        assert whole[-22:].startswith(b"hdconj crc32 ")
        points = hdconj.read(file).circular_spline.outline
        for at in (0, 9, 100, len(whole) // 2, len(whole) - 2):
            file.write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1 :])
            with pytest.raises(hdconj.FileError, match="damaged"):
                hdconj.read(file)
        file.write_bytes(whole[:-22])
        assert (hdconj.read(file).circular_spline.outline == points).all()


@pytest.mark.parametrize("missing", ["angle", "error", "error_error"])
def test_a_run_without_one_of_its_columns_is_shown_without_that_curve(tmp_path, missing):
    scene = hdconj.Scene().with_({"slices.count": 1, "contact.flank_points": 80})
    file, page = tmp_path / "run.h5", tmp_path / "run.html"
    hdconj.run(scene, torque=0, positions=4).to_hdf5(file)
    run_program("report", file, "-o", page)
    assert "Transmission error, unloaded" in page.read_text()
    with h5py.File(file, "r+") as stored:
        del stored["running/sequence_000"][missing]
    run_program("report", file, "-o", page)
    assert drives_of(page)[0]["results"].keys() == {"solve", "run"}
    drawn = page.read_text()
    assert ("Transmission error, unloaded" in drawn) == (missing == "error_error")
    assert 'class="band' not in drawn
