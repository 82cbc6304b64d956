"""The mixture of places and elsewhere that `kinematic-adaptive` claims, and its levels for the person."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import Pipeline, PointerEvent, build, run
from pointpred.predictors.adaptation import levels, mixed_region
from pointpred.predictors.adaptation.predictor import Memory
from tests.building import reach

NAME = "kinematic-adaptive"
ENDS = ((500.0, 100.0), (-300.0, 350.0), (120.0, -420.0), (0.0, 0.0))


def session(
    pipeline: Pipeline, movements: int, seed: int = 1
) -> tuple[np.random.Generator, tuple[float, float]]:
    """Moves between four places in a random order, 4 px off; returns where the cursor then is."""
    random, here = np.random.default_rng(seed), (0.0, 0.0)
    for _ in range(movements):
        here = moved(pipeline, random, here)
    return random, here


def goal(random: np.random.Generator, here: tuple[float, float]) -> tuple[float, float]:
    """One of the other places, a little off."""
    others = [end for end in ENDS if np.hypot(end[0] - here[0], end[1] - here[1]) > 50.0]
    x, y = others[random.integers(len(others))]
    return x + 4.0 * random.standard_normal(), y + 4.0 * random.standard_normal()


def moved(pipeline: Pipeline, random: np.random.Generator, here: tuple[float, float]) -> tuple[float, float]:
    end = goal(random, here)
    run(pipeline, reach(here, end))
    pipeline.reset()
    return end


def test_the_parts_are_the_likeliest_places_and_elsewhere() -> None:
    pipeline = build(NAME)
    random, here = session(pipeline, 15)
    end = goal(random, here)
    run(pipeline, reach(here, end).rows(0, 12))
    mixture = pipeline.mixture
    assert mixture is not None
    assert sum(part.share for part in mixture.parts) == pytest.approx(1.0)
    elsewhere, *others = mixture.parts
    likely = [place for place in pipeline.places if place.p > mixed_region.LEAST][: len(others)]
    assert [(part.share, part.x, part.y) for part in others] == [(one.p, one.x, one.y) for one in likely]
    assert others
    assert all(part.tail is None and part.scale[0] == part.scale[2] for part in others)
    assert elsewhere.tail is not None


def test_asking_changes_nothing_and_streaming_says_the_same() -> None:
    whole, single = build(NAME), build(NAME)
    for one in (whole, single):
        random, here = session(one, 8)
    events = reach(here, goal(random, here)).rows(0, 25)
    run(whole, events)
    for k in range(25):
        single.advance(tuple(events.table[k].tolist()))
        assert single.mixture is not None or k < 5
    assert single.mixture == whole.mixture
    assert single.predictor.remembered() == whole.predictor.remembered()


def test_there_is_none_where_nothing_is_claimed() -> None:
    assert build("kinematic").mixture is None
    for parameters in ({"places": 0}, {"adapt": 0}):
        pipeline = build(NAME, **parameters)
        session(pipeline, 3)
        run(pipeline, reach((0.0, 0.0), ENDS[0]).rows(0, 25))
        assert pipeline.mixture is None
    pipeline = build(NAME)
    session(pipeline, 3)
    assert pipeline.mixture is None
    out = reach((0.0, 0.0), ENDS[0]).rows(0, 25)
    run(pipeline, out)
    assert pipeline.mixture is not None
    pipeline.update(PointerEvent(float(out.t[-1]) + 0.01, 0.0, 0.0))  # back where it began: no direction
    assert pipeline.mixture is None


def test_of_a_stranger_it_is_the_law_that_is_stated() -> None:
    pipeline = build(NAME)
    answer = run(pipeline, reach((0.0, 0.0), ENDS[0]).rows(0, 25)).table[-1]
    mixture = pipeline.mixture
    assert mixture is not None
    (part,) = mixture.parts
    assert (part.x, part.y, *part.scale, part.tail) == (*answer[1:6], answer[8])


def test_it_stands_where_the_window_is() -> None:
    """A window that has moved by (40, 30) px: so have its places."""
    here = (0.0, 0.0)
    pipelines = [build(NAME), build(NAME)]
    for one, origin in zip(pipelines, ((0.0, 0.0), (40.0, 30.0)), strict=True):
        one.enter("editor")
        random, here = session(one, 12)
        one.enter("editor", *origin)
        x, y = goal(random, here)
        start = here[0] + origin[0], here[1] + origin[1]
        run(one, reach(start, (x + origin[0], y + origin[1])).rows(0, 20))
    still, with_window = (one.mixture for one in pipelines)
    assert still is not None
    assert with_window is not None
    assert len(still.parts) == len(with_window.parts) > 1
    for a, b in zip(still.parts[1:], with_window.parts[1:], strict=True):
        assert (b.x - a.x, b.y - a.y) == pytest.approx((40.0, 30.0), abs=1e-6)


def test_both_levels_hold_their_share_of_the_ends() -> None:
    """Ten people who return to four places, after 20 movements, at a third of the time."""
    held = []
    for seed in range(10):
        pipeline = build(NAME)
        random, here = session(pipeline, 20, seed)
        for _ in range(20):
            end = goal(random, here)
            events = reach(here, end)
            run(pipeline, events.rows(0, 20))
            mixture = pipeline.mixture
            assert mixture is not None
            held.append([mixture.region(level).contains(*end) for level in (0.5, 0.8)])
            run(pipeline, events.rows(20, len(events)))
            pipeline.reset()
            here = end
    np.testing.assert_allclose(np.mean(held, axis=0), [0.5, 0.8], atol=0.1)


def test_a_level_whose_region_held_no_end_grows_and_one_that_held_all_shrinks() -> None:
    offsets = levels.Offsets(np.zeros(levels.Offsets.length))
    stated = mixed_region.Mixture(np.zeros(mixed_region.Mixture.length))
    stated.count = 2.0
    stated.rows[0].memory[:] = (0.3, 0.0, 0.0, 1e4, 0.0, 1e4, 2.0)
    stated.rows[1].memory[:] = (0.7, 300.0, 0.0, 100.0, 0.0, 100.0, 0.0)
    for end, sign in (((5000.0, 0.0), 1.0), ((300.0, 0.0), -1.0)):
        offsets.values[:] = 0.0
        mixed_region.judge(offsets.memory, stated.memory, end, 0.5, 1.0)
        assert (np.sign(offsets.values[2]) == sign).all()


def test_what_is_known_of_the_levels_is_part_of_the_person() -> None:
    pipeline = build(NAME)
    session(pipeline, 6)
    assert Memory(pipeline.predictor._memory).person.regions.mixed.values.any()
    again = build(NAME, person=pipeline.person)
    for one in (pipeline, again):
        run(one, reach(ENDS[3], ENDS[0]).rows(0, 20))
    assert again.mixture == pipeline.mixture
