"""The sampling rules that all differentiators share, seen through ``update`` and ``run``."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from pointpred import EventColumns, Motion, PointerEvent
from pointpred.differentiators import DIFFERENTIATORS, Differentiator
from pointpred.errors import EventError, EventOrderError
from pointpred.records import LARGEST, LATEST_S


@pytest.fixture(params=list(DIFFERENTIATORS))
def differentiator(request: pytest.FixtureRequest) -> Differentiator:
    return DIFFERENTIATORS[request.param](cpi=1000.0)


def moving(differentiator: Differentiator, count: int = 20, t: float = 0.0) -> Motion:
    """Feed a movement at 125 Hz; the motion after it."""
    for i in range(count):
        motion = differentiator.update(PointerEvent(t + 0.008 * i, 3.0 * i, -2.0 * i))
    return motion


def test_first_event_starts_a_movement_at_rest(differentiator: Differentiator) -> None:
    motion = differentiator.update(PointerEvent(5.0, 700.0, -3.0))
    assert motion == Motion(5.0, 700.0, -3.0, 0.0, 0.0, 0.0, 0.0, False, start=True, counts=False)


@pytest.mark.parametrize("event", [(1, 2, 3), None, "move", {"t": 0.0}])
def test_what_is_no_event_is_told_so(differentiator: Differentiator, event: object) -> None:
    before = moving(differentiator)
    with pytest.raises(EventError, match="must be a PointerEvent, received"):
        differentiator.update(event)  # type: ignore[arg-type]
    assert differentiator.update(PointerEvent(before.t, before.x, before.y)).vx == before.vx


@pytest.mark.parametrize(
    ("field", "value"),
    [
        *[(field, wrong) for field in ("t", "x", "y", "dx", "buttons") for wrong in ("3", b"3", True)],
        ("x", None),
        ("dx", math.nan),
        ("buttons", 1.5),
        ("buttons", None),
    ],
)
def test_what_only_reads_like_a_number_is_refused(
    differentiator: Differentiator, field: str, value: object
) -> None:
    before = moving(differentiator)
    fields = {"t": before.t + 0.008, "x": 1.0, "y": 1.0, "dx": 1.0, "dy": 1.0, "buttons": 0, field: value}
    if field == "dx" and value != value:
        fields["dy"] = value
    with pytest.raises(EventError, match=f"^{field} must"):
        differentiator.update(PointerEvent(**fields))  # type: ignore[arg-type]
    assert differentiator.update(PointerEvent(before.t, before.x, before.y)).vx == before.vx


def test_numbers_of_numpy_are_numbers(differentiator: Differentiator) -> None:
    twin = differentiator.fresh()
    for i in range(9):
        plain = differentiator.update(PointerEvent(i / 128, i, -i, i, i, 1))
        numpy = PointerEvent(*map(np.float32, (i / 128, i, -i, i, i)), np.uint8(1))  # type: ignore[arg-type]
        assert twin.update(numpy) == plain


@pytest.mark.parametrize("tenths", [1, 3])
def test_a_gap_of_exactly_the_bound_is_none_however_it_is_rounded(
    differentiator: Differentiator, tenths: int
) -> None:
    """0.1 s restarts and 0.3 s begins a movement only where they are exceeded: 0.3 - 0.2 is above 0.1."""
    t = np.arange(200) * (0.1 * tenths)
    assert (np.diff(t) > 0.1 * tenths).any()
    motions = differentiator.run(EventColumns.of(t, np.arange(200.0) ** 2, np.zeros(200)))
    assert not motions.start[1:].any()
    assert (motions.vx[5:] > 0.0).all() == (tenths == 1)


def test_equal_times_keep_the_motion_and_take_the_later_position(differentiator: Differentiator) -> None:
    before = moving(differentiator)
    merged = differentiator.update(PointerEvent(before.t, 99.0, 98.0))
    assert (merged.x, merged.y, merged.start) == (99.0, 98.0, False)
    assert (merged.vx, merged.vy, merged.ax, merged.ay) == (before.vx, before.vy, before.ax, before.ay)


def test_what_shares_a_time_enters_at_the_next_later_one(differentiator: Differentiator) -> None:
    for i in range(30):
        still = differentiator.update(PointerEvent(0.008 * i, 0.0, 0.0, 0, 0))
    for _ in range(2):
        merged = differentiator.update(PointerEvent(still.t, 0.0, 0.0, 50, -25))
    assert (merged.vx, merged.vy) == (0.0, 0.0)
    later = differentiator.update(PointerEvent(still.t + 0.008, 0.0, 0.0, 0, 0))
    assert later.vx > 0.05  # 100 counts are 2.54 mm in 8 ms
    assert later.vy == pytest.approx(-0.5 * later.vx, rel=0.3)


def test_counts_of_one_time_add_up(differentiator: Differentiator) -> None:
    """A ramp whose reports come in two halves of one stamp ends at the same velocity."""
    twin = differentiator.fresh()
    for i in range(80):
        whole = differentiator.update(PointerEvent(0.008 * i, 0.0, 0.0, 4, -6))
        twin.update(PointerEvent(0.008 * i, 0.0, 0.0, 1, -2))
        halves = twin.update(PointerEvent(0.008 * i, 0.0, 0.0, 3, -4))
    assert whole.vx == pytest.approx(4 * 2.54e-5 / 0.008, rel=1e-2)
    assert (halves.vx, halves.vy) == pytest.approx((whole.vx, whole.vy), rel=1e-2)


def test_a_position_replaced_at_the_start_is_no_movement(differentiator: Differentiator) -> None:
    differentiator.update(PointerEvent(1.0, 0.0, 0.0))
    differentiator.update(PointerEvent(1.0, 500.0, 400.0))
    for i in range(1, 20):
        motion = differentiator.update(PointerEvent(1.0 + 0.008 * i, 500.0, 400.0))
        assert (motion.vx, motion.vy, motion.ax, motion.ay) == (0.0, 0.0, 0.0, 0.0)


def test_a_gap_restarts_at_rest_without_starting_a_movement(differentiator: Differentiator) -> None:
    before = moving(differentiator)
    motion = differentiator.update(PointerEvent(before.t + 0.2, 90.0, 80.0))
    assert motion == Motion(before.t + 0.2, 90.0, 80.0, 0.0, 0.0, 0.0, 0.0, False, start=False)


def test_after_a_restart_only_the_time_differs(differentiator: Differentiator) -> None:
    first = moving(differentiator.fresh())
    moving(differentiator)
    again = moving(differentiator, t=64.0)
    assert (again.vx, again.ay) == pytest.approx((first.vx, first.ay), rel=1e-6, abs=1e-9)
    assert again.settled == first.settled


@pytest.mark.parametrize(("wait", "starts"), [(0.099, False), (0.299, False), (0.301, True)])
def test_a_pause_starts_a_movement(differentiator: Differentiator, wait: float, starts: bool) -> None:
    before = moving(differentiator)
    assert differentiator.update(PointerEvent(before.t + wait, 60.0, 0.0)).start is starts


def test_releasing_a_button_starts_a_movement_and_keeps_the_velocity(differentiator: Differentiator) -> None:
    before = moving(differentiator)
    t = before.t
    assert not differentiator.update(PointerEvent(t + 0.008, 60.0, -40.0, buttons=1)).start
    assert not differentiator.update(PointerEvent(t + 0.016, 63.0, -42.0, buttons=3)).start
    released = differentiator.update(PointerEvent(t + 0.024, 66.0, -44.0, buttons=1))
    assert released.start
    assert released.vx == pytest.approx(before.vx, rel=0.2)
    assert differentiator.update(PointerEvent(t + 0.024, 66.0, -44.0, buttons=0)).start


def test_counts_are_used_only_with_a_resolution(differentiator: Differentiator) -> None:
    cursor_only = type(differentiator)()
    for i in range(100):
        event = PointerEvent(0.008 * i, 0.0, 5.0 * i, 10, 0)
        motion, other = differentiator.update(event), cursor_only.update(event)
    assert motion.counts
    assert motion.vx == pytest.approx(10 * 2.54e-5 / 0.008, rel=0.02)
    assert motion.vy == pytest.approx(0.0, abs=1e-12)
    assert not other.counts
    assert other.vy == pytest.approx(5 * 0.0254 / 96 / 0.008, rel=0.02)


REFUSALS: dict[str, tuple[Callable[[float], PointerEvent], type[EventError], str]] = {
    "backwards": (lambda t: PointerEvent(t - 1e-9, 0.0, 0.0), EventOrderError, "must not run backwards"),
    "t nan": (lambda t: PointerEvent(math.nan, 0.0, 0.0), EventError, r"t must lie in .*nan"),
    "t in milliseconds": (lambda t: PointerEvent(1.7e12, 0.0, 0.0), EventError, r"t must lie .*1e\+11\]"),
    "x infinite": (lambda t: PointerEvent(t + 1, math.inf, 0.0), EventError, r"x must lie in .*received inf"),
    "y large": (lambda t: PointerEvent(t + 1, 0.0, -1.1e9), EventError, r"y must lie in \[-1e\+09, 1e\+09\]"),
    "dx large": (lambda t: PointerEvent(t + 1, 0.0, 0.0, 2e9, 0), EventError, "dx must lie in"),
    "dy infinite": (lambda t: PointerEvent(t + 1, 0.0, 0.0, 0, -math.inf), EventError, "dy must lie in"),
    "dx alone": (lambda t: PointerEvent(t + 1, 0.0, 0.0, 3), EventError, "dx and dy come together"),
    "buttons negative": (
        lambda t: PointerEvent(t + 1, 0.0, 0.0, buttons=-1),
        EventError,
        r"buttons must lie in \[0, 1e\+09\], received -1",
    ),
}


@pytest.mark.parametrize("case", REFUSALS)
def test_a_refused_event_says_why_and_changes_no_bit(differentiator: Differentiator, case: str) -> None:
    make, error, message = REFUSALS[case]
    moving(differentiator)
    event = make(0.152)
    kept = differentiator._memory.tobytes()
    with pytest.raises(error, match=message):
        differentiator.update(event)
    assert differentiator._memory.tobytes() == kept
    table = EventColumns.of_events([PointerEvent(0.152, 60.0, 0.0), PointerEvent(0.153, 60.0, 0.0)])
    rows = np.concatenate([table.table, EventColumns.of_events([event]).table])
    with pytest.raises(error, match=rf"row 2: .*{message}"):
        differentiator.run(EventColumns(rows))
    assert differentiator._memory.tobytes() == kept


@pytest.mark.parametrize(
    ("event", "name"),
    [
        (PointerEvent("1", None, 0.0), "t"),  # type: ignore[arg-type]
        (PointerEvent(1.0, None, 0.0), "x"),  # type: ignore[arg-type]
        (PointerEvent(1.0, 0.0, 0.0, 1, "a"), "dy"),  # type: ignore[arg-type]
        (PointerEvent(10**400, 0.0, 0.0), "t"),
    ],
)
def test_what_is_no_number_is_refused(differentiator: Differentiator, event: PointerEvent, name: str) -> None:
    kept = differentiator._memory.tobytes()
    with pytest.raises(EventError, match=f"{name} must"):
        differentiator.update(event)
    assert differentiator._memory.tobytes() == kept


def test_a_bad_first_event_is_not_blamed_on_the_order(differentiator: Differentiator) -> None:
    with pytest.raises(EventError, match="x must lie in"):
        differentiator.update(PointerEvent(-5.0, math.nan, 0.0))
    moving(differentiator, t=100.0)
    begins = EventColumns.of([-5.0], [math.nan], [0.0], begin=np.array([True]))
    with pytest.raises(EventError, match="row 0: x must lie in"):
        differentiator.run(begins)


def test_a_row_that_begins_may_lie_earlier(differentiator: Differentiator) -> None:
    moving(differentiator, t=100.0)
    earlier = differentiator.run(EventColumns.of([3.0], [0.0], [0.0], begin=np.array([True])))
    assert earlier.start[0] == 1.0


def test_whole_numbers_are_numbers(differentiator: Differentiator) -> None:
    """Integers, numpy scalars and floats are one event."""
    twin = differentiator.fresh()
    for i in range(30):
        one = differentiator.update(PointerEvent(i, 2 * i, np.int32(i), np.float32(4.0), 1))
        two = twin.update(PointerEvent(float(i), 2.0 * i, float(i), 4.0, 1.0))
    assert one == two


def test_the_largest_values_are_data(differentiator: Differentiator) -> None:
    differentiator.update(PointerEvent(-LATEST_S, LARGEST, -LARGEST))
    motion = differentiator.update(PointerEvent(LATEST_S, -LARGEST, LARGEST, LARGEST, -LARGEST, int(LARGEST)))
    assert (motion.t, motion.x, motion.vx) == (LATEST_S, -LARGEST, 0.0)
