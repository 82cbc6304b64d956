"""The records that flow through pointpred: an event in, a motion between, a prediction out.

Positions are screen pixels (y grows downwards), time is seconds on any clock that does not run backwards,
motor quantities are metres and seconds. Zero is data everywhere; only ``None`` means "not there".
"""

from __future__ import annotations

from typing import Literal

import msgspec

Phase = Literal["still", "ballistic", "corrective"]
PHASES: tuple[Phase, ...] = ("still", "ballistic", "corrective")
"""Phases in the order of their codes in columns and binary frames."""

LATEST_S = 1e11
"""Bound on the magnitude of a time: seconds of any clock fit, milliseconds since 1970 are a mistaken unit."""
LARGEST = 1e9
"""Bound on the magnitude of positions (px), counts and buttons: beyond it arithmetic means nothing."""
CPI, DPI = (1.0, 1e6), (1.0, 1e5)
"""Bounds on the counts per inch of a device and the pixels per inch of a screen."""
ROUNDING_S = 1e-6
"""Spans of time that differ by less are compared as equal: no rule may hang on how a clock is rounded."""


class PointerEvent(msgspec.Struct, frozen=True):
    """One report of a pointing device.

    ``t`` s; ``x`` and ``y`` cursor position in px; ``dx`` and ``dy`` device counts since the previous event,
    ``None`` where the source has none; ``buttons`` pressed, as in W3C pointer events (bit 0: primary).
    """

    t: float
    x: float
    y: float
    dx: float | None = None
    dy: float | None = None
    buttons: int = 0


class Motion(msgspec.Struct, frozen=True):
    """What a differentiator knows after an event.

    ``x`` and ``y`` cursor px; ``vx vy`` m/s and ``ax ay`` m/s^2 of the hand; ``settled`` once the estimate
    has seen enough samples since its last restart; ``start`` when a movement starts at this sample;
    ``counts`` when the motor motion comes from device counts rather than from the cursor.
    """

    t: float
    x: float
    y: float
    vx: float
    vy: float
    ax: float
    ay: float
    settled: bool
    start: bool = False
    counts: bool = False


class Prediction(msgspec.Struct, frozen=True):
    """Where a movement will end: ``x y`` px, seen from time ``t`` s.

    ``covariance`` = (sxx, sxy, syy) px^2 or ``None`` where the predictor claims no region; ``phase`` of the
    movement at ``t``; ``remaining_s`` until arrival, or ``None``. ``tail``: degrees of freedom of the
    bivariate Student law whose scale matrix ``covariance`` then is; ``None``: the law is normal.
    ``remaining_spread``: standard deviation of the logarithm of the remaining time; ``None``: not claimed.
    """

    t: float
    x: float
    y: float
    covariance: tuple[float, float, float] | None
    phase: Phase
    remaining_s: float | None
    tail: float | None = None
    remaining_spread: float | None = None
