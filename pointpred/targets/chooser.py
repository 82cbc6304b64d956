"""Predictions and events in, proposals out."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import Literal, NamedTuple

import numpy as np

from pointpred.parameter import Parameter, check
from pointpred.records import FloatArray, Place, PointerEvent, Prediction, Row, prediction_row
from pointpred.targets import cursor, decision, expectation, posterior
from pointpred.targets.choice_law import (
    ENTERED,
    INSIDE,
    OUTSIDE,
    RELEASED,
    Model,
    Targets,
    step,
    step_with_shares,
    walk,
)
from pointpred.targets.expectation import expect
from pointpred.targets.inputs import accepted, check_places, refuse, usable
from pointpred.targets.ledger import Ledger, Movement
from pointpred.targets.rectangles import LOG_WEIGHT, Target, table

Reason = Literal["predicted", "entered"]


class Choice(NamedTuple):
    """A change of mind: the target, its share at that moment, what to do with it, and why it is proposed.

    ``reason``: *predicted*, the movement heads for it; *entered*, the cursor has gone into it and no
    prediction had said so before; ``None`` where it is retracted.
    """

    id: Hashable
    p: float
    action: Literal["propose", "retract"]
    reason: Reason | None = None


class Chooser:
    """Proposes the rectangle that the cursor is heading for, once that is likely enough.

    At most two targets are proposed at a time: the one that is predicted, and the one that the cursor is in
    if that is another. A target therefore has its choice when the cursor enters it at the latest. Of targets
    that overlap, the smallest counts as entered, of equal ones the last. A proposal ends when the prediction
    drops it, when the cursor leaves it, and when the button comes up.

    Parameters: ``precision`` is the share of proposals that shall be right; ``elsewhere`` the share of
    movements that go to none of the targets, before anything is seen; ``least_lead_s`` s, a target that the
    cursor enters sooner is not predicted; ``least_way_px`` px, how far the cursor must be from where its
    movement started before anything is predicted: nearer, nobody can say that a movement has begun. Memory:
    15 floats of the cursor, 10 of the last prediction, 7 a target, the ledger. Raises ParameterError, and
    EventError or EventOrderError from ``update`` and ``follow``; nothing is then changed.

    >>> from pointpred import build
    >>> from pointpred.targets import around
    >>> chooser, pipeline = Chooser(precision=0.6), build("minimum-jerk")
    >>> _ = chooser.replace([around("left", -400.0, 0.0, 40.0), around("right", 400.0, 0.0, 40.0)])
    >>> for i in range(30):
    ...     event = PointerEvent(i / 100, 400.0 * (i / 60) ** 2 * (3 - 2 * i / 60), 0.0)
    ...     for choice in chooser.update(pipeline.update(event), event):
    ...         print(choice.id, choice.action, choice.reason)
    right propose predicted
    """

    parameters = (
        Parameter("precision", "", 0.01, 0.999, "share of proposals that shall be right"),
        Parameter("elsewhere", "", 1e-6, 0.999999, "share of movements that go to none of the targets"),
        Parameter("least_lead_s", "s", 0.0, 10.0, "what the cursor enters sooner is not predicted"),
        Parameter("least_way_px", "px", 0.0, 1000.0, "nothing is predicted nearer to the movement's start"),
    )

    def __init__(
        self,
        targets: Sequence[Target] = (),
        *,
        precision: float = 0.5,
        elsewhere: float = 0.02,
        least_lead_s: float = 0.0,
        least_way_px: float = 3.0,
        coefficients: FloatArray = posterior.FITTED,
    ) -> None:
        self._answer: Row = prediction_row(None)
        settings = (precision, elsewhere, least_lead_s, least_way_px)
        names = (parameter.name for parameter in self.parameters)
        check(self.parameters, dict(zip(names, settings, strict=True)))
        self._settings = np.array(settings, dtype=np.float64)
        self._coefficients = usable(coefficients)
        self._memory = np.zeros(cursor.STATES)
        self._standing = self._over = decision.NOBODY
        self._inside = np.zeros(0)
        self._ids: tuple[Hashable, ...] = ()
        self._known = np.zeros((0, expectation.FIELDS))
        self.ledger = Ledger()
        self.replace(targets)

    def configure(
        self,
        *,
        precision: float | None = None,
        elsewhere: float | None = None,
        least_lead_s: float | None = None,
        least_way_px: float | None = None,
    ) -> None:
        """Change these parameters from the next event on; raises ParameterError and then changes nothing."""
        settings = (precision, elsewhere, least_lead_s, least_way_px)
        names = (parameter.name for parameter in self.parameters)
        values = {name: value for name, value in zip(names, settings, strict=True) if value is not None}
        check(tuple(p for p in self.parameters if p.name in values), values)
        for place, parameter in enumerate(self.parameters):
            self._settings[place] = values.get(parameter.name, self._settings[place])

    def replace(self, targets: Sequence[Target]) -> tuple[Choice, ...]:
        """Take other targets, at any time; a proposal of one that is gone is withdrawn.

        Raises ParameterError for too many, or for one out of bounds; the old ones are then kept.
        """
        rows, standing, over = table(targets), self.standing, self.entered
        where = {self._ids[i]: INSIDE if value == ENTERED else value for i, value in enumerate(self._inside)}
        self._table, self._ids = rows, tuple(target.id for target in targets)
        self._own = rows[:, LOG_WEIGHT].copy()
        if len(self._known):
            expect(self._table, self._own, self._known)
        self._shares = np.zeros(len(rows) + 1)
        self._shares[-1] = 1.0
        self._inside = np.array([where.get(id, OUTSIDE) for id in self._ids])
        self._standing, self._over = self._place(standing), self._place(over)
        if standing is not None and self._standing == decision.NOBODY:
            self.ledger.retract(self._memory[cursor.T], standing)
        return tuple(
            Choice(id, 0.0, "retract")
            for id, place in ((standing, self._standing), (over, self._over))
            if id is not None and place == decision.NOBODY
        )

    def expect(self, places: Sequence[Place]) -> None:
        """Take the person's past into account, from ``Pipeline.places``, best at a movement's first events.

        Of n targets, one of weight w in which places lie, or so near that visits of them end in it, gets
        the weight w (1 + n b), b the sum of their ``before``; also targets that are registered later. An
        empty list, as at first, leaves the weights as they are given. Raises ParameterError for places that
        are not usable; nothing is then changed.
        """
        check_places(places)
        known = [(place.x, place.y, place.before, place.spread) for place in places]
        self._known = np.array(known, dtype=np.float64).reshape(-1, expectation.FIELDS)
        expect(self._table, self._own, self._known)

    def _place(self, id: Hashable | None) -> int:
        return self._ids.index(id) if id is not None and id in self._ids else decision.NOBODY

    @property
    def _targets(self) -> Targets:
        return self._table, self._inside, self._shares

    @property
    def _model(self) -> Model:
        return self._coefficients, self._settings

    @property
    def standing(self) -> Hashable | None:
        """The target that is predicted now."""
        return None if self._standing == decision.NOBODY else self._ids[self._standing]

    @property
    def entered(self) -> Hashable | None:
        """The target that is proposed because the cursor is in it, while it is not the predicted one."""
        return None if self._over == decision.NOBODY else self._ids[self._over]

    @property
    def shares(self) -> FloatArray:
        """How likely each target is after the last event, in their order; the last is *none of them*."""
        return self._shares.copy()

    def likeliest(self, most: int = 5) -> list[tuple[Hashable, float]]:
        """The likeliest targets and their shares, best first."""
        shares = self._shares[:-1]
        order = np.argsort(-shares, kind="stable")[:most]
        return [(self._ids[i], float(shares[i])) for i in order.tolist()]

    def heading_to(self, target: Target, *, elsewhere: float = 0.5) -> float:
        """How likely the cursor is heading for this rectangle, which need not be among the targets.

        The choice is between it and anywhere else, where ``elsewhere`` of movements go before anything is
        seen; as it was after the last event. Raises ParameterError.
        """
        check(self.parameters[1:2], {"elsewhere": elsewhere})
        rows, shares = table([target]), np.empty(2)
        posterior.scores(self._memory, rows, self._answer, self._coefficients, elsewhere, shares)
        posterior.normalise(shares)
        return float(shares[0])

    def update(self, prediction: Prediction | None, event: PointerEvent) -> tuple[Choice, ...]:
        """Take an event and the prediction made at it; what has changed, ends of proposals first.

        At most four choices. Raises EventError for an event that is not finite, EventOrderError for one
        before the last.
        """
        memory = self._memory
        row = accepted(memory, event)
        t, _, _, pressed = row
        self._answer = prediction_row(prediction)
        released = memory[cursor.PRESSED] > pressed
        chosen, over, entered = step(memory, row, self._answer, self._targets, self._model, self._standing)
        if chosen == self._standing and over == self._over and not entered:
            return ()
        return self._note(t, chosen, over, entered, released)

    def check_event(self, event: PointerEvent) -> None:
        """Raise EventError or EventOrderError for an event that ``update`` would refuse."""
        accepted(self._memory, event)

    def update_with_shares(
        self, shares: FloatArray, remaining_s: float, event: PointerEvent
    ) -> tuple[Choice, ...]:
        """``update`` where something else says how likely each target is: the same decisions follow.

        ``shares``: of each target in their order, and of none of them; they sum to 1. ``remaining_s``: the
        time left that is predicted, NaN where none is.
        """
        memory = self._memory
        row = accepted(memory, event)
        t, _, _, pressed = row
        self._shares[:] = shares
        released = memory[cursor.PRESSED] > pressed
        chosen, over, entered = step_with_shares(
            memory, row, remaining_s, self._targets, self._settings, self._standing
        )
        if chosen == self._standing and over == self._over and not entered:
            return ()
        return self._note(t, chosen, over, entered, released)

    def follow(
        self, events: FloatArray, answers: FloatArray, *, most: int = 5, last: int | None = None
    ) -> tuple[list[tuple[float, Choice]], list[list[tuple[Hashable, float]]]]:
        """``update`` for many events, rows of ``EventColumns``, and the predictions made at them.

        Returns each change with its time, and the ``most`` likeliest targets after each of the ``last``
        events, all unless given. Other threads run meanwhile, except while a change is noted.
        """
        refuse(self._memory, events)
        count, done = len(events), 0
        rows = count if last is None else min(last, count)
        likeliest = np.empty((rows, 2 * min(most, len(self._table))))
        changes: list[tuple[float, Choice]] = []
        before = int(self._memory[cursor.PRESSED])
        tables = events, answers, likeliest
        while done < count:
            proposed = self._standing, self._over
            done, chosen, over, entered = walk(
                self._memory, tables, done, self._targets, self._model, proposed
            )
            t = float(events[done - 1, 0])
            if chosen != self._standing or over != self._over or entered:
                down = before if done == 1 else int(events[done - 2, 5]) & 1
                released = down > int(events[done - 1, 5]) & 1
                changes += [(t, choice) for choice in self._note(t, chosen, over, entered, released)]
        if count:
            self._answer = tuple(answers[-1].tolist())
        return changes, [self._named(row) for row in likeliest.tolist()]

    def finish(self, target: Hashable | None) -> Movement:
        """Close the movement at the last event, a click on ``target``, in the ledger.

        The proposal stands until the next movement starts: at the release, without one at the next event.
        """
        memory = self._memory
        if memory[cursor.T0] < memory[cursor.T]:
            memory[cursor.PRESSED] = 1.0
        return self.ledger.finish(float(self._memory[cursor.T]), target)

    def reset(self) -> None:
        """Forget every event and the proposals; targets, parameters and the ledger's counts stay.

        A target that the cursor is in is not entered again before the cursor has left it, as after a release.
        """
        self._memory = np.zeros(cursor.STATES)
        self._standing = self._over = decision.NOBODY
        self._answer = prediction_row(None)
        self._shares[:] = 0.0
        self._shares[-1] = 1.0
        self._inside[self._inside != OUTSIDE] = RELEASED
        self.ledger.drop()

    def _named(self, row: list[float]) -> list[tuple[Hashable, float]]:
        """The places of targets and their shares with the targets' names."""
        most = len(row) // 2
        return [(self._ids[int(place)], p) for place, p in zip(row[:most], row[most:], strict=True)]

    def _note(self, t: float, chosen: int, over: int, entered: int, released: bool) -> tuple[Choice, ...]:
        """Update the ledger and the current proposals; ends come first."""
        if entered:
            for i in np.flatnonzero(self._inside == ENTERED).tolist():
                self.ledger.enter(t, self._ids[i])
        before, self._standing = self._standing, chosen
        before_over, self._over = self._over, over
        changed: list[Choice] = []
        if before not in (chosen, decision.NOBODY):
            (self.ledger.end if released else self.ledger.retract)(t, self._ids[before])
            changed.append(self._choice(before, "retract"))
        if before_over not in (over, decision.NOBODY):
            changed.append(self._choice(before_over, "retract"))
        if chosen not in (before, decision.NOBODY):
            self.ledger.propose(t, self._ids[chosen])
            changed.append(self._choice(chosen, "propose", "predicted"))
        if over not in (before_over, decision.NOBODY):
            self.ledger.propose_entered()
            changed.append(self._choice(over, "propose", "entered"))
        # A target whose reason alone has changed stays proposed, so no change is reported.
        stays = {one.id for one in changed if one.action == "retract"} & {
            one.id for one in changed if one.action == "propose"
        }
        return tuple(one for one in changed if one.id not in stays)

    def _choice(
        self, place: int, action: Literal["propose", "retract"], reason: Reason | None = None
    ) -> Choice:
        return Choice(self._ids[place], float(self._shares[place]), action, reason)
