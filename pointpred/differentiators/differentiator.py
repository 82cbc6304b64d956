"""What all differentiators share: the sampling rules, and events in, motions out."""

from __future__ import annotations

from collections.abc import Callable
from math import nan
from typing import Any, ClassVar

from pointpred.differentiators import sampling
from pointpred.errors import EventError, ParameterError
from pointpred.parameter import parameter
from pointpred.records import (
    CPI,
    DPI,
    EventColumns,
    FloatArray,
    Motion,
    MotionColumns,
    MotionRow,
    PointerEvent,
    Row,
    SixFloats,
    TenFloats,
    event_at,
    event_row,
    motion_of,
)
from pointpred.stage import CompiledStage, loop_of

PLAIN = frozenset({float, int, type(None)})
"""Kinds of the fields of an event that need no second look."""


def loop_over_events(step: Callable[..., Any]) -> Callable[..., None]:
    """The loop of a differentiator's law over a table of events; see ``loop_of``."""
    return loop_of(step, event_at)


class Differentiator(CompiledStage):
    """A ``Stage[PointerEvent, Motion]`` around a compiled ``step(memory, event) -> motion``.

    Both are rows: an ``EventRow`` in, the floats of a ``MotionRow`` out, with t NaN where the event is
    refused. A child gives ``step``, ``loop`` and ``at``, the place of the sampling state in the memory.

    ``cpi``: with it the motor motion comes from the events' counts; without, from the cursor and ``dpi``.
    """

    width = len(MotionRow._fields)
    at: ClassVar[int]
    fill = staticmethod(sampling.fill)
    step: ClassVar[Callable[..., TenFloats]]

    cpi: float | None = parameter(
        "counts per inch",
        *CPI,
        "resolution of the device; None: counts are not used",
        default=None,
        absent=0.0,
    )
    dpi: float = parameter(
        "px per inch", *DPI, "resolution of the screen, used where counts are not", default=96.0
    )
    gap_s: float = parameter(
        "s", 1e-3, 1e3, "a longer gap between events means that the device was still", default=0.1
    )
    pause_s: float = parameter(
        "s", 1e-3, 1e3, "the first event after a longer pause starts a movement", default=0.3
    )

    def declare(self, **values: Any) -> None:
        """Check the values, each on its own, and that no pause is shorter than a gap."""
        super().declare(**values)
        if self.pause_s < self.gap_s:
            raise ParameterError(
                f"pause_s must be at least gap_s = {self.gap_s:g} s, received {self.pause_s:g} s",
                field="pause_s",
                value=self.pause_s,
            )

    def settings(self) -> list[float] | FloatArray:
        """What stands first in the memory: m per count or 0, m per px, gap, pause in s; then the child's."""
        return self.filled(type(self).at)

    def update(self, event: PointerEvent, /) -> Motion:
        """Consume one event and return the motion after it.

        Raises EventOrderError when time runs backwards and EventError when a value is not finite or out of
        range; the memory is then unchanged.
        """
        motion = self.advance(checked_event_row(event))
        if motion[0] != motion[0]:
            raise self.refusal(event)
        return motion_of(motion)

    def advance(self, row: Row) -> TenFloats:
        """``update`` in rows; t is NaN where the event is refused, and nothing has changed then."""
        return type(self).step(self._memory, row)

    def run(self, events: EventColumns) -> MotionColumns:
        """Consume a table of events; when a row is refused the error names it and nothing is consumed."""
        before = self.remembered()
        motions = MotionColumns(self.walk_events(events))
        refused = motions.t != motions.t
        if refused.any():
            self.recall(before)
            raise self.refusal_of_row(events, int(refused.argmax()))
        return motions

    def walk_events(self, events: EventColumns) -> FloatArray:
        """``walk`` over events; the samples beside them are for a differentiator that fuses."""
        return self.walk(events.begin, events.table)

    def sense(self, t: float, ax: float, ay: float, az: float) -> None:
        """Consume a sample of an accelerometer; without effect but on a differentiator that fuses."""

    def refusal(self, event: PointerEvent) -> EventError:
        """Why ``update`` refuses an event."""
        return sampling.refusal(event, self._last_t())

    def refusal_of_row(self, events: EventColumns, row: int) -> EventError:
        """Why ``run`` refuses a row of a table."""
        begins = events.begin[: row + 1].nonzero()[0]
        first = int(begins[-1]) if len(begins) else 0
        before = events.t[first:row]
        if len(before):
            last_t: float | None = float(before[-1])
        else:
            last_t = None if len(begins) else self._last_t()
        # The row as it stands, with buttons that may be no whole number at all.
        t, x, y, dx, dy, buttons = events.table[row].tolist()
        event = PointerEvent(t, x, y, None if dx != dx else dx, None if dy != dy else dy, buttons)
        reason = sampling.refusal(event, last_t)
        return type(reason)(f"row {row}: {reason}", field=reason.field, value=reason.value)

    def _last_t(self) -> float | None:
        """The time of the last event, ``None`` before the first."""
        started = self._memory[self.at + sampling.STARTED] == 1.0
        return float(self._memory[self.at + sampling.T]) if started else None


def checked_event_row(event: PointerEvent) -> SixFloats:
    """The row of an event that a user made; raises EventError where a field is no number."""
    try:
        t, x, y, dx, dy, buttons = event.t, event.x, event.y, event.dx, event.dy, event.buttons
        if float is type(t) is type(x) is type(y) and int is type(buttons):  # most events, in half the time
            if dx is None is dy:
                return t, x, y, nan, nan, float(buttons)
            if float is type(dx) is type(dy) and dx == dx and dy == dy:
                return t, x, y, dx, dy, float(buttons)
        kinds = {type(t), type(x), type(y), type(dx), type(dy), type(buttons)}
        if (kinds <= PLAIN or _numbers(event)) and dx == dx and dy == dy:
            return event_row(event)
    except (TypeError, ValueError, OverflowError) as unusable:
        raise sampling.refusal(event, None) from unusable
    except AttributeError as missing:
        raise EventError(f"an event must be a PointerEvent, received {event!r:.80}") from missing
    raise sampling.refusal(event, None)


def _numbers(event: PointerEvent) -> bool:
    """Whether every field is a number, or a count that is missing."""
    counts = [count for count in (event.dx, event.dy) if count is not None]
    return all(map(sampling.is_number, (event.t, event.x, event.y, *counts, event.buttons)))
