"""A differentiator and a predictor, joined: events in, predictions out."""

from __future__ import annotations

from typing import Self

from pointpred.columns import EventColumns, PredictionColumns
from pointpred.differentiators import Differentiator
from pointpred.events import PointerEvent, Prediction
from pointpred.predictors import Predictor


class Pipeline:
    """A ``Stage[PointerEvent, Prediction | None]``: the differentiator's motion feeds the predictor."""

    def __init__(self, name: str, differentiator: Differentiator, predictor: Predictor) -> None:
        self.name = name
        self.differentiator = differentiator
        self.predictor = predictor

    def update(self, event: PointerEvent, /) -> Prediction | None:
        """Consume one event; ``None`` where nothing is justified now.

        Raises EventOrderError when time runs backwards and EventError when a value is not finite or out of
        range; the pipeline is then unchanged.
        """
        kept = self.differentiator.remembered()  # it has moved on when the predictor refuses its motion
        motion = self.differentiator.consume(event)
        try:
            return self.predictor.consume(motion)
        except Exception:
            self.differentiator.recall(kept)
            raise

    def advance(
        self, t: float, x: float, y: float, dx: float, dy: float, buttons: float
    ) -> tuple[float, ...] | None:
        """``update`` in plain numbers, NaN for what is missing: a row of ``PredictionColumns``.

        ``None`` where the event is refused; nothing has changed then, and ``update`` says why.
        """
        kept = self.differentiator.remembered()
        motion = self.differentiator.advance(t, x, y, dx, dy, buttons)
        if motion[0] != motion[0]:
            return None
        try:
            return self.predictor.advance(motion)
        except Exception:
            self.differentiator.recall(kept)
            raise

    def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        self.differentiator.reset()
        self.predictor.reset()

    def fresh(self) -> Self:
        """Return a pipeline with the same parameters and no memory."""
        return type(self)(self.name, self.differentiator.fresh(), self.predictor.fresh())


def run(pipeline: Pipeline, columns: EventColumns) -> PredictionColumns:
    """Consume a table of events and return a row of predictions for each.

    A row is NaN but for ``t`` where ``update`` gives ``None``.

    Continues from the pipeline's memory, so chunks equal the whole; a row marked ``begin`` resets first.
    Raises EventOrderError or EventError naming the row; nothing is then consumed.
    """
    kept = pipeline.differentiator.remembered()
    motions = pipeline.differentiator.run(columns)
    try:
        return pipeline.predictor.run(motions, columns.begin)
    except Exception:
        pipeline.differentiator.recall(kept)
        raise
