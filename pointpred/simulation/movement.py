"""One simulated movement: a person, a device and a target in, every report with the truth out."""

from __future__ import annotations

from math import nan

import msgspec
import numpy as np

from pointpred.pipeline import Pipeline
from pointpred.records import EventColumns, FloatArray, PointerEvent
from pointpred.simulation import loop, plan, sensor, slots
from pointpred.simulation.person import Person

PHASE = loop.OUTPUTS.index("phase")


class Movement(msgspec.Struct, frozen=True):
    """One row per poll (``loop.OUTPUTS``; px from the start) from before the movement to after the click."""

    table: FloatArray

    def column(self, name: str) -> FloatArray:
        """One of ``loop.OUTPUTS``."""
        return np.asarray(self.table[:, loop.OUTPUTS.index(name)])

    @property
    def click_s(self) -> float:
        """Time of the button press."""
        return float(self.table[np.argmax(self.column("buttons") == 1.0), 0])

    @property
    def pieces(self) -> int:
        """The true number of ballistic pieces."""
        ballistic = self.column("phase") == slots.BALLISTIC
        return len(np.unique(self.column("number")[ballistic]))

    def events(self, start: tuple[float, float] = (0.0, 0.0), *, idle_reports: bool = False) -> EventColumns:
        """The events as recorded, with the cursor starting at ``start``."""
        first = np.array([[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]])
        table = np.concatenate([first, self.table[:, :6]])
        table[:, 1:3] += start
        return sensor.reported(table, idle_reports)


def move(
    person: Person,
    setup: plan.Setup,
    aim: plan.Aim,
    generator: np.random.Generator,
    endpoint: tuple[float, float] | None = None,
) -> Movement:
    """Play one movement towards ``aim``; all chance comes from the generator.

    ``endpoint`` (px from the start), with ``setup.rho`` > 0, is the estimate to which an assisted transfer
    function pulls the cursor, available from the hand's start.
    """
    memory, rows = prepare(person, setup, aim, generator)
    if endpoint is not None:
        rows[int(memory[slots.REACTION_S] / setup.period_s) :, 3:] = endpoint
    out = np.empty((len(rows), len(loop.OUTPUTS)))
    return Movement(out[: loop.play(memory, rows, out)])


def move_assisted(
    person: Person, setup: plan.Setup, aim: plan.Aim, generator: np.random.Generator, pipeline: Pipeline
) -> Movement:
    """``move`` with a predictor in the loop: each report goes through the pipeline.

    The pipeline is reset first. Runs report by report, so it is some hundred times slower than ``move``.
    """
    memory, rows = prepare(person, setup, aim, generator)
    pipeline.reset()
    polls: list[tuple[float, ...]] = []
    hat = (nan, nan)
    for noise_x, noise_y, late_s, _, _ in rows.tolist():
        polls.append(loop.step(memory, (noise_x, noise_y, late_s, *hat)))
        t, x, y, dx, dy, buttons = polls[-1][:6]
        if dx != 0.0 or dy != 0.0:
            prediction = pipeline.update(PointerEvent(t, x, y, dx, dy, int(buttons)))
            hat = (nan, nan) if prediction is None else (prediction.x, prediction.y)
        if polls[-1][PHASE] == slots.DONE:
            break
    return Movement(np.array(polls, dtype=np.float64))


def prepare(
    person: Person, setup: plan.Setup, aim: plan.Aim, generator: np.random.Generator
) -> tuple[FloatArray, FloatArray]:
    """The memory of the trial and one row of chance per poll, without an estimated endpoint."""
    memory = plan.memory(person, setup, aim, generator)
    longest_s = plan.PATIENCE_S + memory[slots.VERIFY_S] + memory[slots.PRESS_S]
    rows = np.full((int(longest_s / setup.period_s) + 8, len(loop.INPUTS)), nan)
    rows[:, :2] = generator.standard_normal((len(rows), 2))
    rows[:, 2] = sensor.lateness(generator, len(rows))
    return memory, rows
