"""Counts to whole pixels: nothing is lost but the fraction at a reversal; and the assisted function."""

import pickle
from math import exp, hypot

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred.errors import EventError, ParameterError
from pointpred.transfer import AssistedTransfer, ConstantGain, PixelTransfer, SigmoidGain, TransferFunction

CPI, DPI = 2000.0, 96.0
COUNTS = st.lists(st.tuples(st.integers(-40, 40), st.integers(-40, 40)), min_size=1, max_size=60)


def naive(function: TransferFunction, counts: list[tuple[int, int]], h: float) -> list[tuple[int, int]]:
    """The rule word for word, one axis at a time, without a flat memory."""
    rest, heading, moved = [0.0, 0.0], [0, 0], []
    for pair in counts:
        gain = float(function.gain(hypot(*pair) * 0.0254 / CPI / h))
        whole = []
        for axis, count in enumerate(pair):
            sign = (count > 0) - (count < 0)
            if sign and heading[axis] == -sign:
                rest[axis] = 0.0
            heading[axis] = sign or heading[axis]
            exact = rest[axis] + gain * DPI / CPI * count
            whole.append(int(exact))
            rest[axis] = exact - int(exact)
        moved.append((whole[0], whole[1]))
    return moved


@settings(deadline=None)
@given(COUNTS)
def test_it_is_the_rule_word_for_word(counts: list[tuple[int, int]]) -> None:
    h = 2.0**-10
    for function in (ConstantGain(4.0), SigmoidGain()):
        stage = PixelTransfer(function, cpi=CPI, dpi=DPI, period_s=h)
        found = [stage.update((i * h, float(dx), float(dy))) for i, (dx, dy) in enumerate(counts)]
        # A sum that ends within rounding of a whole pixel may fall on either side of it.
        ours, theirs = np.cumsum(found, axis=0), np.cumsum(naive(function, counts, h), axis=0)
        assert np.abs(ours - theirs).max() <= 1.0
        assert np.mean(ours != theirs) < 0.2


@settings(deadline=None)
@given(st.lists(st.integers(0, 30), min_size=1, max_size=300), st.sampled_from([-1.0, 1.0]))
def test_without_a_reversal_no_more_than_a_pixel_is_ever_owed(counts: list[int], sign: float) -> None:
    stage = PixelTransfer(ConstantGain(4.0), cpi=CPI, dpi=DPI)
    out = stage.run(np.arange(len(counts)) / 1000, sign * np.array(counts, np.float64), np.zeros(len(counts)))
    owed = np.cumsum(sign * np.array(counts)) * 4.0 * DPI / CPI - np.cumsum(out[:, 0])
    assert np.abs(owed).max() < 1.0 + 1e-9
    assert (out == np.trunc(out)).all()


def test_the_rest_is_dropped_when_one_axis_reverses_and_kept_on_the_other() -> None:
    stage = PixelTransfer(ConstantGain(1.0), cpi=100.0, dpi=60.0)  # 0.6 px a count
    assert stage.update((0.0, 1.0, 1.0)) == (0.0, 0.0)
    assert stage.update((0.1, 0.0, 0.0)) == (0.0, 0.0)
    assert stage.update((0.2, -1.0, 1.0)) == (0.0, 1.0)  # x would move if 0.6 were only reduced to 0
    assert stage.update((0.3, -1.0, 1.0)) == (-1.0, 0.0)  # -1.2; had +0.6 been kept, -0.6


def test_the_gain_is_that_of_both_axes_together_and_of_the_true_time() -> None:
    def pixels(h: float, dx: float, dy: float) -> tuple[float, float]:
        stage = PixelTransfer(SigmoidGain(), cpi=CPI, dpi=DPI)
        stage.update((0.0, 0.0, 0.0))
        return stage.update((h, dx, dy))

    expected = float(SigmoidGain().gain(50.0 * 0.0254 / CPI / 0.002)) * DPI / CPI
    assert pixels(0.002, 30.0, 40.0) == (int(30.0 * expected), int(40.0 * expected))
    assert pixels(0.001, 30.0, 40.0)[0] > pixels(0.002, 30.0, 40.0)[0]
    assert pixels(5.0, 3000.0, 0.0) == pixels(0.1, 3000.0, 0.0)


