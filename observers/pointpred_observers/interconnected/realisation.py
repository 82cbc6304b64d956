"""The matrices of a stage of Persidskii form, each an array or a function of t, and their law in numpy."""

from __future__ import annotations

from math import ceil
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import BoolArray, FloatArray
from pointpred_observers.interconnected.persidskii_law import (
    ACCEPTED,
    BACKWARDS,
    REPEATED,
    SKIPPED,
    STEPS_MOST,
    TOO_LONG,
)
from pointpred_observers.numerics.eigenvalues import perron_root
from pointpred_observers.numerics.matrices import dimensions, instance, matrix
from pointpred_observers.plants.nonlinearity import Nonlinearity

NAMES = ("N", "L", "J", "K", "R0", "R1", "R", "R2")
REPLACING = ("V0", "V1", "V2")
LONGEST_S = 1e-2
"""The longest step by default, s."""


class MissingInputs(msgspec.Struct, frozen=True):
    """What replaces the inputs i of w' = N w + L f(Jw + R i) + K i while they are not measured.

    Of a *value* the input is V0 w + V1 f(.). Any other follows i' = V0 w + V1 f(.) + V2 i from its last
    measurement on; in discrete time this is the next i. ``first``: the inputs before their first measurement.
    V0 (inputs, q), V1 (inputs, k), V2 (inputs, inputs): arrays, or functions of t (of the index).
    """

    value: tuple[bool, ...]
    V0: Any
    V1: Any
    V2: Any
    first: FloatArray

    @classmethod
    def held(cls, inputs: int, q: int, k: int, time: str = "continuous") -> MissingInputs:
        """Each input keeps its last value; it is zero before the first."""
        stay = np.eye(inputs) if time == "discrete" else np.zeros((inputs, inputs))
        return cls((False,) * inputs, np.zeros((inputs, q)), np.zeros((inputs, k)), stay, np.zeros(inputs))

    @classmethod
    def expected(cls, V0: Any, V1: Any, inputs: int, time: str = "continuous") -> MissingInputs:
        """The first inputs are outputs, expected to be V0 w + V1 f(.); the others keep their last value."""
        outputs, q = matrix("V0", V0).shape
        seen = matrix("V1", V1, outputs)
        rest, k = inputs - outputs, seen.shape[1]
        return msgspec.structs.replace(
            cls.held(inputs, q, k, time),
            value=(True,) * outputs + (False,) * rest,
            V0=np.vstack([V0, np.zeros((rest, q))]),
            V1=np.vstack([seen, np.zeros((rest, k))]),
        )


