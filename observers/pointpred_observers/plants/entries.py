"""Matrices, infinite bounds, expressions and Python functions as JSON holds them; no text is run."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Mapping
from keyword import iskeyword
from math import isfinite
from typing import Any, Self

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred_observers.numerics.matrices import matrix, wrong
from pointpred_observers.plants.nonlinearity import NAMED, Nonlinearity
from pointpred_observers.plants.symbolic import symbolic

LONGEST = 20_000
"""Most characters of an expression."""
DIGITS_MOST = 4096
"""Most bits of a power of numbers."""
CONSTANTS = ("pi", "E")
CALLED = ("exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "sqrt")
OPERATIONS: dict[type[ast.operator], Any] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}


class PythonFunction(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Stands for a Python function, which no file holds; ``function`` is its name there."""

    function: str


Rows = list[list[float] | float]
"""A matrix by its rows; a flat list is one row or one column, as everywhere in this library."""
Entries = Rows | PythonFunction | None
"""A matrix, a function of t or of the index, or nothing for zero."""
Values = dict[str, Rows | float]
"""Matrices of a certificate by their names in the theorem."""
Functions = Mapping[str, Callable[..., Any]]


class Document(msgspec.Struct, frozen=True, tag_field="kind", forbid_unknown_fields=True, omit_defaults=True):
    """What a file holds of one thing: ``of`` a Python object, and ``made`` into one again."""

    @classmethod
    def of(cls, thing: Any) -> Self:
        """The document of a thing; raises ParameterError for what no file can hold."""
        return cls(**fields_of(cls, thing))

    def made(self, functions: Functions) -> Any:
        """The thing, its checks and audits done; ``functions`` by name where Python functions are missing."""
        raise NotImplementedError


def fields_of(document: type[msgspec.Struct], thing: Any) -> dict[str, Any]:
    """The fields of a document that its thing has under the same names, as JSON holds them."""
    names = document.__struct_fields__
    return {name: written(getattr(thing, name)) for name in names if hasattr(thing, name)}


def written(value: Any) -> Any:
    """Anything that a plant or a design holds, as JSON holds it."""
    if isinstance(value, tuple):
        return tuple(map(written, value))
    if isinstance(value, np.ndarray):
        return entries(value)
    if isinstance(value, Nonlinearity):
        return named(value)
    if isinstance(value, float):
        return finite(value)
    if hasattr(value, "free_symbols"):
        return names_of([value])[0] if value.is_Symbol else text_of(value)
    return value


def named(f: Nonlinearity) -> Any:
    """The names of f, one if all components have the same; of a function its own."""
    if f.codes is None:
        return entries(f.function)
    names = tuple(NAMED[code] for code in f.codes)
    return names[0] if len(set(names)) == 1 else names


def entries(value: Any) -> Any:
    """A matrix as lists, ``None`` for an empty one, the name of a function for a function."""
    if callable(value):
        return PythonFunction(getattr(value, "__name__", type(value).__name__))
    table = np.asarray(value, np.float64)
    return table.tolist() if table.size else None


def finite(value: float) -> float | None:
    """A number, ``None`` for an infinite one, which JSON does not have."""
    return float(value) if np.isfinite(value) else None


def unbounded(value: float | None) -> float:
    """The number that ``finite`` was given, infinite for ``None``."""
    return np.inf if value is None else value


def gap_of(value: float | None, name: str = "gap") -> float:
    """The stored gap of a design, infinite for ``None``; raises ParameterError for one below 0."""
    if value is not None and not value >= 0.0:
        raise wrong(name, "must be a number not below 0, or null where nothing is proved", value)
    return unbounded(value)


def restored(name: str, value: Any, functions: Functions) -> Any:
    """A field with its Python function in place; raises ParameterError naming the function to pass."""
    if not isinstance(value, PythonFunction):
        return value
    if name not in functions:
        again = f"functions={{{name!r}: {value.function if value.function.isidentifier() else '...'}}}"
        words = f"{name} was saved as the Python function {value.function!r}: pass it again, as {again}"
        raise ParameterError(words, field=name)
    return functions[name]


def plain(values: dict[str, Any]) -> Values:
    """Matrices as lists, numbers as they are."""
    return {name: float(one) if np.ndim(one) == 0 else entries(one) for name, one in values.items()}


