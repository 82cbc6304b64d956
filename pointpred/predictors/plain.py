"""A predictor in plain Python: any object with ``update`` and ``reset``, as others write it."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any, ClassVar, Self

import numpy as np

from pointpred.compiled import with_names
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import (
    FINE,
    BoolArray,
    FloatArray,
    MotionRow,
    Prediction,
    TenFloats,
    endpoint,
    motion_of,
    prediction_row,
    refusal,
)


def step(s: movement.State, motion: TenFloats, held: Any) -> TenFloats:
    """Check the motion, then ask the object that is held: it never sees one that is refused."""
    m = MotionRow(*motion)
    fault, _, _ = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    if m.t == s.t0:  # a movement starts, or its first event is replaced by a later one at the same time
        held.reset()
    answer = held.update(motion_of(motion))
    if isinstance(answer, Prediction):
        return m.t, *prediction_row(answer)[1:]
    if answer is None:
        return endpoint(m.t, np.nan, np.nan, movement.phase(s, m))
    try:
        x, y = answer
    except (TypeError, ValueError) as error:
        expected = "expected None, a pair x, y in px or a Prediction"
        raise TypeError(f"update answered {answer!r:.80}, {expected}") from error
    return endpoint(m.t, float(x), float(y), movement.phase(s, m))


class PlainPredictor(Predictor):
    """An object of plain Python as a predictor: some 100 times slower than a law.

    ``make()`` gives the object. Its ``update(motion)`` takes each ``Motion`` (position px, speed of the hand
    m/s, ``start`` where a movement starts) and answers with a ``Prediction``, with x and y in px, or with
    ``None`` where nothing is justified. Its ``reset()`` forgets the movement; it is called where one starts,
    several times in a row at that. With an attribute ``learns = True`` it may remember the person across
    ``reset``. What it raises reaches the caller, and what it has taken in by then stays.
    """

    joined = False
    step = staticmethod(with_names(step))
    loop: ClassVar[Callable[..., None]] = staticmethod(lambda *arguments: None)  # never called: see walk
    states = movement.State.length

    def __init__(self, make: Callable[[], Any]) -> None:
        super().__init__()
        self.make = make
        self.hold(make())

    def hold(self, own: Any) -> None:
        """Ask this object from now on."""
        self.own, self.shared = own, (own,)
        self.learned = int(bool(getattr(own, "learns", False)))

    def reset(self) -> None:
        """Forget the movement."""
        self._memory[:] = 0.0
        self.own.reset()

    def fresh(self) -> Self:
        """A new object, which knows nobody."""
        return type(self)(self.make)

    @property
    def known(self) -> FloatArray:
        """Nothing: what the object learned is its own."""
        return np.empty(0)

    def __copy__(self) -> Self:
        twin = type(self)(self.make)
        twin._memory[:] = self._memory
        twin.hold(copy.deepcopy(self.own))
        return twin

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """Ask for one row after the other, resetting before each row marked ``begin``."""
        answers = np.empty((len(rows), self.width))
        for i, row in enumerate(rows.tolist()):
            if begin[i]:
                self.reset()
            answers[i] = self.advance(row)
        return answers

    def walk_all(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """``walk`` where no row may be refused: they are checked before the object sees the first."""
        memory = self._memory.copy()
        for i, row in enumerate(rows.tolist()):
            if begin[i]:
                memory[:] = 0.0
            m = MotionRow(*row)
            if (fault := movement.follow(memory, m)[0]) != FINE:
                raise refusal(row, movement.refuse(memory, m, fault), f"row {i}: ")
        return self.walk(begin, rows)
