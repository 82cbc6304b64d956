"""Folders of recordings, and conversion of any format to pointpred's own."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from pointpred.errors import RecordingError
from pointpred.recordings import convert, read, read_any

DATA = Path(__file__).parents[1] / "data" / "sources"


@pytest.fixture
def logs(tmp_path: Path) -> Path:
    for user in ("user1", "user2"):
        (tmp_path / "logs" / user).mkdir(parents=True)
        shutil.copy(DATA / "user7" / "session_2020_05_14_1min.csv", tmp_path / "logs" / user / "session_1")
    return tmp_path / "logs"


def test_sessions_of_a_folder_become_one_recording(logs: Path) -> None:
    (recording,) = read_any(logs)
    assert recording.name == "logs"
    assert [(trial.user, trial.trial) for trial in recording.trials] == [
        ("user1", "user1/session_1 0"),
        ("user1", "user1/session_1 1"),
        ("user2", "user2/session_1 0"),
        ("user2", "user2/session_1 1"),
    ]
    assert recording.offsets.tolist() == [0, 3, 6, 9, 12]
    assert recording.events.begin.nonzero()[0].tolist() == [0, 3, 6, 9]


def test_what_a_folder_cannot_give_is_reported(logs: Path) -> None:
    (logs / "LICENSE").write_text("words\n", encoding="utf-8")
    (logs / "cut_samples.parquet").write_bytes(b"PAR1 and nothing more")
    (logs / ".hidden").write_text("words\n", encoding="utf-8")
    (recording,) = read_any(logs)
    assert recording.notes == ("LICENSE fits no recording format",)
    assert [skip.trial for skip in recording.skipped] == ["cut_samples.parquet"]
    (logs / "empty").mkdir()
    with pytest.raises(RecordingError, match=r"no recording among 0 files$"):
        read_any(logs / "empty")


def test_reading_a_folder_tells_how_far_it_is(logs: Path) -> None:
    heard: list[tuple[str, int, int]] = []
    read_any(logs, progress=lambda *step: heard.append(step))
    files = sorted(file.relative_to(logs).as_posix() for file in logs.rglob("*") if file.is_file())
    assert heard == [(file, done, len(files)) for done, file in enumerate(files)]


def test_own_recordings_of_a_folder_stay_apart(tmp_path: Path) -> None:
    for name in ("one", "two"):
        for part in ("samples", "trials"):
            text = (DATA / f"pair_{part}.csv").read_text(encoding="utf-8").replace("pair", name)
            (tmp_path / f"{name}_{part}.csv").write_text(text, encoding="utf-8")
    assert [recording.name for recording in read_any(tmp_path)] == ["one", "two"]


@pytest.mark.parametrize("extension", ["parquet", "csv"])
@pytest.mark.parametrize(
    "name", ["gofitts.sd3", "psychopy.csv", "hid-recorder.txt", "user7/session_0000000001"]
)
def test_convert_keeps_what_was_read(name: str, extension: str, tmp_path: Path) -> None:
    (before,) = read_any(DATA / name)
    summary = convert(DATA / name, tmp_path / f"out.{extension}")
    after = read(summary.files[0])
    np.testing.assert_array_equal(after.events.table, before.events.table)
    assert repr(after.provenance) == repr(before.provenance)
    assert (after.skipped, after.notes) == (before.skipped, before.notes)
    assert (summary.trials, summary.users) == (len(before.trials), 1)
    assert sum(summary.skipped.values()) == len(before.skipped)


def test_convert_a_folder_of_several_recordings(logs: Path, tmp_path: Path) -> None:
    shutil.copy(DATA / "gofitts.sd3", logs / "fitts.sd3")
    summary = convert(logs, tmp_path / "all.csv")
    assert [Path(file).name for file in summary.files] == [
        "fitts_all_samples.csv",
        "fitts_all_trials.csv",
        "logs_all_samples.csv",
        "logs_all_trials.csv",
    ]


def test_recordings_of_one_name_do_not_overwrite_each_other(tmp_path: Path) -> None:
    for folder in ("a", "b"):
        (tmp_path / "in" / folder).mkdir(parents=True)
        shutil.copy(DATA / "pair_samples.csv", tmp_path / "in" / folder)
    summary = convert(tmp_path / "in", tmp_path / "out.csv")
    assert len(set(summary.files)) == 4
    assert [read(file).name for file in summary.files[::2]] == ["pair", "pair_2"]
