"""Identifying an unknown transfer function as a polynomial, thesis section 2.5.1.

A cursor moves in whole pixels, so its speed between two reports at 1 kHz is mostly rounding, and the length
of a rounded step is biased. Reports are therefore combined into short windows: over one, the displacement of
an axis is sum of h (V_x / V) PTF(V) = sum_i c_i (sum of h V_x V^(i-1)): linear in c, with an error of at most
a pixel.
"""

from __future__ import annotations

from math import hypot, inf, nan
from typing import Any, Literal, Protocol

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.errors import EventError, ParameterError
from pointpred.parameter import option, parameter
from pointpred.records import (
    CPI,
    DPI,
    LARGEST,
    LATEST_S,
    METRES_PER_INCH,
    ROUNDING_S,
    EventColumns,
    EventRow,
    FloatArray,
    FloatTable,
    MotionColumns,
    PointerEvent,
    SixFloats,
)
from pointpred.regression import least_squares
from pointpred.regression.least_squares import fit
from pointpred.stage import CompiledStage, loop_of, offsets
from pointpred.transfer import bands
from pointpred.transfer.functions import COEFFICIENTS_MOST, PolynomialFunction

# Parameters: number of coefficients, the power of the first (0 or 1), ... Learned: reports left out, the
# regression, the bands, scratch space for a row. The movement: the last report, counts pending until time
# passes, the start of the window, the hand's way and time in it, its rows of both axes.
N, POWER, METRES_PER_COUNT, METRES_PER_PX, WINDOW_S, GAP_S, FORGETTING, SPEED_LOW, BAND_WIDTH, LEARNED = (
    range(10)
)
(
    _,
    SKIPPED,
    SUMS,
    NUMBERS,
    BANDS,
    ROW,
    STARTED,
    T,
    X,
    Y,
    WAITING_X,
    WAITING_Y,
    START_X,
    START_Y,
    PATH,
    DURATION,
    ROW_X,
    ROW_Y,
    END,
) = offsets(
    LEARNED,
    1,
    least_squares.Sums.length,
    least_squares.numbers(COEFFICIENTS_MOST),
    bands.states(COEFFICIENTS_MOST),
    COEFFICIENTS_MOST,
    *[1] * 10,
    COEFFICIENTS_MOST,
    COEFFICIENTS_MOST,
)

REFUSED, TAKEN, LEFT_OUT = -1.0, 0.0, 1.0


@law
def learn(memory: FloatArray, row: int, output: float, speed: float) -> None:
    """Add output = row . c at a speed of the hand to the recursion and to its band."""
    n = int(memory[N])
    regression = least_squares.parts(memory[NUMBERS:BANDS], n)
    for j in range(n):
        regression.w[j] = memory[row + j]
    least_squares.advance(least_squares.Sums(memory, SUMS), regression, memory[FORGETTING], output)
    band = (speed - memory[SPEED_LOW]) / memory[BAND_WIDTH]
    model = bands.Model(n, 1 - int(memory[POWER]), memory[FORGETTING])
    bands.learn(memory, BANDS, model, band, row, output)


@law
def learn_speeds(memory: FloatArray, speed: float, cursor_speed: float) -> None:
    """Add one pair of speeds in m/s, as in section 2.5.1: the regressor consists of powers of V."""
    value = 1.0 if memory[POWER] == 0.0 else speed
    for j in range(int(memory[N])):
        memory[ROW + j] = value
        value *= speed
    learn(memory, ROW, cursor_speed, speed)


@law
def open_window(memory: FloatArray) -> None:
    """Start a window at the last report."""
    memory[START_X], memory[START_Y] = memory[X], memory[Y]
    memory[PATH] = 0.0
    memory[DURATION] = 0.0
    memory[ROW_X:END] = 0.0


@law
def gather(memory: FloatArray, dt: float, dx: float, dy: float) -> None:
    """Add one report's path to the rows of both axes."""
    u, v = dx * memory[METRES_PER_COUNT], dy * memory[METRES_PER_COUNT]
    path = hypot(u, v)
    memory[PATH] += path
    memory[DURATION] += dt
    if path == 0.0:
        return
    speed = path / dt
    factor = 1.0 / speed if memory[POWER] == 0.0 else 1.0
    for j in range(int(memory[N])):
        memory[ROW_X + j] += u * factor
        memory[ROW_Y + j] += v * factor
        factor *= speed


