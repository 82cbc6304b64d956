"""The load generator: recorded movements to replay, the plan that it is given, and its counts as records.

It is built with ``cc`` when it is needed. Movements are replayed at any rate, in whole frames.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from evidence import ROOT
from evidence.machine import on_cores
from evidence.sets import folder
from pointpred.datasets import sample
from pointpred.protocol.frames import NO_COUNTS
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.records import FloatArray

SECONDS = 10.0
"""Movements of so many seconds are replayed; each client begins at another of them."""
LONGEST_S = 5.0
"""Trials with longer pauses than this are left out."""
SETS = ("kh2017", "freihaut2021", "cryslacks")
"""Sets of people, of which the first that the folder holds is used."""
EVENTS = np.dtype(
    [
        ("begin", "u1"),
        ("text_size", "u1"),
        ("x", "<f8"),
        ("y", "<f8"),
        ("dx", "<i2"),
        ("dy", "<i2"),
        ("buttons", "<u2"),
        ("text", "S102"),
    ]
)
"""An event without its time, packed as on the wire and as JSON: ``struct event`` of ``client.h``."""


@cache
def recording() -> Recording:
    """Recorded movements of people where there are any, else the embedded sample."""
    where = folder()
    files = [file for name in SETS if where for file in sorted(where.glob(f"{name}_samples.*"))]
    return read(files[0]) if files else sample()


def hello(predictor: str, encoding: str = "binary", **fields: object) -> str:
    """The first message of a session whose device is that of the recording."""
    cpi = recording().provenance.cpi
    device = {} if cpi is None else {"device": {"cpi": cpi}}
    return json.dumps(
        {"type": "hello", "version": 1, "predictor": predictor, "encoding": encoding, **device, **fields}
    )


def tables() -> Iterator[FloatArray]:
    """The trials, in an order that does not go person by person."""
    source = recording()
    for trial in np.random.default_rng(17).permutation(len(source.trials)):
        first, last = source.offsets[trial], source.offsets[trial + 1]
        table = source.events.table[first:last]
        if len(table) > 2 and table[-1, 0] - table[0, 0] <= LONGEST_S:
            yield table


def resampled(table: FloatArray, rate_hz: float) -> FloatArray:
    """A movement at another rate: positions between the recorded ones, counts that add up as recorded.

    Counts are NaN where the recording has none.
    """
    t = table[:, 0]
    times = np.arange(t[0], t[-1], 1.0 / rate_hz)
    new = np.empty((len(times), 6))
    new[:, 0] = times
    for column in (1, 2):
        new[:, column] = np.round(np.interp(times, t, table[:, column]), 2)
    for column in (3, 4):
        counts = np.cumsum(table[:, column])
        new[:, column] = np.diff(np.round(np.interp(times, t, counts)), prepend=0.0)
    new[:, 5] = table[np.searchsorted(t, times, side="right") - 1, 5]
    return new


@cache
def track(rate_hz: float, size: int) -> NDArray[np.void]:
    """Movements at ``rate_hz``, each a whole number of frames of ``size`` events."""
    parts, missing = [], SECONDS * rate_hz
    for table in tables():
        rows = resampled(table, rate_hz)
        if whole := len(rows) // size * size:
            parts.append(_packed(rows[:whole]))
            missing -= whole
        if missing <= 0:
            break
    return np.concatenate(parts)


def _packed(rows: FloatArray) -> NDArray[np.void]:
    events = np.zeros(len(rows), EVENTS)
    events["begin"][0] = 1
    for column, name in enumerate(("x", "y", "dx", "dy", "buttons"), 1):
        events[name] = np.nan_to_num(rows[:, column], nan=NO_COUNTS)
    texts = []
    for _, x, y, dx, dy, buttons in rows.tolist():
        counts = "null,null" if dx != dx or dy != dy else f"{dx:.0f},{dy:.0f}"
        texts.append(f",{x},{y},{counts},{buttons:.0f}]")
    events["text"] = texts
    events["text_size"] = [len(text) for text in texts]
    return events


SOURCES = Path(__file__).parent / "generator"
BUILD = ROOT / "build" / "load"
FLAGS = ("-std=c11", "-O2", "-Wall", "-Wextra")
TEXT = 1
Message = str | bytes


class Group(msgspec.Struct, frozen=True):
    """Clients that do the same.

    ``kind``: ``stream`` is a session of the service, ``echo`` a WebSocket and ``raw`` a TCP connection that
    sends everything back, ``script`` sends ``messages`` again and again and is not timed. ``rate`` frames a
    second and client, ``size`` events a frame. ``greeting``: the first messages of a session.
    """

    name: str
    port: int
    pids: tuple[int, ...] = ()
    kind: str = "stream"
    path: str = "/v1/stream"
    clients: int = 1
    rate: float = 1000.0
    size: int = 1
    json: bool = False
    greeting: tuple[Message, ...] = ()
    messages: tuple[Message, ...] = ()


class Plan(msgspec.Struct, frozen=True):
    """A run: an open loop of ``seconds`` after ``warm``, or ``rounds`` of turns of ``turn`` seconds each.

    ``drain``: how long to wait for the last answers; ``window``: the length of the parts of a run whose
    delay is reported.
    """

    groups: tuple[Group, ...]
    seconds: float = 3.0
    warm: float = 0.5
    drain: float = 5.0
    window: float = 1.0
    turn: float = 0.0
    rounds: int = 0


class Delays(msgspec.Struct, frozen=True):
    """Quantiles of a delay, ms."""

    count: int
    p50_ms: float
    p90_ms: float
    p99_ms: float
    p999_ms: float
    max_ms: float


class Window(msgspec.Struct, frozen=True):
    """Quantiles of the delay of the frames that were due in one part of a run."""

    p50_ms: float
    p99_ms: float


class Counts(msgspec.Struct, frozen=True):
    """What became of a group.

    ``sent`` and ``answered`` frames, ``answers`` the messages that answered them, ``unanswered`` frames that
    were due; ``measured`` frames answered while ``server_s``, the processor time of each process, was taken.
    ``texts`` counts other answers by their code or type, ``closes`` by the close code. ``late``: how late
    the generator itself was.
    """

    name: str
    sent: int
    answered: int
    answers: int
    repeated: int
    unanswered: int
    measured: int
    texts: dict[str, int]
    closes: dict[str, int]
    server_s: list[float]
    delay: Delays
    late: Delays
    windows: list[Window]
    turns_us: list[float]

    @property
    def server_us(self) -> float:
        """Processor time of the servers for each frame."""
        return sum(self.server_s) / max(self.measured, 1) * 1e6


class Run(msgspec.Struct, frozen=True):
    """What a run measured; ``own_share``: the generator's own share of a processor."""

    own_share: float
    groups: list[Counts]


