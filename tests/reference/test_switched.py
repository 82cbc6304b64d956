"""The switched predictor against the thesis's own claims and a second, plain implementation."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from pointpred.predictors.switched import SwitchedPredictor
from pointpred.records import FloatArray, MotionColumns


def motions(t: FloatArray, x: FloatArray, v: FloatArray, a: FloatArray) -> MotionColumns:
    """Exact motions along the x axis; y stays."""
    table = np.zeros((len(t), 10))
    table[:, 0], table[:, 1], table[:, 3], table[:, 5] = t, x, v, a
    table[:, 2] = 50.0
    table[:, 7] = 1.0
    table[0, 8] = 1.0
    return MotionColumns(table)


def endpoints(predictor: SwitchedPredictor, columns: MotionColumns) -> FloatArray:
    return predictor.run(columns, np.zeros(len(columns), np.bool_)).x


def minimum_jerk(amplitude: float, gain: float) -> tuple[FloatArray, ...]:
    """Position in px, velocity and acceleration of the hand, of Hogan's law over one second."""
    t = np.linspace(0.0, 1.0, 2001)
    x = amplitude * (10 * t**3 - 15 * t**4 + 6 * t**5)
    v = amplitude / gain * (30 * t**2 - 60 * t**3 + 30 * t**4)
    a = amplitude / gain * (60 * t - 180 * t**2 + 120 * t**3)
    return t, x, v, a


def test_hogans_law_is_predicted_exactly_at_the_peak() -> None:
    """Figure 2.11: the ballistic estimate of a minimum-jerk reach is exact half way."""
    t, x, v, a = minimum_jerk(400.0, 2000.0)
    ends = endpoints(SwitchedPredictor(), motions(t, 100.0 + x, v, a))
    assert ends[1000] == pytest.approx(500.0, abs=1e-9)
    assert ends[700] == pytest.approx(100.0 + 2 * x[700], abs=1e-9)


def test_the_ballistic_law_is_predicted_exactly_at_the_peak_and_then_held() -> None:
    """Section 2.4.2: x = T/2 (1 - cos(eta t)) has its peak at T/2; until V < peak / 5 the endpoint holds."""
    t = np.linspace(0.0, 1.0, 1001)
    x, v = -300.0 * (1 - np.cos(np.pi * t)), -0.1 * np.sin(np.pi * t)
    ends = endpoints(SwitchedPredictor(), motions(t, x, v, -0.1 * np.pi * np.cos(np.pi * t)))
    held = (t > 0.5) & (np.abs(v) > 0.02 * 1.001)
    np.testing.assert_allclose(ends[held], -600.0, atol=1e-2)


def approach(b1: float, b2: float, target: float, x0: float) -> tuple[FloatArray, ...]:
    """The corrective model V' = -b1 V - b2 (x - T), x' = 2000 px/m V, solved by scipy."""

    def slope(_: float, state: NDArray[np.float64]) -> list[float]:
        x, v = state
        return [2000.0 * v, -b1 * v - b2 * (x - target)]

    t = np.linspace(0.0, 1.5, 1501)
    solved = solve_ivp(slope, (0.0, 1.5), [x0, 0.0], t_eval=t, rtol=1e-10, atol=1e-12)
    x, v = solved.y
    return t, x, v, -b1 * v - b2 * (x - target)


def test_the_corrective_phase_finds_the_end_before_it_is_reached() -> None:
    """Section 2.5.4 on its own model; the threshold 1 makes every sample corrective."""
    t, x, v, a = approach(12.0, 0.018, 200.0, 0.0)
    predictor = SwitchedPredictor(threshold=1.0, bound=10.0, gamma=1e9, delay_s=0.05)
    ends = endpoints(predictor, motions(t, x, v, a))
    early = 400  # 0.4 s: the cursor still has a seventh of the way to go
    assert abs(x[early] - 200.0) > 25.0
    assert ends[early] == pytest.approx(200.0, abs=2.0)


PARAMETERS = {"threshold": 0.35, "bound": 0.1, "delay_s": 0.1, "gamma": 3e3}


def plain(columns: MotionColumns, predictor: dict[str, float], axis: int = 0) -> list[float]:
    """The thesis's figure 2.4 for one axis, with numpy matrices and whole histories: a second method."""
    rows = columns.table
    times, history = [], []
    end, peak, ends, scale = 0.0, 0.0, [], np.zeros(3)
    for now in range(len(rows)):
        t, x = rows[now, 0], rows[now, 1 + axis] - rows[0, 1 + axis]
        v, a = rows[now, 3 + axis], rows[now, 5 + axis]
        times.append(t)
        history.append([-a, -v, 1.0, x])
        scale = np.maximum(scale, np.abs(history[-1][:3]))
        peak = max(peak, abs(v))
        before = history[-2][3] if now else 0.0
        if abs(v) < predictor["threshold"] * peak:
            candidate = corrected(np.array(times), np.array(history), scale, end, predictor)
            if candidate is not None and abs(candidate - end) < predictor["bound"] * abs(x):
                end = candidate
        elif a * v >= 0:
            end += 2 * (x - before)
        ends.append(end + rows[0, 1 + axis])
    return ends


