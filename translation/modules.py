"""The modules of the page: each module of the package whose laws are needed, as one in JavaScript."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import numpy as np

from pointpred.predictors.kinematic import coefficient_file
from pointpred.stage import CompiledStage
from translation import entries, stages
from translation.coefficients import coefficients_text
from translation.expressions import is_constant, number
from translation.javascript import Law
from translation.messages import fields_text, messages_text
from translation.names import alias, path_of, renamed
from translation.roots import HAND_WRITTEN, roots
from translation.source import Name, UntranslatableError, is_law, module


def write(folder: Path) -> None:
    """Write every module of the page into a folder; files that are there and not written are removed."""
    files = texts()
    for path in [one for one in folder.rglob("*") if one.is_file()]:
        if path.relative_to(folder).as_posix() not in files:
            path.unlink()
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def texts() -> dict[str, bytes]:
    """The content of every file by its path in the folder; raises UntranslatableError."""
    all_stages = stages.stages()
    of_stages = [name for stage in all_stages for name in stages.laws_of(stage).values()]
    classes = {Name(stage.__module__, stage.__name__) for stage in all_stages}
    wanted = reach([*(roots() - classes), *of_stages])
    modules = sorted({one.module for one in wanted} | {stage.__module__ for stage in all_stages})
    files = {
        path_of(name): text_of(name, wanted, [one for one in all_stages if one.__module__ == name]).encode()
        for name in modules
    }
    files["messages.js"] = messages_text().encode()
    files["fields.js"] = fields_text().encode()
    files["parameters.d.ts"] = entries.types_text().encode()
    files |= {name: text.encode() for name, text in entries.registry_texts().items()}
    files["registry.js"] = stages.registry_text().encode()
    files[stages.COEFFICIENTS] = coefficients_text(coefficient_file.read(coefficient_file.OWN)).encode()
    here = Path(__file__).parent
    return files | {name: (here / name).read_bytes() for name in HAND_WRITTEN}


@cache
def law(name: Name) -> Law:
    """A law in JavaScript; raises UntranslatableError."""
    home = module(name.module)
    return Law(home, home.functions[name.name])


def reach(roots: Iterable[Name]) -> set[Name]:
    """The laws and constants that these need, and they themselves."""
    known: set[Name] = set()
    waiting = list(roots)
    while waiting:
        name = waiting.pop()
        if name not in known:
            known.add(name)
            if is_law(name):
                waiting += law(name).uses
            elif not is_constant(name):
                raise UntranslatableError(f"{name.module}.{name.name} is neither a law nor a constant")
    return known


def relative(reader: str, target: str) -> str:
    """How one file of that folder names another."""
    path = posixpath.relpath(target, posixpath.dirname(path_of(reader)) or ".")
    return path if path.startswith(".") else f"./{path}"


def text_of(name: str, wanted: Iterable[Name], classes: list[type[CompiledStage]]) -> str:
    """The text of a module that exports these of its names, and these of its classes."""
    own = [one for one in wanted if one.module == name]
    home = module(name)
    laws = sorted((one for one in own if is_law(one)), key=lambda one: home.functions[one.name].lineno)
    constants = [one for one in own if not is_law(one)]
    constants.sort(key=lambda one: list(home.values).index(one.name))
    uses = {used.module for one in laws for used in law(one).uses}
    uses |= {used.module for stage in classes for used in stages.laws_of(stage).values()}
    uses -= {name}
    arithmetic = sorted({word for one in laws for word in law(one).arithmetic})
    lines = [f"// Written by `make laws` from {home.path.name}: change that and run it again."]
    if arithmetic:
        lines.append(f'import {{ {", ".join(arithmetic)} }} from "{relative(name, "arithmetic.js")}";')
    lines += [f'import * as {alias(used)} from "{relative(name, path_of(used))}";' for used in sorted(uses)]
    lines += [f"export const {renamed(one.name)} = {constant(home.values[one.name])};" for one in constants]
    lines += [law(one).text for one in laws]
    lines += [stages.text_of(stage) for stage in classes]
    return "\n".join(lines) + "\n"


def constant(value: object) -> str:
    """A number, a tuple of numbers, or a flat array."""
    if isinstance(value, np.ndarray):
        return f"/* @__PURE__ */ new Float64Array({number(tuple(value.tolist())).text})"
    return number(value).text
