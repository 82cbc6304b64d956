"""Many files as one recording: who is a person, what the trials are called, what is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pointpred.errors import ParameterError, RecordingError
from pointpred.recordings import read, read_any, write
from pointpred.recordings.reading import People, Reading


def table(path: Path, users: str = "", trials: int = 2, condition: str = "slow") -> Path:
    """A file of two trials a user, with a condition."""
    path.parent.mkdir(exist_ok=True)
    rows = [
        f"{user},{trial},{condition},{10 * i},{5 * i},{i}"
        for user in users or "-"
        for trial in range(trials)
        for i in range(20)
    ]
    head = "user,trial,pace,t_ms,x,y"
    if not users:
        head, rows = head.removeprefix("user,"), [row.removeprefix("-,") for row in rows]
    path.write_text("\n".join([head, *rows, ""]))
    return path


def people(files: list[Path], by: People | None = None) -> list[tuple[str, str]]:
    [recording] = read_any(files, people=by)
    return [(one.user, one.trial) for one in recording.trials]


def test_each_file_is_a_person(tmp_path: Path) -> None:
    files = [table(tmp_path / "anna.csv", condition="slow"), table(tmp_path / "ben.csv", condition="fast")]
    [recording] = read_any(files)
    assert people(files) == [("anna", "0"), ("anna", "1"), ("ben", "0"), ("ben", "1")]
    assert [one.condition["pace"] for one in recording.trials] == ["slow", "slow", "fast", "fast"]
    assert recording.name == tmp_path.name
    assert len(recording.events) == 80
    assert any(note.startswith("ben.csv: ") for note in recording.notes)


def test_each_folder_is_a_person_whose_files_keep_their_trials_apart(tmp_path: Path) -> None:
    files = [
        table(tmp_path / "p1" / "a.csv"),
        table(tmp_path / "p1" / "b.csv"),
        table(tmp_path / "p2" / "a.csv"),
    ]
    assert people(files, "folder") == [
        *(("p1", name) for name in ("p1/a.csv 0", "p1/a.csv 1", "b 0", "b 1")),
        *(("p2", name) for name in ("0", "1")),
    ]


def test_the_column_of_users_says_who_is_the_same_person(tmp_path: Path) -> None:
    files = [table(tmp_path / "monday.csv", "ab"), table(tmp_path / "tuesday.csv", "bc")]
    assert people(files, "column") == [
        *(("a", "0"), ("a", "1"), ("b", "monday 0"), ("b", "monday 1")),
        *(("b", "tuesday 0"), ("b", "tuesday 1"), ("c", "0"), ("c", "1")),
    ]


def test_users_of_one_person_are_told_apart_and_noted(tmp_path: Path) -> None:
    [recording] = read_any([table(tmp_path / "anna.csv", "xy")])
    assert [(one.user, one.trial) for one in recording.trials] == [
        ("anna", f"anna {user} {trial}") for user in "xy" for trial in range(2)
    ]
    assert "anna.csv: its 2 users count as one person, anna" in recording.notes


def test_own_recordings_are_joined_and_their_trials_files_are_not_read_as_files(tmp_path: Path) -> None:
    (tmp_path / "own").mkdir()
    for name in ("anna", "ben"):
        [one] = read_any(table(tmp_path / "raw" / f"{name}.csv"))
        write(one, tmp_path / "own" / f"{name}.csv")
    [recording] = read_any(tmp_path / "own", people="file")
    assert {one.user for one in recording.trials} == {"anna", "ben"}


def test_a_file_that_cannot_be_read_is_a_skip_and_another_kind_of_file_a_note(tmp_path: Path) -> None:
    table(tmp_path / "anna.csv")
    (tmp_path / "torn.parquet").write_bytes(b"PAR1" + bytes(40))
    (tmp_path / "README").write_text("what this is\n")
    [recording] = read_any(tmp_path, people="file")
    assert [skip.trial for skip in recording.skipped] == ["torn.parquet"]
    assert any("README" in note for note in recording.notes)
    with pytest.raises(RecordingError) as refused:
        read_any([tmp_path / "torn.parquet", tmp_path / "README"])
    assert refused.value.code == "no_recording"


def test_devices_of_other_resolution_are_not_joined(tmp_path: Path) -> None:
    (tmp_path / "own").mkdir()
    for name, cpi in (("anna", 800.0), ("ben", 1600.0)):
        [one] = read_any(table(tmp_path / f"{name}.csv"), Reading(cpi=cpi))
        write(one, tmp_path / "own" / f"{name}.csv")
    with pytest.raises(RecordingError, match="cpi is 1600"):
        read_any(tmp_path / "own", people="file")


def test_convert_joins_what_a_pattern_finds(command: Callable[..., Any], tmp_path: Path) -> None:
    for name in ("p1", "p2", "p3"):
        table(tmp_path / f"{name}.csv")
    out = tmp_path / "study" / "all.parquet"
    out.parent.mkdir()
    done = command("convert", str(tmp_path / "p*.csv"), "--join", "file", "--out", str(out))
    assert done.code == 0
    back = read(out.with_name("all_samples.parquet"))
    assert sorted({one.user for one in back.trials}) == ["p1", "p2", "p3"]
    assert command("convert", str(tmp_path / "p*.csv"), "--join", "people", "--out", str(out)).code == 2


def test_several_files_without_join_stay_recordings_of_their_own(
    command: Callable[..., Any], tmp_path: Path
) -> None:
    files = [str(table(tmp_path / f"{name}.csv")) for name in ("p1", "p2")]
    done = command("convert", *files, "--out", str(tmp_path / "all.csv"))
    assert done.code == 0
    assert (tmp_path / "p1_all_samples.csv").exists()
    assert (tmp_path / "p2_all_samples.csv").exists()


def test_an_unknown_way_to_tell_people_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match="people must be file, folder or column, received 'user'"):
        read_any([table(tmp_path / "anna.csv")], people="user")  # type: ignore[arg-type]
