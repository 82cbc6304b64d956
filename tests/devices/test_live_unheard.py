"""``pointpred live`` whose output is lost: it ends, and keeps what it recorded."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from pointpred.devices.source import Report
from tests.devices.live_process import PATIENCE_S, READING, send, started, until_said
from tests.devices.mice import TWO_WHEELS, Plugged, plug
from tests.devices.umockdev import Testbed

MOVEMENT = [Report(0.0, 100.0, 0.0)] * 25
"""All at once: a session whose output is full lasts no longer than a second."""
MOVED = "cursor 300, 0 px"
"""Where that leads at 800 counts per inch: everything has been read."""


@pytest.fixture
def mouse(testbed: Testbed) -> Plugged:
    return plug(testbed, TWO_WHEELS)


def recorded(process: subprocess.Popen[str], errors: Path, mouse: Plugged, file: Path) -> None:
    """A session that ends by itself has recorded everything that was sent."""
    until_said(errors, READING, process)
    sent = send(mouse, MOVEMENT)
    if process.stdout is not None:
        assert any(MOVED in line for line in process.stdout)
        process.stdout.close()
    process.wait(PATIENCE_S)
    assert len(file.read_text().splitlines()[2:]) == sent


def test_a_reader_that_goes_away_ends_it_quietly(testbed: Testbed, mouse: Plugged, tmp_path: Path) -> None:
    file, errors = tmp_path / "session.csv", tmp_path / "errors"
    with started(testbed, errors, "--cpi", "800", "--record", str(file)) as process:
        recorded(process, errors, mouse, file)
    assert process.returncode == 0
    assert errors.read_text().splitlines()[-1].startswith(READING)


def test_an_output_that_is_full_ends_it_with_the_reason(
    testbed: Testbed, mouse: Plugged, tmp_path: Path
) -> None:
    file, errors = tmp_path / "session.csv", tmp_path / "errors"
    with (
        Path("/dev/full").open("w") as full,
        started(testbed, errors, "--cpi", "800", "--record", str(file), out=full) as process,
    ):
        recorded(process, errors, mouse, file)
    assert process.returncode == 1
    assert errors.read_text().splitlines()[-1] == "pointpred: No space left on device"
