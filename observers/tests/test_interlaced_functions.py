"""Interlaced observers whose maps hold functions that the compiled law does not know."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from scipy.special import erf

from pointpred.errors import ParameterError
from pointpred_observers.triangular.forms import interlaced
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver
from pointpred_observers.triangular.program import computable
from pointpred_observers.triangular.system import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem

sp = pytest.importorskip("sympy")
pytest.importorskip("cvxpy")
X1, X2, U, W1, W2 = sp.symbols("x1 x2 u w1 w2")


def steady(of: Any) -> SymbolicSteadyState:
    system = SymbolicSystem((X1, X2), (-of(X1) + X2, -X2 + U), U, outputs=(X1,))
    return interlaced(system, SymbolicGenerator((W1, W2), (W2, -W1)), 0, W1)


CASES: dict[str, tuple[Any, Any, Any]] = {
    "erf": (sp.erf, erf, lambda w: 2.0 / np.sqrt(np.pi) * np.exp(-(w**2))),
    "asinh": (sp.asinh, np.arcsinh, lambda w: 1.0 / np.sqrt(1.0 + w**2)),
}


@pytest.mark.parametrize("name", CASES)
def test_maps_of_any_function_run(name: str) -> None:
    """x2 = w2 + f(w1) and u = -w1 + f'(w1) w2 + x2, beside scipy's f; one by one, as a table and pickled."""
    symbolic, f, slope = CASES[name]
    maps = steady(symbolic)
    assert not computable(maps.maps)
    observer = InterlacedObserver.design(maps, decay=1.0)
    t = np.arange(0.0, 12.0, 0.05)
    rows = np.column_stack([t, 2.0 * np.cos(t)])
    rows[100:110, 1] = np.nan
    whole = observer.fresh().walk(np.zeros(len(t), np.bool_), rows)
    for i, (time, y) in enumerate(rows):
        if i == 40:
            observer = pickle.loads(pickle.dumps(observer))
        found = observer.update(None if np.isnan(y) else y, time)
        w1, w2 = found.w
        assert found.x == pytest.approx((w1, w2 + f(w1)), abs=1e-14)
        assert found.input == pytest.approx(-w1 + slope(w1) * w2 + w2 + f(w1), abs=1e-13)
        assert whole[i].tolist() == [*found.w, *found.x, *found.z, found.input]
    assert found.w == pytest.approx((2.0 * np.cos(t[-1]), -2.0 * np.sin(t[-1])), abs=1e-2)


def test_a_function_without_numbers_is_named() -> None:
    with pytest.raises(ParameterError, match="no numerical form"):
        InterlacedObserver.design(steady(sp.Function("friction")), decay=1.0)


def test_known_functions_stay_compiled() -> None:
    maps = steady(sp.tanh)
    assert computable((*maps.maps, maps.input))
    assert InterlacedObserver.design(maps, decay=1.0)._function is None
