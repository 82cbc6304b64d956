"""The laws of adaptation against plain numpy that keeps the whole history."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.predictors.adaptation import distances, stages
from pointpred.predictors.adaptation.distances import Ahead
from pointpred.predictors.adaptation.stages import Moment
from pointpred.records import FloatArray

FORGETTING, RIDGE = 0.97, 20.0
LAWS = [(time, width) for time in (1.5, 12.0) for width in (0.02, 0.08, 0.35)]


def remembered(history: list[float]) -> FloatArray:
    memory = np.zeros(distances.Distances.length)
    for distance in history:
        distances.remember(memory, distance)
    return memory


def density(history: list[float], time: float, width: float, at: FloatArray) -> FloatArray:
    """Of the logarithm of the distance: kernels around the last twelve, the older the lighter."""
    last = np.array(history[::-1][:12])
    weight = np.exp(-np.arange(len(last)) / time)
    bumps = np.exp(-0.5 * ((np.log(at)[:, None] - np.log(last)) / width) ** 2)
    found: FloatArray = (bumps * weight / weight.sum()).sum(axis=1) / (width * np.sqrt(2.0 * np.pi))
    return found


def beliefs(history: list[float]) -> FloatArray:
    """Bayes' rule, movement after movement; a share of 0.05 starts anew; the last: nothing is known."""
    first = np.array([0.02 / 6.0] * 6 + [0.98])
    belief = first
    for count in range(2, len(history)):
        at = np.array(history[count : count + 1])
        likely = [density(history[:count], time, width, at)[0] for time, width in LAWS]
        belief = belief * np.array([*np.maximum(3.0 * np.array(likely), 1e-12), 1.0])
        belief = 0.95 * belief / belief.sum() + 0.05 * first
    return belief


HISTORIES = {
    "one distance": [400.0, 402.0, 398.0, 401.0, 400.0, 399.0],
    "two in turn": [300.0, 600.0] * 9,
    "a block after another": [250.0] * 7 + [700.0] * 3,
    "free": list(np.exp(np.random.default_rng(5).uniform(4.0, 7.0, 20))),
}


@pytest.mark.parametrize("history", HISTORIES.values(), ids=HISTORIES)
def test_belief_is_bayes_rule(history: list[float]) -> None:
    memory = remembered(history)
    own = distances.Distances(memory).belief
    np.testing.assert_allclose(own, beliefs(history), rtol=1e-9, atol=1e-14)


@pytest.mark.parametrize("ahead", [60.0, 180.0, 420.0])
@pytest.mark.parametrize("wide", [12.0, 80.0, 200.0])
@pytest.mark.parametrize("history", HISTORIES.values(), ids=HISTORIES)
def test_the_answer_is_the_median_of_the_product(history: list[float], wide: float, ahead: float) -> None:
    """With a normal law the product is known: integrated over a fine grid it gives the same median."""
    reached = 120.0
    memory = remembered(history)
    own, width, _ = distances.combine(memory, reached, Ahead(ahead, wide, 0.0, 1e9))
    grid = np.linspace(ahead - 8.0 * wide, ahead + 8.0 * wide, 400_001)
    law = np.exp(-0.5 * ((grid - ahead) / wide) ** 2)
    belief, last = beliefs(history), np.array(history[::-1][:12])
    prior = np.full(len(grid), belief[6])
    for place, (time, kernel) in enumerate(LAWS):
        weight = np.exp(-np.arange(len(last)) / time)
        for part, distance in zip(belief[place] * weight / weight.sum(), last, strict=True):
            bump = np.exp(-0.5 * ((reached + grid - distance) / (kernel * distance)) ** 2)
            prior += 3.0 * part * bump / (kernel * np.sqrt(2.0 * np.pi))
    mass = np.cumsum(law * prior)
    quantiles = np.interp([0.45, 0.5, 0.55], mass / mass[-1], grid)
    # The logistic law in place of the normal one moves a quantile by up to a hundredth.
    assert quantiles[0] - 0.05 * width <= own <= quantiles[2] + 0.05 * width
    spread = np.sqrt((law * prior * (grid - own) ** 2).sum() / mass[-1])
    assert width == pytest.approx(min(spread, wide), rel=0.03)


