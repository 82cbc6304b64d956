"""A real service is killed in the middle of a stream at 1 kHz: at most the last second is lost."""

from __future__ import annotations

import json
import os
import signal
import struct
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.request import urlopen

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from pointpred.protocol.frames import EVENT
from pointpred.recorder.recordings import listing
from pointpred.recordings import read
from tests.server.listener import soon
from tests.server.running import PATIENCE_S

RATE_HZ = 1000
LASTS_S = 4.0
AHEAD = 200
REACH_S, CYCLE_S, CLICK_S = 0.6, 0.8, 0.05


def reach(t: float) -> tuple[float, float, float, int, int, int]:
    """Reaches of 400 px to and fro, each ended by a click; ``t`` from the stream's beginning."""
    number, phase = divmod(t, CYCLE_S)
    s = min(1.0, phase / REACH_S)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    x = 100.0 + 400.0 * (way if number % 2 == 0 else 1.0 - way)
    held = REACH_S + 0.1 <= phase < REACH_S + 0.1 + CLICK_S
    return t, x, 300.0 + 0.1 * x, -32768, -32768, int(held)


def wait_until_ready(address: str) -> None:
    until = time.monotonic() + 2 * PATIENCE_S
    while time.monotonic() < until:
        try:
            with urlopen(f"{address}readyz", timeout=PATIENCE_S):
                return
        except OSError:  # nobody listens yet
            time.sleep(0.05)
    pytest.fail("the service was not ready in time")


@pytest.fixture
def serving(tmp_path: Path) -> Iterator[tuple[subprocess.Popen[str], str, Path]]:
    """A service that records into a folder, ready to answer."""
    folder = tmp_path / "kept"
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0", "--record", str(folder)]
    with (tmp_path / "log").open("w") as log:
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True)
        try:
            assert process.stdout is not None
            address = process.stdout.readline().strip()
            assert address.startswith("http://127.0.0.1:"), (tmp_path / "log").read_text()
            wait_until_ready(address)
            yield process, address.replace("http", "ws", 1) + "v1/stream", folder
        finally:
            process.kill()
            process.wait()
            if process.stdout:
                process.stdout.close()


class Answers(threading.Thread):
    """Reads answers until the connection is gone, and notes when each event was answered first."""

    def __init__(self, socket: Any) -> None:
        super().__init__()
        self.times: list[float] = []
        """When an event, or one after it, was answered; predictions may give way to newer ones."""
        self._socket = socket

    def run(self) -> None:
        with suppress(ConnectionClosed):
            while True:
                answer = self._socket.recv()
                if isinstance(answer, bytes):
                    (t,) = struct.unpack_from("<d", answer)
                    newer = round(t * RATE_HZ) + 1 - len(self.times)
                    self.times += [time.monotonic()] * newer


def stream(url: str, seconds: float, end: Callable[[Answers], object]) -> tuple[np.ndarray, list[float]]:
    """Send events, one a message, at most 1 kHz and ``AHEAD`` ahead of the answers, then ``end``.

    Returns the rows sent and when each was answered.
    """
    sent: list[tuple[float, float, float, int, int, int]] = []
    count = round(seconds * RATE_HZ)
    patient = {"open_timeout": PATIENCE_S, "ping_timeout": PATIENCE_S, "close_timeout": PATIENCE_S}
    with connect(url, subprotocols=["pointpred.v1"], compression=None, **patient) as socket:
        hello = {"type": "hello", "version": 1, "predictor": "linear", "encoding": "binary"}
        socket.send(json.dumps(hello))
        answers = Answers(socket)
        answers.start()
        begun = time.monotonic()
        while len(sent) < count:
            due = (time.monotonic() - begun) * RATE_HZ
            while len(sent) < min(due, count, len(answers.times) + AHEAD):
                row = reach(len(sent) / RATE_HZ)
                socket.send(np.array([row], EVENT).tobytes())
                sent.append(row)
            time.sleep(0.0005)
        end(answers)
    answers.join()
    return np.array(sent), answers.times