@cache
def built() -> Path:
    """The generator, compiled where its source is newer; raises SystemExit without a compiler."""
    program = BUILD / "generator"
    sources = sorted(SOURCES.iterdir())
    newest = max(file.stat().st_mtime for file in sources)
    if program.exists() and program.stat().st_mtime > newest:
        return program
    compiler = shutil.which("cc")
    if compiler is None:
        raise SystemExit("the load generator needs a C compiler, 'cc': on Debian, apt install gcc libc6-dev")
    BUILD.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=BUILD) as folder:
        new = Path(folder) / "generator"
        files = [str(file) for file in sources if file.suffix == ".c"]
        subprocess.run([compiler, *FLAGS, "-o", str(new), *files, "-lm"], check=True)
        new.replace(program)
    return program


def packed(messages: Sequence[Message]) -> bytes:
    """Messages as the generator reads them: opcode, size, payload."""
    parts = []
    for message in messages:
        if isinstance(message, str):
            opcode, payload = TEXT, message.encode()
        else:
            opcode, payload = TEXT + 1, message
        parts += [bytes([opcode]), len(payload).to_bytes(4, "little"), payload]
    return b"".join(parts)


def words(plan: Plan, folder: Path) -> str:
    """A plan as the generator reads it; its messages and events become files in a folder."""
    numbers = {name: getattr(plan, name) for name in Plan.__struct_fields__ if name != "groups"}
    lines = [f"{name}={value}" for name, value in numbers.items()]
    for number, group in enumerate(plan.groups):
        of_group = {"group": group.name, "kind": group.kind, "port": group.port, "path": group.path}
        of_group |= {"clients": group.clients, "rate": group.rate, "json": int(group.json)}
        of_group |= {"pids": ",".join(map(str, group.pids))}
        for name in ("greeting", "messages"):
            if messages := getattr(group, name):
                file = folder / f"{name}{number}"
                file.write_bytes(packed(messages))
                of_group[name] = file
        if group.kind != "script":
            file = folder / f"events-{group.rate:g}-{group.size}"
            if not file.exists():
                file.write_bytes(track(group.rate * group.size, group.size).tobytes())
            of_group |= {"size": group.size, "events": file}
        lines += [f"{name}={value}" for name, value in of_group.items()]
    return "\n".join(lines)


def run(plan: Plan, cores: set[int]) -> Run:
    """Run a plan on some cores; raises CalledProcessError where a server does not do what it should."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "plan"
        file.write_text(words(plan, Path(folder)), encoding="utf-8")
        with on_cores(cores):
            result = subprocess.run([built(), file], check=True, stdout=subprocess.PIPE)
    return msgspec.json.decode(result.stdout, type=Run)


assert EVENTS.itemsize == 126, "struct event of generator/client.h"
