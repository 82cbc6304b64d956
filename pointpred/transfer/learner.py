"""The transfer function, learnt while a person works."""

from __future__ import annotations

from copy import copy
from math import hypot, inf, nan
from threading import Lock
from typing import Any, Self

from pointpred.errors import EventError, ParameterError
from pointpred.records import LARGEST, LATEST_S, METRES_PER_INCH, PointerEvent
from pointpred.transfer.bands import BANDS, Bands
from pointpred.transfer.curve import GainCurve, curve_of
from pointpred.transfer.identification import Identification, PolynomialIdentifier

FORGETTING = 1.0 - 2e-5
"""Half-life of the samples: three minutes of motion; of a band of speed: an hour spread over all bands."""
SPACING_S, SPACING_MOST_S = 0.0005, 0.1
TOO_FAST = 1.5
WINDOW_S = 0.01
"""Longer than for simulated reports, because a real cursor follows its counts with a varying delay."""


class TransferLearner:
    """Pointer events with counts and the screen's cursor in; the system's transfer function out.

    Assumes that only this device moves the cursor; motion by a program or a second mouse counts as gain. At
    the screen's edge the cursor stops and the hand does not: with ``size`` those events are left out and
    counted. Does not extrapolate beyond the measured speeds.

    The law is that of ``PolynomialIdentifier``: V_c = sum c_i V_m^i by recursive least squares over windows,
    with forgetting, bands of speed weighed so that the largest relative error of the gain is small. Reports
    within ``spacing_s`` count as one: reports queued for their reader have stamps too close to divide by.
    Events faster than 1.5 ``speed_high`` are left out and counted in ``fast``: they are outside the range of
    the fit, and their powers would outweigh all others.

    Parameters: ``size`` of the screen in px; ``forgetting`` for each window and axis; ``window_s`` in s,
    longer than the variation of the cursor's delay; ``spacing_s`` in [0, 0.1] s; the others, ``cpi`` and
    ``dpi`` first, as for ``PolynomialIdentifier``. One thread may read while another updates.
    Memory: 267 floats and one event. Raises ParameterError, and EventError from ``update``.
    Reference: Khalin 2022, sections 2.4.1 and 2.5.1, with the cursor's speed corrected.

    >>> learner = TransferLearner(cpi=1000.0, dpi=100.0)
    >>> for i in range(1, 4000):
    ...     path = i * i // 1000
    ...     learner.update(PointerEvent(0.001 * i, 0.4 * path, 0.0, path - (i - 1) ** 2 // 1000, 0.0))
    >>> curve = learner.curve()
    >>> round(curve.gains[20], 2), curve.closest
    (4.0, 'constant')
    """

    def __init__(
        self,
        *,
        size: tuple[int, int] | None = None,
        forgetting: float = FORGETTING,
        window_s: float = WINDOW_S,
        spacing_s: float = SPACING_S,
        **settings: Any,
    ) -> None:
        if not 0.0 <= spacing_s <= SPACING_MOST_S:
            raise ParameterError(
                f"spacing_s must lie in [0, {SPACING_MOST_S:g}] s, received {spacing_s!r}",
                field="spacing_s",
                value=spacing_s,
            )
        self.size, self.spacing_s, self.edges, self.fast = size, spacing_s, 0, 0
        self._settings: dict[str, Any] = {"forgetting": forgetting, "window_s": window_s, **settings}
        self._identifier = PolynomialIdentifier(**self._settings)
        self._lock = Lock()
        self._waiting: PointerEvent | None = None
        self._since = self._last = -inf
        high = self._identifier.speed_low + BANDS * self._identifier.band_width
        self._counts_a_second = TOO_FAST * high / (METRES_PER_INCH / self._identifier.cpi)

    def update(self, event: PointerEvent, /) -> None:
        """Learn from one event.

        Raises EventError for one without counts, with a value that is not finite, or before the last one; the
        learner is then unchanged.
        """
        with self._lock:
            dx, dy = (nan if d is None else d for d in (event.dx, event.dy))
            fine = abs(event.t) <= LATEST_S and abs(event.x) + abs(event.y) + abs(dx) + abs(dy) <= LARGEST
            if not fine or event.t < self._last:
                raise EventError(
                    f"event needs counts, finite values and a time not before {self._last!r} s, "
                    f"received {event!r}",
                    value=event,
                )
            self._last = event.t
            if self._waiting is not None and event.t - self._since < self.spacing_s:
                dx, dy = dx + (self._waiting.dx or 0.0), dy + (self._waiting.dy or 0.0)
            else:
                self._pass_on()
                self._since = event.t
            self._waiting = PointerEvent(event.t, event.x, event.y, dx, dy)

    def reset(self) -> None:
        """Start a new movement: no speed spans both. Keeps everything learnt."""
        with self._lock:
            self._begin()

    def forget(self) -> None:
        """Forget everything learnt."""
        with self._lock:
            self._begin()
            self._identifier.reset()
            self.edges = self.fast = 0

    def fresh(self) -> Self:
        """A learner with the same parameters and no data."""
        return type(self)(size=self.size, spacing_s=self.spacing_s, **self._settings)

    def identify(self) -> Identification:
        """The current function, with the data behind it.

        Bands are weighed by their relative error once enough of them are accurate; before, all windows have
        equal weight, since weighing would follow the noise.
        """
        return self._identified()[0]

    def curve(self) -> GainCurve:
        """The current function as plain lists, with its excited range, a constant gain and a sigmoid."""
        identification, bands = self._identified()
        return curve_of(identification, bands, self.edges, self.fast)

    def _identified(self) -> tuple[Identification, Bands]:
        """The identification and the bands behind it, from a copy."""
        with self._lock:
            identifier = copy(self._identifier)
        identification = identifier.identify()
        bands = identifier.measured(identification.residual)
        if (bands.trust > 0.5).sum() <= identifier.count:
            identification = identifier.identify("samples")
        return identification, bands

    def _pass_on(self) -> None:
        """Let the law learn from the pending report, or leave it out and count it."""
        event, self._waiting = self._waiting, None
        if event is None:
            return
        path = hypot(event.dx or 0.0, event.dy or 0.0)
        last_t = self._identifier.last_t
        h = inf if last_t is None else event.t - last_t
        if self._at_edge(event):
            self._identifier.begin()
            self.edges += 1
        elif path > LARGEST / 4.0 or (0.0 < h <= self._identifier.gap_s and path > h * self._counts_a_second):
            self._identifier.begin()
            self.fast += 1
        else:
            self._identifier.update(event)

    def _begin(self) -> None:
        """Process the pending report and forget the last one."""
        self._pass_on()
        self._identifier.begin()
        self._last = -inf

    def _at_edge(self, event: PointerEvent) -> bool:
        """Whether the screen's edge may have stopped the cursor there."""
        if self.size is None:
            return False
        width, height = self.size
        return not (0.0 < event.x < width - 1.0 and 0.0 < event.y < height - 1.0)
