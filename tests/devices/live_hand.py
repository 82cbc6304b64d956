"""A hand in real time: counts on an emulated node, and the cursor that a transfer function makes of them."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from math import cos, sin
from typing import Any

from pointpred.transfer import PixelTransfer, TransferFunction
from tests.devices.evdev_mice import write
from tests.devices.screens import HEIGHT, WIDTH, Screen
from tests.devices.umockdev import Testbed

CPI, DPI = 2000.0, 96.0
PERIOD_S = 0.003
START = WIDTH // 4, HEIGHT // 4
CHILD = "from tests.devices.live_hand import child; child()"


def strokes(peaks: list[float], duration_s: float) -> Iterator[tuple[int, float, float]]:
    """Where the hand is, in m, and when, in us: minimum-jerk movements there and back for each peak speed.

    A place every PERIOD_S, never early. On a machine that is held up the places come late, stamped as the
    kernel stamps whoever reads late: neither the hand's speed nor the number of its places is the machine's.
    """
    stamp_us = time.monotonic_ns() // 1000
    for i, peak in enumerate(peaks):
        angle, length = 0.6 * i / len(peaks), peak * duration_s / 1.875
        for back in (False, True):
            for step in range(round(1.2 * duration_s / PERIOD_S)):
                u = min(step * PERIOD_S / duration_s, 1.0)
                share = 10.0 * u**3 - 15.0 * u**4 + 6.0 * u**5
                way = length * (1.0 - share if back else share)
                time.sleep(max(stamp_us / 1e6 - time.monotonic(), 0.0))
                yield stamp_us, way * cos(angle), way * sin(angle)
                stamp_us += round(1e6 * PERIOD_S)


def work(
    bed: Testbed, node: str, screen: Screen, function: TransferFunction, peaks: list[float]
) -> Iterator[int]:
    """Move the mouse and, as the system would, the cursor; yields how many reports were sent, after each.

    Going on only when the report has been read leaves out how long this machine lets readers wait: what is
    measured is the pairing.
    """
    transfer, sent = PixelTransfer(function, cpi=CPI, dpi=DPI), 0
    column, row, at = 0, 0, START
    for stamp_us, x, y in strokes(peaks, 0.3):
        dx, dy = int(x * CPI / 0.0254) - column, int(y * CPI / 0.0254) - row
        if not (dx or dy):
            continue
        column, row = column + dx, row + dy
        moved = transfer.update((stamp_us / 1e6, dx, dy))
        at = screen.place(at[0] + moved[0], at[1] + moved[1])
        stamp = divmod(stamp_us, 1_000_000)
        write(bed, node, [(*stamp, 2, 0, dx), (*stamp, 2, 1, dy), (*stamp, 0, 0, 0)])
        sent += 1
        yield sent


def learn(bed: Testbed, node: str, screen: Screen) -> subprocess.Popen[str]:
    """A child that reads the node and the screen's cursor and learns the transfer function from both."""
    return bed.python(CHILD, node, screen.name)


def child() -> None:
    """Learns, and says how many reports it has seen, until its input ends; then tells what it learnt."""
    import threading

    import msgspec

    from pointpred.devices import evdev
    from pointpred.devices.cursor_paths import Pairing
    from pointpred.devices.evdev import EvdevSource
    from pointpred.devices.screen_cursor import ScreenCursor
    from pointpred.transfer import TransferLearner

    evdev._granted = lambda file: True  # as a kernel does: this emulation refuses the monotonic clock
    done = threading.Event()

    def answer(said: Any) -> None:
        sys.stdout.write(json.dumps(said) + "\n")
        sys.stdout.flush()

    with EvdevSource(sys.argv[1]) as source, ScreenCursor(sys.argv[2]) as cursor:
        learner = TransferLearner(cpi=CPI, dpi=DPI, size=cursor.size)
        pairing, seen, last = Pairing(cursor), 0, None
        pairing.events([])
        answer("ready")
        threading.Thread(target=lambda: (sys.stdin.read(), done.set()), daemon=True).start()
        while not done.is_set():
            if not (reports := source.take(0.05)):
                continue  # a look now might find the cursor of a report that is only on its way
            for event in pairing.events(reports):
                seen, last = seen + bool(event.dx or event.dy), event
                learner.update(event)
                answer(seen)
        place = None if last is None else (last.x, last.y)
        counts = {"lost": source.lost, "unpaired": pairing.unpaired, "place": place}
        answer(counts | {"curve": msgspec.to_builtins(learner.curve()), "cursor": cursor.position()})
