"""The pointing loop with the guarded transfer function: the effect of assistance on a movement."""

from __future__ import annotations

from math import hypot, nan
from typing import Any, NamedTuple

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.parameter import Parameter, check
from pointpred.pipeline import Pipeline
from pointpred.records import FloatArray, PointerEvent, Row
from pointpred.simulation import loop, movement, plan, slots
from pointpred.simulation.person import Person
from pointpred.transfer import GuardedTransfer, assistance, functions, pixels
from pointpred.transfer.assistance import UNGUIDED, way_to

PHASE = loop.OUTPUTS.index("phase")
HABIT = (Parameter("habit", "", 0.0, 1.0, "share by which a person expects the cursor to go farther"),)


class Guard(msgspec.Struct, frozen=True):
    """The parameters of ``GuardedTransfer`` except those of the device."""

    rho: float = 8.0
    strength: float = 0.5
    sideways: float = 0.5
    uncertain: float = 0.5
    unclaimed: float = 0.25

    def memory(self) -> FloatArray:
        """Its initial flat memory; raises ParameterError."""
        values: dict[str, Any] = msgspec.structs.asdict(self)
        for one in GuardedTransfer.parameters:
            if one.name in values:
                one.check(values[one.name])
        return np.array([*map(float, values.values()), *[0.0] * pixels.CARRIED])


OWED = len(Guard.__struct_fields__)


class Claim(msgspec.Struct, frozen=True):
    """The constant prediction of a scripted predictor from the start of the hand's movement, right or wrong.

    ``x``, ``y`` px from the start of the movement; ``spread_px`` its standard deviation.
    """

    x: float
    y: float
    spread_px: float | None = None


class GuidedChance(NamedTuple):
    """A ``loop.Chance``, and the covariance of its endpoint in px^2 or NaN."""

    noise_x: float
    noise_y: float
    late_s: float
    hat_x: float
    hat_y: float
    sxx: float
    sxy: float
    syy: float


@law
def step(memory: FloatArray, row: Row, guard: FloatArray) -> tuple[float, ...]:
    """``loop.step``, with the guard's pixels added before the person sees the report."""
    r = GuidedChance(*row)
    off_x, off_y = r.hat_x - memory[slots.X], r.hat_y - memory[slots.Y]
    poll = loop.step(memory, (r.noise_x, r.noise_y, r.late_s, nan, nan))
    unit, period = memory[slots.METRES_PER_COUNT], memory[slots.PERIOD_S]
    gain = functions.gain(memory, slots.FUNCTION, hypot(poll[3], poll[4]) * unit / period)
    scale = gain * memory[slots.PX_PER_METRE] * unit
    own = scale * poll[3], scale * poll[4]
    add_x, add_y = assistance.add(guard, 0, OWED, period, own, (off_x, off_y, r.sxx, r.sxy, r.syy))
    memory[slots.X] += add_x
    memory[slots.Y] += add_y
    ring = slots.RING + slots.RING_SLOTS * (int(memory[slots.TICK]) % slots.RING_ROWS)
    memory[ring], memory[ring + 1] = memory[slots.X], memory[slots.Y]
    return (poll[0], memory[slots.X], memory[slots.Y], *poll[3:])


play = loop.play_of(step, assistance.guided_report_at)


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

    ``predictor``: a script, or a pipeline in the loop, which is reset first and updated with every report
    with counts (some hundred times slower); ``None`` predicts nothing. ``setup`` must have a sensor and
    ``rho`` 0. With strength 0 or without a predictor it is ``move`` bit for bit. ``habit`` in [0, 1]: the
    extra cursor distance that the person expects from the assistance; their pieces are planned shorter by 1 +
    habit. It is 0 for a person unaware of the assistance, and constant. Raises ParameterError.
    """
    check(HABIT, {"habit": habit})
    memory, chance = movement.prepare(person, setup, aim, generator)
    memory[slots.PIECE + slots.SHARE : slots.SETTINGS : slots.PIECE_SLOTS] /= 1.0 + habit
    rows = np.full((len(chance), len(loop.INPUTS) + 3), nan)
    rows[:, :3] = chance[:, :3]
    limits = guard.memory()
    if isinstance(predictor, Pipeline):
        return _in_the_loop(memory, limits, rows, predictor)
    if predictor is not None:
        variance = nan if predictor.spread_px is None else predictor.spread_px**2
        claim = (predictor.x, predictor.y, variance, 0.0, variance)
        rows[int(memory[slots.REACTION_S] / setup.period_s) :, 3:] = claim
    out = np.empty((len(rows), len(loop.OUTPUTS)))
    return movement.Movement(out[: play(memory, rows, out, limits)])


def _in_the_loop(
    memory: FloatArray, guard: FloatArray, rows: FloatArray, pipeline: Pipeline
) -> movement.Movement:
    """Report by report: each goes through the pipeline, its prediction guides the next."""
    pipeline.reset()
    polls: list[tuple[float, ...]] = []
    way = UNGUIDED
    for noise_x, noise_y, late_s in rows[:, :3].tolist():
        polls.append(step(memory, (noise_x, noise_y, late_s, *way), guard))
        t, x, y, dx, dy, buttons = polls[-1][:6]
        if dx != 0.0 or dy != 0.0:
            way = way_to(pipeline.update(PointerEvent(t, x, y, dx, dy, int(buttons))), (0.0, 0.0))
        if polls[-1][PHASE] == slots.DONE:
            break
    return movement.Movement(np.array(polls, dtype=np.float64))
