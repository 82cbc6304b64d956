"""What the service still owes: a frame of events is answered by predictions, by an error, or by both."""

from __future__ import annotations

from collections import deque

from pointpred.columns import FloatArray
from pointpred.protocol.decoding import check_numbers
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import ErrorMessage

NEVER = float("-inf")


class _Frame:
    """One frame as sent; ``follow`` says what it is owed."""

    def __init__(self, table: FloatArray, *, begins: bool, each: bool) -> None:
        self.table = table
        self.times: list[float] = table[:, 0].tolist()
        self.begins = begins
        self.each = each
        self.newest = NEVER
        self.owed: deque[float] = deque()
        """Times of the predictions that are to come."""
        self.late = False
        """Whether an error is to come, because events run backwards."""

    def usable(self) -> bool:
        """Whether the service's own check lets every number pass."""
        try:
            check_numbers(self.table)
        except ProtocolError:
            return False
        return True

    def follow(self, newest: float) -> float:
        """The service drops what lies before ``newest``; returns the newest time after this frame."""
        newest, kept = NEVER if self.begins else newest, []
        for t in self.times:
            if t >= newest:
                newest = t
                kept.append(t)
        self.owed = deque(kept if self.each else kept[-1:])
        self.late = len(kept) < len(self.times)
        self.newest = newest
        return newest


class Awaited:
    """The frames of a session that are not answered yet, oldest first.

    Answers come in the order of the frames, but predictions may give way to newer ones: then errors come
    before the newest. Holds what was sent since the last answer, which is as much as the service takes
    before it gives up a client that does not read.
    """

    def __init__(self) -> None:
        self._frames: deque[_Frame] = deque()
        self._taken = NEVER  # the newest time the service had taken in before the oldest frame
        self._begins = False
        self._gave_way = False

    def __bool__(self) -> bool:
        return bool(self._frames)

    def ask(self, table: FloatArray, *, each: bool) -> None:
        """A frame is sent; ``each``: one prediction an event, otherwise one for the newest."""
        frame = _Frame(table, begins=self._begins, each=each)
        frame.follow(self._frames[-1].newest if self._frames else self._taken)
        self._frames.append(frame)
        self._begins = False

    def restart(self) -> None:
        """The service forgets its events: the next one may have any time."""
        self._begins = True

    def gave_way(self) -> None:
        """Predictions were replaced by those that come next."""
        self._gave_way = True

    def predicted(self, t: float) -> None:
        """A prediction came: nothing is owed any more to the frames before its own."""
        frames = self._frames
        if self._gave_way or not (frames and frames[0].owed and frames[0].owed[0] == t):
            place = self._place(t)
            self._gave_way = False
            if place is None:
                return
            self._settle(place)
            if t not in frames[0].owed:  # thought to be late, because of one that the service refused
                frames[0].begins = True
                self._follow()
        owed = frames[0].owed
        while owed and owed.popleft() != t:
            pass
        if not owed and not frames[0].late:
            self._settle(1)

    def refused(self, error: ErrorMessage) -> None:
        """An error came; one about events answers a frame, others and the end of a session do not."""
        if not (error.recoverable and error.path is not None and error.path.startswith("$.events")):
            return
        if error.code == "out_of_order":
            late = next((k for k, frame in enumerate(self._frames) if frame.late), None)
            self._settle(0 if late is None else late + 1)
        elif self._frames:  # dropped whole: the service is as if it had not been sent
            self._settle(self._unusable())
            if self._frames.popleft().begins:
                self._taken = NEVER
            self._follow()

    def _place(self, t: float) -> int | None:
        """Which frame a prediction answers: where some gave way, the newest of equal times speaks for all."""
        holding = [k for k, frame in enumerate(self._frames) if t in frame.times]
        places = [k for k in holding if t in self._frames[k].owed] or holding
        return places[-1 if self._gave_way else 0] if places else None

    def _unusable(self) -> int:
        """Which frame was refused for its numbers: the oldest, unless predictions before it gave way."""
        return next((k for k, frame in enumerate(self._frames) if not frame.usable()), 0)

    def _settle(self, count: int) -> None:
        for _ in range(count):
            self._taken = self._frames.popleft().newest

    def _follow(self) -> None:
        newest = self._taken
        for frame in self._frames:
            newest = frame.follow(newest)