class Realisation:
    """w' = N w + L f(Jw + R i) + K i with the output R0 w + R1 f(.) + R2 i, and what replaces missing inputs.

    Parameters: ``elementwise``: f has as many arguments as components; ``missing``, by default the last
    values; the matrices, arrays or functions of t (of the index in discrete time), ``None`` for zero, for R0
    the identity. Raises ParameterError naming a matrix.
    """

    def __init__(self, elementwise: bool, missing: MissingInputs | None, time: str, **given: Any) -> None:
        self._given = {name: given[name] for name in NAMES}
        self.discrete = time == "discrete"
        self.q = q = len(matrix("N", self._now("N", 0.0)))
        self.k = k = self._columns("L")
        self.inputs = m = self._columns("K")
        inner, out = self._now("J", 0.0), self._now("R0", 0.0)
        self.r = k if elementwise or inner is None else len(matrix("J", inner, None, q))
        self.outputs = q if out is None else len(matrix("R0", out, None, q))
        if missing is None:
            missing = MissingInputs.held(m, q, k, time)
        if len(instance("missing", missing, MissingInputs).value) != m:
            raise ParameterError(f"missing needs {m} inputs, received {len(missing.value)}", field="missing")
        self._given |= {name: getattr(missing, name) for name in REPLACING}
        self.varies = any(callable(one) for one in self._given.values())
        self.valued, self.first = np.array(missing.value, bool), matrix("first", missing.first, 1, m)[0]
        rows = (q, q, self.r, q, self.outputs, self.outputs, self.r, self.outputs, m, m, m)
        columns = (q, k, q, m, q, k, m, m, q, k, m)
        self._shapes = dict(zip(self._given, zip(rows, columns, strict=True), strict=True))
        self._constant: dict[str, FloatArray] = {}
        first = {name: self.at(name, 0.0) for name in self._given}
        self._constant |= {name: one for name, one in first.items() if not callable(self._given[name])}
        if (np.abs(first["R"][:, self.valued]) @ np.abs(first["V1"][self.valued])).any():
            raise ParameterError(
                "an input that enters f cannot be replaced by a value of f: set its rows of V1 to zero",
                field="missing",
            )

    def _now(self, name: str, t: float) -> Any:
        one = self._given[name]
        return one(t) if callable(one) else one

    def _columns(self, name: str) -> int:
        given = self._now(name, 0.0)
        flat = dimensions(given) == 1
        return 0 if given is None else int(matrix(name, given, self.q, 1 if flat else None).shape[1])

    def at(self, name: str, t: float) -> FloatArray:
        """A matrix at a time; raises ParameterError for a shape."""
        if name in self._constant:
            return self._constant[name]
        now, shape = self._now(name, t), self._shapes[name]
        if now is None or (self.k == 0 and name in ("J", "R")):
            return np.eye(*shape) if name == "R0" else np.zeros(shape)
        return matrix(name, now, *shape)

    def flat(self, start: FloatArray) -> list[FloatArray]:
        """What the compiled law holds, at 0."""
        held, replacing = ([self.at(name, 0.0) for name in names] for names in (NAMES, REPLACING))
        return [*held, start, self.valued.astype(np.float64), *replacing, self.first]

    def fastest(self, t: float, slopes: Any) -> float:
        """A bound of the rates of the stage at a time in 1/s, with its inputs measured or missing.

        The Perron root of abs(N) + abs(L) S abs(J) bounds each eigenvalue of N + L D J with abs(D) <= S, in
        any units.
        """
        n, ell, j, k, r, v0, v1, v2 = (self.at(name, t) for name in ("N", "L", "J", "K", "R", *REPLACING))
        valued, rest = self.valued, ~self.valued
        spread = np.zeros((self.k, self.r))
        if slopes is not None and self.k == self.r:
            steepest = np.abs(np.array(slopes, np.float64).reshape(-1, 2)).max(axis=1)
            spread = np.diag(np.where(np.isfinite(steepest), steepest, 0.0))
        measured = np.abs(n) + np.abs(ell) @ spread @ np.abs(j)
        # Missing inputs that are values are functions of w; the others are states.
        moved = np.abs(ell + k[:, valued] @ v1[valued]) @ spread
        turned = np.abs(v1[rest]) @ spread
        bridged = np.block(
            [
                [
                    np.abs(n + k[:, valued] @ v0[valued]) + moved @ np.abs(j + r[:, valued] @ v0[valued]),
                    np.abs(k[:, rest]) + moved @ np.abs(r[:, rest]),
                ],
                [
                    np.abs(v0[rest]) + turned @ np.abs(j),
                    np.abs(v2[np.ix_(rest, rest)]) + turned @ np.abs(r[:, rest]),
                ],
            ]
        )
        return max(perron_root(measured), perron_root(bridged))


