"""Symbolic expressions as a list of operations that one compiled law executes.

Compiling one function per system would miss the cache in every process. A program is data: rows of
(operation, target, left, right), where the last three are places in the memory of a stage.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, asin, atan, cos, cosh, exp, isfinite, log, nan, sin, sinh, sqrt, tan, tanh
from typing import Any

import msgspec

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.records import FloatArray, FloatTable
from pointpred_observers.triangular.polynomials import symbolic

ROW = 4
COPY, ADD, MULTIPLY, DIVIDE, POWER = 0, 1, 2, 3, 4
SQRT, EXP, LOG, SIN, COS, TAN, ASIN, ACOS, ATAN, TANH, SINH, COSH = 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
FUNCTIONS = {
    "exp": EXP, "log": LOG, "sin": SIN, "cos": COS, "tan": TAN, "asin": ASIN, "acos": ACOS, "atan": ATAN,
    "sinh": SINH, "cosh": COSH, "tanh": TANH,
}  # fmt: skip
LARGEST_EXPONENT = 700.0
"""Largest argument of exp; beyond it the result is NaN."""


class Program(msgspec.Struct, frozen=True):
    """Operations on registers: inputs first, then ``constants``, then results, outputs last."""

    inputs: int
    constants: tuple[float, ...]
    rows: tuple[tuple[int, int, int, int], ...]
    registers: int
    outputs: int

    def placed(self, inputs: int, constants: int, computed: int) -> list[float]:
        """The rows, flat, with memory places for registers."""
        fixed = self.inputs + len(self.constants)

        def place(register: int) -> int:
            if register < self.inputs:
                return inputs + register
            if register < fixed:
                return constants + register - self.inputs
            return computed + register - fixed

        placed = ((code, *(place(r) for r in registers)) for code, *registers in self.rows)
        return [float(number) for row in placed for number in row]

    @property
    def computed(self) -> int:
        """Number of registers that are written."""
        return self.registers - self.inputs - len(self.constants)


@law
def apply(code: int, a: float, b: float) -> float:
    """One operation; NaN without a finite real value."""
    if code == COPY:
        return a
    if code == ADD:
        return a + b
    if code == MULTIPLY:
        return a * b
    if code == DIVIDE:
        return a / b if b != 0.0 else nan
    if code == POWER:
        return a**b if a > 0.0 and b * log(a) < LARGEST_EXPONENT else nan
    if code == SQRT:
        return sqrt(a) if a >= 0.0 else nan
    if code == LOG:
        return log(a) if a > 0.0 else nan
    if code == ATAN:
        return atan(a)
    if code == TANH:
        return tanh(a)
    if code == ASIN:
        return asin(a) if abs(a) <= 1.0 else nan
    if code == ACOS:
        return acos(a) if abs(a) <= 1.0 else nan
    grows = (code >= SINH) or (code == EXP and a > 0.0)
    if not isfinite(a) or (grows and abs(a) > LARGEST_EXPONENT):
        return nan
    if code == EXP:
        return exp(a)
    if code == SIN:
        return sin(a)
    if code == COS:
        return cos(a)
    if code == TAN:
        return tan(a)
    return sinh(a) if code == SINH else cosh(a)


@law
def execute(memory: FloatArray, rows: FloatTable) -> None:
    """Execute the rows of a program, whose registers are places in the memory."""
    for i in range(len(rows)):
        target, left, right = int(rows[i, 1]), int(rows[i, 2]), int(rows[i, 3])
        memory[target] = apply(int(rows[i, 0]), memory[left], memory[right])


def computable(expressions: Sequence[Any]) -> bool:
    """Whether the law can compute every function in the expressions."""
    sp = symbolic()

    def known(one: Any) -> bool:
        named = one.is_Function and len(one.args) == 1 and one.func.__name__ in FUNCTIONS
        return bool(one.is_Atom or one.is_Add or one.is_Mul or one.is_Pow or named)

    return all(known(one) for expression in expressions for one in sp.preorder_traversal(expression))


def program(inputs: Sequence[Any], expressions: Sequence[Any]) -> Program:
    """Translate expressions; common parts are computed once, polynomials by Horner's rule.

    Raises ParameterError for a symbol that is not an input and for an unsupported function.

    >>> import sympy as sp
    >>> w = sp.Symbol("w")
    >>> program([w], [sp.Rational(1, 2) + w**2]).rows
    ((2, 2, 0, 0), (1, 3, 1, 2), (0, 4, 3, 3))
    """
    sp = symbolic()
    for e in expressions:
        if foreign := e.free_symbols - {*inputs}:
            raise ParameterError(f"{e} needs values for {sorted(map(str, foreign))}")
    shorter = [
        sp.horner(e, wrt=list(inputs)) if e.is_polynomial(*inputs) and e.free_symbols else e
        for e in expressions
    ]
    shared, reduced = sp.cse(shorter, symbols=sp.numbered_symbols(cls=sp.Dummy))
    writer = _Writer(inputs)
    for symbol, e in shared:
        writer.names[symbol] = writer.write(e)
    ends = [writer.write(e) for e in reduced]
    return writer.finished(ends)


class _Writer:
    """Collects rows; a register is named by its kind and its number within the kind."""

    def __init__(self, inputs: Sequence[Any]) -> None:
        self.names = {symbol: ("input", i) for i, symbol in enumerate(inputs)}
        self.inputs = len(inputs)
        self.constants: list[float] = []
        self.rows: list[tuple[int, tuple[str, int], tuple[str, int]]] = []

    def write(self, e: Any) -> tuple[str, int]:
        if e in self.names:
            return self.names[e]
        if e.is_number:
            return self.constant(float(e))
        if e.is_Add or e.is_Mul:
            operation = ADD if e.is_Add else MULTIPLY
            total, *others = [self.write(term) for term in e.args]
            for other in others:
                total = self.row(operation, total, other)
            return total
        if e.is_Pow:
            return self.power(e.base, e.exp)
        name = e.func.__name__
        if name in FUNCTIONS and len(e.args) == 1:
            inner = self.write(e.args[0])
            return self.row(FUNCTIONS[name], inner, inner)
        raise ParameterError(f"{e} cannot be computed: known functions are {', '.join(FUNCTIONS)}")

    def power(self, base: Any, exponent: Any) -> tuple[str, int]:
        x = self.write(base)
        if not exponent.is_Integer:
            return (
                self.row(SQRT, x, x)
                if exponent == symbolic().Rational(1, 2)
                else self.row(POWER, x, self.write(exponent))
            )
        total = x
        for _ in range(abs(int(exponent)) - 1):
            total = self.row(MULTIPLY, total, x)
        return total if exponent > 0 else self.row(DIVIDE, self.constant(1.0), total)

    def constant(self, value: float) -> tuple[str, int]:
        if value not in self.constants:
            self.constants.append(value)
        return "constant", self.constants.index(value)

    def row(self, operation: int, left: tuple[str, int], right: tuple[str, int]) -> tuple[str, int]:
        self.rows.append((operation, left, right))
        return "computed", len(self.rows) - 1

    def finished(self, ends: Sequence[tuple[str, int]]) -> Program:
        for end in ends:
            self.row(COPY, end, end)
        starts = {"input": 0, "constant": self.inputs, "computed": self.inputs + len(self.constants)}

        def register(of: tuple[str, int]) -> int:
            return starts[of[0]] + of[1]

        rows = tuple(
            (code, starts["computed"] + i, register(left), register(right))
            for i, (code, left, right) in enumerate(self.rows)
        )
        count = starts["computed"] + len(rows)
        return Program(self.inputs, tuple(self.constants), rows, count, len(ends))
