"""The places of a session without targets: which is proposed because the person went there before."""

from __future__ import annotations

from collections.abc import Hashable
from typing import cast

from pointpred.pipeline import Pipeline
from pointpred.protocol.server_messages import ChoiceMessage, PlaceSquare
from pointpred.targets import Choice, PlaceChooser
from pointpred_server.sessions.outbox import Outbox
from pointpred_server.sessions.target_tracker import within_bounds


class PlaceTracker:
    """Decides among the places of a person; what it proposes and retracts goes into the outbox."""

    def __init__(self, outbox: Outbox, pipeline: Pipeline, precision: float | None = None) -> None:
        self._outbox = outbox
        self._chooser = PlaceChooser(pipeline)
        self._proposed: dict[Hashable, Choice] = {}
        self._last_t: float | None = None
        if precision is not None:
            self.configure(precision)

    @property
    def pipeline(self) -> Pipeline:
        """Whose places it decides among."""
        return cast(Pipeline, self._chooser.pipeline)

    @pipeline.setter
    def pipeline(self, pipeline: Pipeline) -> None:
        self._chooser.pipeline = pipeline

    def configure(self, precision: float) -> None:
        """The share of proposals that shall be right, brought within the bounds of the chooser."""
        self._chooser.configure(precision=within_bounds(precision))

    def follow(self) -> None:
        """Decide after the pipeline's last event."""
        self._last_t = float(self.pipeline.aim.cursor.t)
        for choice in self._chooser.update():
            self._announce(choice)

    def reset(self) -> None:
        """Forget every event; what is proposed is retracted."""
        for choice in list(self._proposed.values()):
            self._announce(choice._replace(p=0.0, action="retract", reason=None))
        self._chooser.reset()
        self._last_t = None

    def _announce(self, choice: Choice) -> None:
        if choice.action == "propose":
            self._proposed[choice.id] = choice
        else:
            self._proposed.pop(choice.id, None)
        square = choice.place
        assert square is not None
        place = PlaceSquare(square.x + square.width / 2.0, square.y + square.height / 2.0, square.width)
        self._outbox.add_choice(
            ChoiceMessage(f"place {choice.id}", choice.p, choice.action, self._last_t, choice.reason, place)
        )
