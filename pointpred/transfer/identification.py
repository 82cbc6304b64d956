"""Identifying an unknown transfer function as a polynomial, thesis section 2.5.1.

A cursor moves in whole pixels, so its speed between two reports at 1 kHz is mostly rounding, and the length
of a rounded step is biased. Reports are therefore combined into short windows: over one, the displacement of
an axis is sum of h (V_x / V) PTF(V) = sum_i c_i (sum of h V_x V^(i-1)): linear in c, with an error of at most
a pixel.
"""

from __future__ import annotations

from math import hypot, inf, nan
from typing import Annotated, Any, Literal, Protocol

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.errors import EventError, ParameterError
from pointpred.layout import Layout, clear
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
from pointpred.stage import CompiledStage, loop_of
from pointpred.transfer import bands
from pointpred.transfer.functions import COEFFICIENTS_MOST, PolynomialFunction


class Settings(Layout):
    """The parameters."""

    count: float
    """How many coefficients."""
    power: float
    """Of the first, 0 or 1."""
    metres_per_count: float
    metres_per_px: float
    window_s: float
    gap_s: float
    forgetting: float
    speed_low: float
    band_width: float


class Learned(Layout):
    """What stays from one movement to the next."""

    skipped: float
    """Reports left out."""
    sums: least_squares.Sums
    numbers: Annotated[FloatArray, least_squares.numbers(COEFFICIENTS_MOST)]
    bands: Annotated[FloatArray, bands.states(COEFFICIENTS_MOST)]
    row: Annotated[FloatArray, COEFFICIENTS_MOST]
    """Scratch space."""


class Window(Layout):
    """Its start, px; since then the hand's way, m, its time, s, and the rows of both axes."""

    x: float
    y: float
    path: float
    duration: float
    row_x: Annotated[FloatArray, COEFFICIENTS_MOST]
    row_y: Annotated[FloatArray, COEFFICIENTS_MOST]


class State(Layout):
    """The last report, the counts that wait until time passes, the window."""

    started: float
    t: float
    x: float
    y: float
    waiting_x: float
    waiting_y: float
    window: Window


class Memory(Layout):
    """The settings, what is known of the function, then the state."""

    settings: Settings
    learned: Learned
    state: State


REFUSED, TAKEN, LEFT_OUT = -1.0, 0.0, 1.0


@law
def learn(memory: Memory, row: FloatArray, output: float, speed: float) -> None:
    """Add output = row . c at a speed of the hand to the recursion and to its band."""
    settings, learned = memory.settings, memory.learned
    n = int(settings.count)
    regression = least_squares.parts(learned.numbers, n)
    for j in range(n):
        regression.w[j] = row[j]
    least_squares.advance(learned.sums, regression, settings.forgetting, output)
    band = (speed - settings.speed_low) / settings.band_width
    model = bands.Model(n, 1 - int(settings.power), settings.forgetting)
    bands.learn(learned.bands, model, band, row, output)


@law
def learn_speeds(memory: Memory, speed: float, cursor_speed: float) -> None:
    """Add one pair of speeds in m/s, as in section 2.5.1: the regressor consists of powers of V."""
    row = memory.learned.row
    value = 1.0 if memory.settings.power == 0.0 else speed
    for j in range(int(memory.settings.count)):
        row[j] = value
        value *= speed
    learn(memory, row, cursor_speed, speed)


@law
def open_window(s: State) -> None:
    """Start a window at the last report."""
    clear(s.window)
    s.window.x, s.window.y = s.x, s.y


@law
def gather(settings: Settings, window: Window, dt: float, dx: float, dy: float) -> None:
    """Add one report's path to the rows of both axes."""
    u, v = dx * settings.metres_per_count, dy * settings.metres_per_count
    path = hypot(u, v)
    window.path += path
    window.duration += dt
    if path == 0.0:
        return
    speed = path / dt
    factor = 1.0 / speed if settings.power == 0.0 else 1.0
    for j in range(int(settings.count)):
        window.row_x[j] += u * factor
        window.row_y[j] += v * factor
        factor *= speed


@law
def step(memory: Memory, event: SixFloats) -> tuple[float]:
    """One report of the device with the cursor's position after it: refused, taken or left out."""
    settings, s, window = memory.settings, memory.state, memory.state.window
    t, x, y, dx, dy, _ = EventRow(*event)
    if not (abs(t) <= LATEST_S and abs(x) + abs(y) + abs(dx) + abs(dy) <= LARGEST):
        return (REFUSED,)
    started, dt = s.started == 1.0, t - s.t
    if started and dt < 0.0:
        return (REFUSED,)
    s.started = 1.0
    s.t, s.x, s.y = t, x, y
    if not started or dt > settings.gap_s + ROUNDING_S:
        memory.learned.skipped += 1.0
        s.waiting_x, s.waiting_y = 0.0, 0.0
        open_window(s)
        return (LEFT_OUT,)
    s.waiting_x += dx
    s.waiting_y += dy
    if dt == 0.0:
        return (TAKEN,)
    gather(settings, window, dt, s.waiting_x, s.waiting_y)
    s.waiting_x, s.waiting_y = 0.0, 0.0
    if window.duration >= settings.window_s:
        if window.path > 0.0:
            speed = window.path / window.duration
            learn(memory, window.row_x, (x - window.x) * settings.metres_per_px, speed)
            learn(memory, window.row_y, (y - window.y) * settings.metres_per_px, speed)
        open_window(s)
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
    learned = Learned.length
    states = State.length
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
        clear(Memory(self._memory).state)

    def reset(self) -> None:
        """Forget everything learned."""
        self._memory[Settings.length :] = 0.0

    @property
    def last_t(self) -> float | None:
        """The time of the last report of this movement in s; ``None`` before the first."""
        s = Memory(self._memory).state
        return float(s.t) if s.started else None

    def measured(self, noise: float) -> bands.Bands:
        """The mean gain in each band with data; ``noise``: standard deviation of a displacement."""
        n, linear = self.count, 1 if self.offset else 0
        numbers, weight, product, rows = bands.visited(Memory(self._memory).learned.bands, n, linear)
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
        learned = Memory(self._memory).learned
        regression = least_squares.parts(learned.numbers, self.count)
        fitted = fit(learned.sums, regression, self.least_excitation)
        shift = 0 if self.offset else 1
        linear = 1 - shift
        skipped = int(learned.skipped)
        powers = tuple(j + shift for j in fitted.unexcited)
        numbers, rows, trust = bands.trusted(learned.bands, self.count, linear, fitted.residual)
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
