"""Tables of records with a name for each column."""

from __future__ import annotations

from collections.abc import Iterator
from operator import index
from typing import Any, ClassVar, Generic, Self, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pointpred.errors import EventError

FloatArray = NDArray[np.float64]

Record = TypeVar("Record")


class Columns(Generic[Record]):
    """A table of shape (rows, fields) with a name for each column.

    Iterating gives the rows as records, an integer index one of them, a slice the columns of some rows.
    """

    names: ClassVar[tuple[str, ...]] = ()

    def __init__(self, table: ArrayLike) -> None:
        table = numbers_of(table, type(self).__name__)
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


def numbers_of(values: ArrayLike, name: str) -> FloatArray:
    """An array of floats, from what numpy takes for numbers."""
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "biufO":
            raise TypeError(f"received {array.dtype}")
        return array.astype(np.float64, copy=False)
    except (TypeError, ValueError) as wrong:
        raise EventError(f"{name} needs numbers: {wrong}") from wrong
