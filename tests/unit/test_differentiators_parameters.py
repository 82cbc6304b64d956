"""What the constructors refuse, and that they say the bound and the value."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from pointpred import EventColumns, build
from pointpred.differentiators import (
    DIFFERENTIATORS,
    BackwardDifferentiator,
    HomogeneousDifferentiator,
    KalmanDifferentiator,
)
from pointpred.errors import ParameterError

REFUSED: list[tuple[type, dict[str, Any], str]] = [
    (HomogeneousDifferentiator, {"order": 1}, r"order must lie in \[2, 8\].*received 1"),
    (HomogeneousDifferentiator, {"order": 2.5}, "order must be a whole number, received 2.5"),
    (HomogeneousDifferentiator, {"alpha": -0.26}, r"alpha must lie in \[-1/order, 0\].*-0.26"),
    (HomogeneousDifferentiator, {"alpha": 0.01}, "alpha must lie in"),
    (HomogeneousDifferentiator, {"gain_lambda": math.nan}, "gain_lambda must lie in .*nan"),
    (HomogeneousDifferentiator, {"between": "spline"}, "'line' or 'hold', received 'spline'"),
    (HomogeneousDifferentiator, {"gains": [1.0, 2.0]}, "gains must be 4 positive numbers"),
    (HomogeneousDifferentiator, {"gains": [1.0, 2.0, -3.0, 4.0]}, "gains must be 4 positive numbers"),
    (HomogeneousDifferentiator, {"gains": 5}, "gains must be 4 positive numbers, received 5"),
    (HomogeneousDifferentiator, {"gains": "abcd"}, "gains must be 4 positive numbers, received 'abcd'"),
    (HomogeneousDifferentiator, {"gains": [1, 2, 3, None]}, "gains must be 4 positive numbers"),
    (HomogeneousDifferentiator, {"gains": [1.0, 1.0, 100.0, 1.0]}, "unstable law: a pole has real part"),
    (HomogeneousDifferentiator, {"gain_lambda": 500.0}, r"step_s must be below 0.0005 s.*received 0.0015"),
    (HomogeneousDifferentiator, {"gap_s": 20.0, "pause_s": 30.0}, "gap_s must be at most 10000 sub-steps"),
    (KalmanDifferentiator, {"jerk_density": 0.0}, "jerk_density must lie in .*m\\^2/s\\^5, received 0"),
    (KalmanDifferentiator, {"noise_m": -1e-4}, "noise_m must lie in"),
    (BackwardDifferentiator, {"shortest_s": 0.0}, "shortest_s must lie in"),
    (BackwardDifferentiator, {"shortest_s": "1"}, r"shortest_s must be a number \(s\), received '1'"),
    *[(kind, {"dpi": 0.0}, "dpi must lie in") for kind in DIFFERENTIATORS.values()],
    *[(kind, {"cpi": True}, "cpi must be a number") for kind in DIFFERENTIATORS.values()],
    *[(kind, {"pause_s": 0.05}, "pause_s must be at least gap_s") for kind in DIFFERENTIATORS.values()],
]


@pytest.mark.parametrize(("kind", "parameters", "message"), REFUSED)
def test_refuses(kind: type, parameters: dict[str, Any], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        kind(**parameters)


def test_a_whole_order_may_be_a_float() -> None:
    assert np.array_equal(
        HomogeneousDifferentiator(order=4.0)._memory,  # type: ignore[arg-type]
        HomogeneousDifferentiator(order=4)._memory,
    )


@pytest.mark.parametrize("wrong", [["hold"], None, 5, {}])
def test_a_name_that_is_no_word_is_refused(wrong: Any) -> None:
    with pytest.raises(ParameterError, match="unknown predictor"):
        build(wrong)
    with pytest.raises(ParameterError, match="unknown differentiator"):
        build("hold", differentiator=wrong)


@pytest.mark.parametrize("name", DIFFERENTIATORS)
def test_every_default_lies_within_its_bounds_and_is_documented(name: str) -> None:
    kind = DIFFERENTIATORS[name]
    for parameter in kind.parameters:
        value = parameter.default
        assert value is None or parameter.low <= value <= parameter.high
        assert parameter.name in (kind.__doc__ or "")
        assert parameter.meaning


@pytest.mark.parametrize("order", range(2, 9))
def test_every_order_follows_a_slow_sine(order: int) -> None:
    t = np.arange(2000) * 0.001
    u = 0.05 * np.sin(3.0 * t)
    differentiator = HomogeneousDifferentiator(order=order, alpha=-0.1, gain_lambda=20.0, gain_xi=1.2)
    motions = differentiator.run(EventColumns.of(t, u * 96 / 0.0254, u))
    error = np.abs(motions.vx - 0.15 * np.cos(3.0 * t))[500:]
    if order == 2:
        # Without a model of the acceleration, k_2 |e|^0.8 balances it: the velocity is off by k_1 |e|^0.9.
        k1, k2 = differentiator.gains
        assert error.max() == pytest.approx(k1 * (0.45 / k2) ** (0.9 / 0.8), rel=0.05)
    else:
        assert error.max() < 1e-3


@pytest.mark.parametrize("name", DIFFERENTIATORS)
@pytest.mark.parametrize(("parameter", "value"), [("gap_s", "x"), ("pause_s", None), ("gap_s", math.nan)])
def test_shared_parameters_are_checked_before_they_are_compared(
    name: str, parameter: str, value: Any
) -> None:
    with pytest.raises(ParameterError, match=f"{parameter} must"):
        DIFFERENTIATORS[name](**{parameter: value})
    with pytest.raises(ParameterError, match=f"{parameter} must"):
        build("hold", differentiator=name, **{parameter: value})
