"""The frames of events without an answer yet: predictions, an error, or both will answer them."""

from __future__ import annotations

from collections import deque

from pointpred.protocol.decoding import check_numbers
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import ErrorMessage
from pointpred.records import FloatArray

NEVER = float("-inf")


class _Frame:
    """One frame as sent; ``update`` determines the answers to expect."""

    def __init__(self, table: FloatArray, *, begins: bool, each: bool) -> None:
        self.table = table
        self.times: list[float] = table[:, 0].tolist()
        self.begins = begins
        self.each = each
        self.newest = NEVER
        self.expected: deque[float] = deque()
        """Times of the predictions to expect."""
        self.late = False
        """Whether to expect an error, because events run backwards."""

    def usable(self) -> bool:
        """Whether the service's own check accepts every number."""
        try:
            check_numbers(self.table)
        except ProtocolError:
            return False
        return True

    def update(self, newest: float) -> float:
        """Expect that events before ``newest`` are dropped; returns the newest time after this frame."""
        newest, used = NEVER if self.begins else newest, []
        for t in self.times:
            if t >= newest:
                newest = t
                used.append(t)
        self.expected = deque(used if self.each else used[-1:])
        self.late = len(used) < len(self.times)
        self.newest = newest
        return newest


class UnansweredFrames:
    """The frames of a session that are not answered yet, oldest first.

    Answers come in the order of the frames, but newer predictions may replace older ones: then errors come
    before the newest. Holds what was sent since the last answer, which is as much as the service takes
    before it ends the session of a client that does not read.
    """

    def __init__(self) -> None:
        self._frames: deque[_Frame] = deque()
        self._taken = NEVER  # the newest time the service had taken in before the oldest frame
        self._begins = False
        self._skipped = False

    def __bool__(self) -> bool:
        return bool(self._frames)

    def add(self, table: FloatArray, *, each: bool) -> None:
        """A frame is sent; ``each``: one prediction an event, otherwise one for the newest."""
        frame = _Frame(table, begins=self._begins, each=each)
        frame.update(self._frames[-1].newest if self._frames else self._taken)
        self._frames.append(frame)
        self._begins = False

    def restart(self) -> None:
        """The service forgets its events: the next one may have any time."""
        self._begins = True

    def skip(self) -> None:
        """The predictions that come next have replaced older ones."""
        self._skipped = True

    def answer(self, t: float) -> None:
        """A prediction came: nothing more is expected for the frames before its own."""
        frames = self._frames
        if self._skipped or not (frames and frames[0].expected and frames[0].expected[0] == t):
            place = self._index_of(t)
            self._skipped = False
            if place is None:
                return
            self._remove(place)
            if t not in frames[0].expected:  # taken for late, because of an event that the service refused
                frames[0].begins = True
                self._update()
        expected = frames[0].expected
        while expected and expected.popleft() != t:
            pass
        if not expected and not frames[0].late:
            self._remove(1)

    def refuse(self, error: ErrorMessage) -> None:
        """An error came; one about events answers a frame, others and the end of a session do not."""
        if not (error.recoverable and error.path is not None and error.path.startswith("$.events")):
            return
        if error.code == "out_of_order":
            late = next((k for k, frame in enumerate(self._frames) if frame.late), None)
            self._remove(0 if late is None else late + 1)
        elif self._frames:  # dropped whole: the service is as if it had not been sent
            self._remove(self._unusable())
            if self._frames.popleft().begins:
                self._taken = NEVER
            self._update()

    def _index_of(self, t: float) -> int | None:
        """Which frame a prediction answers; of equal times the newest one, where some were replaced."""
        holding = [k for k, frame in enumerate(self._frames) if t in frame.times]
        places = [k for k in holding if t in self._frames[k].expected] or holding
        return places[-1 if self._skipped else 0] if places else None

    def _unusable(self) -> int:
        """Which frame was refused for its numbers: the oldest, unless predictions before it were replaced."""
        return next((k for k, frame in enumerate(self._frames) if not frame.usable()), 0)

    def _remove(self, count: int) -> None:
        for _ in range(count):
            self._taken = self._frames.popleft().newest

    def _update(self) -> None:
        newest = self._taken
        for frame in self._frames:
            newest = frame.update(newest)
