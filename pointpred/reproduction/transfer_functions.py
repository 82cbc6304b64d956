"""Figures 2.6 and 2.7 of the thesis: transfer functions identified from 48 trials."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pointpred.drawing import Look, Panel, beside, drawing
from pointpred.records import FloatArray
from pointpred.reproduction.figure import Reproduction, Value
from pointpred.reproduction.transfer_trials import (
    SPEEDS,
    TRIALS,
    best_polynomial,
    gain_error,
    identify,
    rebuild,
    rebuilding_errors,
    simulate_trials,
)
from pointpred.transfer import ConstantGain, PolynomialFunction, SigmoidGain, TransferFunction

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
