"""Nonlinear regression (3.50): an estimator, and the condition under which Theorem 3.3.3 proves it."""

from __future__ import annotations

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.columns import FloatArray
from pointpred.errors import EventError, ParameterError, UndecidedError
from pointpred.observers.nonlinearity import KNOWN
from pointpred.observers.regressors import nonlinear_law as law
from pointpred.observers.regressors.excitation import increasing, samples
from pointpred.observers.regressors.gradient import joined
from pointpred.parameter import Parameter, check
from pointpred.regression.recursive_least_squares import moment, starting
from pointpred.stage import CompiledStage

MONOTONE = tuple(name for name, one in KNOWN.items() if one.low >= 0.0 and np.isfinite(one.high))
"""Nonlinearities that do not fall and are nowhere infinitely steep."""
PASSES_MOST = 200


class NonlinearRegressor(CompiledStage):
    """Estimator of constants x in y = (1 - D1) J x + D1 f(J x), a mean of a linear and a saturating sensor.

    Assumes that J is persistently exciting and f does not fall; where f is flat and D1 near 1 nothing is
    learned. A constant that drifts is followed with a lag.

    theta' = g J'(y - (1 - D1) J theta - D1 f(J theta)), with J, D1 and y on lines between two samples,
    by the classical Runge-Kutta method in steps of half the fastest time constant.

    Parameters: ``count`` of unknowns n, 1 to 32; ``outputs`` r, 1 to 32; ``gain`` g in 1/s over the
    square of J's unit, > 0; ``f`` one of identity, tanh, atan, saturation; ``start`` the first
    estimate, zeros unless given. Memory: 7 + 5 n + 2 (r n + r + 1) floats. Returns the estimate from
    ``update``. Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Khalin 2022, (3.47)-(3.51); before (3.51) the print lacks a J in J'J z.

    >>> stage = NonlinearRegressor(2, f="atan", gain=2.0)
    >>> for i in range(4000):
    ...     t, s = i / 100, 3.0 + 5.0 * np.sin(i / 100)
    ...     weight = np.sin(5 * t) ** 2
    ...     estimate = stage.update((1.0, np.sin(t)), weight, (1 - weight) * s + weight * np.arctan(s), t)
    >>> [round(float(value), 2) for value in estimate]
    [3.0, 5.0]
    """

    parameters = (
        Parameter("count", "", 1, 32, "number of unknown constants"),
        Parameter("outputs", "", 1, 32, "number of outputs in a sample"),
        Parameter("gain", "1/s", 1e-9, 1e9, "speed of the estimate where J has length 1"),
    )
    loop = staticmethod(law.loop)

    def __init__(
        self,
        count: int,
        *,
        outputs: int = 1,
        gain: float = 1.0,
        f: str = "atan",
        start: ArrayLike | None = None,
    ) -> None:
        check(self.parameters, {"count": count, "outputs": outputs, "gain": gain})
        for name, value in (("count", count), ("outputs", outputs)):
            if value != int(value):
                raise ParameterError(f"{name} must be a whole number, received {value!r}")
        if f not in MONOTONE:
            raise ParameterError(f"f must be one of {', '.join(MONOTONE)}, which do not fall, received {f!r}")
        self.count, self.outputs = int(count), int(outputs)
        self.width = self.count
        shape = np.array([self.count, self.outputs, gain, KNOWN[f].code, max(1.0, KNOWN[f].high)])
        first = np.zeros(self.count) if start is None else starting(self.count, start)
        self.lay_out(np.concatenate([shape, first]), law.states(self.count, self.outputs))

    def update(self, regressor: ArrayLike, weight: float, output: ArrayLike, t: float) -> FloatArray:
        """Take in a sample at ``t`` s, ``weight`` being D1, and return the estimate.

        Raises EventError for what is not finite, of another shape, a weight outside [0, 1], or a gap
        over which the gain is too large; EventOrderError when time runs backwards; nothing is then changed.
        """
        row = joined(self.count, self.outputs, regressor, output)
        try:
            share = float(weight)
        except (TypeError, ValueError) as unusable:
            raise EventError(f"weight must be a number, received {weight!r}") from unusable
        if not 0.0 <= share <= 1.0:
            raise EventError(f"weight must lie in [0, 1], received {weight!r}")
        known = law.START + self.count
        now = moment(t, float(self._memory[known + 1]) if self._memory[known] == 1.0 else None)
        out = np.empty(self.count)
        if law.step(self._memory, now, np.append(row, share), out) == law.TOO_FAST:
            raise EventError(
                f"gain J'J over the gap would need more than {law.STEPS_MOST} steps, received t={t!r}, "
                f"regressor {regressor!r}"
            )
        return out


