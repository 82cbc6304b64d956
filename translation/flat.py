"""Memories with names as flat ones: what JavaScript makes of a law.

A memory ``s`` becomes the array ``s`` and the place ``s_at`` where it begins in it. ``s_at`` goes behind the other
arguments and is 0 unless told otherwise, so that a law can be called with a whole memory.
"""

from __future__ import annotations

import ast
from typing import NamedTuple

from pointpred.layout import Layout, Part
from translation.c_expressions import CLEAR
from translation.kinds import layout_at, layout_of
from translation.source import Module, Name, UntranslatableError, is_law, member, module, origin


class Place(NamedTuple):
    """A memory with names: the array, where it begins there, its layout; of ``count`` memories where it is one."""

    array: ast.expr
    at: ast.expr
    layout: type[Layout]
    count: int = 0


def layouts_of(reader: Module, function: ast.FunctionDef) -> dict[str, type[Layout]]:
    """The arguments of a law that are memories with names."""
    found = {}
    for one in function.args.args:
        layout = layout_at(reader, one.annotation)
        if layout is not None:
            found[one.arg] = layout
    return found


def flattened(reader: Module, function: ast.FunctionDef) -> tuple[ast.FunctionDef, list[str]]:
    """A law on flat memories, and the names of its places, which are its last arguments."""
    flat = _Flat(reader, function)
    body = [line for statement in function.body for line in flat.statement(statement)]
    places = [f"{name}_at" for name in layouts_of(reader, function)]
    arguments = ast.arguments([], [*function.args.args, *map(ast.arg, places)], None, [], [], None, [])
    made = ast.FunctionDef(function.name, arguments, body, [], function.returns)
    return ast.fix_missing_locations(ast.copy_location(made, function)), places


def _sum(*parts: ast.expr) -> ast.expr:
    """The sum of places, whole numbers that are known taken together, last."""
    known, others = 0, []
    for part in parts:
        for one in _summands(part):
            if isinstance(one, ast.Constant):
                known += one.value
            else:
                others.append(one)
    if known or not others:
        others.append(ast.Constant(known))
    total = others[0]
    for one in others[1:]:
        total = ast.BinOp(total, ast.Add(), one)
    return total


def _summands(node: ast.expr) -> list[ast.expr]:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return [*_summands(node.left), *_summands(node.right)]
    return [node]


def _times(node: ast.expr, size: int) -> ast.expr:
    if isinstance(node, ast.Constant):
        return ast.Constant(node.value * size)
    return node if size == 1 else ast.BinOp(node, ast.Mult(), ast.Constant(size))


