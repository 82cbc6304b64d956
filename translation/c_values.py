"""An expression in C with its kind, and constants as such."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from translation.kinds import FLAG, FLOAT, WHOLE, Kind, joined, kind_of_value
from translation.source import Name

ATOM, CALL, UNARY, PRODUCT, SUM, ORDER, EQUAL, BITS, AND, OR, CHOICE = 20, 18, 15, 13, 12, 10, 9, 8, 5, 4, 3
SAME = {
    *("acos", "asin", "atan", "atan2", "copysign", "cos", "cosh", "erf", "exp", "expm1", "hypot", "lgamma"),
    *("log", "log1p", "log2", "pow", "sin", "sinh", "sqrt", "tan", "tanh"),
}
"""Functions of Python's ``math`` that are also functions of ``math.h``."""


class Value(NamedTuple):
    """An expression in C, its kind, and how tightly its outermost operator binds."""

    text: str
    kind: Kind
    binds: int = ATOM
    place: str = ""
    """Of an array within a memory: its own name, which is indexed directly."""

    def within(self, binds: int) -> str:
        """The expression where something that binds so tightly is expected."""
        return self.text if self.binds >= binds else f"({self.text})"


def function_of_c(name: Name, values: list[Value]) -> Value | None:
    """A call of a function of Python or of its ``math``; None where C has none like it."""
    word = name.name
    match word, values:
        case "abs", [one]:
            return Value(f"{'fabs' if one.kind == FLOAT else 'llabs'}({one.text})", one.kind, CALL)
        case "int", [one]:
            return one if one.kind == WHOLE else Value(f"(int64_t){one.within(UNARY)}", WHOLE, UNARY)
        case "float", [one]:
            return one if one.kind == FLOAT else Value(f"(double){one.within(UNARY)}", FLOAT, UNARY)
        case "bool", [one]:
            return one if one.kind == FLAG else Value(f"{one.within(EQUAL + 1)} != 0", FLAG, EQUAL)
        case "len", [one]:
            return Value(f"{one.within(CALL)}.n", WHOLE, CALL)
        case (("max" | "min"), [first, *others]) if others:
            for other in others:
                kind = joined(first.kind, other.kind)
                suffix = "_float" if kind == FLOAT else "_whole"
                first = Value(f"{word}{suffix}({first.text}, {other.text})", kind, CALL)
            return first
        case (("floor" | "ceil" | "trunc"), [one]):
            return one if one.kind == WHOLE else Value(f"(int64_t){word}({one.text})", WHOLE, UNARY)
        case "isfinite", [one]:
            return Value(f"isfinite({one.text})", FLAG, CALL)
    if name.module == "math" and word in SAME:
        return Value(f"{word}({', '.join(one.text for one in values)})", FLOAT, CALL)
    return None


def literal(value: Any) -> Value:
    """A constant."""
    if isinstance(value, bool):
        return Value("true" if value else "false", FLAG)
    if isinstance(value, int | np.integer):
        text = f"{int(value)}" if abs(int(value)) < 2**15 else f"INT64_C({int(value)})"
        return Value(text, WHOLE, UNARY if value < 0 else ATOM)
    if isinstance(value, float):
        if math.isinf(value):
            return Value("INFINITY", FLOAT) if value > 0 else Value("-INFINITY", FLOAT, UNARY)
        if value != value:
            return Value("NAN", FLOAT)
        return Value(repr(float(value)), FLOAT, UNARY if math.copysign(1.0, value) < 0 else ATOM)
    if isinstance(value, tuple):
        kind = kind_of_value(value)
        assert kind is not None
        return Value("{" + ", ".join(literal(one).text for one in value) + "}", kind)
    raise TypeError(f"no constant: {value!r}")
