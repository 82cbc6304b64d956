"""The scorer on recordings of real movements: every trial is scored or accounted for."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from pointpred.recordings.own import read
from pointpred.scoring import rows, score, summarise

FOLDER = os.environ.get("POINTPRED_RECORDINGS")
FILES = sorted(Path(FOLDER).glob("*_samples.parquet")) if FOLDER else []

pytestmark = [
    pytest.mark.recordings,
    pytest.mark.skipif(not FILES, reason="POINTPRED_RECORDINGS names no folder with recordings"),
]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name.removesuffix("_samples.parquet"))
def test_trial_counts_add_up_and_the_floor_falls_towards_the_end(path: Path) -> None:
    import pandas as pd

    listed = pd.read_parquet(path.with_name(path.name.replace("_samples", "_trials")))
    scored = score([read(path)], ["hold"])[0]
    assert len(scored.trials) + len(scored.skipped) == len(listed)
    assert len(scored.trials) > 0.97 * len(listed)
    hold = scored.predictors[0]
    assert np.array_equal(hold.coverage, np.ones(len(scored.trials)))
    assert hold.failed == ()
    means = hold.by_time.mean(axis=0)
    assert (np.diff(means) < 0.0).all()
    described = summarise(scored, draws=50)
    assert described.predictors[0].time_averaged.of_hold == 1.0
    assert described.trials == len(scored.trials)
    assert rows(described)[0][0] == "hold"
