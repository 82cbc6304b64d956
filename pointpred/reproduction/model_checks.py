"""Figures 2.5 and 2.11 of the thesis, its two checks of its model: the corrective phase, and minimum jerk."""

from __future__ import annotations

from math import inf
from pathlib import Path

import msgspec
import numpy as np

from pointpred.drawing import Panel, beside, drawing
from pointpred.parameter import Parameter, check
from pointpred.predictors import SwitchedPredictor
from pointpred.records import FloatArray, MotionColumns
from pointpred.regression import DynamicRegressorExtension
from pointpred.reproduction.figure import Reproduction, Value
from pointpred.simulation import loop
from pointpred.transfer import Arctan, TransferFunction


class Signals(msgspec.Struct, frozen=True):
    """One axis over time: t in s, cursor x, hand v and its derivative a, all in the units of the model."""

    t: FloatArray
    x: FloatArray
    v: FloatArray
    a: FloatArray


class Doubled(msgspec.Struct, frozen=True):
    """A movement and the ballistic estimate of its end."""

    t: FloatArray
    x: FloatArray
    v: FloatArray
    estimate: FloatArray


def bare_memory(transfer: TransferFunction, *, period_s: float, px_per_metre: float = 1.0) -> loop.Memory:
    """A trial without person, sensor or noise: the caller sets the phase and the forces."""
    memory = loop.Memory(np.zeros(loop.Memory.length))
    settings = memory.settings
    settings.period_s, settings.substeps, settings.px_per_metre = period_s, 1.0, px_per_metre
    settings.function.memory[:] = transfer.slots
    settings.patience_s = inf
    return memory


def corrective_signals(
    *,
    b1: float = 4.0,
    b2: float = 7.0,
    target: float = 600.0,
    transfer: TransferFunction | None = None,
    step_s: float = 0.01,
    duration_s: float = 10.0,
) -> Signals:
    """The corrective phase alone from rest, V' = -b1 V - b2 (x - T), x' = PTF(V), by default arctan.

    The defaults are those of section 2.6.2; V is in px/s there and needs no sensor. arctan moves the cursor
    at most 1.57 px/s, so 600 px take 382 s, and V is nearly constant after the first two seconds.

    Parameters: ``b1`` 1/s and ``b2`` in [0, 1e6]; ``target`` px; ``step_s`` of the midpoint rule and
    ``duration_s`` in s. Raises ParameterError.
    Reference: Khalin 2022, sections 2.4.3 and 2.6.2, figure 2.5.

    >>> signals = corrective_signals(duration_s=3.0)
    >>> round(float(signals.v[-1]))  # close to b2 T / b1 = 1050
    1042
    """
    bounds = (
        Parameter("b1", "1/s", 0.0, 1e6, "friction"),
        Parameter("b2", "1/s^2", 0.0, 1e6, "feedback"),
        Parameter("target", "px", -1e9, 1e9, "T"),
        Parameter("step_s", "s", 1e-6, 1.0, "step of the integration"),
        Parameter("duration_s", "s", 0.0, 1e5, "length of the signals"),
    )
    values = {"b1": b1, "b2": b2, "target": target, "step_s": step_s, "duration_s": duration_s}
    check(bounds, values)
    memory = bare_memory(Arctan() if transfer is None else transfer, period_s=step_s)
    memory.state.phase, memory.state.feedback = loop.CORRECTIVE, b2
    memory.settings.b1, memory.settings.aim_x = b1, target
    rows = np.zeros((round(duration_s / step_s), len(loop.INPUTS)))
    rows[:, 3:] = np.nan
    out = np.zeros((len(rows) + 1, len(loop.OUTPUTS)))
    loop.play(memory.memory, rows, out[1:])
    x, v = out[:, loop.OUTPUTS.index("x")], out[:, loop.OUTPUTS.index("vx")]
    return Signals(out[:, 0].copy(), x.copy(), v.copy(), -b1 * v - b2 * (x - target))


def ballistic_estimate(t: FloatArray, x: FloatArray, v: FloatArray, a: FloatArray) -> FloatArray:
    """The endpoint of ``SwitchedPredictor`` without its corrective phase, one axis.

    t in s, x in px from the start, v in m/s, a in m/s^2, all of the same length.
    """
    table = np.zeros((len(t), len(MotionColumns.names)))
    for name, values in {"t": t, "x": x, "vx": v, "ax": a, "settled": np.ones(len(t))}.items():
        table[:, MotionColumns.names.index(name)] = values
    begin = np.zeros(len(t), dtype=np.bool_)
    return SwitchedPredictor(threshold=0.0).run(MotionColumns(table), begin).x


def minimum_jerk_check(samples: int = 1001) -> Doubled:
    """Figure 2.11: the minimum-jerk movement from 0 to 1 in unit time, and its end estimated by doubling.

    x = 10 t^3 - 15 t^4 + 6 t^5; the speed peaks at t = 1/2, where x = 1/2 and the estimate is exactly 1.
    Reference: Hogan 1984; Khalin 2022, section 2.6.3.

    >>> check = minimum_jerk_check()
    >>> float(check.t[check.v.argmax()]), round(float(check.estimate[check.v.argmax()]), 12)
    (0.5, 1.0)
    """
    check((Parameter("samples", "", 3, 10**7, "of unit time"),), {"samples": samples})
    t = np.linspace(0.0, 1.0, samples)
    x = t**3 * (10.0 - 15.0 * t + 6.0 * t**2)
    v = 30.0 * t**2 * (1.0 - t) ** 2
    a = 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t)
    return Doubled(t, x, v, ballistic_estimate(t, x, v, a))


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
