"""Bad recordings: a clear error that names file and row, or a skip with reason and row; nothing vanishes."""

from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from pointpred.errors import RecordingError
from pointpred.recording import Recording, Skip, Trial
from pointpred.recordings import read, write
from pointpred.records import EventColumns
from tests.building import text_file

HEADER = "user,trial,t_s,x_px,y_px\n"
GOOD = "u,good,0,0,0\nu,good,1,3,4\n"


def samples(folder: Path, text: str, name: str = "set_samples.csv") -> Path:
    return text_file(folder / name, text)


@pytest.mark.parametrize(
    ("rows", "reason", "row"),
    [
        ("u,bad,0,0,0\nu,bad,1,nan,0\n", "x is nan, expected a finite number", 3),
        ("u,bad,0,0,0\nu,bad,,1,0\n", "t is nan, expected a finite number", 3),
        ("u,bad,0,0,0\nu,bad,1,1,inf\n", "y is inf, expected a finite number", 3),
        ("u,bad,0,0,0\nu,bad,1,1e10,0\n", "x is 10000000000.0, expected at most 1e+09 either way", 3),
        ("u,bad,0,0,0\nu,bad,1.7e12,1,0\n", "t is 1700000000000.0, expected at most 1e+11 either way", 3),
        ("u,bad,0,0,0\nu,bad,1,left,0\n", "x_px is 'left', expected a number", 3),
        ("u,bad,2,0,0\nu,bad,2,1,0\nu,bad,1.5,2,0\n", "time goes backwards, from 2.0 s to 1.5 s", 4),
        ("u,bad,0,0,0\n", "one sample, expected at least two", 2),
        ("u,bad,0,5,5\nu,bad,1,5,5\nu,bad,2,5,5\n", "no movement: every position equals the first", 2),
    ],
)
def test_a_bad_trial_is_skipped_with_its_row(rows: str, reason: str, row: int, tmp_path: Path) -> None:
    recording = read(samples(tmp_path, HEADER + GOOD + rows))
    assert recording.skipped == (Skip("bad", reason, row, "u"),)
    assert [trial.trial for trial in recording.trials] == ["good"]
    assert recording.rows(0).x.tolist() == [0, 3]


def test_buttons_and_counts_are_checked(tmp_path: Path) -> None:
    text = "user,trial,t_s,x_px,y_px,dx_counts,dy_counts,buttons\n"
    text += (
        "u,1,0,0,0,,,0\nu,1,1,1,0,,,-1\nu,2,0,0,0,0,0,0\nu,2,1,0,0,5,0,0\nu,3,0,0,0,0,0,\nu,3,1,1,0,0,0,0\n"
    )
    recording = read(samples(tmp_path, text))
    assert [trial.trial for trial in recording.trials] == ["2"]  # counts moved while the cursor could not
    assert [(skip.trial, skip.row) for skip in recording.skipped] == [("1", 1), ("3", 4)]
    assert "expected a whole number from 0 to 65535" in recording.skipped[0].reason


def test_one_count_without_the_other_is_skipped_with_its_row_and_the_rest_is_kept(tmp_path: Path) -> None:
    text = "user,trial,t_s,x_px,y_px,dx_counts,dy_counts\n"
    text += "u,1,0,0,0,0,0\nu,1,1,9,0,4,\nu,2,0,0,0,,\nu,2,1,9,0,,3\nu,3,0,0,0,,\nu,3,1,9,0,4,3\n"
    recording = read(samples(tmp_path, text))
    assert [trial.trial for trial in recording.trials] == ["3"]
    assert recording.skipped == (
        Skip("1", "dx is 4.0 and dy nan, expected both or neither", 1, "u"),
        Skip("2", "dx is nan and dy 3.0, expected both or neither", 3, "u"),
    )


def test_equal_times_and_a_first_time_of_zero_are_normal(tmp_path: Path) -> None:
    recording = read(samples(tmp_path, HEADER + "u,1,0,0,0\nu,1,0,1,0\nu,1,0,2,0\n"))
    assert recording.skipped == ()
    assert len(recording.events) == 3


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the file is empty"),
        ("\n", "Empty CSV|missing"),
        ("user,trial,t_s,x_px\nu,1,0,0\n", "column 'y_px' is missing, found user, trial, t_s, x_px"),
        ("user,trial,t_s,x_px,y_px,pressure\nu,1,0,0,0,1\n", "unknown column 'pressure', expected only"),
        ("user,trial,t_s,x_px,y_px,t_s\nu,1,0,0,0,1\n", "column 't_s' occurs twice"),
        (HEADER + GOOD + "u,1,0.5,7\n", r"data row 2 \(counted from 0\): 4 cells, expected 5"),
        (HEADER + GOOD + "u,1,0.5,7,8,9\n", r"data row 2 \(counted from 0\): 6 cells, expected 5"),
        (
            "dataset," + HEADER + "a,u,1,0,0,0\nb,u,1,1,0,0\n",
            r"data row 1 \(counted from 0\) belongs to data set 'b', expected 'a'",
        ),
        ("# pointpred:{oops\n" + HEADER + GOOD, "header is not JSON"),
        ('# pointpred:{"version":7}\n' + HEADER + GOOD, "header version 7, expected 1"),
        (
            '# pointpred:{"version":1,"rows":3}\n' + HEADER + GOOD,
            "truncated, it holds 2 rows, expected 3 rows",
        ),
        ('# pointpred:{"version":1}\n' + HEADER + GOOD[:-1], "last row does not end with a line break"),
        ('# pointpred:{"version":1,"provenance":{"dpi":"x"}}\n' + HEADER + GOOD, "not as expected"),
    ],
)
def test_a_bad_file_is_an_error_that_names_it(text: str, message: str, tmp_path: Path) -> None:
    path = samples(tmp_path, text)
    with pytest.raises(RecordingError, match=message) as caught:
        read(path)
    assert str(path) in str(caught.value)


