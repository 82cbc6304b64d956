"""What a script gives the client: an address, a token, events as records or rows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from urllib.parse import urlsplit, urlunsplit

import numpy as np

from pointpred.columns import EventColumns
from pointpred.errors import EventError, ParameterError
from pointpred.events import PointerEvent
from pointpred.protocol.records import NONE

Row = Sequence[float | None]
"""t, x, y and then, where they are known, dx, dy, buttons."""


def address(url: str) -> str:
    """The stream's address: ``http`` becomes ``ws``, a bare address gets the usual path.

    >>> address("http://127.0.0.1:8765/")
    'ws://127.0.0.1:8765/v1/stream'
    """
    parts = urlsplit(url)
    scheme = {"http": "ws", "https": "wss"}.get(parts.scheme, parts.scheme)
    if scheme not in ("ws", "wss") or not parts.netloc:
        raise ParameterError(f"the address must be ws://HOST:PORT or http://HOST:PORT, received {url!r}")
    path = parts.path if parts.path not in ("", "/") else "/v1/stream"
    return urlunsplit((scheme, parts.netloc, path, parts.query, ""))


def authorization(token: str | None) -> dict[str, str]:
    """The header that shows a token."""
    return {} if token is None else {"Authorization": f"Bearer {token}"}


def columns_of(events: EventColumns | Iterable[PointerEvent | Row]) -> EventColumns:
    """Events as a table, from records or from rows; raises EventError."""
    if isinstance(events, EventColumns):
        return events
    table = [_numbers(event) for event in events]
    return EventColumns(np.array(table, dtype=np.float64).reshape(-1, 6))


def _numbers(event: PointerEvent | Row) -> list[float]:
    if isinstance(event, PointerEvent):
        row: Row = (event.t, event.x, event.y, event.dx, event.dy, event.buttons)
    elif 3 <= len(event) <= 6:
        row = (*event, *(None, None, 0)[len(event) - 3 :])
    else:
        raise EventError(f"an event is t, x, y[, dx, dy, buttons], received {len(event)} values")
    return [NONE if value is None else float(value) for value in row]
