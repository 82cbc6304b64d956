"""The outcome of each proposal: hit, wasted or retracted, and its lead time."""

from __future__ import annotations

from collections import deque
from collections.abc import Hashable
from statistics import median
from typing import Any, TypeVar

import msgspec

Value = TypeVar("Value")

LATEST = 1000
"""Movements of which the lead is remembered, and targets of one movement."""


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
    their proposals as wasted. Memory: the counts, the movement that goes on, and the leads of the latest
    1000 movements.

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
        self._forget()

    def _forget(self) -> None:
        self._made: dict[Hashable, int] = {}
        self._standing: tuple[Hashable, float] | None = None
        self._ended: tuple[float, Hashable, float] | None = None
        self._entered: dict[Hashable, tuple[float, float | None]] = {}
        self._retracted = self._at_entry = 0

    def propose(self, t: float, id: Hashable) -> None:
        """Note a proposal; it takes the place of one that stands."""
        _remember(self._made, id, self._made.get(id, 0) + 1)
        self._standing = (id, t)

    def propose_entered(self) -> None:
        """Note that a target was proposed because the cursor had gone into it."""
        self._at_entry += 1

    def retract(self, t: float, id: Hashable) -> None:
        """Note that the proposal that stands was withdrawn; where it does not stand, nothing is noted."""
        if self._since(id) is not None:
            self._retracted += 1
            self._standing = None

    def end(self, t: float, id: Hashable) -> None:
        """Note that the proposal that stands ended with its movement, when the button came up.

        That is no retraction, and if the movement is closed at this moment, the proposal stood until then.
        """
        since = self._since(id)
        if since is not None:
            self._standing, self._ended = None, (t, id, since)

    def enter(self, t: float, id: Hashable) -> None:
        """Note that the cursor went into a target; only the first time in a movement counts."""
        if id not in self._entered:
            _remember(self._entered, id, (t, self._since(id)))

    def _since(self, id: Hashable) -> float | None:
        return self._standing[1] if self._standing is not None and self._standing[0] == id else None

    def _until(self, t: float, id: Hashable) -> float | None:
        """Since when a target has been proposed, where its proposal stands or ended just now."""
        ended = self._ended
        return ended[2] if ended is not None and ended[:2] == (t, id) else self._since(id)

    def finish(self, t: float, id: Hashable | None) -> Movement:
        """Close the movement at its click, with the target it was for or ``None``."""
        proposed = sum(self._made.values())
        right = self._made.get(id, 0) if id is not None else 0
        entered, since = (t, None) if id is None else self._entered.get(id, (t, self._until(t, id)))
        leads = None if since is None else (entered - since, t - since)
        if leads is not None:
            self._leads.append(leads)
        entry_s, click_s = leads or (None, None)
        done = Movement(
            proposed, leads is not None, proposed - right, self._retracted, entry_s, click_s, self._at_entry
        )
        self.movements += 1
        self.proposed += proposed
        self.right += right
        self.hits += done.hit
        self.wasted += done.wasted
        self.retracted += done.retracted
        self.entered += done.entered
        self._forget()
        return done

    def drop(self) -> None:
        """Forget the movement that goes on: it ended without a click."""
        self._forget()

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


def _remember(noted: dict[Hashable, Value], id: Hashable, value: Value) -> None:
    """Note a value, and forget the oldest target where there are too many: ids are the caller's."""
    noted[id] = value
    if len(noted) > LATEST:
        del noted[next(iter(noted))]
