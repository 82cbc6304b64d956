"""Pointpred's own recordings: hand-written files, what pandas sees in what we write, the same bytes twice."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings import read, write
from pointpred.records import EventColumns

DATA = Path(__file__).parents[1] / "data" / "sources"
NONE = float("nan")


@pytest.fixture
def small() -> Recording:
    parts = [
        EventColumns.of([0.0, 0.1], [1.0, 2.0], [3.0, -0.1], [1, 2], [0, 0], [0, 1]),
        EventColumns.of([5.0, 5.0, 5.5], [0.1 + 0.2, 1e-300, 3.0], [0.0, -0.0, 123456789.1]),
    ]
    trials = [
        Trial("ann", "a,b", 1.0, 2.0, 3.0, clean=True, condition={"device": 'a "mouse"\n', "block": 1.0}),
        Trial("bob", "", condition={"device": "1"}),
    ]
    provenance = Provenance("hand", "counts", "centre", "up", "ms", 110.0, 800.0, simulated=True)
    return Recording.of("tiny", parts, trials, [Skip("9", "broken", 4)], provenance, ["seen"])


def test_a_hand_written_pair_is_read() -> None:
    recording = read(DATA / "pair_samples.csv")
    assert recording.name == "pair"
    assert recording.offsets.tolist() == [0, 2, 5]
    assert [(trial.user, trial.trial) for trial in recording.trials] == [("ann", "1"), ("bob", "1")]
    ann, bob = recording.trials
    assert (ann.target_x, ann.target_y, ann.target_w, ann.clean) == (13.0, 24.0, 8.0, True)
    assert ann.condition == {"block": 1.0, "device": "mouse"}
    assert bob.clean is None
    assert np.isnan([bob.target_x, bob.target_y, bob.target_w]).all()
    expected = [
        [0, 10, 20, NONE, NONE, 0],
        [0.5, 13, 24, 6, 8, 1],
        [0, 0.1, -5, NONE, NONE, 0],
        [0, 0.2, -5, 1, 0, 0],
        [0.25, 0.1 + 0.2, -4.5, 1, 2, 3],
    ]
    np.testing.assert_array_equal(recording.events.table, expected)
    assert recording.events.begin.tolist() == [True, False, True, False, False]
    assert recording.provenance == Provenance("csv")
    assert recording.skipped == recording.notes == ()


def test_without_a_trials_file_targets_are_unknown(tmp_path: Path) -> None:
    alone = tmp_path / "walk.csv"
    alone.write_bytes((DATA / "pair_samples.csv").read_bytes())
    recording = read(alone)
    assert len(recording.trials) == 2
    assert all(np.isnan(trial.target_x) for trial in recording.trials)
    given = read(alone, trials=DATA / "pair_trials.csv")
    assert given.trials[0].target_w == 8.0


@pytest.mark.parametrize("extension", [".parquet", ".csv"])
def test_everything_a_recording_knows_survives(small: Recording, tmp_path: Path, extension: str) -> None:
    samples, trials = write(small, tmp_path / f"tiny{extension}")
    assert (samples.name, trials.name) == (f"tiny_samples{extension}", f"tiny_trials{extension}")
    back = read(samples)
    assert back.events.table.tobytes() == small.events.table.tobytes()
    assert back.offsets.tolist() == small.offsets.tolist()
    assert back.events.begin.tolist() == small.events.begin.tolist()
    assert repr(back.trials) == repr(
        (
            Trial("ann", "a,b", 1.0, 2.0, 3.0, clean=True, condition={"block": 1.0, "device": 'a "mouse"\n'}),
            small.trials[1],
        )
    )
    assert (back.name, back.provenance) == (small.name, small.provenance)
    assert (back.skipped, back.notes) == (small.skipped, small.notes)


@pytest.mark.parametrize("extension", [".parquet", ".csv"])
def test_the_same_recording_gives_the_same_bytes(small: Recording, tmp_path: Path, extension: str) -> None:
    first = [file.read_bytes() for file in write(small, tmp_path / f"one{extension}")]
    second = [file.read_bytes() for file in write(small, tmp_path / f"two{extension}")]
    assert first == second
    assert not list(tmp_path.glob("*.part"))


def test_pandas_reads_what_we_write(small: Recording, tmp_path: Path) -> None:
    samples, trials = write(small, tmp_path / "tiny.csv")
    table = pd.read_csv(samples, skiprows=1, keep_default_na=False, na_values={"dx_counts": [""]})
    assert table["x_px"].tolist() == small.events.x.tolist()
    assert table["buttons"].tolist() == [0, 1, 0, 0, 0]
    assert table["user"].tolist() == ["ann", "ann", "bob", "bob", "bob"]
    assert pd.read_csv(trials, skiprows=1)["n_samples"].tolist() == [2, 3]
    parquet, _ = write(small, tmp_path / "tiny.parquet")
    frame = pd.read_parquet(parquet)
    np.testing.assert_array_equal(frame["dx_counts"], small.events.dx)
    assert frame["trial"].tolist() == ["a,b", "a,b", "", "", ""]


def test_rows_of_trials_may_interleave(tmp_path: Path) -> None:
    mixed = tmp_path / "mixed_samples.csv"
    mixed.write_text(
        "user,trial,t_s,x_px,y_px\nu,1,0,0,0\nu,2,7,5,5\nu,1,1,1,0\nu,2,8,6,5\nu,1,2,2,0\n", encoding="utf-8"
    )
    recording = read(mixed)
    assert recording.notes == ("row 2: the rows of trials interleave; put together by trial",)
    assert [trial.trial for trial in recording.trials] == ["1", "2"]
    assert recording.rows(0).t.tolist() == [0, 1, 2]
    assert recording.rows(1).x.tolist() == [5, 6]


def test_user_and_trial_together_are_the_key(tmp_path: Path) -> None:
    keys = [("a", "1"), ("a", "2"), ("b", "1"), ("b", "2"), ("1", "a")]
    lines = [f"{user},{trial},{t},{t},0" for user, trial in keys for t in (0, 1)]
    path = tmp_path / "keys.csv"
    path.write_text("user,trial,t_s,x_px,y_px\n" + "\n".join(lines) + "\n", encoding="utf-8")
    recording = read(path)
    assert [(trial.user, trial.trial) for trial in recording.trials] == keys
    assert recording.offsets.tolist() == [0, 2, 4, 6, 8, 10]


def test_a_recording_without_trials_survives(tmp_path: Path) -> None:
    for extension in (".parquet", ".csv"):
        samples, _ = write(Recording.of("none", [], []), tmp_path / f"none{extension}")
        back = read(samples)
        assert (back.name, back.trials, len(back.events)) == ("none", (), 0)


@pytest.mark.parametrize(
    ("trials", "message"),
    [
        ([Trial("u", "1"), Trial("u", "1")], "occurs twice"),
        ([Trial("u", "1", condition={"a": 1.0}), Trial("u", "2", condition={"a": "b"})], "either words or"),
        ([Trial("u", "1", condition={"clean": 1.0}), Trial("u", "2")], "name of its own"),
    ],
)
def test_what_cannot_be_written_is_refused(trials: list[Trial], message: str, tmp_path: Path) -> None:
    part = EventColumns.of([0.0, 1.0], [0.0, 1.0], [0.0, 0.0])
    with pytest.raises(RecordingError, match=message):
        write(Recording.of("bad", [part, part], trials), tmp_path / "bad.csv")
    assert list(tmp_path.iterdir()) == []


def test_an_unknown_extension_is_refused(small: Recording, tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r"expected \.parquet or \.csv"):
        write(small, tmp_path / "tiny.xlsx")
