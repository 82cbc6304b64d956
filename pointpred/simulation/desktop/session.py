"""A recording of people who work on a simulated desktop, and what a program on it would know."""

from __future__ import annotations

from collections.abc import Iterable
from math import nan

import msgspec
import numpy as np

from pointpred.errors import DivergenceError
from pointpred.parameter import Parameter, check
from pointpred.recording import Provenance, Recording, Trial
from pointpred.records import EventColumns, FloatArray
from pointpred.simulation import movement, plan
from pointpred.simulation.desktop.scenario import named
from pointpred.simulation.desktop.windows import SCREEN_PX
from pointpred.simulation.desktop.worker import Step, Worker, aim_at, place_of
from pointpred.simulation.person import Person
from pointpred.transfer import ConstantGain

SETUP = plan.Setup(ConstantGain(4.0))
FARTHEST_PX = 1e5
"""A cursor farther from the screen's corner has run away."""
BOUNDS = (
    Parameter("movements", "", 2, 100_000, "of each person", whole=True),
    Parameter("seed", "", 0, 2**32 - 1, "of the generators", whole=True),
)


class DesktopSession(msgspec.Struct, frozen=True):
    """Sessions of several people on a desktop, and the number of the first movement after the change.

    ``change`` counts each person's movements from 0; ``None`` where nothing changes. The window in front at a
    movement's start and its upper left corner, which the program of that window knows, stand in the trial's
    ``condition`` as ``window``, ``window_x`` and ``window_y``, so that a file keeps them, too.
    """

    recording: Recording
    change: int | None

    @property
    def keys(self) -> tuple[str, ...]:
        """The window in front at each movement's start."""
        return tuple(str(trial.condition["window"]) for trial in self.recording.trials)

    @property
    def origins(self) -> FloatArray:
        """The upper left corner of that window on the screen, px: (movements, 2)."""
        corners = [
            [float(trial.condition[name]) for name in ("window_x", "window_y")]
            for trial in self.recording.trials
        ]
        return np.array(corners).reshape(-1, 2)


def simulate_desktop(
    persons: Iterable[Person],
    scenario: str = "steady",
    *,
    seed: int = 0,
    movements: int = 120,
    change: int | None = None,
    setup: plan.Setup = SETUP,
    idle_reports: bool = False,
    name: str | None = None,
) -> DesktopSession:
    """Every person works through a session of ``movements`` movements, each starting where the last ended.

    Windows, their controls and the person's habits are drawn for each person. Of the movements 20 to 40 %
    (another share for each person) are free clicks; the others follow sequences of controls, of which the
    k-th is chosen with weight 1/k. Scenarios: ``steady``, nothing changes; ``moved``, the window stands
    elsewhere from the movement ``change`` on (default: half of them); ``habits``, other controls and
    sequences from there on; ``menus``, menus open at the cursor; ``windows``, three windows, one in front.
    Until the change a person's movements are the same in the first three.

    Assumes no lost polls, a screen without edges, and people as ``simulate_circle`` has them: they do not
    tire or learn, and a changed desktop does not slow them down. How often places repeat is a choice made
    here, not a measurement. A trial's target is its control's centre and smaller side, unknown for free
    clicks; ``condition`` names the scenario, the control, the window (``DesktopSession``) and the skill, and
    ``changed`` is 1 from the change on.

    Parameters: ``movements`` in [2, 100000]; ``change`` in [1, movements - 1]; ``seed`` a whole number >= 0.
    The same seed gives the same session; a person's movements do not depend on the other people.
    With a gain that grows with the speed, such as ``SigmoidGain``, the corrections of a movement in some
    10,000 grow without end: DivergenceError names it. Raises ParameterError.

    >>> from pointpred.simulation import people
    >>> session = simulate_desktop(people(1), "moved", movements=4)
    >>> session.change, session.keys[0], len(np.unique(session.origins, axis=0))
    (2, 'window 0', 2)
    """
    chosen = named(scenario)
    check(BOUNDS, {"movements": movements, "seed": seed})
    first_after = movements // 2 if change is None else change
    bound = Parameter("change", "", 1, movements - 1, "the first movement after the change", whole=True)
    check((bound,), {"change": first_after})
    parts: list[EventColumns] = []
    labels: list[Trial] = []
    for person in persons:
        who = person.name.encode()
        worker = Worker(chosen, np.random.default_rng([seed, 3, *who]))
        cursor = SCREEN_PX[0] / 2, SCREEN_PX[1] / 2
        for number in range(movements):
            if chosen.changes and number == first_after:
                worker.change()
            generator = np.random.default_rng([seed, 4, number, *who])
            step = worker.step(generator)
            condition: dict[str, str | float] = {
                "scenario": scenario,
                "changed": float(chosen.changes and number >= first_after),
            }
            labels.append(_label(person, number, step, place_of(step, cursor), condition))
            parts.append(_move(person, setup, step, cursor, generator, idle_reports))
            x, y = parts[-1].table[-1, 1:3]
            cursor = float(x), float(y)
    provenance = Provenance("simulated", dpi=setup.dpi, cpi=setup.cpi, simulated=True)
    title = f"simulated desktop, {scenario}" if name is None else name
    recording = Recording.of(title, parts, labels, provenance=provenance)
    return DesktopSession(recording, first_after if chosen.changes else None)


def _move(
    person: Person,
    setup: plan.Setup,
    step: Step,
    cursor: tuple[float, float],
    generator: np.random.Generator,
    idle_reports: bool,
) -> EventColumns:
    """The events of one movement from the cursor to the step's control."""
    x, y = place_of(step, cursor)
    off_x, off_y, precision = aim_at(step.control, generator)
    aim = plan.Aim(x + off_x - cursor[0], y + off_y - cursor[1], precision)
    events = movement.move(person, setup, aim, generator).events(cursor, idle_reports=idle_reports)
    if np.abs(events.table[:, 1:3]).max() > FARTHEST_PX:
        raise DivergenceError(
            f"{person.name} overshoots {step.control.name!r} more with every correction, until the cursor is "
            f"over {FARTHEST_PX:g} px away; take a setup with ConstantGain, or another seed"
        )
    return events


def _label(
    person: Person,
    number: int,
    step: Step,
    place: tuple[float, float],
    condition: dict[str, str | float],
) -> Trial:
    control, window = step.control, step.window
    x, y, width = (nan, nan, nan) if control.area else (*place, min(control.width, control.height))
    return Trial(
        user=person.name,
        trial=str(number),
        target_x=round(x, 3),
        target_y=round(y, 3),
        target_w=round(width, 3),
        condition={
            **condition,
            "control": control.name,
            "window": window.key,
            "window_x": window.x,
            "window_y": window.y,
            "skill": round(person.skill, 3),
        },
    )