@law
def step(memory: FloatArray, event: SixFloats) -> tuple[float]:
    """One report of the device with the cursor's position after it: refused, taken or left out."""
    t, x, y, dx, dy, _ = EventRow(*event)
    if not (abs(t) <= LATEST_S and abs(x) + abs(y) + abs(dx) + abs(dy) <= LARGEST):
        return (REFUSED,)
    started, dt = memory[STARTED] == 1.0, t - memory[T]
    if started and dt < 0.0:
        return (REFUSED,)
    memory[STARTED] = 1.0
    memory[T], memory[X], memory[Y] = t, x, y
    if not started or dt > memory[GAP_S] + ROUNDING_S:
        memory[SKIPPED] += 1.0
        memory[WAITING_X], memory[WAITING_Y] = 0.0, 0.0
        open_window(memory)
        return (LEFT_OUT,)
    memory[WAITING_X] += dx
    memory[WAITING_Y] += dy
    if dt == 0.0:
        return (TAKEN,)
    gather(memory, dt, memory[WAITING_X], memory[WAITING_Y])
    memory[WAITING_X], memory[WAITING_Y] = 0.0, 0.0
    if memory[DURATION] >= memory[WINDOW_S]:
        if memory[PATH] > 0.0:
            speed = memory[PATH] / memory[DURATION]
            learn(memory, ROW_X, (x - memory[START_X]) * memory[METRES_PER_PX], speed)
            learn(memory, ROW_Y, (y - memory[START_Y]) * memory[METRES_PER_PX], speed)
        open_window(memory)
    return (TAKEN,)


@law
def event_at(rows: FloatTable, i: int) -> SixFloats:
    """A row of a table of events as a tuple."""
    r = rows[i]
    return r[0], r[1], r[2], r[3], r[4], r[5]


class Identification(msgspec.Struct, frozen=True):
    """A transfer function and the data behind it.

    ``function`` is ``None`` if the data do not determine all powers, or contain no speed of the judged range;
    ``unexcited`` lists the powers that add nothing to those before them, ``condition`` is that of the data
    with columns of equal length. ``samples`` used, ``skipped`` reports without a valid time before them;
    ``residual`` is the root mean square error of a sample (m for windows, m/s for speeds).
    """

    function: PolynomialFunction | None
    unexcited: tuple[int, ...]
    condition: float
    residual: float
    samples: int
    skipped: int


