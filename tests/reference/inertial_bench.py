"""A path in the plane with counts and an accelerometer of known errors."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred import EventColumns
from pointpred.accelerations import Accelerations
from pointpred.records import METRES_PER_INCH, FloatArray

CPI = 2000.0
COUNT_M = METRES_PER_INCH / CPI
GRAVITY = 9.81


def path(t: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Position m, velocity, acceleration of a smooth path in the plane, shape (rows, 2), at rest at 0."""
    place, speed, push = (np.zeros((len(t), 2)) for _ in range(3))
    for axis, parts in enumerate((((0.03, 1.1), (0.004, 3.7)), ((0.02, 1.7), (0.003, 4.3)))):
        for size, rate_hz in parts:
            w = 2.0 * np.pi * rate_hz
            place[:, axis] += size * (1.0 - np.cos(w * t))
            speed[:, axis] += size * w * np.sin(w * t)
            push[:, axis] += size * w * w * np.cos(w * t)
    return place, speed, push


class Bench:
    """A path with an accelerometer: turned, scaled, tilted, biased, with positions ``delay_s`` late."""

    def __init__(
        self, length_s: float, turn: float, delay_s: float, noise: float, seed: int = 1, counts: bool = True
    ) -> None:
        random = np.random.default_rng(seed)
        self.t = np.arange(round(1000.0 * length_s)) / 1000.0
        late = np.maximum(self.t - delay_s, 0.0)
        place = path(late)[0]
        if counts:
            place = np.round(place / COUNT_M) * COUNT_M
        px = place * 96.0 / METRES_PER_INCH
        self.events = EventColumns.of(self.t, px[:, 0], px[:, 1])
        self.scale = 1.04
        turned = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)], [0.02, -0.03]])
        self.matrix = self.scale * turned
        self.zero = GRAVITY * np.array([0.03, -0.05, 0.998]) + np.array([0.15, -0.2, 0.1])
        self.sample_t = np.arange(round(1600.0 * length_s)) / 1600.0
        force = path(self.sample_t)[2] @ self.matrix.T + self.zero
        force += noise * random.standard_normal(force.shape)
        self.samples = np.column_stack([self.sample_t, force])
        self.beside = self.events.sampled(self.samples)

    def stamped(self, behind_s: float, every: int = 1) -> EventColumns:
        """Every so many events, with the samples in their true order, stamped by a clock that is behind."""
        events = self.events[::every]
        samples = self.samples - np.array([behind_s, 0.0, 0.0, 0.0])
        before = np.searchsorted(self.sample_t, events.t, side="right")
        return EventColumns(events.table, None, Accelerations(samples, before))

    def off(self, motions: Any, since_s: float, until_s: float = np.inf) -> float:
        """RMS error of the velocity, m/s, both axes."""
        rows = (motions.t >= since_s) & (motions.t < until_s)
        speed = path(motions.t)[1]
        errors = np.column_stack([motions.vx, motions.vy])[rows] - speed[rows]
        return float(np.sqrt(np.mean(errors**2)))
