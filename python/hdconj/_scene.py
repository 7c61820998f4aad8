# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes: what is to be computed."""

from __future__ import annotations

import json
import os
import re
import tomllib
from collections.abc import Mapping, Sequence
from numbers import Integral, Real
from pathlib import Path
from typing import Any, Union

import numpy as np

from . import _core
from ._arguments import as_changes
from ._errors import Fault, InputError, fault_text
from ._tree import Group

Value = Union[
    bool, int, float, Real, np.generic, str, "os.PathLike[str]",
    Sequence[Any], "np.ndarray[Any, Any]", Mapping[str, Any], None,
]  # fmt: skip


def quoted(text: str) -> str:
    """Text as TOML quotes it: as JSON does, but no pair of surrogates stands for a character, and DEL is escaped."""
    return re.sub(r"[\x7f\ud800-\udfff]", lambda match: f"\\u{ord(match[0]):04x}", json.dumps(text, ensure_ascii=False))


def toml_value(value: Value) -> str:
    """A value as TOML writes it."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        return quoted(os.fsdecode(value))
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{quoted(str(key))} = {toml_value(item)}" for key, item in value.items()) + "}"
    if isinstance(value, np.ndarray):
        return toml_value(value.tolist())
    if isinstance(value, Sequence):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    return repr(value)


def toml_text(tables: Mapping[str, Any], path: tuple[str, ...] = ()) -> str:
    """Nested dictionaries as the tables of TOML."""
    for key in tables:
        if not isinstance(key, str):
            raise TypeError(f"the key {key!r} of a scene is no text: write the name of a table or of a key")
    own = {key: item for key, item in tables.items() if not isinstance(item, Mapping)}
    text = f"[{'.'.join(path)}]\n" if path and (own or not tables) else ""
    text += "".join(f"{key} = {toml_value(item)}\n" for key, item in own.items() if item is not None)
    for key, item in tables.items():
        if isinstance(item, Mapping):
            text += toml_text(item, (*path, key))
    return text


def _require(is_right: bool, function: str, expected: str, given: object) -> None:
    if not is_right:
        raise TypeError(f"{function}() takes {expected}, not {type(given).__name__}")


def _bytes(text: str) -> bytes:
    return text.encode("utf-8", "surrogateescape")


class Scene:
    """A drive and what is asked of it: immutable, sound or not.

    A scene with faults exists, so that :meth:`check` can name all of them. Every verb refuses it with
    :class:`InputError`. Keys, units and limits are those of docs/reference/scene.md.
    """

    __slots__ = ("_core", "_source", "_overrides", "_is_unread")
    _core: _core.Scene
    _source: tuple[str, str, str]  # text, name, folder
    _overrides: tuple[str, ...]
    _is_unread: bool  # its file could not be read

    def __init__(self) -> None:
        """The built-in scene: the type-50 drive of the thesis."""
        self._read((_core.builtin_scene_text(), "the built-in scene", ""), ())

    def _read(self, source: tuple[str, str, str], overrides: tuple[str, ...]) -> None:
        text, name, folder = map(_bytes, source)
        object.__setattr__(self, "_core", _core.Scene.parse(text, name, folder, [_bytes(each) for each in overrides]))
        object.__setattr__(self, "_source", source)
        object.__setattr__(self, "_overrides", overrides)
        object.__setattr__(self, "_is_unread", False)

    @classmethod
    def _of(cls, source: tuple[str, str, str], overrides: tuple[str, ...] = ()) -> Scene:
        scene = cls.__new__(cls)
        scene._read(source, overrides)
        return scene

    @classmethod
    def load(cls, file: str | os.PathLike[str]) -> Scene:
        """Read a scene file in TOML.

        Parameters
        ----------
        file : path
            File names in it are relative to its folder.
        """
        read = _core.Scene.load(os.fsencode(file))
        name = os.fsdecode(file)
        scene = cls._of((read.text, name, str(Path(name).parent)))
        object.__setattr__(scene, "_is_unread", read.faults != scene._core.faults)
        object.__setattr__(scene, "_core", read)  # with the faults of the file itself
        return scene

    @classmethod
    def from_toml(cls, text: str, name: str = "text", folder: str | os.PathLike[str] = "") -> Scene:
        """Read a scene from text.

        Parameters
        ----------
        text : str
            TOML.
        name : str
            How messages call it.
        folder : path
            Where relative file names start; empty: the working directory.
        """
        _require(isinstance(text, str), "from_toml", "text", text)
        return cls._of((text, name, os.fspath(folder)))

    @classmethod
    def from_dict(
        cls, tables: Mapping[str, Any], name: str = "dictionary", folder: str | os.PathLike[str] = ""
    ) -> Scene:
        """Read a scene from nested dictionaries, the tables of TOML.

        Parameters
        ----------
        tables : mapping
            A key with None is left out.
        name : str
            How messages call it.
        folder : path
            Where relative file names start, such as :attr:`folder` of the scene that a dictionary is of; empty: the
            working directory.
        """
        _require(isinstance(tables, Mapping), "from_dict", 'a mapping such as {"drive": {"module": 0.25}}', tables)
        return cls.from_toml(toml_text(tables), name, folder)

    def with_(self, changes: Mapping[str, Value]) -> Scene:
        """The same scene with some keys changed, as ``--set`` of the program does.

        Parameters
        ----------
        changes : mapping
            From paths such as ``"flexspline.wall"`` to values, also of NumPy; None removes a key or a table.
        """
        _require(isinstance(changes, Mapping), "with_", 'a mapping such as {"flexspline.wall": 0.6}', changes)
        for key in changes:
            if not isinstance(key, str) or "=" in key:
                raise TypeError(f'with_() takes paths of keys such as "flexspline.wall", not {key!r}')
        if self._is_unread:
            return self
        more = tuple(f"!{key}" if value is None else f"{key}={toml_value(value)}" for key, value in changes.items())
        return self._of(self._source, self._overrides + more)

    def check(self) -> tuple[Fault, ...]:
        """Every fault, in order of place; empty where the scene can be computed."""
        faults = (Fault(*fault) for fault in self._core.faults)
        return tuple(fault._replace(remedy=as_changes(fault.remedy)) for fault in faults)

    def plan(self, verb: str = "solve") -> dict[str, Any]:
        """Stages that "solve", "contact", "load" or "run" would run and why, as ``hdconj check --json``."""
        plan: dict[str, Any] = json.loads(self._core.check_json(self._source[1], verb))
        return plan

    def to_toml(self) -> str:
        """The scene as text, changes included; without the byte order mark that its file may begin with."""
        return self._core.text.removeprefix("\ufeff")

    def to_dict(self) -> dict[str, Any]:
        """The scene as nested dictionaries, changes included; relative file names start at :attr:`folder`.

        Raises
        ------
        InputError
            The text is no TOML.
        """
        try:
            return tomllib.loads(self.to_toml())
        except tomllib.TOMLDecodeError:
            raise InputError(self.check(), fault_text(self.check())) from None

    @property
    def name(self) -> str:
        """Name of the drive."""
        return self._core.name

    @property
    def folder(self) -> str:
        """Where relative file names start; empty: the working directory."""
        return self._source[2]

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a scene does not change; with_() makes another")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[str, str]:
        return self.to_toml(), self._source[2]

    def __reduce__(self) -> tuple[Any, ...]:
        return Scene._of, (self._source, self._overrides)

    def __repr__(self) -> str:
        faults = len(self._core.faults)
        return f"<hdconj.Scene {self.name!r}{f', {faults} faults' if faults else ''}>"


SceneLike = Union[Scene, str, "os.PathLike[str]", Mapping[str, Any], None]


def scene_of(given: SceneLike) -> Scene:
    """The scene that an argument means: a scene, the name of a file, dictionaries, or None for the built-in one."""
    if given is None:
        return Scene()
    if isinstance(given, Scene):
        return given
    if isinstance(given, Group):
        raise TypeError(f"{given!r} is a result or a part of one: write result.scene")
    if isinstance(given, Mapping):
        return Scene.from_dict(given)
    return Scene.load(given)
