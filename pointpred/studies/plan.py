"""What a participant does: the sequences of movements, in an order of their own."""

from __future__ import annotations

from itertools import product
from typing import Literal

import numpy as np
from msgspec import Struct

from pointpred.simulation.circle import positions
from pointpred.studies.design import Design, Task

Phase = Literal["practice", "test"]


class Sequence(Struct, frozen=True):
    """Movements under one condition: a click on the first place begins it, then each place follows in turn.

    ``places`` are centres of targets, px from the middle of the picture. ``width`` is the diameter on a
    circle; a bar has a ``height`` as well. Blocks count from 1, in practice and test apart. ``rest``: a break
    comes before it.
    """

    phase: Phase
    block: int
    task: Task
    distance: float
    width: float
    height: float | None
    movements: int
    places: list[tuple[float, float]]
    rest: bool = False


def plan_of(design: Design, participant: int) -> list[Sequence]:
    """The sequences of a participant, counted from 0."""
    blocks: list[tuple[Phase, int]] = [("practice", block + 1) for block in range(design.practice_blocks)]
    blocks += [("test", block + 1) for block in range(design.blocks)]
    conditions = list(product(design.tasks, design.distances_px, design.widths_px))
    plan = []
    for number, (phase, block) in enumerate(blocks):
        for place, index in enumerate(order_of(design, len(conditions), participant, number)):
            task, distance, width = conditions[index]
            circle = task == "circle"
            plan.append(
                Sequence(
                    phase,
                    block,
                    task,
                    distance,
                    width,
                    None if circle else design.bar_height_px,
                    design.movements,
                    circle_of(distance, design.movements) if circle else bars_of(distance),
                    rest=design.break_s > 0 and number > 0 and place == 0,
                )
            )
    return plan


def circle_of(distance: float, targets: int) -> list[tuple[float, float]]:
    """Targets on a circle in the order in which they are visited, each ``distance`` from the one before."""
    return [(x, y) for x, y in positions(distance, (0.0, 0.0), targets)]


def bars_of(distance: float) -> list[tuple[float, float]]:
    """Two bars, left and right."""
    return [(-distance / 2.0, 0.0), (distance / 2.0, 0.0)]


def order_of(design: Design, conditions: int, participant: int, block: int) -> list[int]:
    """The order of the conditions in a block, both counted from 0.

    Random orders follow from the seed, the participant and the block alone. In a Latin square each further
    block of a participant takes the next row.
    """
    if design.order == "random":
        shuffled = np.random.default_rng([design.seed, participant, block]).permutation(conditions)
        return [int(index) for index in shuffled]
    if design.order == "as-written":
        return list(range(conditions))
    return latin_row(conditions, participant + block)


def latin_row(conditions: int, row: int) -> list[int]:
    """A row of a balanced Latin square (Williams 1949): each condition follows every other equally often.

    There are as many rows as conditions, twice as many where their number is odd; then they begin anew.

    >>> [latin_row(4, row) for row in range(4)]
    [[0, 1, 3, 2], [1, 2, 0, 3], [2, 3, 1, 0], [3, 0, 2, 1]]
    """
    first = [(index + 1) // 2 if index % 2 else -(index // 2) for index in range(conditions)]
    order = [(step + row) % conditions for step in first]
    return order[::-1] if conditions % 2 and (row // conditions) % 2 else order
