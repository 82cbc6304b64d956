"""Proofs that an expression vanishes nowhere, and places where it does."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred_observers.triangular.ranges import prove_nonzero

sp = pytest.importorskip("sympy")
W1, W2 = W = sp.symbols("w1 w2")


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
