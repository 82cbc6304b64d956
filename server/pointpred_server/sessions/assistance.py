"""The cursor of a session whose counts the service turns into movement, helped towards the endpoint."""

from __future__ import annotations

from math import hypot

import numpy as np

from pointpred.errors import EventError
from pointpred.protocol.client_messages import Assist, Hello, cpi_of, dpi_of
from pointpred.protocol.decoding import check_numbers
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Cursor, encode
from pointpred.records import LARGEST, FloatArray, Row
from pointpred.regions import as_normal
from pointpred.transfer import ConstantGain, GuardedTransfer, SigmoidGain
from pointpred.transfer.assistance import UNGUIDED

Memory = tuple[bytes, tuple[float, float] | None, float, tuple[float, ...]]


class Assistance:
    """Counts move the cursor, and the prediction after each event guides the next.

    The first event of the session says where the cursor stands before it; positions in later ones are not
    used: the client learns later where the cursor is. A reset leaves the cursor where it is.
    """

    def __init__(self, hello: Hello, assist: Assist) -> None:
        """Raises ProtocolError where the hello has no counts per inch."""
        cpi = cpi_of(hello)
        if cpi is None:
            sentence = "assistance needs the counts per inch of the device"
            raise ProtocolError("bad_field", sentence, "$.device.cpi", field="cpi")
        function = ConstantGain(assist.gain) if assist.function == "constant" else SigmoidGain()
        self._transfer = GuardedTransfer(
            function, cpi=cpi, dpi=dpi_of(hello), rho=assist.rho, strength=assist.strength
        )
        self._screen = hello.screen
        self._place: tuple[float, float] | None = None  # px; not before the first event
        self._added_px = 0.0
        self._guidance: tuple[float, ...] = ()  # the newest endpoint and its covariance

    def check(self, table: FloatArray) -> None:
        """Raise ProtocolError for the first event that cannot be used or has no counts."""
        check_numbers(table)
        missing = np.isnan(table[:, 3])
        if missing.any():
            path = f"$.events[{int(missing.argmax())}][3]"
            sentence = "assistance needs counts: dx and dy must be numbers"
            raise ProtocolError("bad_field", sentence, path, field="dx")

    def move(self, row: Row) -> Row:
        """The event where its counts bring the cursor, within the screen; raises EventError."""
        t, x, y, dx, dy, buttons = row
        x, y = self._place or (x, y)
        guidance = UNGUIDED
        if self._guidance:
            to_x, to_y, sxx, sxy, syy = self._guidance
            if abs(to_x - x) <= LARGEST and abs(to_y - y) <= LARGEST:
                guidance = (to_x - x, to_y - y, sxx, sxy, syy)
        accepted, px, py, added_x, added_y = self._transfer.advance((t, dx, dy, *guidance))
        if accepted != accepted:
            raise EventError(f"t = {t!r} s with counts {dx!r}, {dy!r} cannot be used")
        self._added_px += hypot(added_x, added_y)
        width, height = (self._screen.width_px, self._screen.height_px) if self._screen else (None, None)
        self._place = place = _within(x + px, width), _within(y + py, height)
        return t, *place, dx, dy, buttons

    def guide(self, prediction: Row) -> None:
        """The newest prediction guides the next event."""
        _, x, y, sxx, sxy, syy, _, _, tail, _ = prediction
        self._guidance = (x, y, *as_normal(sxx, sxy, syy, tail)) if x == x else ()

    def cursor(self, t: float) -> str:
        """Where the cursor is after the events up to ``t``, as the client is told."""
        assert self._place is not None
        return encode(Cursor(t, *self._place, self._added_px)).decode()

    def follow(self, other: Assistance) -> None:
        """Go on where another one has brought the cursor."""
        self._place, self._added_px, self._guidance = other._place, other._added_px, other._guidance

    def reset(self) -> None:
        """Forget every event, but not where the cursor is."""
        self._transfer.reset()
        self._guidance = ()

    def remembered(self) -> Memory:
        """All that changes."""
        return self._transfer.remembered(), self._place, self._added_px, self._guidance

    def recall(self, memory: Memory) -> None:
        """Be as at the time of ``remembered``."""
        transfer, self._place, self._added_px, self._guidance = memory
        self._transfer.recall(transfer)


def _within(place: float, size: float | None) -> float:
    """A coordinate on a screen of a size; without one, within what a pipeline takes."""
    if size is None:
        return min(max(place, -LARGEST), LARGEST)
    return min(max(place, 0.0), max(size - 1.0, 0.0))
