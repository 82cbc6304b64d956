"""The measurement of the prefetch policy: ForesightJS's rule, frames, and the scores of movements."""

from __future__ import annotations

import numpy as np
import pytest

from evidence.data import Table
from evidence.intent.firing import FRAME_S, by_hover, by_policy, by_rule, fire_by_rule, frame_end, score
from evidence.intent.fit import chances, first_firings
from evidence.intent.measure import HEADS, RULE, beside
from evidence.intent.movements import Movement
from pointpred.records import FloatArray
from pointpred.targets import around, prefetch
from pointpred.targets.rectangles import table

TARGETS = table([around("start", 0.0, 0.0, 20.0), around("right", 299.0, 0.0, 40.0)])


def straight() -> FloatArray:
    """1000 px/s along x at 100 Hz, up to the middle of the target."""
    events = np.zeros((31, 6))
    events[:, 0], events[:, 1] = 5.0 + np.arange(31) / 100, 10.0 * np.arange(31)
    return events


def test_the_rule_fires_when_a_line_of_120_ms_reaches_the_border() -> None:
    fired_at = np.empty(2)
    fire_by_rule(straight(), TARGETS, 0.0, fired_at)
    assert fired_at[0] == 5.0  # the cursor is in it at the first event
    assert fired_at[1] == pytest.approx(5.16)  # 160 + 120 px reach beyond the border at 279 px


def test_of_a_frame_the_last_event_is_seen_when_the_frame_ends() -> None:
    events = straight()
    ends = [frame_end(events, i, 0.025) for i in range(6)]
    assert ends == pytest.approx([np.inf, np.inf, 5.025, np.inf, np.inf, 5.05])
    fired_at = np.empty(2)
    fire_by_rule(events, TARGETS, 0.025, fired_at)
    assert fired_at[1] == pytest.approx(5.2)  # no position of the rest is among the last eight


def test_the_rule_remembers_the_rest_before_a_movement() -> None:
    fired_at, near = np.empty(1), table([around("near", 100.0, 0.0, 20.0)])
    fire_by_rule(straight(), near, 0.0, fired_at)
    assert fired_at[0] == pytest.approx(5.07)  # the eighth position of the movement; without the rest 5.01


def test_a_score_counts_firings_with_and_without_where_the_movement_starts() -> None:
    events = straight()
    movement = Movement("two", "set", "user", TARGETS, 1, events, np.empty((0, 6)), {})
    one = score([movement], [by_rule(movement, 0.0)])
    assert (one.firings, one.elsewhere, one.before) == (2.0, 1.0, 1.0)
    assert one.lead_s == pytest.approx(0.12)
    late = score([movement, movement], [by_rule(movement, 0.0), np.array([np.inf, 5.28])])
    assert (late.before, late.lead_all_s) == (0.5, pytest.approx(0.06))


def test_by_the_policy_nothing_fires_where_the_movement_starts() -> None:
    movement = Movement("two", "set", "user", TARGETS, 1, straight(), np.empty((0, 6)), {})
    shares = np.tile([0.0, 0.97, 0.03], (31, 1))
    fired_at = by_policy(movement, shares, np.array(prefetch.FITTED), 0.0)
    assert fired_at[0] == np.inf
    assert fired_at[1] < 5.1


def test_the_fit_sees_the_firings_of_the_policy() -> None:
    random = np.random.default_rng(3)
    places = [around(i, *random.uniform(-50.0, 350.0, 2), *random.uniform(10.0, 120.0, 2)) for i in range(8)]
    movements = []
    for _ in range(6):
        events = np.zeros((40, 6))
        events[:, 0], events[:, 1:3] = np.arange(40) / 100, random.normal(6.0, 9.0, (40, 2)).cumsum(axis=0)
        movements.append(Movement("eight", "set", "user", table(places), 1, events, np.empty((0, 6)), {}))
    shares = [random.dirichlet([*[0.02] * 8, 1.0], 40) for _ in movements]
    settings, count = np.array(prefetch.FITTED), 8 * len(movements)
    fired = first_firings(chances(movements, shares), settings, count)
    pairs = zip(movements, shares, strict=True)
    assert fired.tolist() == [t for pair in pairs for t in by_policy(*pair, settings, FRAME_S).tolist()]
    assert 8 < np.isfinite(fired).sum() < count


def test_a_hover_fires_after_its_time_or_at_the_press_and_not_where_the_pointer_only_passes() -> None:
    movement = Movement("two", "set", "user", TARGETS, 1, straight(), np.empty((0, 6)), {})
    assert by_hover(movement, 0.01) == pytest.approx([5.01, 5.29])  # in each target for 20 ms
    assert by_hover(movement, 0.2) == pytest.approx([np.inf, 5.3])


def test_what_is_asked_for_and_not_reached_is_named() -> None:
    ours, theirs = ("9", "3.00", "2.00", "90.0", "199", "0"), ("9", "3.00", "2.00", "90.0", "100", "0")
    worse, bare = ("9", "3.01", "2.00", "89.9", "200", "0"), ("9", "3.00", "2.00", "90.0", "100", "0")
    rows = [("a", "ours", *ours), ("a", RULE, *theirs), ("b", "ours", *worse), ("b", RULE, *bare)]
    table = Table.of(("layout", "rule", "movements", *HEADS), rows)
    assert [row[-1] for row in beside(table, "ours").texts()] == ["lead", "firings, before"]
