"""The outcome of each proposal: hit, wasted or retracted, and its lead time."""

from __future__ import annotations

from collections import deque
from collections.abc import Hashable
from math import nan
from statistics import median
from typing import Any

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout, clear
from pointpred.records import FloatTable
from pointpred.targets.rectangles import NOBODY

LATEST = 1000
"""Movements of which the lead is remembered, and targets of one movement."""

MADE, ENTRY, ENTRY_SINCE, FIELDS = range(4)
"""Of a target in a movement, a row: how often it was proposed; when the cursor first went into it, and since
when it had been proposed then, NaN where it did not and was not."""


class State(Layout):
    """Of a movement."""

    standing: float
    since: float
    """The row of the target that is proposed, and since when, s."""
    ended: float
    ended_at: float
    ended_since: float
    """That whose proposal ended with the release of a button, when it ended, and since when it stood."""
    proposed: float
    retracted: float
    entered: float
    """Proposals, retractions, targets proposed because the cursor had gone into them."""


PROPOSED, RETRACTED, ENTERED = (part.at for part in State.parts[5:])
STATES = State.length
"""For JavaScript that looks at the memory itself."""


@law
def begin(s: State, rows: FloatTable) -> None:
    """Nothing is known of a movement yet, nor of the targets of these rows."""
    clear(s)
    s.standing = s.ended = NOBODY
    for i in range(len(rows)):
        rows[i, MADE], rows[i, ENTRY], rows[i, ENTRY_SINCE] = 0.0, nan, nan


@law
def propose(s: State, rows: FloatTable, t: float, place: int) -> None:
    """A proposal is made; it takes the place of one that stands."""
    s.proposed += 1.0
    s.standing, s.since = place, t
    if place != NOBODY:
        rows[place, MADE] += 1.0


@law
def withdraw(s: State, t: float, place: int, released: bool) -> None:
    """The proposal that stands ends; where this target's does not stand, nothing happens.

    ``released``: it ended with its movement, when the button came up. That is no retraction, and if the
    movement is closed at this moment, the proposal stood until then.
    """
    if place == NOBODY or s.standing != place:
        return
    s.standing = NOBODY
    if released:
        s.ended, s.ended_at, s.ended_since = place, t, s.since
    else:
        s.retracted += 1.0


@law
def enter(s: State, rows: FloatTable, t: float, place: int) -> None:
    """The cursor goes into a target; only the first time in a movement counts."""
    if place != NOBODY and rows[place, ENTRY] != rows[place, ENTRY]:
        rows[place, ENTRY] = t
        rows[place, ENTRY_SINCE] = s.since if s.standing == place else nan


@law
def close(s: State, rows: FloatTable, t: float, place: int) -> tuple[float, float, float]:
    """How often the target of the movement was proposed, and the leads before its entry and its click, s.

    The leads are NaN where no proposal of it stood when the cursor first went into it; where the cursor never
    did, it was clicked beside, and the proposal has to stand at the click, or end at this moment.
    """
    if place == NOBODY:
        return 0.0, nan, nan
    entry, since = rows[place, ENTRY], rows[place, ENTRY_SINCE]
    if entry != entry:
        entry = t
        if s.ended == place and s.ended_at == t:
            since = s.ended_since
        elif s.standing == place:
            since = s.since
    return rows[place, MADE], entry - since, t - since


class Movement(msgspec.Struct, frozen=True):
    """The account of one movement; leads in s, ``None`` where there is none."""

    proposed: int
    hit: bool
    """When the cursor first entered the target (or clicked beside it), a proposal of it stood."""
    wasted: int
    """Proposals of other targets, whether retracted or not."""
    retracted: int
    lead_entry_s: float | None
    """From the proposal until the cursor first entered the target."""
    lead_click_s: float | None
    entered: int = 0
    """Targets proposed because the cursor had gone into them: no predictions, and in none of the above."""


