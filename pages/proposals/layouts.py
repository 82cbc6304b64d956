"""Layouts of a page, laid so that a recorded movement ends in one of their targets."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pointpred.records import FloatArray
from pointpred.targets import Target

Layout = Callable[[np.random.Generator], list[Target]]
EFFECTIVE, EDGE = 4.133, 0.49
"""People aim at centres with a deviation of the width over the first, here within the second of it."""
TRIES = 50


def cards(generator: np.random.Generator) -> list[Target]:
    """Eight cards of 200 x 142 px in two rows, 24 px apart."""
    return [Target(i, 224.0 * (i % 4), 166.0 * (i // 4), 200.0, 142.0) for i in range(8)]


def links(generator: np.random.Generator) -> list[Target]:
    """Links of 50 to 150 px in six lines of text, 40 to 160 px apart."""
    targets: list[Target] = []
    for line in range(6):
        x = 0.0
        while True:
            x, width = x + generator.uniform(40.0, 160.0), generator.uniform(50.0, 150.0)
            if x + width > 640.0:
                break
            targets.append(Target(len(targets), x, 26.0 * line, width, 20.0))
            x += width
    return targets


def menu(generator: np.random.Generator) -> list[Target]:
    """Twenty rows of 180 x 24 px without a gap."""
    return [Target(i, 0.0, 24.0 * i, 180.0, 24.0) for i in range(20)]


LAYOUTS: dict[str, Layout] = {"cards": cards, "links": links, "menu": menu}


def placed(
    layout: Layout, start: FloatArray, end: FloatArray, generator: np.random.Generator
) -> tuple[list[Target], int] | None:
    """The targets, and the place of the one that the movement ends in; it does not start in that one.

    ``None`` where no such place was found.
    """
    for _ in range(TRIES):
        targets = layout(generator)
        right = int(generator.integers(len(targets)))
        goal = targets[right]
        size = np.array([goal.width, goal.height])
        off = np.clip(generator.normal(0.0, size / EFFECTIVE), -EDGE * size, EDGE * size)
        dx, dy = (end - off - (goal.x + 0.5 * goal.width, goal.y + 0.5 * goal.height)).tolist()
        moved = [Target(one.id, one.x + dx, one.y + dy, one.width, one.height) for one in targets]
        goal = moved[right]
        x, y = (start - (goal.x, goal.y)).tolist()
        if not (0.0 <= x <= goal.width and 0.0 <= y <= goal.height):
            return moved, right
    return None