class PolynomialIdentifier(CompiledStage):
    """Reports of a device with the cursor's positions in, a polynomial transfer function out.

    Assumes that only the device moves the cursor, away from the screen's edge. Reports must have counts.
    Small corners of the function are rounded; gains far outside the measured speeds are noise.

    V_c = sum c_i V_m^i by recursive least squares with forgetting. ``update`` learns displacements over short
    windows, which rounding to whole pixels does not bias; ``learn`` takes pairs of speeds as in the thesis,
    from Euler differences or from a differentiator (``euler_speeds``, ``differentiated_speeds``).

    Parameters: ``order`` q in 1 ... 6; ``offset`` allows c_0; ``cpi`` and ``dpi``; ``window_s`` in s;
    ``gap_s``, a longer pause makes a report's speed unknown; ``forgetting`` in (0, 1] for each sample;
    ``speed_low``, ``speed_high`` in m/s, the range of the fit; ``least_excitation`` the sine below which
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

    order: int = parameter("", 1, COEFFICIENTS_MOST - 1, "highest power of the speed", default=5, whole=True)
    cpi: float = parameter("counts per inch", *CPI, "resolution of the device", default=2000.0)
    dpi: float = parameter("px per inch", *DPI, "resolution of the screen", default=96.0)
    window_s: float = parameter(
        "s", 1e-4, 1.0, "displacements are learnt over windows of this length", default=0.005
    )
    gap_s: float = parameter("s", 1e-3, 1e3, "after a longer pause a report's speed is unknown", default=0.1)
    forgetting: float = parameter(
        "", 1e-6, 1.0, "factor on the weight of the past at each sample", default=1.0
    )
    speed_low: float = parameter("m/s", 0.0, 1e2, "lowest speed that is judged", default=0.0127)
    speed_high: float = parameter("m/s", 1e-3, 1e2, "highest speed that is judged", default=0.31)
    least_excitation: float = parameter(
        "", 1e-14, 1.0, "sine below which a power is not excited", default=1e-4
    )
    offset: bool = option("whether c_0 may differ from 0", default=False)
    learned = STARTED - LEARNED
    states = END - STARTED
    width = 1
    loop = staticmethod(loop_of(step, event_at))

    def declare(self, **values: Any) -> None:
        """Check each value, and that the range of speeds is not empty."""
        super().declare(**values)
        if self.speed_low >= self.speed_high:
            raise ParameterError(
                f"speed_low must lie below speed_high = {self.speed_high!r} m/s, "
                f"received {self.speed_low!r} m/s",
                field="speed_low",
                value=self.speed_low,
            )
        self.count = int(self.order) + (1 if self.offset else 0)
        self.band_width = (self.speed_high - self.speed_low) / bands.BANDS

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        shape = [float(self.count), 0.0 if self.offset else 1.0]
        metres = [METRES_PER_INCH / self.cpi, METRES_PER_INCH / self.dpi]
        spans = [self.window_s, self.gap_s, self.forgetting, self.speed_low, self.band_width]
        return [*shape, *metres, *spans]

    def update(self, event: PointerEvent, /) -> None:
        """Consume one report with counts and the cursor's position after it.

        Raises EventError for an event without counts, with a value that is not finite, or before the last
        one; the stage is then unchanged.
        """
        dx, dy = (nan if d is None else d for d in (event.dx, event.dy))
        if step(self._memory, (event.t, event.x, event.y, dx, dy, 0.0)) == (REFUSED,):
            raise EventError(
                f"event needs counts, finite values and a time in order, received {event!r}", value=event
            )

    def run(self, events: EventColumns) -> None:
        """Consume a table of reports; a row marked ``begin`` starts a new trial. Raises EventError."""
        before = self.remembered()
        refused = self.walk(events.begin, events.table)[:, 0] == REFUSED
        if refused.any():
            self.recall(before)
            raise EventError(
                f"row {int(refused.argmax())}: event needs counts, finite values and a time in order"
            )

    def learn(self, speed_m_s: float, cursor_speed_m_s: float) -> None:
        """Consume one pair (V_m, V_c); raises EventError for a speed that is not finite and >= 0."""
        if not (0.0 <= speed_m_s < inf and 0.0 <= cursor_speed_m_s < inf):
            raise EventError(
                f"speeds must lie in [0, inf) m/s, received {speed_m_s!r} and {cursor_speed_m_s!r}",
                value=(speed_m_s, cursor_speed_m_s),
            )
        learn_speeds(self._memory, speed_m_s, cursor_speed_m_s)

    def begin(self) -> None:
        """Start a new movement: no window spans both. Keeps everything learned."""
        self._memory[STARTED:] = 0.0

    def reset(self) -> None:
        """Forget everything learned."""
        self._memory[LEARNED:] = 0.0

    @property
    def last_t(self) -> float | None:
        """The time of the last report of this movement in s; ``None`` before the first."""
        return float(self._memory[T]) if self._memory[STARTED] else None

    def measured(self, noise: float) -> bands.Bands:
        """The mean gain in each band with data; ``noise``: standard deviation of a displacement."""
        n, linear = self.count, 1 if self.offset else 0
        numbers, weight, product, rows = bands.visited(self._memory, BANDS, n, linear)
        if n > linear + 1:  # where the gain curve is smooth a band's gain is that at its mean speed
            speeds = rows[:, linear + 1] / weight
        else:
            speeds = self.speed_low + (numbers + 0.5) * self.band_width
        return bands.Bands(speeds, product / weight, noise / np.sqrt(weight))

    def identify(self, weighting: Literal["samples", "gain"] = "gain") -> Identification:
        """The current function.

        ``"samples"`` is the thesis's recursion: every sample counts alike, so the errors are small where most
        samples lie. ``"gain"`` weighs bands of speed so that the largest relative error of the gain is small;
        with fewer bands than coefficients it uses the samples.
        """
        fitted = fit(
            least_squares.Sums(self._memory, SUMS),
            least_squares.parts(self._memory[NUMBERS:BANDS], self.count),
            self.least_excitation,
        )
        shift = 0 if self.offset else 1
        linear = 1 - shift
        skipped = int(self._memory[SKIPPED])
        powers = tuple(j + shift for j in fitted.unexcited)
        numbers, rows, trust = bands.trusted(self._memory, BANDS, self.count, linear, fitted.residual)
        function = None
        if fitted.values is not None and len(numbers):
            values = np.array(fitted.values)
            if weighting == "gain" and len(rows) > self.count:
                values = bands.balance(rows, trust)
            excited = numbers[trust > 0.5] if (trust > 0.5).any() else numbers
            low, high = (self.speed_low + self.band_width * (float(excited[i]) + (i < 0)) for i in (0, -1))
            function = PolynomialFunction([0.0] * shift + values.tolist(), speed_low=low, speed_high=high)
        return Identification(function, powers, fitted.condition, fitted.residual, fitted.samples, skipped)


class Differentiating(Protocol):
    """The interface of a differentiator used here."""

    def run(self, events: EventColumns) -> MotionColumns:
        """A motion for each event."""
        ...


def euler_speeds(
    events: EventColumns, *, cpi: float, dpi: float = 96.0, window_s: float = 0.02
) -> tuple[FloatArray, FloatArray]:
    """The speeds of hand and cursor in m/s by Euler differences over windows of at least ``window_s``.

    Assumes one trial with counts. Over single reports the rounding to whole pixels dominates, and a rounded
    step is on average longer than the step, so a window near 0 overestimates the speed.

    V_c = sqrt(dx^2 + dy^2) / h, corrected: the printed difference of sqrt(x^2 + y^2), the distance from the
    screen's corner, is not a speed (it is 0 for a movement around the corner).

    Returns (V_m, V_c), one pair a window. Raises EventError without counts and ParameterError.
    Reference: Khalin 2022, section 2.4.1, corrected.

    >>> events = EventColumns.of([0.0, 0.1], [0.0, 3.0], [0.0, 4.0], [0, 30], [0, 40])
    >>> motor, cursor = euler_speeds(events, cpi=1000.0, dpi=100.0)
    >>> float(motor[0].round(6)), float(cursor[0].round(6))  # 0.05 inch and 0.05 inch in 0.1 s
    (0.0127, 0.0127)
    """
    if not (window_s >= 0.0 and cpi > 0.0 and dpi > 0.0):
        raise ParameterError(
            f"window_s must be >= 0 s, cpi and dpi above 0, received {window_s!r}, {cpi!r}, {dpi!r}",
            field="window_s",
        )
    counts = events.table[:, 3:5]
    if np.isnan(counts).any():
        raise EventError("events need counts to tell the speed of the hand")
    rows = _edges(events.t, window_s)
    h = np.diff(events.t[rows])
    path = np.diff(np.cumsum(counts, axis=0)[rows], axis=0) * (METRES_PER_INCH / cpi)
    way = np.diff(events.table[rows, 1:3], axis=0) * (METRES_PER_INCH / dpi)
    return np.hypot(path[:, 0], path[:, 1]) / h, np.hypot(way[:, 0], way[:, 1]) / h


def differentiated_speeds(
    events: EventColumns, motor: Differentiating, cursor: Differentiating, *, spacing_s: float = 0.02
) -> tuple[FloatArray, FloatArray]:
    """The speeds of hand and cursor in m/s, each by a differentiator, thinned to one pair per ``spacing_s``.

    Assumes one trial. ``motor`` is built with the device's cpi, so that it follows the counts; ``cursor``
    without, so that it follows the path on the screen. The same law and gains delay both equally; but a
    curved transfer function of a smoothed speed is not the smoothed function.

    Returns (V_m, V_c) where both have settled.
    Reference: Khalin 2022, section 2.4.1.
    """
    hand, screen = motor.run(events), cursor.run(EventColumns.of(events.t, events.x, events.y))
    settled = (hand.settled == 1.0) & (screen.settled == 1.0)
    rows = _edges(events.t, spacing_s)
    rows = rows[settled[rows]]
    return np.hypot(hand.vx, hand.vy)[rows], np.hypot(screen.vx, screen.vy)[rows]


def _edges(t: FloatArray, spacing_s: float) -> np.ndarray[tuple[int], np.dtype[np.intp]]:
    """Rows that lie at least ``spacing_s`` after each other, and later than each other."""
    rows = [0]
    for row in range(1, len(t)):
        if t[row] - t[rows[-1]] >= spacing_s and t[row] > t[rows[-1]]:
            rows.append(row)
    return np.array(rows[: len(t)], np.intp)
