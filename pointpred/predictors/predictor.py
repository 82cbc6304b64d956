"""What all predictors share: motions in, predictions or ``None`` out."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import msgspec
import numpy as np

from pointpred.columns import BoolArray, MotionColumns, PredictionColumns, prediction_of
from pointpred.errors import EventError
from pointpred.events import Motion, Prediction
from pointpred.stage import CompiledStage

NONE = float("nan")
REFUSED = (NONE, NONE, NONE, NONE, NONE, NONE, NONE)
"""What a step returns for a motion it refuses: even the phase is NaN; its memory is then unchanged."""

PHASE = 7
CLAIMS = 9
"""What a step returns that also claims a tail or a spread of the remaining time."""


class Predictor(CompiledStage):
    """A ``Stage[Motion, Prediction | None]`` around a compiled law.

    ``step(memory, t, x, y, vx, vy, ax, ay, settled, start)`` returns (x, y, sxx, sxy, syy, remaining_s,
    phase), and after them (tail, remaining_spread) if it claims either; x is NaN where nothing is justified,
    the phase is NaN where the motion is refused.
    """

    width = 10
    step: ClassVar[Callable[..., tuple[float, ...]]]

    def update(self, motion: Motion, /) -> Prediction | None:
        """Consume one motion and return the prediction after it, or ``None`` where none is justified.

        Raises EventError for a motion that is not finite or lies before the last; nothing is then changed.
        """
        try:
            row = tuple(map(float, msgspec.structs.astuple(motion)))
        except (TypeError, ValueError, OverflowError) as unusable:
            raise EventError(f"motion must be numbers, received {motion!r}") from unusable
        return self.consume(row)

    def consume(self, row: tuple[float, ...]) -> Prediction | None:
        """``update`` for a motion that is still the plain row a differentiator made."""
        answer = self.advance(row)
        return prediction_of(answer[0], answer[1:])

    def advance(self, row: tuple[float, ...]) -> tuple[float, ...]:
        """``consume``, with the prediction as a row of ``PredictionColumns``."""
        t, x, y, vx, vy, ax, ay, settled, start, _ = row
        values = type(self).step(self._memory, t, x, y, vx, vy, ax, ay, settled, start)
        if values[6] == values[6] and len(values) != CLAIMS:
            return (t, *values, NONE, NONE)  # ``accepted``, without the call: this runs for every event
        return self.accepted(row, values)

    def accepted(self, row: tuple[float, ...], values: tuple[float, ...]) -> tuple[float, ...]:
        """What a step returned as a row of ``PredictionColumns``; raises EventError where it refused."""
        if values[6] != values[6]:
            raise EventError(f"motion must be finite and not before the last one, received {row!r}")
        return (row[0], *values) if len(values) == CLAIMS else (row[0], *values, NONE, NONE)

    def run(self, motions: MotionColumns, begin: BoolArray) -> PredictionColumns:
        """Consume a table of motions; when a row is refused the error names it and nothing is consumed."""
        kept = self._memory.copy()
        table = self.walk(begin, motions.table)
        refused = np.isnan(table[:, PHASE])
        if refused.any():
            self._memory = kept
            row = int(refused.argmax())
            raise EventError(f"row {row}: motion must be finite and not before the last one")
        return PredictionColumns(table)
