"""Scores with numbers from a seeded generator: people, conditions, good and poor predictors."""

import numpy as np
import pytest

from pointpred.recording import Skip, Trial
from pointpred.scoring.results import (
    AXIS_FRACTIONS,
    PATH_FRACTIONS,
    TIME_FRACTIONS,
    PredictorErrors,
    ScoredTrial,
    SetScore,
)

FACTORS = {
    "hold": 1.0, "switched-printed": 0.9, "kep-quartic-gated": 1.4, "kep-quadratic": 1.8, "kinematic": 0.7,
    "linear": 1.05, "kalman": 0.97, "minimum-jerk": 0.92, "ktm": 1.1,
}  # fmt: skip


def errors(name, distances, generator):
    def series(fractions):
        left = 1.0 - np.array(fractions)
        noise = generator.gamma(2.0, 0.5, size=(len(distances), len(fractions)))
        floor = 0.0 if name == "hold" else 0.03
        return distances[:, None] * (FACTORS[name] * left + floor) * noise

    by_time, by_path, axis = (series(f) for f in (TIME_FRACTIONS, PATH_FRACTIONS, AXIS_FRACTIONS))
    if name.startswith("kep"):
        axis[generator.random(axis.shape) < 0.04] += 2000.0
    coverage = np.full(len(distances), 1.0 if name == "hold" else 0.9)
    cost = 0.3 * (1 + list(FACTORS).index(name))
    return PredictorErrors(name, by_time.mean(axis=1), by_time, by_path, axis, coverage, cost)


def make(name="synthetic", people=6, repeats=3, names=tuple(FACTORS), user="user", **more):
    generator = np.random.default_rng(17)
    trials = []
    for who in range(people):
        for distance in (200.0, 600.0):
            for width in (20.0, 60.0):
                for k in range(repeats):
                    about = Trial(
                        f"{user} {who}", f"{user} {who} {distance:g} {width:g} {k}",
                        target_w=width, clean=bool(generator.random() < 0.7),
                        condition={"distance": distance},
                    )  # fmt: skip
                    divided = bool(generator.random() < 0.3 + 0.5 * (who % 2))
                    length = distance + generator.normal(0.0, 5.0)
                    trials.append(ScoredTrial(about, length, 0.2, 0.8, divided, 80))
    distances = np.array([trial.distance_px for trial in trials])
    scored = tuple(errors(one, distances, generator) for one in names)
    skipped = (Skip("lost", "has no events", 4),)
    return SetScore(name, tuple(trials), skipped, scored, **more)


@pytest.fixture(scope="session")
def make_score():
    return make


@pytest.fixture(scope="session")
def score():
    return make()
