"""Observers and regulators of Persidskii form as compiled stages on irregular samples."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pointpred.columns import FloatArray
from pointpred.errors import DivergenceError, EventError, EventOrderError, ParameterError
from pointpred.observers.interconnected import persidskii_law as law
from pointpred.observers.interconnected.design import ObserverDesign
from pointpred.observers.interconnected.generator import Generator
from pointpred.observers.matrices import matrix
from pointpred.observers.nonlinearity import nonlinearity
from pointpred.observers.persidskii import Persidskii
from pointpred.parameter import option, parameter
from pointpred.stage import CompiledStage

STEPS_MOST = 100_000


class PersidskiiObserver(CompiledStage):
    """The stage w' = N w + L f(Jw + R i) + K i with i the inputs of a sample; returns R0 w + R1 f(.) + R2 i.

    Assumes that inputs are linear between two samples; in discrete time each sample is one step, and its
    inputs act from the next step on. A gap longer than ``gap_s`` restarts at ``start``, because the inputs in
    between are unknown.

    Continuous time is integrated by the classical Runge-Kutta method in steps of at most ``step_s``; a step
    too long for the fastest eigenvalue of N is unstable, so choose step_s below 1 / (largest eigenvalue).

    Parameters: ``N`` (q, q), ``L`` (q, k), ``J`` (k, q), ``K`` (q, inputs), ``f`` a name or one for each
    component; ``R0`` (outputs, q), default the identity; ``R1`` (outputs, k); ``R`` (k, inputs) and ``R2``
    (outputs, inputs), default zeros; ``start`` (q), default zeros; ``step_s`` in s, [1e-6, 1]; ``gap_s`` in
    s, [1e-6, 1e6], at most 10^5 steps; ``time`` "continuous" or "discrete". Memory: the matrices and 2 + 6 q
    + k + 2 inputs floats.
    Raises ParameterError; EventError, EventOrderError and DivergenceError from ``update``.

    Reference: Khalin 2022, (3.5), (3.8), (3.17), (3.19).

    >>> lag = PersidskiiObserver([[-1.0]], None, None, [[1.0]], "sin", start=[0.0])
    >>> [round(float(lag.update(t, 1.0)[0]), 6) for t in (0.0, 0.25, 1.0)]  # 1 - exp(-t)
    [0.0, 0.221199, 0.632121]
    """

    step_s: float = parameter("s", 1e-6, 1.0, "longest step of the integration", default=1e-2)
    gap_s: float = parameter("s", 1e-6, 1e6, "longest time between two samples that is bridged", default=1.0)
    time: str = option("'continuous' or 'discrete'", default="continuous")
    step = staticmethod(law.step)
    loop = staticmethod(law.loop)

    def __init__(
        self,
        N: ArrayLike,
        L: ArrayLike | None,
        J: ArrayLike | None,
        K: ArrayLike | None,
        f: Any,
        *,
        R0: ArrayLike | None = None,
        R1: ArrayLike | None = None,
        R: ArrayLike | None = None,
        R2: ArrayLike | None = None,
        start: ArrayLike | None = None,
        **values: Any,
    ) -> None:
        self.declare(**values)
        q = len(matrix("N", N))
        ell = np.zeros((q, 0)) if L is None else matrix("L", L, q, 1 if np.ndim(L) == 1 else None)
        k = ell.shape[1]
        codes = nonlinearity(f, k).codes
        if codes is None:
            raise ParameterError(
                "a compiled stage needs an f that has a name, received a function", field="f"
            )
        kay = np.zeros((q, 0)) if K is None else matrix("K", K, q, 1 if np.ndim(K) == 1 else None)
        out = np.eye(q) if R0 is None else matrix("R0", R0, None, q)
        parts = [
            np.array(codes, np.float64),
            matrix("N", N, q, q),
            ell,
            np.zeros((0, q)) if k == 0 else matrix("J", J, k, q),
            kay,
            out,
            np.zeros((len(out), k)) if R1 is None else matrix("R1", R1, len(out), k),
            np.zeros((k, kay.shape[1])) if R is None or k == 0 else matrix("R", R, k, kay.shape[1]),
            np.zeros((len(out), kay.shape[1])) if R2 is None else matrix("R2", R2, len(out), kay.shape[1]),
            np.zeros(q) if start is None else matrix("start", start, 1, q),
        ]
        self.inputs = kay.shape[1]
        self.width = len(out)
        shape = [q, k, self.inputs, len(out), float(self.time == "discrete"), self.step_s, self.gap_s]
        settings = np.concatenate([np.array(shape, np.float64), *(part.ravel() for part in parts)])
        self._time_at = len(settings)
        self.lay_out(settings, law.floats(q, k, self.inputs))

    def declare(self, **values: Any) -> None:
        """Check the values, and the number of steps in the longest gap."""
        super().declare(**values)
        if self.gap_s / self.step_s > STEPS_MOST:
            raise ParameterError(
                f"gap_s must be at most {STEPS_MOST:.0e} step_s = {self.step_s!r} s, received {self.gap_s!r}",
                field="gap_s",
                value=self.gap_s,
            )
        if self.time not in ("continuous", "discrete"):
            raise ParameterError(
                f"time must be 'continuous' or 'discrete', received {self.time!r}",
                field="time",
                value=self.time,
            )

    def update(self, t: float, inputs: ArrayLike = ()) -> FloatArray:
        """Process the inputs measured at ``t`` (s, or the index) and return the outputs at t.

        Raises EventError for values that are not finite or a wrong number of them, EventOrderError when time
        runs backwards and DivergenceError if the state diverges; the stage is then unchanged.
        """
        row = self._row(t, inputs)
        before = self._memory.copy()
        out = np.empty(self.width)
        if law.step(self._memory, row, out) == law.BACKWARDS:
            raise EventOrderError(
                f"t must not run backwards: received {row[0]!r} after {before[self._time_at + 1]!r}",
                field="t",
                value=t,
            )
        if not np.isfinite(self._memory).all():
            self._memory[:] = before
            raise DivergenceError(f"the state leaves every bound before t = {t!r}: take a smaller step_s")
        return out

    def _row(self, t: float, inputs: ArrayLike) -> FloatArray:
        try:
            row = np.concatenate([[t], np.ravel(np.asarray(inputs, np.float64))]).astype(np.float64)
        except (TypeError, ValueError, OverflowError) as unusable:
            raise EventError(f"a sample must be numbers, received t={t!r}, inputs={inputs!r}") from unusable
        if len(row) != 1 + self.inputs:
            raise EventError(f"a sample needs {self.inputs} inputs, received {inputs!r}")
        if not np.isfinite(row).all():
            raise EventError(f"a sample must be finite, received t={t!r}, inputs={inputs!r}")
        return row


def observer_stage(design: ObserverDesign, **settings: Any) -> PersidskiiObserver:
    """Observer (3.5) of a design: inputs are Y, then rho; it returns w^, then x^ = Pi w^ of (3.7)."""
    g, plant, m = design.generator, design.plant, design.gain
    return PersidskiiObserver(
        g.S0 - m @ plant.C0 @ design.Pi,
        g.S1 - m @ plant.C1,
        plant.H @ design.Pi,
        np.hstack([g.G + m, g.E]),
        plant.f,
        R0=np.vstack([np.eye(g.q), design.Pi]),
        time=plant.time,
        **settings,
    )


def regulator_stage(plant: Persidskii, regulator: Generator, **settings: Any) -> PersidskiiObserver:
    """Regulator (3.8): inputs are Y, then rho; it returns u = L0 w + L1 f(Jw).

    Raises ParameterError if the regulator has no J.
    """
    g = regulator.beside(plant)
    if g.J is None:
        raise ParameterError("a regulator needs J: give it, or take it from the steady-state map, J = H Pi")
    return PersidskiiObserver(
        g.S0,
        g.S1,
        g.J,
        np.hstack([g.G, g.E]),
        plant.f if regulator.f is None else regulator.f,
        R0=g.L0,
        R1=g.L1,
        time=plant.time,
        **settings,
    )
