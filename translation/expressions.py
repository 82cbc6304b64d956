"""The expressions of a law in JavaScript.

A tuple, and a row, becomes an array; a flat array a ``Float64Array``; a two-dimensional one an array of them.
What JavaScript means differently is a call of ``arithmetic.js``: the remainder, ``max``, ``min``, ``hypot``.
"""

from __future__ import annotations

import ast
import math
from typing import NamedTuple

import numpy as np

from translation.local_names import Locals
from translation.names import qualified, renamed
from translation.row_types import Types
from translation.source import Module, Name, UntranslatableError, is_law, member, module, origin, row_of

BINARY = {
    ast.Add: ("+", 12),
    ast.Sub: ("-", 12),
    ast.Mult: ("*", 13),
    ast.Div: ("/", 13),
    ast.BitAnd: ("&", 8),
}
"""Operators that both languages have, with JavaScript's precedence."""
COMPARISONS = {ast.Eq: "===", ast.NotEq: "!==", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}
SAME_IN_MATH = {
    *("abs", "acos", "asin", "atan", "atan2", "ceil", "cos", "cosh", "exp", "expm1", "floor"),
    *("log", "log1p", "log2", "sin", "sinh", "sqrt", "tan", "tanh", "trunc"),
}
"""Functions of Python's ``math`` that are also functions of ``Math``."""
OWN = {"copysign", "erf", "hypot", "lgamma"}
"""Functions of Python's ``math`` that ``arithmetic.js`` has."""
CONSTANTS = {"inf": "Infinity", "nan": "NaN", "pi": "Math.PI"}
ATOM, CALL, UNARY, COMPARE, EQUAL, AND, OR, CHOICE, COMMA = 20, 18, 15, 10, 9, 5, 4, 3, 1


class Text(NamedTuple):
    """An expression in JavaScript, and how tightly its outermost operator binds."""

    text: str
    binds: int = ATOM

    def within(self, binds: int) -> str:
        """The expression where something that binds so tightly is expected."""
        return self.text if self.binds >= binds else f"({self.text})"


