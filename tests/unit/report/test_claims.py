"""Figures of claims show what the summary says, and nothing where nothing is claimed."""

import numpy as np
import pytest
from msgspec.structs import replace

from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.report import write_report
from pointpred.scoring.report.figures import inside_curves, time_left_bars
from pointpred.scoring.summary import summarise


@pytest.fixture(scope="module")
def claiming(make_score):
    """A score in which `kinematic` claims regions and times, and `kalman` regions up to half of the time."""
    scored = make_score(people=3, repeats=1)
    random, count = np.random.default_rng(5), len(scored.trials)
    inside = (random.random((count, len(DECILES), 1)) < np.array([0.5, 0.8, 0.95])).astype(float)
    early = inside.copy()
    early[:, 5:] = np.nan
    regions = np.tile([1.0, 0.5, 0.8, 0.95, 20.0], (count, 1))
    left = np.column_stack([np.ones(count), np.full(count, 0.09), np.full(count, 0.12), *np.ones((4, count))])
    left[:, 4:] = 0.5, 0.8, 0.95
    told = {
        "kinematic": {"inside_by_time": inside, "time_left": left, "time_inside_by_time": inside},
        "kalman": {"inside_by_time": early},
    }
    changed = [
        replace(p, calibration=regions, **told[p.name]) if p.name in told else p for p in scored.predictors
    ]
    return replace(scored, predictors=tuple(changed))


@pytest.fixture(scope="module")
def described(claiming):
    return summarise(claiming, draws=50)


def test_those_who_claim_are_drawn_and_no_others(described):
    drawn = inside_curves(described, "calibration")
    assert "kinematic 50/80/95 % over all the time" in drawn.alt
    assert ">kalman<" in drawn.svg
    assert ">linear<" not in drawn.svg
    times = inside_curves(described, "time_left")
    assert ">kinematic<" in times.svg
    assert ">kalman<" not in times.svg


def test_the_time_left_stands_beside_the_clock(described):
    drawn = time_left_bars(described)
    assert "kinematic 0.75." in drawn.alt
    assert "The clock, 120 ms off," in drawn.caption


def test_nothing_is_drawn_without_claims(make_score):
    silent = summarise(make_score(people=2, repeats=1), draws=20)
    assert inside_curves(silent, "calibration") is None
    assert inside_curves(silent, "time_left") is None
    assert time_left_bars(silent) is None


def test_the_report_shows_them(claiming, tmp_path):
    write_report([claiming], tmp_path / "out.html")
    page = (tmp_path / "out.html").read_text()
    for title in ("Endpoints inside the predicted regions", "Arrivals inside", "Time left beside a clock"):
        assert page.count(f'alt="{title}') == 1
