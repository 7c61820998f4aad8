# SPDX-License-Identifier: GPL-3.0-or-later
"""How studies run: the same rows however they are cut, and nothing lost or twice whatever is killed.

HDCONJ_FULL in the environment: every kill twenty times.
"""

import contextlib
import json
import os
import random
import shutil
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import hdconj

study = pytest.importorskip("hdconj.study")
pytest.importorskip("distributed")
from hdconj.study import _drive, _engine, _shards, _store  # noqa: E402
from hdconj.study.__main__ import main  # noqa: E402

FULL = bool(os.environ.get("HDCONJ_FULL"))
KILLS = 20 if FULL else 1
TEXT = """
[set]
"solver.tolerance" = 1e-3
[vary]
"flexspline.wall" = { from = 0.6, to = 0.8 }
"wave_generator.radial_deformation" = { from = 0.05, to = 0.27 }
rise = { normal = [0.0, 0.002] }
"flexspline.profile.concave_rise" = "0.0671 + rise"
[sample]
count = COUNT
seed = 5
[compute]
verb = "solve"
[figures]
land = "solve.land_width"
depth = "solve.space_depth"
[constraints]
land = { min = 0.1 }
[objectives]
depth = "max"
"""


def recipe(count):
    return study.read_recipe(TEXT.replace("COUNT", str(count)))


def write(folder, count):
    file = folder / "study.toml"
    file.write_text(TEXT.replace("COUNT", str(count)))
    return file


def bits(folder):
    """All rows of a study as one checksum, and how many there are of each sample."""
    import pyarrow as pa

    table = pa.concat_tables([rows.replace_schema_metadata(None) for rows, _ in _shards.read_shards(folder / "rows")])
    numbers = table.column("sample").to_pylist()
    assert len(set(numbers)) == len(numbers)
    return _shards.digest(table), numbers


def command(*words):
    return [sys.executable, "-m", "hdconj.study", *map(str, words)]


def start(*words, **environment):
    return subprocess.Popen(
        command(*words), env={**os.environ, **environment}, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    )


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """The rows of 90 drives by one worker."""
    folder = tmp_path_factory.mktemp("one")
    told = study.run(recipe(90), folder, jobs=1, progress=False)
    assert told.done == 90 and 0 < told.failed < 90
    assert {"no-land"} <= set(study.open(folder).frame["code"])
    return bits(folder)


