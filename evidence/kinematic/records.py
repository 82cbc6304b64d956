"""How `kinematic` does on people and sets that it was not fitted to, as it is kept: ``data.json``."""

from __future__ import annotations

import msgspec

Levels = tuple[float, float, float]
"""Shares at 50, 80 and 95 %."""


class Claims(msgspec.Struct, frozen=True):
    """Shares inside, at 10, 20 ... 90 % of the time."""

    regions: tuple[Levels, ...]
    """Of the endpoints, inside the regions."""
    arrivals: tuple[Levels, ...]
    """Of the arrivals, inside the intervals."""


class Ratio(msgspec.Struct, frozen=True):
    """The error over that of `hold`, with its 95 % interval."""

    of_hold: float | None
    interval: tuple[float, float] | None


class SetRow(msgspec.Struct, frozen=True):
    """One set."""

    name: str
    users: int
    trials: int
    every: Ratio
    """Time-averaged, all trials."""
    clean: Ratio | None
    by_time: dict[float, float]
    """Over the error of `hold` at shares of the time."""
    by_path: dict[float, float]
    claims: Claims
    left_ms: float
    """Mean absolute error of the time left."""
    clock_ms: float
    """That of a clock that uses the set's median time."""
    of_clock: float
    """The ratio of both."""


class Held(msgspec.Struct, frozen=True):
    """Every set by one way of holding out."""

    sets: tuple[SetRow, ...]
    together: Claims
    """Over all sets."""


class Validation(msgspec.Struct, frozen=True):
    """Both ways of holding out."""

    people_out: Held
    """Five folds of users, each predicted by a network fitted to the other four."""
    sets_out: Held
    """Each set predicted by a network fitted to the other six."""
