"""Shares of targets: they sum to one, follow the laws of symmetry, and are the prior times the mass."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from pointpred import EventColumns, PointerEvent, Prediction, build
from pointpred import run as run_columns
from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.records import FloatArray
from pointpred.targets import Chooser, Target, around
from pointpred.targets.posterior import MASS, Coefficients

MASS_ALONE = np.zeros(Coefficients.length)
for weights in (Coefficients(MASS_ALONE).claimed, Coefficients(MASS_ALONE).unclaimed):
    weights.slow[MASS] = weights.fast[MASS] = 1.0


def reach(x: float = 300.0, y: float = -120.0, count: int = 40) -> list[PointerEvent]:
    s = np.linspace(0.0, 0.6, count)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    return [PointerEvent(0.01 * i, x * w, y * w) for i, w in enumerate(way.tolist())]


def after(chooser: Chooser, events: list[PointerEvent], prediction: Prediction | None) -> FloatArray:
    for event in events:
        chooser.update(prediction, event)
    return chooser.shares


LAW = Prediction(0.0, 280.0, -100.0, (1600.0, -500.0, 900.0), "ballistic", 0.2, 5.0)
coordinates = st.floats(-1500.0, 1500.0)
targets = st.lists(
    st.tuples(coordinates, coordinates, st.floats(1.0, 300.0), st.floats(1.0, 300.0), st.floats(0.0, 9.0)),
    max_size=12,
)


def made(rows: list[tuple[float, ...]]) -> list[Target]:
    return [Target(i, *row) for i, row in enumerate(rows)]


@given(targets, st.sampled_from([LAW, None, Prediction(0.0, 50.0, 9.0, None, "still", None)]))
def test_shares_are_shares_of_one(rows: list[tuple[float, ...]], prediction: Prediction | None) -> None:
    shares = after(Chooser(made(rows)), reach(), prediction)
    assert len(shares) == len(rows) + 1
    assert (shares >= 0.0).all()
    assert shares.sum() == pytest.approx(1.0)


def test_shares_are_prior_times_the_mass_of_small_targets() -> None:
    places = [Target("a", 276.0, -104.0, 8.0, 8.0, 1.0), Target("b", 222.0, -51.0, 6.0, 12.0, 2.5)]
    masses = []
    for place in places:
        spread = np.diag([(place.width / 4.133) ** 2, (place.height / 4.133) ** 2])
        law = stats.multivariate_normal(
            [280.0, -100.0], np.array([[1600.0, -500.0], [-500.0, 900.0]]) + spread
        )
        low, high = (place.x, place.y), (place.x + place.width, place.y + place.height)
        masses.append(place.weight * law.cdf(high, lower_limit=low))
    normal = Prediction(0.0, 280.0, -100.0, (1600.0, -500.0, 900.0), "ballistic", 0.2)
    shares = after(Chooser(places, coefficients=MASS_ALONE), reach(), normal)
    assert shares[0] / shares[1] == pytest.approx(masses[0] / masses[1], rel=0.02)


@given(targets.filter(lambda rows: len(rows) > 1), st.floats(1.0, 3.0), st.floats(1.0, 3.0))
def test_a_wider_target_is_never_less_likely(rows: list[tuple[float, ...]], wide: float, tall: float) -> None:
    rows = [(*row[:4], 1.0) for row in rows]
    x, y, w, h, weight = rows[0]
    wider = (x - (wide - 1.0) * w / 2.0, y - (tall - 1.0) * h / 2.0, wide * w, tall * h, weight)
    straight = Prediction(0.0, 280.0, -100.0, (1600.0, 0.0, 900.0), "ballistic", 0.2, 5.0)
    before = after(Chooser(made(rows)), reach(), straight)[0]
    assert after(Chooser(made([wider, *rows[1:]])), reach(), straight)[0] >= before * (1.0 - 5e-3) - 1e-12


@given(targets, st.booleans(), st.booleans())
def test_mirrors_and_quarter_turns_of_everything_change_nothing(
    rows: list[tuple[float, ...]], claimed: bool, turn: bool
) -> None:
    def moved(x: float, y: float) -> tuple[float, float]:
        return (-y, x) if turn else (-x, y)

    there = []
    for x, y, w, h, weight in rows:
        mx, my = moved(x + w / 2.0, y + h / 2.0)
        mw, mh = (h, w) if turn else (w, h)
        there.append((mx - mw / 2.0, my - mh / 2.0, mw, mh, weight))
    matrix, other = (
        ((1600.0, -500.0, 900.0), (900.0, 500.0, 1600.0))
        if turn
        else ((1600.0, -500.0, 900.0), (1600.0, 500.0, 900.0))
    )
    first = Prediction(0.0, 280.0, -100.0, matrix if claimed else None, "ballistic", 0.2, 5.0)
    second = Prediction(0.0, *moved(280.0, -100.0), other if claimed else None, "ballistic", 0.2, 5.0)
    events = [PointerEvent(e.t, *moved(e.x, e.y)) for e in reach()]
    shares = after(Chooser(made(rows)), reach(), first)
    assert after(Chooser(made(there)), events, second) == pytest.approx(shares, abs=1e-7)


def test_moving_the_screen_and_the_clock_changes_nothing() -> None:
    places = [around(i, 60.0 * i, -25.0 * i, 40.0) for i in range(8)]
    far = [Target(t.id, t.x + 4096.0, t.y - 512.0, t.width, t.height) for t in places]
    events = [PointerEvent(e.t + 64.0, e.x + 4096.0, e.y - 512.0) for e in reach()]
    moved = Prediction(64.0, LAW.x + 4096.0, LAW.y - 512.0, LAW.scale, "ballistic", 0.2, 5.0)
    shares = after(Chooser(places), reach(), LAW)
    assert after(Chooser(far), events, moved) == pytest.approx(shares, abs=1e-9)


def test_a_weight_of_zero_is_never_and_all_zero_is_none_of_them() -> None:
    place = around("a", 300.0, -120.0, 40.0)
    never = Target("a", place.x, place.y, 40.0, 40.0, 0.0)
    assert after(Chooser([never, around("b", 0.0, 90.0, 9.0)]), reach(), LAW)[0] == 0.0
    assert after(Chooser([never]), reach(), LAW).tolist() == [0.0, 1.0]


def test_heading_to_a_rectangle_that_is_no_target() -> None:
    chooser = Chooser()
    after(chooser, reach(), LAW)
    assert chooser.heading_to(around("ahead", 300.0, -120.0, 60.0)) > 0.5
    assert chooser.heading_to(around("behind", -300.0, 120.0, 60.0)) < 0.05


def run(chooser: Chooser, events: list[PointerEvent]) -> list[object]:
    pipeline = build("minimum-jerk")
    return [(chooser.update(pipeline.update(e), e), chooser.shares.tolist()) for e in events]


PLACES = [around(i, 300.0 * np.cos(i), 300.0 * np.sin(i), 40.0) for i in range(6)]


def test_the_same_events_give_the_same_choices_also_after_a_reset_and_a_pickle() -> None:
    chooser, events = Chooser(PLACES, precision=0.5), reach()
    first = run(chooser, events)
    chooser.reset()
    assert run(chooser, events) == first
    chooser.reset()
    half = run(chooser, events[:20])
    again = pickle.loads(pickle.dumps(chooser))
    assert half == first[:20]
    pipeline = build("minimum-jerk")
    for event in events[:20]:
        pipeline.update(event)
    assert [(again.update(pipeline.update(e), e), again.shares.tolist()) for e in events[20:]] == first[20:]


@pytest.mark.parametrize("x", [np.nan, np.inf, 2e9])
def test_a_refused_event_changes_nothing(x: float) -> None:
    chooser = Chooser(PLACES)
    after(chooser, reach()[:20], LAW)
    before = pickle.dumps(chooser)
    with pytest.raises(EventError):
        chooser.update(LAW, PointerEvent(0.2, x, 0.0))
    with pytest.raises(EventOrderError):
        chooser.update(LAW, PointerEvent(0.1, 0.0, 0.0))
    assert pickle.dumps(chooser) == before


def test_many_events_at_once_are_the_same_as_one_by_one() -> None:
    events = EventColumns.of_events(reach())
    answers = run_columns(build("minimum-jerk"), events)
    one, many = Chooser(PLACES, precision=0.5), Chooser(PLACES, precision=0.5)
    changes, likely, heading = [], [], []
    for event, prediction in zip(events.events(), answers.predictions(), strict=True):
        changes += [(event.t, choice) for choice in one.update(prediction, event)]
        likely.append(one.likeliest())
        best = int(np.argmax(one.shares))
        heading.append(best if best < len(PLACES) else -1)
    assert changes
    for first, stop in ((0, 13), (13, 13), (13, 40)):
        found, told, places = many.follow(events.table[first:stop], answers.table[first:stop])
        assert places == heading[first:stop]
        assert found == [change for change in changes if change[0] in events.t[first:stop]]
        assert told == likely[first:stop]
    assert {-1} < set(heading)
    assert many.finish(0) == one.finish(0)
    assert many.shares.tolist() == one.shares.tolist()
    before = pickle.dumps(many)
    with pytest.raises(EventOrderError, match="row 0"):
        many.follow(events.table[:2], answers.table[:2])
    wrong = events.table[-2:].copy()
    wrong[:, 0] += 9.0
    wrong[1, 1] = np.nan
    with pytest.raises(EventError, match="row 1"):
        many.follow(wrong, answers.table[-2:])
    assert pickle.dumps(many) == before


def test_a_smooth_start_towards_targets_far_apart_proposes_nothing_within_three_pixels() -> None:
    places = [around("a", 900.0, 0.0, 40.0), around("b", -900.0, 0.0, 40.0)]
    for least, near in ((3.0, False), (0.0, True)):
        chooser, pipeline = Chooser(places, least_way_px=least), build("minimum-jerk")
        events = reach(900.0, 0.0, 400)
        where = [abs(e.x) for e in events if chooser.update(pipeline.update(e), e)]
        assert where
        assert (where[0] < 3.0) == near


def test_other_targets_keep_a_proposal_that_is_still_there() -> None:
    chooser = Chooser([around("a", 300.0, -120.0, 60.0), around("b", -300.0, 0.0, 60.0)], precision=0.5)
    after(chooser, reach(), LAW)
    assert chooser.standing == "a"
    assert chooser.replace([around("b", -300.0, 0.0, 60.0), around("a", 300.0, -120.0, 60.0)]) == ()
    assert chooser.standing == "a"
    (gone,) = chooser.replace([around("b", -300.0, 0.0, 60.0)])
    assert (gone.id, gone.action, chooser.standing) == ("a", "retract", None)


def test_a_release_of_the_button_ends_what_was_proposed() -> None:
    chooser = Chooser([around("a", 300.0, -120.0, 60.0)], precision=0.5)
    after(chooser, reach(), LAW)
    chooser.update(LAW, PointerEvent(0.5, 300.0, -120.0, buttons=1))
    assert chooser.standing == "a"
    (ended,) = chooser.update(None, PointerEvent(0.6, 300.0, -120.0))
    assert (ended.id, ended.action) == ("a", "retract")


def test_settings_out_of_bounds_are_refused_and_nothing_is_changed() -> None:
    chooser = Chooser(PLACES, precision=0.7)
    with pytest.raises(ParameterError, match="elsewhere"):
        chooser.configure(precision=0.5, elsewhere=1.0)
    assert chooser._settings[0] == 0.7
    with pytest.raises(ParameterError, match="precision"):
        chooser.configure(precision=0.0)