@contextlib.contextmanager
def cluster(workers, folder):
    """A scheduler and workers as processes of their own; gives the address and the processes."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": folder}
    address = f"tcp://127.0.0.1:{port}"
    scheduler = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", str(port),
                 "--no-dashboard"]  # fmt: skip
    worker = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--nthreads", "1", "--no-dashboard"]
    made = [subprocess.Popen(scheduler, **quiet), *(subprocess.Popen(worker, **quiet) for _ in range(workers))]
    try:
        yield address, made
    finally:
        for process in made:
            process.kill()
            process.wait()


@pytest.mark.parametrize("jobs", [2, 3] if FULL else [3])
def test_same_rows_for_every_number_of_workers(expected, tmp_path, jobs):
    study.run(recipe(90), tmp_path, jobs=jobs, shard_seconds=2, progress=False)
    assert bits(tmp_path) == expected


def test_same_rows_through_a_scheduler(expected, tmp_path):
    with cluster(2, tmp_path) as (address, _):
        study.run(recipe(90), tmp_path / "study", scheduler=address, progress=False)
    assert bits(tmp_path / "study") == expected


def test_more_drives_go_on_where_fewer_ended(expected, scheduler, tmp_path):
    study.run(recipe(40), tmp_path, scheduler=scheduler, progress=False)
    before = {file: file.stat().st_mtime_ns for file in (tmp_path / "rows").iterdir()}
    told = study.run(recipe(90), tmp_path, scheduler=scheduler, progress=False)
    assert told.done == 50
    assert bits(tmp_path) == expected
    assert all(file.stat().st_mtime_ns == when for file, when in before.items())


def children(of):
    """Worker processes below a process."""
    found = []
    for task in os.listdir("/proc"):
        if task.isdigit():
            try:
                parent = int(open(f"/proc/{task}/stat").read().rsplit(")", 1)[1].split()[1])
            except (OSError, IndexError):
                continue
            if parent == of:
                found += [int(task), *children(int(task))]
    return found


def dask_workers(of):
    """Worker processes of a run; some may have just ended."""
    found = []
    for task in children(of):
        with contextlib.suppress(OSError):
            if "spawn_main" in open(f"/proc/{task}/cmdline").read():
                found.append(task)
    return found


@pytest.fixture(scope="module")
def longer(scheduler, tmp_path_factory):
    """A study that lasts some seconds, and its rows."""
    folder = tmp_path_factory.mktemp("longer")
    study.run(recipe(400), folder, scheduler=scheduler, progress=False)
    return bits(folder)


def until(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "nothing happens"
        time.sleep(0.02)


@pytest.mark.parametrize("number", range(KILLS))
def test_a_killed_worker_loses_nothing(longer, tmp_path, number):
    file, folder = write(tmp_path, 400), tmp_path / "study"
    process = start("run", file, "-o", folder, "--jobs", 2, "--shard-seconds", 2, "--quiet")
    until(lambda: list(folder.glob("rows/*.parquet")) or process.poll() is not None)
    time.sleep(random.Random(number).uniform(0, 0.5))
    for worker in dask_workers(process.pid)[:1]:
        with contextlib.suppress(ProcessLookupError):
            os.kill(worker, signal.SIGKILL)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 0, said
    assert bits(folder) == longer


@pytest.mark.parametrize("number", range(KILLS))
def test_a_killed_driver_is_resumed(longer, scheduler, tmp_path, number):
    file, folder = write(tmp_path, 400), tmp_path / "study"
    process = start("run", file, "-o", folder, "--jobs", 2, "--shard-seconds", 2, "--quiet")
    until(lambda: list(folder.glob("rows/*.parquet")) or process.poll() is not None)
    time.sleep(random.Random(number).uniform(0, 0.5))
    process.kill()
    process.communicate()
    study.run(file, folder, scheduler=scheduler, progress=False)
    assert bits(folder) == longer


@pytest.mark.parametrize("number", range(KILLS))
def test_a_killed_scheduler_is_told_and_resumed(longer, scheduler, tmp_path, number):
    file, folder = write(tmp_path, 400), tmp_path / "study"
    with cluster(1, tmp_path) as (address, processes):
        process = start("run", file, "-o", folder, "--scheduler", address, "--shard-seconds", 2, "--quiet")
        until(lambda: list(folder.glob("rows/*.parquet")) or process.poll() is not None)
        time.sleep(random.Random(number).uniform(0, 0.5))
        processes[0].kill()
        _, said = process.communicate(timeout=120)
    assert process.returncode == 1 and "run again to resume" in said, said
    study.run(file, folder, scheduler=scheduler, progress=False)
    assert bits(folder) == longer


def test_workers_that_do_not_start_are_told(monkeypatch, tmp_path, capsys):
    import distributed

    def fails(**options):
        raise RuntimeError("Nanny failed to start.")

    monkeypatch.setattr(distributed, "LocalCluster", fails)
    assert main(["run", str(write(tmp_path, 5)), "-o", str(tmp_path / "study"), "--jobs", "1"]) == 1
    told = "the processes of this machine did not start (Nanny failed to start.); run again to resume"
    assert capsys.readouterr().err == f"hdconj study: {told}\n"


def test_a_script_needs_no_guard(tmp_path):
    """Workers do not run it."""
    write(tmp_path, 40)
    script = tmp_path / "script.py"
    script.write_text('import hdconj.study\nprint("ran")\nhdconj.study.run("study.toml", "out", jobs=2)\n')
    done = subprocess.run([sys.executable, script], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stdout, done.stderr) == (0, "ran\n", "")
    assert len(study.open(tmp_path / "out").frame) == 40


def test_a_scheduler_without_the_package_is_told(monkeypatch, tmp_path):
    with contextlib.ExitStack() as stack:
        with monkeypatch.context() as bare:
            bare.delenv("PYTHONPATH")
            address, _ = stack.enter_context(cluster(1, tmp_path))
        with pytest.raises(_engine.EngineLost, match=r"the same hdconj\[study\]"):
            study.run(recipe(5), tmp_path / "study", scheduler=address, progress=False)


@pytest.mark.parametrize("twice", [False, True])
def test_an_interrupt_of_a_terminal_stops_quietly(longer, scheduler, tmp_path, twice):
    """Ctrl-C reaches the whole group: workers leave it to the run that they belong to."""
    file, folder = write(tmp_path, 400), tmp_path / "study"
    process = subprocess.Popen(command("run", file, "-o", folder, "--jobs", "2", "--shard-seconds", "2"),
                               stderr=subprocess.PIPE, text=True, start_new_session=True)  # fmt: skip
    until(lambda: list(folder.glob("rows/*.parquet")) or process.poll() is not None)
    begin = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)
    if twice:
        time.sleep(0.1)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGINT)
    _, said = process.communicate(timeout=60)
    assert not said.replace("hdconj study: stopped; run again to resume\n", ""), said
    # One that comes while Python itself ends is Python's.
    assert process.returncode == 1 or (twice and process.returncode == -signal.SIGINT)
    assert not twice or time.monotonic() - begin < 3
    study.run(file, folder, scheduler=scheduler, progress=False)
    assert bits(folder) == longer


def test_a_drive_that_kills_its_worker_is_found(expected, tmp_path, monkeypatch):
    # every interpreter that starts from now on
    (tmp_path / "sitecustomize.py").write_text(
        "import os, signal\n"
        "from hdconj.study import _drive\n"
        "own = _drive.row_of\n"
        "def row_of(recipe, sample, errors):\n"
        "    if sample[0] == 37: os.kill(os.getpid(), signal.SIGKILL)\n"
        "    return own(recipe, sample, errors)\n"
        "_drive.row_of = row_of\n"
    )
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:{os.environ['PYTHONPATH']}")
    folder = tmp_path / "study"
    study.run(recipe(50), folder, jobs=2, shard_seconds=2, progress=False)
    frame = study.open(folder).frame
    assert list(frame["sample"]) == list(range(50))
    assert list(frame.loc[frame["code"] == "killed-worker", "sample"]) == [37]
    assert frame.loc[37, "cause"] == "signal 9" and np.isnan(frame.loc[37, "land"])
    assert frame.loc[37, "flexspline.wall"] == recipe(50).values(37)["flexspline.wall"]


@pytest.fixture(scope="module")
def whole(scheduler, tmp_path_factory):
    """The folder of a study of 90 drives, to be copied and harmed."""
    folder = tmp_path_factory.mktemp("whole")
    study.run(recipe(90), folder, scheduler=scheduler, shard_seconds=2, progress=False)
    return folder


@pytest.mark.parametrize("harm", ["truncate", "turn", "rename"])
def test_a_broken_shard_is_made_again(expected, whole, scheduler, tmp_path, harm):
    shutil.copytree(whole, tmp_path, dirs_exist_ok=True)
    shard = sorted((tmp_path / "rows").iterdir())[-1]
    content = shard.read_bytes()
    if harm == "truncate":
        shard.write_bytes(content[: len(content) // 2])
    elif harm == "turn":
        middle = content.index(b"PAR1") + 60
        shard.write_bytes(content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :])
    else:
        shard.rename(shard.with_name("rows-000000000-000000999.parquet"))
    told = study.run(recipe(90), tmp_path, scheduler=scheduler, progress=False)
    assert told.done > 0 and bits(tmp_path) == expected


def test_a_shard_of_another_study_is_made_again(expected, whole, scheduler, tmp_path):
    """Other values of the same columns, and other columns; a shard of a former version does not say whose it is."""
    import pyarrow.parquet as pq

    own, other = tmp_path / "own", tmp_path / "other"
    shutil.copytree(whole, own)
    study.run(
        study.read_recipe(TEXT.replace("COUNT", "90").replace("seed = 5", "seed = 6")), other, scheduler=scheduler,
        progress=False,
    )  # fmt: skip

    def replace_rows(change):
        for shard in (own / "rows").iterdir():
            shard.unlink()
        for shard in (other / "rows").iterdir():
            shutil.copy(shard, own / "rows")
            table, about = _shards.read_shard(shard)
            change(own / "rows" / shard.name, table, about)

    def rewritten(file, table, about):
        words = json.dumps(about | {"rows_sha256": _shards.digest(table)})
        pq.write_table(table.replace_schema_metadata({b"hdconj": words.encode()}), file)

    def former(file, table, about):
        rewritten(file, table, {word: value for word, value in about.items() if word not in _shards.IDENTITY})

    def without_depth(file, table, about):
        former(file, table.drop_columns(["depth"]), about)

    replace_rows(lambda *_: None)
    assert len(study.open(own).frame) == 0
    for change in (lambda *_: None, without_depth):
        replace_rows(change)
        assert study.run(recipe(90), own, scheduler=scheduler, progress=False).done == 90
        assert bits(own) == expected
    replace_rows(former)
    assert study.run(recipe(90), own, scheduler=scheduler, progress=False).done == 0


def test_two_runs_in_one_folder(tmp_path):
    file = write(tmp_path, 20)
    folder = _store.Folder(tmp_path / "study")
    with folder.locked():
        assert folder.is_running()
        second = subprocess.run(command("run", file, "-o", folder.place), capture_output=True, text=True)
    assert second.returncode == 2
    assert f"is in use by process {os.getpid()}" in second.stderr and "name another folder" in second.stderr
    assert not folder.is_running()


def test_another_study_in_the_folder_is_refused(scheduler, tmp_path):
    study.run(recipe(5), tmp_path, scheduler=scheduler, progress=False)
    with pytest.raises(hdconj.InputError, match="holds rows of another study"):
        study.run(study.read_recipe(TEXT.replace("COUNT", "5").replace("seed = 5", "seed = 6")), tmp_path, jobs=1)
    with pytest.raises(hdconj.InputError, match="is no folder of a study"):
        study.open(tmp_path / "rows")


ORDER = """
[vary]
{}
[sample]
method = "grid"
[figures]
{}
"""


@pytest.mark.parametrize(
    "keys, figures",
    [
        ("b = { list = [3, 4, 5] }\na = { list = [1, 2] }", 'f = "a + b"\ng = "a - b"'),
        ("a = { list = [1, 2] }\nb = { list = [3, 4, 5] }", 'g = "a - b"\nf = "a + b"'),
    ],
)
def test_another_order_of_keys_or_figures_is_another_study(scheduler, tmp_path, keys, figures):
    """Sample i is another drive where the keys stand in another order: rows of both would not make one grid."""
    first = ORDER.format("a = { list = [1, 2] }\nb = { list = [3, 4, 5] }", 'f = "a + b"\ng = "a - b"')
    study.run(study.read_recipe(first), tmp_path, scheduler=scheduler, progress=False)
    before = bits(tmp_path)
    with pytest.raises(hdconj.InputError, match="holds rows of another study"):
        study.run(study.read_recipe(ORDER.format(keys, figures)), tmp_path, jobs=1, progress=False)
    assert bits(tmp_path) == before


@pytest.mark.parametrize("room", [0, 7000])
def test_a_full_disk_is_told_and_resumed(expected, scheduler, tmp_path, room):
    file, folder = write(tmp_path, 90), tmp_path / "study"
    limited = f"import resource, sys; resource.setrlimit(resource.RLIMIT_FSIZE, ({room}, {room})); " + (
        "from hdconj.study.__main__ import main; sys.exit(main(sys.argv[1:]))"
    )
    failed = subprocess.run(
        [sys.executable, "-c", f"if __name__ == '__main__':\n    {limited}", "run", file, "-o", folder, "--jobs", "1"],
        capture_output=True, text=True, timeout=120,
    )  # fmt: skip
    assert failed.returncode == 1 and "cannot be written" in failed.stderr, failed.stderr
    assert "run again to resume" in failed.stderr
    assert str(folder) in failed.stderr
    assert not [file for file in folder.rglob(".*")]
    study.run(file, folder, scheduler=scheduler, progress=False)
    assert bits(folder) == expected


@pytest.mark.parametrize("line", ['sample.count = 2\nscene = "drive.toml"', '"scene" = "drive.toml"  # mine'])
def test_the_folder_has_a_study_wherever_its_scene_is_named(scheduler, tmp_path, line):
    (tmp_path / "drive.toml").write_text(hdconj.Scene().to_toml())
    file = tmp_path / "s.toml"
    file.write_text(f'{line}\nvary.a = {{ list = [1, 2] }}\n[figures]\nscene = "a"\n')
    study.run(file, tmp_path / "out", scheduler=scheduler, progress=False)
    assert "scene" in study.open(tmp_path / "out").frame


def test_the_folder_repeats_the_study(expected, scheduler, tmp_path):
    first, second = tmp_path / "first", tmp_path / "second"
    study.run(recipe(30), first, scheduler=scheduler, progress=False)
    study.run(first / "study.toml", second, scheduler=scheduler, progress=False)
    assert bits(first) == bits(second)
    about = json.loads((first / "study.json").read_text())
    assert about["program"].startswith(hdconj.__version__) and len(about["scene_sha256"]) == 64
    assert about["packages"]["numpy"] == np.__version__ and about["machine"]["cores"] > 0


FILES = """
scene = "scenes/drive.toml"
[set]
"solver.tolerance" = 1e-3
[vary]
"wave_generator.file" = { list = ["a/cam.csv", 'b/cam.csv', "nowhere.csv"] }
"flexspline.wall" = { from = 0.6, to = 0.8, count = 2 }
[sample]
method = "grid"
[figures]
depth = "solve.space_depth"
[objectives]
depth = "max"
"""


POINTS = "points-\U00020bb7.csv"


def write_with_files(folder):
    """A study whose scene reads its tooth from a file, and its cam from one of two files of the same name."""
    scenes, source = folder / "scenes", Path(os.environ["HDCONJ_SOURCE"], "data/scenes")
    for name, height in (("a", 0.25), ("b", 0.24)):
        (scenes / name).mkdir(parents=True)
        angles = np.linspace(0, 180, 37)
        rows = [f"{angle},{height * np.cos(2 * np.radians(angle)):.6f}" for angle in angles]
        (scenes / name / "cam.csv").write_text("\n".join(rows))
    shutil.copy(source / "points-flank.csv", folder / POINTS)
    text = (source / "points.toml").read_text().replace("points-flank.csv", f"../{POINTS}")
    cosine = 'family = "cosine"\nradial_deformation = 0.25'
    assert cosine in text
    (scenes / "drive.toml").write_text(text.replace(cosine, 'family = "table"\nfile = "a/cam.csv"'))
    (folder / "study.toml").write_text(FILES)
    return folder / "study.toml"


def test_the_folder_has_the_files_that_the_scene_names(scheduler, tmp_path):
    file, first = write_with_files(tmp_path), tmp_path / "first"
    said = r"line 6: vary.wave_generator.file = nowhere.csv: cannot be read \(name a CSV file, relative to the scene's"
    with pytest.raises(hdconj.InputError, match=said):
        study.check(file)
    file.write_text(FILES.replace(', "nowhere.csv"', ""))
    study.run(file, first, scheduler=scheduler, progress=False)
    found = study.open(first)
    assert list(found.frame["code"]) == 4 * [""]
    depth = list(found.frame["depth"])
    assert len(set(depth)) == 4  # every cam and every wall
    cams = found.frame["wave_generator.file"]
    assert list(cams) == 2 * ["a/cam.csv"] + 2 * ["b/cam.csv"]  # as the study names them, in all that is read
    assert found.to_xarray()["wave_generator.file"].values.tolist() == ["a/cam.csv", "b/cam.csv"]
    assert found.best(1)["wave_generator.file"][0] in set(cams)
    names = {each.name for each in (first / "files").iterdir()}
    assert len(names) == 3 and {"cam.csv", POINTS} < names
    assert study.run(file, first, scheduler=scheduler, progress=False).done == 0
    cam = tmp_path / "scenes/b/cam.csv"
    cam.write_text(cam.read_text().replace("0.24", "0.23"))
    with pytest.raises(hdconj.InputError, match="holds rows of another study"):
        study.run(file, first, scheduler=scheduler, progress=False)
    shutil.rmtree(tmp_path / "scenes")
    (tmp_path / POINTS).unlink()
    study.run(first / "study.toml", tmp_path / "second", scheduler=scheduler, progress=False)
    again = study.open(tmp_path / "second").frame
    assert found.frame.equals(again)
    assert [hdconj.solve(found.scene(i)).figures["space_depth"].value for i in range(4)] == depth
    best = tmp_path / "elsewhere" / "best.toml"
    best.parent.mkdir()
    said = subprocess.run(command("best", first, "--scene", best), capture_output=True, text=True, cwd=tmp_path)
    assert said.returncode == 0, said.stderr
    assert hdconj.solve(best).figures["space_depth"].value == max(depth)


NAMED = """
[set]
"solver.tolerance" = 1e-3
"flexspline.profile.file" = "tooth"
[vary]
"errors.profile_form" = { list = ["form.csv", "other/form.csv", "files/form.csv", "OTHER"] }
"drive.name" = { list = ["tooth", "form.csv"] }
[files]  # the study's own name
tooth = "TOOTH"
[sample]
method = "grid"
[figures]
depth = "solve.space_depth"
[scene]
SCENE
"""


def test_files_have_the_names_that_the_study_gives_them(scheduler, tmp_path):
    """Equal names in several folders, absolute ones, one of [files]; also where a copy would take the name of another.

    The words of a key that names no files are no names of files.
    """
    source = Path(os.environ["HDCONJ_SOURCE"], "data/scenes")
    scene = (source / "points.toml").read_text().replace("\n[", "\n[scene.").replace("points-flank.csv", "nowhere.csv")
    for place, rise in ((".", 1), ("other", 2), ("files", 3)):
        (tmp_path / place).mkdir(exist_ok=True)
        (tmp_path / place / "form.csv").write_text(f"height [mm],excess [um]\n-0.3,0\n-0.1,1\n0.1,{rise}\n0.3,0\n")
    text = NAMED.replace("TOOTH", str(source / "points-flank.csv")).replace("SCENE", scene)
    (tmp_path / "study.toml").write_text(text.replace("OTHER", str(tmp_path / "other/form.csv")))
    first, second = tmp_path / "first", tmp_path / "second"
    study.run(tmp_path / "study.toml", first, scheduler=scheduler, progress=False)
    assert len([*(first / "files").iterdir()]) == 4
    given = ["form.csv", "other/form.csv", "files/form.csv", str(tmp_path / "other/form.csv")]
    contents = [(tmp_path / name).read_bytes() for name in given]
    study.run(first / "study.toml", second, scheduler=scheduler, progress=False)
    assert bits(first) == bits(second)
    for place in (first, second):
        assert study.run(place / "study.toml", place, scheduler=scheduler, progress=False).done == 0
        found = study.open(place)
        assert list(found.frame["errors.profile_form"][::2]) == given
        assert list(found.frame["drive.name"]) == 4 * ["tooth", "form.csv"] and (found.frame["code"] == "").all()
        for sample, row in enumerate(found.frame.to_dict("records")):
            used = found.scene(sample)
            assert Path(used.folder, used.to_dict()["errors"]["profile_form"]).read_bytes() == contents[sample // 2]
            assert used.name == row["drive.name"]


TEETH = """
scene = "scenes/drive.toml"
[set]
"errors.profile_form" = "form.csv"
[vary]
"errors.flexspline.pitch" = { list = ["teeth.csv", 'b/teeth.csv'] }
[sample]
method = "grid"
[figures]
depth = "solve.space_depth"
[objectives]
depth = "max"
"""


def test_every_key_that_names_a_file_is_one_of_the_study(scheduler, tmp_path):
    """The scene's schema says which they are: here an error of the profile, and one of the teeth."""
    scenes, first = tmp_path / "scenes", tmp_path / "first"
    (scenes / "b").mkdir(parents=True)
    (scenes / "drive.toml").write_text(hdconj.Scene().to_toml())
    (scenes / "form.csv").write_text("height [mm],excess [um]\n-0.3,0\n-0.1,1\n0.1,2\n0.3,0\n")
    for name, place in (("teeth.csv", 1), ("b/teeth.csv", 2)):
        rows = (f"{tooth},{place if tooth == 1 else 0}" for tooth in range(1, 201))
        (scenes / name).write_text("\n".join(["tooth,place [um]", *rows]))
    file = tmp_path / "study.toml"
    file.write_text(TEETH.replace("b/teeth", "none"))
    with pytest.raises(hdconj.InputError) as refused:
        study.check(file)
    (fault,) = refused.value.faults
    assert fault.line == 6 and fault.reason.startswith("cannot be read") and "none.csv" in fault.reason
    file.write_text(TEETH)
    study.run(file, first, scheduler=scheduler, progress=False)
    found = study.open(first)
    assert list(found.frame["code"]) == ["", ""]
    assert len([*(first / "files").iterdir()]) == 3
    study.open(first).folder.write_scene(tmp_path / "best.toml", found.recipe, found.values(found.frame.iloc[1]))
    assert not hdconj.Scene.load(tmp_path / "best.toml").check()
    for changed in ("form.csv", "b/teeth.csv"):
        whole = (scenes / changed).read_text()
        (scenes / changed).write_text(whole.replace("1,2", "1,3"))
        with pytest.raises(hdconj.InputError, match="holds rows of another study"):
            study.run(file, first, scheduler=scheduler, progress=False)
        (scenes / changed).write_text(whole)
    shutil.rmtree(scenes)
    study.run(first / "study.toml", tmp_path / "second", scheduler=scheduler, progress=False)
    assert bits(first) == bits(tmp_path / "second")


