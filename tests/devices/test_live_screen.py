"""``pointpred live`` beside a screen: the cursor is read, the transfer function learnt, saved and used."""

from __future__ import annotations

import json
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest

from pointpred.recordings import read
from pointpred.transfer import ConstantGain, PixelTransfer, named_transfer
from tests.devices.evdev_mice import PLAIN, plug, write
from tests.devices.live_fakes import reach
from tests.devices.live_process import READING, started, until_said
from tests.devices.screens import HEIGHT, WIDTH, Screen
from tests.devices.umockdev import Testbed

START = WIDTH // 4, HEIGHT // 4
CPI, DPI = 2000.0, 96.0
WAYS = [(way, 0.4 * way) for way in np.linspace(60.0, 3600.0, 9)]


def drag(bed: Testbed, node: str, screen: Screen, ways: list[tuple[float, float]]) -> int:
    """There and back along each way, in counts; a constant gain of 4 moves the cursor. Reports sent."""
    transfer, at, sent = PixelTransfer(ConstantGain(4.0), cpi=CPI, dpi=DPI), START, 0
    for way in ways:
        for turn in (1.0, -1.0):
            began = time.time()
            for report in reach(0.0, (turn * way[0], turn * way[1]), 0.3, 250.0)[:-2]:
                time.sleep(max(0.0, began + report.t - time.time()))
                dx, dy, stamp = int(report.dx), int(report.dy), time.time_ns() // 1000
                if dx or dy:
                    moves = ((2, 0, dx), (2, 1, dy), (0, 0, 0))
                    write(bed, node, [(*divmod(stamp, 1_000_000), *move) for move in moves])
                    x, y = transfer.update((stamp / 1e6, dx, dy))
                    at = (at[0] + int(x), at[1] + int(y))
                    assert screen.place(*at) == at
                    sent += 1
            time.sleep(0.1)
    return sent


def ended(process: subprocess.Popen[str], errors: Path) -> str:
    process.send_signal(signal.SIGTERM)
    out, _ = process.communicate(timeout=30)
    assert process.returncode == 0, errors.read_text()
    return out


def test_what_the_screen_teaches_is_saved_and_moves_a_cursor_without_one(
    testbed: Testbed, screen: Screen, tmp_path: Path
) -> None:
    node, errors = plug(testbed, 3, PLAIN), tmp_path / "errors"
    saved, session = tmp_path / "desk.json", tmp_path / "session.csv"
    device = ("--device", node, "--cpi", str(CPI))
    words = (*device, "--save-transfer", str(saved), "--record", str(session))
    screen.place(*START)
    with started(testbed, errors, *words, display=screen.name) as process:
        until_said(errors, READING, process)
        assert "the screen's cursor, paired with the counts by time" in errors.read_text()
        drag(testbed, node, screen, WAYS)
        out = ended(process, errors)
    assert f"saved in {saved}" in out
    assert "identified between" in out
    low, high = (json.loads(saved.read_text())[f"speed_{end}"] for end in ("low", "high"))
    learnt = named_transfer(str(saved))
    assert learnt.cpi == CPI
    gains = learnt.function.gain(np.linspace(low, high, 20))
    assert float(np.mean(gains)) == pytest.approx(4.0, rel=0.15)  # how well: tests/devices/test_cursor_x11.py
    recorded = read(session)
    assert "no button was pressed: cut at pauses" in recorded.notes
    assert recorded.provenance.origin == "the screen's cursor, paired with the counts by time"

    again = tmp_path / "again.csv"
    words = ("--device", node, "--transfer", str(saved), "--record", str(again))
    with started(testbed, errors, *words) as process:
        until_said(errors, READING, process)
        assert "2000 counts per inch" in errors.read_text()  # the file says so
        assert "moved by a transfer function" in errors.read_text()
        drag(testbed, node, screen, WAYS[-3:])
        ended(process, errors)
    table = np.vstack([read(again).rows(i).table for i in range(len(read(again).trials))])
    moved = np.ptp(np.cumsum(table[:, 3])) * float(np.mean(gains)) * DPI / CPI
    assert np.ptp(table[:, 1]) == pytest.approx(moved, rel=0.15)


def test_a_screen_that_goes_ends_the_session_and_keeps_what_there_was(
    testbed: Testbed, screen: Screen, tmp_path: Path
) -> None:
    node, errors, session = plug(testbed, 3, PLAIN), tmp_path / "errors", tmp_path / "session.csv"
    words = ("--device", node, "--cpi", "2000", "--record", str(session))
    screen.place(*START)
    with started(testbed, errors, *words, display=screen.name) as process:
        until_said(errors, READING, process)
        drag(testbed, node, screen, WAYS[-1:])
        screen.stop()
        out, _ = process.communicate(timeout=30)
    assert process.returncode == 1
    assert f"pointpred: the X11 display {screen.name} is gone" in errors.read_text()
    assert "Traceback" not in errors.read_text()
    assert " reports; " in out
    assert len(read(session).trials) > 0
