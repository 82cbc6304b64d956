"""The modules of the package as the translator reads them: laws, rows, constants, and the origin of names."""

from __future__ import annotations

import ast
import importlib
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

MARK = "law"
PLAIN = {"pointpred.regions"}
"""Modules of laws that stay plain Python: another module compiles them by ``law(function)``."""


class UntranslatableError(Exception):
    """A construct that the law language does not have; the message names file, line, law and construct."""


class Name(NamedTuple):
    """What a name of a module stands for: the module that defines it, and its name there."""

    module: str
    name: str


class Module(NamedTuple):
    """A module of the package, parsed."""

    name: str
    path: Path
    functions: dict[str, ast.FunctionDef]
    laws: dict[str, ast.FunctionDef]
    """Functions with a mark."""
    marked: dict[str, str]
    """Names assigned as ``name = law(function)``, and the name of the function."""
    rows: dict[str, list[tuple[str, ast.expr]]]
    """Classes that name the parts of a tuple: each part with its annotation."""
    aliases: dict[str, ast.expr]
    """What names that are assigned at the top of the module stand for, as it is written there."""
    imports: dict[str, str]
    """What each imported name stands for, dotted."""
    values: dict[str, Any]
    """The module's own namespace when it has been imported."""


@cache
def module(name: str) -> Module:
    """Import and parse a module by its dotted name."""
    values = vars(importlib.import_module(name))
    path = Path(values["__file__"])
    return parse(name, path.read_text("utf-8"), path, values)


def parse(name: str, source: str, path: Path, values: dict[str, Any]) -> Module:
    """A module of this source."""
    tree = ast.parse(source)
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    laws = {key: node for key, node in functions.items() if any(map(_is_mark, node.decorator_list))}
    rows = {
        node.name: [
            (part.target.id, part.annotation)
            for part in node.body
            if isinstance(part, ast.AnnAssign) and isinstance(part.target, ast.Name)
        ]
        for node in tree.body
        if isinstance(node, ast.ClassDef) and any(_is_name(base, "NamedTuple") for base in node.bases)
    }
    aliases = {
        node.targets[0].id: node.value
        for node in tree.body
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }
    imports: dict[str, str] = {}
    for node in tree.body:
        if isinstance(node, ast.Import):
            imports |= {alias.asname or alias.name: alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            imports |= {alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names}
    marked = {
        target.id: node.value.args[0].id
        for node in tree.body
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and _is_mark(node.value.func)
        for target in node.targets
        if isinstance(target, ast.Name) and isinstance(node.value.args[0], ast.Name)
    }
    return Module(name, path, functions, laws, marked, rows, aliases, imports, values)


def _is_name(node: ast.expr, name: str) -> bool:
    return isinstance(node, ast.Name) and node.id == name


def _is_mark(node: ast.expr) -> bool:
    return _is_name(node, MARK)


def origin(reader: Module, name: str) -> Name:
    """Where a name that a module uses is defined; the module is empty for a builtin, and for a module."""
    dotted = reader.imports.get(name)
    if dotted is None:
        if name in reader.marked:
            return origin(reader, reader.marked[name])
        return Name(reader.name if name in reader.values else "", name)
    if _is_module(dotted):
        return Name("", dotted)
    where, _, attribute = dotted.rpartition(".")
    return origin(module(where), attribute) if where.startswith("pointpred") else Name(where, attribute)


def member(reader: Module, owner: str, name: str) -> Name:
    """Where ``owner.name`` is defined, ``owner`` being an imported module."""
    dotted = reader.imports.get(owner, "")
    return origin(module(dotted), name) if dotted.startswith("pointpred") else Name(dotted, name)


@cache
def _is_module(dotted: str) -> bool:
    try:
        importlib.import_module(dotted)
    except ModuleNotFoundError:
        return False
    return True


def is_law(name: Name) -> bool:
    """Whether a name is that of a law, of a layout, or of a function that another module compiles."""
    if not name.module.startswith("pointpred"):
        return False
    home = module(name.module)
    return name.name in home.laws or (name.module in PLAIN and name.name in home.functions)


def row_of(name: Name) -> list[tuple[str, ast.expr]] | None:
    """The parts of a class of rows; ``None`` for any other name."""
    if not name.module.startswith("pointpred"):
        return None
    return module(name.module).rows.get(name.name)
