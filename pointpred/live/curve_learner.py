"""The transfer function of the system, learned while a session runs."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from pathlib import Path

from pointpred.devices.cursor_paths import CursorPath, PositionPath
from pointpred.errors import EventError, SourceError
from pointpred.records import Pair
from pointpred.transfer import GainCurve, TransferLearner, save_transfer

CURVE_S = 2.0
"""How often the curve is computed anew: it takes some 30 ms."""
NEEDS_CURSOR = "a transfer function is learnt from counts and the screen's cursor; here only counts are known"
NEEDS_COUNTS = (
    "a transfer function is learnt from counts and the screen's cursor; here only the cursor is known"
)
NEEDS_CPI = "the transfer function is learnt with counts per inch: give --cpi, or measure with --measure-cpi"


class CurveLearner:
    """Learns from the events of a session (a ``Watcher``); a thread of its own computes the curve."""

    def __init__(self, cpi: float, dpi: float, size: tuple[int, int] | None) -> None:
        self.cpi, self.dpi = cpi, dpi
        self.learner = TransferLearner(cpi=cpi, dpi=dpi, size=size)
        self.curve: GainCurve = self.learner.curve()
        self.unused = 0
        """Events it refused, such as those that only correct a place."""
        self._events = 0

    def take(self, pairs: Sequence[Pair]) -> None:
        """Learn from a batch."""
        for event, _ in pairs:
            try:
                self.learner.update(event)
            except EventError:
                self.unused += 1
        self._events += len(pairs)

    def start(self, stopping: threading.Event, changed: Callable[[GainCurve], None]) -> None:
        """Compute the curve every two seconds in which something came, until ``stopping`` is set."""
        threading.Thread(target=self._run, args=(stopping, changed), name="transfer", daemon=True).start()

    def save(self, path: Path) -> str:
        """Write the function; returns a sentence about it. Raises SourceError where there is none."""
        function = self.learner.identify().function
        if function is None:
            raise SourceError(f"no transfer function to save in {path}: {self.learner.curve().words}")
        save_transfer(path, function, cpi=self.cpi, dpi=self.dpi)
        return f"saved in {path}; 'pointpred live --transfer {path}' uses it"

    def words(self) -> str:
        """The curve in a line."""
        curve = self.curve
        best = next((one for one in curve.compared if one.kind == curve.closest), None)
        like = f"; closest: {best.kind}, off by {100 * best.largest:.1f} % at most" if best else ""
        return curve.words + like

    def _run(self, stopping: threading.Event, changed: Callable[[GainCurve], None]) -> None:
        events = 0
        while not stopping.wait(CURVE_S):
            if self._events != events:
                events = self._events
                self.curve = self.learner.curve()
                changed(self.curve)


def curve_learner(path: CursorPath, cpi: float | None, dpi: float) -> CurveLearner | str:
    """A learner, or why this path does not allow one."""
    if path.space != "screen":
        return NEEDS_CURSOR
    if isinstance(path, PositionPath) and not path.counts:
        return NEEDS_COUNTS
    if cpi is None:
        return NEEDS_CPI
    cursor = getattr(path, "cursor", None)
    return CurveLearner(cpi, dpi, getattr(cursor, "size", None))
