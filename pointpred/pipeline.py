"""A differentiator and a predictor, joined, and the targets: events in, predictions out."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from copy import copy
from functools import cache
from math import nan
from typing import TYPE_CHECKING, Any, Literal, Self, overload

import numpy as np

from pointpred.compiled import law
from pointpred.differentiators import Differentiator
from pointpred.errors import ParameterError
from pointpred.person import person_of, restore
from pointpred.predictors import Predictor
from pointpred.predictors.mixture import Mixture
from pointpred.records import (
    EVENT_FIELD,
    EventColumns,
    FloatArray,
    FloatTable,
    Place,
    PointerEvent,
    Prediction,
    PredictionColumns,
    Row,
    TenFloats,
    event_at,
    event_row,
    prediction_of,
    refusal,
    refused,
)
from pointpred.scene import scene
from pointpred.targets.aim import Aim
from pointpred.targets.rectangles import Target

if TYPE_CHECKING:
    import pandas as pd


@cache
def joint_of(first: Callable[..., Any], second: Callable[..., Any]) -> Callable[..., TenFloats]:
    """The law ``first`` and then ``second`` with what it answered, for one event.

    Takes the memory of each, the row, and what ``second`` shares. Where either refuses, both memories are as
    they were: ``second`` changes nothing then, and that of ``first`` is copied back. Made once for two laws.
    """

    @law
    def joint(memory: FloatArray, other: FloatArray, row: Row, *shared: FloatArray) -> TenFloats:
        kept = memory.copy()
        answer: TenFloats = first(memory, row)
        if answer[0] == answer[0]:
            answer = second(other, answer, *shared)
            if answer[0] != answer[0]:
                memory[:] = kept
        return answer

    return joint


@cache
def last_of(
    first: Callable[..., Any], second: Callable[..., Any], follow: Callable[..., bool] | None
) -> Callable[..., TenFloats]:
    """``first`` and then ``second`` over a table of at least one event; the answer to the last of them.

    ``follow`` takes a motion into the memory of ``second`` as that does, and says whether it was accepted;
    without one, ``second`` is called for each. Where an event is refused, both memories are as they were.
    """
    follow_one = follow or _following(second)

    @law
    def last(memory: FloatArray, other: FloatArray, rows: FloatTable, *shared: FloatArray) -> TenFloats:
        kept, other_kept = memory.copy(), other.copy()
        answer, count = refused(EVENT_FIELD, nan), 0
        for i in range(len(rows) - 1):
            between = first(memory, event_at(rows, i))
            if between[0] != between[0] or not follow_one(other, between, *shared):
                break
            count += 1
        if count == len(rows) - 1:
            between = first(memory, event_at(rows, count))
            if between[0] == between[0]:
                answer = second(other, between, *shared)
        if answer[0] != answer[0]:
            memory[:] = kept
            other[:] = other_kept
        return answer

    return last


def _following(step: Callable[..., Any]) -> Callable[..., bool]:
    """A law that does what ``step`` does, and says only whether it accepts."""

    @law
    def follow(memory: FloatArray, row: Row, *shared: FloatArray) -> bool:
        t = step(memory, row, *shared)[0]
        return bool(t == t)

    return follow


class Pipeline:
    """A ``Stage[PointerEvent, Prediction | None]``: the differentiator's motion feeds the predictor.

    Where targets are registered, the prediction is the one given these. ``push`` takes a table of events;
    ``update`` one event, through both laws in one compiled call, and ``advance`` does so in rows. Where an
    event is refused, nothing has changed.
    """

    def __init__(self, name: str, differentiator: Differentiator, predictor: Predictor) -> None:
        self.name = name
        self.differentiator = differentiator
        self.predictor = predictor
        self._aim: Aim | None = None
        self._joint: Callable[..., TenFloats] | None = None
        self._last: Callable[..., TenFloats] | None = None

    def __repr__(self) -> str:
        targets = f", {len(self._aim.ids)} targets" if self._aim is not None and self._aim.ids else ""
        return f"<Pipeline {self.name}: {self.differentiator}, {self.predictor}{targets}>"

    def update(self, event: PointerEvent, /) -> Prediction | None:
        """Consume one event; ``None`` where nothing is justified now.

        Raises EventOrderError when time runs backwards and EventError when a value is not finite or out of
        range; the pipeline is then unchanged.
        """
        row = event_row(event)
        answer = self.advance(row)
        if answer[0] != answer[0]:
            raise refusal(row, answer)
        return prediction_of(answer)

    def advance(self, row: Row) -> TenFloats:
        """``update`` in rows: an ``EventRow`` in, the floats of a ``PredictionRow`` out.

        The first is NaN where the event is refused: nothing has changed then; ``records.refusal`` says why.
        """
        joint = self._joint or self._bind()[0]
        answer = joint(self.differentiator._memory, self.predictor._memory, row, *self.predictor.shared)
        if self._aim is None or answer[0] != answer[0]:
            return answer
        return self._aim.given(row, answer)

    @overload
    def push(self, events: EventColumns | FloatArray, want: Literal["last"]) -> TenFloats: ...

    @overload
    def push(
        self,
        events: EventColumns | FloatArray,
        want: Literal["all"] = "all",
        motions: FloatArray | None = None,
    ) -> FloatArray: ...

    def push(
        self,
        events: EventColumns | FloatArray,
        want: Literal["last", "all"] = "all",
        motions: FloatArray | None = None,
    ) -> FloatArray | TenFloats:
        """Consume events and return the rows of their predictions, or only the last one of at least one.

        ``events``: columns, where a row marked ``begin`` resets first, or their table, where none does.
        ``motions``: what a fresh differentiator with this one's parameters gives for ``events``, whose first
        row is marked ``begin``; the differentiator itself is then left as it is. A row is NaN but for ``t``
        and the phase where ``update`` gives ``None``. Raises EventOrderError or EventError naming the row;
        nothing is then consumed.
        """
        if isinstance(events, np.ndarray):
            if want == "last" and self._aim is None and self.predictor.joined:
                last, predictor = self._last or self._bind()[1], self.predictor
                answer = last(self.differentiator._memory, predictor._memory, events, *predictor.shared)
                if answer[0] == answer[0]:
                    return answer
            table, begin = events, np.zeros(len(events), np.bool_)
        else:
            table, begin = events.table, events.begin
        before = self.differentiator.remembered()
        answers: FloatArray | None = None
        try:
            if motions is None:
                motions = self.differentiator.walk_all(begin, table)
            answers = self.predictor.walk_all(begin, motions)
        finally:
            if answers is None:
                self.differentiator.recall(before)
        if self._aim is not None:
            self._aim.follow(begin, table, answers)
        return tuple(answers[-1].tolist()) if want == "last" else answers

    def _bind(self) -> tuple[Callable[..., TenFloats], Callable[..., TenFloats]]:
        """The joint law and that of a table's last answer; not before an event comes."""
        first, second = type(self.differentiator), type(self.predictor)
        self._joint = joint_of(first.step, second.step)
        self._last = last_of(first.step, second.step, second.follow)
        return self._joint, self._last

    def __getstate__(self) -> dict[str, Any]:
        """Everything but the compiled laws, which are made again."""
        return {**self.__dict__, "_joint": None, "_last": None}

    def register(self, targets: Sequence[Target]) -> None:
        """Take these targets, in place of those before, as what can be pointed at; none: as if nobody had.

        From the next event on the endpoint, its region and the time left are those of a movement to one of
        them or elsewhere. ``reset`` keeps them. At most 1000; raises ParameterError, nothing changed.

        >>> from pointpred import build
        >>> from pointpred.targets import around
        >>> pipeline = build("minimum-jerk")
        >>> pipeline.register([around("left", -400.0, 0.0, 40.0), around("right", 400.0, 0.0, 40.0)])
        >>> for i in range(30):
        ...     at = PointerEvent(i / 100, 400.0 * (i / 60) ** 2 * (3 - 2 * i / 60), 0.0)
        ...     prediction = pipeline.update(at)
        >>> max(pipeline.shares, key=pipeline.shares.get), round(prediction.x)
        ('right', 400)
        """
        self.aim.register(targets)

    @property
    def aim(self) -> Aim:
        """The registered targets and what is known of them, for those that decide among them."""
        if self._aim is None:
            self._aim = Aim()
        return self._aim

    @aim.setter
    def aim(self, aim: Aim) -> None:
        self._aim = aim

    @property
    def shares(self) -> dict[Hashable, float]:
        """How likely the movement is for each registered target, by its id; ``None``: for none of them."""
        if self._aim is None:
            return {None: 1.0}
        return dict(zip((*self._aim.ids, None), self._aim.shares.tolist(), strict=True))

    @property
    def learns(self) -> bool:
        """Whether finished movements change what is said of the next: then only a new person starts fresh."""
        return bool(self.predictor.learned) or (self._aim is not None and self._aim.learn == 1)

    @property
    def person(self) -> str:
        """What finished movements taught of the person, for ``build(name, person=...)``: printable ASCII.

        At most 16384 characters; "" while nobody is known, and always where nothing is learned or can be
        saved (`ktm`). The movement that goes on is not in it: ``reset`` finishes it. What is known of the
        targets that the person takes stands behind a ``+``.
        """
        own, taken = person_of(self.predictor), "" if self._aim is None else person_of(self._aim)
        return f"{own}+{taken}" if taken else own

    @person.setter
    def person(self, person: str) -> None:
        own, plus, taken = person.partition("+") if isinstance(person, str) else (person, "", "")
        if plus and not taken:
            raise ParameterError("person must not end with '+'; is it cut off?", field="person")
        restore(copy(self._aim or Aim()), taken)  # refused before anything is changed
        restore(self.predictor, own)
        if taken:
            restore(self.aim, taken)

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
        """What the last prediction knows beyond one law: the targets and places where it may end, elsewhere.

        ``None`` where nothing is justified now, and where neither targets are registered nor the predictor
        learns places. It is put together when asked for; predictions themselves claim one law.

        >>> from pointpred import build
        >>> build("kinematic-adaptive").mixture is None
        True
        """
        own = self.predictor.mixture
        return own if self._aim is None or not self._aim.ids else self._aim.mixture(own)

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
        if self._aim is not None:
            self._aim = self._aim.fresh()

    def reset(self) -> None:
        """Forget every event: the next one starts a movement. What is known of the person stays."""
        self.differentiator.reset()
        self.predictor.reset()
        if self._aim is not None:
            self._aim.reset()

    def __copy__(self) -> Self:
        twin = type(self)(self.name, copy(self.differentiator), copy(self.predictor))
        twin._aim = copy(self._aim)
        return twin

    def fresh(self) -> Self:
        """Return a pipeline with the same parameters and targets and no memory, which knows nobody."""
        twin = type(self)(self.name, self.differentiator.fresh(), self.predictor.fresh())
        twin._aim = None if self._aim is None else self._aim.fresh()
        return twin


@overload
def run(pipeline: Pipeline, columns: EventColumns) -> PredictionColumns: ...


@overload
def run(pipeline: Pipeline, columns: pd.DataFrame) -> pd.DataFrame: ...


def run(pipeline: Pipeline, columns: EventColumns | pd.DataFrame) -> PredictionColumns | pd.DataFrame:
    """Consume a table of events and return a row of predictions for each.

    A row is NaN but for ``t`` and the phase where ``update`` gives ``None``. A ``pandas.DataFrame`` with the
    columns of ``EventColumns.of_frame`` gives one with the same index and the columns ``t_s, x_px, ...``.

    Continues from the pipeline's memory, so chunks equal the whole; a row marked ``begin`` resets first.
    Raises EventOrderError or EventError naming the row; nothing is then consumed.
    """
    if isinstance(columns, EventColumns):
        return PredictionColumns(pipeline.push(columns))
    answers = PredictionColumns(pipeline.push(EventColumns.of_frame(columns)))
    return answers.to_pandas().set_index(columns.index)
