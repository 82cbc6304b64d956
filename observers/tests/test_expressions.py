"""Expressions as text: what is written is read again, and nothing else."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.errors import ParameterError
from pointpred_observers.plants.expressions import parsed, text_of

sp = pytest.importorskip("sympy")

X, Y = sp.symbols("x y")
LEAVES = st.sampled_from([X, Y, sp.Integer(-3), sp.Rational(2, 7), sp.pi, sp.sqrt(2)])
EXPRESSIONS = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.builds(lambda a, b: a + b, inner, inner),
        st.builds(lambda a, b: a * b, inner, inner),
        st.builds(lambda a: a**3, inner),
        st.builds(lambda a: 1 / (1 + a**2), inner),
        st.builds(sp.sin, inner),
        st.builds(sp.tanh, inner),
    ),
    max_leaves=6,
)


@given(EXPRESSIONS)
def test_an_expression_comes_back(expression: sp.Expr) -> None:
    assert parsed(text_of(expression), "here") == expression


def test_decimals_are_exact() -> None:
    assert parsed("0.1*x", "here") * 10 == X
    assert parsed("1e-3", "here") == sp.Rational(1, 1000)


@pytest.mark.parametrize(
    "text",
    [
        "x.real", "x[0]", "lambda: 1", "[x]", "x if y else 1", "f(x)", "sin(x, y)", "sin(*x)", "x == 1",
        "x and y",
        "(x := 1)", "'a'", "1j", "True", "x @ y", "x % 2", "x // 2", "9**9**9",
        "2**(10**9 + 1/2)", "(1/3)**(-10**9 - 1/7)",
        "2**100000", "1e999", "sqrt(-1)", "log(0)", "((9**99)**99)**99",
        "1/0", "x/(1-1)", "import os", "", " ", "x" * 30_000, "(" * 500 + "x" + ")" * 500, "__import__('os')",
    ],
    ids=range(33),
)  # fmt: skip
def test_anything_else_is_refused(text: str) -> None:
    with pytest.raises(ParameterError, match="here"):
        parsed(text, "here")
