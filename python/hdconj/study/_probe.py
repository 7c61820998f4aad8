# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scene's schema and the verbs say of the values that a study gives to keys and options."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

from .._errors import Fault, NumericalError
from .._scene import Scene
from ._expression import Expression
from ._faults import near, written
from ._keys import Key, Value
from ._options import KEYS, judged, single
from ._recipe import Recipe, flat
from ._tables import Reader


def ask_names(reader: Reader, links: Mapping[str, Expression], known: Mapping[str, Any]) -> None:
    """Whether links find their names; keys that are refused themselves are not proposed."""
    wrong = {fault.path.removeprefix("vary.").removeprefix("scene ") for fault in reader.faults}
    proposed = [name for name in (*known, *links) if name not in wrong]
    for path, link in links.items():
        for name in link.names:
            if name not in known and name not in links:
                reader.told(f"vary.{path}", f"unknown name {name}", near(name, proposed), link.text)
            elif name not in links and not isinstance(known[name], (int, float)):
                reader.told(f"vary.{path}", f"{name} is no number", "links compute with numbers", link.text)


def probe(reader: Reader, scene: Scene, recipe: Recipe) -> None:
    """What the scene's schema says of the base scene and of the ends of all that varies."""
    own = set(scene.check())
    for fault in own:
        given = reader.tables.get("scene")  # its lines are not those of the study
        place = f"line {fault.line} of {given}: " if fault.line and isinstance(given, str) else "scene "
        line = reader.lines.get(f"set.{fault.path}", reader.lines.get(f"scene.{fault.path}", 0))
        reader.faults.append(fault._replace(path=place + fault.path, line=line))
    for key in recipe.keys:
        for value in key.probes:
            values = {**recipe.first, key.path: value}
            with suppress(NumericalError):  # a link without a value is a row of its own
                values = recipe.linked(values)
            for fault in recipe.scene_of(values).check():
                if fault not in own:
                    _schema_fault(reader, fault, key, values, recipe)


def ask_verbs(reader: Reader, recipe: Recipe) -> None:
    """What the verbs say of the values of their options, of the built-in drive where the scene has faults."""
    try:
        scene = Scene() if recipe.scene.check() else recipe.scene_of(recipe.linked(recipe.first))
    except NumericalError:
        return
    for verb, options in recipe.verbs:
        for fault in judged(verb, options, scene) if options else ():
            is_given = fault.path in options
            place = f"compute.{verb}.{fault.path}" if is_given else f"compute.{verb}"
            reason = fault.reason if is_given else f"{fault.path}: {fault.reason}"
            reader.told(place, reason, fault.remedy, fault.value)


def refuse_overridden(reader: Reader, recipe: Recipe) -> None:
    """An option that stands in place of a key leaves the key's value, which the rows show, without effect."""
    given = dict.fromkeys(recipe.varied, "vary")
    given |= {path: "set" for path in flat(reader.table("set"))}
    for verb, options in recipe.verbs:
        for option, key in KEYS.items():
            if key in given and single(options.get(option)) is not None:
                reason = f"stands in place of {key}, which stands under [{given[key]}] too"
                reader.told(f"compute.{verb}.{option}", reason, "remove one of them", options[option])


def settled(recipe: Recipe) -> Recipe:
    """The recipe whose scene has the values of options that stand in place of its keys: its scenes say them then.

    They stay options where the verbs differ in them, and where the scene is not sound with that key alone.
    """
    scene, verbs = recipe.scene, [(verb, dict(options)) for verb, options in recipe.verbs]
    for option, key in KEYS.items():
        takes_it = [options for verb, options in verbs if verb == "load" or not key.startswith("load.")]
        value, *others = [single(options.get(option)) for options in takes_it] or [None]
        changed = scene if value is None else scene.with_({key: value})
        if value is not None and all(other == value for other in others) and set(changed.check()) <= set(scene.check()):
            scene = changed
            for options in takes_it:
                del options[option]
    return replace(recipe, scene=scene, verbs=tuple(verbs))


def _schema_fault(reader: Reader, fault: Fault, key: Key, values: Mapping[str, Value], recipe: Recipe) -> None:
    """Takes over a fault that holds whatever the other keys are; others are drives that cannot be made."""
    of_key = fault.path == key.path or (fault.kind == "unknown" and key.path.startswith(f"{fault.path}."))
    if fault.kind == "other" or not (of_key or fault.path in recipe.varied):
        return
    value = values[key.path]
    whole = of_key and isinstance(value, float) and value.is_integer()
    if whole and _takes(recipe.scene_of({key.path: int(value)}), key.path):
        fault = fault._replace(reason="takes whole numbers only", remedy="write a whole number: add step = 1")
    link = dict(recipe.links).get(fault.path)
    linked = values.get(fault.path)
    if link and isinstance(linked, float) and _takes(recipe.scene_of({fault.path: round(linked)}), fault.path):
        remedy = f"write round({link.text})"
        fault = fault._replace(reason="takes whole numbers only", remedy=remedy, value=written(linked))
    place = f"vary.{key.path if of_key else fault.path}"
    if not any(known.path == place and known.reason == fault.reason for known in reader.faults):
        reader.told(place, fault.reason, fault.remedy, value if of_key else fault.value)


def _takes(scene: Scene, path: str) -> bool:
    """Whether the scene's value of that key is one that the key takes in some scene."""
    return all(fault.path != path or fault.kind == "other" for fault in scene.check())
