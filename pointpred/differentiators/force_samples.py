"""Samples of an accelerometer: what makes one, why one is refused, how its sensor stands on the device."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from pointpred.compiled import law
from pointpred.differentiators.sampling import is_number
from pointpred.errors import EventError, EventOrderError
from pointpred.records import LATEST_S, FloatArray, Row

FORCE_MOST_M_S2 = 1e4
"""Bound on the magnitude of a sample along an axis: a thousand times gravity."""


class Sensor(NamedTuple):
    """How an accelerometer stands on its device: the acceleration is ``weights`` f + ``offset``, m/s^2.

    ``weights`` has shape (2, 3): alignment and scale, inverted; ``offset`` is gravity and bias as they act on
    the two axes, with their sign changed; positions are stamped ``delay_s`` s late. ``known``: well enough
    for motions by its samples.
    """

    weights: FloatArray
    offset: FloatArray
    delay_s: float
    known: bool


@law
def sample_at(table: FloatArray, i: int) -> tuple[float, float, float, float]:
    """A row of a table of samples as a tuple."""
    r = table[i]
    return r[0], r[1], r[2], r[3]


@law
def is_sample(sample: Row) -> bool:
    """Whether the values make a sample: all within their bounds."""
    t, fx, fy, fz = sample
    most = FORCE_MOST_M_S2
    return bool(abs(t) <= LATEST_S and abs(fx) <= most and abs(fy) <= most and abs(fz) <= most)


def numbers_of_sample(sample: Sequence[Any]) -> tuple[float, float, float, float]:
    """A sample as floats; raises EventError for what is no number, such as a word that reads like one.

    >>> numbers_of_sample((1, 0, 0, 10))
    (1.0, 0.0, 0.0, 10.0)
    """
    for name, value in zip(("t", "ax", "ay", "az"), sample, strict=True):
        if not is_number(value):
            raise EventError(
                f"{name} of a sample must be a number, received {value!r:.80}", field=name, value=value
            )
    try:
        t, ax, ay, az = (float(value) for value in sample)
    except OverflowError as beyond:  # a whole number beyond every float
        raise refusal_of_sample(sample, 0.0) from beyond
    return t, ax, ay, az


def refusal_of_sample(sample: Sequence[float], last_t: float) -> EventError:
    """Why a sample was refused; ``last_t`` s is the time of the one before it."""
    t, *force = sample
    if not abs(t) <= LATEST_S:
        return EventError(
            f"t of a sample must lie in [-{LATEST_S:g}, {LATEST_S:g}], received {t!r}", field="t"
        )
    for name, value in zip(("ax", "ay", "az"), force, strict=True):
        if not abs(value) <= FORCE_MOST_M_S2:
            bounds = f"[-{FORCE_MOST_M_S2:g}, {FORCE_MOST_M_S2:g}] m/s^2"
            return EventError(f"{name} of a sample must lie in {bounds}, received {value!r}", field=name)
    message = f"t of a sample must not run backwards: received {t!r} s after {last_t!r} s"
    return EventOrderError(message, field="t", value=t)