class Expressions:
    """The expressions of one law; ``uses``: what they need of the package, ``arithmetic``: of that module."""

    def __init__(self, reader: Module, function: ast.FunctionDef) -> None:
        self.reader, self.function = reader, function
        self.uses: set[Name] = set()
        self.arithmetic: set[str] = set()
        self.types = Types(reader, function)
        self.locals = Locals(function)
        arguments = function.args.args
        self._floats = {
            one.arg for one in arguments if one.annotation and ast.unparse(one.annotation) == "float"
        }

    def error(self, node: ast.AST, what: str) -> UntranslatableError:
        """The error for a construct, with its file, line and law."""
        line = getattr(node, "lineno", self.function.lineno)
        return UntranslatableError(f"{self.reader.path}:{line}: {self.function.name}: {what}")

    def text(self, node: ast.expr) -> Text:
        """An expression; raises UntranslatableError."""
        match node:
            case ast.Constant(value=bool() | int() | float() as value):
                return number(value)
            case ast.Constant():
                raise self.error(node, f"constant {node.value!r}")
            case ast.Name():
                return self._name(node)
            case ast.Attribute():
                return self._attribute(node)
            case ast.Tuple():
                return Text(f"[{', '.join(self._part(one) for one in node.elts)}]")
            case ast.UnaryOp():
                return self._unary(node)
            case ast.BinOp():
                return self._binary(node)
            case ast.BoolOp():
                binds = AND if isinstance(node.op, ast.And) else OR
                word = " && " if binds == AND else " || "
                return Text(word.join(self.condition(one).within(binds + 1) for one in node.values), binds)
            case ast.Compare():
                return self._compare(node)
            case ast.IfExp():
                test, body, orelse = self.condition(node.test), self.text(node.body), self.text(node.orelse)
                return Text(
                    f"{test.within(CHOICE + 1)} ? {body.within(CHOICE + 1)} : {orelse.within(CHOICE)}", CHOICE
                )
            case ast.Subscript():
                return self._subscript(node)
            case ast.Call():
                return self._call(node)
        raise self.error(node, type(node).__name__)

    def _part(self, node: ast.expr) -> str:
        """A part of a tuple, or the parts of another one behind a star."""
        if isinstance(node, ast.Starred):
            return f"...{self.text(node.value).within(COMMA + 1)}"
        return self.text(node).within(COMMA + 1)

    def condition(self, node: ast.expr) -> Text:
        """An expression as a condition; a float is refused, because NaN is true in Python and false here."""
        if isinstance(node, ast.Name) and node.id in self._floats:
            raise self.error(node, f"the float {node.id} as a condition: write what it is compared with")
        return self.text(node)

    def _name(self, node: ast.Name) -> Text:
        if node.id in self.locals.names:
            return Text(renamed(node.id))
        return self._global(node, origin(self.reader, node.id))

    def _global(self, node: ast.expr, name: Name) -> Text:
        """A constant of a module, or a law."""
        if name.module in ("math", "numpy") and name.name in CONSTANTS:
            return Text(CONSTANTS[name.name])
        if is_law(name) or is_constant(name):
            self.uses.add(name)
            return Text(renamed(name.name) if name.module == self.reader.name else qualified(name))
        raise self.error(
            node,
            f"{name.module or 'unknown'}.{name.name}" if name.module else f"the name {ast.unparse(node)}",
        )

    def _attribute(self, node: ast.Attribute) -> Text:
        """A part of a row, ``shape`` of an array within its index, or what a module holds."""
        if (
            isinstance(node.value, ast.Name)
            and node.value.id in self.reader.imports
            and node.value.id not in self.locals.names
        ):
            return self._global(node, member(self.reader, node.value.id, node.attr))
        place = self.types.place(node)
        if place is None:
            raise self.error(
                node,
                f".{node.attr} of {ast.unparse(node.value)}, which is not known to be a row with that part",
            )
        return Text(f"{self.text(node.value).within(CALL)}[{place}]", CALL)

    def _unary(self, node: ast.UnaryOp) -> Text:
        sign = {ast.Not: "!", ast.USub: "-", ast.Invert: "~"}.get(type(node.op))
        if sign is None:
            raise self.error(node, f"{type(node.op).__name__} in {ast.unparse(node)}")
        operand = self.condition(node.operand) if sign == "!" else self.text(node.operand)
        return Text(f"{sign}{operand.within(UNARY + 1)}", UNARY)

    def _binary(self, node: ast.BinOp) -> Text:
        left, right = self.text(node.left), self.text(node.right)
        match node.op:
            case ast.Pow():
                return self._power(node, left, right)
            case ast.FloorDiv():
                return Text(f"Math.floor({left.within(13)} / {right.within(14)})", CALL)
            case ast.Mod():
                return self._own("remainder", left, right)
        if type(node.op) not in BINARY:
            raise self.error(node, f"{type(node.op).__name__} in {ast.unparse(node)}")
        sign, binds = BINARY[type(node.op)]
        return Text(f"{left.within(binds)} {sign} {right.within(binds + 1)}", binds)

    def _power(self, node: ast.BinOp, left: Text, right: Text) -> Text:
        """The square of a name is a product, as compiled Python has it; others are powers."""
        if isinstance(node.right, ast.Constant) and node.right.value == 2:
            if isinstance(node.left, ast.Name | ast.Attribute):
                return Text(f"{left.within(13)} * {left.within(14)}", 13)
            return self._own("square", left)
        return Text(f"Math.pow({left.within(COMMA + 1)}, {right.within(COMMA + 1)})", CALL)

    def _compare(self, node: ast.Compare) -> Text:
        operands = [node.left, *node.comparators]
        if any(isinstance(one, ast.Call) for one in operands[1:-1]):
            raise self.error(node, f"a call in the middle of {ast.unparse(node)}")
        if wrong := [one for one in node.ops if type(one) not in COMPARISONS]:
            raise self.error(node, f"{type(wrong[0]).__name__} in {ast.unparse(node)}")
        texts = [self.text(one).within(COMPARE + 1) for one in operands]
        signs = [COMPARISONS[type(one)] for one in node.ops]
        parts = [f"{texts[i]} {sign} {texts[i + 1]}" for i, sign in enumerate(signs)]
        return Text(parts[0], EQUAL) if len(parts) == 1 else Text(" && ".join(parts), AND)

    def _subscript(self, node: ast.Subscript) -> Text:
        array = node.value
        if isinstance(array, ast.Attribute) and array.attr == "shape":
            return self._shape(node, array.value)
        if isinstance(node.slice, ast.Slice):
            return self._own("view", self.text(array), Text(self.bounds(node.slice)[2:] or "0", COMMA))
        if isinstance(array, ast.Name) and array.id in self.locals.views:
            whole = self.text(self.locals.views[array.id])
            return Text(
                f"{whole.within(CALL)}[{renamed(array.id)} + {self.text(node.slice).within(12)}]", CALL
            )
        indices = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        if any(isinstance(one, ast.UnaryOp) for one in indices):
            raise self.error(node, f"an index from the end in {ast.unparse(node)}")
        if isinstance(indices[-1], ast.Slice):
            row = "".join(f"[{self.text(one).text}]" for one in indices[:-1])
            return self._own(
                "view",
                Text(f"{self.text(array).within(CALL)}{row}", CALL),
                Text(self.bounds(indices[-1])[2:] or "0", COMMA),
            )
        places = "".join(f"[{self.text(one).text}]" for one in indices)
        return Text(f"{self.text(array).within(CALL)}{places}", CALL)

    def bounds(self, part: ast.Slice) -> str:
        """The bounds of a slice as further arguments of a call."""
        if part.step is not None:
            raise self.error(part, "a slice in steps")
        lower = "0" if part.lower is None else self.text(part.lower).text
        if part.lower is None and part.upper is None:
            return ""
        return f", {lower}" + ("" if part.upper is None else f", {self.text(part.upper).text}")

    def _shape(self, node: ast.Subscript, array: ast.expr) -> Text:
        text = self.text(array).within(CALL)
        if isinstance(node.slice, ast.Constant) and node.slice.value in (0, 1):
            return Text(f"{text}.length" if node.slice.value == 0 else f"{text}[0].length", CALL)
        raise self.error(node, ast.unparse(node))

    def _call(self, node: ast.Call) -> Text:
        match node.func:
            case ast.Attribute(value=array, attr="reshape"):
                return self._own("table", self.text(array), *(self.text(one) for one in node.args))
            case ast.Name(id=word) if word not in self.locals.names:
                name = origin(self.reader, word)
            case ast.Attribute(value=ast.Name(id=owner), attr=word) if owner in self.reader.imports:
                name = member(self.reader, owner, word)
            case _:
                raise self.error(node, f"call of {ast.unparse(node.func)}")
        if row_of(name) is not None:
            return self._row(node)
        if any(isinstance(argument, ast.Starred) for argument in node.args):
            raise self.error(node, f"* in {ast.unparse(node)}")
        if name.module == "numpy" and name.name in ("empty", "zeros"):
            return self._array(node)
        if node.keywords:
            raise self.error(node, f"keyword in {ast.unparse(node)}")
        arguments = [self.text(one) for one in node.args]
        if not name.module:
            return self._builtin(node, name.name, arguments)
        if name.module == "math":
            return self._math(node, name.name, arguments)
        if not is_law(name):
            raise self.error(node, f"call of {ast.unparse(node)}")
        return _called(self._global(node, name).text, arguments)

    def _row(self, node: ast.Call) -> Text:
        if node.keywords:
            raise self.error(node, f"keyword in {ast.unparse(node)}")
        match node.args:
            case [ast.Starred(value=values)]:
                return self.text(values)
        return self.text(ast.Tuple(node.args))

    def _array(self, node: ast.Call) -> Text:
        """Whole numbers stand in an array of floats, too: up to 2^53 they are exact."""
        if not all(word.arg == "dtype" and ast.unparse(word.value) == "np.int64" for word in node.keywords):
            raise self.error(node, f"keyword in {ast.unparse(node)}")
        match node.args:
            case [ast.Tuple(elts=[rows, columns])]:
                return self._own("matrix", self.text(rows), self.text(columns))
            case [size]:
                return _called("new Float64Array", [self.text(size)])
        raise self.error(node, f"call of {ast.unparse(node)}")

    def _builtin(self, node: ast.Call, word: str, arguments: list[Text]) -> Text:
        match word, arguments:
            case "abs", [_]:
                return _called("Math.abs", arguments)
            case "int", [_]:
                return _called("Math.trunc", arguments)
            case "float", [one]:
                return _called("Number", arguments) if one.binds <= EQUAL else one
            case "bool", [one]:
                return one if one.binds in (AND, OR, EQUAL) else _called("Boolean", arguments)
            case "len", [one]:
                return Text(f"{one.within(CALL)}.length", CALL)
            case (("max" | "min"), [first, *others]) if others:
                for other in others:
                    first = self._own("larger" if word == "max" else "smaller", first, other)
                return first
        raise self.error(node, f"call of {ast.unparse(node)}")

    def _math(self, node: ast.Call, word: str, arguments: list[Text]) -> Text:
        if word in SAME_IN_MATH:
            return _called(f"Math.{word}", arguments)
        if word == "isfinite":
            return _called("Number.isFinite", arguments)
        if word in OWN:
            return self._own(word, *arguments)
        raise self.error(node, f"call of {ast.unparse(node)}")

    def _own(self, word: str, *arguments: Text) -> Text:
        """A call of a function of ``arithmetic.js``."""
        self.arithmetic.add(word)
        return Text(f"{word}({', '.join(one.within(COMMA) for one in arguments)})", CALL)


