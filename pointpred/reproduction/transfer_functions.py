"""Figures 2.6 and 2.7 of the thesis: transfer functions identified from 48 trials."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.drawing import Look, Panel, beside, drawing
from pointpred.records import EventColumns, FloatArray
from pointpred.reproduction.figure import Reproduction, Value
from pointpred.transfer import (
    ConstantGain,
    PixelTransfer,
    PolynomialFunction,
    PolynomialIdentifier,
    SigmoidGain,
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


WAY = "windows, gain"
"""How the polynomial is identified: the default of ``PolynomialIdentifier``."""
SEED, FRESH_SEED = 1, 1000
DRAWN_TRIAL = 13
FUNCTIONS: dict[str, TransferFunction] = {"sigmoid": SigmoidGain(), "constant gain 4": ConstantGain(4.0)}
WORDS = "simulated minimum-jerk movements at 2000 CPI and 1 kHz"


def identified() -> dict[str, PolynomialFunction]:
    """The polynomial of order 5 for each of the thesis's two functions."""
    return {name: identify(simulate_trials(truth, SEED), WAY) for name, truth in FUNCTIONS.items()}


def figure_2_6(_: Path | None) -> Reproduction:
    """The cursor's position of a fresh trial, rebuilt from the speed of the hand."""
    panels, values = [], []
    for name, function in identified().items():
        fresh = simulate_trials(FUNCTIONS[name], FRESH_SEED)
        events = fresh[DRAWN_TRIAL]
        path = rebuild(function, events)
        for column, axis in enumerate("xy"):
            lines = beside(
                events.t,
                (events.table[:, 1 + column], axis, "truth"),
                (path[:, column], "rebuilt from V_m", "second"),
            )
            panels.append(Panel(f"{axis} [px]", lines, title=name))
        off = rebuilding_errors(function, fresh)
        values += [
            Value(f"largest distance in a trial, median of {TRIALS}, {name}",
                  float(np.median(off)), None, "px"),
            Value(f"largest distance in a trial, worst of {TRIALS}, {name}", float(off.max()), None, "px"),
        ]  # fmt: skip
    title = "Figure 2.6: position of a fresh trial, rebuilt"
    return Reproduction(tuple(values), drawing(title, panels, columns=2), WORDS)


def figure_2_7(_: Path | None) -> Reproduction:
    """The gain curves over the speed of the hand, and the best polynomial of order 5 for the sigmoid."""
    panels, values = [], []
    for name, function in identified().items():
        truth = FUNCTIONS[name]
        lines: list[tuple[FloatArray, str, Look]] = [
            (truth.gain(SPEEDS), "true", "truth"),
            (function.gain(SPEEDS), "identified", "second"),
        ]
        error = gain_error(function, truth)
        values += [
            Value(f"error of the gain, median, {name}", 100.0 * error.median, None, "%"),
            Value(f"error of the gain, largest, {name}", 100.0 * error.largest, None, "%"),
        ]
        if name == "sigmoid":
            best = best_polynomial(truth)
            lines.append((best.gain(SPEEDS), "best of order 5", "third"))
            largest = 100.0 * gain_error(best, truth).largest
            values.append(Value("error of the gain, largest, best polynomial", largest, None, "%"))
        top = 1.15 * float(truth.gain(0.3))
        panels.append(Panel("gain", beside(SPEEDS, *lines), x="V_m [m/s]", limits=(0.0, top), title=name))
    low, high, slow, fast = (float(FUNCTIONS["sigmoid"].gain(v)) for v in (0.0, 0.6, 0.05, 0.3))
    values += [
        Value("gain of the sigmoid below 0.05 m/s", low, "1"),
        Value("gain of the sigmoid at 0.05 m/s", slow, "1"),
        Value("gain of the sigmoid at 0.3 m/s", fast),
        Value("gain of the sigmoid above 0.6 m/s", high, "15"),
    ]
    return Reproduction(tuple(values), drawing("Figure 2.7: gain", panels, columns=2), WORDS)
