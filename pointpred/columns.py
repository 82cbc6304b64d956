"""The records of ``events`` as columns: one float64 table, a row a record, NaN where a field is ``None``.

A table is what compiled loops walk over; the named properties are views into it, not copies.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from operator import index
from typing import Any, ClassVar, Generic, Self, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pointpred.accelerations import Accelerations
from pointpred.errors import EventError
from pointpred.records import (
    EventRow,
    Motion,
    MotionRow,
    PointerEvent,
    Prediction,
    PredictionRow,
    event_of,
    event_row,
    motion_of,
    prediction_of,
)
from pointpred.regions import Region, probability, region_of

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
Record = TypeVar("Record")


class Columns(Generic[Record]):
    """A table of shape (rows, fields) with a name for each column.

    Iterating gives the rows as records, an integer index one of them, a slice the columns of some rows.
    """

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

    def __iter__(self) -> Iterator[Record]:
        return map(self._record, self.table.tolist())

    @overload
    def __getitem__(self, place: slice) -> Self: ...

    @overload
    def __getitem__(self, place: int) -> Record: ...

    def __getitem__(self, place: int | slice) -> Record | Self:
        if isinstance(place, slice):
            return self._rows(place)
        return self._record(self.table[index(place)].tolist())

    def _record(self, row: list[float]) -> Record:
        """A row as a record."""
        raise NotImplementedError

    def _rows(self, some: slice) -> Self:
        """Some rows as columns."""
        return type(self)(self.table[some])

    def __getattr__(self, name: str) -> FloatArray:
        if name in type(self).names:
            column: FloatArray = self.table[:, type(self).names.index(name)]
            return column
        raise AttributeError(f"{type(self).__name__} has no column {name!r}")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.table,)


class EventColumns(Columns[PointerEvent]):
    """Pointer events as columns, with ``begin`` marking the rows before which a stage is reset.

    ``accelerations``: the samples of an accelerometer beside them.
    """

    names = EventRow._fields

    def __init__(
        self,
        table: ArrayLike,
        begin: BoolArray | None = None,
        accelerations: Accelerations | None = None,
    ) -> None:
        super().__init__(table)
        count = len(self.table)
        self.begin = np.zeros(count, dtype=np.bool_) if begin is None else np.asarray(begin, np.bool_)
        if self.begin.shape != (count,):
            raise EventError(f"begin needs {count} rows, received shape {self.begin.shape}")
        self._accelerations = accelerations
        if accelerations is not None and len(accelerations.before) != count:
            raise EventError(f"accelerations need {count} events, received {len(accelerations.before)}")

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
        return cls(np.array([event_row(event) for event in events], dtype=np.float64).reshape(-1, 6))

    def events(self) -> Iterator[PointerEvent]:
        """The rows as records."""
        return iter(self)

    def rows(self, start: int, stop: int) -> Self:
        """The rows from ``start`` up to ``stop``."""
        return self[start:stop]

    def _record(self, row: list[float]) -> PointerEvent:
        return event_of(tuple(row))

    @property
    def accelerations(self) -> Accelerations:
        """The samples of an accelerometer beside them; none unless given."""
        return Accelerations.none(len(self)) if self._accelerations is None else self._accelerations

    def sampled(self, accelerations: ArrayLike) -> Self:
        """These events with the samples of an accelerometer beside them, by time; see ``Accelerations``.

        ``accelerations`` has shape (samples, 4). Both must be of one trial, or of a clock that goes on.
        """
        return type(self)(self.table, self.begin, Accelerations.by_time(accelerations, self.t))

    def chosen(self, rows: NDArray[np.int64], begin: BoolArray) -> Self:
        """Some rows, by their places in rising order, with marks of their own."""
        beside = self._accelerations
        chosen = None if beside is None else beside.chosen(rows, self.begin)
        return type(self)(self.table[rows], begin, chosen)

    def _rows(self, some: slice) -> Self:
        beside = self._accelerations
        return type(self)(self.table[some], self.begin[some], None if beside is None else beside.rows(some))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.table, self.begin, self._accelerations)


class MotionColumns(Columns[Motion]):
    """Motions as columns."""

    names = MotionRow._fields

    def motions(self) -> Iterator[Motion]:
        """The rows as records."""
        return iter(self)

    def _record(self, row: list[float]) -> Motion:
        return motion_of(tuple(row))


class RegionColumns(Columns[Region | None]):
    """Regions as columns, in the units of ``Region``; a row without a region is NaN."""

    names = ("x", "y", "major", "minor", "angle")

    def _record(self, row: list[float]) -> Region | None:
        return Region(*row) if row[0] == row[0] else None


class PredictionColumns(Columns[Prediction | None]):
    """Predictions as columns; a row without a prediction is NaN but for ``t`` and the phase."""

    names = PredictionRow._fields

    def predictions(self) -> Iterator[Prediction | None]:
        """The rows as records, ``None`` where nothing was justified."""
        return iter(self)

    def region(self, level: float) -> RegionColumns:
        """``Prediction.region`` of each row; raises ParameterError for a level outside (0, 1)."""
        level = probability(level)
        claimed = self.table[:, [1, 2, 3, 4, 5, 8]].tolist()
        regions = [region_of(level, *row) for row in claimed]
        none = (np.nan,) * len(RegionColumns.names)
        rows = [none if one is None else (one.x, one.y, one.major, one.minor, one.angle) for one in regions]
        return RegionColumns(np.array(rows, dtype=np.float64).reshape(-1, len(RegionColumns.names)))

    def _record(self, row: list[float]) -> Prediction | None:
        return prediction_of(tuple(row))


def _numbers(values: ArrayLike, name: str) -> FloatArray:
    """An array of floats, from what numpy takes for numbers."""
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "biufO":
            raise TypeError(f"received {array.dtype}")
        return array.astype(np.float64, copy=False)
    except (TypeError, ValueError) as wrong:
        raise EventError(f"{name} needs numbers: {wrong}") from wrong
