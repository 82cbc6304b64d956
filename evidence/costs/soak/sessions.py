"""The sessions of the soak's clients: what they send, and every answer and every recorded row compared.

``StreamClient`` is a client without its socket, bytes in and bytes out. Its frames are written and read
unchecked, so that wrong ones can be sent. It sends the movements of the embedded sample for ever.
``OfflineRun`` predicts the same events offline, and ``Reporter`` writes what came of it, a line of JSON a
second.
"""

from __future__ import annotations

import json
import math
import os
import sys
import tempfile
import threading
import time
from base64 import b64encode
from collections import Counter, deque
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv as pacsv

from pointpred import EventColumns, build, run
from pointpred.datasets import sample
from pointpred.protocol.client_messages import VERSION
from pointpred.protocol.frames import pack_events, pack_predictions, row_of_prediction, unpack_predictions
from pointpred.protocol.server_messages import PredictionMessage
from pointpred.recordings.own import EVENT_COLUMNS
from pointpred.records import EVENT_FIELDS, PHASES, PREDICTION_FIELDS, FloatArray

CPI, DPI = 800.0, 96.0
"""The device and the screen that every client of the soak names."""
PREDICTION_NUMBERS, EVENT_NUMBERS = len(PREDICTION_FIELDS), len(EVENT_FIELDS)
"""How many numbers of a prediction and of an event are stored."""


class OfflineRun:
    """The events of one session, in order, and every answer to them.

    ``file`` names two files of raw floats, the events and the predictions that an offline run makes of them:
    a session of an hour does not fit in memory.
    """

    def __init__(self, predictor: str, file: Path) -> None:
        self.answers = 0
        self.wrong: list[str] = []
        self.file = file
        self.events = 0
        self._pipeline = build(predictor, cpi=CPI, dpi=DPI)
        self._waiting: list[FloatArray] = []
        self._answers: list[FloatArray] = []
        self._times = np.empty(0)
        self._expected = np.empty((0, PREDICTION_NUMBERS))
        self._last_answer = -np.inf
        self._files = [path.open("wb") for path in paths(file)]

    def sent(self, table: FloatArray) -> None:
        """Take in events that were sent."""
        self.events += len(table)
        self._waiting.append(table)

    def answered(self, frame: str | bytes) -> float:
        """Take in a frame of predictions; returns the time of the newest."""
        if isinstance(frame, bytes):
            rows = np.array(unpack_predictions(frame)[0])
        else:
            message = msgspec.json.decode(frame, type=PredictionMessage)
            rows = np.array([row_of_prediction(message)])
        self._answers.append(rows)
        return float(rows[-1, 0])

    def compare(self) -> None:
        """Predict what was sent since the last call, and compare what was answered."""
        if self._waiting:
            table = np.concatenate(self._waiting)
            self._waiting.clear()
            predictions = run(self._pipeline, EventColumns(table)).table
            for file, rows in zip(self._files, (table, predictions), strict=True):
                file.write(np.ascontiguousarray(rows).tobytes())
            as_sent = np.array(unpack_predictions(pack_predictions(predictions))[0])
            self._times = np.concatenate([self._times, table[:, 0]])
            self._expected = np.concatenate([self._expected, as_sent])
        if not self._answers:
            return
        answers = np.concatenate(self._answers)
        self._answers.clear()
        self.answers += len(answers)
        times = np.concatenate([[self._last_answer], answers[:, 0]])
        if not (np.diff(times) > 0).all():
            self.wrong.append("answers out of order")
        at = np.searchsorted(self._times, answers[:, 0])
        if at[-1] >= len(self._times) or not same(answers, self._expected[at]):
            self.wrong.append(f"answers between {answers[0, 0]} and {answers[-1, 0]} s differ")
        self._last_answer = float(answers[-1, 0])
        self._times, self._expected = self._times[at[-1] :], self._expected[at[-1] :]

    @property
    def complete(self) -> bool:
        """Whether the newest event is answered."""
        return not self._waiting and (not self.events or len(self._times) == 1)

    def close(self) -> None:
        """Compare the rest, and close the files."""
        self.compare()
        for file in self._files:
            file.close()


def paths(file: Path) -> tuple[Path, Path]:
    """The files of events and predictions of an offline run."""
    return file.with_suffix(".events"), file.with_suffix(".predictions")


def same(one: FloatArray, other: FloatArray) -> bool:
    """Whether two tables hold the same numbers, bit for bit, but for the sign of a NaN."""
    return one.shape == other.shape and np.array_equal(one, other, equal_nan=True)


