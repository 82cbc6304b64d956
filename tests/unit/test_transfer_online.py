"""The transfer function learnt on line: what it knows, what it leaves out, and what a file keeps of it."""

from __future__ import annotations

import json
import os
from math import inf
from pathlib import Path

import numpy as np
import pytest

from benchmarks.transfer_trials import CPI, DPI, simulate_trials
from pointpred.errors import EventError, ParameterError, RecordingError
from pointpred.events import PointerEvent
from pointpred.transfer import (
    Arctan,
    ConstantGain,
    HeldPolynomial,
    PixelTransfer,
    PolynomialFunction,
    PolynomialIdentifier,
    SigmoidGain,
    TransferFunction,
    TransferLearner,
    load_transfer,
    named_transfer,
    save_transfer,
)
from pointpred.transfer.curve import Bands, compare, fitted_constant, fitted_sigmoid

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


@pytest.mark.parametrize("function", [ConstantGain(3.0), SigmoidGain(2.0, 9.0, 0.1, 0.4), SMOOTH])
def test_a_file_keeps_the_function_and_its_resolutions(function: TransferFunction, tmp_path: Path) -> None:
    path = tmp_path / "function.json"
    save_transfer(path, function, cpi=1600.0, dpi=110.0)
    assert json.loads(path.read_text())["version"] == 1
    back = load_transfer(path)
    assert (back.cpi, back.dpi) == (1600.0, 110.0)
    speeds = np.linspace(0.0127, 0.31, 50)
    assert back.function.gain(speeds) == pytest.approx(function.gain(speeds), rel=1e-12)
    assert named_transfer(str(path)).cpi == 1600.0
    with pytest.raises(ParameterError, match="exists"):
        save_transfer(path, function)
    save_transfer(path, ConstantGain(1.0), replace=True)
    assert float(load_transfer(path).function.gain(0.1)) == 1.0
    assert os.listdir(tmp_path) == ["function.json"]  # noqa: PTH208


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("{", "truncated"),
        ("\x00", "malformed"),
        ('{"version": 2, "kind": "constant", "numbers": [1]}', "version must be 1"),
        ('{"version": 1, "kind": "constant", "numbers": []}', "expected 1 numbers, received 0"),
        ('{"version": 1, "kind": "sigmoid", "numbers": [1, 2, 3]}', "expected 4 numbers"),
        ('{"version": 1, "kind": "polynomial", "numbers": [0, 1]}', "needs speed_low"),
        ('{"version": 1, "kind": "constant", "numbers": [-1]}', "gain must lie"),
        ('{"version": 1, "kind": "constant", "numbers": [1], "cpi": -5}', "cpi and dpi"),
        ('{"version": 1, "kind": "constant", "numbers": [1], "more": 1}', "unknown field"),
        (" " * 70000, "longer than"),
    ],
)
def test_a_file_of_anything_else_is_refused_by_name(text: str, why: str, tmp_path: Path) -> None:
    path = tmp_path / "other.json"
    path.write_text(text)
    with pytest.raises(RecordingError, match=f"other.json: not a saved transfer function: .*{why}"):
        load_transfer(path)


def test_what_cannot_move_a_cursor_is_not_saved(tmp_path: Path) -> None:
    for function in (
        Arctan(),
        PolynomialFunction([0.0, 1.0]),
        PolynomialFunction([1.0, 1.0], speed_high=1.0),
    ):
        with pytest.raises(ParameterError):
            save_transfer(tmp_path / "function.json", function)
    assert list(tmp_path.iterdir()) == []


def test_words_name_a_function() -> None:
    assert float(named_transfer("constant:2.5").function.gain(0.1)) == 2.5
    assert named_transfer("sigmoid").function.slots.tolist() == SigmoidGain().slots.tolist()
    assert named_transfer("sigmoid:1,3,0.1,0.2").function.slots.tolist()[1:5] == [1.0, 3.0, 0.1, 0.2]
    for words in ("constant", "constant:x", "constant:1,2", "sigmoid:1", "curve", "no/such/file"):
        with pytest.raises(ParameterError, match="expected 'constant:GAIN', 'sigmoid'"):
            named_transfer(words)


def test_a_held_polynomial_stays_tame_beyond_its_range() -> None:
    wild = PolynomialFunction([0.0, 1.0, 20.0, -40.0, 0.0, -300.0], speed_low=0.02, speed_high=0.3)
    held = HeldPolynomial(wild)
    inside = np.linspace(0.02, 0.3, 30)
    assert held.gain(inside) == pytest.approx(wild.gain(inside), rel=1e-12)
    assert held.cursor_speed(inside) == pytest.approx(wild.cursor_speed(inside), rel=1e-12)
    assert held.gain([0.0, 2.0]).tolist() == pytest.approx([float(wild.gain(0.02)), float(wild.gain(0.3))])
    assert float(wild.gain(2.0)) < 0.0 < float(held.gain(2.0))
    forward = PixelTransfer(held, cpi=CPI, dpi=DPI).run(np.arange(3) / 1000, np.full(3, 400.0), np.zeros(3))
    assert (forward[:, 0] > 0.0).all()
    with pytest.raises(ParameterError, match="c_0 = 0 and order 1 to 5"):
        HeldPolynomial(PolynomialFunction([0.0] * 6 + [1.0], speed_high=1.0))