def test_the_folder_has_the_measured_curve(scheduler, tmp_path):
    """It is found from where the study is, and decides the rows."""
    curve = np.vstack([[t / 28 * 0.1, t] for t in [*range(0, 29), *range(28, -29, -1), *range(-28, 1)]])
    (tmp_path / "rig.csv").write_text("angle [deg],torque [N m]\n" + "\n".join(f"{a},{t}" for a, t in curve))
    text = SHARED.replace("SCENE", str(Path(os.environ["HDCONJ_SOURCE"], "data/scenes/type-50-elastic.toml")))
    text = text.replace("count = 3", "count = 2").replace('["contact", "load"]', '"load"')
    text = text.replace('area = "contact.contact_area"', "")
    (tmp_path / "study.toml").write_text(text.replace("curve = false", 'curve = false, measured = "rig.csv"'))
    first = tmp_path / "first"
    study.run(tmp_path / "study.toml", first, scheduler=scheduler, progress=False)
    (tmp_path / "rig.csv").rename(tmp_path / "moved.csv")
    study.run(first / "study.toml", tmp_path / "second", scheduler=scheduler, progress=False)
    assert bits(first) == bits(tmp_path / "second")
    (tmp_path / "rig.csv").write_text((tmp_path / "moved.csv").read_text().replace("0.1,28", "0.2,28"))
    with pytest.raises(hdconj.InputError, match="holds rows of another study"):
        study.run(tmp_path / "study.toml", first, scheduler=scheduler, progress=False)


