"""Recursive least squares with forgetting, as compiled laws: a triangular root, no inverse.

The information A = sum of d^(k-i) w_i w_i' is kept as its triangular root R (A = R'R) with z (psi = R'z).
Plane rotations merge each sample into the triangle, so the condition number is that of the data, not its
square. Rotations commute with a change of the regressor's units: no scaling is needed.

A stage that has a regression keeps its ``Sums`` and ``numbers(n)`` floats, writes the regressor w of
``parts`` and calls ``advance``. All zeros: no samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, hypot, inf, isfinite, sqrt
from typing import Annotated, Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.compiled import law
from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.layout import Layout
from pointpred.parameter import is_number, option, parameter
from pointpred.records import FloatArray, FloatTable
from pointpred.stage import CompiledStage


class Sums(Layout):
    """How many samples there were, the same with forgetting, the sum of squared residuals with forgetting."""

    samples: float
    effective: float
    residual: float


class Regression(NamedTuple):
    """The numbers of a regression of n unknowns."""

    w: FloatArray
    """The regressor, which ``advance`` overwrites."""
    z: FloatArray
    R: FloatTable
    """n x n, upper."""


@law
def numbers(n: int) -> int:
    """Floats that n unknowns need besides the sums."""
    return 2 * n + n * n


@law
def parts(memory: FloatArray, n: int) -> Regression:
    """The parts of ``numbers(n)`` floats."""
    return Regression(memory[:n], memory[n : 2 * n], memory[2 * n : 2 * n + n * n].reshape(n, n))


@law
def advance(s: Sums, regression: Regression, forgetting: float, output: float) -> None:
    """A = d A + w w', psi = d psi + w y for the regressor w and y = ``output``."""
    w, z, r = regression
    n = len(w)
    if forgetting < 1.0:
        keep = sqrt(forgetting)
        for i in range(n):
            z[i] *= keep
            for j in range(n):
                r[i, j] *= keep
    rest = output
    for i in range(n):
        top, low = r[i, i], w[i]
        length = hypot(top, low)
        if low == 0.0 or length == 0.0:
            continue
        cosine, sine = top / length, low / length
        for j in range(i, n):
            upper, lower = r[i, j], w[j]
            r[i, j] = cosine * upper + sine * lower
            w[j] = cosine * lower - sine * upper
        z[i], rest = cosine * z[i] + sine * rest, cosine * rest - sine * z[i]
    s.samples += 1.0
    s.effective = forgetting * s.effective + 1.0
    s.residual = forgetting * s.residual + rest * rest


@law
def excitation(r: FloatTable, j: int) -> float:
    """The sine of the angle between column j of the data and those before it: 0 if it depends on them."""
    square = 0.0
    for i in range(j + 1):
        square += r[i, j] * r[i, j]
    return abs(r[j, j]) / sqrt(square) if square > 0.0 else 0.0


@law
def solve(regression: Regression, least: float, out: FloatArray) -> bool:
    """Write the estimate to ``out``; False, without writing, if an excitation is below ``least``."""
    _, z, r = regression
    n = len(z)
    for j in range(n):
        if excitation(r, j) < least:
            return False
    for back in range(n):
        i = n - 1 - back
        value = z[i]
        for j in range(i + 1, n):
            value -= r[i, j] * out[j]
        out[i] = value / r[i, i]
    return True


class Memory(Layout):
    """Of the stage: its parameters; whether there was a time, and the last one; the regression."""

    forgetting: float
    rate: float
    least: float
    ridge: float
    started: float
    t: float
    sums: Sums
    numbers: Annotated[FloatArray, None]


class Fit(msgspec.Struct, frozen=True):
    """The estimate and its quality.

    ``values`` and ``errors`` (their standard errors if the samples' errors are independent) are ``None`` if a
    parameter is not excited; ``unexcited`` lists those whose columns depend on the columns before;
    ``condition`` of the data with columns of equal length; ``residual`` root mean square.
    """

    values: tuple[float, ...] | None
    errors: tuple[float, ...] | None
    unexcited: tuple[int, ...]
    condition: float
    residual: float
    samples: int
    effective_samples: float


