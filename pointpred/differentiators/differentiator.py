"""What all differentiators share: the sampling rules, and events in, motions out."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from pointpred.columns import EventColumns, MotionColumns
from pointpred.differentiators import sampling
from pointpred.errors import EventError
from pointpred.events import Motion, PointerEvent
from pointpred.stage import CompiledStage

NONE = float("nan")
REFUSED_ROW = (NONE, NONE, NONE, NONE, NONE, NONE, NONE, 0.0, 0.0, 0.0)
"""What a step returns for an event it refuses; its memory is then unchanged."""


PLAIN = frozenset({float, int, type(None)})
"""Kinds of the fields of an event that need no second look."""


class Differentiator(CompiledStage):
    """A ``Stage[PointerEvent, Motion]`` around a compiled ``step(memory, t, x, y, dx, dy, buttons)``.

    A child gives ``step``, ``loop`` and ``at``, the place of the sampling state in the memory.
    """

    width = 10
    at: int
    step: ClassVar[Callable[..., tuple[float, ...]]]

    def update(self, event: PointerEvent, /) -> Motion:
        """Consume one event and return the motion after it.

        Raises EventOrderError when time runs backwards and EventError when a value is not finite or out of
        range; the memory is then unchanged.
        """
        t, x, y, vx, vy, ax, ay, settled, start, counts = self.consume(event)
        return Motion(t, x, y, vx, vy, ax, ay, settled == 1.0, start == 1.0, counts == 1.0)

    def consume(self, event: PointerEvent) -> tuple[float, ...]:
        """``update``, with the motion as the plain row that a pipeline hands to its predictor."""
        try:
            dx, dy = event.dx, event.dy
            kinds = {type(event.t), type(event.x), type(event.y), type(dx), type(dy), type(event.buttons)}
            if (not kinds <= PLAIN and not _numbers(event)) or dx != dx or dy != dy:
                raise TypeError("a value that is no number, or NaN for a count")
            row = type(self).step(
                self._memory,
                float(event.t),
                float(event.x),
                float(event.y),
                NONE if dx is None else float(dx),
                NONE if dy is None else float(dy),
                float(event.buttons),
            )
        except (TypeError, ValueError, OverflowError) as unusable:
            raise sampling.explain(event, None) from unusable
        except AttributeError as missing:
            raise EventError(f"an event must be a PointerEvent, received {event!r:.80}") from missing
        if row[0] != row[0]:
            raise sampling.explain(event, self._last_t())
        return row

    def advance(
        self, t: float, x: float, y: float, dx: float, dy: float, buttons: float
    ) -> tuple[float, ...]:
        """``consume`` for plain numbers, NaN for what is missing; t is NaN where the event is refused."""
        return type(self).step(self._memory, t, x, y, dx, dy, buttons)

    def run(self, events: EventColumns) -> MotionColumns:
        """Consume a table of events; when a row is refused the error names it and nothing is consumed."""
        kept = self._memory.copy()
        motions = MotionColumns(self.walk(events.begin, events.table))
        refused = motions.t != motions.t
        if refused.any():
            row = int(refused.argmax())
            self._memory = kept
            raise self.explain_row(events, row)
        return motions

    def explain_row(self, events: EventColumns, row: int) -> Exception:
        """Why a row of a table was refused."""
        begins = events.begin[: row + 1].nonzero()[0]
        first = int(begins[-1]) if len(begins) else 0
        before = events.t[first:row]
        if len(before):
            last_t: float | None = float(before[-1])
        else:
            last_t = None if len(begins) else self._last_t()
        reason = sampling.explain(_record(events, row), last_t)
        return type(reason)(f"row {row}: {reason}")

    def _last_t(self) -> float | None:
        """The time of the last event, ``None`` before the first."""
        started = self._memory[self.at + sampling.STARTED] == 1.0
        return float(self._memory[self.at + sampling.T]) if started else None


def _numbers(event: PointerEvent) -> bool:
    """Whether every field is a number, or a count that is missing."""
    counts = [count for count in (event.dx, event.dy) if count is not None]
    return all(map(sampling.is_number, (event.t, event.x, event.y, *counts, event.buttons)))


def _record(events: EventColumns, row: int) -> PointerEvent:
    """A row as it stands, with buttons that may be no whole number at all."""
    t, x, y, dx, dy, buttons = events.table[row].tolist()
    return PointerEvent(t, x, y, None if dx != dx else dx, None if dy != dy else dy, buttons)
