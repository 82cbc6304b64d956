"""The clock of a person: asked as much as it was right; a duration made again and again is expected."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from pointpred import build, run
from pointpred.predictors.adaptation import durations as clock
from pointpred.records import FloatArray
from tests.building import reach

LEFT = 6
SHARES, KEEP, LEAST, KEPT = (0.0, 0.25, 0.5, 0.75, 1.0), 0.97, 0.05, 12
FIRST = 5.0 * np.array([1.0, 0.92, 0.88, 0.9, 0.97])
"""As the docstrings have them."""


def taught(
    moments: Callable[[float], list[tuple[float, float]]], durations: FloatArray
) -> tuple[FloatArray, list[list[float]]]:
    """The memory after movements of these durations, and each one's errors as plain arithmetic has them.

    ``moments`` gives (time passed, time left as said) of a duration.
    """
    memory, errors = np.zeros(clock.Durations.length), []
    for n, duration in enumerate(durations.tolist()):
        if n:
            clock.forget(memory)
            median = float(np.median(durations[max(n - KEPT, 0) : n]))
            of = [0.0] * len(SHARES)
            for since, said in moments(duration):
                clock.judge(memory, since, said, duration - since, duration)
                for k, share in enumerate(SHARES):
                    told = (1 - share) * said + share * max(median - since, 0.0)
                    of[k] += abs(max(told, LEAST * said) - (duration - since)) / duration
            errors.append(of)
        clock.remember(memory, duration)
    return memory, errors


def test_the_best_mixture_is_the_one_with_the_least_discounted_error() -> None:
    random = np.random.default_rng(4)
    for _ in range(20):
        durations = random.uniform(0.3, 1.2, 30)
        wrong = random.uniform(0.5, 2.0)

        def moments(duration: float, wrong: float = wrong) -> list[tuple[float, float]]:
            return [(s * duration, wrong * (1.0 - s) * duration) for s in (0.1, 0.5, 0.9)]

        memory, errors = taught(moments, durations)
        ages = KEEP ** np.arange(len(errors) - 1, -1, -1)
        sums = ages @ np.array(errors)
        np.testing.assert_allclose(clock.Durations(memory).errors, sums, rtol=1e-12)
        assert clock.Durations(memory).movements == pytest.approx(ages.sum(), rel=1e-12)
        sums += FIRST * sums[0] / ages.sum()
        assert clock.Durations(memory).best == SHARES[int(np.argmin(sums))]
        assert clock.Durations(memory).median == np.median(durations[-KEPT:])


def test_a_predictor_that_knows_is_left_alone_and_one_that_does_not_is_overruled() -> None:
    random = np.random.default_rng(5)
    free, regular = random.uniform(0.3, 1.5, 80), 0.6 * np.exp(0.03 * random.standard_normal(80))
    knows, _ = taught(lambda duration: [(0.4 * duration, 0.6 * duration)], free)
    assert clock.mix(knows, 0.2, 0.5) == 0.5
    guesses, _ = taught(lambda duration: [(0.4 * duration, 1.8 * duration)], regular)
    assert clock.mix(guesses, 0.2, 1.5) == pytest.approx(0.4, abs=0.05)


def test_at_first_half_of_it_is_believed() -> None:
    """Where all mixtures are as wrong, the belief at first decides; a few movements overrule it."""
    memory, _ = taught(lambda duration: [(0.2, 0.4)], np.array([0.6, 0.5]))
    assert clock.Durations(memory).best == 0.5


def test_some_time_is_always_left() -> None:
    guesses, _ = taught(lambda duration: [(0.4 * duration, 1.8 * duration)], np.full(20, 0.6))
    assert clock.mix(guesses, 5.0, 1.5) == pytest.approx(0.05 * 1.5)
    assert clock.mix(np.zeros(clock.Durations.length), 5.0, 1.5) == 1.5


@pytest.mark.parametrize("tempo", [0.35, 1.4])
def test_a_person_who_is_fast_or_slow_is_timed_better_than_by_what_holds_for_anybody(tempo: float) -> None:
    """Distances vary, durations hardly: the cursor is near its end at 85 % of the way's time or later."""
    random = np.random.default_rng(6)
    pipelines = {name: build(name) for name in ("kinematic", "kinematic-adaptive")}
    errors: dict[str, list[float]] = {name: [] for name in pipelines}
    for n in range(25):
        duration = tempo * float(np.exp(0.05 * random.standard_normal()))
        events = reach(
            (0.0, 0.0), (float(random.uniform(200.0, 700.0)), 0.0), duration, rest_s=0.2, rate_hz=125.0
        )
        near = np.abs(events.x - events.x[-1]) > np.maximum(8.0, 0.03 * events.x[-1])
        arrival = events.t[int(np.flatnonzero(near)[-1]) + 1]
        for name, pipeline in pipelines.items():
            pipeline.reset()
            said = run(pipeline, events).table[:, LEFT]
            moving = (events.t < arrival) & np.isfinite(said)
            if n >= 10:
                errors[name].append(float(np.abs(said - (arrival - events.t))[moving].mean()))
    assert np.mean(errors["kinematic-adaptive"]) < 0.5 * np.mean(errors["kinematic"])
    assert np.mean(errors["kinematic-adaptive"]) < 0.12 * tempo


@pytest.mark.parametrize("count", range(1, KEPT + 1))
def test_the_median_is_numpys_to_the_bit(count: int) -> None:
    random = np.random.default_rng(count)
    for kinds in (2, 100):  # with many equal values, and with hardly any
        for _ in range(50):
            known = clock.Durations(np.zeros(clock.Durations.length))
            known.count, known.last[:count] = count, random.integers(0, kinds, count) / 7.0
            assert clock.median(known.memory) == np.median(known.last[:count])
