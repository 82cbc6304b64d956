"""The messages of ``/v1/live``: what the server sends about the device attached to this machine."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from pointpred.protocol.client_messages import Bye, Events
from pointpred.protocol.server_messages import ErrorMessage, PredictionMessage
from pointpred.transfer import GainCurve


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
    report to its prediction, null where the stamps are of another clock. ``note``: what a person should know
    of the device now, such as that nothing moves and what to try; null where there is nothing to say.
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
    note: str | None = None


class Curve(Struct, tag="transfer"):
    """The system's transfer function as learnt so far: why there is no curve, or what the curve rests on.

    Speeds are the hand's in m/s; ``excited`` is the range that the person has shown, beyond it nothing is
    known. ``compared``: simpler functions on the same measurements, ``closest`` the simplest that fits.
    """

    words: str
    curve: GainCurve | None = None


LIVE_MESSAGES = (Attached, Events, PredictionMessage, Status, Curve, ErrorMessage, Bye)
"""What the server sends to a viewer; ``events`` in the shape that clients of ``/v1/stream`` send."""
