"""The transfer function learnt on line: what it knows, what it leaves out, and what a file keeps of it."""

from __future__ import annotations

from math import inf
from typing import Literal

import numpy as np
import pytest

from pointpred.errors import EventError, ParameterError
from pointpred.records import PointerEvent
from pointpred.reproduction.transfer_functions import CPI, DPI, simulate_trials
from pointpred.transfer import (
    ConstantGain,
    PolynomialFunction,
    PolynomialIdentifier,
    SigmoidGain,
    TransferFunction,
    TransferLearner,
)
from pointpred.transfer.bands import Bands
from pointpred.transfer.curve import compare, fitted_constant, fitted_sigmoid

COUNTS = CPI / 0.0254
SMOOTH = PolynomialFunction([0.0, 1.0, 20.0, -40.0], speed_low=0.0127, speed_high=0.31)


def moves(
    function: TransferFunction, seconds: float, t0: float = 0.0, top: float = 0.3
) -> list[PointerEvent]:
    """A curved path without rounding through a function; the hand's speed runs over 0 ... ``top`` m/s."""
    t = np.arange(1, int(seconds * 1000)) / 1000
    speed, angle = 0.5 * top * (1.0 - np.cos(3.0 * t)), 2.0 * np.sin(t)
    heading = np.column_stack([np.cos(angle), np.sin(angle)]) * 0.001
    counts = heading * (speed * COUNTS)[:, None]
    place = 900.0 + np.cumsum(heading * (function.cursor_speed(speed) * DPI / 0.0254)[:, None], axis=0)
    rows = np.column_stack([t0 + t, place, counts])
    return [PointerEvent(*row) for row in rows.tolist()]


def learnt(function: TransferFunction, **settings: object) -> TransferLearner:
    learner = TransferLearner(cpi=CPI, dpi=DPI, **settings)
    for event in moves(function, 6.0):
        learner.update(event)
    return learner


def test_the_curve_is_the_function_over_the_speeds_that_were_shown() -> None:
    learner = TransferLearner(cpi=CPI, dpi=DPI)
    assert learner.curve().excited is None
    assert learner.curve().words == "nothing learnt yet: move the mouse"
    for event in moves(SMOOTH, 6.0, top=0.2):
        learner.update(event)
    curve = learner.curve()
    assert curve.excited is not None
    assert curve.excited[0] == pytest.approx(0.0127, abs=0.016)
    assert curve.excited[1] == pytest.approx(0.2, abs=0.016)
    assert (curve.speeds[0], curve.speeds[-1]) == pytest.approx(curve.excited)
    assert curve.gains == pytest.approx(SMOOTH.gain(curve.speeds).tolist(), rel=1e-3)
    assert curve.measured_gains == pytest.approx(SMOOTH.gain(curve.measured_speeds).tolist(), rel=0.01)
    assert (curve.closest, curve.edges, curve.fast, curve.skipped) == ("polynomial", 0, 0, 1)


def test_one_speed_alone_is_not_a_curve_and_says_which_powers_lack() -> None:
    learner = TransferLearner(cpi=CPI, dpi=DPI)
    for i in range(400):
        learner.update(PointerEvent(0.001 * i, 2.0 * i, 0.0, 8.0, 0.0))
    curve = learner.curve()
    assert curve.speeds == []
    assert "2, 3, 4, 5" in curve.words
    assert curve.compared[0].parameters["gain"] == pytest.approx(2.0 * CPI / DPI / 8.0)


@pytest.mark.parametrize(("truth", "kind"), [(ConstantGain(4.0), "constant"), (SigmoidGain(), "sigmoid")])
def test_the_kinds_are_told_apart_and_their_numbers_found(truth: TransferFunction, kind: str) -> None:
    learner = TransferLearner(cpi=CPI, dpi=DPI)
    for trial in simulate_trials(truth, 7, 24):
        learner.reset()
        for event in trial.events():
            learner.update(event)
    curve = learner.curve()
    assert curve.closest == kind
    told = {each.kind: each for each in curve.compared}[curve.closest]
    if kind == "constant":
        assert told.parameters["gain"] == pytest.approx(4.0, rel=0.01)
    else:
        assert told.parameters["gain_min"] == pytest.approx(1.0, rel=0.05)
        assert told.parameters["speed_low"] == pytest.approx(0.05, abs=0.005)
    assert told.gains == pytest.approx(truth.gain(curve.speeds).tolist(), rel=0.04)


