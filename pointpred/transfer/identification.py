"""Identifying an unknown transfer function as a polynomial, thesis section 2.5.1."""

from __future__ import annotations

from math import inf
from typing import Any, Literal

import msgspec
import numpy as np

from pointpred.columns import EventColumns
from pointpred.errors import EventError, ParameterError
from pointpred.events import METRES_PER_INCH, PointerEvent
from pointpred.parameter import Parameter, check
from pointpred.regression.recursive_least_squares import fit
from pointpred.stage import CompiledStage
from pointpred.transfer import bands, windows
from pointpred.transfer.known import COEFFICIENTS_MOST
from pointpred.transfer.polynomial import PolynomialFunction

NONE = float("nan")


class Identification(msgspec.Struct, frozen=True):
    """A transfer function and what it rests on.

    ``function`` is ``None`` where the data do not tell all powers apart, or hold no speed of the judged
    range; ``unexcited`` lists the powers that add nothing to those before them, ``condition`` is that of the
    data with columns of equal length. ``samples`` were used, ``skipped`` reports had no time before them that
    could be believed; ``residual`` is the root mean square error of a sample (m for windows, m/s for speeds).
    """

    function: PolynomialFunction | None
    unexcited: tuple[int, ...]
    condition: float
    residual: float
    samples: int
    skipped: int


