"""Movements as mice make them: pauses, equal times, clicks, sub-movements."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray


def movements(seed: int, *, rate_hz: float = 125.0, count: int = 6) -> FloatArray:
    """Rows of ``EventColumns``: reaches on whole px that end with a click; every other has two parts."""
    random = np.random.default_rng(seed)
    rows, t, place = [], 10.0, np.array([500.0, 400.0])
    for number in range(count):
        way = random.uniform(-400.0, 400.0, 2)
        length = random.uniform(0.3, 0.7)
        parts = [(way, length)] if number % 2 else [(0.85 * way, length), (0.15 * way, 0.25)]
        for part, duration in parts:
            steps = round(duration * rate_hz)
            for i in range(1, steps + 1):
                s = i / steps
                at = np.round(place + part * (10 * s**3 - 15 * s**4 + 6 * s**5))
                t += random.uniform(0.8, 1.2) / rate_hz if i % 17 else 0.0
                rows.append([t, *at, np.nan, np.nan, 0.0])
            place = place + part
        rows += [[t + 0.02, *np.round(place), np.nan, np.nan, 1.0]]
        rows += [[t + 0.1, *np.round(place), np.nan, np.nan, 0.0]]
        t += 0.11 if number % 3 else 0.9
    return np.array(rows)
