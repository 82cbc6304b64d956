"""The records that flow through pointpred: an event in, a motion between, a prediction out.

Positions are screen pixels (y grows downwards), time is seconds on any clock that does not run backwards,
motor quantities are metres and seconds. Zero is data everywhere; only ``None`` means "not there".
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import msgspec

from pointpred.regions import Region, probability, region_of

Phase = Literal["still", "ballistic", "corrective"]
PHASES: tuple[Phase, ...] = ("still", "ballistic", "corrective")
"""Phases in the order of their codes in columns and binary frames."""

LATEST_S = 1e11
"""Bound on the magnitude of a time: seconds of any clock fit, milliseconds since 1970 are a mistaken unit."""
LARGEST = 1e9
"""Bound on the magnitude of positions (px), counts and buttons: beyond it arithmetic means nothing."""
NORMAL = float("nan")
"""The tail of a normal law in columns, frames and laws; records say ``None``."""
METRES_PER_INCH = 0.0254
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

    ``scale`` = (sxx, sxy, syy) px^2, the scale matrix of the endpoint's law, or ``None`` where the predictor
    claims no region. ``tail``: degrees of freedom of that law, a bivariate Student law; ``None``: the law is
    normal, and ``scale`` its covariance. ``phase`` of the movement at ``t``. ``remaining_s`` until arrival,
    or ``None``.
    ``remaining_spread``: standard deviation of the logarithm of the remaining time; ``None``: not claimed.
    """

    t: float
    x: float
    y: float
    scale: tuple[float, float, float] | None
    phase: Phase
    remaining_s: float | None
    tail: float | None = None
    remaining_spread: float | None = None

    @property
    def covariance(self) -> tuple[float, float, float] | None:
        """(sxx, sxy, syy) px^2 of the endpoint, or ``None`` where no region is claimed.

        That of a Student law is ``scale`` tail / (tail - 2); with a tail up to 2 it has none.
        """
        if self.scale is None or self.tail is None:
            return self.scale
        if not self.tail > 2.0:
            return None
        wider = 1.0 / (1.0 - 2.0 / self.tail)
        sxx, sxy, syy = self.scale
        return wider * sxx, wider * sxy, wider * syy

    def region(self, level: float) -> Region | None:
        """The ellipse that holds the endpoint with probability ``level``, as the prediction claims.

        ``None`` where no region is claimed, the scale matrix has no inside, or the ellipse is too large for a
        finite number. Raises ParameterError for a level outside (0, 1).

        >>> prediction = Prediction(0.0, 300.0, 200.0, (400.0, 0.0, 100.0), "ballistic", None)
        >>> region = prediction.region(0.5)
        >>> round(region.major, 3), round(region.minor, 3), region.angle
        (23.548, 11.774, 0.0)
        """
        level = probability(level)
        if self.scale is None:
            return None
        return region_of(level, self.x, self.y, *self.scale, NORMAL if self.tail is None else self.tail)


class Place(NamedTuple):
    """Where movements of this person ended before: ``x y`` px, as the destination of the present movement.

    ``p``: how likely it is now, ``before``: how likely it was before the movement showed anything; both
    beside the other places and beside everywhere else, so that they sum to less than 1. ``visits``: how many
    movements ended there, earlier ones counting less; at most 33.4. ``id``: from 0 to 63, the same as long as
    the place is remembered, also in a saved person; a place that replaces a forgotten one takes its id.
    ``spread`` px: the standard deviation of visits around the place, as this person's scatter grows with the
    distance from where the movement starts.
    """

    x: float
    y: float
    p: float
    before: float
    visits: float
    id: int
    spread: float


Pair = tuple[PointerEvent, Prediction | None]
"""An event and what is predicted at it; ``None`` where nothing is justified."""
