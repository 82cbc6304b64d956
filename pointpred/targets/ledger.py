"""What became of each proposal: hit, wasted or retracted, and how early it came."""

from __future__ import annotations

from collections import deque
from collections.abc import Hashable
from statistics import median
from typing import Any

import msgspec

LATEST = 1000
"""Movements of which the lead is remembered."""


class Movement(msgspec.Struct, frozen=True):
    """The account of one movement; leads in s, ``None`` where there is none."""

    proposed: int
    hit: bool
    """The target was proposed before the cursor entered it, and that proposal stood at the end."""
    wasted: int
    """Proposals of other targets, whether retracted or not."""
    retracted: int
    lead_entry_s: float | None
    """From the proposal until the cursor last entered the target."""
    lead_click_s: float | None


class Ledger:
    """Counts proposals over movements.

    A proposal is *right* when it names the target of its movement. Movements without a known target count
    their proposals as wasted. Memory: the counts, the movement that goes on, and the leads of the latest
    1000 movements.

    >>> ledger = Ledger()
    >>> ledger.propose(0.2, "a")
    >>> ledger.enter(0.5, "a")
    >>> ledger.finish(0.7, "a").lead_entry_s
    0.3
    >>> ledger.precision, ledger.coverage, ledger.proposals_a_movement
    (1.0, 1.0, 1.0)
    """

    def __init__(self) -> None:
        self.movements = self.proposed = self.right = self.hits = self.wasted = self.retracted = 0
        self._leads: deque[tuple[float, float]] = deque(maxlen=LATEST)
        self._forget()

    def _forget(self) -> None:
        self._made: dict[Hashable, int] = {}
        self._standing: tuple[Hashable, float] | None = None
        self._entered: tuple[Hashable, float] | None = None
        self._retracted = 0

    def propose(self, t: float, id: Hashable) -> None:
        """Note a proposal; it takes the place of one that stands."""
        self._made[id] = self._made.get(id, 0) + 1
        self._standing = (id, t)

    def retract(self, t: float, id: Hashable) -> None:
        """Note that the proposal that stands was withdrawn."""
        self._retracted += 1
        self._standing = None

    def enter(self, t: float, id: Hashable) -> None:
        """Note that the cursor went into a target; only the last entry counts."""
        self._entered = (id, t)

    def finish(self, t: float, id: Hashable | None) -> Movement:
        """Close the movement at its click, with the target it was for or ``None``."""
        proposed = sum(self._made.values())
        right = self._made.get(id, 0) if id is not None else 0
        lead_entry = lead_click = None
        if self._standing is not None and self._standing[0] == id and id is not None:
            since = self._standing[1]
            entered = self._entered[1] if self._entered is not None and self._entered[0] == id else t
            if entered >= since:
                lead_entry, lead_click = round(entered - since, 9), round(t - since, 9)
                self._leads.append((lead_entry, lead_click))
        done = Movement(
            proposed, lead_entry is not None, proposed - right, self._retracted, lead_entry, lead_click
        )
        self.movements += 1
        self.proposed += proposed
        self.right += right
        self.hits += done.hit
        self.wasted += done.wasted
        self.retracted += self._retracted
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
            "precision": self.precision,
            "coverage": self.coverage,
            "proposals_a_movement": self.proposals_a_movement,
            "median_lead_entry_s": median(entry) if entry else None,
            "median_lead_click_s": median(click) if click else None,
        }