class PolynomialIdentifier(CompiledStage):
    """Reports of a device with the cursor's positions in, a polynomial transfer function out.

    Assumes that the cursor is free: at the screen's edge, or moved by anything else, it misleads. Reports
    must carry counts. Small corners of the function are rounded; gains far outside the speeds seen are noise.

    V_c = sum c_i V_m^i by recursive least squares with forgetting. ``update`` learns displacements over short
    windows, which whole pixels cannot bias; ``learn`` takes pairs of speeds as in the thesis, from Euler
    differences or from a differentiator (``pointpred.transfer.speeds``).

    Parameters: ``order`` q in 1 ... 6; ``offset`` allows c_0; ``cpi`` and ``dpi``; ``window_s`` in s;
    ``gap_s``, a longer pause makes a report's speed unknown; ``forgetting`` in (0, 1] for each sample;
    ``speed_low``, ``speed_high`` in m/s, the range that is judged; ``least_excitation`` the sine below which
    a power counts as not excited.
    Memory: 267 floats. Raises ParameterError, and EventError from ``update``.

    Reference: Khalin 2022, sections 2.4.1 and 2.5.1, with the cursor's speed corrected.

    >>> from pointpred.transfer import ConstantGain
    >>> identifier = PolynomialIdentifier(order=2)
    >>> for speed in (0.05, 0.1, 0.2):
    ...     identifier.learn(speed, 4.0 * speed)
    >>> round(float(identifier.identify().function.gain(0.15)), 6)
    4.0
    """

    parameters = (
        Parameter("order", "", 1, COEFFICIENTS_MOST - 1, "highest power of the speed"),
        Parameter("cpi", "counts per inch", 1.0, 1e6, "resolution of the device"),
        Parameter("dpi", "px per inch", 1.0, 1e5, "resolution of the screen"),
        Parameter("window_s", "s", 1e-4, 1.0, "displacements are learnt over windows of this length"),
        Parameter("gap_s", "s", 1e-3, 1e3, "after a longer pause a report's speed is unknown"),
        Parameter("forgetting", "", 1e-6, 1.0, "factor on the weight of the past at each sample"),
        Parameter("speed_low", "m/s", 0.0, 1e2, "lowest speed that is judged"),
        Parameter("speed_high", "m/s", 1e-3, 1e2, "highest speed that is judged"),
        Parameter("least_excitation", "", 1e-14, 1.0, "sine below which a power is not excited"),
    )
    width = 1
    loop = staticmethod(windows.loop)

    def __init__(
        self,
        *,
        order: int = 5,
        offset: bool = False,
        cpi: float = 2000.0,
        dpi: float = 96.0,
        window_s: float = 0.005,
        gap_s: float = 0.1,
        forgetting: float = 1.0,
        speed_low: float = 0.0127,
        speed_high: float = 0.31,
        least_excitation: float = 1e-4,
    ) -> None:
        values: dict[str, Any] = {"order": order, "cpi": cpi, "dpi": dpi, "window_s": window_s}
        values |= {"gap_s": gap_s, "forgetting": forgetting, "speed_low": speed_low}
        check(self.parameters, values | {"speed_high": speed_high, "least_excitation": least_excitation})
        if order != int(order):
            raise ParameterError(f"order must be a whole number, received {order!r}")
        if speed_low >= speed_high:
            raise ParameterError(
                f"speed_low must lie below speed_high = {speed_high!r} m/s, received {speed_low!r} m/s"
            )
        self.offset, self.count, self.least = offset, int(order) + (1 if offset else 0), least_excitation
        self.speed_low, self.band_width = speed_low, (speed_high - speed_low) / bands.BANDS
        metres = [METRES_PER_INCH / cpi, METRES_PER_INCH / dpi]
        first = [float(self.count), 0.0 if offset else 1.0, *metres]
        self.lay_out([*first, window_s, gap_s, forgetting, self.speed_low, self.band_width], windows.STATES)

    def update(self, event: PointerEvent, /) -> None:
        """Consume one report with counts and the cursor's position after it.

        Raises EventError for an event without counts, with a value that is not finite, or before the last
        one; nothing is then changed.
        """
        dx, dy = (NONE if d is None else d for d in (event.dx, event.dy))
        if windows.step(self._memory, event.t, event.x, event.y, dx, dy) == windows.REFUSED:
            raise EventError(f"event needs counts, finite values and a time in order, received {event!r}")

    def run(self, events: EventColumns) -> None:
        """Consume a table of reports; a row marked ``begin`` starts a new trial. Raises EventError."""
        kept = self._memory.copy()
        refused = self.walk(events.begin, events.table)[:, 0] == windows.REFUSED
        if refused.any():
            self._memory = kept
            raise EventError(
                f"row {int(refused.argmax())}: event needs counts, finite values and a time in order"
            )

    def learn(self, speed_m_s: float, cursor_speed_m_s: float) -> None:
        """Consume one pair (V_m, V_c); raises EventError for a speed that is not finite and >= 0."""
        if not (0.0 <= speed_m_s < inf and 0.0 <= cursor_speed_m_s < inf):
            raise EventError(
                f"speeds must lie in [0, inf) m/s, received {speed_m_s!r} and {cursor_speed_m_s!r}"
            )
        windows.learn_speeds(self._memory, speed_m_s, cursor_speed_m_s)

    def identify(self, weighting: Literal["samples", "gain"] = "gain") -> Identification:
        """The function now.

        ``"samples"`` is the thesis's recursion: every sample counts alike, so the errors are small where most
        samples lie. ``"gain"`` weighs bands of speed so that the largest relative error of the gain is small;
        with fewer bands than coefficients it falls back on the samples.
        """
        found = fit(self._memory, windows.SOLVER, self.count, self.least)
        shift = 0 if self.offset else 1
        linear = 1 - shift
        skipped = int(self._memory[windows.SKIPPED])
        powers = tuple(j + shift for j in found.unexcited)
        numbers, rows, trust = bands.trusted(self._memory, windows.BANDS, self.count, linear, found.residual)
        function = None
        if found.values is not None and len(numbers):
            values = np.array(found.values)
            if weighting == "gain" and len(rows) > self.count:
                values = bands.balance(rows, trust)
            seen = numbers[trust > 0.5] if (trust > 0.5).any() else numbers
            low, high = (self.speed_low + self.band_width * (float(seen[i]) + (i < 0)) for i in (0, -1))
            function = PolynomialFunction([0.0] * shift + values.tolist(), speed_low=low, speed_high=high)
        return Identification(function, powers, found.condition, found.residual, found.samples, skipped)
