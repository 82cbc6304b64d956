"""From how likely each target is to proposals: of targets, and of places that nobody registered."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import Literal, NamedTuple, Protocol

import numpy as np

from pointpred.parameter import Parameter, check
from pointpred.records import FloatArray, FloatTable, Place
from pointpred.targets import choice_law, past
from pointpred.targets.aim import Aim
from pointpred.targets.choice_law import LEAST_PX
from pointpred.targets.decision import HIGHEST, LOWEST, USUAL, Settings
from pointpred.targets.ledger import Ledger, Movement
from pointpred.targets.posterior import EFFECTIVE
from pointpred.targets.rectangles import FIELDS, NOBODY, Target, around, holder, key_of

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
    prediction had said so before; ``None`` where it is retracted. ``place``: the rectangle of a place of the
    person, ``None`` for a registered target.
    """

    id: Hashable
    p: float
    action: Action
    reason: Reason | None = None
    place: Target | None = None


class Aimed(Protocol):
    """What choosers ask of a pipeline: its targets with how likely each is, and the person's places."""

    @property
    def aim(self) -> Aim:
        """The registered targets."""

    @property
    def places(self) -> tuple[Place, ...]:
        """Where movements of the person ended before."""


class Chooser:
    """Proposes the registered target that the cursor is heading for, once that is likely enough.

    ``update`` decides by the shares of the pipeline after its last event. At most two targets are proposed at
    a time: the one that is predicted, and the one that the cursor is in if that is another. A target
    therefore has its choice when the cursor enters it at the latest. Of targets that overlap, the smallest
    counts as entered, of equal ones the last. A proposal ends when the prediction drops it, when the cursor
    leaves it, when the button comes up, and when its target is no longer registered.

    Parameters: ``precision`` is the share of proposals that shall be right; ``least_lead_s`` s, a target that
    the cursor enters sooner is not predicted; ``least_way_px`` px, how far the cursor must be from where its
    movement started before anything is predicted: nearer, nobody can say that a movement has begun. Memory: a
    float a target, the ledger. Raises ParameterError.

    >>> from pointpred import PointerEvent, build
    >>> from pointpred.targets import around
    >>> pipeline = build("minimum-jerk")
    >>> pipeline.register([around("left", -400.0, 0.0, 40.0), around("right", 400.0, 0.0, 40.0)])
    >>> chooser = Chooser(pipeline, precision=0.6)
    >>> for i in range(30):
    ...     _ = pipeline.update(PointerEvent(i / 100, 400.0 * (i / 60) ** 2 * (3 - 2 * i / 60), 0.0))
    ...     for choice in chooser.update():
    ...         print(choice.id, choice.action, choice.reason)
    right propose predicted
    """

    parameters = tuple(
        Parameter(name, unit, getattr(LOWEST, name), getattr(HIGHEST, name), meaning)
        for name, unit, meaning in (
            ("precision", "", "share of proposals that shall be right"),
            ("least_lead_s", "s", "what the cursor enters sooner is not predicted"),
            ("least_way_px", "px", "nothing is predicted nearer to the movement's start"),
        )
    )

    def __init__(
        self,
        pipeline: Aimed,
        *,
        precision: float = USUAL.precision,
        least_lead_s: float = USUAL.least_lead_s,
        least_way_px: float = USUAL.least_way_px,
    ) -> None:
        settings = Settings(precision, least_lead_s, least_way_px)
        check(self.parameters, settings._asdict())
        self.pipeline = pipeline
        self.ledger = Ledger()
        self._aim = pipeline.aim  # from now on it follows the cursor
        self._settings = Settings(*map(float, settings))
        self._state = choice_law.State(np.full(choice_law.State.length, float(NOBODY)))
        self._ids: tuple[Hashable, ...] = ()
        self._targets = np.zeros((0, FIELDS)), np.zeros(0), np.ones(1)
        self._keys: FloatTable = np.zeros((0, past.KEYS))
        self._changes = np.empty(len(CHANGES))
        self.follow_targets()

    def configure(
        self,
        *,
        precision: float | None = None,
        least_lead_s: float | None = None,
        least_way_px: float | None = None,
    ) -> None:
        """Change these parameters from the next event on; raises ParameterError and then changes nothing."""
        given = zip(Settings._fields, (precision, least_lead_s, least_way_px), strict=True)
        values = {name: value for name, value in given if value is not None}
        check(tuple(p for p in self.parameters if p.name in values), values)
        self._settings = self._settings._replace(**{name: float(value) for name, value in values.items()})

    @property
    def standing(self) -> Hashable | None:
        """The target that is predicted now."""
        return self._id_at(self._state.predicted)

    @property
    def entered(self) -> Hashable | None:
        """The target that is proposed because the cursor is in it, while it is not the predicted one."""
        return self._id_at(self._state.entered)

    def _id_at(self, place: float) -> Hashable | None:
        return None if place == NOBODY else self._ids[int(place)]

    def follow_targets(self) -> tuple[Choice, ...]:
        """End the proposals of targets that are no longer registered; ``update`` does so, too."""
        aim = self.pipeline.aim
        return self._take(aim.ids, aim.table, aim.keys, aim.shares)

    def update(self) -> tuple[Choice, ...]:
        """Decide after the pipeline's last event; what has changed, ends of proposals first.

        At most four choices, and two more where other targets are registered than before.
        """
        gone = self.follow_targets()
        return gone + self._decide()

    def finish(self, target: Hashable | None) -> Movement:
        """Close the movement at the last event, a click on ``target``, in the ledger.

        The proposal stands until the next movement starts: at the release, without one at the next event.
        """
        return self._close(NOBODY if target is None else key_of(str(target)))

    def _close(self, key: float) -> Movement:
        """Close the movement, for the target of this number or NOBODY."""
        now = self.pipeline.aim.cursor
        if now.t0 < now.t:
            now.pressed = 1.0  # what comes next is a release
        return self.ledger.close(float(now.t), key)

    def reset(self) -> None:
        """Forget the proposals, as the pipeline's ``reset`` forgets its events; the ledger's counts stay.

        A target that the cursor is in is not entered again before the cursor has left it, as after a release.
        """
        choice_law.reset(self._state.memory, self._targets[1])
        self.ledger.drop()

    def _take(
        self, ids: tuple[Hashable, ...], rows: FloatArray, keys: FloatTable, shares: FloatArray
    ) -> tuple[Choice, ...]:
        """Decide among these targets from now on; the proposals of those that are gone end."""
        if ids is self._ids:
            self._targets = rows, self._targets[1], shares
            return ()
        inside, proposed, t = np.empty(len(ids)), (self.standing, self.entered), self.pipeline.aim.cursor.t
        before, account = (self._keys, self._targets[1]), (self.ledger.account.memory, self.ledger.rows)
        gone = choice_law.replace(self._state.memory, float(t), before, (keys, inside), *account)
        self._ids, self._keys, self._targets = ids, keys, (rows, inside, shares)
        return tuple(Choice(id, 0.0, "retract") for id, ends in zip(proposed, gone, strict=True) if ends)

    def _decide(self) -> tuple[Choice, ...]:
        """Decide by the shares, and note what has changed."""
        given = self.pipeline.aim.memory, self._targets, self._keys, self._settings
        account = self.ledger.account.memory, self.ledger.with_room(len(self._ids))
        if not choice_law.update(self._state.memory, *given, *account, self._changes):
            return ()
        shares = self._targets[2]
        return tuple(
            Choice(self._ids[place], float(shares[place]), action, reason)
            for place, (action, reason) in zip(map(int, self._changes), CHANGES, strict=True)
            if place != NOBODY
        )


