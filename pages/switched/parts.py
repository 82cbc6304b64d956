"""``switched-direction`` without one of its parts, where no parameter takes it away."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.compiled import law
from pointpred.predictors import SwitchedDirectionPredictor, submovement
from pointpred.records import BoolArray, FloatArray
from pointpred.registry import parameters

AXES = ((1, 3, 5), (2, 4, 6))
"""Columns of place, velocity and acceleration of x and of y in a table of motions."""


@law
def hold_after_peaks(
    motions: FloatArray, begin: BoolArray, rise: float, memory: FloatArray, answers: FloatArray
) -> None:
    """Replace what is answered after a sub-movement's peak by the answer at the peak."""
    peak = 0
    for i in range(len(motions)):
        x, y = motions[i, 1], motions[i, 2]
        if begin[i] or motions[i, 8] == 1.0:
            submovement.begin(memory, 0, x, y)
        speed = np.hypot(motions[i, 3], motions[i, 4])
        submovement.follow(memory, 0, rise, x, y, speed)
        if speed == memory[submovement.PEAK]:
            peak = i
        answers[i, 1], answers[i, 2] = answers[peak, 1], answers[peak, 2]


class _Whole(SwitchedDirectionPredictor):
    """The predictor with the registry's constants; a part of it for whole recordings only."""

    def __init__(self) -> None:
        super().__init__(**settings())

    def fresh(self) -> Any:
        """Another one: it remembers nothing between recordings."""
        return type(self)()


class Held(_Whole):
    """The doubled endpoint is held after the peak, as in the thesis's ballistic phase."""

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """A whole table of movements at once."""
        answers = super().walk(begin, rows)
        hold_after_peaks(rows, begin, settings()["rise"], np.zeros(submovement.STATES), answers)
        return answers


class AxisWise(_Whole):
    """The law for each axis on its own, with the axis' own sub-movements."""

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """A whole table of movements at once."""
        answers: list[FloatArray] = []
        for other in reversed(AXES):
            one = rows.copy()
            one[:, other] = 0.0
            answers.append(SwitchedDirectionPredictor(**settings()).walk(begin, one))
        answers[0][:, 2] = answers[1][:, 2]
        return answers[0]


def settings() -> dict[str, float]:
    """The constants that the registry builds with."""
    own = {parameter.name for parameter in SwitchedDirectionPredictor.parameters}
    return {name: value for name, (_, value) in parameters("switched-direction").items() if name in own}