def _called(name: str, arguments: list[Text]) -> Text:
    return Text(f"{name}({', '.join(one.within(COMMA + 1) for one in arguments)})", CALL)


def number(value: object) -> Text:
    """A constant: a number, or a tuple of constants."""
    match value:
        case bool():
            return Text("true" if value else "false")
        case tuple():
            return Text(f"[{', '.join(number(one).text for one in value)}]")
        case int() | float():
            if math.isinf(value):
                return Text("Infinity") if value > 0 else Text("-Infinity", UNARY)
            if value != value:
                return Text("NaN")
            text = repr(value).removesuffix(".0")
            return Text(text, UNARY) if text.startswith("-") else Text(text)
    raise TypeError(f"no constant: {value!r}")


def is_constant(name: Name) -> bool:
    """Whether a name of a module of the package is a number, a tuple of numbers, or an array."""
    if not name.module.startswith("pointpred"):
        return False
    value = module(name.module).values.get(name.name)
    return (
        _is_number(value) or isinstance(value, np.ndarray) or (isinstance(value, tuple) and _is_table(value))
    )


def _is_number(value: object) -> bool:
    return isinstance(value, int | float)


def _is_table(value: tuple[object, ...]) -> bool:
    return all(_is_number(one) or (isinstance(one, tuple) and _is_table(one)) for one in value)