def difference(folder: Path, session: str, file: Path, *, whole: bool) -> str | None:
    """How a recorded session differs from what was sent and predicted offline; ``None`` where it does not.

    ``whole``: every event must be there; otherwise those up to some event, because the connection was cut.
    """
    events, predictions = paths(file)
    count = events.stat().st_size // (8 * EVENT_NUMBERS)
    parts = (("samples", events, EVENT_NUMBERS), ("predictions", predictions, PREDICTION_NUMBERS))
    for part, path, width in parts:
        recordings = list(folder.glob(f"*-{session}_{part}.csv"))
        if not recordings:
            if whole and count:
                return f"{part} of {session} are missing"
            continue
        rows = 0
        try:
            with path.open("rb") as expected_rows:
                for table in _tables(recordings[0], part):
                    expected = np.frombuffer(expected_rows.read(table.nbytes)).reshape(-1, width)
                    if not same(table, expected):
                        return f"{part} of {session} differ after row {rows}"
                    rows += len(table)
        except pa.ArrowInvalid as error:
            return f"{part} of {session} after row {rows}: {error}"
        if whole and rows != count:
            return f"{part} of {session}: {rows} of {count} rows are recorded"
    return None


def _tables(file: Path, part: str) -> Iterator[FloatArray]:
    """The numbers of a recorded file, a block at a time."""
    columns = EVENT_COLUMNS if part == "samples" else [field.column for field in PREDICTION_FIELDS]
    options = pacsv.ReadOptions(skip_rows=1 if part == "samples" else 0, block_size=1 << 22)
    kinds = {name: pa.string() if name == "phase" else pa.float64() for name in columns}
    conversion = pacsv.ConvertOptions(include_columns=list(columns), column_types=kinds)
    with pacsv.open_csv(file, options, convert_options=conversion) as reader:
        for batch in reader:
            yield np.column_stack([_numbers(column) for column in batch.columns])


def _numbers(column: pa.Array) -> FloatArray:
    """A column as floats, NaN where a cell is empty; a phase as its code."""
    if pa.types.is_string(column.type):
        column = pc.index_in(column, pa.array(PHASES))
    values: FloatArray = column.cast("double").to_numpy(zero_copy_only=False)
    return values


TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
APART = 9973
"""Events between the beginnings of two clients in the sample."""
ERROR, PREDICTION = b'{"type":"error"', b'{"type":"prediction"'


def frame(opcode: int, payload: bytes) -> bytes:
    """A client's frame; the masking key is zero, which spares the load generator, not the server."""
    size = len(payload)
    if size < 126:
        head = bytes((0x80 | opcode, 0x80 | size))
    elif size < 65536:
        head = bytes((0x80 | opcode, 0x80 | 126)) + size.to_bytes(2, "big")
    else:
        head = bytes((0x80 | opcode, 0x80 | 127)) + size.to_bytes(8, "big")
    return head + bytes(4) + payload


def split(received: bytes) -> tuple[list[tuple[int, bytes]], bytes]:
    """The server's whole frames, as opcode and payload, and what is left over."""
    frames, at = [], 0
    while len(received) - at >= 2:
        head, size, start = received[at] & 15, received[at + 1], at + 2
        if size == 126:
            size, start = int.from_bytes(received[at + 2 : at + 4], "big"), at + 4
        elif size == 127:
            size, start = int.from_bytes(received[at + 2 : at + 10], "big"), at + 10
        if start + size > len(received):
            break
        frames.append((head, received[start : start + size]))
        at = start + size
    return frames, received[at:]


@cache
def _recorded() -> FloatArray:
    return sample().events.table


def events(number: int, rate_hz: float, first: int, count: int) -> FloatArray:
    """Events ``first`` to ``first + count`` of a client, as rows of t s, x px, y px, dx, dy, buttons."""
    recorded = _recorded()
    places = np.arange(first, first + count)
    table = recorded[(places + number * APART) % len(recorded)]
    table[:, 0] = places / rate_hz
    return table


BYE = frame(TEXT, b'{"type":"bye"}')


def upgrade(port: int, path: str = "/v1/stream") -> bytes:
    """The request that begins a WebSocket."""
    return (
        f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        f"Sec-WebSocket-Key: {b64encode(bytes(16)).decode()}\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Protocol: pointpred.v1\r\n\r\n"
    ).encode()