def rectangle_of(place: Place) -> Target:
    """The square around a place that its visits scatter in: as wide as a target of that scatter.

    Its side is 4.133 standard deviations of the visits (MacKenzie 1992), at least 16 px.

    >>> rectangle_of(Place(100.0, 50.0, p=0.4, before=0.3, visits=5.0, id=7, spread=10.0)).width
    41.33
    """
    return around(place.id, place.x, place.y, max(EFFECTIVE * place.spread, LEAST_PX))


class PlaceChooser(Chooser):
    """Proposes the place that the cursor is heading for, of those where the person went before.

    As ``Chooser``, but nobody registers anything: the places and how likely each is are those of
    ``Pipeline.places``, and the rest is *elsewhere*. A place is proposed and withdrawn by the rules for
    targets; its rectangle is a square of 4.133 standard deviations of its visits, at least 16 px, which
    ``Choice.place`` is. A place is entered when the cursor is within that square.

    Parameters and errors: those of ``Chooser``; ``precision`` is the share that a place must have to be
    proposed.

    >>> from pointpred import PointerEvent, build
    >>> pipeline = build("kinematic-adaptive")
    >>> chooser = PlaceChooser(pipeline, precision=0.6)
    >>> for number in range(8):  # back and forth
    ...     for i in range(70):
    ...         s = min(i / 60, 1.0)
    ...         way = 400.0 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    ...         event = PointerEvent(number + i / 100, way if number % 2 == 0 else 400.0 - way, 0.0)
    ...         _ = pipeline.update(event)
    ...         for choice in chooser.update():
    ...             if number == 6 and choice.action == "propose":
    ...                 print(choice.reason, round(choice.place.x + choice.place.width / 2))
    ...     pipeline.reset()
    ...     chooser.reset()
    predicted 400
    """

    _rectangles: Mapping[Hashable, Target] = {}
    _squares: FloatTable = np.zeros((0, FIELDS))
    _numbers: tuple[Hashable, ...] = ()

    def follow_targets(self) -> tuple[Choice, ...]:
        """End the proposals of places that are no longer known; ``update`` does so, too."""
        places = sorted(self.pipeline.places, key=lambda place: place.id)
        count, before = len(places), self._rectangles
        known = np.array([(one.x, one.y, one.p, one.id, one.spread) for one in places]).reshape(count, 5)
        squares, keys, shares = np.empty((count, FIELDS)), np.zeros((count, past.KEYS)), np.empty(count + 1)
        choice_law.lay_places(known, squares, keys, shares)
        if not np.array_equal(squares, self._squares) or not np.array_equal(keys, self._keys):
            self._squares, self._numbers = squares, tuple(place.id for place in places)
            self._rectangles = {place.id: rectangle_of(place) for place in places}
        gone = self._take(self._numbers, squares, keys, shares)
        return tuple(one._replace(place=before[one.id]) for one in gone)

    def update(self) -> tuple[Choice, ...]:
        """As ``Chooser.update``; each change carries the rectangle of its place."""
        gone = self.follow_targets()
        return gone + tuple(one._replace(place=self._rectangles[one.id]) for one in self._decide())

    def finish(self, target: Hashable | None = None) -> Movement:
        """Close the movement at the last event in the ledger: it went to the place that the cursor is in.

        The proposal stands until the next movement starts.
        """
        now = self.pipeline.aim.cursor
        place = holder(self._squares, float(now.x), float(now.y))
        return self._close(NOBODY if place == NOBODY else float(self._keys[place, past.ID]))
