"""The local names of a law: where each is declared in JavaScript, whose names live in blocks."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import NamedTuple

Block = tuple[int, ...]
"""A block of statements, as the path of blocks that leads to it."""


class Occurrence(NamedTuple):
    """A name in a law: the block and the statement in which it stands, and whether it is assigned there."""

    block: Block
    statement: ast.stmt
    assigned: bool


class Locals:
    """The names that a law assigns, and its arguments.

    ``views``: names that stand for a slice of an argument of which only single numbers are read or written;
    each with the array.
    """

    def __init__(self, function: ast.FunctionDef) -> None:
        self._function = function
        arguments = {one.arg for one in function.args.args}
        occurrences = list(_occurrences(function.body, (0,)))
        self._of: dict[str, list[Occurrence]] = {}
        for name, occurrence in occurrences:
            self._of.setdefault(name, []).append(occurrence)
        assigned = {name for name, places in self._of.items() if any(place.assigned for place in places)}
        self.names = arguments | assigned
        loops = {name for name in assigned if any(_loops_over(node, name) for node in ast.walk(function))}
        self._changed = {name for name in arguments if any(one.assigned for one in self._of.get(name, []))}
        self._begins = {name: _beginning(self._of[name]) for name in assigned - arguments - loops - {"_"}}
        self.views = _views(function, arguments - self._changed)

    def begins_here(self, statement: ast.stmt, name: str) -> bool:
        """Whether a name is declared by this assignment or loop."""
        return isinstance(statement, ast.For) or self._begins.get(name) is statement

    def is_constant(self, name: str) -> bool:
        """Whether a name is given a value once only."""
        return name not in self._changed and sum(one.assigned for one in self._of.get(name, [])) <= 1

    def declared_first(self) -> list[str]:
        """The names that are declared at the top of the law, because no single block holds them all."""
        return sorted(name for name, statement in self._begins.items() if statement is None)

    def outlives_loop(self, loop: ast.For, name: str) -> bool:
        """Whether the variable of a loop is used outside its loop."""
        within = {
            id(node) for one in ast.walk(self._function) if _loops_over(one, name) for node in ast.walk(one)
        }
        return any(id(one.statement) not in within for one in self._of[name])


def _loops_over(node: ast.AST, name: str) -> bool:
    return isinstance(node, ast.For) and isinstance(node.target, ast.Name) and node.target.id == name


def _occurrences(statements: list[ast.stmt], block: Block) -> Iterator[tuple[str, Occurrence]]:
    """Every name of a block and of the blocks in it, in the order of the source."""
    for statement in statements:
        inner = [part for part in ("body", "orelse") if getattr(statement, part, None)]
        for child in ast.iter_child_nodes(statement):
            if isinstance(child, ast.stmt):
                continue
            for node in ast.walk(child):
                if isinstance(node, ast.Name):
                    # The variable of a loop lives in its body.
                    loop = isinstance(statement, ast.For) and child is statement.target
                    where = (*block, id(statement)) if loop else block
                    yield node.id, Occurrence(where, statement, isinstance(node.ctx, ast.Store))
        for part in inner:
            yield from _occurrences(getattr(statement, part), (*block, id(statement), len(part)))


def _beginning(places: list[Occurrence]) -> ast.stmt | None:
    """The assignment that can declare a name: the first, if it stands in the block that holds all others.

    ``a = b = value`` declares neither.
    """
    first = places[0]
    # On the right of an assignment stands what was there before: the first in the source is the value's.
    assignment = next((one for one in places if one.assigned), first)
    inside = all(one.block[: len(assignment.block)] == assignment.block for one in places)
    alone = len(getattr(assignment.statement, "targets", ())) <= 1
    return assignment.statement if inside and alone and assignment.statement is first.statement else None


def _views(function: ast.FunctionDef, arrays: set[str]) -> dict[str, ast.expr]:
    """Names given a slice of an argument once, and then only indexed; with the argument."""
    candidates: dict[str, ast.expr] = {}
    counts: dict[str, int] = {}
    for node in ast.walk(function):
        if not isinstance(node, ast.Assign):
            continue
        for target, value in _pairs(node):
            if isinstance(target, ast.Name):
                counts[target.id] = counts.get(target.id, 0) + 1
                if isinstance(value, ast.Subscript) and _is_plain_slice(value.slice):
                    candidates[target.id] = value.value
    indexed = {
        id(node.value)
        for node in ast.walk(function)
        if isinstance(node, ast.Subscript) and not isinstance(node.slice, ast.Slice | ast.Tuple | ast.UnaryOp)
    }
    only_indexed = {
        name
        for name in candidates
        if all(
            id(node) in indexed
            for node in ast.walk(function)
            if isinstance(node, ast.Name) and node.id == name and isinstance(node.ctx, ast.Load)
        )
    }
    return {
        name: array
        for name, array in candidates.items()
        if name in only_indexed and counts[name] == 1 and isinstance(array, ast.Name) and array.id in arrays
    }


def _is_plain_slice(node: ast.expr) -> bool:
    return isinstance(node, ast.Slice) and node.step is None


def _pairs(node: ast.Assign) -> Iterator[tuple[ast.expr, ast.expr | None]]:
    """The targets of an assignment, each with its own value where there is one."""
    for target in node.targets:
        if not isinstance(target, ast.Tuple):
            yield target, node.value
        elif isinstance(node.value, ast.Tuple):
            yield from zip(target.elts, node.value.elts, strict=False)
        else:
            yield from ((one, None) for one in target.elts)
