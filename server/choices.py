"""The targets of a session: how likely each is, what is proposed, and what came of it in a trial."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pointpred.columns import FloatArray, prediction_of
from pointpred.errors import ParameterError
from pointpred.events import PointerEvent
from pointpred.server.messages import Choice, Goal, Likely, Target
from pointpred.server.outbox import Outbox
from pointpred.server.refusals import RefusedError
from pointpred.targets import Choice as Change
from pointpred.targets import Chooser
from pointpred.targets import Target as Rectangle

LIKELIEST = 5
"""Targets told with a prediction."""
PRECISION = next(bound for bound in Chooser.parameters if bound.name == "precision")

Shares = list[Likely]


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
        """Take other targets; a proposal of one that is gone is retracted. Raises RefusedError."""
        rectangles = [Rectangle(one.id, one.x, one.y, one.width, one.height, one.weight) for one in targets]
        try:
            changes = self._chooser.replace(rectangles)
        except ParameterError as error:
            raise RefusedError("bad_field", str(error), "$.targets") from None
        self._targets = targets
        self._say(self._last_t, changes)

    def reset(self) -> None:
        """Forget every event; what is proposed is retracted."""
        if (standing := self._chooser.standing) is not None:
            self._say(self._last_t, [Change(standing, 0.0, "retract")])
        self._chooser.reset()
        self._last_t = None

    def take(self, table: FloatArray, predictions: FloatArray, *, each: bool) -> list[Shares]:
        """Take events that a pipeline took in, and its predictions; what changes is said.

        Returns the likeliest targets: after each event, or after the last.
        """
        shares: list[Shares] = []
        chooser, last = self._chooser, len(table) - 1
        for place, (event, row) in enumerate(zip(table.tolist(), predictions.tolist(), strict=True)):
            t, x, y, _, _, buttons = event
            prediction = prediction_of(row[0], tuple(row[1:]))
            self._say(t, chooser.update(prediction, PointerEvent(t, x, y, buttons=int(buttons))))
            if each or place == last:
                shares.append([Likely(str(id), p) for id, p in chooser.likeliest(LIKELIEST)])
            self._last_t = t
        return shares

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

    def _say(self, t: float | None, changes: Sequence[Change]) -> None:
        for id, p, action in changes:
            self._outbox.choose(Choice(str(id), p, action, t))
