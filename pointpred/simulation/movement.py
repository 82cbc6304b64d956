"""One simulated movement: a person, a device and a target in, every report with the truth out."""

from __future__ import annotations

from math import inf, nan

import msgspec
import numpy as np

from pointpred.pipeline import Pipeline
from pointpred.records import METRES_PER_INCH, BoolArray, EventColumns, FloatArray, PointerEvent
from pointpred.simulation import loop
from pointpred.simulation.loop import Memory
from pointpred.simulation.person import Person, Traits
from pointpred.simulation.plan import FURTHER_PIECE, PATIENCE_S, Draws, plan
from pointpred.transfer import TransferFunction

SUBSTEPS = 2
MEAN_LATE_S = 60e-6
MOST_LATE_S = 0.8e-3
"""Largest delay of a stamp after its poll, s; delays are exponential with mean ``MEAN_LATE_S``."""
STAMP_S = 2.0**-17
"""Stamps are whole ticks of a clock at 131072 Hz (7.6 us): exact as floats, and small in a file."""


class Setup(msgspec.Struct, frozen=True):
    """The device and the screen: counts per inch, px per inch, seconds between polls.

    ``rho`` (1/s) above 0 makes the transfer function an assisted one; ``strength`` bounds its pull to a share
    of the hand's own motion, infinite as printed in Remark 2.2.1.
    """

    transfer: TransferFunction
    cpi: float = 2000.0
    dpi: float = 96.0
    period_s: float = 0.001
    rho: float = 0.0
    strength: float = inf


class Aim(msgspec.Struct, frozen=True):
    """A target relative to the start of the trial: centre and width, px."""

    x: float
    y: float
    width: float

    @property
    def distance(self) -> float:
        """To the centre, px."""
        return float(np.hypot(self.x, self.y))


def planned_memory(person: Person, setup: Setup, aim: Aim, generator: np.random.Generator) -> Memory:
    """The memory of one trial: setup, person and a plan drawn from the generator; the state is zero."""
    memory = Memory(np.zeros(Memory.length))
    settings = memory.settings
    settings.period_s = setup.period_s
    settings.substeps = SUBSTEPS
    settings.px_per_metre = setup.dpi / METRES_PER_INCH
    settings.metres_per_count = METRES_PER_INCH / setup.cpi
    settings.rho, settings.strength = setup.rho, setup.strength
    settings.function.memory[:] = setup.transfer.slots
    traits = person.traits
    plan(settings, traits, _drawn(traits, generator), aim.x, aim.y, aim.width)
    settings.delay_s = min(traits.delay_s, (loop.RING_ROWS - 1) * setup.period_s)
    return memory


def _drawn(traits: Traits, generator: np.random.Generator) -> Draws:
    """The chance in a plan, from a generator of numpy."""
    draws = Draws(np.zeros(Draws.length))
    draws.memory[:7] = generator.standard_normal(7)
    count = 1
    if generator.uniform() >= traits.one_piece:
        count = 2 + int(generator.binomial(loop.PIECES_MOST - 2, FURTHER_PIECE * (1.0 - traits.skill)))
    draws.count = count
    for number, piece in enumerate(draws.pieces[:count]):
        last = number == count - 1
        piece.share = generator.standard_normal() if last else generator.uniform()
        piece.memory[1:5] = generator.standard_normal(4)
        piece.until = generator.uniform()
        if not last:
            piece.pause = generator.standard_exponential()
    return draws


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
        ballistic = self.column("phase") == loop.BALLISTIC
        return len(np.unique(self.column("number")[ballistic]))

    def events(self, start: tuple[float, float] = (0.0, 0.0), *, idle_reports: bool = False) -> EventColumns:
        """The events as recorded, with the cursor starting at ``start``."""
        first = np.array([[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]])
        table = np.concatenate([first, self.table[:, :6]])
        table[:, 1:3] += start
        return reported(table, idle_reports)


def move(
    person: Person,
    setup: Setup,
    aim: Aim,
    generator: np.random.Generator,
    endpoint: tuple[float, float] | None = None,
) -> Movement:
    """Play one movement towards ``aim``; all chance comes from the generator.

    ``endpoint`` (px from the start), with ``setup.rho`` > 0, is the estimate to which an assisted transfer
    function pulls the cursor, available from the hand's start.
    """
    memory, rows = prepare(person, setup, aim, generator)
    if endpoint is not None:
        rows[int(memory.settings.reaction_s / setup.period_s) :, 3:] = endpoint
    out = np.empty((len(rows), len(loop.OUTPUTS)))
    return Movement(out[: loop.play(memory.memory, rows, out)])


def move_assisted(
    person: Person, setup: Setup, aim: Aim, generator: np.random.Generator, pipeline: Pipeline
) -> Movement:
    """``move`` with a predictor in the loop: each report goes through the pipeline.

    The pipeline is reset first. Runs report by report, so it is some hundred times slower than ``move``.
    """
    memory, rows = prepare(person, setup, aim, generator)
    pipeline.reset()
    polls: list[tuple[float, ...]] = []
    hat = (nan, nan)
    for noise_x, noise_y, late_s, _, _ in rows.tolist():
        polls.append(loop.step(memory.memory, (noise_x, noise_y, late_s, *hat)))
        t, x, y, dx, dy, buttons = polls[-1][:6]
        if dx != 0.0 or dy != 0.0:
            prediction = pipeline.update(PointerEvent(t, x, y, dx, dy, int(buttons)))
            hat = (nan, nan) if prediction is None else (prediction.x, prediction.y)
        if polls[-1][PHASE] == loop.DONE:
            break
    return Movement(np.array(polls, dtype=np.float64))


def prepare(
    person: Person, setup: Setup, aim: Aim, generator: np.random.Generator
) -> tuple[Memory, FloatArray]:
    """The memory of the trial and one row of chance per poll, without an estimated endpoint."""
    memory = planned_memory(person, setup, aim, generator)
    longest_s = PATIENCE_S + memory.settings.verify_s + memory.settings.press_s
    rows = np.full((int(longest_s / setup.period_s) + 8, len(loop.INPUTS)), nan)
    rows[:, :2] = generator.standard_normal((len(rows), 2))
    rows[:, 2] = lateness(generator, len(rows))
    return memory, rows


def lateness(generator: np.random.Generator, reports: int) -> FloatArray:
    """How late each report is stamped (s): exponential, bounded."""
    return np.asarray(np.minimum(generator.exponential(MEAN_LATE_S, reports), MOST_LATE_S))


def reported(polls: FloatArray, idle_reports: bool) -> EventColumns:
    """The polls that make an event: the first, motion, a change of a button; all with ``idle_reports``."""
    table = polls.copy()
    table[:, 0] = np.round(table[:, 0] / STAMP_S) * STAMP_S
    if idle_reports:
        return EventColumns(table)
    events: BoolArray = (table[:, 3] != 0.0) | (table[:, 4] != 0.0)
    events[1:] |= np.diff(table[:, 5]) != 0.0
    events[:1] = True
    return EventColumns(table[events])
