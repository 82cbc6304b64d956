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
from pointpred.records import FloatArray, FloatTable, SixFloats
from pointpred.targets.rectangles import NOBODY, key_of

LATEST = 1000
"""Movements of which the lead is remembered, and targets of one movement."""

MADE, ENTRY, ENTRY_SINCE, KEY, FIELDS = range(5)
"""Of a target in a movement, a row: how often it was proposed; when the cursor first went into it, and since
when it had been proposed then, NaN where it did not and was not; the target's number in an account."""


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


class Totals(Layout):
    """Of all movements, as ``Ledger.summary`` has them."""

    movements: float
    proposed: float
    right: float
    hits: float
    wasted: float
    retracted: float
    entered: float


class Account(Layout):
    """All movements, the one that goes on, and how many rows its targets have; they are found by number."""

    totals: Totals
    movement: State
    rows: float


STATES = Account.length
"""For JavaScript that makes a memory."""


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


@law
def row_of(s: Account, rows: FloatTable, key: float, new: bool) -> int:
    """The row of a target; NOBODY where it has none, unless ``new`` and there is room for another."""
    count = int(s.rows)
    for i in range(count):
        if rows[i, KEY] == key:
            return i
    if not new or count == len(rows):
        return NOBODY
    s.rows += 1.0
    rows[count, MADE], rows[count, ENTRY], rows[count, ENTRY_SINCE] = 0.0, nan, nan
    rows[count, KEY] = key
    return count


@law
def note_proposal(s: Account, rows: FloatTable, t: float, key: float) -> None:
    """A proposal of the target of this number is made."""
    propose(s.movement, rows, t, row_of(s, rows, key, True))


@law
def note_end(s: Account, rows: FloatTable, t: float, key: float, released: bool) -> None:
    """The proposal of this target that stands ends, as ``withdraw`` says."""
    withdraw(s.movement, t, row_of(s, rows, key, False), released)


@law
def note_entry(s: Account, rows: FloatTable, t: float, key: float) -> None:
    """The cursor goes into this target."""
    enter(s.movement, rows, t, row_of(s, rows, key, True))


@law
def add(s: Totals, movement: tuple[float, float, float, float, float]) -> None:
    """Add a movement: how many it proposed, whether it was hit, wasted, retracted, and entered."""
    proposed, hit, wasted, retracted, entered = movement
    s.movements += 1.0
    s.proposed += proposed
    s.right += proposed - wasted
    s.hits += hit
    s.wasted += wasted
    s.retracted += retracted
    s.entered += entered


@law
def drop(s: Account) -> None:
    """Forget the movement."""
    clear(s.movement)
    s.movement.standing = s.movement.ended = NOBODY
    s.rows = 0.0


@law
def finish(s: Account, rows: FloatTable, t: float, key: float) -> SixFloats:
    """Close the movement, for the target of this number or NOBODY, and add it to the totals.

    Returns how many were proposed, wasted, retracted and entered, and the leads before the entry and the
    click, s, NaN where there is none.
    """
    right, entry_s, click_s = close(s.movement, rows, t, row_of(s, rows, key, False))
    proposed, retracted, entered = s.movement.proposed, s.movement.retracted, s.movement.entered
    hit = 1.0 if entry_s == entry_s else 0.0
    add(s.totals, (proposed, hit, proposed - right, retracted, entered))
    drop(s)
    return proposed, proposed - right, retracted, entered, entry_s, click_s


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


def _total(name: str) -> property:
    """A count of all movements."""
    return property(lambda ledger: int(getattr(ledger.account.totals, name)))


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

    movements, proposed, right, hits = map(_total, ("movements", "proposed", "right", "hits"))
    wasted, retracted, entered = map(_total, ("wasted", "retracted", "entered"))

    def __init__(self) -> None:
        self.account = Account(np.zeros(Account.length))
        self.rows: FloatArray = np.empty((4, FIELDS))
        self._leads: deque[tuple[float, float]] = deque(maxlen=LATEST)
        self.drop()

    def propose(self, t: float, id: Hashable) -> None:
        """Note a proposal; it takes the place of one that stands."""
        note_proposal(self.account.memory, self.with_room(1), float(t), key_of(str(id)))

    def retract(self, t: float, id: Hashable) -> None:
        """Note that the proposal that stands was withdrawn; where it does not stand, nothing is noted."""
        note_end(self.account.memory, self.rows, float(t), key_of(str(id)), False)

    def end(self, t: float, id: Hashable) -> None:
        """Note that the proposal that stands ended with its movement, when the button came up.

        That is no retraction, and if the movement is closed at this moment, the proposal stood until then.
        """
        note_end(self.account.memory, self.rows, float(t), key_of(str(id)), True)

    def enter(self, t: float, id: Hashable) -> None:
        """Note that the cursor went into a target; only the first time in a movement counts."""
        note_entry(self.account.memory, self.with_room(1), float(t), key_of(str(id)))

    def finish(self, t: float, id: Hashable | None) -> Movement:
        """Close the movement at its click, with the target it was for or ``None``."""
        return self.close(float(t), NOBODY if id is None else key_of(str(id)))

    def close(self, t: float, key: float) -> Movement:
        """``finish`` for the number of a target, NOBODY for none."""
        *counts, entry_s, click_s = map(float, finish(self.account.memory, self.rows, t, key))
        proposed, wasted, retracted, entered = map(int, counts)
        if entry_s != entry_s:
            return Movement(proposed, False, wasted, retracted, None, None, entered)
        self._leads.append((entry_s, click_s))
        return Movement(proposed, True, wasted, retracted, entry_s, click_s, entered)

    def drop(self) -> None:
        """Forget the movement that goes on: it ended without a click."""
        drop(self.account.memory)

    def with_room(self, count: int) -> FloatArray:
        """The rows, with room for so many more targets of this movement: LATEST in all."""
        needed = min(int(self.account.rows) + count, LATEST)
        if needed > len(self.rows):
            more = np.empty((max(needed, 2 * len(self.rows)) - len(self.rows), FIELDS))
            self.rows = np.concatenate((self.rows, more))[:LATEST]
        return self.rows

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
