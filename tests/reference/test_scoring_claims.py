"""Claims against scipy's laws, draws from them, and plain Python over the definitions."""

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
from pointpred.scoring.measures import regions
from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.measures.regions import INSIDE, LEVELS, RANKED
from pointpred.scoring.results import TIME_FRACTIONS
from tests.scripted import Scripted, pipeline_with

END = np.array([300.0, -200.0])
SHAPE = np.array([[900.0, -500.0], [-500.0, 1600.0]])
TAIL, SPREAD, WHOLE_S = 3.0, 0.4, 0.998


class Claiming(Scripted):
    """Points drawn around the end by a Student law; times left drawn around the truth by a log-normal one."""

    def __init__(
        self, *, tail: float | None = TAIL, late_factor: float = 1.0, silent_from: float = 2.0
    ) -> None:
        super().__init__()
        self.tail, self.late_factor, self.silent_from = tail, late_factor, silent_from

    def answers(self, motions: MotionColumns, begin: BoolArray) -> FloatArray:
        random = np.random.default_rng(round(motions.t[0]))
        passed = motions.t - np.repeat(
            motions.t[begin], np.diff(np.append(np.flatnonzero(begin), len(motions)))
        )
        table = np.full((len(motions), 10), np.nan)
        table[:, 1:3] = stats.multivariate_t(END, SHAPE, TAIL, seed=random).rvs(len(motions))
        half = np.where(passed > 0.5 * WHOLE_S, self.late_factor, 1.0)
        for column, value in zip((3, 4, 5), (SHAPE[0, 0], SHAPE[0, 1], SHAPE[1, 1]), strict=True):
            table[:, column] = value * half
        table[:, 8] = np.nan if self.tail is None else self.tail
        left = np.maximum(ARRIVAL_S - passed, 1e-6)
        table[:, 6] = left * np.exp(SPREAD * random.standard_normal(len(motions)))
        table[:, 9] = SPREAD
        table[passed > self.silent_from, 3:] = np.nan
        table[:, 7] = 1.0
        return table


def pipeline(**settings: Any) -> Pipeline:
    return pipeline_with("claiming", Claiming(**settings))


def reaches(count: int = 300) -> Recording:
    s = np.linspace(0.0, 1.0, 500)
    # Every trial at another time, which the draws are seeded with.
    parts = [EventColumns.of(k + 0.002 * np.arange(500), END[0] * s, END[1] * s) for k in range(count)]
    trials = [
        Trial(f"u{i % 7}", str(i), target_x=305.0, target_y=-200.0, target_w=60.0) for i in range(count)
    ]
    return Recording.of("reaches", parts, trials)


RECORDING = reaches()
ARRIVAL_S = prepare(RECORDING).trials[0].arrival_s


@pytest.mark.parametrize("tail", [0.4, 1.3, 3.0, 40.0])
@pytest.mark.parametrize("z", [-30.0, -1.5, -0.01, 0.0, 0.7, 4.0])
def test_the_distribution_is_scipys(z: float, tail: float) -> None:
    assert regions.distribution(z, tail) == pytest.approx(stats.t.cdf(z, tail), rel=1e-9, abs=1e-15)


@pytest.mark.parametrize("tail", [1.5, 3.0, 40.0])
@pytest.mark.parametrize("error", [-25.0, 0.0, 4.0])
def test_the_ranked_score_is_the_integral_of_the_squared_distance(error: float, tail: float) -> None:
    law = stats.t(tail, scale=3.0)
    below = integrate.quad(lambda y: law.cdf(y) ** 2, -np.inf, error, limit=500)[0]
    above = integrate.quad(lambda y: law.sf(y) ** 2, error, np.inf, limit=500)[0]
    assert regions.student_score(error, 3.0, tail) == pytest.approx(below + above, rel=1e-4)


def test_a_law_without_a_mean_has_no_bound() -> None:
    assert regions.student_score(1.0, 1.0, 1.0) == np.inf
    assert regions.student_score(-5.0, 0.0, 3.0) == 5.0


def test_regions_with_a_tail_hold_what_they_say() -> None:
    found = replay(prepare(RECORDING), pipeline()).calibration
    assert found is not None
    assert found[:, INSIDE:RANKED].mean(axis=0) == pytest.approx(LEVELS, abs=0.01)


def test_the_same_regions_called_normal_hold_less() -> None:
    found = replay(prepare(RECORDING), pipeline(tail=None)).calibration
    assert found is not None
    # Of a bivariate Student law a share 1 - (1 + far / nu)^(-nu / 2) lies within the squared distance `far`.
    wanted = [1.0 - (1.0 - 2.0 * np.log(1.0 - p) / TAIL) ** (-0.5 * TAIL) for p in LEVELS]
    assert found[:, INSIDE:RANKED].mean(axis=0) == pytest.approx(wanted, abs=0.01)


def test_deciles_tell_early_claims_from_late_ones() -> None:
    found = replay(prepare(RECORDING), pipeline(late_factor=0.25)).inside_by_time
    assert found is not None
    shares = found.mean(axis=0)
    early, late = np.array(DECILES) < 0.45, np.array(DECILES) > 0.55
    assert shares[early].mean(axis=0) == pytest.approx(LEVELS, abs=0.04)
    wanted = [1.0 - (1.0 + 0.25 * ((1.0 - p) ** (-2.0 / TAIL) - 1.0)) ** (-0.5 * TAIL) for p in LEVELS]
    assert shares[late].mean(axis=0) == pytest.approx(wanted, abs=0.04)


