"""What all baseline predictors owe a caller, fed with motions directly."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred import Motion
from pointpred.errors import EventError, ParameterError
from pointpred.predictors import (
    KalmanPredictor,
    KinematicEndpointPredictor,
    LinearPredictor,
    MinimumJerkPredictor,
    Predictor,
)
from pointpred.records import FloatArray, MotionColumns

MAKERS: dict[str, Callable[[], Predictor]] = {
    "linear": LinearPredictor,
    "kalman": KalmanPredictor,
    "minimum-jerk": MinimumJerkPredictor,
    "kep 2": lambda: KinematicEndpointPredictor(degree=2),
    "kep 4": KinematicEndpointPredictor,
    "kep 4 gated": lambda: KinematicEndpointPredictor(change_most=0.02),
}
EVERY = pytest.mark.parametrize("name", list(MAKERS))
PX_PER_M = 3000.0


def columns(t: FloatArray, place: FloatArray, velocity: FloatArray) -> MotionColumns:
    """Motions with the given positions (px) and velocities (m/s), the first a start."""
    table = np.zeros((len(t), 10))
    table[:, 0], table[:, 1:3], table[:, 3:5] = t, place, velocity
    table[:, 7] = 1.0
    table[0, 8] = 1.0
    return MotionColumns(table)


def reach(count: int = 60, noise: float = 0.3, seed: int = 1) -> MotionColumns:
    """A minimum-jerk reach of (300, -400) px in 0.6 s, 80 % of it, with noisy speeds."""
    random = np.random.default_rng(seed)
    t = 0.6 * np.sort(random.uniform(0.0, 0.8, count))
    s = t / 0.6
    way, speed = 10 * s**3 - 15 * s**4 + 6 * s**5, (30 * s**2 - 60 * s**3 + 30 * s**4) / 0.6
    place = np.outer(way, [300.0, -400.0])
    velocity = np.outer(speed, [300.0, -400.0]) / PX_PER_M
    return columns(t, place, velocity * (1.0 + 0.1 * noise * random.standard_normal((count, 1))))


def answers(name: str, motions: MotionColumns) -> FloatArray:
    return MAKERS[name]().run(motions, np.zeros(len(motions), np.bool_)).table


def moved(motions: MotionColumns, matrix: FloatArray, shift: FloatArray) -> MotionColumns:
    table = motions.table.copy()
    table[:, 1:3] = table[:, 1:3] @ matrix.T + shift
    table[:, 3:5] = table[:, 3:5] @ matrix.T
    return MotionColumns(table)


def agree(left: FloatArray, right: FloatArray) -> None:
    """The same answers; where a zero is barely there rounding decides: in one row at most."""
    unlike = np.isnan(left[:, 1]) != np.isnan(right[:, 1])
    assert unlike.sum() <= 1
    np.testing.assert_allclose(left[~unlike], right[~unlike], rtol=1e-6, atol=1e-5)


@EVERY
@given(angle=st.floats(0.0, 6.3), mirror=st.sampled_from([-1.0, 1.0]), seed=st.integers(0, 99))
@settings(max_examples=25, deadline=None, derandomize=True)
def test_turning_and_mirroring_the_screen_turns_the_endpoints(
    name: str, angle: float, mirror: float, seed: int
) -> None:
    matrix = np.array([[np.cos(angle), -mirror * np.sin(angle)], [np.sin(angle), mirror * np.cos(angle)]])
    motions = reach(seed=seed)
    expected = answers(name, motions)
    expected[:, 1:3] = expected[:, 1:3] @ matrix.T
    agree(answers(name, moved(motions, matrix, np.zeros(2))), expected)


@EVERY
@given(x=st.integers(-5000, 5000), y=st.integers(-5000, 5000))
@settings(max_examples=15, deadline=None)
def test_shifting_the_screen_shifts_the_endpoints(name: str, x: int, y: int) -> None:
    motions = reach()
    motions.table[:, 1:3] = np.round(motions.table[:, 1:3])
    shift = np.array([float(x), float(y)])
    expected = answers(name, motions)
    expected[:, 1:3] += shift
    agree(answers(name, moved(motions, np.eye(2), shift)), expected)


@pytest.mark.parametrize("name", [name for name in MAKERS if name != "kalman"])
@pytest.mark.parametrize("factor", [1 / 16, 3.0, 64.0])
def test_enlarging_the_screen_enlarges_the_predictions(name: str, factor: float) -> None:
    """The Kalman filter alone knows px: its noise does."""
    motions = reach()
    larger = motions.table.copy()
    larger[:, 1:3] *= factor
    expected = answers(name, motions)
    expected[:, 1:3] *= factor
    agree(answers(name, MotionColumns(larger)), expected)


@EVERY
@pytest.mark.parametrize(
    "bad",
    [
        {"t": float("nan")},
        {"t": 0.1},
        {"x": float("inf")},
        {"y": float("nan")},
        {"vx": float("nan")},
        {"vy": float("-inf")},
    ],
)
def test_a_refused_motion_leaves_the_memory_as_it_was(name: str, bad: dict[str, float]) -> None:
    predictor = MAKERS[name]()
    for motion in list(reach().motions())[:40]:
        predictor.update(motion)
    before = predictor._memory.tobytes()
    good = {"t": 9.0, "x": 0.0, "y": 0.0, "vx": 0.0, "vy": 0.0, "ax": 0.0, "ay": 0.0}
    with pytest.raises(EventError, match="must be finite and not before"):
        predictor.update(Motion(**{**good, **bad}, settled=True))
    assert predictor._memory.tobytes() == before


@EVERY
def test_a_still_cursor_is_predicted_to_stay_or_not_at_all(name: str) -> None:
    t = np.arange(200) / 125.0
    table = answers(name, columns(t, np.full((200, 2), 7.0), np.zeros((200, 2))))
    given_rows = table[~np.isnan(table[:, 1])]
    np.testing.assert_allclose(given_rows[:, 1:3], 7.0, atol=1e-9)
    assert (table[:, 7] == 0.0).all()


@EVERY
def test_long_wandering_stays_finite_and_bounded(name: str) -> None:
    """10^5 motions of one movement: back and forth, standstills, equal times, bursts."""
    random = np.random.default_rng(6)
    count = 100_000
    t = np.cumsum(random.choice([0.0, 1e-6, 0.001, 0.008, 0.2], count))
    step = random.standard_normal((count, 2)) * random.choice([0.0, 1.0, 50.0], (count, 1))
    place = 400.0 * np.sin(np.cumsum(step, axis=0) / 400.0)
    table = answers(name, columns(t, place, random.standard_normal((count, 2)) * 0.2))
    answered = ~np.isnan(table[:, 1])
    assert not np.isinf(table).any()
    assert np.isin(table[:, 7], (0.0, 1.0, 2.0)).all()
    travelled = np.abs(np.diff(place, axis=0)).sum()
    assert (np.abs(table[answered, 1:3]) <= 400.0 + 10.0 * travelled).all()


@pytest.mark.parametrize("predictor", [LinearPredictor, KalmanPredictor, KinematicEndpointPredictor])
def test_parameters_keep_their_bounds(predictor: type[Predictor]) -> None:
    for parameter in predictor.parameters:
        for value in (parameter.low, parameter.high):
            predictor(**{parameter.name: value})
        for value in (parameter.low - 1e-4, 2.0 * parameter.high, float("nan"), "1"):
            with pytest.raises(ParameterError, match=parameter.name):
                predictor(**{parameter.name: value})
    with pytest.raises(ParameterError, match="whole number"):
        KinematicEndpointPredictor(degree=2.5)  # type: ignore[arg-type]
