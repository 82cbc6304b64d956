"""``pointpred live`` in a process of its own, beside an emulated mouse."""

from __future__ import annotations

import os
import struct
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO

from pointpred.devices.source import Report
from tests.devices.mice import Plugged
from tests.devices.umockdev import Testbed

READING = "predictor: "
"""The last line of the heading: from then on reports are read."""
PATIENCE_S = 60.0


def environment(testbed: Testbed) -> dict[str, str]:
    """The emulated devices, and no screen."""
    return {
        name: value
        for name, value in testbed.environment().items()
        if name not in ("DISPLAY", "WAYLAND_DISPLAY")
    }


@contextmanager
def started(
    testbed: Testbed,
    errors: Path,
    *arguments: str,
    out: int | IO[str] = subprocess.PIPE,
    stdin: int = subprocess.DEVNULL,
    display: str | None = None,
) -> Iterator[subprocess.Popen[str]]:
    """A process that reads the mouse; what it says on stderr goes to a file."""
    screen = {} if display is None else {"DISPLAY": display}
    command = [sys.executable, "-m", "pointpred", "live", *arguments]
    with errors.open("w") as said:
        process = subprocess.Popen(
            command,
            env=environment(testbed) | screen,
            stdin=stdin,
            stdout=out,
            stderr=said,
            text=True,
        )
    try:
        yield process
    finally:
        process.kill()
        process.wait()
        if process.stdout is not None:
            process.stdout.close()


def until_said(errors: Path, words: str, process: subprocess.Popen[str]) -> None:
    """Wait until the process has said something."""
    end = time.monotonic() + PATIENCE_S
    while words not in errors.read_text():
        assert process.poll() is None, errors.read_text()
        assert time.monotonic() < end, errors.read_text()
        time.sleep(0.02)


def until_recorded(file: Path, events: int, process: subprocess.Popen[str]) -> None:
    """Wait until so many events are in a recording: nowhere else shows what has been read of the mouse."""
    end = time.monotonic() + PATIENCE_S
    while (written := rows_of(file)) < events:
        assert process.poll() is None, f"it ended after {written} of {events} events"
        assert time.monotonic() < end, f"{written} of {events} events"
        time.sleep(0.02)


def rows_of(file: Path) -> int:
    """How many whole rows a recording has by now, below its two lines of heading."""
    return max(0, file.read_text().count("\n") - 2) if file.exists() else 0


def send(mouse: Plugged, reports: Iterable[Report]) -> int:
    """Send reports of a mouse with two wheels when their times come; returns how many."""
    began, count = time.monotonic(), 0
    for report in reports:
        time.sleep(max(0.0, began + report.t - time.monotonic()))
        os.write(mouse.hand, struct.pack("<Hhhbb", report.buttons, int(report.dx), int(report.dy), 0, 0))
        count += 1
    return count