class StreamClient:
    """Speaks for a client that keeps to the rules.

    ``delays`` holds the seconds from when an event was due to be sent to the first answer that counts it.
    """

    def __init__(
        self,
        folder: Path,
        number: int,
        rate_hz: float,
        *,
        predictor: str = "switched",
        encoding: str = "binary",
        reply: str = "frame",
    ) -> None:
        self.session = ""
        self.close_code = 0
        self.errors: list[str] = []
        """Errors that an innocent client must not get."""
        self.behind = 0
        """How often the service said that answers gave way to newer ones."""
        self.delays: list[float] = []
        descriptor, file = tempfile.mkstemp(dir=folder)
        os.close(descriptor)
        self.run = OfflineRun(predictor, Path(file))
        self._number, self._rate_hz, self._binary = number, rate_hz, encoding == "binary"
        self._hello = {"type": "hello", "version": VERSION, "predictor": predictor, "encoding": encoding}
        self._hello |= {"reply": reply, "device": {"cpi": CPI}, "screen": {"dpi": DPI}}
        self._rest = b""
        self._upgraded = False
        self._due: deque[tuple[float, float]] = deque()

    def skip(self, seconds: float) -> None:
        """The next event is later by so much: nobody moved."""
        self._pause += seconds

    _pause = 0.0

    def frames(self, count: int, due: float, *, a_frame: int = 1) -> bytes:
        """The next events, framed; they were to be sent at ``due``."""
        table = events(self._number, self._rate_hz, self.run.events, count)
        table[:, 0] += self._pause
        self.run.sent(table)
        self._due.extend((t, due) for t in table[:, 0].tolist())
        return b"".join(self._frame(table[at : at + a_frame]) for at in range(0, count, a_frame))

    def _frame(self, table: FloatArray) -> bytes:
        if self._binary:
            return frame(BINARY, pack_events(table))
        rows = [[*row[:5], int(row[5])] for row in table.tolist()]
        return frame(TEXT, json.dumps({"type": "events", "events": rows}).encode())

    def receive(self, data: bytes, now: float) -> bytes:
        """Take in what came; returns what is to be sent at once."""
        self._rest += data
        if not self._upgraded:
            head, end, rest = self._rest.partition(b"\r\n\r\n")
            if not end:
                return b""
            if not head.startswith(b"HTTP/1.1 101"):
                raise ConnectionError(f"no upgrade: {head[:80]!r}")
            self._upgraded, self._rest = True, rest
            return frame(TEXT, json.dumps(self._hello).encode())
        frames, self._rest = split(self._rest)
        return b"".join(self._take(opcode, payload, now) for opcode, payload in frames)

    def _take(self, opcode: int, payload: bytes, now: float) -> bytes:
        if opcode == PING:
            return frame(PONG, payload)
        if opcode == CLOSE:
            self.close_code = int.from_bytes(payload[:2], "big")
            return frame(CLOSE, payload[:2])
        if opcode == BINARY or payload.startswith(PREDICTION):
            self._answered(self.run.answered(payload if opcode == BINARY else payload.decode()), now)
        elif opcode == TEXT and not self.session:
            self.session = msgspec.json.decode(payload).get("session", "")
        elif payload.startswith(ERROR):
            if msgspec.json.decode(payload)["code"] == "slow":
                self.behind += 1
            else:
                self.errors.append(payload.decode())
        return b""

    def _answered(self, newest: float, now: float) -> None:
        while self._due and self._due[0][0] <= newest:
            self.delays.append(now - self._due.popleft()[1])

    def take_delays(self) -> np.ndarray:
        """The delays since the last call, s."""
        delays, self.delays = np.array(self.delays), []
        return delays

    @property
    def answered(self) -> bool:
        """Whether every event is answered."""
        return not self._due


SHORTEST_S, RATIO = 1e-5, 1.01
"""The bins of delays: each ends 1 % above the one before."""
LATER_S = 1.0
"""After the entry in the log the recorder writes what waits."""
LOOK_S = 0.25
PATIENCE_S = 120.0
"""A session that its client has left is on the disk within this time."""


class Plan(msgspec.Struct):
    """Where the service is, and where what the clients sent is kept until it is compared."""

    port: int
    pid: int
    log: str
    scratch: str
    recordings: str
    seed: int = 1


class Report(msgspec.Struct):
    """What happened since the last one."""

    delays: dict[int, int] = {}
    counts: dict[str, int] = {}
    wrong: list[str] = []


