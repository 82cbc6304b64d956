"""What ``pointpred live`` says at the end of a session, and what is there then."""

from __future__ import annotations

from pathlib import Path

import pytest

from pointpred import build
from pointpred.devices.source import Report
from pointpred.live.run import LiveRun, OutputOptions
from pointpred.live.session import LiveSession
from tests.devices.live_fakes import FakeMouse


class LateMouse(FakeMouse):
    """Reports only once a session has begun: what came before, which is taken first, belongs to nothing."""

    def __init__(self, *reports: Report) -> None:
        super().__init__()
        self._late = list(reports)
        self._begun = False

    def take(self, timeout_s: float) -> list[Report]:
        if self._begun:  # however little time a session has, it looks once more before it ends
            self.put(self._late)
            self._late = []
        self._begun = True
        return super().take(timeout_s)


def followed(mouse: FakeMouse, file: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """The last line of a session that ends by itself."""
    session = LiveSession(mouse, None, build("hold"))
    LiveRun(session, OutputOptions("hold", record=file, seconds=0.2)).run()
    return capsys.readouterr().out.splitlines()[-1]


def test_a_recording_of_nothing_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "session.csv"
    assert followed(LateMouse(), file, capsys) == "recorded: nothing moved, nothing recorded"
    assert not file.exists()


def test_a_recording_of_what_could_not_be_read_does_not_say_that_nothing_moved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mouse = LateMouse()
    mouse.unreadable = 3
    assert followed(mouse, tmp_path / "session.csv", capsys) == "recorded: nothing recorded"


def test_a_recording_says_how_much_is_where(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "session.csv"
    told = followed(LateMouse(Report(1.0, 2, 0), Report(1.1, 3, 0)), file, capsys)
    assert told == f"recorded: 2 events in {file}"
    assert len(file.read_text().splitlines()[2:]) == 2