class Ledger:
    """Counts proposals over movements.

    Proposals are predictions; what is proposed because the cursor has entered it is counted apart. A
    proposal is *right* when it names the target of its movement. Movements without a known target count
    their proposals as wasted. Memory: the counts, the movement that goes on with its first 1000 targets, and
    the leads of the latest 1000 movements.

    >>> ledger = Ledger()
    >>> ledger.propose(0.2, "a")
    >>> ledger.enter(0.5, "a")
    >>> round(ledger.finish(0.7, "a").lead_entry_s, 3)
    0.3
    >>> ledger.precision, ledger.coverage, ledger.proposals_a_movement
    (1.0, 1.0, 1.0)
    """

    def __init__(self) -> None:
        self.movements = self.proposed = self.right = self.hits = self.wasted = self.retracted = 0
        self.entered = 0
        self._leads: deque[tuple[float, float]] = deque(maxlen=LATEST)
        self._movement = State(np.empty(State.length))
        self.drop()

    def propose(self, t: float, id: Hashable) -> None:
        """Note a proposal; it takes the place of one that stands."""
        place = self._row_of(id)
        propose(self._movement.memory, self._rows, float(t), place)

    def propose_entered(self) -> None:
        """Note that a target was proposed because the cursor had gone into it."""
        self._movement.entered += 1.0

    def retract(self, t: float, id: Hashable) -> None:
        """Note that the proposal that stands was withdrawn; where it does not stand, nothing is noted."""
        withdraw(self._movement.memory, float(t), self._places.get(id, NOBODY), False)

    def end(self, t: float, id: Hashable) -> None:
        """Note that the proposal that stands ended with its movement, when the button came up.

        That is no retraction, and if the movement is closed at this moment, the proposal stood until then.
        """
        withdraw(self._movement.memory, float(t), self._places.get(id, NOBODY), True)

    def enter(self, t: float, id: Hashable) -> None:
        """Note that the cursor went into a target; only the first time in a movement counts."""
        place = self._row_of(id)
        enter(self._movement.memory, self._rows, float(t), place)

    def finish(self, t: float, id: Hashable | None) -> Movement:
        """Close the movement at its click, with the target it was for or ``None``."""
        place = NOBODY if id is None else self._places.get(id, NOBODY)
        right, *leads = map(float, close(self._movement.memory, self._rows, float(t), place))
        movement = self._movement
        proposed, retracted, entered = map(int, (movement.proposed, movement.retracted, movement.entered))
        hit = leads[0] == leads[0]
        if hit:
            self._leads.append((leads[0], leads[1]))
        entry_s, click_s = leads if hit else (None, None)
        done = Movement(proposed, hit, proposed - int(right), retracted, entry_s, click_s, entered)
        self.movements += 1
        self.proposed += proposed
        self.right += int(right)
        self.hits += done.hit
        self.wasted += done.wasted
        self.retracted += retracted
        self.entered += entered
        self.drop()
        return done

    def drop(self) -> None:
        """Forget the movement that goes on: it ended without a click."""
        self._places: dict[Hashable, int] = {}
        self._rows = np.empty((4, FIELDS))
        begin(self._movement.memory, self._rows)

    def _row_of(self, id: Hashable) -> int:
        """The row of a target, a new one where it has none; NOBODY beyond LATEST: ids are the caller's."""
        place = self._places.get(id, NOBODY)
        if place == NOBODY and len(self._places) < LATEST:
            place = self._places[id] = len(self._places)
            if place == len(self._rows):
                self._rows = np.concatenate((self._rows, np.tile((0.0, nan, nan), (place, 1))))
        return place

    @property
    def precision(self) -> float | None:
        """The share of proposals that were right."""
        return self.right / self.proposed if self.proposed else None

    @property
    def coverage(self) -> float | None:
        """The share of movements whose target was proposed before the cursor entered it."""
        return self.hits / self.movements if self.movements else None

    @property
    def proposals_a_movement(self) -> float | None:
        """Proposals over movements."""
        return self.proposed / self.movements if self.movements else None

    def summary(self) -> dict[str, Any]:
        """Every number, with the medians of the leads of the latest movements."""
        entry, click = zip(*self._leads, strict=True) if self._leads else ((), ())
        return {
            "movements": self.movements,
            "proposed": self.proposed,
            "right": self.right,
            "hit": self.hits,
            "wasted": self.wasted,
            "retracted": self.retracted,
            "entered": self.entered,
            "precision": self.precision,
            "coverage": self.coverage,
            "proposals_a_movement": self.proposals_a_movement,
            "median_lead_entry_s": median(entry) if entry else None,
            "median_lead_click_s": median(click) if click else None,
        }
