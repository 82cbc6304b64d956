"""The thesis's two checks of its model: the corrective phase alone (figure 2.5) and minimum jerk (2.11)."""

from __future__ import annotations

from math import inf

import msgspec
import numpy as np

from pointpred.parameter import Parameter, check
from pointpred.predictors import SwitchedPredictor
from pointpred.records import FloatArray, MotionColumns
from pointpred.simulation import loop, slots
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


def bare_memory(transfer: TransferFunction, *, period_s: float, px_per_metre: float = 1.0) -> FloatArray:
    """A trial without person, sensor or noise: the caller sets the phase and the forces in ``slots``."""
    memory = np.zeros(slots.SIZE)
    memory[slots.PERIOD_S] = period_s
    memory[slots.SUBSTEPS] = 1.0
    memory[slots.PX_PER_METRE] = px_per_metre
    memory[slots.FUNCTION : slots.B1] = transfer.slots
    memory[slots.PATIENCE_S] = inf
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
    memory[slots.PHASE], memory[slots.FEEDBACK] = slots.CORRECTIVE, b2
    memory[slots.B1], memory[slots.AIM_X] = b1, target
    rows = np.zeros((round(duration_s / step_s), len(loop.INPUTS)))
    rows[:, 3:] = np.nan
    out = np.zeros((len(rows) + 1, len(loop.OUTPUTS)))
    loop.play(memory, rows, out[1:])
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
