"""A differentiator and a predictor, joined: events in, predictions out."""

from __future__ import annotations

from typing import Self

from pointpred.columns import BoolArray, EventColumns, FloatArray, PredictionColumns
from pointpred.compiled import law
from pointpred.differentiators import Differentiator
from pointpred.events import PointerEvent, Prediction
from pointpred.person import person_of
from pointpred.predictors import Predictor
from pointpred.predictors.predictor import PHASE


@law
def refused(motions: FloatArray, predictions: FloatArray) -> bool:
    """Whether a stage refused a row: the time of its motion, or the phase, is NaN."""
    for i in range(len(motions)):
        if motions[i, 0] != motions[i, 0] or predictions[i, PHASE] != predictions[i, PHASE]:
            return True
    return False


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

    def advance_all(self, begin: BoolArray, table: FloatArray) -> FloatArray | None:
        """``run`` in plain tables, for frames so short that records around them would be felt.

        ``None`` where a row is refused; nothing has changed then, and ``run`` says why.
        """
        stages = (self.differentiator, self.predictor)
        kept = [stage.remembered() for stage in stages]
        motions = self.differentiator.walk(begin, table)
        predictions = self.predictor.walk(begin, motions)
        if not refused(motions, predictions):
            return predictions
        for stage, memory in zip(stages, kept, strict=True):
            stage.recall(memory)
        return None

    @property
    def learns(self) -> bool:
        """Whether finished movements change what is said of the next: then only a new person starts fresh."""
        return bool(getattr(self.predictor, "learned", 0))

    @property
    def person(self) -> str:
        """What finished movements taught of the person, for ``build(name, person=...)``: printable ASCII.

        At most 4096 characters; "" while nobody is known, and always where nothing is learned or can be
        saved (`ktm`). The movement that goes on is not in it: ``reset`` finishes it.
        """
        return person_of(self.predictor)

    def reset(self) -> None:
        """Forget every event: the next one starts a movement. What is known of the person stays."""
        self.differentiator.reset()
        self.predictor.reset()

    def fresh(self) -> Self:
        """Return a pipeline with the same parameters and no memory, which knows nobody."""
        return type(self)(self.name, self.differentiator.fresh(), self.predictor.fresh())


def run(pipeline: Pipeline, columns: EventColumns) -> PredictionColumns:
    """Consume a table of events and return a row of predictions for each.

    A row is NaN but for ``t`` and the phase where ``update`` gives ``None``.

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
