"""A differentiator and a predictor, joined: events in, predictions out."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, Self

import numpy as np

from pointpred.compiled import law
from pointpred.differentiators import Differentiator, HomogeneousDifferentiator
from pointpred.differentiators.differentiator import checked_event_row
from pointpred.errors import EventError
from pointpred.joint import joint_of, joint_sharing, last_of
from pointpred.mixtures.mixture import Mixture
from pointpred.person import person_of
from pointpred.predictors import Predictor
from pointpred.records import (
    REFUSED,
    BoolArray,
    EventColumns,
    FloatArray,
    Place,
    PointerEvent,
    Prediction,
    PredictionColumns,
    Row,
    TenFloats,
    prediction_of,
)
from pointpred.scene import scene


@law
def has_refusal(rows: FloatArray) -> bool:
    """Whether a stage refused a row: its time is NaN."""
    count = 0  # refusals are rare: an early exit gains nothing, and ruff would turn it into any() (SIM110)
    for i in range(len(rows)):
        count += 1 if rows[i, 0] != rows[i, 0] else 0
    return count > 0


class Pipeline:
    """A ``Stage[PointerEvent, Prediction | None]``: the differentiator's motion feeds the predictor.

    ``advance`` takes one row, through both laws in one compiled call, and ``advance_all`` a table; ``update``
    and ``run`` do the same for records and columns. Where an event is refused, nothing has changed.
    """

    def __init__(self, name: str, differentiator: Differentiator, predictor: Predictor) -> None:
        self.name = name
        self.differentiator = differentiator
        self.predictor = predictor
        self._joint: Callable[..., TenFloats] | None = None
        self._last: Callable[..., Row] | None = None

    def update(self, event: PointerEvent, /) -> Prediction | None:
        """Consume one event; ``None`` where nothing is justified now.

        Raises EventOrderError when time runs backwards and EventError when a value is not finite or out of
        range; the pipeline is then unchanged.
        """
        answer = self.advance(checked_event_row(event))
        if answer is None:
            raise self._reason(lambda: self.predictor.update(self.differentiator.update(event)))
        return prediction_of(answer)

    def sense(self, t: float, ax: float, ay: float, az: float) -> None:
        """Consume one sample of an accelerometer on the device, before the events that come after it.

        Time in s on the clock of the events, as well as it is known; specific force in m/s^2 along the axes
        of the sensor. Without effect where the differentiator uses no acceleration. Raises EventError for
        what is no number within its bounds, and EventOrderError where the time runs backwards against the
        sample before; the pipeline is then unchanged.
        """
        self.differentiator.sense(t, ax, ay, az)

    def advance(self, row: Row) -> TenFloats | None:
        """``update`` in rows: an ``EventRow`` in, the floats of a ``PredictionRow`` out.

        ``None`` where the event is refused; nothing has changed then, and ``update`` says why.
        """
        first, second = self.differentiator, self.predictor
        joint = self._joint or self._bind()
        answer = joint(first._memory, second._memory, row)
        return answer if answer[0] == answer[0] else None

    def joint(self) -> Callable[..., TenFloats]:
        """Both laws as one."""
        join = joint_sharing if self.predictor.shared else joint_of
        return join(type(self.differentiator).step, type(self.predictor).step, self._compiled)

    def _bind(self) -> Callable[..., TenFloats]:
        """The joint law with what is shared; not before an event comes: one for tables only has no law."""
        shared = self.predictor.shared
        self._joint = partial(self.joint(), *shared) if shared else self.joint()
        return self._joint

    @property
    def _compiled(self) -> bool:
        """Whether both laws are compiled as one."""
        return self.predictor.joint_compiled and isinstance(self.differentiator, HomogeneousDifferentiator)

    def advance_last(self, table: FloatArray) -> Row | None:
        """``advance_all`` of at least one row where only the last answer is wanted, bit for bit the same."""
        last = self._last or self._bind_last()
        answer = last(self.differentiator._memory, self.predictor._memory, table, *self.predictor.shared)
        return answer if answer[0] == answer[0] else None

    def last(self) -> Callable[..., Row] | None:
        """Both laws as one over a table; ``None`` where they are not compiled as one."""
        second = type(self.predictor)
        return last_of(type(self.differentiator).step, second.step, second.follow) if self._compiled else None

    def _bind_last(self) -> Callable[..., Row]:
        self._last = self.last() or self._walk_to_last
        return self._last

    def _walk_to_last(self, memory: FloatArray, other: FloatArray, table: FloatArray, *_: FloatArray) -> Row:
        answers = self.advance_all(np.zeros(len(table), np.bool_), table)
        return REFUSED if answers is None else tuple(answers[-1].tolist())

    def __getstate__(self) -> dict[str, Any]:
        """Everything but the compiled laws, which are made again."""
        return {**self.__dict__, "_joint": None, "_last": None}

    def advance_all(self, begin: BoolArray, table: FloatArray) -> FloatArray | None:
        """``advance`` over a table, resetting before each row marked ``begin``.

        ``None`` where a row is refused; nothing has changed then, and ``run`` says why.
        """
        return self._predict_all(begin, lambda: self.differentiator.walk(begin, table))

    def _predict_all(self, begin: BoolArray, motions: Callable[[], FloatArray]) -> FloatArray | None:
        """The answers to what the differentiator makes of a table; ``None`` where a row is refused."""
        stages = (self.differentiator, self.predictor)
        memories = [stage.remembered() for stage in stages]
        answers: FloatArray | None = None
        try:
            answers = self.predictor.walk(begin, motions())
            if has_refusal(answers):
                answers = None
        finally:
            if answers is None:
                for stage, memory in zip(stages, memories, strict=True):
                    stage.recall(memory)
        return answers

    def advance_columns(self, columns: EventColumns) -> FloatArray | None:
        """``advance_all`` with the samples of an accelerometer that stand beside the events."""
        return self._predict_all(columns.begin, lambda: self.differentiator.walk_events(columns))

    def refusal(self, columns: EventColumns) -> EventError:
        """Why ``advance_columns`` refuses a table of events; it names the row."""
        return self._reason(lambda: self.predictor.run(self.differentiator.run(columns), columns.begin))

    def _reason(self, attempt: Callable[[], object]) -> EventError:
        """Why the stages refuse what was attempted; they are afterwards as they were."""
        memory = self.differentiator.remembered()
        try:
            attempt()
        except EventError as reason:
            return reason
        finally:
            self.differentiator.recall(memory)
        raise AssertionError("the stages take one by one what the pipeline refused")

    @property
    def learns(self) -> bool:
        """Whether finished movements change what is said of the next: then only a new person starts fresh."""
        return bool(self.predictor.learned or self.differentiator.learned)

    @property
    def person(self) -> str:
        """What finished movements taught of the person, for ``build(name, person=...)``: printable ASCII.

        At most 16384 characters; "" while nobody is known, and always where nothing is learned or can be
        saved (`ktm`). The movement that goes on is not in it: ``reset`` finishes it.
        """
        return person_of(self.predictor)

    @property
    def places(self) -> tuple[Place, ...]:
        """Where movements of this person ended before, the likeliest destination first; at most 64.

        Those of the window or page that ``enter`` named. Before a movement has begun ``p`` is ``before``,
        for a movement from where the last one ended. Empty where the predictor learns no places.

        >>> from pointpred import build
        >>> build("kinematic-adaptive").places
        ()
        """
        return self.predictor.known_places

    @property
    def mixture(self) -> Mixture | None:
        """What the last prediction knows beyond one law: the places where it may end, and elsewhere.

        ``None`` where nothing is justified now, and always where the predictor learns no places. It is put
        together when asked for; predictions themselves claim one law.

        >>> from pointpred import build
        >>> build("kinematic-adaptive").mixture is None
        True
        """
        return self.predictor.mixture

    def enter(self, key: str, x: float = 0.0, y: float = 0.0) -> None:
        """The next movement is in this window or page; one that goes on stays in the window it began in.

        Places are remembered for each ``key`` and relative to the origin (x, y) px, so that they move with
        the window; "" is the key of a pipeline that was told nothing. Other windows' places are kept. Raises
        ParameterError for a key that is no string and an origin that is no number within the bounds of
        positions; nothing is then changed. Without effect on a predictor that learns no places.
        """
        self.predictor.enter(scene(key, x, y))

    def forget(self) -> None:
        """Forget the person, the movement and the window."""
        self.differentiator = self.differentiator.fresh()
        self.predictor = self.predictor.fresh()

    def reset(self) -> None:
        """Forget every event: the next one starts a movement. What is known of the person stays."""
        self.differentiator.reset()
        self.predictor.reset()

    def fresh(self) -> Self:
        """Return a pipeline with the same parameters and no memory, which knows nobody."""
        return type(self)(self.name, self.differentiator.fresh(), self.predictor.fresh())


def run_on(pipeline: Pipeline, columns: EventColumns, motions: FloatArray) -> PredictionColumns:
    """``run`` where the motions of the events are known, as pipelines of one differentiator share them.

    ``motions``: what a fresh differentiator with this one's parameters gives for ``columns``, whose first row
    is marked ``begin``. The differentiator itself is left as it is. Raises what ``run`` raises.
    """
    memory = pipeline.predictor.remembered()
    answers: FloatArray | None = None
    try:
        answers = pipeline.predictor.walk(columns.begin, motions)
        if has_refusal(answers):
            answers = None
    finally:
        if answers is None:
            pipeline.predictor.recall(memory)
    return run(pipeline, columns) if answers is None else PredictionColumns(answers)


def run(pipeline: Pipeline, columns: EventColumns) -> PredictionColumns:
    """Consume a table of events and return a row of predictions for each.

    A row is NaN but for ``t`` and the phase where ``update`` gives ``None``.

    Continues from the pipeline's memory, so chunks equal the whole; a row marked ``begin`` resets first.
    Raises EventOrderError or EventError naming the row; nothing is then consumed.
    """
    table = pipeline.advance_columns(columns)
    if table is None:
        raise pipeline.refusal(columns)
    return PredictionColumns(table)