def matrices_of(
    values: Values,
    shapes: dict[str, tuple[int, int]],
    numbers: tuple[str, ...] = (),
    *,
    optional: tuple[str, ...] = (),
) -> dict[str, Any]:
    """The matrices of a certificate in their shapes; raises ParameterError for a missing or unknown one."""
    known = (*shapes, *numbers)
    if unknown := [name for name in values if name not in known]:
        raise ParameterError(f"certificate: {unknown[0]} is not known, it may hold {', '.join(known)}")
    if missing := [name for name in known if name not in values and name not in optional]:
        raise ParameterError(f"certificate: {missing[0]} is missing, it needs {', '.join(known)}")
    found: dict[str, Any] = {}
    for name, one in values.items():
        if name in numbers:
            if not isinstance(one, float):
                raise ParameterError(f"certificate: {name} must be a number, received a matrix")
            found[name] = one
        else:
            found[name] = matrix(f"certificate: {name}", one, *shapes[name])
    return found


def text_of(expression: Any) -> str:
    """An expression as ``parsed`` reads it; raises ParameterError for one that it could not read."""
    text = str(symbolic().sstr(expression, full_prec=False))
    if parsed(text, "the expression") != expression:
        raise ParameterError(f"{text} cannot be saved: it changes when it is read again")
    return text


def names_of(symbols: Any) -> tuple[str, ...]:
    """The names of symbols; raises ParameterError for one that is no plain name."""
    names = tuple(str(one) for one in symbols)
    for name in names:
        if not name.isidentifier() or iskeyword(name) or name in (*CONSTANTS, *CALLED):
            words = f"a symbol in a file needs a plain name, such as x1, no function, received {name!r}"
            raise ParameterError(words, field=name)
    return names


def symbols_of(names: tuple[str, ...]) -> list[Any]:
    """The symbols of names."""
    return [symbolic().Symbol(name) for name in names_of(names)]


def parsed(text: str, where: str) -> Any:
    """The expression that a text means: numbers, names, + - * / **, and the known functions of one argument.

    Decimals are read as they print. Nothing is evaluated as Python. Raises ParameterError naming ``where``.
    """
    if len(text) > LONGEST:
        raise ParameterError(f"{where}: an expression has at most {LONGEST} characters, received {len(text)}")
    try:
        expression = _built(ast.parse(text.strip(), mode="eval").body, where)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as unusable:
        if isinstance(unusable, ParameterError):
            raise
        raise ParameterError(f"{where}: {text!r:.60} is no expression") from unusable
    sp = symbolic()
    if expression.has(sp.nan, sp.oo, -sp.oo, sp.zoo, sp.I):
        raise ParameterError(f"{where}: {text!r:.60} has no finite real value")
    return expression


def _built(node: ast.expr, where: str) -> Any:
    sp = symbolic()
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        if isinstance(node.value, float) and not isfinite(node.value):
            raise ParameterError(f"{where}: a number is too large")
        return sp.Rational(repr(node.value))
    if isinstance(node, ast.Name):
        return getattr(sp, node.id) if node.id in CONSTANTS else sp.Symbol(node.id)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.UAdd | ast.USub):
        inner = _built(node.operand, where)
        return -inner if isinstance(node.op, ast.USub) else inner
    if isinstance(node, ast.BinOp):
        left, right = _built(node.left, where), _built(node.right, where)
        if isinstance(node.op, ast.Div) and right == 0:
            raise ParameterError(f"{where}: divides by zero in {ast.unparse(node)}")
        if isinstance(node.op, ast.Pow):
            _require_short(left, right, where)
        if operation := OPERATIONS.get(type(node.op)):
            return operation(left, right)
    if isinstance(node, ast.Call) and len(node.args) == 1 and not node.keywords:
        called = ast.unparse(node.func)
        if called in CALLED:
            return getattr(sp, called)(_built(node.args[0], where))
    known = f"numbers, names, + - * / **, {', '.join((*CONSTANTS, *CALLED))}"
    raise ParameterError(f"{where}: {ast.unparse(node)} is not known; an expression may hold {known}")


def _require_short(base: Any, exponent: Any, where: str) -> None:
    """Raise ParameterError for a power that is a number too long to be meant."""
    # sympy works out the whole part of a rational exponent, as it does an integer.
    if exponent.is_Rational and abs(exponent) > 1:
        parts = [part for one in base.atoms(symbolic().Rational) for part in (one.p, one.q)]
        size = max((abs(int(part)).bit_length() for part in parts), default=1)
        if size * abs(int(exponent)) > DIGITS_MOST:
            raise ParameterError(f"{where}: the power {base}**{exponent} is too large")
