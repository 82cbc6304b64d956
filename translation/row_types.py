"""Which values of a law are rows: the places of their named parts follow from their class."""

from __future__ import annotations

import ast
from typing import NamedTuple

from translation.source import Module, Name, member, module, origin, row_of


class Row(NamedTuple):
    """A row of a class."""

    of: Name


class Parts(NamedTuple):
    """A tuple of such values."""

    kinds: tuple[Kind, ...]


Kind = Row | Parts | None
"""What a value is, as far as it matters here; None: something else."""


class Types:
    """What the names of a law stand for, as its annotations and its assignments say."""

    def __init__(self, reader: Module, function: ast.FunctionDef) -> None:
        self._reader = reader
        self._kinds = {one.arg: annotated(reader, one.annotation) for one in function.args.args}

    def learn(self, assignment: ast.Assign) -> None:
        """Take in an assignment."""
        for target in assignment.targets:
            self._give(target, self.kind(assignment.value))

    def _give(self, target: ast.expr, kind: Kind) -> None:
        match target:
            case ast.Name():
                self._kinds[target.id] = kind
            case ast.Tuple(elts=targets):
                parts = kind.kinds if isinstance(kind, Parts) else (None,) * len(targets)
                for one, part in zip(targets, parts, strict=False):
                    self._give(one, part)

    def kind(self, node: ast.expr) -> Kind:
        """What an expression is."""
        match node:
            case ast.Name():
                return self._kinds.get(node.id)
            case ast.Tuple(elts=values):
                return Parts(tuple(self.kind(one) for one in values))
            case ast.Call(func=ast.Name(id=word)):
                return _called(origin(self._reader, word))
            case ast.Call(func=ast.Attribute(value=ast.Name(id=owner), attr=word)):
                return _called(member(self._reader, owner, word))
        return None

    def place(self, node: ast.Attribute) -> int | None:
        """The index of a named part; None where the value is not known to be a row that has it."""
        kind = self.kind(node.value)
        if not isinstance(kind, Row):
            return None
        names = [name for name, _ in row_of(kind.of) or []]
        return names.index(node.attr) if node.attr in names else None


def annotated(reader: Module, annotation: ast.expr | None) -> Kind:
    """What an annotation of a module says."""
    match annotation:
        case ast.Name(id=word):
            name = origin(reader, word)
            return Row(name) if row_of(name) is not None else None
        case ast.Subscript(value=ast.Name(id="tuple"), slice=ast.Tuple(elts=parts)):
            return Parts(tuple(annotated(reader, one) for one in parts))
    return None


def _called(name: Name) -> Kind:
    """What a class of rows makes, or a law returns."""
    if row_of(name) is not None:
        return Row(name)
    if not name.module.startswith("pointpred"):
        return None
    home = module(name.module)
    function = home.functions.get(name.name)
    return annotated(home, function.returns) if function else None