def test_rows_equal_reports_and_a_refused_one_is_named_and_changes_nothing() -> None:
    rng = np.random.default_rng(5)
    t, counts = np.cumsum(rng.uniform(0.0, 0.002, 200)), rng.integers(-9, 10, (200, 2)).astype(float)
    whole, single = (PixelTransfer(SigmoidGain(), cpi=CPI) for _ in range(2))
    table = whole.run(t, counts[:, 0], counts[:, 1])
    assert np.array_equal(table, [single.update((t[i], *counts[i])) for i in range(200)])
    before = single._memory.copy()
    with pytest.raises(EventError, match="not before"):
        single.update((0.0, 1.0, 1.0))
    with pytest.raises(EventError, match="row 1"):
        single.run(t[[199, 0]], counts[:2, 0], counts[:2, 1])
    with pytest.raises(EventError):
        single.update((9.0, np.nan, 1.0))
    assert np.array_equal(before, single._memory)
    twin = pickle.loads(pickle.dumps(single))
    assert twin.update((9.0, 7.0, 1.0)) == single.update((9.0, 7.0, 1.0))


def test_assistance_without_an_endpoint_or_without_rho_is_the_plain_function() -> None:
    rng = np.random.default_rng(6)
    plain = PixelTransfer(SigmoidGain(), cpi=CPI)
    silent, still = (
        AssistedTransfer(SigmoidGain(), cpi=CPI),
        AssistedTransfer(SigmoidGain(), cpi=CPI, rho=0.0),
    )
    for i, (dx, dy) in enumerate(rng.integers(-30, 31, (300, 2)).astype(float)):
        report = (i / 1000, dx, dy)
        wanted = plain.update(report)
        assert silent.update(report) == wanted
        assert still.update(report, (50.0, -3.0)) == wanted


def test_the_printed_term_draws_a_resting_cursor_exponentially() -> None:
    """x' = -rho (x - T) has the solution T (1 - exp(-rho t)), at any rate of reports."""
    for rate in (125.0, 1000.0):
        stage = AssistedTransfer(ConstantGain(), cpi=CPI, rho=3.0, strength=np.inf, period_s=1.0 / rate)
        x = 0.0
        for i in range(int(rate)):
            x += stage.update((i / rate, 0.0, 0.0), (900.0 - x, 0.0))[0]
        assert x == pytest.approx(900.0 * (1.0 - exp(-3.0)), abs=2.0)


def test_a_bounded_pull_rests_with_the_hand_and_never_beats_it() -> None:
    stage = AssistedTransfer(ConstantGain(), cpi=CPI, rho=50.0, strength=0.5)
    plain = PixelTransfer(ConstantGain(), cpi=CPI)
    assert all(stage.update((i / 1000, 0.0, 0.0), (500.0, 500.0)) == (0.0, 0.0) for i in range(100))
    x = y = 0.0
    for i in range(100, 400):  # the hand leaves a wrong endpoint on the other side
        step = stage.update((i / 1000, 20.0, 0.0), (-500.0 - x, -y))
        x, y = x + step[0], y + step[1]
    own = sum(plain.update((i / 1000, 20.0, 0.0))[0] for i in range(100, 400))
    assert x == pytest.approx(own / 2.0, abs=2.0)
    assert y == 0.0


def test_assisted_bounds_and_refusals() -> None:
    with pytest.raises(ParameterError, match="rho"):
        AssistedTransfer(ConstantGain(), cpi=CPI, rho=-1.0)
    stage = AssistedTransfer(ConstantGain(), cpi=CPI)
    stage.update((1.0, 3.0, 1.0), (5.0, 5.0))
    before = stage._memory.copy()
    for report, off in (
        ((0.5, 1.0, 1.0), None),
        ((2.0, np.inf, 1.0), None),
        ((2.0, 1.0, 1.0), (np.inf, 0.0)),
    ):
        with pytest.raises(EventError):
            stage.update(report, off)
    assert np.array_equal(before, stage._memory)