def test_missing_and_unreadable_files(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="nowhere"):
        read(tmp_path / "nowhere_samples.parquet")
    binary = tmp_path / "binary_samples.csv"
    binary.write_bytes(HEADER.encode() + b"u,1,0,0,\xff\x00\n")
    with pytest.raises(RecordingError, match="binary_samples"):
        read(binary)


@pytest.fixture
def parquet(tmp_path: Path) -> Path:
    rng = np.random.default_rng(3)
    parts = [
        EventColumns.of(np.arange(50) / 100, rng.normal(size=50), rng.normal(size=50)) for _ in range(20)
    ]
    trials = [Trial(f"u{index % 3}", str(index), 1.0, 2.0, 3.0) for index in range(20)]
    return write(Recording.of("many", parts, trials), tmp_path / "many.parquet")[0]


def test_a_truncated_parquet_file_is_an_error(parquet: Path) -> None:
    whole = parquet.read_bytes()
    for keep in (4, 100, len(whole) // 2, len(whole) - 1):
        parquet.write_bytes(whole[:keep])
        with pytest.raises(RecordingError, match=r"many_samples\.parquet"):
            read(parquet)


def test_a_flipped_byte_in_a_parquet_page_is_noticed(parquet: Path) -> None:
    damaged = bytearray(parquet.read_bytes())
    damaged[len(damaged) // 3] ^= 0xFF
    parquet.write_bytes(bytes(damaged))
    with pytest.raises(RecordingError):
        read(parquet)


def test_parquet_without_a_user_names_the_row(tmp_path: Path) -> None:
    table = pa.table(
        {"user": ["u", None], "trial": [1, 1], "t_s": [0.0, 1.0], "x_px": [0, 1], "y_px": [0, 0]}
    )
    pq.write_table(table, tmp_path / "gap_samples.parquet")
    with pytest.raises(RecordingError, match=r"data row 1 \(counted from 0\) has no user"):
        read(tmp_path / "gap_samples.parquet")


@pytest.mark.parametrize(
    ("trials", "skip"),
    [
        (
            "user,trial,n_samples\nu,good,3\n",
            Skip("good", "2 samples, expected 3 as the trials file says", 0, "u"),
        ),
        (
            "user,trial,target_w\nu,good,-1\n",
            Skip("good", "target_w is -1.0, expected a finite number above 0", 0, "u"),
        ),
        ("user,trial,target_x\nu,good,far\n", Skip("good", "target_x is 'far', expected a number", 0, "u")),
        (
            "user,trial,clean\nu,good,maybe\n",
            Skip("good", "clean is 'maybe', expected true or false", 0, "u"),
        ),
        (
            "user,trial,block\nu,good,1\nu,good,2\n",
            Skip("good", "described twice, in rows 0 and 1 of set_trials.csv", 0, "u"),
        ),
    ],
)
def test_a_contradicting_trials_file_costs_the_trial(trials: str, skip: Skip, tmp_path: Path) -> None:
    samples(tmp_path, trials, "set_trials.csv")
    recording = read(samples(tmp_path, HEADER + GOOD))
    assert recording.skipped == (skip,)
    assert recording.trials == ()


def test_trials_on_one_side_only_are_reported(tmp_path: Path) -> None:
    samples(tmp_path, "user,trial,n_samples\nu,gone,5\n", "set_trials.csv")
    recording = read(samples(tmp_path, HEADER + GOOD))
    assert recording.skipped == (Skip("gone", "no samples", None, "u"),)
    assert recording.notes == ("trial good of u is not described in set_trials.csv",)
    assert [trial.trial for trial in recording.trials] == ["good"]


def test_a_trials_file_in_place_of_the_samples_is_named(tmp_path: Path) -> None:
    path = samples(tmp_path, "user,trial,n_samples\nu,1,3\n", "set_trials.csv")
    with pytest.raises(RecordingError, match="table of trials"):
        read(path)
    samples(tmp_path, HEADER + GOOD)
    samples(tmp_path, "dataset,user,trial\nother,u,good\n", "set_trials.csv")
    with pytest.raises(RecordingError, match="describes data set 'other', expected 'set'"):
        read(tmp_path / "set_samples.csv")