def test_silence_is_no_claim_at_its_deciles() -> None:
    one = replay(prepare(RECORDING), pipeline(silent_from=0.5 * ARRIVAL_S))
    assert one.inside_by_time is not None
    assert one.time_inside_by_time is not None
    assert np.isnan(one.inside_by_time[0]).all(axis=1).tolist() == [share > 0.5 for share in DECILES]
    assert np.isnan(one.time_inside_by_time[0]).all(axis=1).tolist() == [share > 0.5 for share in DECILES]


def test_intervals_of_the_time_left_hold_what_they_say() -> None:
    told = summarise(score([RECORDING], [pipeline()])[0], draws=50).predictors[1].time_left
    assert list(told.inside.values()) == pytest.approx(LEVELS, abs=0.01)
    assert told.claimed == 1.0
    by_time = [list(cell.inside.values()) for cell in told.by_time.values()]
    assert np.mean(by_time, axis=0) == pytest.approx(LEVELS, abs=0.02)
    # The mean of |1 - exp(s z)|, integrated, times the mean time left, which is half of the whole.
    share = integrate.quad(lambda z: abs(1.0 - np.exp(SPREAD * z)) * stats.norm.pdf(z), -10.0, 10.0)[0]
    assert told.s == pytest.approx(share * 0.5 * ARRIVAL_S, rel=0.02)


def steady(durations: list[float]) -> Recording:
    """Even movements of 400 px that stop at once; each takes another time."""
    parts = [
        EventColumns.of(s * np.linspace(0, 1, 101), np.linspace(0, 400, 101), np.zeros(101))
        for s in durations
    ]
    return Recording.of("steady", parts, [Trial("ann", str(i)) for i in range(len(durations))])


class Says(Scripted):
    """Says one time left, always."""

    def __init__(self, seconds: float) -> None:
        super().__init__()
        self.seconds = seconds

    def answers(self, motions: MotionColumns, begin: BoolArray) -> FloatArray:
        table = np.full((len(motions), 10), np.nan)
        table[:, 1], table[:, 2], table[:, 6], table[:, 7] = motions.x, motions.y, self.seconds, 1.0
        return table


def test_the_clock_knows_the_median_of_the_set_and_nothing_else() -> None:
    prepared = prepare(steady([0.5, 1.0, 2.0]))
    times = [trial.arrival_s for trial in prepared.trials]
    left = replay(prepared, Pipeline("says", build("hold").differentiator, Says(0.25))).time_left  # type: ignore[arg-type]
    assert left is not None
    for k, whole in enumerate(times):
        passed = np.linspace(0.0, whole, 20_001)
        clock = np.abs(whole - passed - np.maximum(times[1] - passed, 0.0)).mean()
        assert left[k, 2] == pytest.approx(clock, abs=0.02 * whole)
        assert left[k, 1] == pytest.approx(np.abs(whole - passed - 0.25).mean(), abs=0.02 * whole)
    assert left[1, 2] == pytest.approx(0.0, abs=1e-12)
    assert np.isnan(left[:, 4:]).all()
    assert replay(prepared, build("hold")).time_left is None


def test_where_no_time_is_claimed_the_clock_is_scored() -> None:
    quiet = replay(prepare(RECORDING), pipeline(silent_from=0.5 * ARRIVAL_S)).time_left
    assert quiet is not None
    assert quiet[:, 0] == pytest.approx(0.5, abs=0.01)
    # Every trial takes the median time: the clock is right, and silence costs nothing.
    loud = replay(prepare(RECORDING), pipeline()).time_left
    assert loud is not None
    assert quiet[:, 1].mean() == pytest.approx(0.75 * loud[:, 1].mean(), rel=0.05)


def test_hits_are_those_of_plain_geometry() -> None:
    prepared = prepare(RECORDING)
    found = replay(prepared, pipeline()).hits
    cursor = replay(prepared, build("hold")).hits
    assert found is not None
    assert cursor is not None
    law = stats.multivariate_t(END, SHAPE, TAIL, seed=1).rvs(200_000)
    assert found.mean() == pytest.approx(
        (np.hypot(law[:, 0] - 305.0, law[:, 1] + 200.0) <= 30.0).mean(), abs=0.02
    )
    for share, hit in zip(TIME_FRACTIONS, cursor[0].tolist(), strict=True):
        x, y = share * ARRIVAL_S / WHOLE_S * END
        assert hit == (1.0 if np.hypot(x - 305.0, y + 200.0) <= 30.0 else 0.0)


def test_without_a_target_there_is_no_hit() -> None:
    known = steady([0.5, 1.0])
    assert replay(prepare(known), build("hold")).hits is None
    assert summarise(score([known], [])[0], draws=20).predictors[0].hits is None


def test_the_summary_counts_trials_with_a_target_and_gives_intervals() -> None:
    one = summarise(score([RECORDING], [pipeline()])[0], draws=200).predictors[1]
    assert one.hits.trials == 300
    cell = one.hits.by_time[0.5]
    low, high = cell.interval
    assert low < cell.share < high
    decile = one.calibration.by_time[0.4]
    assert decile.trials == 300
    low, high = decile.interval[0.8]
    assert low < decile.inside[0.8] < high
