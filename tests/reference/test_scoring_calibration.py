"""Regions and their score against the normal law, integrated and drawn."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import integrate, stats

from pointpred import EventColumns, build
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording, Trial
from pointpred.records import BoolArray, FloatArray, MotionColumns
from pointpred.scoring import prepare, replay, score, summarise
from pointpred.scoring.measures.regions import CLAIMED, INSIDE, RANKED, calibrate, ranked_score
from tests.scripted import Scripted, pipeline_with

COVARIANCE = np.array([[900.0, -500.0], [-500.0, 1600.0]])


class Regions(Scripted):
    """Predicts points drawn around the end (300, -200) with a known covariance, and claims another."""

    def __init__(self, claimed: np.ndarray, silent: bool = False) -> None:
        super().__init__()
        self.claimed, self.silent = claimed, silent

    def answers(self, motions: MotionColumns, begin: BoolArray) -> FloatArray:
        random = np.random.default_rng(len(motions))
        table = np.full((len(motions), 10), np.nan)
        table[:, 1:3] = random.multivariate_normal([300.0, -200.0], COVARIANCE, len(motions))
        table[:, 3:6] = self.claimed[0, 0], self.claimed[0, 1], self.claimed[1, 1]
        if self.silent:
            table[::2, 3:6] = np.nan
        return table


def pipeline(claimed: np.ndarray, **settings: Any) -> Pipeline:
    return pipeline_with("regions", Regions(claimed, **settings))


@pytest.fixture(scope="module")
def recording() -> Recording:
    s = np.linspace(0.0, 1.0, 500)
    part = EventColumns.of(0.002 * np.arange(500), 300.0 * s, -200.0 * s)
    return Recording.of("reaches", [part] * 60, [Trial("ann", str(i)) for i in range(60)])


def test_honest_regions_hold_as_many_endpoints_as_they_say(recording: Recording) -> None:
    found = replay(prepare(recording), pipeline(COVARIANCE)).calibration
    assert found is not None
    assert found[:, CLAIMED].tolist() == [1.0] * 60
    assert found[:, INSIDE:RANKED].mean(axis=0) == pytest.approx([0.5, 0.8, 0.95], abs=0.015)
    best = (30.0 + 40.0) / 2 / np.sqrt(np.pi)  # mean score of a normal law about itself: sigma / sqrt(pi)
    assert found[:, RANKED].mean() == pytest.approx(best, rel=0.02)


@pytest.mark.parametrize("factor", [0.25, 4.0])
def test_regions_too_small_or_too_large_show_and_score_worse(recording: Recording, factor: float) -> None:
    honest = replay(prepare(recording), pipeline(COVARIANCE)).calibration
    found = replay(prepare(recording), pipeline(factor * COVARIANCE)).calibration
    assert honest is not None
    assert found is not None
    expected = [stats.chi2.cdf(factor * stats.chi2.ppf(p, 2), 2) for p in (0.5, 0.8, 0.95)]
    assert found[:, INSIDE:RANKED].mean(axis=0) == pytest.approx(expected, abs=0.015)
    assert found[:, RANKED].mean() > 1.02 * honest[:, RANKED].mean()


@pytest.mark.parametrize(("error", "deviation"), [(0.0, 3.0), (5.0, 3.0), (-40.0, 3.0), (2.0, 50.0)])
def test_ranked_score_is_the_integral_of_the_squared_distance_of_distributions(
    error: float, deviation: float
) -> None:
    law = stats.norm(0.0, deviation)
    below = integrate.quad(lambda y: law.cdf(y) ** 2, -1000.0, error, points=[0.0], limit=200)[0]
    above = integrate.quad(lambda y: law.sf(y) ** 2, error, 1000.0, points=[0.0], limit=200)[0]
    assert ranked_score(error, deviation) == pytest.approx(below + above, rel=1e-5)


def test_a_region_without_width_scores_the_error_and_holds_nothing() -> None:
    rows = np.array([[0.0, 0.0, 0.0], [0.01, 50.0, 0.0], [0.02, 100.0, 0.0]])
    answers = np.full((3, 10), np.nan)
    answers[:, 1:6] = 97.0, 4.0, 0.0, 0.0, 0.0
    out = np.empty((1, 5))
    calibrate(rows, answers, np.array([0, 3]), np.array([2]), out)
    assert out[0].tolist() == pytest.approx([1.0, 0.0, 0.0, 0.0, 3.5], rel=1e-12)


def test_claims_are_weighed_by_time_and_silence_is_no_claim(recording: Recording) -> None:
    found = replay(prepare(recording), pipeline(COVARIANCE, silent=True)).calibration
    assert found is not None
    assert found[:, CLAIMED] == pytest.approx(0.5, abs=0.01)
    assert replay(prepare(recording), build("hold")).calibration is None


def test_the_summary_says_how_often_regions_held(recording: Recording) -> None:
    hold, regions = summarise(score([recording], [pipeline(COVARIANCE)])[0], draws=20).predictors
    assert hold.calibration is None
    assert regions.calibration.claimed == 1.0
    assert list(regions.calibration.inside) == [0.5, 0.8, 0.95]
    assert regions.calibration.inside[0.8] == pytest.approx(0.8, abs=0.02)