def bin_of(delay_s: float) -> int:
    """The bin of a delay."""
    return max(0, math.ceil(math.log(max(delay_s, SHORTEST_S) / SHORTEST_S) / math.log(RATIO)))


def delay_of(number: int) -> float:
    """The upper end of a bin, s."""
    return SHORTEST_S * RATIO**number


class Endings:
    """Reads the log of a service as it grows; one object may serve several threads."""

    def __init__(self, log: Path, pid: int) -> None:
        self._log = log
        self._descriptors = Path(f"/proc/{pid}/fd")
        self._closed: set[str] = set()
        self._at = 0
        self._lock = threading.Lock()

    def wait(self, session: str, patience_s: float) -> bool:
        """Wait until a session has ended and is on the disk; False where that takes too long."""
        until = time.monotonic() + patience_s
        while not self._is_closed(session):
            if time.monotonic() > until:
                return False
            time.sleep(LOOK_S)
        time.sleep(LATER_S)
        while any(session in name for name in self._open()):
            if time.monotonic() > until:
                return False
            time.sleep(LOOK_S)
        return True

    def _is_closed(self, session: str) -> bool:
        with self._lock:
            self._read()
            return session in self._closed

    def _read(self) -> None:
        """Take in what was logged since the last time."""
        with self._log.open("rb") as log:
            log.seek(self._at)
            whole, end, _ = log.read().rpartition(b"\n")
        self._at += len(whole) + len(end)
        entries = [json.loads(line) for line in whole.splitlines() if line.startswith(b"{")]
        self._closed |= {entry["session"] for entry in entries if "session closed" in entry["message"]}

    def _open(self) -> list[str]:
        """The files that the service holds open."""
        names = []
        for descriptor in self._descriptors.iterdir():
            with suppress(OSError):  # closed meanwhile
                names.append(str(descriptor.readlink()))
        return names


class Reporter:
    """Collects what the clients of one process do, and writes it to stdout."""

    def __init__(self, plan: Plan) -> None:
        self._folder = Path(plan.recordings)
        self._endings = Endings(Path(plan.log), plan.pid)
        self.counts: Counter[str] = Counter()
        self.wrong: list[str] = []
        self._delays: Counter[int] = Counter()
        self._lock = threading.Lock()
        self.stopping = threading.Event()
        """Set when the soak has closed our stdin."""
        threading.Thread(target=self._watch, daemon=True).start()

    def _watch(self) -> None:
        sys.stdin.read()
        self.stopping.set()

    def add_delays(self, delays: np.ndarray) -> None:
        """Count delays of answers to events."""
        self._delays.update(bin_of(delay) for delay in delays.tolist())

    def write(self) -> None:
        """Write what has come together since the last line."""
        with self._lock:
            line = msgspec.json.encode(Report(dict(self._delays), dict(self.counts), self.wrong))
            self._delays.clear()
            self.counts.clear()
            self.wrong.clear()
        sys.stdout.write(line.decode() + "\n")
        sys.stdout.flush()

    def conclude(self, client: StreamClient, *, whole: bool) -> None:
        """Compare what was answered and recorded of a session that its client has left; blocks.

        ``whole``: the client left as it should, so every event is answered and recorded.
        """
        client.run.close()
        wrong = client.run.wrong + client.errors
        if whole and not client.run.complete:
            wrong.append(f"{client.session}: its last events were not answered")
        if client.session:
            if not self._endings.wait(client.session, PATIENCE_S):
                wrong.append(f"{client.session}: the service has not ended it after {PATIENCE_S:g} s")
            elif message := difference(self._folder, client.session, client.run.file, whole=whole):
                wrong.append(message)
        counts = Counter({"events sent": client.run.events, "predictions compared": client.run.answers})
        counts["sessions compared" if client.session else "sessions without a welcome"] = 1
        if not wrong:
            counts.update(_forget(client, self._folder))
        with self._lock:
            self.wrong += wrong
            self.counts.update(counts)


def _forget(client: StreamClient, folder: Path) -> Counter[str]:
    """Remove the files of a session in which everything was right, and count their bytes.

    An hour of them would take gigabytes.
    """
    bytes_of: Counter[str] = Counter()
    for file in (client.run.file, *paths(client.run.file)):
        file.unlink()
    for file in folder.glob(f"*-{client.session}_*.csv") if client.session else ():
        bytes_of[f"bytes of {file.stem.rpartition('_')[2]}"] += file.stat().st_size
        file.unlink()
    return bytes_of
