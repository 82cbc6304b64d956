"""The system's transfer function learnt while ``pointpred live`` runs, and kept where it was asked for."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pointpred.devices.paths import PositionPath
from pointpred.errors import EventError, SourceError
from pointpred.transfer import TransferLearner, save_transfer

if TYPE_CHECKING:
    from pointpred.devices.paths import CursorPath
    from pointpred.devices.sessions import Pair
    from pointpred.transfer import GainCurve

CURVE_S = 2.0
"""How often the curve is worked out anew: it takes some 30 ms."""
NEEDS_CURSOR = "a transfer function is learnt from counts and the screen's cursor; here only counts are known"
NEEDS_COUNTS = (
    "a transfer function is learnt from counts and the screen's cursor; here only the cursor is known"
)
NEEDS_CPI = "the transfer function is learnt with counts per inch: give --cpi, or measure with --measure-cpi"


class Learning:
    """A learner fed by a session (a ``Watcher``), and its curve worked out on a thread of its own."""

    def __init__(self, cpi: float, dpi: float, size: tuple[int, int] | None) -> None:
        self.cpi, self.dpi = cpi, dpi
        self.learner = TransferLearner(cpi=cpi, dpi=dpi, size=size)
        self.curve: GainCurve = self.learner.curve()
        self.unused = 0
        """Events it did not take, such as those that only correct a place."""
        self._events = 0

    def take(self, pairs: Sequence[Pair]) -> None:
        """Learn from what came."""
        for event, _ in pairs:
            try:
                self.learner.update(event)
            except EventError:
                self.unused += 1
        self._events += len(pairs)

    def start(self, stopping: threading.Event, told: Callable[[GainCurve], None]) -> None:
        """Work the curve out every two seconds in which something came, until ``stopping`` is set."""
        threading.Thread(target=self._run, args=(stopping, told), name="transfer", daemon=True).start()

    def save(self, path: Path) -> str:
        """Write the function; returns what came of it in words. Raises SourceError where there is none."""
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

    def _run(self, stopping: threading.Event, told: Callable[[GainCurve], None]) -> None:
        seen = 0
        while not stopping.wait(CURVE_S):
            if self._events != seen:
                seen = self._events
                self.curve = self.learner.curve()
                told(self.curve)


def learning_of(path: CursorPath, cpi: float | None, dpi: float) -> Learning | str:
    """A learner where there is something to learn from, otherwise why there is none."""
    if path.space != "screen":
        return NEEDS_CURSOR
    if isinstance(path, PositionPath) and not path.counts:
        return NEEDS_COUNTS
    if cpi is None:
        return NEEDS_CPI
    cursor = getattr(path, "cursor", None)
    return Learning(cpi, dpi, getattr(cursor, "size", None))
