"""``pointpred live --person FILE``: read at the start and saved in the end, only where it was asked for."""

from __future__ import annotations

import stat
from pathlib import Path
from typing import Any

import pytest

from pointpred import Pipeline, build
from pointpred.devices.cursor_paths import MotorPath
from pointpred.devices.source import Report
from pointpred.errors import ParameterError
from pointpred.live import follow
from pointpred.live.follow import read_person, save_person
from tests.devices.live_fakes import reach
from tests.devices.test_live_outlets import LateMouse

NAME = "kinematic-adaptive"
REPORTS = [[*reach(1.0, (400.0, 90.0)), *reach(4.0, (-600.0, 40.0))], [*reach(9.0, (500.0, -90.0))]]


def live(command: Any, monkeypatch: pytest.MonkeyPatch, reports: list[Report], *options: str | Path) -> Any:
    monkeypatch.setattr(follow, "choose", lambda *asked: LateMouse(*reports))
    return command("live", "--cursor", "motor", "--cpi", "800", "--seconds", "0.3", *options)


def wanted(*sessions: list[Report]) -> Pipeline:
    """A pipeline that was given the same, each session finished."""
    pipeline = build(NAME, cpi=800.0)
    for reports in sessions:
        for event in MotorPath(800.0).events(reports):
            pipeline.update(event)
        pipeline.reset()
    return pipeline


def test_the_next_session_goes_on_with_the_person(
    command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file = tmp_path / "me.txt"
    left = live(command, monkeypatch, REPORTS[0], "--person", file)
    assert left.code == 0, left.err
    assert str(file) in left.out
    assert file.read_text() == wanted(REPORTS[0]).person + "\n"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert live(command, monkeypatch, REPORTS[1], "--person", file).code == 0
    assert file.read_text() == wanted(*REPORTS).person + "\n"
    assert [one.name for one in tmp_path.iterdir()] == ["me.txt"]


def test_nothing_is_saved_unless_asked_or_where_nothing_was_learned(
    command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    assert live(command, monkeypatch, REPORTS[0]).code == 0
    left = live(command, monkeypatch, [], "--person", tmp_path / "me.txt")
    assert left.code == 0
    assert "nothing" in left.out
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("content", ["", "1.nobody", "\xff" * 9000])
def test_a_file_that_holds_no_person_is_refused_and_stays(
    command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, content: str
) -> None:
    file = tmp_path / "me.txt"
    file.write_text(content, encoding="latin-1")
    if content == "":
        assert read_person(file, NAME) == ""  # an empty file knows nobody
        return
    left = live(command, monkeypatch, REPORTS[0], "--person", file)
    assert (left.code, left.out) == (2, "")
    assert str(file) in left.err
    assert file.read_text(encoding="latin-1") == content


def test_others_and_replays_have_no_person(command: Any, tmp_path: Path) -> None:
    file = tmp_path / "me.txt"
    for arguments in (["--predictor", "hold"], ["--predictor", "ktm"], ["--replay", "sample"]):
        left = command("live", "--person", file, *arguments)
        assert left.code == 2
        assert "--person" in left.err
    with pytest.raises(ParameterError, match="--person"):
        read_person(Path("-"), NAME)
    left = command("live", "--person", tmp_path / "no" / "me.txt", "--predictor", NAME)
    assert (left.code, left.out) == (2, "")
    assert "folder" in left.err


def test_a_write_that_fails_leaves_the_old_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "me.txt"
    file.write_text("before")

    def fail(self: Path, target: Path) -> None:
        raise OSError("the disk is full")

    monkeypatch.setattr(Path, "replace", fail)
    with pytest.raises(OSError, match="full"):
        save_person(file, wanted(REPORTS[0]))
    assert file.read_text() == "before"
    assert [one.name for one in tmp_path.iterdir()] == ["me.txt"]
