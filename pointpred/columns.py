"""The records of ``events`` as columns: one float64 table, a row a record, NaN where a field is ``None``.

A table is what compiled loops walk over; the named properties are views into it, not copies.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pointpred.errors import EventError
from pointpred.events import PHASES, Motion, PointerEvent, Prediction

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]


class Columns:
    """A table of shape (rows, fields) with a name for each column."""

    names: ClassVar[tuple[str, ...]] = ()

    def __init__(self, table: ArrayLike) -> None:
        table = _numbers(table, type(self).__name__)
        if table.ndim != 2 or table.shape[1] != len(self.names):
            raise EventError(
                f"{type(self).__name__} needs shape (rows, {len(self.names)}), received {table.shape}"
            )
        self.table = np.ascontiguousarray(table)

    def __len__(self) -> int:
        return len(self.table)

    def __getattr__(self, name: str) -> FloatArray:
        if name in type(self).names:
            column: FloatArray = self.table[:, type(self).names.index(name)]
            return column
        raise AttributeError(f"{type(self).__name__} has no column {name!r}")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.table,)


class EventColumns(Columns):
    """Pointer events as columns, with ``begin`` marking the rows before which a stage is reset."""

    names = ("t", "x", "y", "dx", "dy", "buttons")

    def __init__(self, table: ArrayLike, begin: BoolArray | None = None) -> None:
        super().__init__(table)
        count = len(self.table)
        self.begin = np.zeros(count, dtype=np.bool_) if begin is None else np.asarray(begin, np.bool_)
        if self.begin.shape != (count,):
            raise EventError(f"begin needs {count} rows, received shape {self.begin.shape}")

    @classmethod
    def of(
        cls,
        t: ArrayLike,
        x: ArrayLike,
        y: ArrayLike,
        dx: ArrayLike | None = None,
        dy: ArrayLike | None = None,
        buttons: ArrayLike | None = None,
        begin: BoolArray | None = None,
    ) -> Self:
        """Columns from one array a field, all of the same length; what is missing is ``None`` or 0.

        Raises EventError for an array of another length or of what is no number.
        """
        time = _numbers(t, "t")
        if time.ndim != 1:
            raise EventError(f"t needs one number a row, received shape {time.shape}")
        table = np.full((len(time), 6), np.nan)
        table[:, 5] = 0.0
        for column, values in enumerate((time, x, y, dx, dy, buttons)):
            if values is None:
                continue
            numbers = _numbers(values, cls.names[column])
            if numbers.shape != time.shape:
                raise EventError(
                    f"{cls.names[column]} needs {len(time)} rows as t has, received shape {numbers.shape}"
                )
            table[:, column] = numbers
        return cls(table, begin)

    @classmethod
    def of_events(cls, events: Iterable[PointerEvent]) -> Self:
        """Columns from records."""
        none = float("nan")
        rows = [
            (e.t, e.x, e.y, none if e.dx is None else e.dx, none if e.dy is None else e.dy, e.buttons)
            for e in events
        ]
        return cls(np.array(rows, dtype=np.float64).reshape(-1, 6))

    def events(self) -> Iterator[PointerEvent]:
        """The rows as records."""
        for t, x, y, dx, dy, buttons in self.table.tolist():
            yield PointerEvent(t, x, y, dx if dx == dx else None, dy if dy == dy else None, int(buttons))

    def rows(self, start: int, stop: int) -> Self:
        """The rows from ``start`` up to ``stop``."""
        return type(self)(self.table[start:stop], self.begin[start:stop])

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.table, self.begin)


class MotionColumns(Columns):
    """Motions as columns."""

    names = ("t", "x", "y", "vx", "vy", "ax", "ay", "settled", "start", "counts")

    def motions(self) -> Iterator[Motion]:
        """The rows as records."""
        for t, x, y, vx, vy, ax, ay, settled, start, counts in self.table.tolist():
            yield Motion(t, x, y, vx, vy, ax, ay, bool(settled), bool(start), bool(counts))


class PredictionColumns(Columns):
    """Predictions as columns; a row without a prediction is NaN but for ``t`` and the phase."""

    names = ("t", "x", "y", "sxx", "sxy", "syy", "remaining_s", "phase", "tail", "remaining_spread")

    def predictions(self) -> Iterator[Prediction | None]:
        """The rows as records, ``None`` where nothing was justified."""
        for row in self.table.tolist():
            yield prediction_of(row[0], tuple(row[1:]))


def _numbers(values: ArrayLike, name: str) -> FloatArray:
    """An array of floats, from what numpy takes for numbers."""
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "biufO":
            raise TypeError(f"received {array.dtype}")
        return array.astype(np.float64, copy=False)
    except (TypeError, ValueError) as wrong:
        raise EventError(f"{name} needs numbers: {wrong}") from wrong


def prediction_of(t: float, values: tuple[float, ...]) -> Prediction | None:
    """A prediction from a row of ``PredictionColumns`` after its time; ``None`` where x is NaN."""
    x, y, sxx, sxy, syy, remaining_s, phase, tail, spread = values
    if x != x:
        return None
    return Prediction(
        t,
        x,
        y,
        (sxx, sxy, syy) if sxx == sxx else None,
        PHASES[int(phase)],
        remaining_s if remaining_s == remaining_s else None,
        tail if tail == tail else None,
        spread if spread == spread else None,
    )
