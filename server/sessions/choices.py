"""The targets of a session: how likely each is, what is proposed, and what came of it in a trial."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from pointpred.columns import FloatArray
from pointpred.errors import ParameterError
from pointpred.protocol.client_messages import Goal, Target
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Choice, Likely
from pointpred.server.sessions.outbox import Outbox
from pointpred.targets import Choice as Change
from pointpred.targets import Chooser
from pointpred.targets import Target as Rectangle

LIKELIEST = 5
"""Targets told with a prediction."""
PRECISION = next(bound for bound in Chooser.parameters if bound.name == "precision")

AT_ONCE = 4096
"""Events times targets that are looked at while others wait: about a millisecond."""


class Taken(NamedTuple):
    """What came of events: what has changed, with its times, and the likeliest targets of each told event."""

    changes: list[tuple[float, Change]]
    likely: list[list[Likely]]


class Choices:
    """One chooser over the targets of a session; what it decides goes into the outbox.

    Memory: the chooser's, which grows with the targets only.
    """

    def __init__(self, outbox: Outbox, precision: float | None = None) -> None:
        self._outbox = outbox
        self._chooser = Chooser()
        self._targets: Sequence[Target] = ()
        self._last_t: float | None = None
        if precision is not None:
            self.configure(precision)

    def configure(self, precision: float) -> None:
        """The share of proposals that shall be right; 0 and 1 mean as near to them as the decisions go."""
        self._chooser.configure(precision=min(max(precision, PRECISION.low), PRECISION.high))

    def replace(self, targets: Sequence[Target]) -> None:
        """Take other targets; a proposal of one that is gone is retracted. Raises ProtocolError."""
        rectangles = [Rectangle(one.id, one.x, one.y, one.width, one.height, one.weight) for one in targets]
        try:
            changes = self._chooser.replace(rectangles)
        except ParameterError as error:
            raise ProtocolError("bad_field", str(error), "$.targets") from None
        self._targets = targets
        self.say([(self._last_t, change) for change in changes])

    def reset(self) -> None:
        """Forget every event; what is proposed is retracted."""
        proposed = (self._chooser.standing, self._chooser.entered)
        self.say([(self._last_t, Change(id, 0.0, "retract")) for id in proposed if id is not None])
        self._chooser.reset()
        self._last_t = None

    def heavy(self, events: int) -> bool:
        """Whether so many events would keep others waiting."""
        return events * len(self._targets) > AT_ONCE

    def take(self, table: FloatArray, predictions: FloatArray, *, each: bool) -> Taken:
        """Take events that a pipeline took in, and its predictions; any thread may run it.

        Returns what has changed, and the likeliest targets: after each event, or after the last.
        """
        last = len(table) if each else 1
        changes, likely = self._chooser.follow(table, predictions, most=LIKELIEST, last=last)
        self._last_t = float(table[-1, 0])
        return Taken(changes, [[Likely(str(id), p) for id, p in one] for one in likely])

    def say(self, changes: Sequence[tuple[float | None, Change]]) -> None:
        """What has changed, to the client."""
        for t, (id, p, action, reason) in changes:
            self._outbox.choose(Choice(str(id), p, action, t, reason))

    def account(self, goal: Goal | None) -> dict[str, Any]:
        """Close the movement; what a score says of its proposals, nothing where the goal is unknown."""
        if goal is None:
            return {}
        movement = self._chooser.finish(self._named(goal))
        return {
            "fired": movement.proposed,
            "hit": movement.hit,
            "wasted": movement.wasted,
            "lead_s": movement.lead_entry_s,
        }

    def _named(self, goal: Goal) -> str | None:
        """The target that a goal lies in, the one with the nearest centre; ``None`` where there is none."""

        def off(one: Target) -> tuple[float, float]:
            return abs(one.x + one.width / 2 - goal.x), abs(one.y + one.height / 2 - goal.y)

        held = [
            one for one in self._targets if off(one)[0] <= one.width / 2 and off(one)[1] <= one.height / 2
        ]
        return min(held, key=lambda one: sum(off(one))).id if held else None
