"""The multidirectional task of ISO 9241-411: targets on a circle, visited across it."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from math import cos, pi, sin

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.parameter import Parameter, check
from pointpred.recording import Provenance, Recording, Trial
from pointpred.records import EventColumns
from pointpred.simulation import movement
from pointpred.simulation.person import Person, people
from pointpred.transfer import ConstantGain, SigmoidGain, TransferFunction

TARGETS = 13
MM_PER_INCH = 25.4
FUNCTIONS: dict[str, TransferFunction] = {"sigmoid": SigmoidGain(), "constant": ConstantGain(4.0)}
"""The two functions of the thesis's experiment (section 2.6.1)."""
BOUNDS = (
    Parameter("trials", "", 1, TARGETS - 1, "movements a circle"),
    Parameter("distance_mm", "mm", 5.0, 1e4, "between successive targets"),
    Parameter("width_mm", "mm", 0.5, 1e3, "of a target"),
)
SETUP = movement.Setup(FUNCTIONS["constant"])


class Condition(msgspec.Struct, frozen=True):
    """A circle's condition: distance between successive targets and their width in mm, the function."""

    distance_mm: float
    width_mm: float
    transfer: str


THESIS_CONDITIONS = tuple(
    Condition(distance, width, transfer)
    for distance, width, transfer in itertools.product((150.0, 75.0), (7.0, 2.0), FUNCTIONS)
)


def positions(distance_px: float, centre: tuple[float, float], targets: int = TARGETS) -> list[list[float]]:
    """The targets' centres (px) in the order of the visits; successive ones are ``distance_px`` apart.

    The number of targets is odd, so that steps of half a turn visit them all.

    >>> places = np.array(positions(100.0, (0.0, 0.0)))
    >>> [round(float(d), 6) for d in np.hypot(*np.diff(places, axis=0).T)][:2], len(places)
    ([100.0, 100.0], 13)
    """
    check((Parameter("targets", "", 3, 101, "on the circle"),), {"targets": targets})
    if targets % 2 == 0:
        raise ParameterError(
            f"targets must be odd, so that the order across visits all, received {targets}", field="targets"
        )
    radius = distance_px / (2.0 * cos(pi / (2 * targets)))
    angles = [2.0 * pi * ((k * (targets // 2 + 1)) % targets) / targets for k in range(targets)]
    return [[centre[0] + radius * sin(a), centre[1] - radius * cos(a)] for a in angles]


def simulate_circle(
    persons: Iterable[Person],
    conditions: Sequence[Condition] = THESIS_CONDITIONS,
    *,
    seed: int = 0,
    trials: int = TARGETS - 1,
    setup: movement.Setup = SETUP,
    centre: tuple[float, float] = (960.0, 540.0),
    idle_reports: bool = False,
    name: str = "simulated circle",
) -> Recording:
    """Every person does every condition: a circle of 13 targets, ``trials`` movements each.

    Each movement starts where the last one ended; each circle starts at the next target of the order. A trial
    begins at a button release and ends after the click on its target, so the press lies some 80 ms before the
    last event. ``setup.transfer`` is replaced by the condition's function. ``idle_reports`` keeps the polls
    in which nothing happened.

    Assumes no lost polls and a screen without edges. The same seed gives the same recording; a person's
    trials do not depend on the other people. Raises ParameterError.
    """
    check(BOUNDS[:1], {"trials": trials})
    for condition in conditions:
        check(BOUNDS[1:], {"distance_mm": condition.distance_mm, "width_mm": condition.width_mm})
        _function(condition.transfer)
    parts: list[EventColumns] = []
    labels: list[Trial] = []
    for person in persons:
        for number, condition in enumerate(conditions):
            generator = np.random.default_rng([seed, 2, *person.name.encode(), number])
            chosen = msgspec.structs.replace(setup, transfer=_function(condition.transfer))
            px = setup.dpi / MM_PER_INCH
            width = condition.width_mm * px
            places = positions(condition.distance_mm * px, centre)
            first = number * trials % TARGETS
            x, y = (float(round(value)) for value in places[first])
            for trial in range(trials):
                target = places[(first + trial + 1) % TARGETS]
                aim = movement.Aim(target[0] - x, target[1] - y, width)
                moved = movement.move(person, chosen, aim, generator)
                parts.append(moved.events((x, y), idle_reports=idle_reports))
                labels.append(_label(person, condition, number * trials + trial, target, width))
                x, y = (float(value) for value in parts[-1].table[-1, 1:3])
    provenance = Provenance("simulated", dpi=setup.dpi, cpi=setup.cpi, simulated=True)
    return Recording.of(name, parts, labels, provenance=provenance)


def thesis_setup(seed: int = 0) -> Recording:
    """The thesis's experiment with simulated people: 10 people x 2 distances x 2 widths x 2 functions x 12.

    960 trials at 1 kHz and 2000 counts per inch. The screen has 96 px per inch, so distances are 567 and
    283 px; the thesis reports 265 to 800 px without its screen.
    """
    return simulate_circle(people(10, seed), seed=seed, name="simulated circle, 10 people")


def _function(name: str) -> TransferFunction:
    if name not in FUNCTIONS:
        raise ParameterError(f"transfer must be one of {', '.join(FUNCTIONS)}, received {name!r}")
    return FUNCTIONS[name]


def _label(person: Person, condition: Condition, number: int, target: Sequence[float], width: float) -> Trial:
    return Trial(
        user=person.name,
        trial=str(number),
        target_x=round(target[0], 3),
        target_y=round(target[1], 3),
        target_w=round(width, 3),
        condition={
            "distance_mm": condition.distance_mm,
            "width_mm": condition.width_mm,
            "transfer": condition.transfer,
            "skill": round(float(person.traits.skill), 3),
        },
    )
