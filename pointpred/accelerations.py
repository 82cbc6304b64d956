"""Samples of an accelerometer beside a table of events: which of them came before which event.

An accelerometer has its own rate, so its samples are no events and no columns of events. They stand in a
table of their own; of each event is known how many of them came before it. Whoever takes rows of the events
takes their samples along.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pointpred.errors import EventError, EventOrderError

FIELDS = ("t", "ax", "ay", "az")
"""A sample: time in s, specific force in m/s^2 along the axes of the sensor, gravity included."""


class Accelerations:
    """A table of samples (``FIELDS``), and for each event the number of samples that came before it.

    ``table`` has shape (samples, 4), ``before`` one whole number an event, which never falls. Samples behind
    the last event are left out: no event could tell of them. Raises EventError for other shapes, and for
    numbers of samples that fall or that the table does not have.
    """

    def __init__(self, table: ArrayLike, before: ArrayLike) -> None:
        rows = np.asarray(table, dtype=np.float64)
        counts = np.asarray(before, dtype=np.int64)
        if rows.ndim != 2 or rows.shape[1] != len(FIELDS):
            raise EventError(f"samples need shape (samples, {len(FIELDS)}), received {rows.shape}")
        if counts.ndim != 1:
            raise EventError(f"before needs one number an event, received shape {counts.shape}")
        if len(counts) and (counts[0] < 0 or counts[-1] > len(rows) or (np.diff(counts) < 0).any()):
            shown = f"{counts.tolist()!r:.80}"
            raise EventError(f"before must rise from 0 to at most {len(rows)}, received {shown}")
        self.table: NDArray[np.float64] = np.ascontiguousarray(rows[: counts[-1] if len(counts) else 0])
        self.before: NDArray[np.int64] = counts

    @classmethod
    def none(cls, events: int) -> Self:
        """No sample beside so many events."""
        return cls(np.empty((0, len(FIELDS))), np.zeros(events, np.int64))

    @classmethod
    def by_time(cls, table: ArrayLike, t: ArrayLike) -> Self:
        """Each sample before the first event that is not earlier; both in the order of their times in s.

        Raises EventOrderError where the time of a sample runs backwards against the one before.

        >>> Accelerations.by_time([[0.1, 0, 0, 9.8], [0.2, 0, 0, 9.8], [0.9, 0, 0, 9.8]], [0.0, 0.2]).before
        array([0, 2])
        """
        rows = np.asarray(table, dtype=np.float64)
        times = rows[:, 0] if rows.ndim == 2 and rows.shape[1] else np.empty(0)
        back = np.flatnonzero(np.diff(times) < 0.0)
        if len(back):
            at = int(back[0]) + 1
            raise EventOrderError(
                f"sample {at}: t must not run backwards: received {times[at]:.17g} s after "
                f"{times[at - 1]:.17g} s; sort the samples, or leave it out",
                field="t",
                value=float(times[at]),
            )
        return cls(rows, np.searchsorted(times, np.asarray(t, np.float64), side="right"))

    @classmethod
    def joined(cls, parts: Sequence[Accelerations]) -> Self:
        """The samples of tables of events that are put one behind the other."""
        if not parts:
            return cls.none(0)
        first = np.cumsum([0, *(len(part) for part in parts[:-1])])
        before = [part.before + start for part, start in zip(parts, first.tolist(), strict=True)]
        return cls(np.concatenate([part.table for part in parts]), np.concatenate(before))

    def __len__(self) -> int:
        """How many samples there are."""
        return len(self.table)

    def rows(self, some: slice) -> Self:
        """Those of some events, the samples that came since the event before the first of them included.

        Raises EventError where there are samples and the slice runs backwards.
        """
        first, _, step = some.indices(len(self.before))
        if step < 0 and len(self):
            raise EventError(f"events with accelerations run forwards, received a slice with step {step}")
        counts = self.before[some]
        if step < 0 or not len(counts):
            return type(self).none(len(counts))
        start = int(self.before[first - 1]) if first else 0
        return type(self)(self.table[start:], counts - start)

    def chosen(self, events: NDArray[np.int64], begin: NDArray[np.bool_]) -> Self:
        """Those of some events, by their places in rising order, where trials are cut.

        Before a chosen event stand the samples since the chosen one before it, but none from before the last
        event marked ``begin``, with which another trial's clock may start.
        """
        if not len(self) or not len(events):
            return type(self).none(len(events))
        since = np.concatenate([[0], self.before[:-1]])
        trial = np.maximum.accumulate(np.where(begin, since, 0))[events]
        stop = self.before[events]
        start = np.maximum(np.concatenate([[0], stop[:-1]]), trial)
        counts = stop - start
        before = np.cumsum(counts)
        place = np.repeat(start - before + counts, counts) + np.arange(before[-1])
        return type(self)(self.table[place], before)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.table, self.before)
