"""Checks of a chooser's inputs: events out of bounds or order, and invalid coefficients."""

from __future__ import annotations

import numpy as np

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.records import LARGEST, FloatArray, PointerEvent
from pointpred.targets import cursor
from pointpred.targets.choice_law import unusable
from pointpred.targets.posterior import Coefficients


def accepted(s: cursor.State, event: PointerEvent) -> tuple[float, float, float, float]:
    """The event as (t, x, y, pressed); raises EventError or EventOrderError for one that cannot be used."""
    t, x, y = float(event.t), float(event.x), float(event.y)
    if not cursor.usable(t, x, y):
        raise EventError(f"an event needs finite numbers within bounds, received {event!r}")
    if s.known == 1.0 and t < s.t:
        raise EventOrderError(f"t must not run backwards: {t!r} after {s.t!r}")
    return t, x, y, float(event.buttons & 1)


def refuse(s: cursor.State, events: FloatArray) -> None:
    """Raise EventError or EventOrderError for the first row of ``EventColumns`` that cannot be used."""
    wrong = unusable(s.memory, events)
    if wrong < 0:
        return
    t, x, y = events[wrong, :3].tolist()
    if not cursor.usable(t, x, y):
        raise EventError(f"an event needs finite numbers within bounds, received row {wrong}: {(t, x, y)}")
    before = float(events[wrong - 1, 0] if wrong else s.t)
    raise EventOrderError(f"t must not run backwards: row {wrong}, {t!r} after {before!r}")


def usable(coefficients: FloatArray) -> FloatArray:
    """A copy of a posterior's coefficients; raises ParameterError for what is no row of numbers in bounds."""
    try:
        values = np.asarray(coefficients)
    except ValueError as ragged:
        raise ParameterError(
            f"coefficients must be {Coefficients.length} finite numbers: {ragged}"
        ) from ragged
    fits = values.shape == (Coefficients.length,) and values.dtype.kind in "fiu"
    if not fits or not (np.abs(values) <= LARGEST).all():
        raise ParameterError(
            f"coefficients must be {Coefficients.length} finite numbers of magnitude up to {LARGEST:g}, "
            f"received {values.dtype} of shape {values.shape}"
        )
    return np.array(values, dtype=np.float64)
