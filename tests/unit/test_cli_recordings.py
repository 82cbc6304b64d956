"""``pointpred recordings``: lists what is there, deletes what was named and nothing else."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from pointpred import build, run
from pointpred.cli import recordings as module
from pointpred.datasets import sample
from pointpred.protocol.client_messages import Goal, Hello
from pointpred.recorder.writer import Recorder
from pointpred.records import EventColumns


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    """A folder with two sessions, of two trials and of none, and files of others."""
    folder = tmp_path / "kept"
    recorder = Recorder(folder)
    for name, trials in (("first", 2), ("second", 0)):
        session = recorder.open(name, Hello(1, "hold"))
        assert session is not None
        for index in range(max(1, trials)):
            events = sample().rows(index)
            if not trials:
                events = EventColumns(np.column_stack([events.table[:, :5], np.zeros(len(events))]))
            if trials:
                session.trial("start", Goal(1.0, 2.0, 3.0))
            session.events(events, run(build("hold"), events))
            session.trial("end")
        session.close()
    assert recorder.close()
    (folder / "diary.txt").write_text("mine", encoding="utf-8")
    (folder / "study_samples.csv").write_text("user,trial,t_s,x_px,y_px\n", encoding="utf-8")
    (folder / "20260102T030405Z-folder_samples.csv").mkdir()
    return folder


def names(kept: Path) -> list[str]:
    return sorted(
        {path.name.rpartition("_")[0] for path in kept.iterdir() if "Z-" in path.name and path.is_file()}
    )


def test_list_says_what_is_there(command, kept: Path) -> None:
    left = command("recordings", "list", "--folder", kept)
    assert left.code == 0
    rows = [line.split() for line in left.out.splitlines()]
    sizes = [len(sample().rows(0)) + len(sample().rows(1)), len(sample().rows(0))]
    assert [row[0] for row in rows[1:]] == names(kept)
    assert [row[3:6] for row in rows[1:]] == [[str(sizes[0]), "2", "0"], [str(sizes[1]), "0", "1"]]


def test_list_as_json(command, kept: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POINTPRED_RECORD", str(kept))
    document = json.loads(command("recordings", "list", "--json").out)
    first, second = document["recordings"]
    assert (first["trials"], second["trials"]) == (2, 0)
    assert len(first["files"]) == 3
    assert len(second["files"]) == 2
    assert first["bytes"] == sum(Path(path).stat().st_size for path in first["files"])


def test_a_recording_that_cannot_be_read_is_listed_and_can_be_deleted(command, kept: Path) -> None:
    name = names(kept)[0]
    (kept / f"{name}_samples.csv").write_bytes(b"\xff\x00")
    left = command("recordings", "list", "--folder", kept)
    assert left.code == 0
    assert "so this is no text" in " ".join(left.out.split())
    assert command("recordings", "delete", name, "--force", "--folder", kept).code == 0
    assert len(names(kept)) == 1


def test_one_command_deletes_everything_of_the_recorder_and_nothing_else(command, kept: Path) -> None:
    left = command("recordings", "delete", "--all", "--force", "--folder", kept)
    assert left.code == 0
    assert "deleted 2 recordings" in left.err
    assert sorted(path.name for path in kept.iterdir()) == [
        "20260102T030405Z-folder_samples.csv",
        "diary.txt",
        "study_samples.csv",
    ]
    again = command("recordings", "delete", "--all", "--folder", kept)
    assert (again.code, "nothing is recorded" in again.err) == (0, True)


@pytest.mark.parametrize(("answer", "left_over"), [("y\n", 1), ("n\n", 2), ("", 2)])
def test_it_asks_before_it_deletes(
    command, kept: Path, monkeypatch: pytest.MonkeyPatch, answer: str, left_over: int
) -> None:
    import io

    monkeypatch.setattr("sys.stdin", io.StringIO(answer))
    left = command("recordings", "delete", names(kept)[0], "--folder", kept)
    assert "Delete 1 recording (" in left.err
    assert ("deleted 1 recording, " in left.err) == (left_over == 1)
    assert len(names(kept)) == left_over
    assert (left.code == 0) == (left_over == 1)


@pytest.mark.parametrize("name", ["nobody", "../kept/diary.txt", "diary.txt", "20260102T030405Z-folder", "*"])
def test_an_unknown_name_deletes_nothing(command, kept: Path, name: str) -> None:
    before = sorted(kept.iterdir())
    left = command("recordings", "delete", names(kept)[0], name, "--force", "--folder", kept)
    assert left.code == 2
    assert f"no recording {name!r}" in left.err
    assert sorted(kept.iterdir()) == before


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["list"], "--folder"),
        (["delete", "--force", "--folder", "."], "--all"),
        (["delete", "a", "--all", "--force", "--folder", "."], "not both"),
    ],
)
def test_wrong_use(command, monkeypatch: pytest.MonkeyPatch, arguments: list[str], said: str) -> None:
    monkeypatch.delenv("POINTPRED_RECORD", raising=False)
    left = command("recordings", *arguments)
    assert left.code == 2
    assert said in left.err


def test_a_folder_that_is_not_there_is_one_line_and_1(command, tmp_path: Path) -> None:
    left = command("recordings", "list", "--folder", tmp_path / "none")
    assert left.code == 1
    assert len(left.err.splitlines()) == 1


@pytest.mark.parametrize(("size", "said"), [(0, "0 B"), (999, "999 B"), (1000, "1.0 kB"), (2.5e9, "2.5 GB")])
def test_sizes_read_well(size: float, said: str) -> None:
    assert module._size(size) == said
