"""Shares of targets: they sum to one, follow the laws of symmetry, and are the prior times the mass."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from pointpred import Pipeline, PointerEvent, Prediction, build
from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred.targets import Chooser, Target, around
from pointpred.targets.posterior import MASS, Coefficients
from tests.aimed import Told

MASS_ALONE = np.zeros(Coefficients.length)
for weights in (Coefficients(MASS_ALONE).claimed, Coefficients(MASS_ALONE).unclaimed):
    weights.slow[MASS] = weights.fast[MASS] = 1.0


def reach(x: float = 300.0, y: float = -120.0, count: int = 40) -> list[PointerEvent]:
    s = np.linspace(0.0, 0.6, count)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    return [PointerEvent(0.01 * i, x * w, y * w) for i, w in enumerate(way.tolist())]


def after(pipeline: Told, events: list[PointerEvent], prediction: Prediction | None) -> FloatArray:
    for event in events:
        pipeline.take(prediction, event)
    return pipeline.aim.shares


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
    shares = after(Told(made(rows)), reach(), prediction)
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
    shares = after(Told(places, coefficients=MASS_ALONE), reach(), normal)
    assert shares[0] / shares[1] == pytest.approx(masses[0] / masses[1], rel=0.02)


@given(targets.filter(lambda rows: len(rows) > 1), st.floats(1.0, 3.0), st.floats(1.0, 3.0))
def test_a_wider_target_is_never_less_likely(rows: list[tuple[float, ...]], wide: float, tall: float) -> None:
    rows = [(*row[:4], 1.0) for row in rows]
    x, y, w, h, weight = rows[0]
    wider = (x - (wide - 1.0) * w / 2.0, y - (tall - 1.0) * h / 2.0, wide * w, tall * h, weight)
    straight = Prediction(0.0, 280.0, -100.0, (1600.0, 0.0, 900.0), "ballistic", 0.2, 5.0)
    before = after(Told(made(rows)), reach(), straight)[0]
    assert after(Told(made([wider, *rows[1:]])), reach(), straight)[0] >= before * (1.0 - 5e-3) - 1e-12


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
    shares = after(Told(made(rows)), reach(), first)
    assert after(Told(made(there)), events, second) == pytest.approx(shares, abs=1e-7)


def test_moving_the_screen_and_the_clock_changes_nothing() -> None:
    places = [around(i, 60.0 * i, -25.0 * i, 40.0) for i in range(8)]
    far = [Target(t.id, t.x + 4096.0, t.y - 512.0, t.width, t.height) for t in places]
    events = [PointerEvent(e.t + 64.0, e.x + 4096.0, e.y - 512.0) for e in reach()]
    moved = Prediction(64.0, LAW.x + 4096.0, LAW.y - 512.0, LAW.scale, "ballistic", 0.2, 5.0)
    shares = after(Told(places), reach(), LAW)
    assert after(Told(far), events, moved) == pytest.approx(shares, abs=1e-9)


def test_a_weight_of_zero_is_never_and_all_zero_is_none_of_them() -> None:
    place = around("a", 300.0, -120.0, 40.0)
    never = Target("a", place.x, place.y, 40.0, 40.0, 0.0)
    assert after(Told([never, around("b", 0.0, 90.0, 9.0)]), reach(), LAW)[0] == 0.0
    assert after(Told([never]), reach(), LAW).tolist() == [0.0, 1.0]


def run(pipeline: Pipeline, chooser: Chooser, events: list[PointerEvent]) -> list[object]:
    return [(pipeline.update(event), chooser.update(), pipeline.shares) for event in events]


PLACES = [around(i, 300.0 * np.cos(i), 300.0 * np.sin(i), 40.0) for i in range(6)]


def test_the_same_events_give_the_same_choices_also_after_a_reset_and_a_pickle() -> None:
    pipeline, events = build("minimum-jerk", targets=PLACES, learn=0), reach()
    chooser = Chooser(pipeline, precision=0.5)
    first = run(pipeline, chooser, events)
    assert any(choices for _, choices, _ in first)
    pipeline.reset()
    chooser.reset()
    assert run(pipeline, chooser, events) == first
    pipeline.reset()
    chooser.reset()
    assert run(pipeline, chooser, events[:20]) == first[:20]
    again, chooses = pickle.loads(pickle.dumps((pipeline, chooser)))
    assert chooses.pipeline is again
    assert run(again, chooses, events[20:]) == first[20:]


def test_a_smooth_start_towards_targets_far_apart_proposes_nothing_within_three_pixels() -> None:
    places = [around("a", 900.0, 0.0, 40.0), around("b", -900.0, 0.0, 40.0)]
    for least, near in ((3.0, False), (0.0, True)):
        pipeline = build("minimum-jerk", targets=places)
        chooser = Chooser(pipeline, least_way_px=least)
        said = run(pipeline, chooser, events := reach(900.0, 0.0, 400))
        where = [abs(event.x) for event, (_, choices, _) in zip(events, said, strict=True) if choices]
        assert where
        assert (where[0] < 3.0) == near


def proposing(*targets: Target) -> tuple[Told, Chooser]:
    """After a reach to "a", which is proposed."""
    pipeline = Told(targets)
    chooser = Chooser(pipeline, precision=0.5)
    for event in reach():
        pipeline.take(LAW, event)
        chooser.update()
    assert chooser.standing == "a"
    return pipeline, chooser


A, B = around("a", 300.0, -120.0, 60.0), around("b", -300.0, 0.0, 60.0)


def test_other_targets_keep_a_proposal_that_is_still_there() -> None:
    pipeline, chooser = proposing(A, B)
    pipeline.aim.register([B, A])
    assert chooser.follow_targets() == ()
    assert chooser.standing == "a"
    pipeline.aim.register([B])
    (gone,) = chooser.follow_targets()
    assert (gone.id, gone.action, chooser.standing) == ("a", "retract", None)


def test_a_target_that_is_gone_is_retracted_at_the_next_event_at_the_latest() -> None:
    pipeline, chooser = proposing(A, B)
    pipeline.aim.register([])
    pipeline.take(LAW, PointerEvent(0.45, 300.0, -120.0))
    assert [(one.id, one.action) for one in chooser.update()] == [("a", "retract")]


def test_a_release_of_the_button_ends_what_was_proposed() -> None:
    pipeline, chooser = proposing(A)
    pipeline.take(LAW, PointerEvent(0.5, 300.0, -120.0, buttons=1))
    assert chooser.update() == ()
    assert chooser.standing == "a"
    pipeline.take(None, PointerEvent(0.6, 300.0, -120.0))
    (ended,) = chooser.update()
    assert (ended.id, ended.action) == ("a", "retract")


def test_settings_out_of_bounds_are_refused_and_nothing_is_changed() -> None:
    pipeline, chooser = proposing(A)
    with pytest.raises(ParameterError, match="least_way_px"):
        chooser.configure(precision=0.999, least_way_px=-1.0)
    pipeline.take(LAW, PointerEvent(0.5, 300.0, -120.0))
    assert chooser.update() == ()
    with pytest.raises(ParameterError, match="precision"):
        chooser.configure(precision=0.0)
    with pytest.raises(ParameterError, match="elsewhere"):
        build("hold", elsewhere=1.0)
