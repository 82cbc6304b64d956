"""``pointpred live`` reads an emulated mouse: what it records is scored, what it measures is right."""

from __future__ import annotations

import json
import os
import pty
import signal
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pointpred import EventColumns, build, run
from pointpred.devices.hidraw import HidSource
from pointpred.devices.source import Report
from pointpred.recordings import read
from tests.devices.live_fakes import reach
from tests.devices.live_process import PATIENCE_S, READING, send, started, until_recorded, until_said
from tests.devices.mice import BUTTONS, TWO_WHEELS, Plugged, plug
from tests.devices.umockdev import Testbed

REACHES = ((900.0, -400.0), (-700.0, 500.0), (400.0, 800.0))


@pytest.fixture
def mouse(testbed: Testbed) -> Plugged:
    return plug(testbed, TWO_WHEELS)


def test_a_recorded_session_is_scored_as_it_is(testbed: Testbed, tmp_path: Path, command: Any) -> None:
    """Two are there: the first is a touchpad's mouse, which never moves."""
    plug(testbed, BUTTONS, 0)
    mouse = plug(testbed, TWO_WHEELS, 1)
    file, errors = tmp_path / "session.csv", tmp_path / "errors"
    arguments = ("--cpi", "800", "--predictor", "switched", "--record", str(file))
    with started(testbed, errors, *arguments) as process:
        until_said(errors, READING, process)
        reaches = [reach(0.0, way, rate_hz=500.0) for way in REACHES]
        still = next(i for i, report in enumerate(reaches[0]) if report.dx or report.dy)
        sent = sum(send(mouse, reports) for reports in reaches) - still
        until_recorded(file, sent, process)
        process.send_signal(signal.SIGTERM)
        out, _ = process.communicate(timeout=PATIENCE_S)
        assert process.returncode == 0, errors.read_text()
    assert f"{sent} reports; 0 lost, 0 unreadable, 0 refused" in out
    assert "motor space" in errors.read_text()
    assert "note: following /dev/hidraw1 (two wheels)" in errors.read_text()
    recording = read(file)
    assert recording.provenance.clock == HidSource.clock
    assert len(recording.trials) == len(REACHES)
    ends = [recording.rows(i).table[-1, 1:3] for i in range(len(REACHES))]
    scale = 96.0 / 800.0
    np.testing.assert_allclose(ends, scale * np.cumsum(REACHES, axis=0), atol=1e-6)
    left = command("score", file, "--predictors", "switched,kep-quadratic,kep-quartic", "--json", "-")
    assert left.code == 0, left.err
    (told,) = json.loads(left.out)["sets"]
    assert told["trials"] == len(REACHES)
    names = [one["name"] for one in told["predictors"]]
    assert names == ["hold", "switched", "kep-quadratic", "kep-quartic"]
    assert all(one["time_averaged"]["px"] > 0.0 for one in told["predictors"])


def test_recorded_predictions_are_those_of_a_batch(testbed: Testbed, mouse: Plugged, tmp_path: Path) -> None:
    file, errors = tmp_path / "session_samples.csv", tmp_path / "errors"
    arguments = ("--cpi", "800", "--predictor", "switched", "--record", str(file))
    with started(testbed, errors, *arguments) as process:
        until_said(errors, READING, process)
        until_recorded(file, send(mouse, reach(0.0, REACHES[0], rate_hz=500.0)), process)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=PATIENCE_S)
        assert process.returncode == 0, errors.read_text()
    events = np.genfromtxt(file, delimiter=",", skip_header=2, usecols=range(2, 8))
    told = np.genfromtxt(tmp_path / "session_predictions.csv", delimiter=",", skip_header=1, usecols=range(3))
    batch = run(build("switched", cpi=800.0, dpi=96.0), EventColumns(events)).table[:, :3]
    np.testing.assert_array_equal(told, batch)


def test_a_killed_process_loses_little(testbed: Testbed, mouse: Plugged, tmp_path: Path) -> None:
    file, errors = tmp_path / "session.csv", tmp_path / "errors"
    with started(testbed, errors, "--cpi", "800", "--record", str(file)) as process:
        until_said(errors, READING, process)
        sent = send(mouse, reach(0.0, REACHES[0], rate_hz=500.0))
        until_recorded(file, sent, process)  # nothing more comes: what is held back is written all the same
        process.kill()
    assert len(file.read_text().splitlines()[2:]) == sent


def test_the_resolution_is_measured_from_one_move(testbed: Testbed, mouse: Plugged, tmp_path: Path) -> None:
    """Asked for in a terminal, where m is the answer that measures."""
    errors = tmp_path / "errors"
    ours, theirs = pty.openpty()
    os.write(ours, b"m\n")
    with started(testbed, errors, "--seconds", "0.5", out=theirs, stdin=theirs) as process:
        until_said(errors, "Put the mouse against a ruler", process)
        send(mouse, [Report(0.0, 15.0, 0.0)] * 420)  # at once: a hand held up for a second has ended its move
        process.wait(timeout=PATIENCE_S)
    os.close(theirs)
    shown = os.read(ours, 1 << 16).decode()
    os.close(ours)
    assert process.returncode == 0
    assert "6300 counts over 10 cm: 1600 CPI" in errors.read_text()
    assert "1600 counts per inch" in shown


def test_an_unplugged_mouse_is_waited_for_and_read_on(
    testbed: Testbed, mouse: Plugged, tmp_path: Path
) -> None:
    file, errors = tmp_path / "session.csv", tmp_path / "errors"
    with started(testbed, errors, "--cpi", "800", "--record", str(file)) as process:
        until_said(errors, READING, process)
        sent = send(mouse, reach(0.0, REACHES[0], rate_hz=250.0))
        assert process.stdout is not None
        until_recorded(file, sent, process)  # what waits in the node is gone with it
        mouse.unplug()
        while not next(process.stdout).startswith("unplugged; "):
            pass
        again = plug(testbed, TWO_WHEELS, 1)
        while next(process.stdout).startswith("unplugged; "):
            pass
        sent += send(again, reach(0.0, REACHES[1], rate_hz=250.0))
        until_recorded(file, sent, process)
        process.send_signal(signal.SIGTERM)
        out, _ = process.communicate(timeout=PATIENCE_S)
    assert f"{sent} reports; 0 lost" in out


def test_a_session_without_clicks_is_cut_at_pauses(
    testbed: Testbed, mouse: Plugged, tmp_path: Path, command: Any
) -> None:
    file, errors = tmp_path / "session.csv", tmp_path / "errors"
    with started(testbed, errors, "--cpi", "800", "--record", str(file)) as process:
        until_said(errors, READING, process)
        sent = 0
        for way in REACHES[:2]:
            sent += send(mouse, reach(0.0, way, 0.2, rate_hz=250.0)[:-2])
            until_recorded(file, sent, process)
            time.sleep(0.6)  # the pause
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=PATIENCE_S)
    assert len(read(file).trials) == 2
    left = command("score", file, "--predictors", "switched")
    assert left.code == 0
    assert "no button was pressed: cut at pauses" in left.err
