"""Simulated trials through a transfer function, its identification from them, and how far off it is."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.records import EventColumns, FloatArray
from pointpred.transfer import (
    PixelTransfer,
    PolynomialFunction,
    PolynomialIdentifier,
    TransferFunction,
    differentiated_speeds,
    euler_speeds,
)

CPI, DPI = 2000.0, 96.0
METRES_PER_COUNT, METRES_PER_PX = 0.0254 / CPI, 0.0254 / DPI
DISTANCES_M = (0.075, 0.150)
TRIALS = 48
ORDER = 5
SPEEDS = np.linspace(0.0127, 0.3, 400)


def simulate_trial(
    function: TransferFunction, peak: float, distance: float, rng: np.random.Generator
) -> EventColumns:
    """One straight minimum-jerk movement of the hand that takes the cursor ``distance`` m over the screen.

    2000 CPI, reports every 1 ms with 5 % jitter of their real times, whole counts, whole pixels.
    """
    u = np.linspace(0.0, 1.0, 2001)
    bell = 16.0 * u**2 * (1.0 - u) ** 2
    duration = distance / float(np.trapezoid(function.cursor_speed(peak * bell), u))
    h = 0.001 * np.clip(1.0 + 0.05 * rng.standard_normal(int(1200 * duration) + 50), 0.5, 1.5)
    t = np.cumsum(h)
    t = t[t < duration + 0.02]
    s = np.clip(t / duration, 0.0, 1.0)
    path = peak * duration / 1.875 * (10.0 * s**3 - 15.0 * s**4 + 6.0 * s**5)
    angle = rng.uniform(0.0, 2.0 * np.pi)
    place = np.trunc(np.outer(path, [np.cos(angle), np.sin(angle)]) / METRES_PER_COUNT)
    counts = np.diff(place, axis=0, prepend=0.0)
    moved = PixelTransfer(function, cpi=CPI, dpi=DPI).run(t, counts[:, 0], counts[:, 1])
    x, y = 900.0 + np.cumsum(moved[:, 0]), 600.0 + np.cumsum(moved[:, 1])
    begin = np.zeros(len(t), np.bool_)
    begin[0] = True
    return EventColumns.of(t, x, y, counts[:, 0], counts[:, 1], begin=begin)


def simulate_trials(function: TransferFunction, seed: int, count: int = TRIALS) -> list[EventColumns]:
    """Trials over 75 and 150 mm in turn, peak speeds of the hand spread evenly over 0.03 ... 0.31 m/s."""
    rng = np.random.default_rng(seed)
    peaks = rng.permutation(np.linspace(0.03, 0.31, count))
    return [simulate_trial(function, peak, DISTANCES_M[i % 2], rng) for i, peak in enumerate(peaks)]


def identify(trials: list[EventColumns], way: str) -> PolynomialFunction:
    """The polynomial from trials, one of the ways below."""
    identifier = PolynomialIdentifier(order=ORDER, cpi=CPI, dpi=DPI)
    for events in trials:
        if way.startswith("windows"):
            identifier.run(events)
            continue
        if way == "euler":
            pairs = euler_speeds(events, cpi=CPI, dpi=DPI)
        else:
            law: dict[str, Any] = {"alpha": 0.0, "gain_lambda": 20.0} if way == "linear" else {}
            hand, screen = (
                HomogeneousDifferentiator(cpi=CPI, **law),
                HomogeneousDifferentiator(dpi=DPI, **law),
            )
            pairs = differentiated_speeds(events, hand, screen)
        for speed, cursor_speed in zip(*pairs, strict=True):
            identifier.learn(float(speed), float(cursor_speed))
    function = identifier.identify("gain" if way == "windows, gain" else "samples").function
    if function is None:
        raise RuntimeError("the trials do not excite all powers")
    return function


class GainError(NamedTuple):
    """Relative error of a gain curve over 0.0127 ... 0.3 m/s."""

    median: float
    largest: float
    at: float


def gain_error(estimate: TransferFunction, truth: TransferFunction) -> GainError:
    """How far the gain of an estimate is from the true one over SPEEDS."""
    error = np.abs(estimate.gain(SPEEDS) / truth.gain(SPEEDS) - 1.0)
    return GainError(float(np.median(error)), float(error.max()), float(SPEEDS[error.argmax()]))


def best_polynomial(truth: TransferFunction) -> PolynomialFunction:
    """The polynomial with c_0 = 0 whose largest relative gain error is smallest: a linear programme."""
    from scipy.optimize import linprog

    rows = SPEEDS[:, None] ** np.arange(ORDER) / truth.gain(SPEEDS)[:, None]
    bound = np.ones((len(SPEEDS), 1))
    sides = np.block([[rows, -bound], [-rows, -bound]])
    limits = np.concatenate([np.ones(len(SPEEDS)), -np.ones(len(SPEEDS))])
    cost = np.eye(ORDER + 1)[-1]
    answer: Any = linprog(cost, A_ub=sides, b_ub=limits, bounds=[(None, None)] * (ORDER + 1))
    return PolynomialFunction([0.0, *answer.x[:-1]])


def rebuild(function: TransferFunction, events: EventColumns) -> FloatArray:
    """The cursor's path in px from V_m alone: model (2.1) with a transfer function, no rounding to pixels."""
    counts = events.table[1:, 3:5]
    speed = np.hypot(counts[:, 0], counts[:, 1]) * METRES_PER_COUNT / np.diff(events.t)
    steps = function.gain(speed)[:, None] * counts * (DPI / CPI)
    start = events.table[:1, 1:3]
    return np.concatenate([start, start + np.cumsum(steps, axis=0)])


def rebuilding_errors(function: TransferFunction, fresh: list[EventColumns]) -> FloatArray:
    """The largest distance in px between rebuilt and true path, one number a fresh trial."""
    return np.array([np.hypot(*(rebuild(function, e) - e.table[:, 1:3]).T).max() for e in fresh])
