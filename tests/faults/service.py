"""A real service for a fault: a process of its own that records, and what can be seen of it from outside."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self
from urllib.request import urlopen

import numpy as np
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from pointpred import EventColumns, build, run
from pointpred.datasets import sample
from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.protocol.frames import PREDICTION, pack_events, pack_predictions
from pointpred.recordings import read
from pointpred.records import FloatArray
from tests.server.running import PATIENCE_S

AT_ONCE = 50
"""Events that are sent before their answers are read."""


@dataclass
class Running:
    """A service that answers."""

    process: subprocess.Popen[str]
    address: str
    folder: Path
    """Where it records, as this process sees it."""
    log: Path
    token: str = ""

    @property
    def url(self) -> str:
        """The address of the stream."""
        return f"{self.address.replace('http', 'ws', 1)}v1/stream?token={self.token}"

    def metric(self, name: str) -> float:
        """A metric, as it was within the last second."""
        address = re.search(r"Metrics: (http://[^\s\"]+)", self.log.read_text())
        assert address is not None
        with urlopen(address[1], timeout=PATIENCE_S) as answer:
            lines = answer.read().decode().splitlines()
        return sum(float(line.rpartition(" ")[2]) for line in lines if line.startswith(name))

    def errors(self) -> list[str]:
        """The messages of the errors in the log."""
        entries = [json.loads(line) for line in self.log.read_text().splitlines() if line.startswith("{")]
        return [entry["message"] for entry in entries if entry["level"] == "error"]

    def samples(self, session: str) -> Path | None:
        """The events that are recorded of a session, where there are any."""
        return next(self.folder.glob(f"*-{session}_samples.csv"), None)

    def stop(self) -> int:
        """SIGTERM, and the exit status."""
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(PATIENCE_S)


@contextmanager
def service(
    tmp_path: Path,
    *options: str,
    wrapper: Sequence[str] = (),
    environment: Mapping[str, str] | None = None,
    inside: Path | None = None,
) -> Iterator[Running]:
    """``pointpred serve`` with recording, ready to answer.

    ``wrapper`` is a command that runs it; ``inside`` the folder, where that is not in ``tmp_path``.
    """
    folder, log = inside or tmp_path / "kept", tmp_path / "log"
    command = [*wrapper, sys.executable, "-m", "pointpred", "serve", "--port", "0", "--metrics-port", "0"]
    with log.open("w") as errors:
        process = subprocess.Popen(
            [*command, "--record", str(folder), *options],
            stdout=subprocess.PIPE,
            stderr=errors,
            text=True,
            env=environment,
        )
        try:
            assert process.stdout is not None
            address = process.stdout.readline().strip()
            assert address.startswith("http://"), log.read_text()
            seen = Path(f"/proc/{process.pid}/root{folder}") if inside else folder
            yield Running(process, address, seen, log)
        finally:
            process.send_signal(signal.SIGCONT)
            process.kill()
            process.wait()
            if process.stdout:
                process.stdout.close()


class Client:
    """A session whose every prediction is compared with an offline run, bit for bit."""

    def __init__(self, url: str, predictor: str = "linear", reply: str = "event") -> None:
        # Where a test fails, answers that nobody reads keep the close frame from being read.
        patient = {"open_timeout": PATIENCE_S, "close_timeout": 10.0}
        self.sent: FloatArray = np.empty((0, 6))
        self._hello = {"type": "hello", "version": 1, "predictor": predictor, "encoding": "binary"}
        self._hello["reply"] = reply
        self._pipeline = build(predictor)
        self._connection = connect(
            url, subprotocols=[Subprotocol(SUBPROTOCOL)], compression=None, ping_interval=None, **patient
        )

    def __enter__(self) -> Self:
        self.socket: ClientConnection = self._connection.__enter__()
        self.socket.send(json.dumps(self._hello))
        self.session: str = json.loads(self.socket.recv(PATIENCE_S))["session"]
        return self

    def __exit__(self, *left: Any) -> None:
        self._connection.__exit__(*left)

    def exchange(self, count: int) -> None:
        """Send events, one a message, and compare what is predicted for each."""
        for first in range(0, count, AT_ONCE):
            table = self.send(min(AT_ONCE, count - first))
            expected = pack_predictions(run(self._pipeline, EventColumns(table)).table, version=1)
            answers = b""
            while len(answers) < len(table) * PREDICTION[1].itemsize:
                answer = self.socket.recv(PATIENCE_S)
                assert isinstance(answer, bytes), answer
                answers += answer
            assert answers == expected

    def send(self, count: int) -> FloatArray:
        """Send events, one a message, and read nothing."""
        first = len(self.sent)
        table = sample().events.table[first : first + count].copy()
        table[:, 0] = np.arange(first, first + count) / 1000
        self.sent = np.concatenate([self.sent, table])
        for row in table:
            self.socket.send(pack_events(row[None]))
        return table

    def leave(self) -> None:
        """Say bye, and wait until the service has closed."""
        self.socket.send('{"type":"bye"}')
        for _ in self.socket:
            pass

    def recorded(self, running: Running) -> FloatArray:
        """The events that are recorded of this session; each was sent."""
        file = running.samples(self.session)
        table = np.empty((0, 6)) if file is None else rows_of(file)
        np.testing.assert_array_equal(table, self.sent[: len(table)])
        return table


def rows_of(file: Path) -> FloatArray:
    """The whole rows of a samples file, which the scorer can read as it is; none before the first write."""
    lines = file.read_bytes().splitlines(keepends=True)[2:]
    cells = [line.rstrip().split(b",")[2:] for line in lines if line.endswith(b"\n")]
    if cells:
        read(file)
    return np.array([[float(cell or "nan") for cell in row] for row in cells]).reshape(-1, 6)