SHARED = """
scene = "SCENE"
[set]
"slices.count" = 3
"slices.surface" = "tilted"
"contact.flank_points" = 20
"solver.tolerance" = 1e-3
"circular_spline.backlash_offset" = "auto"
[vary]
"tilt.angle_deg" = { from = 0.0, to = 0.2, count = 3 }
[sample]
method = "grid"
[compute]
verb = ["contact", "load"]
load = { torque = 5, curve = false }
[figures]
area = "contact.contact_area"
twist = "load.twist"
stress = "load.largest_stress"
"""


def test_what_drives_share_is_computed_once():
    """Cup and bearing are the same for every tilt: their responses are computed for the first drive only."""
    scene = Path(os.environ["HDCONJ_SOURCE"], "data/scenes/type-50-elastic.toml")
    given = study.read_recipe(SHARED.replace("SCENE", str(scene)))
    samples = [(i, given.values(i)) for i in range(3)]

    def counted(compute):
        """Rows, and how many responses were computed and taken over for them."""
        before = hdconj._core.elastic_body_count()
        rows = compute()
        return rows, *np.subtract(hdconj._core.elastic_body_count(), before)

    alone, of_all, none = counted(lambda: [_drive.row_of(given, sample, True)[0] for sample in samples])
    try:
        first, of_first, _ = counted(lambda: _drive.rows_of(given, samples[:1], True)[0])
        others, of_others, reused = counted(lambda: _drive.rows_of(given, samples[1:], True)[0])
    finally:
        hdconj._core.keep_elastic_bodies(0)
    assert first + others == alone and all(row["code"] == "" for row in alone)
    assert none == 0 and 0 < of_first < of_all / 3 and of_others == 0 and reused > 0