class RegressionMargin(msgspec.Struct, frozen=True):
    """By how much Theorem 3.3.3 holds: the least ``margin`` over the record, ``at`` which time, and P there.

    Where the margin is positive V = e'Pe falls by at least twice it times abs(e)^2; elsewhere the
    theorem says nothing.
    """

    margin: float
    at: float
    P: FloatArray


def regression_margin(
    t: ArrayLike, regressor: ArrayLike, weight: ArrayLike, gain: float, *, flattest: float = 0.0
) -> RegressionMargin:
    """The margin of Theorem 3.3.3 on a record of J and D1 that repeats for ever.

    Assumes f with slopes between ``flattest`` and 1, and J, D1 constant within a sample's interval.
    The theorem shows asymptotic stability, not the input-to-state stability that it claims.

    P' = g (P J'J + J'J P) - I, solved backwards; with f(Jw) - f(Jz) = s J e the condition
    -g D1 e'P J'(f(Jw) - f(Jz) - J e) < e'e / 2 is g D1 (1 - s) max eig sym(P J'J) < 1/2 at the flattest s.

    Parameters: ``t`` s, increasing; ``regressor`` (samples, n) or (samples, r, n); ``weight`` D1 in [0, 1];
    ``gain`` g > 0; ``flattest`` in [0, 1]. Raises ParameterError; UndecidedError where P does not
    settle, as it does not without excitation.

    Reference: Khalin 2022, (3.52), Theorem 3.3.3.

    >>> t = np.linspace(0.0, 2 * np.pi, 200)
    >>> j = np.stack([np.cos(t), np.sin(t)], axis=1)
    >>> round(regression_margin(t, j, np.full(200, 0.2), 1.0).margin, 3)
    0.288
    """
    times = increasing(t)
    j = samples(regressor, len(times))
    d1 = np.asarray(weight, np.float64)
    if d1.shape != times.shape or not ((d1 >= 0.0) & (d1 <= 1.0)).all():
        raise ParameterError(f"weight must be {len(times)} numbers in [0, 1], received shape {d1.shape}")
    if not 0.0 < gain < np.inf or not 0.0 <= flattest <= 1.0:
        raise ParameterError(
            f"gain must be above 0 and flattest in [0, 1], received {gain!r} and {flattest!r}"
        )
    squares = np.einsum("kri,krj->kij", j, j)
    held, h = 0.5 * (squares[:-1] + squares[1:]), np.diff(times)
    values, vectors = np.linalg.eigh(held)
    rate = gain * np.maximum(values, 0.0) * h[:, None]
    fade = np.einsum("kia,ka,kja->kij", vectors, np.exp(-rate), vectors)
    gained = np.einsum("kia,ka,kja->kij", vectors, _share(2.0 * rate) * h[:, None], vectors)
    p, last = np.zeros(squares.shape[1:]), np.inf
    for _ in range(PASSES_MOST):
        begun, found = p, []
        for forget, new in zip(fade[::-1], gained[::-1], strict=True):
            p = new + forget @ p @ forget
            found.append(p)
        last = float(np.abs(p - begun).max()) / float(np.abs(p).max())
        if last < 1e-9:
            break
    else:
        raise UndecidedError(
            f"P still changes by {last:.2g} of itself after {PASSES_MOST} passes: no excitation?"
        )
    return _least(times, np.array(found[::-1]), squares[:-1], d1[:-1], gain * (1.0 - flattest))


def _share(x: FloatArray) -> FloatArray:
    """(1 - exp(-x)) / x, 1 at 0."""
    small = np.where(x > 1e-12, x, 1.0)
    return np.where(x > 1e-12, -np.expm1(-small) / small, 1.0)


def _least(
    times: FloatArray, p: FloatArray, squares: FloatArray, d1: FloatArray, gain: float
) -> RegressionMargin:
    product = p @ squares
    worst = np.linalg.eigvalsh(0.5 * (product + np.swapaxes(product, 1, 2)))[:, -1]
    margins = 0.5 - gain * d1 * worst
    k = int(margins.argmin())
    return RegressionMargin(float(margins[k]), float(times[k]), p[k])
