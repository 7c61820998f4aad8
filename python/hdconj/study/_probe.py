# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scene's schema and the verbs say of the values that a study gives to keys and options."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from difflib import get_close_matches
from typing import Any

from .._errors import Fault, InputError, NumericalError
from .._scene import Scene
from ._expression import Expression
from ._faults import near, short
from ._keys import Key, Value, is_number, takes
from ._options import KEYS, judged, single
from ._recipe import Recipe, flat
from ._tables import Reader


def _has_number(scene: Scene, path: str) -> bool:
    """Whether a key takes numbers, and this scene may have it: its tooth or wave generator may be of another family."""
    refused = scene.with_({path: "?"}).check()
    return bool(takes(path).number) and any(fault.path == path and fault.kind == "value" for fault in refused)


def absent_key(scene: Scene, name: str) -> str:
    """What to do about a name that is a key of numbers which the scene does not have; empty for others.

    No number stands in it: what a key does when it is absent is not always a value of it.
    """
    if "." not in name or not _has_number(scene, name):
        return ""
    effects: set[str] = set()
    with suppress(InputError):  # of a scene that these verbs do not take
        effects = {each["remedy"] for verb in ("contact", "load") for each in scene.plan(verb).get("absent", ())}
    words = name.split(".")
    for table in (".".join(words[:count]) for count in range(1, len(words))):
        if f"a table [{table}]" in effects:
            return f"leave the name out: the scene has no [{table}], an effect that this key would switch on"
    page = "docs/reference/scene.md says what holds while it is absent"
    return f'write "{name}" under [set], {takes(name).words}; {page}'


def ask_names(reader: Reader, recipe: Recipe, links: Mapping[str, Expression]) -> None:
    """Whether links find their names, and figures numbers; keys that are refused themselves are not proposed."""
    wrong = {fault.path.removeprefix("vary.").removeprefix("scene ") for fault in reader.faults}
    known, numbers = _known(recipe), _numbers(recipe)
    for name, figure in recipe.figures:
        for word in sorted(set(figure.names) & known - numbers - links.keys()):
            reader.told(f"figures.{name}", f"{word} is no number", "figures compute with numbers", figure.text)
    for path, link in links.items():
        for name in sorted(set(link.names) - links.keys() - numbers):
            if name in known:
                reader.told(f"vary.{path}", f"{name} is no number", "links compute with numbers", link.text)
            elif remedy := absent_key(recipe.scene, name):
                reader.told(f"vary.{path}", f"{name} is not written in the scene", remedy, link.text)
            else:
                proposed = sorted({*numbers, *links} - wrong - {path})
                reader.told(f"vary.{path}", f"unknown name {name}", near(name, proposed), link.text)


def _known(recipe: Recipe) -> set[str]:
    """Names that have a value: keys of the scene, and those that vary."""
    return {*recipe.base, *recipe.first}


def _numbers(recipe: Recipe) -> set[str]:
    """Those of them that have a number; a key that varies, one at least."""
    varied = {key.path for key in recipe.keys if any(map(is_number, (*key.values, key.middle)))}
    return varied | (recipe.constants.keys() - {key.path for key in recipe.keys})


def probe(reader: Reader, scene: Scene, recipe: Recipe) -> None:
    """What the scene's schema says of the base scene and of the ends of all that varies.

    Keys that vary need not stand in the base scene: a fault that the drive in the middle does not have is none.
    """
    own = set(scene.check())
    lasting = {fault.path for fault in recipe.scene_of(_with_links(recipe, recipe.first)).check()}
    for fault in (fault for fault in own if fault.path in lasting):
        given = reader.tables.get("scene")  # its lines are not those of the study
        place = f"line {fault.line} of {given}: " if fault.line and isinstance(given, str) else "scene "
        line = reader.lines.get(f"set.{fault.path}", reader.lines.get(f"scene.{fault.path}", 0))
        reader.faults.append(fault._replace(path=place + fault.path, line=line))
    refused: dict[str, tuple[Fault, Mapping[str, Value]]] = {}
    valued, taken = _refuse_without_value(reader, recipe), set[str]()
    for key in recipe.keys:
        if _refuse_no_length(reader, key, recipe):
            continue
        for value in (*key.probes, *key.between):
            values = _with_links(recipe, {**recipe.first, key.path: value})
            faults = [fault for fault in recipe.scene_of(values).check() if fault not in own and fault.kind != "other"]
            for fault in faults:
                _schema_fault(reader, fault, key, values, recipe)
            for path in (path for path, _ in recipe.links if path in values and path in valued):
                of_link = next((fault for fault in faults if _is_of(fault, path)), None)
                if of_link is None:
                    taken.add(path)
                else:
                    refused.setdefault(path, (of_link, values))
    for path, (fault, values) in refused.items():
        if path not in taken:
            _refuse_link(reader, fault, path, values, recipe)


def _refuse_without_value(reader: Reader, recipe: Recipe) -> set[str]:
    """The links that have a value in the middle or at an end; tells of those that have none."""
    links = {path: link.text for path, link in recipe.links}
    causes: dict[str, str] = {}
    valued: set[str] = set()
    for change in ({}, *({key.path: value} for key in recipe.keys for value in (*key.probes, *key.between))):
        without = len(links)
        try:
            recipe.linked({**recipe.first, **change})
        except NumericalError as error:
            causes.setdefault(error.place, error.cause.removeprefix(f"{links[error.place]}: "))
            without = list(links).index(error.place)
        valued.update(list(links)[:without])
    known = _numbers(recipe) | links.keys()  # ask_names() tells of other names
    sound = {path for path, link in recipe.links if known.issuperset(link.names)}
    for path in (path for path in causes if path not in valued and path in sound):
        reason = f"has no value in the middle of all that varies nor at an end: {causes[path]}"
        reader.told(f"vary.{path}", reason, "change the link, or the range of what it is of", links[path])
    return valued


