"""Who follows the events of a session: the recorder does."""

from __future__ import annotations

from typing import Protocol

from pointpred.protocol.client_messages import Conditions, Goal, Hello
from pointpred.records import EventColumns, PredictionColumns


class SessionObserver(Protocol):
    """Follows the events of a session, as a recorder does; no method may raise."""

    def configure(self, hello: Hello) -> None:
        """The predictor and its parameters from now on."""

    def events(self, table: EventColumns, predictions: PredictionColumns) -> None:
        """The events that the pipeline took in, and the prediction after each."""

    def trial(self, action: str, target: Goal | None = None, conditions: Conditions | None = None) -> None:
        """A trial starts, or ends: then with all that is known of what it was."""

    def close(self) -> None:
        """The session has ended."""
