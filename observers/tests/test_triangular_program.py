"""Programs of operations against sympy, and proofs that an expression vanishes nowhere."""

from __future__ import annotations

from math import isnan
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred_observers.triangular import program as triangular_program
from pointpred_observers.triangular.ranges import prove_nonzero
from pointpred_observers.triangular.program import ROW, program

sp = pytest.importorskip("sympy")
W1, W2 = W = sp.symbols("w1 w2")


def evaluated(expressions: Any, at: tuple[float, float], *, plain: bool = False) -> list[float]:
    """The program in a memory of its own: rows, constants, inputs, registers."""
    made = program(W, expressions)
    constants = ROW * len(made.rows)
    inputs = constants + len(made.constants)
    computed = inputs + len(W)
    memory = np.zeros(computed + made.computed)
    memory[:constants] = made.placed(inputs, constants, computed)
    memory[constants:inputs] = made.constants
    memory[inputs:computed] = at
    execute = triangular_program.execute
    rows = memory[:constants].reshape(-1, ROW)
    (getattr(execute, "py_func", execute) if plain else execute)(memory, rows)
    found: list[float] = memory[len(memory) - made.outputs :].tolist()
    return found


INTEGER = st.integers(-3, 3)


@st.composite
def expression(draw: st.DrawFn, depth: int = 3) -> Any:
    if depth == 0:
        return draw(st.sampled_from([W1, W2, sp.Rational(2, 3), sp.Integer(-1)]))
    left, right = draw(expression(depth=depth - 1)), draw(expression(depth=depth - 1))
    kind = draw(st.integers(0, 6))
    bounded = left / (1 + left**2)
    return [
        left + right, left * right, left**2 - right, right / (1 + left**2), sp.sin(left), sp.exp(bounded),
        sp.sqrt(1 + right**2) + sp.tanh(left),
    ][kind]  # fmt: skip


@given(expression(), expression(), st.floats(-2, 2), st.floats(-2, 2))
@settings(max_examples=25)
def test_random_expressions_have_the_values_of_sympy(one: Any, two: Any, w1: float, w2: float) -> None:
    expected = [float(e.subs({W1: w1, W2: w2})) for e in (one, two)]
    for plain in (False, True):
        assert evaluated([one, two], (w1, w2), plain=plain) == pytest.approx(expected, rel=1e-10, abs=1e-10)


@pytest.mark.parametrize("name", sorted(triangular_program.FUNCTIONS))
def test_every_function_is_the_one_it_is_called(name: str) -> None:
    function = getattr(sp, name)
    assert evaluated([function(W1)], (0.4, 0.0)) == pytest.approx([float(function(0.4))], rel=1e-15)


@pytest.mark.parametrize(
    ("e", "at"),
    [
        (1 / W1, 0.0), (sp.log(W1), -1.0), (sp.sqrt(W1), -1.0), (sp.asin(W1), 1.5), (sp.acos(W1), -1.5),
        (sp.exp(W1), 800.0), (sp.cosh(W1), -800.0), (W1**sp.Rational(1, 3), -1.0), (W1**W2, 1e300),
    ],
)  # fmt: skip
def test_what_has_no_finite_value_is_nan(e: Any, at: float) -> None:
    for plain in (False, True):
        assert isnan(evaluated([e], (at, 2.0), plain=plain)[0])


def test_exp_of_much_below_zero_is_nothing() -> None:
    assert evaluated([sp.exp(W1)], (-800.0, 0.0)) == [0.0]


def test_what_cannot_be_computed_is_refused() -> None:
    with pytest.raises(ParameterError, match=r"k\*w1 needs values for \['k'\]"):
        program(W, [sp.Symbol("k") * W1])
    with pytest.raises(ParameterError, match=r"Abs\(w1\) cannot be computed: known functions are exp, log"):
        program(W, [sp.Abs(W1)])


@pytest.mark.parametrize(
    ("e", "region"),
    [
        (1 + W1**2, None), (sp.exp(W1 * W2), None), (2 + sp.sin(W1), None), (sp.Integer(-3), None),
        (sp.Symbol("k"), None), (1 + W1**2 + W1 * W2 + W2**2, [(-3, 3), (-3, 3)]),
        (W1 - 2, [(-1, 1), (0, 0)]), (sp.Rational(1, 3) - W1, [(-1, 0.333), (0, 1)]),
    ],
)  # fmt: skip
def test_what_vanishes_nowhere_is_proved(e: Any, region: Any) -> None:
    prove_nonzero("g", e, W, region)


@pytest.mark.parametrize(
    ("e", "region", "place"),
    [
        (W1**2 - 2, None, r"vanishes at w1 = -?1\.41421"),
        (W1 * W2 + 1, None, r"vanishes at w1 = -1, w2 = 1"),
        (W1**2 + W2**2, [(-1, 1), (-2, 2)], "vanishes at w1 = 0, w2 = 0"),
        (sp.sin(W1), [(3.0, 4.0), (0, 1)], r"vanishes at w1 = 3\.14159"),
        (1 / (W1 - 1), [(0.0, 1.5), (0, 1)], "has no value at w1 = 1,"),
        ((W1 + 1) ** 2 - W1**2 - 2 * W1 - 1, None, "vanishes everywhere"),
    ],
)
def test_a_place_where_it_vanishes_is_named_and_true(e: Any, region: Any, place: str) -> None:
    with pytest.raises(InfeasibleError, match=f"^g {place}"):
        prove_nonzero("g", e, W, region)


def test_what_is_neither_is_undecided() -> None:
    with pytest.raises(UndecidedError, match=r"neither shown to vanish nowhere nor found .* give a region"):
        prove_nonzero("g", (W1 - sp.pi) ** 2, W, None)
    with pytest.raises(ParameterError, match=r"g = k\*w1 \+ 1 needs values for \['k'\]"):
        prove_nonzero("g", 1 + sp.Symbol("k") * W1, W, None)
    for wrong, told in (
        ([(0, 1)], r"region needs 2 pairs \(low, high\), received"),
        ([(1, 0), (0, 1)], r"w1 needs finite low <= high, received \(1, 0\)"),
        ([(0, np.inf), (0, 1)], "w1 needs finite low <= high"),
    ):
        with pytest.raises(ParameterError, match=told):
            prove_nonzero("g", W1, W, wrong)
