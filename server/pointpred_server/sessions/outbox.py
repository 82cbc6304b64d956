"""What a session has still to send: bounded, and predictions give way to newer ones.

A client that reads slowly gets the newest prediction and is told how many it missed. The number of missed
predictions does not show whether a client still reads, because one frame of events may bring a thousand
predictions. The connection therefore goes by the time since the client last read.
"""

from __future__ import annotations

from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import ChoiceMessage, ErrorMessage, encode

Note = Frame | ChoiceMessage
MOST_CHOICES = 64
"""At most so many choices wait to be read; of more, only those that still change what is proposed stay."""


class Outbox:
    """Frames in the order in which they are to be sent; not safe for threads."""

    def __init__(self, *, most_notes: int = 1024) -> None:
        self.most_notes = most_notes
        self.dropped = 0
        """Predictions that newer ones replaced since the client last read."""
        self.dropped_total = 0
        self.predictions = 0
        """All predictions, dropped ones included."""
        self._notes: list[Note] = []
        self._newest: list[Frame] = []
        self.waiting = 0
        """How many predictions wait to be sent."""
        self._after = 0  # how many notes were there before the newest prediction
        self._choices = 0  # how many of the notes are choices
        self._dropped_choices = 0
        self._proposed: frozenset[str] = frozenset()  # targets proposed as far as the client knows

    def add(self, frame: Frame) -> None:
        """Add a frame that must not be lost."""
        self._notes.append(frame)

    def add_choice(self, choice: ChoiceMessage) -> None:
        """Add a proposal or its end; of many, those that still change what is proposed are not lost."""
        self._notes.append(choice)
        self._choices += 1
        if self._choices > MOST_CHOICES:
            self._shorten()

    def predict(self, frames: list[Frame], count: int) -> None:
        """Set the answer to the newest events, ``count`` predictions; unsent older ones are dropped."""
        self.dropped += self.waiting
        self.dropped_total += self.waiting
        self.predictions += count
        self._newest, self.waiting, self._after = frames, count, len(self._notes)

    @property
    def full(self) -> bool:
        """Whether more waits than a client may leave unread."""
        return len(self._notes) > self.most_notes

    def __bool__(self) -> bool:
        return bool(self._notes or self._newest)

    def take(self) -> list[Frame]:
        """Everything to send now, in order; then the outbox is empty."""
        newest, self._newest, self.waiting = self._newest, [], 0
        if not self._notes and not self.dropped:
            return newest
        if self.dropped or self._dropped_choices:
            newest = [encode(ErrorMessage("slow", self._loss())).decode(), *newest]
            self.dropped = self._dropped_choices = 0
        notes, self._notes = self._notes, []
        if self._choices:
            self._proposed = proposed_after(self._proposed, notes)
            self._choices = 0
        before, after = (
            [_frame(note) for note in part] for part in (notes[: self._after], notes[self._after :])
        )
        return [*before, *newest, *after]

    def _loss(self) -> str:
        lost = [f"{self.dropped} predictions"] if self.dropped else []
        lost += [f"{self._dropped_choices} choices"] if self._dropped_choices else []
        return f"{' and '.join(lost)} gave way to newer ones because they were not read in time"

    def _shorten(self) -> None:
        """Drop the choices but for those that lead from what the client knows to what is proposed."""
        proposed = proposed_after(self._proposed, self._notes)
        choices = [note for note in self._notes if isinstance(note, ChoiceMessage)]
        ended, begun = self._proposed - proposed, proposed - self._proposed
        ends = {one.id: one for one in choices if one.action == "retract" and one.id in ended}
        begins = {one.id: one for one in choices if one.action == "propose" and one.id in begun}
        others: list[Note] = [note for note in self._notes if not isinstance(note, ChoiceMessage)]
        self._after -= sum(isinstance(note, ChoiceMessage) for note in self._notes[: self._after])
        left = [*ends.values(), *begins.values()]
        self._dropped_choices += self._choices - len(left)
        self._notes, self._choices = [*others, *left], len(left)


def proposed_after(before: frozenset[str], notes: list[Note]) -> frozenset[str]:
    """The targets that are proposed after these notes, where those ``before`` were proposed."""
    for note in notes:
        if isinstance(note, ChoiceMessage):
            before = before | {note.id} if note.action == "propose" else before - {note.id}
    return before


def _frame(note: Note) -> Frame:
    return encode(note).decode() if isinstance(note, ChoiceMessage) else note
