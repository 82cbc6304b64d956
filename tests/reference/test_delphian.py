"""The Delphian predictor against movements that obey a known line exactly."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, Motion, build
from pointpred.errors import ParameterError
from pointpred.predictors import DelphianPredictor, fit_line
from pointpred.recording import Recording, Trial
from pointpred.records import FloatArray, MotionColumns

SLOPE, OFFSET = 400.0, 60.0
PX_PER_M = 96.0 / 0.0254


def movement(peak_m_s: float, direction: float, rate_hz: float = 500.0) -> tuple[MotionColumns, FloatArray]:
    """A reach whose speed is a half sine and whose way left at its peak lies on the line; and its end."""
    left = SLOPE * peak_m_s + OFFSET
    seconds = np.pi * left / (peak_m_s * PX_PER_M)  # half of the way is peak * seconds / pi
    t = np.arange(0.0, seconds, 1.0 / rate_hz)
    unit = np.array([np.cos(direction), np.sin(direction)])
    table = np.zeros((len(t), 10))
    table[:, 0] = t
    table[:, 1:3] = 50.0 + np.outer(left * (1.0 - np.cos(np.pi * t / seconds)), unit)
    table[:, 3:5] = np.outer(peak_m_s * np.sin(np.pi * t / seconds), unit)
    table[0, 8] = 1.0
    return MotionColumns(table), 50.0 + 2.0 * left * unit


def answers(motions: MotionColumns, **settings: float) -> FloatArray:
    predictor = DelphianPredictor(slope_px_s_m=SLOPE, offset_px=OFFSET, **settings)
    return predictor.run(motions, np.zeros(len(motions), np.bool_)).table


@pytest.mark.parametrize("peak", [0.05, 0.3, 1.2])
@pytest.mark.parametrize("direction", [0.0, 2.0, -2.5])
def test_on_the_line_the_endpoint_is_right_from_the_peak_on_and_nothing_is_said_before(
    peak: float, direction: float
) -> None:
    motions, end = movement(peak, direction)
    table = answers(motions)
    said = ~np.isnan(table[:, 1])
    assert not said[: len(said) // 2].any()
    first = int(said.argmax())
    assert said[first:].all()
    speed = np.hypot(motions.vx, motions.vy) / peak
    assert speed[first] < 0.95 <= speed[first - 1]
    step = np.abs(np.diff(motions.table[:, 1:3], axis=0)).max()
    assert np.abs(table[first:, 1:3] - end).max() < step


def test_a_higher_peak_takes_the_answer_back_and_gives_a_new_one() -> None:
    low, high = 0.2, 0.4
    speeds = [0.0, low, 0.1, high, 0.3, 0.1]
    predictor = DelphianPredictor(slope_px_s_m=SLOPE, offset_px=OFFSET)
    found = []
    for i, speed in enumerate(speeds):
        prediction = predictor.update(
            Motion(0.1 * i, 20.0 * i, 0.0, speed, 0.0, 0.0, 0.0, True, start=i == 0)
        )
        found.append(prediction and round(prediction.x, 9))
    after = 60.0 + SLOPE * high + OFFSET
    assert found == [None, None, 20.0 + SLOPE * low + OFFSET, None, after, after]


def test_a_fall_within_the_margin_is_no_peak() -> None:
    predictor = DelphianPredictor(fall=0.5)
    for i, speed in enumerate([0.0, 0.4, 0.21]):
        assert predictor.update(Motion(0.1 * i, 20.0 * i, 0.0, speed, 0.0, 0.0, 0.0, True)) is None
    assert predictor.update(Motion(0.3, 60.0, 0.0, 0.19, 0.0, 0.0, 0.0, True)) is not None


def test_it_never_points_back() -> None:
    predictor = DelphianPredictor(slope_px_s_m=0.0, offset_px=-500.0)
    for i, speed in enumerate([0.0, 0.4, 0.1]):
        prediction = predictor.update(Motion(0.1 * i, 20.0 * i, 0.0, speed, 0.0, 0.0, 0.0, True))
    assert prediction is not None
    assert (prediction.x, prediction.y) == (20.0, 0.0)


def test_the_fit_finds_the_line_of_a_person() -> None:
    peaks = np.linspace(0.1, 0.8, 15)
    parts = []
    for k, peak in enumerate(peaks):
        motions, end = movement(float(peak), 0.4 * k, 1000.0)
        table = np.vstack([motions.table[:, :3], [motions.t[-1] + 1e-3, *end]])
        parts.append(EventColumns.of(table[:, 0], table[:, 1], table[:, 2]))
    recording = Recording.of("ann", parts, [Trial("ann", str(k)) for k in range(len(peaks))])
    exact = build("hold", differentiator="difference").differentiator
    slope, offset = fit_line(recording, exact)
    assert slope == pytest.approx(SLOPE, rel=0.03)
    assert offset == pytest.approx(OFFSET, abs=8.0)
    with pytest.raises(ParameterError, match="at least 2 different peak speeds, received 0"):
        fit_line(Recording.of("none", [], []), exact)


def test_parameters_keep_their_bounds() -> None:
    for parameter in DelphianPredictor.parameters:
        for value in (parameter.low - 1.0, 2.0 * parameter.high, float("nan")):
            with pytest.raises(ParameterError, match=parameter.name):
                DelphianPredictor(**{parameter.name: value})
