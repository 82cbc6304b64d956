"""The unknown input itself, from the outputs and the known part of their motion."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import matrix

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
        self.density = None if density is None else _sizes("density", density, None)
        self.reset()

    def reset(self) -> None:
        """Forget every interval."""
        self.latest: FloatArray | None = None
        """The last estimate, ``None`` before the first."""
        self._y, self._covariance = np.zeros(self.outputs), np.zeros((0, 0))
        self._inverses: tuple[bytes, FloatArray | None] = b"", None

    def update(
        self, known: FloatArray, g: FloatArray, h: float, before: FloatArray, after: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """The estimate after an interval of ``h`` s, and its standard deviation; NaN where there is none.

        ``known``: the mean of C (A x + b) over it, in discrete time its value; ``before`` and ``after`` the
        outputs at its ends, NaN for a missing one.
        """
        none = np.full(g.shape[1], np.nan)
        if self.noise is not None and self.density is not None:
            walk = np.diag(np.broadcast_to(self.density, g.shape[1:]))
            if self.latest is None:
                self._begin(known, g, h, before, after, self.noise, walk)
            else:
                self._filter(known, g, h, after, self.noise, walk, self.latest)
            spread = none if self.latest is None else np.sqrt(np.diag(self._covariance)[-len(none) :])
        else:
            inverse, moved = self._interval(g, h, before, after)
            if inverse is not None:
                seen = ~np.isnan(moved)
                self.latest = np.asarray(inverse @ (moved - known)[seen], np.float64)
            spread = none
        return none if self.latest is None else self.latest, spread

    def _interval(
        self, g: FloatArray, h: float, before: FloatArray, after: FloatArray
    ) -> tuple[FloatArray | None, FloatArray]:
        """The inverse of the rows of G that were measured, if these determine d; y', or the next y."""
        moved = after if self.time == "discrete" else (after - before) / h
        seen = ~np.isnan(moved)
        same = g.tobytes() + seen.tobytes()  # G is often constant, and the inverse is most of the cost
        if same != self._inverses[0]:
            left, sizes, right = np.linalg.svd(g[seen], full_matrices=False)
            inverse = None
            if len(sizes) == g.shape[1] and sizes.min() > SINGULAR * np.linalg.norm(g):
                inverse = np.asarray((right.T / sizes) @ left.T, np.float64)
                if self.noise is not None:
                    weights = 1.0 / self.noise[seen]
                    inverse = np.linalg.pinv(g[seen] * weights[:, None], rcond=SINGULAR) * weights
            self._inverses = same, inverse
        return self._inverses[1], moved

    def _begin(
        self,
        known: FloatArray,
        g: FloatArray,
        h: float,
        before: FloatArray,
        after: FloatArray,
        noise: FloatArray,
        walk: FloatArray,
    ) -> None:
        """Start the filter with an interval by itself, at whose ends every output is known."""
        inverse, moved = self._interval(g, h, before, after)
        if inverse is None or np.isnan(moved).any():
            return
        self.latest, variance = np.asarray(inverse @ (moved - known), np.float64), np.diag(noise**2)
        if self.time == "discrete":
            self._covariance = inverse @ variance @ inverse.T
            return
        self._y = after.copy()
        across = variance @ inverse.T / h
        # The end of the interval is not its middle: a random walk adds a third of its growth.
        own = 2.0 / h**2 * inverse @ variance @ inverse.T + walk * h / 3.0
        self._covariance = np.block([[variance, across], [across.T, own]])

    def _filter(
        self,
        known: FloatArray,
        g: FloatArray,
        h: float,
        after: FloatArray,
        noise: FloatArray,
        walk: FloatArray,
        d: FloatArray,
    ) -> None:
        """Predict (y, d), in discrete time d, and correct it by what was measured, in Joseph's form."""
        p, m = g.shape
        if self.time == "discrete":
            state, covariance, rows = d, self._covariance + walk, g
            error = after - known - g @ d
        else:
            onward = np.block([[np.eye(p), h * g], [np.zeros((m, p)), np.eye(m)]])
            side = 0.5 * h**2 * g @ walk
            growth = np.block([[h**3 / 3.0 * g @ walk @ g.T, side], [side.T, h * walk]])
            state, rows = np.concatenate([self._y + h * (known + g @ d), d]), np.eye(p, p + m)
            covariance = onward @ self._covariance @ onward.T + growth
            error = after - state[:p]
        seen = ~np.isnan(after)
        if seen.any():
            rows, variance = rows[seen], np.diag(noise[seen] ** 2)
            gain = np.linalg.solve(rows @ covariance @ rows.T + variance, rows @ covariance).T
            kept = np.eye(len(state)) - gain @ rows
            state = state + gain @ error[seen]
            covariance = kept @ covariance @ kept.T + gain @ variance @ gain.T
        self._covariance = covariance
        self._y, self.latest = state[:-m], state[-m:]


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
