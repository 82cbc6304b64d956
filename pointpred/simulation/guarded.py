"""The pointing loop with the guarded transfer function in it: what assistance does to a movement."""

from __future__ import annotations

from math import hypot
from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.events import PointerEvent
from pointpred.parameter import Parameter, check
from pointpred.pipeline import Pipeline
from pointpred.simulation import loop, movement, plan, slots
from pointpred.simulation.person import Person
from pointpred.transfer import assisted_guard, known, pixels
from pointpred.transfer.assisted_guarded import GUARD_PARAMETERS, guidance

NONE = float("nan")
PHASE = loop.OUTPUTS.index("phase")
OWED = assisted_guard.SETTINGS
HABIT = (Parameter("habit", "", 0.0, 1.0, "share by which a person expects the cursor to go farther"),)


class Guard(msgspec.Struct, frozen=True):
    """How much help: the parameters of ``GuardedTransfer`` that are not those of the device."""

    rho: float = 8.0
    strength: float = 0.5
    sideways: float = 0.5
    uncertain: float = 0.5
    unclaimed: float = 0.25

    def memory(self) -> FloatArray:
        """Its flat memory: the parameters, nothing owed; raises ParameterError."""
        values: dict[str, Any] = msgspec.structs.asdict(self)
        check(GUARD_PARAMETERS, values)
        return np.array([*map(float, values.values()), *[0.0] * pixels.CARRIED])


class Claim(msgspec.Struct, frozen=True):
    """What a scripted predictor says from the start of the hand's movement on, right or deliberately wrong.

    ``x``, ``y`` px from where the movement starts; ``spread_px`` the standard deviation it claims.
    """

    x: float
    y: float
    spread_px: float | None = None


@law
def step(
    memory: FloatArray,
    guard: FloatArray,
    noise_x: float,
    noise_y: float,
    late_s: float,
    hat_x: float,
    hat_y: float,
    sxx: float,
    sxy: float,
    syy: float,
) -> tuple[float, ...]:
    """``loop.step``, and what the guard adds to the pixels of its report before the eyes have them."""
    off_x, off_y = hat_x - memory[slots.X], hat_y - memory[slots.Y]
    made = loop.step(memory, noise_x, noise_y, late_s, NONE, NONE)
    unit, period = memory[slots.METRES_PER_COUNT], memory[slots.PERIOD_S]
    gain = known.gain(memory, slots.FUNCTION, hypot(made[3], made[4]) * unit / period)
    scale = gain * memory[slots.PX_PER_METRE] * unit
    own_x, own_y = scale * made[3], scale * made[4]
    add_x, add_y = assisted_guard.add(guard, 0, OWED, period, own_x, own_y, off_x, off_y, sxx, sxy, syy)
    memory[slots.X] += add_x
    memory[slots.Y] += add_y
    row = slots.RING + slots.RING_SLOTS * (int(memory[slots.TICK]) % slots.RING_ROWS)
    memory[row], memory[row + 1] = memory[slots.X], memory[slots.Y]
    return (made[0], memory[slots.X], memory[slots.Y], *made[3:])


@law
def play(memory: FloatArray, guard: FloatArray, rows: FloatArray, out: FloatArray) -> int:
    """The same step over a table until the button is released; returns the number of reports made."""
    for i in range(len(rows)):
        r = rows[i]
        answer = step(memory, guard, r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7])
        for j in range(len(answer)):
            out[i, j] = answer[j]
        if memory[slots.PHASE] == slots.DONE:
            return i + 1
    return len(rows)


def move_guarded(
    person: Person,
    setup: plan.Setup,
    aim: plan.Aim,
    generator: np.random.Generator,
    guard: Guard,
    predictor: Claim | Pipeline | None = None,
    *,
    habit: float = 0.0,
) -> movement.Movement:
    """One movement towards ``aim`` whose reports go through the guarded transfer function.

    ``predictor``: a script, or a pipeline in the loop, which is reset first and hears every report that has
    counts (some hundred times slower); ``None`` predicts nothing. ``setup`` must have a sensor and ``rho`` 0.
    With strength 0 or without a predictor it is ``move`` bit for bit. ``habit`` in [0, 1]: how much farther
    than their hand asks for the person has learnt that the cursor goes; their pieces are planned shorter by
    1 + habit. 0 is somebody who does not know of the help, and nobody learns here. Raises ParameterError.
    """
    check(HABIT, {"habit": habit})
    memory, chance = movement.prepare(person, setup, aim, generator)
    memory[slots.PIECE + slots.SHARE : slots.SETTINGS : slots.PIECE_SLOTS] /= 1.0 + habit
    rows = np.full((len(chance), len(loop.INPUTS) + 3), NONE)
    rows[:, :3] = chance[:, :3]
    held = guard.memory()
    if isinstance(predictor, Pipeline):
        return _in_the_loop(memory, held, rows, predictor)
    if predictor is not None:
        variance = NONE if predictor.spread_px is None else predictor.spread_px**2
        said = (predictor.x, predictor.y, variance, 0.0, variance)
        rows[int(memory[slots.REACTION_S] / setup.period_s) :, 3:] = said
    out = np.empty((len(rows), len(loop.OUTPUTS)))
    return movement.Movement(out[: play(memory, held, rows, out)])


def _in_the_loop(
    memory: FloatArray, held: FloatArray, rows: FloatArray, pipeline: Pipeline
) -> movement.Movement:
    """Report by report: each goes through the pipeline, its prediction guides the next."""
    pipeline.reset()
    made: list[tuple[float, ...]] = []
    said = guidance(None, (0.0, 0.0))
    for noise_x, noise_y, late_s in rows[:, :3].tolist():
        made.append(step(memory, held, noise_x, noise_y, late_s, *said))
        t, x, y, dx, dy, buttons = made[-1][:6]
        if dx != 0.0 or dy != 0.0:
            said = guidance(pipeline.update(PointerEvent(t, x, y, dx, dy, int(buttons))), (0.0, 0.0))
        if made[-1][PHASE] == slots.DONE:
            break
    return movement.Movement(np.array(made, dtype=np.float64))
