"""Figures 2.5 and 2.11 of the thesis: the corrective phase alone, and minimum jerk."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pointpred.drawing import Panel, beside, drawing
from pointpred.regression import DynamicRegressorExtension
from pointpred.reproduction.figure import Reproduction, Value
from pointpred.reproduction.simulation_checks import corrective_signals, minimum_jerk_check

DURATION_S = 420.0
"""Until the cursor has arrived: arctan moves it at most 1.57 px/s over 600 px."""
DELAY_S, GAMMA = 0.1, 1.14e14
"""Of the regression; the thesis prints neither."""


def figure_2_5(_: Path | None) -> Reproduction:
    """The corrective phase under arctan, and its parameters by DREM."""
    signals = corrective_signals(duration_s=DURATION_S)
    stage = DynamicRegressorExtension(3, delay_s=DELAY_S, gamma=GAMMA)
    found = np.full((len(signals.t), 3), np.nan)
    for i, (t, x, v, a) in enumerate(zip(signals.t, signals.x, signals.v, signals.a, strict=True)):
        answer = stage.update((-a, -v, 1.0), x, t)
        if answer is not None:
            found[i] = answer.values
    goal = found[:, 2]
    panels = []
    for until in (3.0, DURATION_S):
        part = signals.t <= until
        lines = beside(signals.t[part], (signals.x[part], "x", "truth"), (goal[part], "T^", "second"))
        panels.append(Panel("x", lines, limits=(-30.0, 640.0), title=f"the first {until:g} s"))
    for until in (3.0, DURATION_S):
        part = signals.t <= until
        panels.append(Panel("V", beside(signals.t[part], (signals.v[part], "", "first"))))
    inverse_b2, ratio, target = found[-1].tolist()
    outside = ~(np.abs(goal - 600.0) <= 0.01 * 600.0)  # also before the first estimate
    settled = float(signals.t[outside].max())
    values = (
        Value("T", target, "600", "px"),
        Value("b1", ratio / inverse_b2, "4", "1/s"),
        Value("b2", 1.0 / inverse_b2, "7", "1/s^2"),
        Value("last time at which T^ is not within 1 % of T", settled, None, "s"),
    )
    title = "Figure 2.5: corrective phase, b1 = 4, b2 = 7, T = 600, PTF = arctan, h = 0.01 s"
    return Reproduction(values, drawing(title, panels, columns=2), "simulated, as the thesis does")


def figure_2_11(_: Path | None) -> Reproduction:
    """The minimum-jerk movement, and its end by doubling the way at the peak of the speed."""
    check = minimum_jerk_check()
    panels = (
        Panel("x", beside(check.t, (check.x, "x", "truth"), (check.estimate, "T^", "second")), x="t"),
        Panel("V", beside(check.t, (check.v, "", "first")), x="t"),
    )
    peak = int(check.v.argmax())
    values = (
        Value("time of the peak of the speed", float(check.t[peak]), "1/2"),
        Value("x at the peak", float(check.x[peak]), "1/2"),
        Value("T^ at the peak", float(check.estimate[peak]), "1"),
        Value("T^ at the end", float(check.estimate[-1]), "1"),
    )
    return Reproduction(values, drawing("Figure 2.11: minimum jerk", panels), "computed, without units")
