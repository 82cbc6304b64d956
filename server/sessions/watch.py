"""Who may look on while a session goes."""

from __future__ import annotations

from typing import Protocol

from pointpred.columns import EventColumns, PredictionColumns
from pointpred.protocol.client_messages import Goal, Hello


class Watch(Protocol):
    """Who is told what a session takes in, such as a recorder; nothing of it may raise."""

    def configure(self, hello: Hello) -> None:
        """The predictor and its parameters from now on."""

    def events(self, table: EventColumns, predictions: PredictionColumns) -> None:
        """The events that the pipeline took in, and what it answered to each."""

    def trial(self, action: str, target: Goal | None = None) -> None:
        """A trial starts or ends."""

    def close(self) -> None:
        """The session has ended."""