def corrected(
    t: FloatArray, history: FloatArray, scale: FloatArray, end: float, predictor: dict[str, float]
) -> float | None:
    """One step of DREM with delays 0, tau, 2 tau by interpolation, cofactors and the exact exponential."""
    delays = predictor["delay_s"] * np.arange(3)
    if t[-1] - delays[-1] < t[0]:
        return None
    rows = np.array([[np.interp(t[-1] - d, t, history[:, j]) for j in range(4)] for d in delays])
    phi_matrix, y = rows[:, :3] / scale, rows[:, 3]
    norms = np.linalg.norm(phi_matrix, axis=1)
    phi_matrix, y = phi_matrix / norms[:, None], y / norms
    phi = float(np.linalg.det(phi_matrix))
    replaced = phi_matrix.copy()
    replaced[:, 2] = y
    if phi == 0.0:
        return end
    decay = np.exp(-predictor["gamma"] * phi**2 * (t[-1] - t[-2]))
    return float(end + (1 - decay) * (np.linalg.det(replaced) / phi / scale[2] - end))


def test_a_plain_implementation_of_figure_2_4_agrees() -> None:
    """A reach with an overshoot and a correction, sampled slower than the ring thins (delay / 64)."""
    t = np.arange(0.0, 1.6, 0.008)
    x = 500 * np.clip(t / 0.7, 0, 1) ** 2 * (3 - 2 * np.clip(t / 0.7, 0, 1))
    x -= 25 * np.clip((t - 0.7) / 0.5, 0, 1) ** 2 * (3 - 2 * np.clip((t - 0.7) / 0.5, 0, 1))
    v = np.gradient(x, t) / 2000
    columns = motions(t, 100 + x, v, np.gradient(v, t))
    ours = endpoints(SwitchedPredictor(**PARAMETERS), columns)
    np.testing.assert_allclose(ours, plain(columns, PARAMETERS), rtol=1e-7, atol=1e-6)
    assert len(np.unique(np.round(ours[t > 0.7], 3))) > 20  # the corrective phase was really visited


def glide(t: FloatArray, start: float, stop: float) -> FloatArray:
    """From 0 to 1 between two times."""
    s = np.clip((t - start) / (stop - start), 0.0, 1.0)
    return s**2 * (3 - 2 * s)


def diagonal() -> MotionColumns:
    """Both axes reach and correct, each in its own time; x reaches once more while y corrects."""
    t = np.arange(0.0, 1.6, 0.008)
    table = np.zeros((len(t), 10))
    table[:, 0], table[0, 8], table[:, 7] = t, 1.0, 1.0
    x = 500 * glide(t, 0.0, 0.7) - 25 * glide(t, 0.7, 1.2) + 150 * glide(t, 1.2, 1.6)
    y = -220 * glide(t, 0.1, 1.0) + 30 * glide(t, 1.0, 1.4)
    for axis, (origin, place) in enumerate(((100.0, x), (-40.0, y))):
        v = np.gradient(place, t) / 2000
        table[:, 1 + axis], table[:, 3 + axis], table[:, 5 + axis] = origin + place, v, np.gradient(v, t)
    return MotionColumns(table)


def corrective(columns: MotionColumns) -> NDArray[np.bool_]:
    """Rows in which each axis is below its threshold, in two columns."""
    speed = np.abs(columns.table[:, 3:5])
    below: NDArray[np.bool_] = speed < PARAMETERS["threshold"] * np.maximum.accumulate(speed)
    return below


def test_each_axis_of_a_diagonal_movement_has_its_own_phase() -> None:
    """Remark 2.5.1, against the plain implementation run for one axis at a time."""
    columns = diagonal()
    phases = corrective(columns)
    assert np.count_nonzero(phases[:, 0] & ~phases[:, 1]) > 20
    assert np.count_nonzero(~phases[:, 0] & phases[:, 1]) > 5
    answers = SwitchedPredictor(**PARAMETERS).run(columns, np.zeros(len(columns), np.bool_))
    for axis, ours in enumerate((answers.x, answers.y)):
        np.testing.assert_allclose(ours, plain(columns, PARAMETERS, axis), rtol=1e-7, atol=1e-6)
        assert len(np.unique(np.round(ours[phases[:, axis]], 3))) > 20  # the regression has a say


def test_an_axis_does_not_hear_of_the_other() -> None:
    both = diagonal().table
    for axis in (0, 1):
        alone = both.copy()
        alone[:, [2 - axis, 4 - axis, 6 - axis]] = 0.0
        begin = np.zeros(len(both), np.bool_)
        one = SwitchedPredictor(**PARAMETERS).run(MotionColumns(alone), begin).table
        two = SwitchedPredictor(**PARAMETERS).run(MotionColumns(both), begin).table
        assert np.array_equal(one[:, 1 + axis], two[:, 1 + axis])


def test_a_step_larger_than_the_bound_is_refused() -> None:
    """Section 2.5.4: with bound 0 the corrective phase changes nothing."""
    t, x, v, a = approach(12.0, 0.018, 200.0, 0.0)
    ends = endpoints(SwitchedPredictor(threshold=1.0, bound=0.0, gamma=1e9), motions(t, x, v, a))
    peak = int(np.abs(v).argmax())
    later = [end for end, slow in zip(ends, np.abs(v) < np.abs(v).max(), strict=True) if slow]
    assert len({round(end, 9) for end in later[peak:]}) == 1


def test_turning_back_lowers_the_endpoint() -> None:
    """Section 2.5.6: an overshoot (dx < 0 while a V >= 0) takes twice its way off the estimate."""
    t = np.linspace(0.0, 0.2, 201)
    x = np.concatenate([np.linspace(0, 100, 101), np.linspace(100, 60, 101)[1:]])
    v = np.concatenate([np.full(101, 0.2), np.full(100, -0.2)])
    ends = endpoints(SwitchedPredictor(), motions(t, x, v, np.zeros(201)))
    assert ends[100] == pytest.approx(200.0)
    assert ends[200] == pytest.approx(120.0)
    assert all(later <= earlier for earlier, later in pairwise(ends[100:]))