class _Flat(ast.NodeTransformer):
    """Rewrites the statements of one law."""

    def __init__(self, reader: Module, function: ast.FunctionDef) -> None:
        self.reader, self.function = reader, function
        self.memories = {
            name: Place(ast.Name(name, ast.Load()), ast.Name(f"{name}_at", ast.Load()), layout)
            for name, layout in layouts_of(reader, function).items()
        }

    def error(self, node: ast.AST, what: str) -> UntranslatableError:
        line = getattr(node, "lineno", self.function.lineno)
        return UntranslatableError(f"{self.reader.path}:{line}: {self.function.name}: {what}")

    def statement(self, node: ast.stmt) -> list[ast.stmt]:
        """A statement, or those that stand for it."""
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value) if (place := self.place(value)) is not None:
                return [self._named(node, name, place)]
            case ast.Assign(targets=[ast.Tuple(elts=names)], value=ast.Tuple(elts=values)) if any(
                self.place(one) is not None for one in values
            ):
                pairs = zip(names, values, strict=True)
                return [line for one, value in pairs for line in self.statement(ast.copy_location(ast.Assign([one], value), node))]
            case ast.Expr(value=ast.Call(args=[part]) as call) if self._called(call) == CLEAR:
                place = self.place(part)
                if place is None:
                    raise self.error(node, f"clear of {ast.unparse(part)}")
                target = self._slice(place, 0, place.layout.length, ast.Store())
                return [ast.copy_location(ast.Assign([target], ast.Constant(0.0)), node)]
            case ast.If() | ast.For() | ast.While():
                for word in ("test", "iter"):
                    if hasattr(node, word):
                        setattr(node, word, self.visit(getattr(node, word)))
                for word in ("body", "orelse"):
                    setattr(node, word, [line for one in getattr(node, word) for line in self.statement(one)])
                return [node]
        made: ast.stmt = self.visit(node)
        return [made]

    def _named(self, node: ast.Assign, name: str, place: Place) -> ast.stmt:
        """A name for a memory within another one: its place gets the name."""
        known = self.memories.get(name)
        if known is not None and ast.unparse(known.array) != ast.unparse(place.array):
            raise self.error(node, f"{name} is a part of two memories")
        self.memories[name] = Place(place.array, ast.Name(f"{name}_at", ast.Load()), place.layout)
        return ast.copy_location(ast.Assign([ast.Name(f"{name}_at", ast.Store())], place.at), node)

    def _called(self, node: ast.Call) -> Name | None:
        match node.func:
            case ast.Name(id=word):
                return origin(self.reader, word)
            case ast.Attribute(value=ast.Name(id=owner), attr=word) if owner in self.reader.imports:
                return member(self.reader, owner, word)
        return None

    def place(self, node: ast.expr) -> Place | None:
        """The memory with names that an expression is; None where it is something else."""
        match node:
            case ast.Name(id=name):
                return self.memories.get(name)
            case ast.Attribute(value=value, attr=name) if (outer := self.place(value)) is not None:
                part = self._part(node, outer, name)
                if part is not None and part.of is not None:
                    return Place(outer.array, _sum(outer.at, ast.Constant(part.at)), part.of, part.shape[0] if part.shape else 0)
            case ast.Subscript(value=value, slice=index) if (outer := self.place(value)) is not None and outer.count:
                index = self.visit(index)
                return Place(outer.array, _sum(outer.at, _times(index, outer.layout.length)), outer.layout)
            case ast.Call(args=[array, *at]) if (layout := self._layout(node)) is not None:
                return Place(self.visit(array), self.visit(at[0]) if at else ast.Constant(0), layout)
        return None

    def _layout(self, node: ast.Call) -> type[Layout] | None:
        name = self._called(node)
        return layout_of(name) if name is not None and name.module.startswith("pointpred") else None

    def _part(self, node: ast.AST, place: Place, name: str) -> Part | None:
        if name == "memory":
            return None
        for part in place.layout.parts:
            if part.name == name:
                return part
        raise self.error(node, f"{place.layout.__name__} has no {name}")

    def _slice(self, place: Place, start: int, count: int, context: ast.expr_context) -> ast.expr:
        first = _sum(place.at, ast.Constant(start))
        return ast.Subscript(place.array, ast.Slice(first, _sum(first, ast.Constant(count))), context)

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:  # noqa: N802
        if node.attr == "length" and (layout := layout_at(self.reader, node.value)) is not None:
            return ast.copy_location(ast.Constant(layout.length), node)
        place = self.place(node.value)
        if place is None:
            return node if isinstance(node.value, ast.Name) else self.generic_visit(node)  # type: ignore[return-value]
        part = self._part(node, place, node.attr)
        if part is None:
            return ast.copy_location(self._slice(place, 0, place.layout.length, node.ctx), node)
        if part.of is not None or len(part.shape) > 1:
            raise self.error(node, f"the whole of {ast.unparse(node)}")
        if part.shape:
            if part.shape == (-1,):
                raise self.error(node, f"the whole of {ast.unparse(node)}")
            return ast.copy_location(self._slice(place, part.at, part.shape[0], node.ctx), node)
        return ast.copy_location(ast.Subscript(place.array, _sum(place.at, ast.Constant(part.at)), node.ctx), node)

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:  # noqa: N802
        match node.value:
            case ast.Attribute(value=value, attr=name) if (place := self.place(value)) is not None:
                part = self._part(node, place, name)
                if part is not None and part.of is None and part.shape:
                    return ast.copy_location(self._element(node, place, part), node)
        return self.generic_visit(node)  # type: ignore[return-value]

    def _element(self, node: ast.Subscript, place: Place, part: Part) -> ast.expr:
        first, index = _sum(place.at, ast.Constant(part.at)), node.slice
        wide = part.shape[1] if len(part.shape) == 2 else 1
        if isinstance(index, ast.Tuple):
            row, index = index.elts
            first, wide = _sum(first, _times(self.visit(row), wide)), 1
            end: ast.expr = _sum(first, ast.Constant(part.shape[1]))
        else:
            end = _sum(first, ast.Constant(part.shape[0] * wide))
        if isinstance(index, ast.Slice):
            lower = _sum(first, _times(self.visit(index.lower), wide)) if index.lower else first
            upper = _sum(first, _times(self.visit(index.upper), wide)) if index.upper else end
            return ast.Subscript(place.array, ast.Slice(lower, upper), node.ctx)
        at = _sum(first, _times(self.visit(index), wide))
        if len(part.shape) == 2 and not isinstance(node.slice, ast.Tuple):
            return ast.Subscript(place.array, ast.Slice(at, _sum(at, ast.Constant(wide))), node.ctx)
        return ast.Subscript(place.array, at, node.ctx)

    def visit_Call(self, node: ast.Call) -> ast.expr:  # noqa: N802
        if isinstance(node.func, ast.Attribute) and node.func.attr == "reshape":
            return self.generic_visit(node)  # type: ignore[return-value]
        name = self._called(node)
        if name == Name("", "len") and isinstance(node.args[0], ast.Attribute | ast.Subscript):
            size = self._size(node.args[0])
            if size is not None:
                return ast.copy_location(ast.Constant(size), node)
        arguments, places = [], []
        for i, argument in enumerate(node.args):
            place = self.place(argument)
            arguments.append(self.visit(argument) if place is None else place.array)
            if name is not None and is_law(name):
                home = module(name.module)
                taken = layouts_of(home, home.functions[name.name])
                words = [one.arg for one in home.functions[name.name].args.args]
                if i < len(words) and words[i] in taken:
                    places.append(ast.Constant(0) if place is None else place.at)
                elif place is not None:
                    raise self.error(node, f"{ast.unparse(argument)} where a flat memory is expected")
        while places and isinstance(places[-1], ast.Constant) and places[-1].value == 0:
            places.pop()
        return ast.copy_location(ast.Call(node.func, [*arguments, *places], node.keywords), node)

    def _size(self, node: ast.expr) -> int | None:
        """How many a part of a memory has."""
        place = self.place(node)
        if place is not None and place.count:
            return place.count
        if isinstance(node, ast.Attribute) and (outer := self.place(node.value)) is not None:
            part = self._part(node, outer, node.attr)
            return part.shape[0] if part is not None and part.shape and part.shape[0] > 0 else None
        return None
