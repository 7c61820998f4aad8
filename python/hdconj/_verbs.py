# SPDX-License-Identifier: GPL-3.0-or-later
"""The verbs of the program as functions."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NoReturn, Optional, Union

from . import _core, _hdf5, _results
from ._arguments import checked, interval, number, numbers, word, words
from ._errors import Fault, FileError, InputError, fault_text
from ._scene import Scene, SceneLike, scene_of

Progress = Union[bool, Callable[[str, Optional[float]], None]]


@contextmanager
def _calling(progress: Progress) -> Iterator[Callable[[str, float | None], None] | None]:
    """The observer of a call."""
    if progress is True:
        try:
            from tqdm.auto import tqdm  # type: ignore[import-untyped]
        except ImportError:
            yield None
            return
        with tqdm(total=1.0, bar_format="{desc} {percentage:3.0f}%|{bar}| {elapsed}", leave=False) as bar:

            def show(what: str, share: float | None) -> None:
                bar.set_description(what, refresh=False)
                bar.n = bar.n if share is None else share
                bar.refresh()

            yield show
    else:
        yield progress or None


def _refuse(path: str, value: object, reason: str, remedy: str) -> NoReturn:
    faults = (Fault(path, 0, str(value), reason, remedy),)
    raise InputError(faults, fault_text(faults))


@checked
def solve(scene: SceneLike = None, *, advice: bool = True, progress: Progress = False) -> _results.Solution:
    """Solve for the circular spline that is conjugate to the flexspline's tooth.

    Parameters
    ----------
    scene : Scene, path, mapping or None
        The drive; None: the built-in one.
    advice : bool
        Try what the notes on flank contact and undercut advise, by solving changed drives. False: in words alone.
    progress : bool or callable
        True: a bar of tqdm where that is installed. A function is called with the stage that begins and None. What it
        throws ends the computation.

    Returns
    -------
    Solution
        Lengths in mm, angles in rad. The same bits for any number of threads, and as the program writes them.

    Raises
    ------
    InputError
        The scene has faults.
    NumericalError
        A stage failed.
    """
    asked = scene_of(scene)
    with _calling(progress) as observer:
        return _results.Solution._computed(_core.solve(asked._core, advice, observer), asked)


@checked
def find_neutral_curve(scene: SceneLike, *, progress: Progress = False) -> _results.NeutralCurve:
    """Find the neutral curve on which two given teeth touch.

    Parameters
    ----------
    scene : Scene, path or mapping
        A drive with both teeth and ``wave_generator.family = "wanted"``.
    progress : bool or callable
        As for :func:`solve`.

    Returns
    -------
    NeutralCurve
        Lengths in mm, angles in rad; every figure with its error.

    Raises
    ------
    NumericalError
        There is no such curve; the message says at which angle the flanks stop touching.
    """
    asked = scene_of(scene)
    with _calling(progress) as observer:
        return _results.NeutralCurve._computed(_core.find_neutral_curve(asked._core, observer), asked)


@checked
def contact(
    scene: SceneLike = None,
    *,
    tilts_deg: float | Sequence[float] = (),
    surfaces: str | Sequence[str] = (),
    kinds: str | Sequence[str] = (),
    best_deg: tuple[float, float] | None = None,
    revolution: int = 0,
    errors: bool = True,
    progress: Progress = False,
) -> _results.ContactStudy:
    """Compute contact area, clearance and backlash against tilt and surface.

    Parameters
    ----------
    scene : Scene, path, mapping or None
        The drive; None: the built-in one.
    tilts_deg : float or sequence of float
        Tilts in degrees; empty: the scene's.
    surfaces : str or sequence of str
        "tilted", "ruled", "per-slice"; empty: the scene's.
    kinds : str or sequence of str
        "radial", "draft"; empty: the scene's.
    best_deg : (float, float), optional
        Interval in degrees in which the best tilt is searched; None: no search.
    revolution : int
        Angles of the wave generator over a revolution, at most 10000; 0: the scene's only.
    errors : bool
        False: the same figures without their errors, in less time.
    progress : bool or callable
        As for :func:`solve`; the second argument is the share that is done, or None.

    Returns
    -------
    ContactStudy
    """
    asked = scene_of(scene)
    best = None if best_deg is None else interval("best_deg", best_deg)
    choices = (numbers("tilts_deg", tilts_deg), words("surfaces", surfaces), words("kinds", kinds))
    options = (*choices, best, revolution, errors)
    with _calling(progress) as observer:
        return _results.ContactStudy._computed(_core.contact(asked._core, *options, observer), asked)


@checked
def load(
    scene: SceneLike = None,
    *,
    torque: float | None = None,
    points: int | None = None,
    tilts_deg: float | Sequence[float] = (),
    surfaces: str | Sequence[str] = (),
    kinds: str | Sequence[str] = (),
    curve: bool = True,
    errors: bool = True,
    measured: str | os.PathLike[str] | _results.Measurement | None = None,
    progress: Progress = False,
) -> _results.LoadStudy:
    """Load the drive: torque-twist curve, stiffness, pressure and stress.

    Parameters
    ----------
    scene : Scene, path, mapping or None
        The drive; None: the built-in one.
    torque : float, optional
        Largest torque on the circular spline in N m, above 0; None: the scene's.
    points : int, optional
        Even torques from 0 to the largest, at most 1000; None: as many as the stiffness needs. Of a curve only.
    tilts_deg, surfaces, kinds
        As for :func:`contact`.
    curve : bool
        False: the largest torque only.
    errors : bool
        False: one grid alone; the same figures without their errors, in less time.
    measured : path or Measurement, optional
        Torque-angle curve of a test rig, to compare with. A file is read as :func:`read_measured`
        does without further arguments: the cup turns at the output.
    progress : bool or callable
        As for :func:`contact`.

    Returns
    -------
    LoadStudy
        Torques in N mm, twists in rad, stresses in MPa.
    """
    asked = scene_of(scene)
    if points is not None and not curve:
        _refuse("points", points, "curve=False leaves no curve that could have points", "leave one of them out")
    if measured is not None and not isinstance(measured, _results.Measurement):
        measured = _read_measured(measured, asked)
    seen = measured._kept() if measured is not None else None
    choices = (numbers("tilts_deg", tilts_deg), words("surfaces", surfaces), words("kinds", kinds))
    options = (torque, points, *choices, curve, errors, seen)
    with _calling(progress) as observer:
        return _results.LoadStudy._computed(_core.load(asked._core, *options, observer), asked)


@checked
def run(
    scene: SceneLike = None,
    *,
    torque: float | None = None,
    positions: int | None = None,
    errors: bool = True,
    progress: Progress = False,
) -> _results.RunStudy:
    """Run the drive: transmission error, torque on the wave generator, friction and efficiency.

    Parameters
    ----------
    scene : Scene, path, mapping or None
        The drive; None: the built-in one. Its table ``[running]`` says which member turns, its table
        ``[friction]`` what it loses.
    torque : float, optional
        Largest torque on the output in N m; 0: first contact only, in the shape that the scene
        prescribes. None: ``load.torque``, which is a torque on the circular spline.
    positions : int, optional
        Of the wave generator over one tooth pitch; None: the scene's, or 16.
    errors : bool
        False: one grid alone; the same figures without their errors, in less time.
    progress : bool or callable
        As for :func:`contact`.

    Returns
    -------
    RunStudy
        Transmission errors in rad, torques in N mm, speeds in rad/s.
    """
    asked = scene_of(scene)
    with _calling(progress) as observer:
        return _results.RunStudy._computed(_core.run(asked._core, torque, positions, errors, observer), asked)


@checked
def wedm(
    scene: SceneLike = None,
    *,
    folder: str | os.PathLike[str] = "",
    dialects: str | Sequence[str] = (),
    progress: Progress = False,
) -> _results.WireProgram:
    """Make the paths for cutting by wire.

    Parameters
    ----------
    scene : Scene, path, mapping or None
        The drive, with a table ``[wedm]``.
    folder : path
        Where the files of the machines are written, whole or not at all; empty: nowhere.
    dialects : str or sequence of str
        Of the files; empty: the scene's, or all that fit.
    progress : bool or callable
        As for :func:`solve`.

    Returns
    -------
    WireProgram
        Coordinates in mm of the wire's centre in the lower and the upper face.
    """
    asked = scene_of(scene)
    with _calling(progress) as observer:
        made = _core.wedm(asked._core, os.fspath(folder), words("dialects", dialects), observer)
    return _results.WireProgram._computed(made, asked)


@checked
def accuracy(
    scene: SceneLike = None,
    *,
    studies: str | Sequence[str] = (),
    sample: int = 64,
    repeats: int = 5,
    quick: bool = False,
    progress: Progress = False,
) -> _results.Accuracy:
    """Measure what accuracy costs in time.

    Parameters
    ----------
    scene : Scene, path, mapping or None
        The drive; None: the built-in one.
    studies : str or sequence of str
        Names as ``hdconj accuracy --help`` lists them; empty: all.
    sample : int
        Random designs around the scene, 0 to 1000.
    repeats : int
        Runs of each setting, 1 to 1000.
    quick : bool
        Short series, one run of each setting.
    progress : bool or callable
        As for :func:`contact`.

    Returns
    -------
    Accuracy
        Errors in mm, times in s.
    """
    asked = scene_of(scene)
    with _calling(progress) as observer:
        made = _core.accuracy(asked._core, words("studies", studies), sample, repeats, quick, observer)
    return _results.Accuracy._computed(made, asked)


@checked
def inspect(
    scene: SceneLike,
    points: str | os.PathLike[str],
    *,
    part: str = "flexspline",
    plane: float | None = None,
    probe: float = 0,
    register: str = "least-squares",
    progress: Progress = False,
) -> _results.Inspection:
    """Compare measured points with the nominal outline.

    Parameters
    ----------
    scene : Scene, path, mapping or None
        The drive; None: the built-in one.
    points : path
        CSV or DXF file of points in mm.
    part : str
        "flexspline" or "circular-spline".
    plane : float, optional
        Height in mm; None: all planes of the file.
    probe : float
        Radius in mm of the ball whose centres are given; negative: inside the material.
    register : str
        "datum", "turn", "least-squares" or "minimum-zone".
    progress : bool or callable
        As for :func:`solve`.

    Returns
    -------
    Inspection
        Deviations in mm, positive outside the material.
    """
    asked = scene_of(scene)
    with _calling(progress) as observer:
        made = _core.inspect(asked._core, os.fspath(points), part, plane, probe, register, observer)
    return _results.Inspection._computed(made, asked)


@checked
def read_measured(
    file: str | os.PathLike[str],
    scene: SceneLike = None,
    *,
    torque_constant: float | None = None,
    counts_per_turn: float | None = None,
    ratio: float | None = None,
    efficiency: float | None = None,
    output_member: str = "cup",
) -> _results.Measurement:
    """Read a torque-angle curve of a test rig; evaluate its backlash and stiffness.

    Parameters
    ----------
    file : path
        CSV; its columns are described in docs/how-to/measured-curve.md.
    scene : Scene, path, mapping or None
        Whose ratio is used where none is given.
    torque_constant : float, optional
        Of the rig's motor in N m/A.
    counts_per_turn : float, optional
        Of the encoder on the motor.
    ratio : float, optional
        Motor turns per turn of the output.
    efficiency : float, optional
        Between motor and output, 0 to 1.
    output_member : str
        Member that turns at the rig's output: "cup" or "circular-spline".

    Returns
    -------
    Measurement
        Torques in N mm, angles in rad, at the output.
    """
    return _read_measured(file, scene_of(scene), (torque_constant, counts_per_turn, ratio, efficiency, output_member))


def _read_measured(
    file: str | os.PathLike[str], asked: Scene, rig: tuple[Any, ...] = (None, None, None, None, "cup")
) -> _results.Measurement:
    return _results.Measurement._computed(_core.read_measured(asked._core, os.fspath(file), *rig), asked)


@checked
def report(
    scenes: SceneLike | _results.Result | Sequence[SceneLike | _results.Result],
    file: str | os.PathLike[str],
    *,
    parts: str | Sequence[str] = (),
    tilts_deg: float | Sequence[float] = (),
    revolution: int = 0,
    curve: bool = True,
    progress: Progress = False,
) -> list[str]:
    """Write one HTML page of a drive, or of several that it compares.

    Parameters
    ----------
    scenes : Scene, path, mapping, result, None, or a list of these
        The drives; None: the built-in one. In place of a scene also a result of :func:`solve`, :func:`contact`,
        :func:`load` or :func:`run`, or the path of its file. It is shown as it is: of its scene only the motion of the
        teeth is computed.
    file : path
        The page, NAME.html. It opens from disk and needs no network.
    parts : str or sequence of str
        What is computed of a scene beside the circular spline: "contact", "load", "run", "wedm", "design".
    tilts_deg : float or sequence of float
        Tilts of contact in degrees; empty: the scene's.
    revolution : int
        Angles of the wave generator at which contact is computed, at most 10000; 0: the scene's only.
    curve : bool
        False: load at the largest torque only.
    progress : bool or callable
        As for :func:`contact`.

    Returns
    -------
    list of str
        Parts that were asked for and have no result, each with its cause.
    """
    page = os.fsdecode(file)
    if os.path.splitext(page)[1].lower() != ".html":
        _refuse("file", page, "a browser knows the file by its ending .html", "write NAME.html")

    def source_of(given: Any) -> Any:
        if isinstance(given, _results.Result):
            return f"a result of {given.scene.name}", given
        if isinstance(given, (str, os.PathLike)) and _core.is_result_file(name := os.fspath(given)):
            try:
                return name, _hdf5.read(name)
            except FileError as error:
                return name, str(error)  # a fault among those of the others
        return scene_of(given)._core

    listed: list[Any] = list(scenes) if isinstance(scenes, (list, tuple)) else [scenes]
    asked = [source_of(each) for each in listed]
    options = (words("parts", parts), numbers("tilts_deg", tilts_deg), revolution, curve)
    with _calling(progress) as observer:
        return _core.report(asked, page, *options, observer)


@checked
def design(ratio: float, *, progress: Progress = False, **wishes: Any) -> _results.Design:
    """Design a whole drive from a few wishes.

    Parameters
    ----------
    ratio : float
        i = z_f/(z_c - z_f), circular spline held.
    progress : bool or callable
        As for :func:`solve`.
    **wishes
        diameter [mm], module [mm], length_ratio, torque [N m], family, material, fatigue [MPa], youngs_modulus [MPa],
        poissons_ratio, land [modules], clearance [mm], safety, name; as the options of ``hdconj design``.

    Returns
    -------
    Design
        Its drive is :attr:`Design.scene`.
    """
    asked = _core.DesignWishes()
    for name, value in {"ratio": ratio, **wishes}.items():
        if name.startswith("_") or not hasattr(asked, name):
            raise TypeError(f"design() knows no wish {name!r}")
        is_text = isinstance(getattr(asked, name), str)
        setattr(asked, name, word(name, value) if is_text else number(name, value))
    with _calling(progress) as observer:
        text, made = _core.design(asked, observer)
    return _results.Design._computed(made, Scene.from_toml(text, "the designed scene"))
