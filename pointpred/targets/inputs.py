"""Checks of a chooser's inputs: events out of bounds or order, and invalid coefficients."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.records import LARGEST, FloatArray, Place, PointerEvent
from pointpred.targets import cursor
from pointpred.targets.choice_law import unusable
from pointpred.targets.posterior import COEFFICIENTS

WHOLE = 1.0 + 1e-9
"""The largest share of a place: sums of shares are rounded."""


def accepted(memory: FloatArray, event: PointerEvent) -> tuple[float, float, float, float]:
    """The event as (t, x, y, pressed); raises EventError or EventOrderError for one that cannot be used."""
    t, x, y = float(event.t), float(event.x), float(event.y)
    if not cursor.usable(t, x, y):
        raise EventError(f"an event needs finite numbers within bounds, received {event!r}")
    if memory[cursor.KNOWN] == 1.0 and t < memory[cursor.T]:
        raise EventOrderError(f"t must not run backwards: {t!r} after {memory[cursor.T]!r}")
    return t, x, y, float(event.buttons & 1)


def refuse(memory: FloatArray, events: FloatArray) -> None:
    """Raise EventError or EventOrderError for the first row of ``EventColumns`` that cannot be used."""
    wrong = unusable(memory, events)
    if wrong < 0:
        return
    t, x, y = events[wrong, :3].tolist()
    if not cursor.usable(t, x, y):
        raise EventError(f"an event needs finite numbers within bounds, received row {wrong}: {(t, x, y)}")
    before = float(events[wrong - 1, 0] if wrong else memory[cursor.T])
    raise EventOrderError(f"t must not run backwards: row {wrong}, {t!r} after {before!r}")


def check_places(places: Sequence[Place]) -> None:
    """Raise ParameterError for an ``id`` that occurs twice and for a number of a place that is out of bounds.

    Shares lie in [0, 1], up to rounding; positions and spreads, px, within the bounds of positions.
    """
    ids = {place.id for place in places}
    if len(ids) < len(places):
        numbers = [place.id for place in places]
        twice = next(id for id in numbers if numbers.count(id) > 1)
        raise ParameterError(
            f"the id of a place must occur once, received {twice!r} twice", field="id", value=twice
        )
    for x, y, p, before, _, id, spread in places:
        shares = 0.0 <= p <= WHOLE and 0.0 <= before <= WHOLE
        if shares and abs(x) <= LARGEST and abs(y) <= LARGEST and 0.0 <= spread <= LARGEST:
            continue
        bounds = {
            "x": (x, -LARGEST, LARGEST),
            "y": (y, -LARGEST, LARGEST),
            "p": (p, 0.0, WHOLE),
            "before": (before, 0.0, WHOLE),
            "spread": (spread, 0.0, LARGEST),
        }
        name, (value, low, high) = next(
            (name, one) for name, one in bounds.items() if not one[1] <= one[0] <= one[2]
        )
        raise ParameterError(
            f"{name} of place {id!r} must lie in [{low:g}, {high:g}], received {value!r}",
            field=name,
            value=value,
        )


def usable(coefficients: FloatArray) -> FloatArray:
    """A copy of a posterior's coefficients; raises ParameterError for what is no row of numbers in bounds."""
    try:
        values = np.asarray(coefficients)
    except ValueError as ragged:
        raise ParameterError(f"coefficients must be {COEFFICIENTS} finite numbers: {ragged}") from ragged
    fits = values.shape == (COEFFICIENTS,) and values.dtype.kind in "fiu"
    if not fits or not (np.abs(values) <= LARGEST).all():
        raise ParameterError(
            f"coefficients must be {COEFFICIENTS} finite numbers of magnitude up to {LARGEST:g}, "
            f"received {values.dtype} of shape {values.shape}"
        )
    return np.array(values, dtype=np.float64)
