"""Known transfer functions against their definitions, and what they share."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from pointpred.errors import EventError, ParameterError, RecordingError
from pointpred.transfer import (
    Arctan,
    ConstantGain,
    PolynomialFunction,
    SigmoidGain,
    TransferFunction,
    averaged_gain,
)

FUNCTIONS: list[TransferFunction] = [
    ConstantGain(),
    SigmoidGain(),
    Arctan(),
    PolynomialFunction([0.0, 1.0, -2.0, 30.0, 4.0, -5.0, 6.0]),
]


def test_the_sigmoid_is_the_line_through_the_experiment_s_four_numbers() -> None:
    speeds = np.linspace(0.0, 1.0, 501)
    wanted = np.interp(speeds, [0.05, 0.6], [1.0, 15.0])
    assert SigmoidGain().gain(speeds) == pytest.approx(wanted, rel=1e-12)


def test_the_polynomial_is_numpy_s() -> None:
    coefficients = [0.3, 1.0, -2.0, 30.0, 4.0, -5.0, 6.0]
    speeds = np.linspace(0.01, 0.5, 50)
    wanted = np.polynomial.Polynomial(coefficients)(speeds)
    function = PolynomialFunction(coefficients)
    assert function.cursor_speed(speeds) == pytest.approx(wanted, rel=1e-12)
    assert function.gain(speeds) == pytest.approx(wanted / speeds, rel=1e-12)
    assert float(function.gain(0.0)) == np.inf
    assert Arctan().cursor_speed(speeds) == pytest.approx(np.arctan(speeds), rel=1e-12)


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: type(f).__name__)
@given(speed=st.floats(1e-6, 2.0))
def test_gain_times_speed_is_the_cursor_s_speed(function: TransferFunction, speed: float) -> None:
    assert isinstance(function, TransferFunction)
    assert float(function.gain(speed)) * speed == pytest.approx(float(function.cursor_speed(speed)), rel=1e-9)
    assert float(function.gain(0.0)) == pytest.approx(float(function.gain(1e-12)), rel=1e-9)


def test_shapes_are_kept_and_a_wrong_speed_is_named() -> None:
    assert ConstantGain().gain([[0.1, 0.2], [0.3, 0.4]]).shape == (2, 2)
    for wrong in (-0.1, np.nan, np.inf):
        with pytest.raises(EventError) as refused:
            ConstantGain().gain([0.1, wrong])
        assert refused.value.field == "speed"
        assert refused.value.value == pytest.approx(wrong, nan_ok=True)


def test_bounds_are_named() -> None:
    wrong: list[tuple[str, Callable[[], object]]] = [
        ("gain", lambda: ConstantGain(-1.0)),
        ("speed_low", lambda: SigmoidGain(speed_low=0.2, speed_high=0.1)),
        ("coefficients", lambda: PolynomialFunction([])),
        ("coefficients", lambda: PolynomialFunction([0.0] * 8)),
        ("coefficients", lambda: PolynomialFunction([np.nan])),
        ("speed_max_m_s", lambda: averaged_gain(ConstantGain(), 0.0)),
    ]
    for field, call in wrong:
        with pytest.raises(ParameterError) as refused:
            call()
        assert refused.value.field == field


@pytest.mark.parametrize("speed_max", [0.02, 0.1, 0.3, 0.9])
@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: type(f).__name__)
def test_the_averaged_gain_is_the_ratio_of_two_displacements(
    function: TransferFunction, speed_max: float
) -> None:
    corners = [float(np.arcsin(v / speed_max)) for v in (0.05, 0.6) if v < speed_max]
    corners += [np.pi - c for c in corners]
    way = quad(
        lambda p: float(function.cursor_speed(speed_max * np.sin(p))), 0.0, np.pi, points=corners or None
    )[0]
    path = quad(lambda p: speed_max * np.sin(p), 0.0, np.pi)[0]
    assert averaged_gain(function, speed_max) == pytest.approx(way / path, rel=1e-6)


def test_the_printed_averaged_gain_is_no_gain() -> None:
    """For PTF = g V the printed (1 / Vmax) int_0^Vmax PTF(s) ds is g Vmax / 2, a speed."""
    speed_max, gain = 0.2, 4.0
    printed = quad(lambda s: gain * s, 0.0, speed_max)[0] / speed_max
    assert printed == pytest.approx(gain * speed_max / 2.0)
    assert averaged_gain(ConstantGain(gain), speed_max) == pytest.approx(gain, rel=1e-6)


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=7), st.floats(0.0, 1.0), st.floats(1.5, np.inf))
def test_json_keeps_every_bit(coefficients: list[float], low: float, high: float) -> None:
    function = PolynomialFunction(coefficients, speed_low=low, speed_high=high)
    twin = PolynomialFunction.from_json(function.to_json())
    assert (twin.coefficients, twin.speed_low, twin.speed_high) == (function.coefficients, low, high)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "not a saved transfer function"),
        ('{"version":1,"coefficients":["x"],"speed_low":0,"speed_high":1}', "coefficients"),
        ('{"version":2,"coefficients":[1],"speed_low":0,"speed_high":1}', "version must be 1, received 2"),
    ],
)
def test_other_json_is_refused(text: str, said: str) -> None:
    with pytest.raises(RecordingError, match=said):
        PolynomialFunction.from_json(text)
