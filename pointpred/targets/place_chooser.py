"""Proposals without targets: the places where the person went before."""

from __future__ import annotations

from collections.abc import Sequence
from math import nan
from typing import Literal, NamedTuple

import numpy as np

from pointpred.records import Place, PointerEvent, Prediction
from pointpred.targets.chooser import Choice, Chooser, Reason
from pointpred.targets.inputs import check_places
from pointpred.targets.ledger import Ledger, Movement
from pointpred.targets.rectangle_mass import EFFECTIVE
from pointpred.targets.rectangles import Target, around

LEAST_PX = 16.0
"""Size of the smallest place: what people point at is hardly smaller, and the scatter near a place is 0."""


def rectangle_of(place: Place) -> Target:
    """The square around a place that its visits scatter in: as wide as a target of that scatter.

    Its side is 4.133 standard deviations of the visits (MacKenzie 1992), at least 16 px.

    >>> rectangle_of(Place(100.0, 50.0, p=0.4, before=0.3, visits=5.0, id=7, spread=10.0)).width
    41.33
    """
    return around(place.id, place.x, place.y, max(EFFECTIVE * place.spread, LEAST_PX))


class PlaceChoice(NamedTuple):
    """A change of mind, as ``Choice``, about a place: ``id`` of the ``Place``, ``place``: its rectangle."""

    id: int
    p: float
    action: Literal["propose", "retract"]
    reason: Reason | None
    place: Target


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
        self, *, precision: float = 0.5, least_lead_s: float = 0.0, least_way_px: float = 3.0
    ) -> None:
        self._chooser = Chooser(precision=precision, least_lead_s=least_lead_s, least_way_px=least_way_px)
        self._rectangles: dict[int, Target] = {}
        self._cursor: tuple[float, float] | None = None

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
        check_places(places)
        self._chooser.check_event(event)
        before = self._rectangles
        gone = self._replace(places)
        self._cursor = float(event.x), float(event.y)
        shares = np.empty(len(places) + 1)
        rows = {id: row for row, id in enumerate(self._rectangles)}
        for place in places:
            shares[rows[place.id]] = place.p
        shares[-1] = max(1.0 - sum(place.p for place in places), 0.0)
        remaining_s = nan if prediction is None or prediction.remaining_s is None else prediction.remaining_s
        changed = self._chooser.update_with_shares(shares, remaining_s, event)
        return (*_with_places(gone, before), *_with_places(changed, self._rectangles))

    def finish(self) -> Movement:
        """Close the movement at the last event, which ended where the cursor is, in the ledger.

        It went to the smallest place that the cursor is in, or to none. The proposal stands until the next
        movement starts.
        """
        return self._chooser.finish(None if self._cursor is None else self.place_at(*self._cursor))

    def place_at(self, x: float, y: float) -> int | None:
        """The smallest place whose square holds this point, of equal ones the nearest; ``None`` for none."""

        def off(one: Target) -> tuple[float, float]:
            return abs(x - one.x - one.width / 2.0), abs(y - one.y - one.height / 2.0)

        around_it = [one for one in self._rectangles.values() if max(off(one)) <= one.width / 2.0]
        nearest = min(around_it, key=lambda one: (one.width, sum(off(one))), default=None)
        return None if nearest is None else self._number(nearest.id)

    def reset(self) -> None:
        """Forget every event and the proposals; parameters and the ledger's counts stay."""
        self._chooser.reset()
        self._cursor = None

    def _replace(self, places: Sequence[Place]) -> tuple[Choice, ...]:
        """Lay out the rectangles, in the order of their numbers, where they have changed."""
        rectangles = {place.id: rectangle_of(place) for place in sorted(places, key=lambda place: place.id)}
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