def test_fitted_numbers_are_those_of_exact_gains() -> None:
    speeds = np.linspace(0.02, 0.7, 18)
    exact = Bands(speeds, SigmoidGain().gain(speeds), np.full(18, 1e-6))
    found = fitted_sigmoid(exact)
    assert found is not None
    wanted = {"gain_min": 1.0, "gain_max": 15.0, "speed_low": 0.05, "speed_high": 0.6}
    assert found == pytest.approx(wanted, rel=1e-3)
    assert fitted_constant(Bands(speeds, np.full(18, 3.0), np.full(18, 0.1))) == pytest.approx(3.0)
    mixed = Bands(speeds, speeds + 0.3, np.linspace(0.001, 0.02, 18))
    gains = np.linspace(0.4, 0.8, 4001)
    cost = (mixed.trust * (gains[:, None] / mixed.gains - 1.0) ** 2).sum(axis=1)
    assert fitted_constant(mixed) == pytest.approx(gains[cost.argmin()], abs=1e-4)
    few = Bands(speeds[:3], np.ones(3), np.zeros(3))
    assert fitted_sigmoid(few) is None
    assert [each.kind for each in compare(few, None, speeds)] == ["constant"]
    assert compare(Bands(speeds, np.ones(18), np.ones(18)), None, speeds) == []


def test_the_screen_s_edge_teaches_nothing() -> None:
    width, height = 1000, 1200
    clipped = [
        PointerEvent(e.t, min(max(e.x, 0.0), width - 1.0), min(max(e.y, 0.0), height - 1.0), e.dx, e.dy)
        for e in moves(ConstantGain(4.0), 12.0)
    ]
    naive, careful = (
        TransferLearner(cpi=CPI, dpi=DPI),
        TransferLearner(cpi=CPI, dpi=DPI, size=(width, height)),
    )
    for event in clipped:
        naive.update(event)
        careful.update(event)
    careful.reset()
    assert careful.edges == sum(not (0 < e.x < width - 1 and 0 < e.y < height - 1) for e in clipped) > 100
    assert careful.curve().edges == careful.edges
    assert careful.curve().gains == pytest.approx([4.0] * 41, rel=1e-6)
    assert np.abs(np.array(naive.curve().gains) / 4.0 - 1.0).max() > 0.2


def test_reports_that_waited_together_and_leaps_do_not_spoil_it() -> None:
    """Every 50th report waits for the next: its stamp is 20 us before it; now and then the hand leaps."""
    learner = TransferLearner(cpi=CPI, dpi=DPI)
    events = [
        PointerEvent(e.t + (0.00098 if i % 50 == 0 else 0.0), e.x, e.y, e.dx, e.dy)
        for i, e in enumerate(moves(SMOOTH, 6.0))
    ]
    events.append(PointerEvent(events[-1].t + 0.001, 0.0, 0.0, 5000.0, 0.0))
    for event in events:
        learner.update(event)
    learner.reset()
    curve = learner.curve()
    assert curve.fast == 1
    assert curve.gains == pytest.approx(SMOOTH.gain(curve.speeds).tolist(), rel=0.02)
    plain = PolynomialIdentifier(cpi=CPI, dpi=DPI, window_s=0.01)
    for event in events:
        plain.update(event)
    found = plain.identify().function
    assert found is None or np.abs(found.gain(curve.speeds) / SMOOTH.gain(curve.speeds) - 1.0).max() > 0.02


@pytest.mark.parametrize(("noise_px", "weighting"), [(20.0, "samples"), (0.0, "gain")])
def test_bands_are_weighed_once_they_are_known(
    noise_px: float, weighting: Literal["samples", "gain"]
) -> None:
    learner, rng = TransferLearner(cpi=CPI, dpi=DPI), np.random.default_rng(5)
    for trial in simulate_trials(SigmoidGain(), 7, 12):
        learner.reset()
        for e in trial.events():
            x, y = (e.x, e.y) + noise_px * rng.standard_normal(2)
            learner.update(PointerEvent(e.t, x, y, e.dx, e.dy))
    found, wanted = (each.function for each in (learner.identify(), learner._identifier.identify(weighting)))
    assert found is not None
    assert wanted is not None
    assert found.coefficients == wanted.coefficients


def test_a_changed_setting_shows_after_a_while() -> None:
    learner = TransferLearner(cpi=CPI, dpi=DPI, forgetting=0.99)
    for event in [*moves(ConstantGain(2.0), 6.0), *moves(ConstantGain(4.0), 40.0, t0=10.0)]:
        learner.update(event)
    assert learner.curve().gains == pytest.approx([4.0] * 41, rel=0.02)


def test_it_obeys_the_laws_of_a_stage() -> None:
    learner = learnt(SMOOTH)
    before = learner.curve()
    for wrong in (
        PointerEvent(0.001, 1.0, 1.0, 1.0, 1.0),
        PointerEvent(9.0, 1.0, 1.0),
        PointerEvent(9.0, float("nan"), 1.0, 1.0, 1.0),
        PointerEvent(inf, 1.0, 1.0, 1.0, 1.0),
    ):
        with pytest.raises(EventError):
            learner.update(wrong)
    assert learner.curve() == before
    learner.reset()
    after = learner.curve()  # what was learnt stays
    assert after.samples >= before.samples > 500
    assert after.gains == pytest.approx(before.gains, rel=1e-9)
    assert learner.fresh().curve().samples == 0
    learner.forget()
    assert learner.curve() == learner.fresh().curve()
    with pytest.raises(ParameterError, match="spacing_s"):
        TransferLearner(spacing_s=0.2)
