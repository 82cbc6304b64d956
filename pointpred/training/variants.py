"""The same movements seen otherwise: another tempo, size, direction, sampling rate."""

from __future__ import annotations

from math import cos, log, pi, sin

import numpy as np

from pointpred.recording import Recording
from pointpred.records import EventColumns, FloatArray

TEMPO = (0.35, 1.6)
"""Bounds on how much longer a movement is made, even on a logarithmic scale."""
SIZE = (0.4, 2.5)
"""Bounds on how much larger a movement is made, even on a logarithmic scale."""
TINY, TINY_TEMPO, TINY_SHARE = (0.1, 0.4), (0.25, 1.6), 0.13
"""The same for this share of them: where no flick goes some dozen px every start looks like a long way."""
RATES_HZ = (60.0, 75.0, 100.0, 125.0, 200.0, 250.0, 500.0, 1000.0)
ROUGH_SHARE = 0.3
"""Share of movements that run on straight lines between their samples instead of smoothly."""


def varied(recording: Recording, seed: int) -> Recording:
    """Every trial stretched in time, scaled, turned, mirrored and resampled at random, in whole pixels.

    Of samples of one time the last counts; trials of fewer than three times stay as they are but for that.
    Counts are left out.
    """
    random = np.random.default_rng(seed)
    paths = []
    for number in range(len(recording.trials)):
        first, stop = int(recording.offsets[number]), int(recording.offsets[number + 1])
        paths.append(_vary(recording.events.table[first:stop], random))
    return Recording.of(recording.name, paths, recording.trials)


def _vary(table: FloatArray, random: np.random.Generator) -> EventColumns:
    bounds = (TINY_TEMPO, TINY) if random.random() < TINY_SHARE else (TEMPO, SIZE)
    tempo, size = (float(np.exp(random.uniform(log(low), log(high)))) for low, high in bounds)
    angle, mirror = float(random.uniform(0.0, 2.0 * pi)), 1.0 if random.random() < 0.5 else -1.0
    rate, rough = float(random.choice(RATES_HZ)), bool(random.random() < ROUGH_SHARE)
    table = table[np.append(np.diff(table[:, 0]) > 0.0, True)]  # of events at one time the last counts
    if len(table) < 3:
        return EventColumns.of(table[:, 0], table[:, 1], table[:, 2])
    t = (table[:, 0] - table[0, 0]) * tempo
    place = (table[:, 1:3] - table[0, 1:3]) * size
    turned = place @ np.array([[cos(angle), sin(angle)], [-mirror * sin(angle), mirror * cos(angle)]])
    grid = np.append(np.arange(0.0, t[-1] - 0.5 / rate, 1.0 / rate), t[-1])
    return EventColumns.of(grid, *np.round(_between(t, turned, grid, rough)).T)


def _between(t: FloatArray, place: FloatArray, grid: FloatArray, rough: bool) -> FloatArray:
    """Positions at other times: on lines, or on a curve that overshoots nowhere."""
    from scipy.interpolate import PchipInterpolator

    if rough:
        return np.stack([np.interp(grid, t, axis) for axis in place.T], axis=1)
    smooth: FloatArray = np.asarray(PchipInterpolator(t, place)(grid), dtype=np.float64)
    return smooth
