"""Recordings that were appended to: a hand-written one, and one cut at every byte."""

from pathlib import Path

import numpy as np
import pytest

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Skip, Trial
from pointpred.recordings import Reading, read, read_any

DATA = Path(__file__).parents[1] / "data" / "sources"
NONE = float("nan")
SAMPLES = (DATA / "recorded_samples.csv").read_bytes()
COMPLETE = SAMPLES[: SAMPLES.rindex(b"\n") + 1]


def test_marked_trials_of_a_hand_written_recording() -> None:
    recording = read(DATA / "recorded_samples.csv")
    assert recording.name == "recorded"
    assert recording.trials == (Trial("s", "1", 15.0, 23.0, 8.0),)
    expected = [[7.5, 10, 20, NONE, NONE, 0], [7.625, 12.5, 21, 5, 2, 0], [7.75, 14, 22, 3, 2, 1]]
    np.testing.assert_array_equal(recording.events.table, expected)
    assert recording.skipped == (
        Skip("rows 0 to 0", "outside the marked trials", 0),
        Skip("rows 4 to 5", "outside the marked trials", 4),
        Skip("2", "2 samples, expected 5 as the trials file says", 6, "s"),
        Skip("3", "the trial never ended", 8, "s"),
    )
    assert recording.notes == (
        "recorded_samples.csv: the last line is cut after 14 bytes and left aside",
        "recorded_trials.csv: the last line is cut after 3 bytes and left aside",
    )
    assert recording.provenance == Provenance(
        "pointpred recorder", "px", "as the client says", "down", "the client's clock, s", 110.0, 800.0
    )


def test_without_its_trials_file_every_target_is_unknown(tmp_path: Path) -> None:
    path = tmp_path / "alone_samples.csv"
    path.write_bytes(SAMPLES)
    recording = read(path)
    assert [trial.trial for trial in recording.trials] == ["1", "2", "3"]
    assert all(np.isnan(trial.target_x) for trial in recording.trials)
    assert "no trials file: every target is unknown" in recording.notes


def test_without_marks_the_stream_is_cut_at_clicks_or_as_asked(tmp_path: Path) -> None:
    path = tmp_path / "stream.csv"
    path.write_bytes(COMPLETE.replace(b'"1"', b"").replace(b'"2"', b"").replace(b'"3"', b""))
    (clicks,) = read_any(path)
    assert [(trial.user, trial.trial, trial.condition) for trial in clicks.trials] == [
        ("s", "0", {"begins_s": 7.25})
    ]
    assert clicks.events.t.tolist() == [0.0, 0.25, 0.375, 0.5]
    assert [(skip.trial, skip.reason) for skip in clicks.skipped] == [
        ("rows 4 to 4", "a button is held"),
        ("rows 5 to 9", "no click ends it"),
    ]
    (whole,) = read_any(path, Reading(cut="whole"))
    assert len(whole.events) == 10
    assert not [note for note in whole.notes if "no effect" in note]


def test_a_file_cut_at_any_byte_keeps_every_complete_row(tmp_path: Path) -> None:
    path = tmp_path / "cut_samples.csv"
    header = COMPLETE.index(b"user,trial") + len("user,trial,t_s,x_px,y_px,dx_counts,dy_counts,buttons\n")
    for length in range(header, len(COMPLETE) + 1):
        path.write_bytes(COMPLETE[:length])
        recording = read(path)
        rows = COMPLETE[header:length].count(b"\n")
        outside = sum(
            int(skip.trial.split()[3]) - int(skip.trial.split()[1]) + 1
            for skip in recording.skipped
            if skip.trial.startswith("rows")
        )
        short = sum(skip.reason.startswith("one sample") for skip in recording.skipped)
        assert len(recording.events) + outside + short == rows
        cut = length - COMPLETE.rindex(b"\n", 0, length) - 1
        said = [note for note in recording.notes if "last line" in note]
        left = f"cut_samples.csv: the last line is cut after {cut} bytes and left aside"
        assert said == ([left] if cut else [])


@pytest.mark.parametrize("length", [0, 5, 20, SAMPLES.index(b"\n") - 1])
def test_a_file_without_its_first_line_is_an_error(length: int, tmp_path: Path) -> None:
    path = tmp_path / "short_samples.csv"
    path.write_bytes(SAMPLES[:length])
    with pytest.raises(RecordingError):
        read(path)


def test_zeros_after_a_loss_of_power_count_as_the_cut_line(tmp_path: Path) -> None:
    path = tmp_path / "zeros_samples.csv"
    path.write_bytes(COMPLETE + b"\0" * 100)
    recording = read(path)
    assert len(recording.trials) == 3
    assert recording.notes[0] == "zeros_samples.csv: the last line is cut after 100 bytes and left aside"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b"8.25", b"later"),
        (b"20,30", b"20"),
        (b"buttons", b"knobs"),
        (b"buttons\n", b'"buttons\n\xde"\n'),
        (b'"append":true', b'"append":false'),
    ],
)
def test_damage_elsewhere_is_an_error(old: bytes, new: bytes, tmp_path: Path) -> None:
    path = tmp_path / "bad_samples.csv"
    path.write_bytes(SAMPLES.replace(old, new, 1))
    with pytest.raises(RecordingError, match="bad_samples"):
        read(path)
