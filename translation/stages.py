"""The classes of stages as objects in JavaScript: their laws, their parameters, the sizes of their memory."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from pointpred.compiled import key_of
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.parameter import REQUIRED, Parameter
from pointpred.person import layout_name
from pointpred.registry import GAINS, RECOMMENDED, REGISTRY
from pointpred.stage import CompiledStage
from pointpred.targets.aim import Aim
from translation.expressions import number
from translation.names import path_of, qualified, renamed
from translation.source import Name, is_law

COEFFICIENTS = "kinematic.js"
"""The module of coefficients in the folder of laws."""
LOAD_COEFFICIENTS = f'() => import("./{COEFFICIENTS}").then((one) => one.COEFFICIENTS)'
LONGEST_GROUP = 16
"""Slots of a group that comes again and again, such as those of a place, at most."""
LAWS = ("step", "conclude", "fill", "settle", "sizes", "fault", "enter_scene", "list_places", "list_parts")
"""What a class may name as its laws."""


def stages() -> list[type[CompiledStage]]:
    """Every predictor and every differentiator that has a name, and what weighs targets."""
    named = [*(one.predictor for one in REGISTRY.values()), *DIFFERENTIATORS.values()]
    return [*dict.fromkeys(named), Aim]


def laws_of(stage: type[CompiledStage]) -> dict[str, Name]:
    """The laws of a class by the names of its attributes."""
    named = {}
    for word in LAWS:
        function = getattr(stage, word, None)
        if function is None:
            continue
        home, _, own = key_of(function).partition(":")
        if is_law(name := Name(home, own)):
            named[word] = name
    return named


def text_of(stage: type[CompiledStage]) -> str:
    """The object of a class."""
    laws = laws_of(stage)
    parts = [
        f"{word}: {renamed(name.name) if name.module == stage.__module__ else qualified(name)}"
        for word, name in laws.items()
    ]
    example = stage(**_required(stage))
    memory, learned = len(example.remembered()) // 8, example.learned
    parts.append(
        f"settings: {example._first - learned}, learned: {learned}, states: {memory - example._first}"
    )
    if stage.slots:
        parts.append(f"layout: {json.dumps(layout_name(stage.slots).hex())}")
        parts.append(f"slots: [\n{_lines(_shortened([_slot(slot) for slot in stage.slots]))}\n  ]")
    parts.append(f"parameters: [\n{_lines(_parameter(one) for one in stage.parameters)}\n  ]")
    return f"export const {stage.__name__} = {{\n" + "".join(f"  {part},\n" for part in parts) + "};"


def registry_text() -> str:
    """The module that names every predictor and loads what it needs."""
    lines = [
        "// Written by `make laws` from the registry: change that and run it again.",
        f"export const RECOMMENDED = {json.dumps(RECOMMENDED)};",
        f"export const GAINS = {object_text(GAINS)};",
        "export const PREDICTORS = {",
    ]
    for entry in REGISTRY.values():
        preset = {"preset": entry.preset} if entry.preset else {}
        parts = [
            f"{key}: {_value(value)}"
            for key, value in {"differentiator": entry.differentiator, **preset}.items()
        ]
        parts.append(f"load: {_load(entry.predictor)}")
        if hasattr(entry.predictor, "coefficients"):
            parts.append(f"coefficients: {LOAD_COEFFICIENTS}")
        lines.append(f"  {json.dumps(entry.name)}: {{ {', '.join(parts)} }},")
    lines += ["};", "export const DIFFERENTIATORS = {"]
    lines += [f"  {json.dumps(name)}: {{ load: {_load(stage)} }}," for name, stage in DIFFERENTIATORS.items()]
    lines += ["};", "export const REGISTRY = { GAINS, PREDICTORS, DIFFERENTIATORS };"]
    return "\n".join(lines) + "\n"


def descriptions_text() -> str:
    """The module that says in words what names and parameters are, for pages that show it."""
    predictors = {
        entry.name: {
            "title": entry.title,
            "reference": entry.reference,
            "meanings": _meanings(entry.predictor),
        }
        for entry in REGISTRY.values()
    }
    differentiators = {name: {"meanings": _meanings(stage)} for name, stage in DIFFERENTIATORS.items()}
    return (
        "// Written by `make laws` from the registry: change that and run it again.\n"
        f"export const PREDICTORS = {json.dumps(predictors, indent=2)};\n"
        f"export const DIFFERENTIATORS = {json.dumps(differentiators, indent=2)};\n"
    )


def _shortened(entries: list[str]) -> Iterator[str]:
    """Entries of a list, a group of up to LONGEST_GROUP that comes again and again as one entry."""
    at = 0
    while at < len(entries):
        size, times = max(
            ((size, _times(entries, at, size)) for size in range(1, LONGEST_GROUP + 1)),
            key=lambda one: (one[1] > 1) * one[0] * one[1],
        )
        group = entries[at : at + size]
        if times > 1:
            yield f"...Array.from({{ length: {times} }}, () => [{', '.join(group)}]).flat()"
        else:
            yield from group[:1]
        at += size * times if times > 1 else 1


def _times(entries: list[str], at: int, size: int) -> int:
    """How often the group of this size stands there, one right after the other."""
    times, group = 1, entries[at : at + size]
    while entries[at + times * size : at + (times + 1) * size] == group:
        times += 1
    return times


def _meanings(stage: type[CompiledStage]) -> dict[str, str]:
    """What each parameter of a class does."""
    return {one.name: one.meaning for one in stage.parameters}


def _load(stage: type[CompiledStage]) -> str:
    return f'() => import("./{path_of(stage.__module__)}").then((one) => one.{stage.__name__})'


def _required(stage: type[CompiledStage]) -> dict[str, Any]:
    """A value for each parameter that has no default."""
    return {one.name: one.low for one in stage.parameters if one.default is REQUIRED}


def _parameter(one: Parameter) -> str:
    absent = {} if one.absent is None else {"absent": one.absent}
    whole = {"whole": True} if one.whole else {}
    given = {} if one.default is REQUIRED else {"default": one.default}
    bounds = {"name": one.name, **({"unit": one.unit} if one.unit else {}), "low": one.low, "high": one.high}
    return object_text(bounds | given | whole | absent)


def _slot(slot: Any) -> str:
    whole = {"whole": True} if slot.whole else {}
    return object_text({"name": slot.name, "count": slot.count, "low": slot.low, "high": slot.high} | whole)


def object_text(values: dict[str, Any]) -> str:
    """An object of numbers and words."""
    return (
        "{ " + ", ".join(f"{key}: {_value(value)}" for key, value in values.items()) + " }"
        if values
        else "{}"
    )


def _value(value: Any) -> str:
    if isinstance(value, bool | int | float):
        return number(value).text
    if isinstance(value, dict):
        return object_text(value)
    return json.dumps(value)


def _lines(lines: Iterator[str]) -> str:
    return "\n".join(f"    {line}," for line in lines)
