"""The unknown input itself, from the outputs and the known part of their motion."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import BoolArray, FloatArray
from pointpred_observers.matrices import matrix

SINGULAR = 1e-9
"""Singular values below this share of the largest count as zero."""


class InputReconstruction:
    """The unknown input d of y' = known + G d, G = C F; in discrete time y' is the next y.

    Without ``noise`` and ``density`` d is the least-squares solution over each interval by itself, the mean
    of d over it: exact without noise, half an interval late, and noise of the outputs is divided by the
    interval's length. With them it is the Kalman filter of (y, d), in discrete time of d: white noise of
    the outputs, d a random walk. The known part is fed forward, not differentiated, and holds the
    observer's estimate, so that its errors enter d. Outputs that are missing are left out; d then changes
    by the others only.

    Parameters: ``outputs`` p; ``time``; ``noise`` standard deviation of the outputs, one number or p;
    ``density`` spectral density of the rate of d, the squared unit of d by s (variance of its change in a
    step), one number or one for each input. Raises ParameterError.

    Reference: Benyoucef et al. 2021, (39), (40), with a filter instead of the derivative; its (C F)^-1 is the
    pseudo-inverse here, for more outputs than unknown inputs.

    >>> raw = InputReconstruction(1)
    >>> raw.update(np.zeros(1), np.array([[2.0]]), 0.1, np.array([0.0]), np.array([0.6]))[0].round(9).tolist()
    [3.0]
    """

    def __init__(
        self, outputs: int, time: str = "continuous", *, noise: Any = None, density: Any = None
    ) -> None:
        self.outputs, self.time = outputs, time
        if (noise is None) != (density is None):
            raise ParameterError("noise and density come together: give both or none", field="noise")
        self.noise = None if noise is None else _sizes("noise", noise, outputs)
        self.density = density if density is None else _sizes("density", density, None)
        self.reset()

    def reset(self) -> None:
        """Forget every interval."""
        self._d: FloatArray | None = None
        self._y, self._covariance = np.zeros(self.outputs), np.zeros((0, 0))
        self._latest_inverse: tuple[bytes, FloatArray | None] = b"", None

    @property
    def latest(self) -> FloatArray | None:
        """The last estimate, ``None`` before the first."""
        return self._d

    def update(
        self, known: FloatArray, g: FloatArray, h: float, before: FloatArray, after: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """The estimate after an interval of ``h`` s, and its standard deviation; NaN where there is none.

        ``known``: the mean of C (A x + b) over it, in discrete time its value; ``before`` and ``after`` the
        outputs at its ends, NaN for a missing one.
        """
        inputs = g.shape[1]
        if self.noise is None or self._d is None:
            self._begin(known, g, h, before, after)
        elif self.time == "discrete":
            self._discrete(known, g, after)
        else:
            self._continuous(known, g, h, after)
        if self._d is None:
            return np.full(inputs, np.nan), np.full(inputs, np.nan)
        if self.noise is None:
            return self._d, np.full(inputs, np.nan)
        return self._d, np.sqrt(np.diag(self._covariance)[-inputs:])

    def _begin(
        self, known: FloatArray, g: FloatArray, h: float, before: FloatArray, after: FloatArray
    ) -> None:
        """The estimate of the interval by itself, if the outputs that were measured determine d."""
        discrete = self.time == "discrete"
        seen = ~np.isnan(after) & (discrete | ~np.isnan(before))
        inverse = self._inverse(g, seen)
        if inverse is None:
            return
        moved = after if discrete else (after - before) / h
        self._d = np.asarray(inverse @ (moved - known)[seen], np.float64)
        if self.noise is None:
            return
        if not seen.all():  # the filter starts where every output is known
            self._d = None
            return
        assert self.density is not None
        variance = np.diag(self.noise**2)
        rate = np.broadcast_to(self.density, g.shape[1:])
        if discrete:
            self._covariance = inverse @ variance @ inverse.T
            return
        self._y = after.copy()
        across = variance @ inverse.T / h
        # The end of the interval is not its middle: a random walk adds a third of its growth.
        own = 2.0 / h**2 * inverse @ variance @ inverse.T + np.diag(rate * h / 3.0)
        self._covariance = np.block([[variance, across], [across.T, own]])

    def _inverse(self, g: FloatArray, seen: BoolArray) -> FloatArray | None:
        """The weighted inverse of the rows of G that were measured, ``None`` if they do not determine d."""
        # G is often constant, and the inverse is most of the cost.
        same = g.tobytes() + seen.tobytes()
        if same != self._latest_inverse[0]:
            weights = np.ones(self.outputs) if self.noise is None else 1.0 / self.noise
            size, inverse = SINGULAR * np.linalg.norm(g), None
            if seen.any() and np.linalg.matrix_rank(g[seen], tol=size) == g.shape[1]:
                inverse = np.linalg.pinv(g[seen] * weights[seen, None], rcond=SINGULAR) * weights[seen]
            self._latest_inverse = same, inverse
        return self._latest_inverse[1]

    def _discrete(self, known: FloatArray, g: FloatArray, after: FloatArray) -> None:
        assert self._d is not None
        assert self.density is not None
        covariance = self._covariance + np.diag(np.broadcast_to(self.density, self._d.shape))
        self._d, self._covariance = self._corrected(
            self._d, covariance, g, after - known - g @ self._d, ~np.isnan(after)
        )

    def _continuous(self, known: FloatArray, g: FloatArray, h: float, after: FloatArray) -> None:
        assert self._d is not None
        assert self.density is not None
        p, m = g.shape
        walk = np.diag(np.broadcast_to(self.density, (m,)))
        onward = np.block([[np.eye(p), h * g], [np.zeros((m, p)), np.eye(m)]])
        side = 0.5 * h**2 * g @ walk
        growth = np.block([[h**3 / 3.0 * g @ walk @ g.T, side], [side.T, h * walk]])
        state = np.concatenate([self._y + h * (known + g @ self._d), self._d])
        state, self._covariance = self._corrected(
            state,
            onward @ self._covariance @ onward.T + growth,
            np.eye(p, p + m),
            after - state[:p],
            ~np.isnan(after),
        )
        self._y, self._d = state[:p], state[p:]

    def _corrected(
        self, state: FloatArray, covariance: FloatArray, rows: FloatArray, error: FloatArray, seen: BoolArray
    ) -> tuple[FloatArray, FloatArray]:
        """The state and its covariance after the measurements ``seen``, in Joseph's form."""
        assert self.noise is not None
        if not seen.any():
            return state, covariance
        h, variance = rows[seen], np.diag(self.noise[seen] ** 2)
        gain = np.linalg.solve(h @ covariance @ h.T + variance, h @ covariance).T
        kept = np.eye(len(state)) - gain @ h
        state = state + gain @ error[seen]
        return state, np.asarray(kept @ covariance @ kept.T + gain @ variance @ gain.T, np.float64)


def _sizes(name: str, given: Any, count: int | None) -> FloatArray:
    """Numbers above 0, one or ``count``."""
    sizes = matrix(name, given, 1)[0]
    if (sizes <= 0.0).any():
        raise ParameterError(f"{name} must lie above 0, received {given!r}", field=name, value=given)
    if count is not None and len(sizes) not in (1, count):
        raise ParameterError(
            f"{name} needs 1 or {count} numbers, received {len(sizes)}", field=name, value=given
        )
    return sizes if count is None else np.broadcast_to(sizes, (count,)).copy()
