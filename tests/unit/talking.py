"""A session and somebody who talks with it: messages as dictionaries, binary frames as bytes."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from struct import Struct
from typing import Any

from pointpred.clock import Instant
from pointpred.protocol.server_messages import Limits
from pointpred_server.sessions.pointing import PointingSession

EVENT = Struct("<dddhhH")
PREDICTION = Struct("<dddddddBd")
NO_COUNTS = -32768
GOOD = [1e6, 1.0, 2.0, None, None, 0]
"""An event that comes later than all others of the tests."""

Row = Iterable[float | None]


def hello(predictor: str = "hold", **more: Any) -> dict[str, Any]:
    return {"type": "hello", "version": 1, "predictor": predictor, **more}


def events(*rows: Row) -> dict[str, Any]:
    return {"type": "events", "events": [list(row) for row in rows]}


def packed(*rows: Row) -> bytes:
    """Events as the contract packs them."""
    frame = b""
    for t, x, y, dx, dy, buttons in rows:
        counts = (NO_COUNTS if n is None or n != n else int(n) for n in (dx, dy))
        frame += EVENT.pack(t, x, y, *counts, int(buttons or 0))
    return frame


class Talk:
    """A client of a session, which has sent hello unless ``greet`` is False."""

    def __init__(self, *, greet: dict[str, Any] | bool | None = True, **limits: Any) -> None:
        self.session = PointingSession("name", Limits(**limits), Instant(0.0))
        if greet:
            self.say(hello() if greet is True else greet)

    def say(self, frame: dict[str, Any] | str | bytes, now: float = 0.0) -> list[Any]:
        """Send a frame and read every answer."""
        self.session.receive(json.dumps(frame) if isinstance(frame, dict) else frame, Instant(now))
        return self.hear()

    def feed(
        self, rows: Sequence[Row], form: Callable[..., Any] = events, size: int = 64, now: float = 0.0
    ) -> list[Any]:
        """Send events in frames of at most so many."""
        frames = [form(*rows[first : first + size]) for first in range(0, len(rows), size)]
        return [answer for frame in frames for answer in self.say(frame, now)]

    def hear(self) -> list[Any]:
        """What the session has to say."""
        return [one if isinstance(one, bytes) else json.loads(one) for one in self.session.outbox.take()]

    def error(self, frame: dict[str, Any] | str | bytes, now: float = 0.0) -> dict[str, Any]:
        """The one error that a frame gets, in the one shape that errors have."""
        (answer,) = self.say(frame, now)
        assert answer.keys() - {"field", "value"} == {"type", "code", "message", "path", "recoverable"}
        assert answer["type"] == "error"
        found: dict[str, Any] = answer
        return found

    def goes_on(self) -> bool:
        """Whether a good event still gets its prediction."""
        return [answer["t"] for answer in self.say(events(GOOD))] == [1e6]

    @property
    def closed(self) -> int | None:
        return self.session.close.code if self.session.close else None
