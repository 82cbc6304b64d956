"""Predictions and events in, proposals out: of targets, and of places that nobody registered."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from math import nan
from typing import Any, Literal, NamedTuple

import numpy as np

from pointpred.parameter import Parameter, check
from pointpred.records import FloatArray, Place, PointerEvent, Prediction, Row, prediction_row
from pointpred.targets import cursor, decision, expectation, posterior
from pointpred.targets.choice_law import (
    ENTERED,
    INSIDE,
    OUTSIDE,
    RELEASED,
    Targets,
    changes,
    holder,
    step,
    step_with_shares,
    walk,
)
from pointpred.targets.expectation import LEAST_PX, P, expect, place_table
from pointpred.targets.inputs import accepted, refuse, usable
from pointpred.targets.ledger import Ledger, Movement
from pointpred.targets.posterior import EFFECTIVE, HIGHEST, LOWEST, USUAL, Settings
from pointpred.targets.rectangles import LOG_WEIGHT, Target, around, table

Action = Literal["propose", "retract"]
Reason = Literal["predicted", "entered"]
CHANGES: tuple[tuple[Action, Reason | None], ...] = (
    ("retract", None),
    ("retract", None),
    ("propose", "predicted"),
    ("propose", "entered"),
)
"""What ``choice_law.changes`` returns, in its order."""


class Choice(NamedTuple):
    """A change of mind: the target, its share at that moment, what to do with it, and why it is proposed.

    ``reason``: *predicted*, the movement heads for it; *entered*, the cursor has gone into it and no
    prediction had said so before; ``None`` where it is retracted.
    """

    id: Hashable
    p: float
    action: Action
    reason: Reason | None = None


class PlaceChoice(NamedTuple):
    """A change of mind, as ``Choice``, about a place: ``id`` of the ``Place``, ``place``: its rectangle."""

    id: int
    p: float
    action: Action
    reason: Reason | None
    place: Target


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

    parameters = tuple(
        Parameter(name, unit, getattr(LOWEST, name), getattr(HIGHEST, name), meaning)
        for name, unit, meaning in (
            ("precision", "", "share of proposals that shall be right"),
            ("elsewhere", "", "share of movements that go to none of the targets"),
            ("least_lead_s", "s", "what the cursor enters sooner is not predicted"),
            ("least_way_px", "px", "nothing is predicted nearer to the movement's start"),
        )
    )

    def __init__(
        self,
        targets: Sequence[Target] = (),
        *,
        precision: float = USUAL.precision,
        elsewhere: float = USUAL.elsewhere,
        least_lead_s: float = USUAL.least_lead_s,
        least_way_px: float = USUAL.least_way_px,
        coefficients: FloatArray = posterior.FITTED,
    ) -> None:
        self._answer: Row = prediction_row(None)
        settings = Settings(precision, elsewhere, least_lead_s, least_way_px)
        check(self.parameters, settings._asdict())
        self._settings = Settings(*map(float, settings))
        self._coefficients = usable(coefficients)
        self._cursor = cursor.State(np.zeros(cursor.State.length))
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
        given = zip(Settings._fields, settings, strict=True)
        values = {name: value for name, value in given if value is not None}
        check(tuple(p for p in self.parameters if p.name in values), values)
        self._settings = self._settings._replace(**{name: float(value) for name, value in values.items()})

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
            self.ledger.retract(self._cursor.t, standing)
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
        self._known = place_table(places)
        expect(self._table, self._own, self._known)

    def _place(self, id: Hashable | None) -> int:
        return self._ids.index(id) if id is not None and id in self._ids else decision.NOBODY

    @property
    def _targets(self) -> Targets:
        return self._table, self._inside, self._shares

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
        posterior.scores(self._cursor.memory, rows, self._answer, self._coefficients, elsewhere, shares)
        posterior.normalise(shares)
        return float(shares[0])

    def update(self, prediction: Prediction | None, event: PointerEvent) -> tuple[Choice, ...]:
        """Take an event and the prediction made at it; what has changed, ends of proposals first.

        At most four choices. Raises EventError for an event that is not finite, EventOrderError for one
        before the last.
        """
        row = accepted(self._cursor, event)
        self._answer = prediction_row(prediction)
        return self._take(row, step, self._answer, self._targets, self._coefficients, self._settings)

    def check_event(self, event: PointerEvent) -> None:
        """Raise EventError or EventOrderError for an event that ``update`` would refuse."""
        accepted(self._cursor, event)

    def update_with_shares(
        self, shares: FloatArray, remaining_s: float, event: PointerEvent
    ) -> tuple[Choice, ...]:
        """``update`` where something else says how likely each target is: the same decisions follow.

        ``shares``: of each target in their order, and of none of them; they sum to 1. ``remaining_s``: the
        time left that is predicted, NaN where none is.
        """
        row = accepted(self._cursor, event)
        self._shares[:] = shares
        return self._take(row, step_with_shares, remaining_s, self._targets, self._settings)

    def _take(
        self, row: tuple[float, float, float, float], law: Callable[..., tuple[int, int, int]], *given: Any
    ) -> tuple[Choice, ...]:
        """Run a law on an event that was accepted, and note what has changed."""
        released = self._cursor.pressed > row[3]
        return self._note(row[0], *law(self._cursor.memory, row, *given, self._standing), released)

    def follow(
        self, events: FloatArray, answers: FloatArray, *, most: int = 5, last: int | None = None
    ) -> tuple[list[tuple[float, Choice]], list[list[tuple[Hashable, float]]], list[int]]:
        """``update`` for many events, rows of ``EventColumns``, and the predictions made at them.

        Returns each change with its time; after each of the ``last`` events, all unless given, the ``most``
        likeliest targets, and the place of the one that is likeliest of all, -1 where it is none of them.
        Other threads run meanwhile, except while a change is noted.
        """
        refuse(self._cursor, events)
        count, done = len(events), 0
        rows = count if last is None else min(last, count)
        likeliest = np.empty((rows, 2 * (min(most, len(self._table)) + 1)))
        found: list[tuple[float, Choice]] = []
        before = int(self._cursor.pressed)
        tables = events, answers, likeliest
        while done < count:
            proposed = self._standing, self._over
            model = self._coefficients, self._settings
            done, chosen, over, entered = walk(
                self._cursor.memory, tables, done, self._targets, *model, proposed
            )
            t = float(events[done - 1, 0])
            down = before if done == 1 else int(events[done - 2, 5]) & 1
            released = down > int(events[done - 1, 5]) & 1
            found += [(t, choice) for choice in self._note(t, chosen, over, entered, released)]
        if count:
            self._answer = tuple(answers[-1].tolist())
        places = np.where(likeliest[:, 0] == len(self._table), decision.NOBODY, likeliest[:, 0])
        return found, [self._named(row) for row in likeliest.tolist()], places.astype(int).tolist()

    def holder(self, x: float, y: float) -> Hashable | None:
        """The smallest target that holds this point (px), of equal ones the nearest; ``None`` for none."""
        place = holder(self._table, float(x), float(y))
        return None if place == decision.NOBODY else self._ids[place]

    @property
    def cursor(self) -> tuple[float, float] | None:
        """Where the cursor is, px; ``None`` before the first event."""
        now = self._cursor
        return (now.x, now.y) if now.known == 1.0 else None

    def finish(self, target: Hashable | None) -> Movement:
        """Close the movement at the last event, a click on ``target``, in the ledger.

        The proposal stands until the next movement starts: at the release, without one at the next event.
        """
        now = self._cursor
        if now.t0 < now.t:
            now.pressed = 1.0
        return self.ledger.finish(float(now.t), target)

    def reset(self) -> None:
        """Forget every event and the proposals; targets, parameters and the ledger's counts stay.

        A target that the cursor is in is not entered again before the cursor has left it, as after a release.
        """
        self._cursor = cursor.State(np.zeros(cursor.State.length))
        self._standing = self._over = decision.NOBODY
        self._answer = prediction_row(None)
        self._shares[:] = 0.0
        self._shares[-1] = 1.0
        self._inside[self._inside != OUTSIDE] = RELEASED
        self.ledger.drop()

    def _named(self, row: list[float]) -> list[tuple[Hashable, float]]:
        """The places of targets and their shares with the targets' names; *none of them* is left out."""
        most = len(row) // 2
        pairs = [pair for pair in zip(row[:most], row[most:], strict=True) if pair[0] < len(self._ids)]
        return [(self._ids[int(place)], p) for place, p in pairs[: most - 1]]

    def _note(self, t: float, chosen: int, over: int, entered: int, released: bool) -> tuple[Choice, ...]:
        """Update the ledger and the current proposals; ends come first."""
        before, now = (self._standing, self._over), (chosen, over)
        if before == now and not entered:
            return ()
        self._standing, self._over = now
        if entered:
            for i in np.flatnonzero(self._inside == ENTERED).tolist():
                self.ledger.enter(t, self._ids[i])
        if before[0] not in (chosen, decision.NOBODY):
            (self.ledger.end if released else self.ledger.retract)(t, self._ids[before[0]])
        if chosen not in (before[0], decision.NOBODY):
            self.ledger.propose(t, self._ids[chosen])
        if over not in (before[1], decision.NOBODY):
            self.ledger.propose_entered()
        return tuple(
            Choice(self._ids[place], float(self._shares[place]), action, reason)
            for place, (action, reason) in zip(changes(before, now), CHANGES, strict=True)
            if place != decision.NOBODY
        )


