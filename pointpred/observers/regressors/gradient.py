"""Regressors as observers of constants: gradient estimators, beside the project's recursive least squares.

The parameters are the state of a plant that stands still; what the reversed connection of section 3.3
makes of it is an estimator of them.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from pointpred.columns import FloatArray
from pointpred.errors import EventError, ParameterError
from pointpred.observers.regressors import gradient_law as law
from pointpred.parameter import Parameter, check
from pointpred.regression import RecursiveLeastSquares
from pointpred.regression.recursive_least_squares import moment, starting
from pointpred.stage import CompiledStage

__all__ = ["GradientRegressor", "RecursiveLeastSquares"]


class GradientRegressor(CompiledStage):
    """Gradient estimator of constants x in y = D x, as a differential equation or sample by sample.

    Assumes a regressor D that is persistently exciting: in directions that D does not visit nothing is
    learned, and a constant that drifts is followed with a lag. Noise is not averaged away. More gain
    is not always faster: a large one holds the estimate on the plane of the newest sample, along which
    it then creeps.

    Continuous (3.46): theta' = G D'(y - D theta), with D and y on a line between two samples; of
    second order in the interval, exact in theta for one output, and no gain is too large.
    Discrete (3.58): theta += G D'(y - D theta), refused where the trace of D G D' reaches 2, for the
    error could then grow; ``normalised`` divides G by 1 + trace(D G D'), so that no sample is refused.

    Parameters: ``count`` of unknowns n, 1 to 32; ``outputs`` p, 1 to 32; ``gain`` G, a positive
    number, n of them or a positive definite matrix, in 1/s over the square of the regressor's unit
    (discrete: without 1/s); ``time`` "continuous" or "discrete"; ``start`` the first estimate, zeros
    unless given. Memory: 5 + 2 n + n^2 + 2 p (n + 1) floats. Returns the estimate from ``update``.
    Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Khalin 2022, (3.41)-(3.46) and (3.53)-(3.58), with G positive definite where the print
    has nonsingular.

    >>> stage = GradientRegressor(2, gain=3.0)
    >>> for i in range(800):
    ...     t = i / 50
    ...     estimate = stage.update((1.0, np.sin(3 * t)), 3.0 + 5.0 * np.sin(3 * t), t)
    >>> [round(float(value), 3) for value in estimate]
    [3.0, 5.0]
    """

    parameters = (
        Parameter("count", "", 1, 32, "number of unknown constants"),
        Parameter("outputs", "", 1, 32, "number of outputs in a sample"),
    )
    loop = staticmethod(law.loop)

    def __init__(
        self,
        count: int,
        *,
        outputs: int = 1,
        gain: ArrayLike = 1.0,
        time: Literal["continuous", "discrete"] = "continuous",
        normalised: bool = False,
        start: ArrayLike | None = None,
    ) -> None:
        check(self.parameters, {"count": count, "outputs": outputs})
        for name, value in (("count", count), ("outputs", outputs)):
            if value != int(value):
                raise ParameterError(f"{name} must be a whole number, received {value!r}")
        if time not in ("continuous", "discrete"):
            raise ParameterError(f"time must be 'continuous' or 'discrete', received {time!r}")
        if normalised and time == "continuous":
            raise ParameterError(
                "normalised needs time='discrete': no gain of the continuous law is too large"
            )
        self.count, self.outputs, self.time = int(count), int(outputs), time
        self.width = self.count
        kind = law.CONTINUOUS if time == "continuous" else law.NORMALISED if normalised else law.DISCRETE
        first = np.zeros(self.count) if start is None else starting(self.count, start)
        shape = np.array([float(self.count), float(self.outputs), kind])
        settings = np.concatenate([shape, first, positive(self.count, gain).ravel()])
        self.lay_out(settings, law.states(self.count, self.outputs))

    def update(self, regressor: ArrayLike, output: ArrayLike, t: float | None = None) -> FloatArray:
        """Take in output = regressor theta at ``t`` s and return the estimate.

        The discrete law needs no time. Raises EventError for what is not finite, of another shape or
        too steep, and EventOrderError when time runs backwards; nothing is then changed.
        """
        state = law.known(self.count)
        last_t = float(self._memory[state + 1])
        sample = joined(self.count, self.outputs, regressor, output)
        if t is None and self.time == "continuous":
            raise EventError("the continuous law needs the time of every sample, received t=None")
        now = last_t if t is None else moment(t, last_t if self._memory[state] == 1.0 else None)
        out = np.empty(self.count)
        if law.step(self._memory, now, sample, out) == law.TOO_STEEP:
            raise EventError(
                "the trace of D G D' must lie below 2, where a step may enlarge the error, received "
                f"regressor {regressor!r}: choose a smaller gain or normalised=True"
            )
        return out


def joined(count: int, outputs: int, regressor: ArrayLike, output: ArrayLike) -> FloatArray:
    """A sample as one row; raises EventError where it cannot be taken in."""
    received = f"received regressor {regressor!r}, output {output!r}"
    try:
        d, y = np.asarray(regressor, np.float64), np.asarray(output, np.float64)
    except (TypeError, ValueError, OverflowError) as unusable:
        raise EventError(f"a sample must be numbers, {received}") from unusable
    if d.shape not in ((outputs, count), (count,) if outputs == 1 else ()) or y.size != outputs:
        raise EventError(
            f"a sample needs a regressor of shape ({outputs}, {count}) and {outputs} outputs, {received}"
        )
    row = np.concatenate([d.ravel(), y.ravel()])
    if not np.isfinite(row).all():
        raise EventError(f"a sample must be finite, {received}")
    return row


def positive(count: int, gain: ArrayLike) -> FloatArray:
    """A gain as a matrix; raises ParameterError unless it is symmetric and positive definite."""
    try:
        given = np.asarray(gain, np.float64)
    except (TypeError, ValueError) as unusable:
        raise ParameterError(f"gain must be numbers, received {gain!r}") from unusable
    if given.shape not in ((), (count,), (count, count)) or not np.isfinite(given).all():
        raise ParameterError(f"gain must be a finite number, {count} or {count} x {count}, received {gain!r}")
    matrix = np.diag(np.broadcast_to(given, count)) if given.ndim < 2 else given
    if np.abs(matrix - matrix.T).max() > 1e-12 * np.abs(matrix).max():
        raise ParameterError(f"gain must be symmetric, received {gain!r}")
    least = float(np.linalg.eigvalsh(matrix).min())
    if least <= 0.0:
        raise ParameterError(
            f"gain must be positive definite, its least eigenvalue is {least:g}, received {gain!r}"
        )
    return np.array(matrix, np.float64)