class RecursiveLeastSquares(CompiledStage):
    """Least squares over all samples so far, with exponential forgetting.

    Assumes y = w'theta + error with errors in y only: noise in the regressor biases the estimate towards
    zero. Forgetting without new excitation loses the estimate; ``Fit.unexcited`` then lists its parameters.

    A = d A + w w', psi = d psi + w y, A theta = psi; stored as the triangular root of A, without an inverse.

    The recursion theta += A^-1 w (y - w'theta) has no inverse for the first samples: its start is part of the
    estimator. Without ``ridge`` the start is exact: no estimate until the samples determine one, which is
    then ordinary least squares. With ``ridge`` r the recursion starts from A = r I, psi = r ``start``: it is
    ridge regression, least squares with r |theta - start|^2 added, at every sample; ``residual`` counts that
    term, and forgetting fades it like a sample.

    Parameters: ``count`` of unknowns, 1 to 32; ``forgetting`` d in (0, 1] for each sample;
    ``forgetting_rate`` in 1/s, a further factor exp(-rate h) for each step of h s; ``least_excitation`` the
    sine below which a parameter counts as not excited; ``ridge`` in the unit of w^2, 0 for the exact start;
    ``start`` the estimate of the ridge, default zeros.
    Memory: 9 + 2 n + n^2 floats. Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Khalin 2022, section 2.5.1 and (3.62); Ljung 1999; Golub and Van Loan, Givens rotations.

    >>> stage = RecursiveLeastSquares(2)
    >>> for x in (1.0, 2.0, 4.0):
    ...     stage.update((1.0, x), 3.0 + 0.5 * x)
    >>> [round(value, 6) for value in stage.fit().values]
    [3.0, 0.5]
    >>> stage.reset()
    >>> stage.update((1.0, 2.0), 4.0)
    >>> stage.fit().values, stage.fit().unexcited
    (None, (1,))
    """

    count: int = parameter("", 1, 32, "number of unknown constants", whole=True, kw_only=False)
    forgetting: float = parameter(
        "", 1e-6, 1.0, "factor on the weight of the past at each sample", default=1.0
    )
    forgetting_rate: float = parameter(
        "1/s", 0.0, 1e6, "rate at which the weight of the past fades", default=0.0
    )
    least_excitation: float = parameter(
        "", 1e-14, 1.0, "sine below which a parameter is not excited", default=1e-6
    )
    ridge: float = parameter(
        "regressor^2", 0.0, 1e12, "weight of the start; 0: exact, no estimate too early", default=0.0
    )
    start: Sequence[float] | FloatArray | None = option("the estimate that a ridge draws to", default=None)

    def declare(self, **values: Any) -> None:
        """Check the values, and that a start comes with a ridge."""
        super().declare(**values)
        if self.start is not None and self.ridge == 0.0:
            raise ParameterError(
                "start needs a ridge above 0: the exact start draws to nothing",
                field="start",
                value=self.start,
            )
        self.count = int(self.count)
        self._start = starting(self.count, self.start)
        self.states = 2 + Sums.length + numbers(self.count)

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        weights = [float(self.forgetting), float(self.forgetting_rate)]
        return [*weights, float(self.least_excitation), float(self.ridge)]

    def update(self, regressor: Sequence[float] | FloatArray, output: float, t: float | None = None) -> None:
        """Process output = regressor . theta at ``t`` s; ``None``: no time since the last sample.

        Only the forgetting rate needs the time. Raises EventError for a value that is not a finite number or
        a regressor of another length, EventOrderError when time runs backwards; the stage is then unchanged.
        """
        memory = Memory(self._memory)
        last_t = float(memory.t) if memory.started == 1.0 else None
        w, y = sample(self.count, regressor, output)
        now = last_t if t is None else moment(t, last_t)
        h = 0.0 if last_t is None or now is None else now - last_t
        if now is not None:
            memory.started, memory.t = 1.0, now
        regression = parts(memory.numbers, self.count)
        if memory.ridge > 0.0 and memory.sums.samples == 0.0:
            # The start of a ridge regression: A = r I, psi = r start.
            weight = sqrt(float(memory.ridge))
            np.fill_diagonal(regression.R, weight)
            regression.z[:] = weight * self._start
        regression.w[:] = w
        advance(memory.sums, regression, memory.forgetting * exp(-memory.rate * h), y)

    def fit(self) -> Fit:
        """The current estimate and its quality."""
        memory = Memory(self._memory)
        return fit(memory.sums, parts(memory.numbers, self.count), float(memory.least))


def starting(count: int, start: ArrayLike | None) -> FloatArray:
    """The first estimate, zeros for ``None``; raises ParameterError unless it is ``count`` numbers."""
    if start is None:
        return np.zeros(count)
    wrong = f"start must be {count} finite numbers, received {start!r}"
    try:
        values = np.array(start, np.float64)
    except (TypeError, ValueError) as unusable:
        raise ParameterError(wrong, field="start", value=start) from unusable
    if values.shape != (count,) or not np.isfinite(values).all():
        raise ParameterError(wrong, field="start", value=start)
    return values


def sample(count: int, regressor: ArrayLike, output: float) -> tuple[FloatArray, float]:
    """A sample as numbers; raises EventError for an invalid one."""
    received = f"received regressor {regressor!r}, output {output!r}"
    try:
        w, y = np.asarray(regressor, np.float64), float(output)
    except (TypeError, ValueError, OverflowError) as unusable:
        raise EventError(
            f"sample must be numbers, {received}", field="regressor", value=regressor
        ) from unusable
    if w.shape != (count,):
        raise EventError(
            f"regressor needs {count} values, received shape {w.shape}", field="regressor", value=regressor
        )
    if not (np.isfinite(w).all() and isfinite(y)):
        raise EventError(f"sample must be finite, {received}")
    return w, y


def moment(t: float, last_t: float | None) -> float:
    """The time of a sample; raises EventError if not a number, EventOrderError if it runs backwards."""
    try:
        now = float(t) if is_number(t) else inf
    except OverflowError:  # an integer beyond every float
        now = inf
    if not isfinite(now):
        raise EventError(f"t must be a finite number, received {t!r}", field="t", value=t)
    if last_t is not None and now < last_t:
        raise EventOrderError(
            f"t must not run backwards: received {now!r} s after {last_t!r} s", field="t", value=now
        )
    return now


def fit(s: Sums, regression: Regression, least: float) -> Fit:
    """The estimate of a regression and its quality."""
    _, z, triangle = regression
    count = len(z)
    sines = [excitation(triangle, j) for j in range(count)]
    unexcited = tuple(j for j, sine in enumerate(sines) if sine < least)
    samples, effective, square = int(s.samples), float(s.effective), float(s.residual)
    residual = sqrt(square / effective) if effective > 0.0 else 0.0
    if unexcited:
        return Fit(None, None, unexcited, inf, residual, samples, effective)
    singular = np.linalg.svd(triangle / np.linalg.norm(triangle, axis=0), compute_uv=False)
    spread = np.linalg.norm(np.linalg.solve(triangle, np.eye(count)), axis=1)
    spare = effective - count
    variance = square / spare if spare > 0.0 else inf
    return Fit(
        tuple(np.linalg.solve(triangle, z).tolist()),
        tuple((sqrt(variance) * spread).tolist()),
        (),
        float(singular[0] / singular[-1]),
        residual,
        samples,
        effective,
    )