def test_a_row_is_the_drive_alone(expected, scheduler, tmp_path):
    study.run(recipe(20), tmp_path, scheduler=scheduler, progress=False)
    found = study.open(tmp_path)
    row = found.frame[found.frame["code"] == ""].iloc[0]
    alone = hdconj.solve(found.scene(int(row["sample"])))
    assert alone.figures["land_width"].value == row["land"]
    assert alone.figures["space_depth"].error == row["depth_error"]


def test_the_program_finds_the_command(tmp_path):
    """hdconj study is hdconj-study beside the program or on the path."""
    program, command_file = tmp_path / "bin" / "hdconj", tmp_path / "hdconj-study"
    program.parent.mkdir()
    shutil.copy(os.environ["HDCONJ_PROGRAM"], program)
    command_file.write_text(f'#!/bin/sh\nexec {sys.executable} -m hdconj.study "$@"\n')
    command_file.chmod(0o755)
    bare = {**os.environ, "PATH": "/usr/bin:/bin"}

    def asked(environment):
        words = [program, "study", "check", write(tmp_path, 7)]
        return subprocess.run(words, capture_output=True, text=True, env=environment)

    missing = asked(bare)
    assert missing.returncode == 1 and "pip install 'hdconj[study]'" in missing.stderr
    on_path = asked({**bare, "PATH": f"{tmp_path}:{bare['PATH']}"})
    assert on_path.returncode == 0 and on_path.stdout.startswith("7 drives, 3 keys vary"), on_path.stderr
    command_file.rename(program.with_name("hdconj-study"))
    assert asked(bare).returncode == 0


def test_missing_packages_are_named():
    code = (
        "import sys\nsys.modules['pyarrow'] = None\n"
        "from hdconj.study.__main__ import main\nsys.exit(main(['status', 'x']))"
    )
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert said.returncode == 1 and said.stderr.startswith("hdconj study: the package pyarrow is missing; pip install")
