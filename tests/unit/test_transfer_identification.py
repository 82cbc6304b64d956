"""Identification where the answer is known exactly, its refusals, and the cursor's corrected speed."""

import pickle

import numpy as np
import pytest

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.errors import EventError, ParameterError
from pointpred.records import EventColumns, PointerEvent
from pointpred.transfer import PolynomialFunction, PolynomialIdentifier, differentiated_speeds, euler_speeds

TRUTH = PolynomialFunction([0.0, 1.0, 20.0, -40.0, 100.0, -150.0])
CPI, DPI = 2000.0, 96.0
SPEEDS = np.linspace(0.0127, 0.3, 200)


def exact_events(turning: float = 2.0) -> EventColumns:
    """A curved path through TRUTH without any rounding; the speed runs over 0 ... 0.31 m/s."""
    t = np.cumsum(np.full(6000, 0.001))
    speed, angle = 0.155 * (1.0 - np.cos(3.0 * t)), turning * np.sin(t)
    heading = np.column_stack([np.cos(angle), np.sin(angle)])
    counts = heading * (speed * 0.001 * CPI / 0.0254)[:, None]
    steps = heading * (TRUTH.cursor_speed(speed) * 0.001 * DPI / 0.0254)[:, None]
    x, y = np.cumsum(steps, axis=0).T
    return EventColumns.of(t, x, y, counts[:, 0], counts[:, 1])


@pytest.mark.parametrize("weighting", ["samples", "gain"])
@pytest.mark.parametrize("window_s", [0.001, 0.005, 0.03])
def test_a_polynomial_is_found_again_from_displacements(weighting: str, window_s: float) -> None:
    identifier = PolynomialIdentifier(window_s=window_s)
    identifier.run(exact_events())
    found = identifier.identify(weighting)  # type: ignore[arg-type]
    assert found.function is not None
    assert found.function.gain(SPEEDS) == pytest.approx(TRUTH.gain(SPEEDS), rel=1e-6)
    assert found.skipped == 1
    assert found.residual < 1e-9


@pytest.mark.parametrize("offset", [False, True])
def test_pairs_of_speeds_are_the_thesis_s_recursion(offset: bool) -> None:
    rng = np.random.default_rng(4)
    motor = rng.uniform(0.01, 0.3, 500)
    cursor = TRUTH.cursor_speed(motor) + 0.05 + 0.01 * rng.standard_normal(500)
    identifier = PolynomialIdentifier(offset=offset, forgetting=0.995)
    for pair in zip(motor.tolist(), cursor.tolist(), strict=True):
        identifier.learn(*pair)
    root = np.sqrt(0.995 ** np.arange(499, -1, -1.0))
    rows = motor[:, None] ** np.arange(0 if offset else 1, 6)
    wanted = np.linalg.lstsq(rows * root[:, None], cursor * root, rcond=None)[0]
    found = identifier.identify("samples").function
    assert found is not None
    assert found.coefficients[0 if offset else 1 :] == pytest.approx(wanted, rel=1e-6)
    assert (found.coefficients[0] != 0.0) == offset


def test_powers_that_are_not_excited_are_named() -> None:
    identifier = PolynomialIdentifier()
    assert identifier.identify().unexcited == (1, 2, 3, 4, 5)
    for speed in (0.1, 0.2):
        for _ in range(50):
            identifier.learn(speed, 4.0 * speed)
    found = identifier.identify()
    assert (found.function, found.unexcited) == (None, (3, 4, 5))
    narrow = PolynomialIdentifier()
    for speed in np.linspace(0.1, 0.11, 500).tolist():
        narrow.learn(speed, 4.0 * speed)
    assert narrow.identify().unexcited == (4, 5)


def test_the_range_that_was_seen_is_reported() -> None:
    identifier = PolynomialIdentifier(order=2)
    for speed in np.linspace(0.08, 0.2, 300).tolist():
        identifier.learn(speed, 3.0 * speed)
    function = identifier.identify().function
    assert function is not None
    assert 0.06 < function.speed_low <= 0.08
    assert 0.2 <= function.speed_high < 0.22
    outside = PolynomialIdentifier(order=2)
    for speed in (0.5, 0.6, 0.7):
        outside.learn(speed, 3.0 * speed)
    assert outside.identify().function is None