def _is_of(fault: Fault, path: str) -> bool:
    """Whether a fault of a scene is one of a key, or of a table of that key which no scene has."""
    return fault.path == path or (fault.kind == "unknown" and path.startswith(f"{fault.path}."))


def _refuse_no_length(reader: Reader, key: Key, recipe: Recipe) -> bool:
    """Whether a key has a tolerance of ISO 286 and is no length in mm, of which the scene's schema knows the unit."""
    if key.law != "nominal":
        return False
    number, _, words = takes(key.path)
    scenes = (recipe.scene, *(scene for _, _, scene in recipe.worded()))  # a word may be a family with that key
    if number == "length" or not any(_has_number(scene, key.path) for scene in scenes):
        return False
    reason = f"tolerances of ISO 286 are those of lengths in mm, and this key takes {words}"
    reader.told(f"vary.{key.path}", reason, "write normal = [MEAN, DEVIATION], or from and to")
    return True


def _refuse_link(reader: Reader, fault: Fault, path: str, values: Mapping[str, Value], recipe: Recipe) -> None:
    """Tells of a link none of whose values, as far as they were tried, is one that its key takes."""
    text, given = dict(recipe.links)[path].text, values[path]
    if _wants_whole(path, given):
        return  # told already
    reason, remedy = fault.reason, fault.remedy
    if fault.kind == "value":
        names = recipe.varied_of(path)
        at = " at " * bool(names) + ", ".join(f"{name} = {short(values[name])}" for name in names)
        reason = f"gives {short(given)}{at}: {reason}"
        change = f"change the range{'s' * (len(names) > 1)} of {' and '.join(names)}, or the link"
        remedy = change if names else "change the link"
        if not takes(path).number:
            remedy = "links compute numbers: let this key vary by { list = [A, B] }"
    reader.told(f"vary.{path}", reason, remedy, text)


def _with_links(recipe: Recipe, values: Mapping[str, Value]) -> Mapping[str, Value]:
    """All values; without links where one has no value, as a drive is then a row of its own."""
    with suppress(NumericalError):
        return recipe.linked(values)
    return values


def ask_verbs(reader: Reader, recipe: Recipe) -> None:
    """What the verbs say of the values of their options, of the built-in drive where the scene has faults."""
    scene = recipe.scene_of(_with_links(recipe, recipe.first))
    if reader.faults and scene.check():
        scene = Scene()
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


def refuse_unused(reader: Reader, recipe: Recipe) -> None:
    """A name that no link and no figure uses changes nothing: most often a key of the scene is meant."""
    if any(fault.path.startswith(("vary", "figures")) for fault in reader.faults):
        return  # what uses it may be one of these
    used = {name for _, expression in (*recipe.links, *recipe.figures) for name in expression.names}
    ends = {path.rpartition(".")[2]: path for path in recipe.base}
    for key in recipe.keys:
        if "." not in key.path and key.path not in used:
            close = get_close_matches(key.path, ends, 1, 0.6)
            usual = "use it in a link or a figure, or remove it"
            remedy = f'write "{ends[close[0]]}" if that key is meant, or remove it' if close else usual
            reader.told(f"vary.{key.path}", "no link and no figure uses this name", remedy)


def _schema_fault(reader: Reader, fault: Fault, key: Key, values: Mapping[str, Value], recipe: Recipe) -> None:
    """Takes over a fault that holds whatever the other keys are; others are drives that cannot be made.

    A link has other values in other drives, but what makes no whole number here makes none there.
    """
    of_key = _is_of(fault, key.path)
    if not (of_key or fault.path in recipe.varied):
        return
    given = values.get(fault.path, fault.value)
    if _wants_whole(fault.path, given):
        reason, remedy = "takes whole numbers only", _whole_remedy(fault.path, recipe)
    elif values[key.path] in key.between or fault.path in dict(recipe.links):
        return  # a drive that cannot be made, as others of the range can
    else:
        reason, remedy, given = fault.reason, fault.remedy, values[key.path] if of_key else fault.value
    place = f"vary.{key.path if of_key else fault.path}"
    if not any(known.path == place and known.reason == reason for known in reader.faults):
        reader.told(place, reason, remedy, given)


def _wants_whole(path: str, value: object) -> bool:
    """Whether a key refuses a value because it is not whole."""
    return takes(path).number == "whole number" and isinstance(value, float) and not value.is_integer()


def _whole_remedy(path: str, recipe: Recipe) -> str:
    """What to write for a key that takes whole numbers only."""
    if link := dict(recipe.links).get(path):
        return f"write round({link.text})"
    key = next(key for key in recipe.keys if key.path == path)
    if key.law == "list":
        return "write whole numbers"
    if key.is_random:
        return f'let a name vary in its place, such as x, and write "{path}" = "round(x)"'
    low, high, step = map(round, (*key.numbers, 1)[:3])
    return f"write from = {low}, to = {max(high, low + 1)}, step = {max(step, 1)}"
