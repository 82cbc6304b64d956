"""The messages of ``/v1/live``: what is said of the device attached to this machine."""

from __future__ import annotations

from typing import Any, Literal

import msgspec
from msgspec import Struct

from pointpred.server.messages import Bye, ErrorMessage, Events, PredictionMessage


class Attached(Struct, tag="device"):
    """First message: the device, which clock stamps it, what its positions are, and what predicts.

    ``space``: ``screen`` the cursor, ``transfer`` where a transfer function puts it, ``motor`` the hand's own
    way; ``words`` says the same for people. ``cpi`` counts per inch, null where nobody knows it.
    """

    name: str
    clock: str
    space: Literal["screen", "transfer", "motor"]
    words: str
    predictor: str
    cpi: float | None = None
    dpi: float = 96.0


class Status(Struct, tag="status"):
    """How the reading goes, once a second.

    ``lost`` reports nobody took in time, ``unreadable`` ones that could not be decoded, ``resynchronised``
    recoveries after the kernel dropped events, ``refused`` events the pipeline did not take; delays from a
    report to its prediction, null where the stamps are of another clock.
    """

    plugged: bool
    reports: int
    rate_hz: float
    lost: int = 0
    unreadable: int = 0
    resynchronised: int = 0
    refused: int = 0
    delay_p50_s: float | None = None
    delay_p99_s: float | None = None


class Curve(Struct, tag="transfer"):
    """The transfer function as identified so far: gains at speeds of the hand in m/s, and what they rest on.

    ``low`` and ``high`` bound the speeds that were seen; beyond them the curve is a guess. Empty, with
    ``reason``, while the data do not tell a function. ``constant`` and ``sigmoid``: the same data explained
    by those two, gains at the same speeds.
    """

    speeds: list[float] = []
    gains: list[float] = []
    low: float | None = None
    high: float | None = None
    samples: int = 0
    reason: str | None = None
    constant: list[float] = []
    sigmoid: list[float] = []


LiveMessage = Attached | Events | PredictionMessage | Status | Curve | ErrorMessage | Bye
"""What a viewer hears; ``events`` in the shape that clients of ``/v1/stream`` send."""


def live_schemas() -> dict[str, Any]:
    """The components of the messages as JSON schemas."""
    _, components = msgspec.json.schema_components([LiveMessage], ref_template="#/components/schemas/{name}")
    return components
