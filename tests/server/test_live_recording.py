"""A device's session in one file: where it lies, what is in it, and what happens when writing fails."""

from __future__ import annotations

import csv
import stat
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from pointpred import build
from pointpred.devices.cursor_paths import MotorPath, SurfacePath
from pointpred.live.outputs import LiveRecording
from pointpred.live.session import LiveSession
from pointpred.protocol.client_messages import Device, Hello, Screen
from pointpred.recordings import Reading, read
from tests.devices.live_fakes import FakeMouse, reach, touches
from tests.server.listener import soon

HELLO = Hello(1, "kinematic", device=Device(cpi=800.0), screen=Screen(dpi=110.0))
WHERE = "prediction in motor space"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    tmp_path.chmod(0o700)
    return tmp_path / "session.csv"


@pytest.fixture
def recording(file: Path) -> Iterator[LiveRecording]:
    made = LiveRecording(file, HELLO, lambda: WHERE, lambda: "a test's clock")
    yield made
    made.close()


def follow(recording: LiveRecording, *begins: float) -> LiveSession:
    session = LiveSession(FakeMouse(), MotorPath(800.0, 110.0), build("kinematic", cpi=800.0, dpi=110.0))
    session.watchers.append(recording.take)
    for begin in begins:
        session.source.put(reach(begin, (900.0, -300.0)))  # type: ignore[attr-defined]
        session.advance(0.0)
    return session


def test_the_file_is_the_one_that_was_named_and_its_owners_only(file: Path, recording: LiveRecording) -> None:
    follow(recording, 1.0, 3.0)
    assert recording.close()
    assert {path.name for path in file.parent.iterdir()} == {"session.csv", "session_predictions.csv"}
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    held = read(file)
    assert (len(held.trials), held.provenance.cpi, held.provenance.dpi) == (2, 800.0, 110.0)
    assert (held.provenance.origin, held.provenance.clock) == (WHERE, "a test's clock")
    assert (recording.events, recording.lost) == (1004, 0)


def test_the_contacts_of_a_touch_screen_are_movements_of_their_own(file: Path) -> None:
    session = LiveSession(FakeMouse(touches((0.1, 0.2), (0.7, 0.9))), SurfacePath(), build("kinematic"))
    recording = LiveRecording(file, HELLO, lambda: session.words, lambda: "a test's clock")
    session.watchers.append(recording.take)
    session.advance(0.0)
    assert recording.close()
    held = read(file)  # the second begins 50 ms after the first ended: no pause is between them
    assert [len(held.rows(at)) for at in range(2)] == [41, 41]
    assert "cut at pauses, and where a pen or finger was lifted: contacts 2" in held.notes
    assert held.provenance.origin.startswith("the device's own, px of the surface")
    assert np.isnan(held.events.dx).all()
    assert len(read(file, reading=Reading(cut="clicks")).trials) == 0


def test_every_field_of_a_prediction_is_kept(file: Path, recording: LiveRecording) -> None:
    session = LiveSession(
        FakeMouse(reach(1.0, (2000.0, 300.0))),
        MotorPath(800.0, 110.0),
        build("kinematic", cpi=800.0, dpi=110.0),
    )
    pairs = session.advance(0.0)
    recording.take(pairs)
    recording.close()
    with (file.parent / "session_predictions.csv").open() as opened:
        rows = list(csv.DictReader(opened))
    assert len(rows) == len(pairs)
    told = 0
    for row, (event, one) in zip(rows, pairs, strict=True):
        assert float(row["t_s"]) == event.t
        assert row["predictor"] == "kinematic"
        if one is None:
            assert {row["x_px"], row["phase"], row["remaining_s"]} == {""}
            continue
        told += one.scale is not None and one.remaining_s is not None
        assert (float(row["x_px"]), float(row["y_px"]), row["phase"]) == (one.x, one.y, one.phase)
        spread = [row[name] for name in ("sxx_px2", "sxy_px2", "syy_px2")]
        assert [float(value) for value in spread if value] == list(one.scale or ())
        assert row["tail"] == ("" if one.tail is None else repr(one.tail))
        assert (
            row["remaining_s"] == ""
            if one.remaining_s is None
            else float(row["remaining_s"]) == one.remaining_s
        )
    assert told > 100


def test_what_rests_is_not_held_back(file: Path, recording: LiveRecording) -> None:
    session = LiveSession(FakeMouse(reach(1.0, (90.0, 3.0), 0.02)[:20]), None, build("hold"))
    recording.take(session.advance(0.0))
    assert recording.events == 0  # so few wait for more
    recording.take([])
    assert recording.events == session.reports
    soon(lambda: file.exists() and len(file.read_text().splitlines()) == 2 + session.reports, "written")


def test_a_deleted_file_ends_the_recording_only(
    file: Path, recording: LiveRecording, caplog: pytest.LogCaptureFixture
) -> None:
    session = follow(recording, 1.0)
    soon(file.exists, "it is begun")
    file.unlink()

    def noticed() -> bool:
        session.source.put(reach(2.0 + session.reports, (90.0, 3.0)))  # type: ignore[attr-defined]
        session.advance(0.0)
        return recording.failed

    soon(noticed, "it is gone")
    lost = recording.lost
    session.source.put(reach(1e6, (90.0, 3.0)))  # type: ignore[attr-defined]
    assert len(session.advance(0.0)) == 502
    assert recording.lost > lost
    assert not recording.close()
    assert "were deleted" in caplog.text


def test_samples_that_are_named_so_keep_the_name(tmp_path: Path) -> None:
    tmp_path.chmod(0o700)
    recording = LiveRecording(tmp_path / "desk_samples.csv", HELLO, lambda: WHERE, lambda: "a test's clock")
    follow(recording, 1.0)
    assert recording.close()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["desk_predictions.csv", "desk_samples.csv"]
    assert np.ptp(read(tmp_path / "desk_samples.csv").events.t) > 0.4
