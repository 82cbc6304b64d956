"""The law of ``persidskii_law`` as plain Python, for an f or matrices that are functions."""

from __future__ import annotations

from math import ceil

import numpy as np

from pointpred.records import BoolArray, FloatArray
from pointpred_observers.interconnected.missing_inputs import MissingInputs
from pointpred_observers.interconnected.persidskii_law import (
    ACCEPTED,
    BACKWARDS,
    REPEATED,
    SKIPPED,
    STEPS_MOST,
    TOO_LONG,
)
from pointpred_observers.interconnected.realisation import Realisation
from pointpred_observers.plants.nonlinearity import Nonlinearity


class PlainLaw:
    """A step of the stage in numpy, on a memory that holds the state only; slow, 0.15 ms and more.

    The state: whether there was a sample, t; w minus its start (q); the last inputs; which were missing.

    ``step_s`` is ``None`` for steps that follow the fastest eigenvalue of the matrices as they vary.
    """

    def __init__(
        self,
        parts: Realisation,
        f: Nonlinearity,
        missing: MissingInputs,
        start: FloatArray,
        *,
        discrete: bool,
        step_s: float | None,
        longest_s: float,
        gap_s: float | None,
    ) -> None:
        self.parts, self.f, self.missing, self.start = parts, f, missing, start
        self.discrete, self.step_s, self.longest_s = discrete, step_s, longest_s
        self.gap_s = np.inf if gap_s is None else gap_s
        self._valued = np.array(missing.value, bool)

    @property
    def states(self) -> int:
        """Floats of the memory."""
        return 2 + self.parts.q + 2 * self.parts.inputs

    def step(self, memory: FloatArray, row: FloatArray, out: FloatArray) -> int:
        """Process the sample (t, inputs), NaN for a missing one, into ``out``; an earlier t is refused.

        So is one after more than 10^5 steps, in discrete time one whose index is not the next.
        """
        q, m = self.parts.q, self.parts.inputs
        sample, w, last, absent = np.split(memory, (2, 2 + q, 2 + q + m))
        started, t, now = sample[0] == 1.0, float(sample[1]), float(row[0])
        if started and now < t:
            return BACKWARDS
        if started and self.discrete and now != t and now - t != 1.0:
            return SKIPPED
        measured = ~np.isnan(row[1:])
        x, inputs = w + self.start, last.copy()
        verdict = REPEATED if started and now == t else ACCEPTED
        if verdict == ACCEPTED:
            missing = (absent == 1.0) | ~measured
            if not started or (not self.discrete and now - t > self.gap_s):
                x, inputs = self.start.copy(), self.missing.first.copy()
            elif not self.discrete and now - t > self.bridged(t):
                return TOO_LONG
            else:
                x, inputs = self._moved(t, now, x, inputs, row[1:], missing)
            absent[~measured] = 1.0
        inputs[measured] = row[1:][measured]
        absent[measured] = 0.0
        if verdict == ACCEPTED:
            inputs = self._replaced(now, x, inputs, absent == 1.0)
        sample[:] = 1.0, now
        w[:], last[:] = x - self.start, inputs
        at = self.parts.at
        out[:] = at("R0", now) @ x + at("R1", now) @ self._f(now, x, inputs) + at("R2", now) @ inputs
        return verdict

    def _f(self, t: float, x: FloatArray, inputs: FloatArray) -> FloatArray:
        if not self.parts.k:
            return np.zeros(0)
        return self.f(self.parts.at("J", t) @ x + self.parts.at("R", t) @ inputs)

    def _replaced(self, t: float, x: FloatArray, inputs: FloatArray, missing: BoolArray) -> FloatArray:
        """The inputs with those that are missing and a value at their value."""
        chosen = missing & self._valued
        if not chosen.any():
            return inputs
        v0, v1, _ = self.missing.at(t)
        inputs = np.where(chosen, v0 @ x, inputs)
        return np.where(chosen, inputs + v1 @ self._f(t, x, inputs), inputs)

    def _moved(
        self,
        t: float,
        now: float,
        x: FloatArray,
        inputs: FloatArray,
        following: FloatArray,
        missing: BoolArray,
    ) -> tuple[FloatArray, FloatArray]:
        """The state and the inputs carried from one sample to the next."""
        if self.discrete:
            onward, change = self._rate(t, x, inputs), self._change(t, x, inputs)
            return change, np.where(missing, onward, inputs)
        count = max(1, ceil(min((now - t) / self._longest(t), STEPS_MOST)))
        h = (now - t) / count
        both = np.concatenate([x, inputs])
        for n in range(count):
            left = now - t - n * h
            rise = (following - both[len(x) :]) / left
            both = self._runge_kutta(t + n * h, h, both, rise, missing)
        return both[: len(x)], both[len(x) :]

    def bridged(self, t: float) -> float:
        """The longest interval from t on that is bridged, in s."""
        return STEPS_MOST * self._longest(t)

    def _longest(self, t: float) -> float:
        """The longest step from t on, in s."""
        if self.step_s is not None:
            return self.step_s
        speed = self.parts.fastest(t, self.f.slopes, self.missing.value, self.missing.at(t))
        return min(self.longest_s, 1.0 / max(speed, 1e-300))

    def _runge_kutta(
        self, t: float, h: float, both: FloatArray, rise: FloatArray, missing: BoolArray
    ) -> FloatArray:
        q, whole = self.parts.q, not missing.any()

        def rate(s: float, v: FloatArray) -> FloatArray:
            x, inputs, moving = v[:q], v[q:], rise
            if not whole:
                inputs = self._replaced(s, x, inputs, missing)
                moving = np.where(missing, np.where(self._valued, 0.0, self._rate(s, x, inputs)), rise)
            return np.concatenate([self._change(s, x, inputs), moving])

        k1 = rate(t, both)
        k2 = rate(t + 0.5 * h, both + 0.5 * h * k1)
        k3 = rate(t + 0.5 * h, both + 0.5 * h * k2)
        k4 = rate(t + h, both + h * k3)
        return both + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)

    def _change(self, t: float, x: FloatArray, inputs: FloatArray) -> FloatArray:
        """N w + L f + K i."""
        at = self.parts.at
        change: FloatArray = at("N", t) @ x + at("L", t) @ self._f(t, x, inputs) + at("K", t) @ inputs
        return change

    def _rate(self, t: float, x: FloatArray, inputs: FloatArray) -> FloatArray:
        """V0 w + V1 f + V2 i."""
        v0, v1, v2 = self.missing.at(t)
        rate: FloatArray = v0 @ x + v1 @ self._f(t, x, inputs) + v2 @ inputs
        return rate
