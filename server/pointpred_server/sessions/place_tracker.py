"""The places of a session without targets: which is proposed because the person went there before."""

from __future__ import annotations

from collections.abc import Sequence

from pointpred.protocol.server_messages import ChoiceMessage, PlaceSquare
from pointpred.records import FloatArray, Place, event_of, prediction_of
from pointpred.targets import PlaceChoice, PlaceChooser
from pointpred_server.sessions.outbox import Outbox
from pointpred_server.sessions.target_tracker import within_bounds


class PlaceTracker:
    """Decides among the places of a person; what it proposes and retracts goes into the outbox."""

    def __init__(self, outbox: Outbox, precision: float | None = None) -> None:
        self._outbox = outbox
        self._chooser = PlaceChooser()
        self._proposed: dict[int, PlaceChoice] = {}
        self._last_t: float | None = None
        if precision is not None:
            self.configure(precision)

    def configure(self, precision: float) -> None:
        """The share of proposals that shall be right, brought within the bounds of the chooser."""
        self._chooser.configure(precision=within_bounds(precision))

    def follow(self, events: FloatArray, predictions: FloatArray, seen: Sequence[tuple[Place, ...]]) -> None:
        """Decide after events, their predictions, and the places as they were after each."""
        for row, answer, places in zip(events.tolist(), predictions.tolist(), seen, strict=True):
            for choice in self._chooser.update(places, prediction_of(answer), event_of(row)):
                self._announce(row[0], choice)
        self._last_t = float(events[-1, 0])

    def reset(self) -> None:
        """Forget every event; what is proposed is retracted."""
        for choice in list(self._proposed.values()):
            self._announce(self._last_t, choice._replace(p=0.0, action="retract", reason=None))
        self._chooser.reset()
        self._last_t = None

    def _announce(self, t: float | None, choice: PlaceChoice) -> None:
        if choice.action == "propose":
            self._proposed[choice.id] = choice
        else:
            self._proposed.pop(choice.id, None)
        square = choice.place
        place = PlaceSquare(square.x + square.width / 2.0, square.y + square.height / 2.0, square.width)
        self._outbox.add_choice(
            ChoiceMessage(f"place {choice.id}", choice.p, choice.action, t, choice.reason, place)
        )
