"""Checks of a clock: intervals too short or too long for its unit, or whole seconds only."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from pointpred.recordings.columns.clocks import LONGEST_S, SHORTEST_S, forwards, units_by_rate
from pointpred.recordings.trials import codes_of
from pointpred.records import FloatArray

FEW = 3
"""Fewest steps that are checked."""
MOSTLY = 0.5


def clock_notes(name: str, per_second: float, times: FloatArray, users: Any = None) -> list[str]:
    """Notes on a clock whose median interval, or that of a user, is implausible for a pointer.

    ``name`` of its column; ``per_second``: its units in a second; ``users``: the name of each row's user,
    as an Arrow array, ``None`` for one.
    """
    question = _odd(times, per_second) if users is None else ""
    if question:
        return [f"the median interval of {name} is {question}"]
    odd = [(user, question) for user, mine in _by_user(times, users) if (question := _odd(mine, per_second))]
    if not odd:
        return []
    rest = f" (and {len(odd) - 1} more users)" if len(odd) > 1 else ""
    return [f"the median interval of {name} for user {odd[0][0]!r}{rest} is {odd[0][1]}"]


def only_whole_seconds(times: FloatArray, per_second: float, users: Any = None) -> bool:
    """Whether a clock is constant in most steps and otherwise advances by whole seconds.

    >>> only_whole_seconds(np.repeat([0.0, 1000.0, 2000.0], 4), 1e3)
    True
    """
    if users is not None:
        times = np.concatenate([times[:0], *(mine for _, mine in _by_user(times, users))])
    steps = np.diff(times[np.isfinite(times)])
    ahead = forwards(times) / per_second
    still = int(np.count_nonzero(steps == 0))
    return bool(len(ahead)) and bool(np.all(ahead % 1 == 0)) and still > max(FEW, MOSTLY * len(steps))


def _odd(times: FloatArray, per_second: float) -> str:
    """A median interval out of bounds, with a question about its unit; empty if it is within."""
    steps = forwards(times)
    middle = float(np.median(steps)) / per_second if len(steps) >= FEW else SHORTEST_S
    if SHORTEST_S <= middle <= LONGEST_S:
        return ""
    fitting = " or ".join(units_by_rate(times))
    return f"{middle:g} s: " + (f"is it in {fitting}?" if fitting else "is it a time?")


def _by_user(times: FloatArray, users: Any) -> Iterator[tuple[str, FloatArray]]:
    """The times of each user."""
    if users is None or not len(times):
        return
    codes, names = codes_of(users.fill_null(""))
    order = np.argsort(codes, kind="stable")
    ends = np.searchsorted(codes[order], np.arange(1, len(names)))
    yield from zip(names, np.split(times[order], ends), strict=True)
