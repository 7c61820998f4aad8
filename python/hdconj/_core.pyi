# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension module; not for use by itself."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

version: str
revision: str
build: str

_Observer = Callable[[str, float | None], None] | None
_RawFault = tuple[str, int, str, str, str, str, tuple[str, ...], str]

class Scene:
    @staticmethod
    def load(file: bytes) -> Scene: ...
    @staticmethod
    def parse(text: bytes, name: bytes, folder: bytes, overrides: list[bytes]) -> Scene: ...
    @property
    def faults(self) -> tuple[_RawFault, ...]: ...
    @property
    def text(self) -> str: ...
    @property
    def files(self) -> dict[str, tuple[str, bytes | None]]: ...
    @property
    def name(self) -> str: ...
    def check_json(self, name: str, verb: str) -> str: ...

class Result:
    def layout(self) -> tuple[Any, ...]: ...
    def figures(self) -> list[tuple[str, str, float, float | None, str]]: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    @property
    def missing(self) -> list[str]: ...
    @property
    def seconds(self) -> float: ...

class DesignWishes:
    ratio: float
    diameter: float | None
    module: float | None
    length_ratio: float
    torque: float | None
    family: str
    material: str
    land: float
    clearance: float
    safety: float
    name: str

def describe_key(path: str) -> tuple[str, str, str] | None: ...
def keep_elastic_bodies(count: int) -> None: ...
def elastic_body_count() -> tuple[int, int]: ...
def builtin_scene_text() -> str: ...
def write_atomically(target: str | os.PathLike[str], write: Callable[[Path], None]) -> None: ...
def solve(scene: Scene, advice: bool, observer: _Observer) -> Result: ...
def contact(
    scene: Scene,
    tilts_deg: list[float],
    surfaces: list[str],
    kinds: list[str],
    best_deg: tuple[float, float] | None,
    revolution: int,
    errors: bool,
    observer: _Observer,
) -> Result: ...
def load(
    scene: Scene,
    torque: float | None,
    points: int | None,
    tilts_deg: list[float],
    surfaces: list[str],
    kinds: list[str],
    curve: bool,
    errors: bool,
    measured: Result | None,
    observer: _Observer,
) -> Result: ...
def run(
    scene: Scene, torque: float | None, positions: int | None, errors: bool, observer: _Observer
) -> Result: ...
def find_neutral_curve(scene: Scene, observer: _Observer) -> Result: ...
def wedm(scene: Scene, folder: str, dialects: list[str], observer: _Observer) -> Result: ...
def accuracy(
    scene: Scene, studies: list[str], sample: int, repeats: int, quick: bool, observer: _Observer
) -> Result: ...
def inspect(
    scene: Scene,
    points: str,
    part: str,
    plane: float | None,
    probe: float,
    register: str,
    observer: _Observer,
) -> Result: ...
def is_result_file(file: str) -> bool: ...
def report(
    sources: list[Scene | tuple[str, Any]],
    file: str,
    parts: list[str],
    tilts_deg: list[float],
    revolution: int,
    curve: bool,
    observer: _Observer,
) -> list[str]: ...
def read_measured(
    scene: Scene,
    file: str,
    torque_constant: float | None,
    counts_per_turn: float | None,
    ratio: float | None,
    efficiency: float | None,
    output_member: str,
) -> Result: ...
def flexspline_poses(scene: Scene, z: list[float], pitches: float) -> list[float]: ...
def design(wishes: DesignWishes, observer: _Observer) -> tuple[str, Result]: ...