class PlainLaw:
    """The law of ``persidskii_law`` in numpy, where f or matrices are functions; slow, 0.15 ms and more.

    The memory: whether there was a sample, t; w minus its start (q); the last inputs; which were missing.
    ``step_s`` is ``None`` for steps that follow the fastest eigenvalue of the matrices as they vary.
    """

    def __init__(
        self,
        parts: Realisation,
        f: Nonlinearity,
        start: FloatArray,
        step_s: float | None,
        gap_s: float | None,
    ) -> None:
        self.parts, self.f, self.start, self.step_s = parts, f, start, step_s
        self.gap_s = np.inf if gap_s is None else gap_s

    @property
    def states(self) -> int:
        """Floats of the memory."""
        return 2 + self.parts.q + 2 * self.parts.inputs

    def step(self, memory: FloatArray, row: FloatArray, out: FloatArray) -> int:
        """Process the sample (t, inputs), NaN for a missing one, into ``out``; see the compiled law."""
        q, m, discrete = self.parts.q, self.parts.inputs, self.parts.discrete
        sample, w, last, absent = np.split(memory, (2, 2 + q, 2 + q + m))
        started, t, now = sample[0] == 1.0, float(sample[1]), float(row[0])
        if started and now < t:
            return BACKWARDS
        if started and discrete and now != t and now - t != 1.0:
            return SKIPPED
        measured = ~np.isnan(row[1:])
        x, inputs = w + self.start, last.copy()
        verdict = REPEATED if started and now == t else ACCEPTED
        if verdict == ACCEPTED:
            missing = (absent == 1.0) | ~measured
            if not started or (not discrete and now - t > self.gap_s):
                x, inputs = self.start.copy(), self.parts.first.copy()
            elif discrete:
                onward, x = self._sum("V", t, x, inputs), self._sum("N", t, x, inputs)
                inputs = np.where(missing, onward, inputs)
            elif now - t > self.bridged(t):
                return TOO_LONG
            else:
                x, inputs = self._flown(t, now, x, inputs, row[1:], missing)
            absent[~measured] = 1.0
        inputs[measured] = row[1:][measured]
        absent[measured] = 0.0
        if verdict == ACCEPTED:
            inputs = self._replaced(now, x, inputs, absent == 1.0)
        sample[:] = 1.0, now
        w[:], last[:] = x - self.start, inputs
        out[:] = self._sum("R", now, x, inputs)
        return verdict

    def _f(self, t: float, x: FloatArray, inputs: FloatArray) -> FloatArray:
        if not self.parts.k:
            return np.zeros(0)
        return self.f(self.parts.at("J", t) @ x + self.parts.at("R", t) @ inputs)

    def _sum(self, what: str, t: float, x: FloatArray, inputs: FloatArray) -> FloatArray:
        """The change of w ("N"), what missing inputs follow ("V"), or the outputs ("R")."""
        names = {"N": ("N", "L", "K"), "V": REPLACING, "R": ("R0", "R1", "R2")}[what]
        first, second, third = (self.parts.at(name, t) for name in names)
        total: FloatArray = first @ x + second @ self._f(t, x, inputs) + third @ inputs
        return total

    def _replaced(self, t: float, x: FloatArray, inputs: FloatArray, missing: BoolArray) -> FloatArray:
        """The inputs with those that are missing and a value at their value."""
        chosen = missing & self.parts.valued
        if not chosen.any():
            return inputs
        inputs = np.where(chosen, self.parts.at("V0", t) @ x, inputs)
        return np.where(chosen, inputs + self.parts.at("V1", t) @ self._f(t, x, inputs), inputs)

    def bridged(self, t: float) -> float:
        """The longest interval from t on that is bridged, in s."""
        return STEPS_MOST * self._longest(t)

    def _longest(self, t: float) -> float:
        """The longest step from t on, in s."""
        if self.step_s is not None:
            return self.step_s
        return min(LONGEST_S, 1.0 / max(self.parts.fastest(t, self.f.slopes), 1e-300))

    def _flown(
        self,
        t: float,
        now: float,
        x: FloatArray,
        inputs: FloatArray,
        following: FloatArray,
        missing: BoolArray,
    ) -> tuple[FloatArray, FloatArray]:
        """The state and the inputs carried to the next sample by the classical Runge-Kutta method."""
        q, some = len(x), bool(missing.any())
        count = max(1, ceil(min((now - t) / self._longest(t), STEPS_MOST)))
        h, both = (now - t) / count, np.concatenate([x, inputs])
        for n in range(count):
            begin = t + n * h
            rise = (following - both[q:]) / (now - t - n * h)

            def rate(s: float, v: FloatArray, rise: FloatArray = rise) -> FloatArray:
                x, inputs, moving = v[:q], v[q:], rise
                if some:
                    inputs = self._replaced(s, x, inputs, missing)
                    onward = np.where(self.parts.valued, 0.0, self._sum("V", s, x, inputs))
                    moving = np.where(missing, onward, rise)
                return np.concatenate([self._sum("N", s, x, inputs), moving])

            k1 = rate(begin, both)
            k2 = rate(begin + 0.5 * h, both + 0.5 * h * k1)
            k3 = rate(begin + 0.5 * h, both + 0.5 * h * k2)
            k4 = rate(begin + h, both + h * k3)
            both = both + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        return both[:q], both[q:]