def rectangle_of(place: Place) -> Target:
    """The square around a place that its visits scatter in: as wide as a target of that scatter.

    Its side is 4.133 standard deviations of the visits (MacKenzie 1992), at least 16 px.

    >>> rectangle_of(Place(100.0, 50.0, p=0.4, before=0.3, visits=5.0, id=7, spread=10.0)).width
    41.33
    """
    return around(place.id, place.x, place.y, max(EFFECTIVE * place.spread, LEAST_PX))


class PlaceChooser:
    """Proposes the place that the cursor is heading for, of those where the person went before.

    As ``Chooser``, but nobody registers anything: the places and how likely each is come from
    ``Pipeline.places``, and the rest is *elsewhere*. A place is proposed and withdrawn by the rules for
    targets; its rectangle is a square of 4.133 standard deviations of its visits, at least 16 px, which
    ``PlaceChoice.place`` carries. A place is entered when the cursor is within
    that square.

    Parameters: ``precision`` is the share that a place must have to be proposed, ``least_lead_s`` s and
    ``least_way_px`` px as for ``Chooser``. Memory: that of a chooser of at most 64 targets. Costs some
    0.05 ms an event with 64 places, and some 0.2 ms where they have changed since the last. Raises
    ParameterError, and EventError or EventOrderError from ``update``; nothing is then changed.

    >>> from pointpred import build
    >>> chooser, pipeline = PlaceChooser(precision=0.6), build("kinematic-adaptive")
    >>> for number in range(8):  # back and forth
    ...     for i in range(70):
    ...         s = min(i / 60, 1.0)
    ...         way = 400.0 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    ...         event = PointerEvent(number + i / 100, way if number % 2 == 0 else 400.0 - way, 0.0)
    ...         prediction = pipeline.update(event)
    ...         for choice in chooser.update(pipeline.places, prediction, event):
    ...             if number == 6 and choice.action == "propose":
    ...                 print(choice.reason, round(choice.place.x + choice.place.width / 2))
    ...     pipeline.reset()
    ...     chooser.reset()
    predicted 400
    """

    parameters = tuple(one for one in Chooser.parameters if one.name != "elsewhere")

    def __init__(
        self,
        *,
        precision: float = USUAL.precision,
        least_lead_s: float = USUAL.least_lead_s,
        least_way_px: float = USUAL.least_way_px,
    ) -> None:
        self._chooser = Chooser(precision=precision, least_lead_s=least_lead_s, least_way_px=least_way_px)
        self._rectangles: dict[int, Target] = {}

    @property
    def ledger(self) -> Ledger:
        """What became of the proposals."""
        return self._chooser.ledger

    @property
    def standing(self) -> int | None:
        """The place that is predicted now."""
        return self._number(self._chooser.standing)

    @property
    def entered(self) -> int | None:
        """The place that is proposed because the cursor is in it, while it is not the predicted one."""
        return self._number(self._chooser.entered)

    def configure(
        self,
        *,
        precision: float | None = None,
        least_lead_s: float | None = None,
        least_way_px: float | None = None,
    ) -> None:
        """Change these parameters from the next event on; raises ParameterError and then changes nothing."""
        self._chooser.configure(precision=precision, least_lead_s=least_lead_s, least_way_px=least_way_px)

    def update(
        self, places: Sequence[Place], prediction: Prediction | None, event: PointerEvent
    ) -> tuple[PlaceChoice, ...]:
        """Take an event, the prediction made at it and the places as they then are; returns what has changed.

        Where the places are others than before, a proposal of one that is gone is withdrawn first. Raises
        ParameterError for two places of one ``id`` and for a share outside 0 to 1.
        """
        ordered = sorted(places, key=lambda place: place.id)
        rows = place_table(ordered)
        self._chooser.check_event(event)
        before = self._rectangles
        gone = self._replace(ordered)
        shares = np.append(rows[:, P], max(1.0 - float(rows[:, P].sum()), 0.0))
        remaining_s = nan if prediction is None or prediction.remaining_s is None else prediction.remaining_s
        changed = self._chooser.update_with_shares(shares, remaining_s, event)
        return (*_with_places(gone, before), *_with_places(changed, self._rectangles))

    def finish(self) -> Movement:
        """Close the movement at the last event, which ended where the cursor is, in the ledger.

        It went to the smallest place that the cursor is in, or to none. The proposal stands until the next
        movement starts.
        """
        at = self._chooser.cursor
        return self._chooser.finish(None if at is None else self.place_at(*at))

    def place_at(self, x: float, y: float) -> int | None:
        """The smallest place whose square holds this point, of equal ones the nearest; ``None`` for none."""
        return self._number(self._chooser.holder(x, y))

    def reset(self) -> None:
        """Forget every event and the proposals; parameters and the ledger's counts stay."""
        self._chooser.reset()

    def _replace(self, places: Sequence[Place]) -> tuple[Choice, ...]:
        """Lay out the rectangles where they have changed."""
        rectangles = {place.id: rectangle_of(place) for place in places}
        if rectangles == self._rectangles:
            return ()
        gone = self._chooser.replace(list(rectangles.values()))
        self._rectangles = rectangles
        return gone

    @staticmethod
    def _number(id: object) -> int | None:
        return id if isinstance(id, int) else None


def _with_places(choices: Sequence[Choice], rectangles: dict[int, Target]) -> tuple[PlaceChoice, ...]:
    """Choices among rectangles whose ids are those of places."""
    return tuple(
        PlaceChoice(one.id, one.p, one.action, one.reason, rectangles[one.id])
        for one in choices
        if isinstance(one.id, int)
    )
