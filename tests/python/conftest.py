# SPDX-License-Identifier: GPL-3.0-or-later
"""The program beside the package: what both are asked, and how their answers are compared."""

import os
import signal
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pytest

import hdconj

# What a script starts in the background ignores Ctrl-C, and so would all that the tests start.
signal.signal(signal.SIGINT, signal.default_int_handler)

PROGRAM = os.environ["HDCONJ_PROGRAM"]
SOURCE = Path(os.environ["HDCONJ_SOURCE"])
SCENES = sorted(set((SOURCE / "data/scenes").glob("*.toml")) - {SOURCE / "data/scenes/type-50-wanted.toml"})
# What differs from run to run: the clock, and the place of a file.
CHANGING = {"date", "seconds", "timing"}


def run_program(*words, status=0, **options):
    """Runs the program, which is expected to end with @p status."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, encoding="utf-8", errors="surrogateescape",
                          timeout=600, **options)  # a fault may quote what is no UTF-8
    assert done.returncode == status, done.stderr
    return done


def same_bits(group, stored, path=""):
    """Compares a group of Python's with one of a file: names, attributes, arrays and what they mean."""
    attrs = {name for name in stored.attrs} - CHANGING
    assert set(group.attrs) - CHANGING == attrs, path
    for name in attrs:
        written = stored.attrs[name]
        if isinstance(written, np.ndarray):
            assert list(written) == group.attrs[name], f"{path}@{name}"
        else:
            assert type(written)(group.attrs[name]) == written or written != written, f"{path}@{name}"
    dimensions = {
        name
        for name in stored
        if isinstance(stored[name], h5py.Dataset)
        and bytes(stored[name].attrs.get("NAME", b"")).startswith(b"This is a netCDF")
    }
    assert set(group) | set(group._parts.links) == set(stored) - dimensions, path
    for name in set(stored) - dimensions - CHANGING:
        if isinstance(stored[name], h5py.Group):
            same_bits(group.groups[name], stored[name], f"{path}/{name}")
            continue
        written, values = stored[name], group[name]
        if h5py.check_string_dtype(written.dtype):
            assert list(written.asstr()[...]) == list(values), f"{path}/{name}"
        else:
            assert written.dtype == values.dtype, f"{path}/{name}"
            assert written[...].shape == values.shape, f"{path}/{name}"
            assert written[...].tobytes() == values.tobytes(), f"{path}/{name}"
        if name in group.datasets:
            about = group.datasets[name]
            assert (written.attrs["units"], written.attrs["long_name"]) == (about.units, about.meaning)


def without_clock(summary):
    """A summary of JSON without times and names of files."""
    if isinstance(summary, dict):
        left_out = {"seconds", "time_s", "timing", "files"}
        return {name: without_clock(item) for name, item in summary.items() if name not in left_out}
    if isinstance(summary, list):
        return [without_clock(item) for item in summary]
    return summary


@pytest.fixture(scope="session")
def coned():
    """A study of few points, for what does not depend on them."""
    return hdconj.Scene.load(SOURCE / "data/scenes/type-50-coned.toml").with_(
        {"slices.count": 3, "contact.flank_points": 40}
    )


@pytest.fixture(scope="session")
def solution():
    return hdconj.solve()


@pytest.fixture(scope="session")
def scheduler():
    """Address of a scheduler with two workers, for studies that are not about workers: each takes a second to begin."""
    engine = pytest.importorskip("hdconj.study._engine").engine
    with engine(2) as client:
        yield client.scheduler.address