def test_nearer_where_the_direction_is_uncertain() -> None:
    memory = remembered([400.0] * 12)
    sure, _, _ = distances.combine(memory, 10.0, Ahead(300.0, 120.0, 0.0, 8.0))
    unsure, _, _ = distances.combine(memory, 10.0, Ahead(300.0, 120.0, 200.0, 8.0))
    assert sure == pytest.approx(390.0, abs=3.0)
    assert unsure == pytest.approx(400.0 / np.sqrt(1.0 + 0.5 * 0.25) - 10.0, abs=3.0)


def moment(random: np.random.Generator) -> tuple[Moment, float, float, float]:
    """A moment of a movement along x, and where and when it ended."""
    reached, ahead = random.uniform(20.0, 300.0), random.uniform(20.0, 300.0)
    t, across = random.uniform(0.1, 0.5), random.normal(0.0, 5.0)
    wide, broad = random.uniform(10.0, 60.0, 2).tolist()
    tail, left = random.uniform(2.0, 20.0), random.uniform(0.2, 0.6)
    x = reached + 1.2 * ahead + 10.0 * random.standard_t(3.0)
    said = (1.0, t, reached, 0.0, 1.0, 0.0, ahead, across, wide, broad, tail, left, reached)
    m = Moment(np.array(said))
    return m, x, random.normal(0.0, 15.0), t + random.uniform(0.2, 0.9)


def test_the_bias_is_weighted_least_squares_over_the_whole_history() -> None:
    random = np.random.default_rng(3)
    stage = stages.Stage(np.zeros(stages.Stage.length))
    inputs: list[FloatArray] = []
    targets: list[float] = []
    weights: list[float] = []
    theta = np.zeros(2)
    across2: list[float] = []
    along2: list[float] = []
    for _ in range(60):
        m, x, y, t = moment(random)
        total = np.hypot(m.reached + m.along, m.across)
        inputs.append(np.array([total, m.along]) / m.wide)
        targets.append((x - m.x - m.along) / m.wide)
        rest = targets[-1] - inputs[-1] @ theta
        weights.append((m.tail + 1.0) / (m.tail + rest**2))
        ages = FORGETTING ** np.arange(len(targets) - 1, -1, -1)
        for kept, off in ((along2, rest), (across2, (y - m.across) / m.broad)):
            scale = (ages[:-1] @ np.array(kept) + 2.0) / (ages[:-1].sum() + 2.0)
            kept.append((m.tail + 1.0) / (m.tail + off**2 / scale) * off**2)
        rows, weight = np.array(inputs), ages * np.array(weights)
        gram = (rows * weight[:, None]).T @ rows + RIDGE * np.eye(2)
        theta = np.linalg.solve(gram, (rows * weight[:, None]).T @ np.array(targets))
        stages.learn(stage.memory, m.memory, x, y, t)
    np.testing.assert_allclose([stage.total, stage.ahead], theta, rtol=1e-9)
    np.testing.assert_allclose(stage.count, ages.sum(), rtol=1e-12)
    np.testing.assert_allclose(stage.wide, ages @ np.array(along2), rtol=1e-9)
    np.testing.assert_allclose(stage.broad, ages @ np.array(across2), rtol=1e-9)


def test_between_stages_lie_lines() -> None:
    known = stages.Stages(np.zeros(stages.Stages.length))
    for number, stage in enumerate(known.stages):
        stage.total = 0.1 * (number + 1) ** 2
        stage.bias_paid = stage.bias_size = 1e12
    shares = np.linspace(0.0, 1.0, 200)
    own = [stages.correct(known.memory, share, 100.0, 50.0)[0] for share in shares]
    knots = [10.0 * (stage + 1) ** 2 for stage in range(stages.STAGES)]
    expected = np.interp(shares, [0.1, 0.3, 0.5, 0.7, 0.9], knots)
    np.testing.assert_allclose(own, expected, rtol=1e-9, atol=1e-9)
