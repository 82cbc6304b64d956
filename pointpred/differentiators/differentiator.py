"""What all differentiators share: the sampling rules, and events in, motions out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from pointpred.differentiators import sampling
from pointpred.errors import ParameterError
from pointpred.parameter import parameter
from pointpred.records import (
    CPI,
    DPI,
    EventColumns,
    Motion,
    MotionColumns,
    MotionRow,
    PointerEvent,
    TenFloats,
    event_at,
    event_row,
    motion_of,
    refusal,
)
from pointpred.stage import CompiledStage, loop_of


class Differentiator(CompiledStage):
    """A ``Stage[PointerEvent, Motion]`` around a compiled ``step(memory, event) -> motion``.

    Both are rows: an ``EventRow`` in, the floats of a ``MotionRow`` out, with t NaN where the event is
    refused. A child gives ``step``.

    ``cpi``: with it the motor motion comes from the events' counts; without, from the cursor and ``dpi``.
    """

    width = len(MotionRow._fields)
    fill: ClassVar[Callable[..., None]] = staticmethod(sampling.fill)
    step: ClassVar[Callable[..., TenFloats]]

    def __init_subclass__(cls) -> None:
        """Make the loop over a table of events around the class's own law."""
        super().__init_subclass__()
        cls.loop = staticmethod(loop_of(cls.step, event_at))

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

    def update(self, event: PointerEvent, /) -> Motion:
        """Consume one event and return the motion after it.

        Raises EventOrderError when time runs backwards and EventError when a value is not finite or out of
        range; the memory is then unchanged.
        """
        row = event_row(event)
        motion = self.advance(row)
        if motion[0] != motion[0]:
            raise refusal(row, motion)
        return motion_of(motion)

    def run(self, events: EventColumns) -> MotionColumns:
        """Consume a table of events; when a row is refused the error names it and nothing is consumed."""
        return MotionColumns(self.walk_all(events.begin, events.table))
