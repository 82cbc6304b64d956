"""Tables of records with a name for each column, and the same as DataFrames of pandas, which is optional."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from operator import index
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Protocol, Self, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pointpred.errors import EventError
from pointpred.extras import missing_extra

if TYPE_CHECKING:
    import pandas as pd

FloatArray = NDArray[np.float64]

Record = TypeVar("Record")


class Columns(Generic[Record]):
    """A table of shape (rows, fields) with a name for each column.

    Iterating gives the rows as records, an integer index one of them, a slice the columns of some rows.
    """

    names: ClassVar[tuple[str, ...]] = ()
    titles: ClassVar[tuple[str, ...]] = ()
    """The names with their units, as in files and DataFrames; (): the names."""

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

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.names]

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {len(self)} rows of {', '.join(self.names)}>"

    def to_pandas(self) -> pd.DataFrame:
        """A ``pandas.DataFrame`` with a column for each name, with its unit, as ``x_px``; NaN stays NaN.

        Raises MissingExtraError where pandas is not installed.
        """
        try:
            import pandas as pd
        except ImportError as error:
            raise missing_extra("report", "a DataFrame needs pandas") from error
        return pd.DataFrame(dict(zip(self.titles or self.names, self.table.T, strict=True)))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.table,)


class Frame(Protocol):
    """What is used of a ``pandas.DataFrame``, so that types need no pandas."""

    @property
    def columns(self) -> Any:
        """The names of the columns."""
        ...

    def __iter__(self) -> Iterator[Any]: ...


def is_frame(value: object) -> bool:
    """Whether a value is a ``pandas.DataFrame``; pandas is not imported for that."""
    pandas = sys.modules.get("pandas")
    return pandas is not None and isinstance(value, pandas.DataFrame)


def columns_of_frame(frame: pd.DataFrame, names: Mapping[str, str], needed: int) -> dict[str, Any]:
    """The columns of a DataFrame by our names; ``names``: each with its title, which does as well.

    Raises EventError where one of the first ``needed`` is missing.
    """
    found = {name: one for name, title in names.items() for one in (title, name) if one in frame.columns}
    for name in list(names)[:needed]:
        if name not in found:
            known = ", ".join(map(str, frame.columns[:12]))
            raise EventError(f"a DataFrame needs a column {name} or {names[name]}, received {known}")
    return {name: frame[column].to_numpy() for name, column in found.items()}


def numbers_of(values: ArrayLike, name: str) -> FloatArray:
    """An array of floats, from what numpy takes for numbers."""
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "biufO":
            raise TypeError(f"received {array.dtype}")
        return array.astype(np.float64, copy=False)
    except (TypeError, ValueError) as wrong:
        raise EventError(f"{name} needs numbers: {wrong}") from wrong
