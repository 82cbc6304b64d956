"""Recorded sessions: files of frames in their order, played again, and how answers are compared.

A file has an object a line: what the file is, then ``client`` or ``server`` with a text, or with packed
records as base64 in a list of one; at the end ``close`` with the code.
"""

from __future__ import annotations

import base64
import json
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection

from pointpred.protocol.frames import PREDICTION, unpack_predictions

FOLDER = Path(__file__).parent / "sessions"
NEAR = 1e-9
"""Allowed difference, relative, and absolute for numbers near 0: other processors round otherwise."""
TEXTS = {"session": r"[0-9a-f]{16}", "message": r"(?s).+", "person": r"(1\..+)?", "reason": r".*"}
"""Fields whose text may be another one, with what it must look like."""

Frame = str | bytes


@dataclass
class Step:
    """A frame of the client, and the frames that answered it before the next one was sent."""

    sent: Frame
    answers: list[Frame]


@dataclass
class Exchange:
    """A whole session. ``numbers``: whether today's predictions have the same numbers."""

    about: str
    steps: list[Step]
    close: int | None
    numbers: bool = True

    @property
    def version(self) -> int:
        """Of the wire, as the first hello that has one says."""
        sent = [json.loads(step.sent) for step in self.steps if str(step.sent).startswith('{"type":"hello"')]
        return int(sent[0]["version"])


def read(path: Path) -> Exchange:
    """The session of a file."""
    first, *lines = (json.loads(line) for line in path.read_text(encoding="utf-8").splitlines())
    exchange = Exchange(first["about"], [], None, first["numbers"])
    for line in lines:
        ((kind, content),) = line.items()
        if kind == "close":
            exchange.close = content
        elif kind == "client":
            exchange.steps.append(Step(_frame(content), []))
        else:
            exchange.steps[-1].answers.append(_frame(content))
    return exchange


def write(exchange: Exchange, path: Path) -> None:
    """Write a session as a file."""
    lines: list[dict[str, Any]] = [{"about": exchange.about, "numbers": exchange.numbers}]
    for step in exchange.steps:
        lines.append({"client": _content(step.sent)})
        lines += [{"server": _content(frame)} for frame in step.answers]
    lines += [] if exchange.close is None else [{"close": exchange.close}]
    text = "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines)
    path.write_text(text, encoding="utf-8")


def persons(path: Path) -> list[str]:
    """The persons that a recorded session answered, but for the one that nobody knows."""
    texts = [answer for step in read(path).steps for answer in step.answers if isinstance(answer, str)]
    messages = [json.loads(text) for text in texts]
    return [
        message["person"] for message in messages if message.get("type") == "person" and message["person"]
    ]


def play(
    exchange: Exchange, socket: ClientConnection, patience_s: float
) -> Iterator[tuple[str, Frame, Frame]]:
    """Send every frame again; yields the place, each recorded answer and the one that came.

    Each frame is sent after the answers to the last one, so that no answer depends on the delay.
    """
    known = {_type_of(answer) for step in exchange.steps for answer in step.answers} | {"error"}
    for number, step in enumerate(exchange.steps):
        socket.send(step.sent)
        for place, recorded in enumerate(step.answers):
            answer = socket.recv(patience_s)
            while _type_of(answer) not in known:  # a client ignores what it does not know
                answer = socket.recv(patience_s)
            yield f"frame {number}, answer {place}", recorded, answer
    if exchange.close is not None:
        with pytest.raises(ConnectionClosed) as closed:
            socket.recv(patience_s)
        assert closed.value.rcvd is not None, "the connection was lost"
        assert closed.value.rcvd.code == exchange.close


def _rows(frame: bytes, version: int) -> list[list[float]]:
    """The numbers of each record, the place of its target last."""
    rows, places = unpack_predictions(frame, version)
    return [[*row, place] for row, place in zip(rows, places, strict=True)]


def _type_of(frame: Frame) -> str:
    return "packed" if isinstance(frame, bytes) else str(json.loads(frame)["type"])


def differences(recorded: Frame, answer: Frame, version: int, *, numbers: bool) -> list[str]:
    """What a client of the recorded version would stumble over; further fields are no difference."""
    if isinstance(recorded, str) and isinstance(answer, str):
        return list(_different(json.loads(recorded), json.loads(answer), "$", numbers))
    if isinstance(recorded, str) or isinstance(answer, str):
        return [f"expected {type(recorded).__name__}, received {type(answer).__name__}"]
    if len(recorded) != len(answer) or len(answer) % PREDICTION[version].itemsize:
        return [f"expected {len(recorded)} bytes, received {len(answer)}"]
    rows = zip(*(_rows(frame, version) for frame in (recorded, answer)), strict=True)
    return [
        f"row {row}, number {place}: expected {before!r}, received {now!r}"
        for row, pair in enumerate(rows)
        for place, (before, now) in enumerate(zip(*pair, strict=True))
        if not _near(before, now, numbers=numbers or place == 0)
    ]


def _different(recorded: Any, answer: Any, path: str, numbers: bool) -> Iterator[str]:
    if isinstance(recorded, dict) and isinstance(answer, dict):
        for name, value in recorded.items():
            place = f"{path}.{name}"
            if name not in answer:
                yield f"{place} is missing"
            elif name in TEXTS and isinstance(value, str):
                if not isinstance(answer[name], str) or not re.fullmatch(TEXTS[name], answer[name]):
                    yield f"{place}: expected {TEXTS[name]}, received {answer[name]!r}"
            else:
                yield from _different(value, answer[name], place, numbers and name != "limits")
    elif isinstance(recorded, list) and isinstance(answer, list):
        if len(recorded) != len(answer):
            yield f"{path}: expected {len(recorded)} items, received {len(answer)}"
        for place, (before, now) in enumerate(zip(recorded, answer, strict=False)):
            yield from _different(before, now, f"{path}[{place}]", numbers)
    elif _is_number(recorded) and _is_number(answer):
        if not _near(recorded, answer, numbers=numbers or path == "$.t"):
            yield f"{path}: expected {recorded!r}, received {answer!r}"
    elif recorded != answer or type(recorded) is not type(answer):
        yield f"{path}: expected {recorded!r}, received {answer!r}"


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _near(before: float, now: float, *, numbers: bool) -> bool:
    """Whether two numbers are equal within ``NEAR``, or just both there where ``numbers`` is false."""
    if math.isnan(before) or math.isnan(now):
        return math.isnan(before) == math.isnan(now)
    return not numbers or math.isclose(before, now, rel_tol=NEAR, abs_tol=NEAR)


def _frame(content: str | list[str]) -> Frame:
    return content if isinstance(content, str) else base64.b64decode(content[0])


def _content(frame: Frame) -> str | list[str]:
    return frame if isinstance(frame, str) else [base64.b64encode(frame).decode()]
