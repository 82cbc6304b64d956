"""The time left of a person against numpy that keeps the whole history, and against laws that are known."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import optimize

from pointpred.layout import Layout, clear, slots_of
from pointpred.predictors.adaptation import arrival_intervals as intervals
from pointpred.predictors.adaptation import time_left
from pointpred.predictors.adaptation.arrival_intervals import Intervals
from pointpred.predictors.adaptation.time_left import TERMS, Estimates, Movement, Pace, Sums, Way
from pointpred.predictors.adaptation.time_left_prior import PRIOR
from pointpred.records import FloatArray

KEEP, SMALL, JUDGED = 0.98, 0.05, 12
SHARES = (np.arange(JUDGED) + 0.5) / JUDGED
WEIGHTS, SUMS = np.array(PRIOR[:TERMS]), np.zeros((TERMS, TERMS))
SUMS[np.tril_indices(TERMS)] = PRIOR[TERMS:]
SUMS = SUMS + np.tril(SUMS, -1).T
MEDIAN = 0.8


class Memory(Layout):
    """What is known of the person, and the movement."""

    sums: Sums
    intervals: Intervals
    movement: Movement

    @property
    def flat(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """As the laws take them."""
        return self.sums.memory, self.intervals.memory, self.movement.memory


def nobody() -> Memory:
    return Memory(np.zeros(Memory.length))


def situation(random: np.random.Generator) -> tuple[Estimates, Way, Pace, float]:
    """What may be known at a moment, and the time passed."""
    mixed, predicted = random.uniform(0.01, 5.0, 2).tolist()
    way = Way(*random.uniform(1.0, 500.0, 2).tolist())
    pace = Pace(random.uniform(), random.uniform(0.0, 0.4))
    return Estimates(mixed, predicted), way, pace, random.uniform(0.0, 2.0)


def plain_terms(estimates: Estimates, way: Way, pace: Pace, since: float) -> FloatArray:
    """The terms as the docstring has them, in medians."""
    mixed, predicted = np.minimum(np.array(estimates) / MEDIAN, 4.0)
    slow = min(pace.slow_s / MEDIAN, 1.0) / (since / MEDIAN + 0.1)
    share = way.left / (way.left + way.done)
    near = 1.0 / (1.0 + (share / 0.04) ** 2)
    return np.array([mixed, predicted, 1.0, share, pace.of_peak * predicted, slow, near])


def follow(memory: Memory, random: np.random.Generator, start: float, seconds: float) -> FloatArray:
    """A movement with a moment at each share by which it is judged: the terms of each."""
    clear(memory.movement)
    rows = []
    for k, share in enumerate(SHARES):
        estimates, way, pace, since = situation(random)
        cursor = (start + share * seconds, float(k), 0.0)
        time_left.stated(*memory.flat, cursor, since, MEDIAN, estimates, way, pace)
        rows.append(plain_terms(estimates, way, pace, since))
    return np.array(rows)


def weights_of(memory: Memory) -> FloatArray:
    weights = np.empty(TERMS)
    time_left.solve(memory.sums.memory, PRIOR, weights)
    return weights


def test_the_weights_are_those_of_reweighted_least_squares_over_the_whole_history() -> None:
    random = np.random.default_rng(1)
    memory = nobody()
    movements: list[tuple[FloatArray, FloatArray, FloatArray]] = []
    weights = WEIGHTS
    np.testing.assert_allclose(weights_of(memory), WEIGHTS, rtol=1e-12)
    for n in range(40):
        start, seconds = 3.0 * n, random.uniform(0.3, 2.0)
        rows = follow(memory, random, start, seconds)
        time_left.learn(*memory.flat, (start, start + seconds), MEDIAN, PRIOR)
        left = (1.0 - SHARES) * seconds / MEDIAN
        movements.append((rows, left, 1.0 / np.maximum(np.abs(left - rows @ weights), SMALL) / JUDGED))
        products, right = SUMS.copy(), SUMS @ WEIGHTS
        for age, (x, y, weight) in enumerate(reversed(movements)):
            products += KEEP**age * (x * weight[:, None]).T @ x
            right += KEEP**age * (x * weight[:, None]).T @ y
        weights = np.linalg.solve(products, right)
        np.testing.assert_allclose(weights_of(memory), weights, rtol=1e-7, atol=1e-9)


def test_what_is_stated_is_the_weighted_sum_and_never_nothing() -> None:
    random = np.random.default_rng(2)
    for _ in range(300):
        memory = nobody()
        estimates, way, pace, since = situation(random)
        left, spread = time_left.stated(*memory.flat, (1.0, 2.0, 3.0), since, MEDIAN, estimates, way, pace)
        total = MEDIAN * float(WEIGHTS @ plain_terms(estimates, way, pace, since))
        assert left == pytest.approx(max(total, 0.05 * min(estimates.predicted, MEDIAN)), rel=1e-9)
        assert spread == pytest.approx(0.6, rel=1e-12)


def test_the_weights_are_near_those_of_the_least_absolute_error() -> None:
    """By linear programming, for a person whose time left is another sum with mostly small errors."""
    random = np.random.default_rng(3)
    own = np.array([0.2, 0.3, 0.2, 0.1, 0.1, -0.1, 0.2])
    memory, rows, left = nobody(), [], []
    for n in range(250):
        clear(memory.movement)
        for k, share in enumerate(SHARES):
            known = plain_terms(*situation(random))
            time_left.stated(
                *memory.flat, (5.0 * n + share, float(k), 0.0), 0.1, MEDIAN, *situation(random)[:3]
            )
            memory.movement.moments[k].terms[:] = known
            rows.append(known)
        # The arrival is one for all moments: each moment's constant is what makes the sum come true.
        arrival = 5.0 * n + 1.0
        y = (arrival - 5.0 * n - SHARES) / MEDIAN
        x = np.array(rows[-JUDGED:])
        miss = 0.1 * random.standard_t(1.5, JUDGED)
        x[:, 0] = (y - miss - x[:, 1:] @ own[1:]) / own[0]
        for k in range(JUDGED):
            memory.movement.moments[k].terms[:] = x[k]
        rows[-JUDGED:] = list(x)
        left.extend(y.tolist())
        time_left.learn(*memory.flat, (5.0 * n, arrival), MEDIAN, PRIOR)
    x, y = np.array(rows[-150 * JUDGED :]), np.array(left[-150 * JUDGED :])
    count = len(y)
    costs = np.concatenate([np.zeros(TERMS), np.ones(count)])
    both = np.block([[x, -np.eye(count)], [-x, -np.eye(count)]])
    bounds = [(None, None)] * TERMS + [(0.0, None)] * count
    best = optimize.linprog(costs, both, np.concatenate([y, -y]), bounds=bounds)
    error = np.abs(y - x @ weights_of(memory)).sum()
    assert error < 1.05 * best.fun
    assert np.abs(y - x @ WEIGHTS).sum() > 1.5 * best.fun


LAWS = {
    "normal": lambda random: random.standard_normal(),
    "two-sided exponential": lambda random: random.laplace(),
    "Student's of 3": lambda random: random.standard_t(3.0),
    "even": lambda random: random.uniform(-1.5, 1.5),
}


def coverage(random: np.random.Generator, name: str, size: float, movements: int) -> FloatArray:
    """Whether the intervals of 50 and 80 % held each arrival, of one person, by movement and share."""
    memory, inside = np.zeros(Intervals.length), np.empty((movements, JUDGED, 2))
    for n in range(movements):
        step = intervals.next_step(memory) / JUDGED
        for k, share in enumerate(SHARES):
            spread = intervals.spread(memory, float(np.clip(share + 0.1 * random.standard_normal(), 0, 1)))
            off = size * LAWS[name](random)
            inside[n, k] = np.abs(off) <= np.array([0.6744897501960817, 1.2815515655446004]) * spread
            intervals.judge(memory, share, step, (0.5, spread), 0.5 * float(np.exp(off)))
    return inside


@pytest.mark.parametrize("size", [0.15, 0.5, 1.5])
@pytest.mark.parametrize("name", LAWS)
def test_both_levels_are_true_after_twenty_movements(name: str, size: float) -> None:
    random = np.random.default_rng(4)
    held = np.mean([coverage(random, name, size, 45)[20:] for _ in range(20)], axis=(0, 1, 2))
    np.testing.assert_allclose(held, [0.5, 0.8], atol=0.07)


def test_unlearned_intervals_of_such_people_are_wrong() -> None:
    """The test above can fail: what is stated at first misses by far."""
    random = np.random.default_rng(5)
    first = np.mean([coverage(random, "normal", 1.5, 1) for _ in range(200)], axis=(0, 1, 2))
    assert (first < [0.3, 0.5]).all()


def test_a_stage_learns_from_the_true_share_and_no_other() -> None:
    memory = np.zeros(Intervals.length)
    intervals.judge(memory, 1.0 / 6.0, 0.1, (0.5, 0.6), 50.0)
    offsets = Intervals(memory).offsets
    assert offsets[0] > 0.0
    assert not offsets[1:].any()


@given(
    triangle=st.lists(st.floats(-1.0, 1.0), min_size=28, max_size=28),
    residuals=st.lists(st.floats(-1e9, 1e9), min_size=TERMS, max_size=TERMS),
    offsets=st.lists(st.floats(-intervals.FURTHEST, intervals.FURTHEST), min_size=3, max_size=3),
    seed=st.integers(0, 1000),
)
def test_whatever_was_learned_the_time_left_is_finite_and_what_follows_is_accepted(
    triangle: list[float], residuals: list[float], offsets: list[float], seed: int
) -> None:
    random, memory, root = np.random.default_rng(seed), nobody(), np.zeros((TERMS, TERMS))
    root[np.tril_indices(TERMS)] = triangle
    sums, made = memory.sums, root @ root.T * time_left.MOST_PRODUCT / TERMS
    sums.products[:], sums.residuals[:] = made[np.tril_indices(TERMS)], residuals
    memory.intervals.offsets[:] = offsets
    assert time_left.doubt(sums) == ""
    for n in range(3):
        follow(memory, random, 4.0 * n, 1.0)
        for one in memory.movement.moments[:JUDGED]:
            assert np.isfinite(one.memory).all()
            assert 0.0 < one.left <= time_left.FURTHEST * MEDIAN
            assert one.spread > 0.0
        time_left.learn(*memory.flat, (4.0 * n, 4.0 * n + 1.0), MEDIAN, PRIOR)
        known = memory.memory[: Sums.length + Intervals.length]
        slots = [slot for slot in slots_of(Memory) for _ in range(slot.count)]
        assert all(slot.low <= value <= slot.high for slot, value in zip(slots, known, strict=True))
        assert time_left.doubt(sums) == ""


def test_sums_that_no_terms_have_are_refused() -> None:
    learned = Sums(np.zeros(Sums.length))
    learned.products[1] = time_left.MOST_PRODUCT  # a product without the squares
    assert "pivots of at least 0.01" in time_left.doubt(learned)