def test_a_report_after_a_gap_and_the_first_of_a_trial_are_left_out_and_counted() -> None:
    events = exact_events()
    table = events.table.copy()
    table[3000:, 0] += 1.0  # a pause: the counts of the report after it took nobody knows how long
    table[3000:, 1:3] += 500.0  # and the cursor was put elsewhere
    begin = np.zeros(len(table), np.bool_)
    begin[4500] = True
    table[4500:, 1:3] -= 900.0
    identifier = PolynomialIdentifier()
    identifier.run(EventColumns(table, begin))
    found = identifier.identify()
    assert found.function is not None
    assert found.skipped == 3
    assert found.function.gain(SPEEDS) == pytest.approx(TRUTH.gain(SPEEDS), rel=1e-6)


def test_reports_of_the_same_time_are_one() -> None:
    events = exact_events()
    halves = np.repeat(events.table, 2, axis=0)
    halves[:, 3:5] /= 2.0
    identifier = PolynomialIdentifier()
    identifier.run(EventColumns(halves))
    function = identifier.identify().function
    assert function is not None
    assert function.gain(SPEEDS) == pytest.approx(TRUTH.gain(SPEEDS), rel=0.02)


def test_updates_equal_rows_and_a_refused_event_changes_nothing() -> None:
    events = exact_events()
    whole, single = PolynomialIdentifier(), PolynomialIdentifier()
    whole.run(events)
    for event in events.events():
        single.update(event)
    assert np.array_equal(whole._memory, single._memory)
    before = single._memory.copy()
    for wrong in (
        PointerEvent(9.0, 1.0, 1.0),
        PointerEvent(0.0, 1.0, 1.0, 1.0, 1.0),
        PointerEvent(9.0, float("nan"), 1.0, 1.0, 1.0),
    ):
        with pytest.raises(EventError, match="event needs counts"):
            single.update(wrong)
    with pytest.raises(EventError, match="row 0"):
        single.run(events)
    with pytest.raises(EventError, match="speeds"):
        single.learn(-1.0, 1.0)
    assert np.array_equal(before, single._memory)
    assert pickle.loads(pickle.dumps(single)).identify().residual == single.identify().residual
    single.reset()
    assert np.array_equal(single._memory, PolynomialIdentifier()._memory)


def test_bounds_are_named() -> None:
    for wrong in ({"order": 7}, {"order": 2.5}, {"speed_low": 0.4}):
        with pytest.raises(ParameterError) as refused:
            PolynomialIdentifier(**wrong)
        assert {refused.value.field: refused.value.value} == wrong


def corner_circle() -> EventColumns:
    """A circle of 300 px round the screen's corner at 600 px/s, the hand at a quarter of it."""
    t = np.arange(0.0, 0.7, 0.001)
    x, y = 300.0 * np.cos(2.0 * t), 300.0 * np.sin(2.0 * t)
    dx, dy = np.diff(x, prepend=x[0]), np.diff(y, prepend=y[0])
    return EventColumns.of(t, x, y, dx * CPI / DPI / 4.0, dy * CPI / DPI / 4.0)


def test_a_movement_round_the_corner_has_a_speed() -> None:
    """The printed V_c = d/dt sqrt(x^2 + y^2) is zero on this circle; the cursor moves at 600 px/s."""
    events = corner_circle()
    printed = np.diff(np.hypot(events.x, events.y)) / np.diff(events.t)
    assert np.abs(printed).max() < 1e-6
    wanted = 600.0 * 0.0254 / DPI
    motor, cursor = euler_speeds(events, cpi=CPI, dpi=DPI)
    assert cursor == pytest.approx(wanted, rel=1e-3)
    assert motor == pytest.approx(wanted / 4.0, rel=1e-3)
    both = differentiated_speeds(
        events, HomogeneousDifferentiator(cpi=CPI), HomogeneousDifferentiator(dpi=DPI)
    )
    motor, cursor = (speeds[-5:] for speeds in both)
    assert cursor == pytest.approx(wanted, rel=0.02)
    assert motor == pytest.approx(wanted / 4.0, rel=0.02)


def test_euler_needs_counts_and_sense() -> None:
    with pytest.raises(EventError, match="counts"):
        euler_speeds(EventColumns.of([0.0, 1.0], [0.0, 1.0], [0.0, 1.0]), cpi=CPI)
    with pytest.raises(ParameterError, match="window_s"):
        euler_speeds(corner_circle(), cpi=CPI, window_s=-1.0)
    motor, cursor = euler_speeds(corner_circle().rows(0, 0), cpi=CPI)
    assert len(motor) == len(cursor) == 0
