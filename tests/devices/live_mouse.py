"""A mouse at 8 kHz, emulated: one process writes its reports, another reads them and predicts at each.

The reader is what ``pointpred live`` runs: ``HidSource`` on the hidapi wheel, a ``LiveSession``, a pipeline.
The writer notes when it wrote each report, so that what waited in between is seen too. The emulated node
holds 64 reports as the kernel's does, and what finds it full is dropped and counted, as a real mouse's is.
"""

from __future__ import annotations

import ctypes
import gc
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from tests.devices.mice import TWO_WHEELS, plug
from tests.devices.umockdev import Testbed, direct

MOVEMENT_S, MOST_COUNTS = 0.7, 6.0
WARM_UP = 2000
LATEST_S = 30.0
PR_SET_TIMERSLACK = 29


class Live(msgspec.Struct, frozen=True):
    """What came of one run; times in s, shares of one processor."""

    rate_hz: float
    reports: int
    read: int
    lost: int
    unreadable: int
    dropped: int
    exact: bool
    predicted: tuple[float, float, float]
    written: tuple[float, float, float]
    reader_share: float
    writer_share: float = 0.0


def motion(number: int, rate_hz: float) -> NDArray[np.int16]:
    """Counts of a hand that goes to and fro, ``number`` reports of dx and dy; the same in every process."""
    t = np.arange(number) / rate_hz
    speed = MOST_COUNTS * 1000.0 / rate_hz * np.sin(np.pi * t / MOVEMENT_S)
    x = np.round(np.cumsum(speed))
    return np.stack([np.diff(x, prepend=0.0), np.diff(np.round(x / 3), prepend=0.0)], axis=1).astype(np.int16)


def measure(rate_hz: float, seconds: float, predictor: str = "switched") -> Live:
    """Run both processes; raises CalledProcessError where one of them fails."""
    number = int(rate_hz * seconds)
    with Testbed() as testbed, tempfile.TemporaryDirectory() as folder:
        node, notes = plug(testbed, TWO_WHEELS).node, Path(folder, "written")
        hand = testbed.packets(node)
        plan = json.dumps([rate_hz, number, str(notes), predictor])
        command = [sys.executable, "-m", "tests.devices.live_mouse"]
        reader = subprocess.Popen(
            [*command, "read", plan], env=testbed.environment(), stdout=subprocess.PIPE, text=True
        )
        assert reader.stdout is not None
        try:
            reader.stdout.readline()
            words = [*command, "write", plan, str(hand)]
            own = subprocess.run(words, check=True, pass_fds=[hand], stdout=subprocess.PIPE).stdout
            output = reader.communicate(timeout=LATEST_S + 30)[0]
        finally:
            reader.kill()
            os.close(hand)
    share, rate = json.loads(own)
    return msgspec.structs.replace(msgspec.json.decode(output, type=Live), rate_hz=rate, writer_share=share)


def write(rate_hz: float, number: int, notes: str, hand: int) -> None:
    """The writer: each report at its time; notes when, and prints its own load and its true rate."""
    ctypes.CDLL(None).prctl(PR_SET_TIMERSLACK, 1)
    _keep_to(1)
    counts = motion(number, rate_hz).tolist()
    reports = [np.array([0, dx, dy, 0], dtype="<i2").tobytes() for dx, dy in counts]
    stamps, dropped = np.empty(number), []
    used, begin = time.process_time(), time.monotonic() + 0.1
    for i, report in enumerate(reports):
        if (left := begin + i / rate_hz - time.monotonic()) > 0:
            time.sleep(left)
        elif left < -1 / rate_hz:  # held up itself: a mouse sends no bursts, it goes on from here
            begin -= left
        stamps[i] = time.monotonic()
        try:
            os.write(hand, report)
        except BlockingIOError:  # the ring is full
            dropped.append(i)
    used, span = time.process_time() - used, stamps[-1] - stamps[0]
    np.delete(stamps, dropped).tofile(notes + ".part")
    Path(notes + ".part").rename(notes)
    print(json.dumps([used / span, (number - 1) / span]))


def read(rate_hz: float, number: int, notes: str, predictor: str) -> None:
    """The reader: predicts at every report, then says what came and how long it took."""
    from pointpred import PointerEvent, build
    from pointpred.devices.hidraw import HidSource
    from pointpred.live.session import LiveSession

    _keep_to(0)
    pipeline = build(predictor, cpi=1000.0)
    for i in range(WARM_UP):
        pipeline.update(PointerEvent(i / 1000, float(i), 0.0, 1.0, 0.0))
    pipeline.reset()
    gc.collect()
    gc.freeze()  # as pointpred live does: a full collection holds every thread for longer than the ring lasts
    with HidSource() as source:
        direct(source.path)
        session = LiveSession(source, None, pipeline)
        done = np.zeros(number)
        x = y = at = 0
        wanted = number
        print("ready", flush=True)
        while not (first := session.advance(1.0)):
            pass
        used, begin, until = (
            time.process_time(),
            time.monotonic(),
            time.monotonic() + number / rate_hz + LATEST_S,
        )
        pairs = first
        while True:
            now = time.monotonic()
            for event, _ in pairs:
                done[at] = now
                x, y, at = x + int(event.dx or 0), y + int(event.dy or 0), at + 1
            if not pairs and Path(notes).exists():  # the writer has ended; the rest is in its ring
                wanted = len(np.fromfile(notes))
            if at >= wanted or now > until:
                break
            pairs = session.advance()
        share = (time.process_time() - used) / (time.monotonic() - begin)
        while not Path(notes).exists():
            time.sleep(0.05)
        written = np.fromfile(notes)
        delays = session.delays
        expected = motion(number, rate_hz).astype(int).sum(axis=0).tolist()
        live = Live(
            rate_hz,
            number,
            at,
            source.lost,
            source.unreadable,
            number - len(written),
            [x, y] == expected,
            (delays.percentile(0.5) or 0.0, delays.percentile(0.99) or 0.0, delays.longest),
            tuple(np.quantile(done[:at] - written, [0.5, 0.99, 1.0]).tolist()),
            share,
        )
    print(msgspec.json.encode(live).decode())


def _keep_to(processor: int) -> None:
    """Stay on one processor where there are several, so that writer and reader do not share one."""
    several = sorted(os.sched_getaffinity(0))
    os.sched_setaffinity(0, {several[processor % len(several)]})


if __name__ == "__main__":
    role, (rate, many, kept, name) = sys.argv[1], json.loads(sys.argv[2])
    if role == "write":
        write(rate, many, kept, int(sys.argv[3]))
    else:
        read(rate, many, kept, name)
