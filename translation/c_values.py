"""An expression in C with its kind, and constants as such."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from translation.kinds import FLAG, FLOAT, WHOLE, Kind, kind_of_value

ATOM, CALL, UNARY, PRODUCT, SUM, ORDER, EQUAL, BITS, AND, OR, CHOICE = 20, 18, 15, 13, 12, 10, 9, 8, 5, 4, 3


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


def literal(value: Any) -> Value:
    """A constant."""
    if isinstance(value, bool):
        return Value("true" if value else "false", FLAG)
    if isinstance(value, int | np.integer):
        text = f"{int(value)}" if abs(int(value)) < 2**31 else f"INT64_C({int(value)})"
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
