"""``pointpred live`` in a terminal, as a person sees it."""

from __future__ import annotations

import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import termios
import time
from collections.abc import Callable
from fcntl import ioctl

from tests.devices.live_fakes import reach
from tests.devices.live_process import PATIENCE_S, environment, send
from tests.devices.mice import TWO_WHEELS, plug
from tests.devices.umockdev import Testbed

END_OF_VIEW = "Ctrl-C stops"
REACH = reach(0.0, (900.0, -400.0))


def screen_of(testbed: Testbed, *arguments: str) -> tuple[subprocess.Popen[bytes], int]:
    """``pointpred live`` in a terminal of 100 columns; the descriptor reads what is drawn there."""
    ours, theirs = pty.openpty()
    ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 100, 0, 0))
    words = [sys.executable, "-m", "pointpred", "live", *arguments]
    surroundings = environment(testbed) | {"TERM": "xterm-256color"}
    process = subprocess.Popen(words, env=surroundings, stdin=theirs, stdout=theirs, stderr=theirs)
    os.close(theirs)
    return process, ours


def drawn(screen: int, *words: str, meanwhile: Callable[[], None] = lambda: None) -> str:
    """What is drawn until some words are, in this order; between two looks something else may be done."""
    wanted = re.compile(".*".join(re.escape(each) for each in words), re.DOTALL)
    said, end = "", time.monotonic() + PATIENCE_S
    while not wanted.search(said):
        assert time.monotonic() < end, f"waited for {words!r}, saw {said[-3000:]!r}"
        meanwhile()
        wait_s = 0.1
        while select.select([screen], [], [], wait_s)[0]:
            said, wait_s = said + os.read(screen, 65536).decode(errors="replace"), 0.0
    return said


def test_the_terminal_asks_shows_and_stops(testbed: Testbed) -> None:
    mouse = plug(testbed, TWO_WHEELS)
    process, screen = screen_of(testbed, "--predictor", "switched")
    try:
        drawn(screen, "Counts per inch of the mouse")
        os.write(screen, b"fast\n")
        drawn(screen, "expected a number, m or -")
        os.write(screen, b"1200\n")
        first = drawn(screen, END_OF_VIEW)
        assert "1200 counts per inch" in first
        assert "motor space" in first
        sent: list[int] = []
        # the view looks now and then and may miss one movement: the hand goes on until it has seen one
        drawn(screen, "px away", "ballistic", meanwhile=lambda: sent.append(send(mouse, REACH)))
        drawn(screen, "at rest", f"{sum(sent)}, now", "0 lost, 0 unreadable, 0 refused", END_OF_VIEW)
        process.send_signal(signal.SIGINT)
        drawn(screen, f"{sum(sent)} reports; ")
        assert process.wait(PATIENCE_S) == 0
    finally:
        process.kill()
        process.wait()
        os.close(screen)
