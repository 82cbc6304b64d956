"""The entries of the npm package that bring one predictor each, and the types of all parameters."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from pointpred.differentiators import DIFFERENTIATORS
from pointpred.parameter import Parameter
from pointpred.registry import GAINS, RECOMMENDED, REGISTRY, Entry
from pointpred.stage import CompiledStage
from pointpred.targets.aim import Aim
from translation.expressions import number
from translation.names import alias, path_of, qualified
from translation.stages import COEFFICIENTS, LOAD_COEFFICIENTS, laws_of, object_text

FIRST = "minimum-jerk"
"""Predicts until the recommended one is loaded: it needs no coefficients."""
NOTE = "// Written by `make laws` from the registry: change that and run it again."
CORE = """import { inPage } from "../intent/page-source.js";
import { prefetchLinkWith } from "../intent/prefetch-link.js";
import { onIntentWith, registerWith } from "../intent/register.js";
import { assemble } from "../prediction/assembly.js";"""
EXPORTS = """
export const onIntent = /* @__PURE__ */ onIntentWith(OFFER);
export const register = /* @__PURE__ */ registerWith(OFFER);
export const prefetchLink = /* @__PURE__ */ prefetchLinkWith(onIntent);
export const build = (options) => assemble(REGISTRY, {name}, options);
export {{ ledger, onLedger }} from "../intent/reports.js";
export {{ showOverlay }} from "../intent/overlay/overlay.js";"""


def write(folder: Path) -> None:
    """Write every entry into a folder; other files in it are removed."""
    folder.mkdir(exist_ok=True)
    for path in folder.iterdir():
        path.unlink()
    for name, text in entry_texts().items():
        (folder / name).write_text(text, encoding="utf-8")


def entry_texts() -> dict[str, str]:
    """A module and its types for each predictor, by the names of the files."""
    texts = {}
    for entry in REGISTRY.values():
        texts[f"{entry.name}.js"] = _entry(entry)
        texts[f"{entry.name}.d.ts"] = _entry_types(entry)
    return texts


def registry_texts() -> dict[str, str]:
    """For each predictor a registry with nothing else, by the names of the files in the folder of laws."""
    return {f"only/{entry.name}.js": _registry(entry) for entry in REGISTRY.values()}


def types_text() -> str:
    """The names of predictors and the parameters of each, as types."""
    shared = [*(one for kind in DIFFERENTIATORS.values() for one in kind.parameters), *Aim.parameters]
    lines = [
        NOTE,
        "",
        "/** Of every predictor: parameters of the differentiators, and of what weighs targets. */",
        "export interface SharedParameters {",
        *_fields({one.name: one for one in shared}.values(), "  "),
        "  differentiator?: " + " | ".join(map(json.dumps, DIFFERENTIATORS)) + ";",
        "}",
        "",
        "/** The parameters of each predictor by its name. */",
        "export interface OwnParameters {",
    ]
    for entry in REGISTRY.values():
        fields = list(_fields(entry.predictor.parameters, "    "))
        lines.append(f"  /** {entry.title} ({entry.reference}) */")
        lines += (
            [f"  {json.dumps(entry.name)}: {{", *fields, "  };"]
            if fields
            else [f"  {json.dumps(entry.name)}: {{}};"]
        )
    lines += ["}", "", "export type PredictorName = keyof OwnParameters;"]
    return "\n".join(lines) + "\n"


def _fields(parameters: Iterable[Parameter], indent: str) -> Iterable[str]:
    for one in parameters:
        unit = f" {one.unit}" if one.unit else ""
        empty = " | null" if one.absent is not None else ""
        yield f"{indent}/** {one.meaning}; {one.low:g} to {one.high:g}{unit} */"
        yield f"{indent}{one.name}?: number{empty};"


def _registry(entry: Entry) -> str:
    """What `build` needs, and apart from it what `onIntent` needs: neither parameters nor `fill`.

    With coefficients a predictor is loaded when it is needed, with them; without, it is there at once.
    """
    differentiator = DIFFERENTIATORS[entry.differentiator]
    at_once = [differentiator] if _needs_coefficients(entry) else [differentiator, entry.predictor]
    laws = {laws_of(stage)["step"].module for stage in at_once}
    lines = [NOTE, *map(_import, at_once)]
    lines += [f'import * as {alias(module)} from "../{path_of(module)}";' for module in sorted(laws)]
    if _needs_coefficients(entry):
        path, kind = path_of(entry.predictor.__module__), entry.predictor.__name__
        load = f'() => import("../{path}").then((one) => one.{kind})'
        own = f"load: {load}, coefficients: {LOAD_COEFFICIENTS.replace('./', '../')}"
        predictor = (
            f'Promise.all([import("../{path}"), import("../{COEFFICIENTS}")]).then('
            f"([{{ {kind} }}, {{ COEFFICIENTS }}]) => "
            f"({{ step: {kind}.step, coefficients: COEFFICIENTS, {_memory(entry.predictor, entry)} }}))"
        )
    else:
        own = f"load: async () => {entry.predictor.__name__}"
        predictor = _stage(entry.predictor, entry)
    preset = f"preset: {object_text(entry.preset)}, " if entry.preset else ""
    source = json.dumps(entry.differentiator)
    lines += [
        "export const REGISTRY = {",
        f"  GAINS: {object_text(GAINS)},",
        f"  PREDICTORS: {{ {json.dumps(entry.name)}: {{ differentiator: {source}, {preset}{own} }} }},",
        f"  DIFFERENTIATORS: {{ {source}: {{ load: async () => {differentiator.__name__} }} }},",
        "};",
        "export const loadStages = () =>",
        "  Promise.all([",
        f"    {_stage(differentiator, entry)},",
        f"    {predictor},",
        "  ]);",
    ]
    return "\n".join(lines) + "\n"


def _stage(stage: type[CompiledStage], entry: Entry) -> str:
    """The law of a stage, and the memory that it begins with."""
    return f"{{ step: {qualified(laws_of(stage)['step'])}, {_memory(stage, entry)} }}"


def _memory(stage: type[CompiledStage], entry: Entry) -> str:
    """The memory of a stage with the usual values: what it begins with, and how many zeros follow."""
    given = GAINS | entry.preset
    own = {one.name for one in stage.parameters} & given.keys()
    memory = np.frombuffer(stage(**{name: given[name] for name in own}).remembered())
    first = np.trim_zeros(memory, "b")
    numbers = ", ".join(number(float(value)).text for value in first)
    return f"settings: [{numbers}], states: {len(memory) - len(first)}"


def _import(stage: type[CompiledStage]) -> str:
    return f'import {{ {stage.__name__} }} from "../{path_of(stage.__module__)}";'


def _entry(entry: Entry) -> str:
    name = json.dumps(entry.name)
    lines = [NOTE, CORE, f'import {{ loadStages, REGISTRY }} from "../laws/only/{entry.name}.js";']
    offered = f"inPage({name}, loadStages)"
    if entry.name == RECOMMENDED:
        lines.append(f'import {{ loadStages as loadFirst }} from "../laws/only/{FIRST}.js";')
        lines.append('import { smallFirst } from "../intent/small-first.js";')
        offered = f"smallFirst(inPage({json.dumps(FIRST)}, loadFirst), {offered})"
    if _learns_places(entry):
        lines.append('import { onPlaceWith } from "../intent/places.js";')
    lines += ["", f"const OFFER = {{ of: () => {offered} }};", EXPORTS.format(name=name).strip()]
    if _learns_places(entry):
        lines.append("export const onPlace = /* @__PURE__ */ onPlaceWith(build);")
    return "\n".join(lines) + "\n"


def _entry_types(entry: Entry) -> str:
    places = '\nexport { onPlace } from "../index.js";' if _learns_places(entry) else ""
    return f"""{NOTE}
import type {{ BuildOptions, Pipeline }} from "../index.js";

/** A pipeline of this predictor: {entry.title}. */
export function build(options?: BuildOptions<{json.dumps(entry.name)}>): Promise<Pipeline>;
export * from "../intent/one-predictor.js";{places}
"""


def _needs_coefficients(entry: Entry) -> bool:
    return hasattr(entry.predictor, "coefficients")


def _learns_places(entry: Entry) -> bool:
    return hasattr(entry.predictor, "list_places")
