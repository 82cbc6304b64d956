"""What a session still has to say: bounded, and predictions give way to newer ones.

A client that reads slowly gets the newest prediction and is told how many it missed. However many gave way
says nothing of whether it reads, for one frame may hold a thousand: only time does, which the connection
keeps.
"""

from __future__ import annotations

from pointpred.server.messages import ErrorMessage, encode

Frame = str | bytes


class Outbox:
    """Frames in the order in which they are to be sent; not safe for threads."""

    def __init__(self, *, most_notes: int = 1024) -> None:
        self.most_notes = most_notes
        self.dropped = 0
        """Predictions replaced by newer ones since the client last read."""
        self.dropped_in_all = 0
        self.predicted = 0
        """Predictions in all, those that gave way included."""
        self._notes: list[Frame] = []
        self._newest: list[Frame] = []
        self._count = 0
        self._after = 0  # how many notes were there before the newest prediction

    def say(self, frame: Frame) -> None:
        """Add a frame that must not be lost."""
        self._notes.append(frame)

    def predict(self, frames: list[Frame], count: int) -> None:
        """Add the answer to the newest events, ``count`` predictions; unsent older ones give way."""
        self.dropped += self._count
        self.dropped_in_all += self._count
        self.predicted += count
        self._newest, self._count, self._after = frames, count, len(self._notes)

    @property
    def full(self) -> bool:
        """Whether more waits to be said than a client may leave unread."""
        return len(self._notes) > self.most_notes

    @property
    def waiting(self) -> int:
        """Predictions that are still to be sent."""
        return self._count

    def __bool__(self) -> bool:
        return bool(self._notes or self._newest)

    def take(self) -> list[Frame]:
        """Everything to send now, in the order in which it was said."""
        newest, self._newest, self._count = self._newest, [], 0
        if not self._notes and not self.dropped:
            return newest
        if self.dropped:
            said = f"{self.dropped} predictions gave way to newer ones because they were not read in time"
            newest = [encode(ErrorMessage("slow", said)).decode(), *newest]
            self.dropped = 0
        notes, self._notes = self._notes, []
        return [*notes[: self._after], *newest, *notes[self._after :]]
