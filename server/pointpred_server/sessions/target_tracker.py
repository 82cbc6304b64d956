"""The targets of a session: how likely each is, which is proposed, and how good the proposals were."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, cast

from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.protocol.client_messages import Goal, Rectangle
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import Likeliest
from pointpred.protocol.server_messages import ChoiceMessage, Likely
from pointpred.targets import Choice, Chooser
from pointpred.targets.rectangles import NOBODY
from pointpred_server.sessions.outbox import Outbox

LIKELIEST = 5
"""Targets that are sent with a prediction."""
PRECISION = next(bound for bound in Chooser.parameters if bound.name == "precision")


def within_bounds(precision: float) -> float:
    """A share between 0 and 1, within the bounds of choosers."""
    return min(max(precision, PRECISION.low), PRECISION.high)


class Outcome(NamedTuple):
    """How good the proposals of a trial were, as in ``Score``."""

    fired: int
    hit: bool
    wasted: int
    lead_s: float | None


class TargetTracker:
    """Decides among the targets of a session; what it proposes and retracts goes into the outbox.

    Memory: the chooser's, which grows with the targets only.
    """

    def __init__(self, outbox: Outbox, pipeline: Pipeline, precision: float | None = None) -> None:
        self._outbox = outbox
        self._chooser = Chooser(pipeline)
        self.targets: Sequence[Rectangle] = ()
        self._last_t: float | None = None
        if precision is not None:
            self.configure(precision)

    @property
    def pipeline(self) -> Pipeline:
        """Whose targets it decides among."""
        return cast(Pipeline, self._chooser.pipeline)

    @pipeline.setter
    def pipeline(self, pipeline: Pipeline) -> None:
        self._chooser.pipeline = pipeline

    def configure(self, precision: float) -> None:
        """The share of proposals that shall be right, brought within the bounds of the chooser."""
        self._chooser.configure(precision=within_bounds(precision))

    def replace(self, targets: Sequence[Rectangle]) -> None:
        """Replace the targets; a proposal of one that is gone is retracted. Raises ProtocolError."""
        try:
            self.pipeline.register(targets)
        except ParameterError as error:
            raise ProtocolError(
                "bad_field", str(error), "$.targets", field=error.field, value=error.value
            ) from None
        self.targets = targets
        self._announce(self._chooser.follow_targets())

    def reset(self) -> None:
        """Forget every event; what is proposed is retracted."""
        for id in (self._chooser.standing, self._chooser.entered):
            if id is not None:
                self._announce([Choice(id, 0.0, "retract")])
        self._chooser.reset()
        self._last_t = None

    def follow(self) -> Likeliest:
        """Decide after the pipeline's last event; choices go into the outbox."""
        aim = self.pipeline.aim
        self._last_t = float(aim.cursor.t)
        self._announce(self._chooser.update())
        likely = [Likely(str(id), p) for id, p in aim.likeliest(LIKELIEST)]
        place = int(aim.shares.argmax())
        return Likeliest(place if place < len(aim.ids) else NOBODY, likely)

    def _announce(self, choices: Sequence[Choice]) -> None:
        for id, p, action, reason, _ in choices:
            self._outbox.add_choice(ChoiceMessage(str(id), p, action, self._last_t, reason))

    def finish_trial(self, goal: Goal | None) -> Outcome | None:
        """Finish the movement: how good its proposals were, ``None`` where the goal is unknown."""
        if goal is None:
            return None
        movement = self._chooser.finish(self._target_at(goal))
        return Outcome(movement.proposed, movement.hit, movement.wasted, movement.lead_entry_s)

    def _target_at(self, goal: Goal) -> str | None:
        """The target that holds the goal's centre, the one with the nearest centre; ``None`` without any."""

        def distance(one: Rectangle) -> tuple[float, float]:
            return abs(one.x + one.width / 2 - goal.x), abs(one.y + one.height / 2 - goal.y)

        around = [
            one
            for one in self.targets
            if distance(one)[0] <= one.width / 2 and distance(one)[1] <= one.height / 2
        ]
        return min(around, key=lambda one: sum(distance(one))).id if around else None
