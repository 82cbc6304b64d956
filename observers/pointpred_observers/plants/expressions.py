"""Expressions of symbolic plants as text, read without running any of it."""

from __future__ import annotations

import ast
import operator
from keyword import iskeyword
from math import isfinite
from typing import Any

from pointpred.errors import ParameterError
from pointpred_observers.plants.polynomials import symbolic

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
