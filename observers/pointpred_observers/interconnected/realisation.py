"""The matrices of a stage of Persidskii form, each an array or a function of t, and how fast it is."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.numerics.eigenvalues import perron_root
from pointpred_observers.numerics.matrices import dimensions, matrix

NAMES = ("N", "L", "J", "K", "R0", "R1", "R", "R2")


class Realisation:
    """w' = N w + L f(Jw + R i) + K i with the output R0 w + R1 f(.) + R2 i.

    Parameters: the matrices, arrays or functions of t (of the index in discrete time); ``None`` for zero,
    for R0 the identity; ``elementwise``: f has as many arguments as components. Raises ParameterError
    naming a matrix.
    """

    def __init__(self, elementwise: bool, **given: Any) -> None:
        self._given = {name: given[name] for name in NAMES}
        self.varies = any(callable(one) for one in self._given.values())
        self.q = len(matrix("N", self._now("N", 0.0)))
        self.k = _columns(self._now("L", 0.0), self.q, "L")
        self.inputs = _columns(self._now("K", 0.0), self.q, "K")
        inner, out = self._now("J", 0.0), self._now("R0", 0.0)
        self.r = self.k if elementwise or inner is None else len(matrix("J", inner, None, self.q))
        self.outputs = self.q if out is None else len(matrix("R0", out, None, self.q))
        self._shapes = {
            "N": (self.q, self.q),
            "L": (self.q, self.k),
            "J": (self.r, self.q),
            "K": (self.q, self.inputs),
            "R0": (self.outputs, self.q),
            "R1": (self.outputs, self.k),
            "R": (self.r, self.inputs),
            "R2": (self.outputs, self.inputs),
        }
        self._constant: dict[str, FloatArray] = {}
        first = {name: self.at(name, 0.0) for name in NAMES}
        self._constant |= {name: one for name, one in first.items() if not callable(self._given[name])}

    def _now(self, name: str, t: float) -> Any:
        one = self._given[name]
        return one(t) if callable(one) else one

    def at(self, name: str, t: float) -> FloatArray:
        """A matrix at a time; raises ParameterError for a shape."""
        if name in self._constant:
            return self._constant[name]
        now, shape = self._now(name, t), self._shapes[name]
        if now is None or (self.k == 0 and name in ("J", "R")):
            return np.eye(*shape) if name == "R0" else np.zeros(shape)
        return matrix(name, now, *shape)

    def flat(self) -> list[FloatArray]:
        """The matrices at 0 in the order of their names."""
        return [self.at(name, 0.0) for name in NAMES]

    def fastest(
        self, t: float, slopes: Any, value: tuple[bool, ...], v: tuple[FloatArray, FloatArray, FloatArray]
    ) -> float:
        """A bound of the rates of the stage at a time in 1/s, with its inputs measured or missing.

        The Perron root of abs(N) + abs(L) S abs(J) bounds each eigenvalue of N + L D J with abs(D) <= S,
        and does not change with the units of the states. Unbounded slopes do not count. ``value`` and ``v``
        are those of the missing inputs.
        """
        n, ell, j, k, r = (self.at(name, t) for name in ("N", "L", "J", "K", "R"))
        v0, v1, v2 = v
        valued = np.array(value, bool)
        spread = np.zeros((self.k, self.r))
        if slopes is not None and self.k == self.r:
            steepest = np.abs(np.array(slopes, np.float64).reshape(-1, 2)).max(axis=1)
            spread = np.diag(np.where(np.isfinite(steepest), steepest, 0.0))
        measured = np.abs(n) + np.abs(ell) @ spread @ np.abs(j)
        # Missing inputs that are values are functions of w; the others are states.
        moved = np.abs(ell + k[:, valued] @ v1[valued]) @ spread
        rest = ~valued
        bridged = np.block(
            [
                [
                    np.abs(n + k[:, valued] @ v0[valued]) + moved @ np.abs(j + r[:, valued] @ v0[valued]),
                    np.abs(k[:, rest]) + moved @ np.abs(r[:, rest]),
                ],
                [
                    np.abs(v0[rest]) + np.abs(v1[rest]) @ spread @ np.abs(j),
                    np.abs(v2[np.ix_(rest, rest)]) + np.abs(v1[rest]) @ spread @ np.abs(r[:, rest]),
                ],
            ]
        )
        return max(perron_root(measured), perron_root(bridged))


def _columns(given: Any, rows: int, name: str) -> int:
    if given is None:
        return 0
    entries = matrix(name, given, rows, 1 if dimensions(given) == 1 else None)
    return int(entries.shape[1])
