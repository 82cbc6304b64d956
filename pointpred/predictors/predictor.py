"""The interface of all predictors: motions in, predictions or ``None`` out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, ClassVar

from pointpred.errors import EventError
from pointpred.predictors.mixture import Mixture
from pointpred.records import (
    BoolArray,
    Motion,
    MotionColumns,
    Place,
    Prediction,
    PredictionColumns,
    PredictionRow,
    TenFloats,
    motion_row,
    prediction_of,
    refusal,
    row_at,
)
from pointpred.scene import Scene
from pointpred.stage import CompiledStage, learn_nothing, loop_of


class Predictor(CompiledStage):
    """A ``Stage[Motion, Prediction | None]`` around a compiled ``step(memory, motion) -> prediction``.

    Both are rows: a ``MotionRow`` in, the floats of a ``PredictionRow`` out, with x NaN where nothing is
    justified and t NaN where the motion is refused. The loop over a table of motions is made of ``step``.
    """

    width = len(PredictionRow._fields)
    step: ClassVar[Callable[..., TenFloats]]
    follow: ClassVar[Callable[..., bool] | None] = None
    """The part of ``step`` that changes the memory, where a law has such a part: whether it accepts a motion.

    Of a table of which only the last row is answered, the other rows are only followed.
    """
    without_memory: ClassVar[Mapping[str, Any]] = {}
    """What to set so that it remembers neither where movements ended nor how far they went; {}: nothing.

    Scoring shows such a predictor a second time, without this memory.
    """
    joined: ClassVar[bool] = True
    """Whether it remembers nothing but its memory, so that what was before can be put back."""
    claims_time: ClassVar[bool] = True
    """False where no prediction says the time left: scoring then needs no clock to compare with."""

    def __init_subclass__(cls) -> None:
        """Make the loop over a table of motions around the class's own law."""
        super().__init_subclass__()
        if {"step", "conclude"} & vars(cls).keys() and "loop" not in vars(cls):
            conclude = cls.conclude if cls.conclude is not CompiledStage.conclude else learn_nothing
            cls.loop = staticmethod(loop_of(cls.step, row_at, conclude))

    def update(self, motion: Motion, /) -> Prediction | None:
        """Consume one motion and return the prediction after it, or ``None`` where none is justified.

        Raises EventError for a motion that is not finite or lies before the last; nothing is then changed.
        """
        try:
            row = motion_row(motion)
        except (TypeError, ValueError, OverflowError, AttributeError) as unusable:
            raise EventError(f"motion must be numbers, received {motion!r}") from unusable
        answer = self.advance(row)
        if answer[0] != answer[0]:
            raise refusal(row, answer)
        return prediction_of(answer)

    @property
    def known_places(self) -> tuple[Place, ...]:
        """Where movements of the person ended before, the likeliest destination first; most learn none."""
        return ()

    @property
    def mixture(self) -> Mixture | None:
        """What is known of the endpoint beyond one law; most predictors know one law only."""
        return None

    def enter(self, scene: Scene) -> None:
        """The next movement is in this window or page; without effect where no places are learned."""

    def run(self, motions: MotionColumns, begin: BoolArray) -> PredictionColumns:
        """Consume a table of motions; when a row is refused the error names it and nothing is consumed."""
        return PredictionColumns(self.walk_all(begin, motions.table))
