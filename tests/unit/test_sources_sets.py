"""The public sets in POINTPRED_RECORDINGS: every trial is read or reported, as a second reader sees it."""

import os
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pointpred.recordings import read, read_any

FOLDER = os.environ.get("POINTPRED_RECORDINGS")
pytestmark = [
    pytest.mark.recordings,
    pytest.mark.skipif(FOLDER is None, reason="POINTPRED_RECORDINGS names no folder of recordings"),
]
TRIALS = {
    "freihaut2021": 1653,
    "pvplib23714": 480,
    "cryslacks": 2261,
    "kh2017": 1140,
    "humanmovemouse": 331,
    "gofitts_demo": 81,
    "jrcalgo": 297,
}
CLEAN = {
    "freihaut2021": 1303,
    "pvplib23714": 179,
    "cryslacks": 1649,
    "kh2017": 756,
    "humanmovemouse": 328,
    "gofitts_demo": 66,
    "jrcalgo": 205,
}


def path_of(name: str) -> Path:
    path = Path(FOLDER or ".") / f"{name}_samples.parquet"
    if not path.exists():
        pytest.skip(f"{name} is not in POINTPRED_RECORDINGS")
    return path


@pytest.mark.parametrize("name", TRIALS)
def test_every_trial_is_read_or_reported(name: str) -> None:
    recording = read(path_of(name))
    assert len(recording.trials) + len(recording.skipped) == TRIALS[name]
    assert sum(trial.clean is True for trial in recording.trials) == CLEAN[name]
    still = [skip for skip in recording.skipped if skip.reason.startswith("no movement")]
    assert len(recording.skipped) == len(still) == {"pvplib23714": 2}.get(name, 0)


@pytest.mark.parametrize("name", TRIALS)
def test_pandas_reads_the_same(name: str) -> None:
    recording = read(path_of(name))
    frame = pd.read_parquet(path_of(name))
    groups = frame.groupby(["user", frame["trial"].astype(str)], sort=False)
    for index, trial in list(enumerate(recording.trials))[::37]:
        rows = groups.get_group((trial.user, trial.trial))
        np.testing.assert_array_equal(recording.rows(index).table[:, :3], rows[["t_s", "x_px", "y_px"]])


def test_mice_recorded_with_evemu() -> None:
    folder = Path(FOLDER or ".") / "evemu_mice"
    if not folder.exists():
        pytest.skip("evemu_mice is not in POINTPRED_RECORDINGS")
    (recording,) = read_any(folder)
    assert recording.provenance.unit == "counts"
    sums: dict[str, np.ndarray] = {}
    for index, trial in enumerate(recording.trials):
        part = recording.rows(index)
        np.testing.assert_array_equal(np.diff(part.x), part.dx[1:])  # the position is the sum of the counts
        np.testing.assert_array_equal(np.diff(part.y), part.dy[1:])
        file = trial.trial.rsplit(" ", 1)[0]
        sums[file] = sums.get(file, np.zeros(2)) + np.array([part.dx.sum(), part.dy.sum()])
    assert len(sums) == 3
    reported = [skip for skip in recording.skipped if skip.reason.startswith("samples: 1")]
    for file, total in sums.items():
        lines = [line.split() for line in (folder / file).read_text(encoding="utf-8").splitlines()]
        moves = [line for line in lines if line[:1] == ["E:"] and line[2] == "0002"]
        expected = [sum(int(line[4]) for line in moves if line[3] == axis) for axis in ("0000", "0001")]
        if not any(skip.trial.startswith(file) for skip in reported):
            np.testing.assert_array_equal(total, expected)