class Growth:
    """Notes when a samples file has grown: a kill between two growths would lose all that came since.

    ``stalled`` is the longest time for which the machine let nobody look, or put a byte on the disk: nobody
    writes then, either.
    """

    def __init__(self, folder: Path) -> None:
        self.stalled = 0.0
        self.times: list[float] = []
        self._folder = folder
        self._probe = folder.with_name("probe")
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._look)

    def __enter__(self) -> Growth:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._done.set()
        self._thread.join()

    def _look(self) -> None:
        size, looked, looks = 0, time.monotonic(), 0
        with self._probe.open("wb", buffering=0) as probe:
            while not self._done.wait(0.005):
                self.stalled = max(self.stalled, time.monotonic() - looked - 0.005)
                looked, looks = time.monotonic(), looks + 1
                sizes = [path.stat().st_size for path in self._folder.glob("*_samples.csv")]
                if sizes and sizes[0] != size:
                    size = sizes[0]
                    self.times.append(time.monotonic())
                if looks % 20 == 0:  # as often as the recorder
                    probe.write(b".")
                    os.fsync(probe.fileno())


def test_a_killed_service_loses_at_most_one_second(
    serving: tuple[subprocess.Popen[str], str, Path], command: Any
) -> None:
    process, url, folder = serving
    moment: list[float] = []

    def kill(answers: Answers) -> None:
        moment.append(time.monotonic())
        os.kill(process.pid, signal.SIGKILL)

    with Growth(folder) as growth:
        sent, answered = stream(url, LASTS_S, kill)
    (killed,) = moment  # what comes after it, such as the end of the connection, is no loss
    assert process.wait() == -signal.SIGKILL
    silent_s = np.diff(answered).max()  # while the machine let the service do nothing, it took in nothing
    most_s = 1.0 + growth.stalled + silent_s
    (one,) = listing(folder)
    assert one.problem is None
    samples = next(path for path in one.files if path.name.endswith("_samples.csv"))
    lines = samples.read_bytes().splitlines(keepends=True)
    rows = [line.split(b",") for line in lines[2:] if line.endswith(b"\n")]
    kept = np.array([[float(cell) for cell in row[2:5]] for row in rows])
    lost_s = killed - answered[len(kept)] if len(kept) < len(answered) else 0.0
    np.testing.assert_array_equal(kept, sent[: len(kept), :3])
    assert lost_s <= most_s, f"lost {lost_s} s"
    since = [answered[0], *(time_s for time_s in growth.times if answered[0] < time_s < killed), killed]
    assert np.diff(since).max() <= most_s, "killed at another moment, it would have lost more"
    left = command("score", samples, "--predictors", "linear", "--json", "-")
    assert left.code == 0, left.err
    (scored,) = json.loads(left.out)["sets"]
    clicks = np.count_nonzero(np.diff(sent[: len(kept), 5]) > 0)
    assert scored["trials"] == clicks >= 2


def test_a_stopped_service_loses_nothing(serving: tuple[subprocess.Popen[str], str, Path]) -> None:
    process, url, folder = serving
    sent, _ = stream(url, 0.9, lambda answers: soon(lambda: len(answers.times) == 900, "all is answered"))
    process.send_signal(signal.SIGTERM)
    process.wait(PATIENCE_S)
    recording = read(next(folder.glob("*_samples.csv")))
    outside = [skip.trial.split() for skip in recording.skipped]
    rows = len(recording.events) + sum(int(words[3]) - int(words[1]) + 1 for words in outside)
    assert rows == len(sent)
    (predictions,) = folder.glob("*_predictions.csv")
    assert len(predictions.read_text(encoding="utf-8").splitlines()) == 1 + len(sent)


def test_a_service_that_is_not_asked_to_record_writes_nothing(tmp_path: Path) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "POINTPRED_RECORD"}
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0"]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, cwd=tmp_path, env=environment
    )
    try:
        assert process.stdout is not None
        url = process.stdout.readline().strip().replace("http", "ws", 1) + "v1/stream"
        assert len(stream(url, 0.3, lambda answers: None)[1]) > 100
    finally:
        process.terminate()
        process.wait(PATIENCE_S)
        if process.stdout:
            process.stdout.close()
    assert list(tmp_path.iterdir()) == []
