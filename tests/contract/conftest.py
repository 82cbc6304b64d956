"""Signals that every stage must survive, and the names of all stages."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from pointpred import EventColumns

TICK = 2.0**-13
"""Time stamps are multiples of this: adding a power of two to them is exact."""


def minimum_jerk(duration: float, period: float, *, jitter: float = 0.0, seed: int = 1) -> EventColumns:
    """A straight reach of 500 px with a correction, in whole pixels, followed by a dwell."""
    random = np.random.default_rng(seed)
    t = np.arange(0.0, duration + 0.4, period)
    t = t + np.concatenate([[0.0], random.uniform(-jitter, jitter, len(t) - 1) * period])
    t = np.round(t / TICK) * TICK
    s = np.clip(t / duration, 0.0, 1.0)
    r = np.clip((t - duration) / 0.3, 0.0, 1.0)
    reach = 10 * s**3 - 15 * s**4 + 6 * s**5
    back = 10 * r**3 - 15 * r**4 + 6 * r**5
    return EventColumns.of(t, np.round(400 * reach - 20 * back), np.round(300 * reach + 7 * back))


def with_counts() -> EventColumns:
    """The same reach reported as counts beside pixels, four counts a pixel."""
    events = minimum_jerk(0.7, 0.001, jitter=0.3)
    table = events.table.copy()
    table[:, 3] = 4.0 * np.diff(table[:, 1], prepend=table[0, 1])
    table[:, 4] = 4.0 * np.diff(table[:, 2], prepend=table[0, 2])
    return EventColumns(table)


def troubled() -> EventColumns:
    """Equal stamps, gaps, pauses, a click, counts that come and go, a cursor that stands and turns back."""
    events = minimum_jerk(0.6, 0.008, jitter=0.4, seed=3)
    table = np.concatenate([events.table, events.table, events.table])
    length = len(events)
    table[length:, 0] += 2.0
    table[2 * length :, 0] += 2.0
    table[length : 2 * length, 1:3] *= -1.0
    table[5:60:7, 0] = table[4:59:7, 0]
    table[length + 20 : 2 * length, 0] += 0.1875
    table[length - 10 : length - 5, 5] = 1.0
    table[2 * length + 3 : 2 * length + 30, 3:5] = 3.0
    return EventColumns(table)


def wandering(rate: float = 125.0, count: int = 400, seed: int = 7) -> EventColumns:
    """A random walk: no law of movement holds."""
    random = np.random.default_rng(seed)
    t = np.round(np.cumsum(random.exponential(1.0 / rate, count)) / TICK) * TICK
    steps = np.round(random.standard_normal((count, 2)) * random.choice([0.0, 1.0, 30.0], (count, 1)))
    return EventColumns.of(t, *np.cumsum(steps, axis=0).T, buttons=random.integers(0, 4, count))


SIGNALS: dict[str, Callable[[], EventColumns]] = {
    "reach at 1 kHz": lambda: minimum_jerk(0.7, 0.001, jitter=0.3),
    "reach at 60 Hz": lambda: minimum_jerk(0.7, 1 / 60, jitter=0.2),
    "reach at 8 kHz": lambda: minimum_jerk(0.3, TICK),
    "reach with counts": with_counts,
    "troubled": troubled,
    "wandering": wandering,
    "still": lambda: EventColumns.of(np.arange(50) * 0.0078125, np.zeros(50), np.zeros(50)),
    "one event": lambda: EventColumns.of([0.0], [0.0], [0.0]),
    "1 Hz": lambda: EventColumns.of(np.arange(20.0), np.arange(20.0) ** 2, np.arange(20.0)),
}


@pytest.fixture(params=list(SIGNALS))
def events(request: pytest.FixtureRequest) -> EventColumns:
    """Each signal in turn."""
    return SIGNALS[request.param]()


@pytest.fixture
def troubled_events() -> EventColumns:
    """The signal in which the most goes wrong."""
    return troubled()
