"""The targets of a session: how likely each is, which is proposed, and how good the proposals were."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from pointpred.errors import ParameterError
from pointpred.protocol.client_messages import Goal, Rectangle
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import Aim
from pointpred.protocol.server_messages import ChoiceMessage, Likely
from pointpred.records import FloatArray, Place
from pointpred.targets import Choice, Chooser
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

    def __init__(self, outbox: Outbox, precision: float | None = None) -> None:
        self._outbox = outbox
        self._chooser = Chooser()
        self._targets: Sequence[Rectangle] = ()
        self._last_t: float | None = None
        if precision is not None:
            self.configure(precision)

    def configure(self, precision: float) -> None:
        """The share of proposals that shall be right, brought within the bounds of the chooser."""
        self._chooser.configure(precision=within_bounds(precision))

    def replace(self, targets: Sequence[Rectangle]) -> None:
        """Replace the targets; a proposal of one that is gone is retracted. Raises ProtocolError."""
        try:
            changes = self._chooser.replace(targets)
        except ParameterError as error:
            raise ProtocolError(
                "bad_field", str(error), "$.targets", field=error.field, value=error.value
            ) from None
        self._targets = targets
        self.announce([(self._last_t, change) for change in changes])

    def expect(self, places: Sequence[Place]) -> None:
        """Take into account where the person went before."""
        self._chooser.expect(places)

    def reset(self) -> None:
        """Forget every event; what is proposed is retracted."""
        proposed = (self._chooser.standing, self._chooser.entered)
        self.announce([(self._last_t, Choice(id, 0.0, "retract")) for id in proposed if id is not None])
        self._chooser.reset()
        self._last_t = None

    def follow(
        self,
        table: FloatArray,
        predictions: FloatArray,
        seen: Sequence[Sequence[Place]] | None = None,
        *,
        each: bool,
    ) -> list[Aim]:
        """Decide after events and their predictions; choices go into the outbox.

        ``seen``: the person's places after each event, where they count; at the event where they change, the
        weights change. Returns the aim after each event with ``each``, otherwise after the last.
        """
        aims: list[Aim] = []
        for places, part in _runs(seen, len(table)):
            if places is not None:
                self.expect(places)
            last = part.stop - part.start if each else int(part.stop == len(table))
            made, likely, headed = self._chooser.follow(
                table[part], predictions[part], most=LIKELIEST, last=last
            )
            self.announce(made)
            aims += [
                Aim(place, [Likely(str(id), p) for id, p in one])
                for place, one in zip(headed, likely, strict=True)
            ]
        self._last_t = float(table[-1, 0])
        return aims

    def announce(self, choices: Sequence[tuple[float | None, Choice]]) -> None:
        """Send choices to the client."""
        for t, (id, p, action, reason) in choices:
            self._outbox.add_choice(ChoiceMessage(str(id), p, action, t, reason))

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
            for one in self._targets
            if distance(one)[0] <= one.width / 2 and distance(one)[1] <= one.height / 2
        ]
        return min(around, key=lambda one: sum(distance(one))).id if around else None


def _runs(
    seen: Sequence[Sequence[Place]] | None, events: int
) -> Iterator[tuple[Sequence[Place] | None, slice]]:
    """Runs of events, each begun where what is known before a movement changes, and their places.

    The places are in the order of their numbers, so that sums of shares do not depend on the likeliest now.
    """
    if seen is None:
        yield None, slice(0, events)
        return
    ordered = [sorted(places, key=lambda place: place.id) for places in seen]
    known = [[(place.x, place.y, place.before, place.spread) for place in places] for places in ordered]
    starts = [i for i in range(events) if i == 0 or known[i] != known[i - 1]]
    for start, stop in pairwise([*starts, events]):
        yield ordered[start], slice(start, stop)
