"""An unknown input observer at run time: samples in, estimates of the state and of the unknown input out."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from functools import partial
from math import ceil
from typing import TYPE_CHECKING, Any, Self

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.errors import DivergenceError, EventError, EventOrderError, ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray, FloatTable
from pointpred.regression.least_squares import moment
from pointpred_observers.numerics.eigenvalues import SINGULAR, perron_root
from pointpred_observers.numerics.matrices import matrix, wrong
from pointpred_observers.plants.boxes import weigh

if TYPE_CHECKING:
    from pointpred_observers.unknown_input.observer import UnknownInputObserver

SUBSTEP = 0.2
"""Longest step of an integration, a share of the shortest time constant."""
STEPS_MOST = 100_000
"""Most steps between two samples: within as many time constants the steps grow with the interval."""
BASE, TOTAL, STAGE, RATE, ESTIMATE = 0, 1, 2, 3, 4
"""Rows of the space for a step: z at its begin, sums of rates, z and its rate now, x_hat now."""


class UnknownInputSample(msgspec.Struct, frozen=True):
    """The outputs y and the known part b(y, u) at ``t`` s (or the index), and the scheduling variables there.

    An output that is NaN is missing, ``None`` for all of them. ``schedule`` is a dict, or a function of x.
    """

    t: float
    y: Any
    known: FloatArray
    schedule: Any


class UnknownInputEstimate(msgspec.Struct, frozen=True):
    """The estimate of the state, and of the unknown input d with its standard deviation ``spread``.

    ``certified`` while the scheduling variables lie in the design's box and no output has been missing
    since the sample before. ``d`` is NaN until it can be estimated, and where the schedule lacks a variable
    of A; without a filter it is the mean since the sample before and ``spread`` is NaN. In discrete time it
    is the d of the step that ends here.
    """

    t: float
    x: FloatArray
    certified: bool
    d: FloatArray
    spread: FloatArray


@law
def mix(corners: FloatTable, axes: FloatTable, p: FloatArray, weights: FloatArray, block: FloatArray) -> bool:
    """The matrices at a point of a box from those at its vertices, a row each; false for one outside."""
    if not weigh(axes, p, weights):
        return False
    for j in range(len(block)):
        block[j] = 0.0
    for i in range(len(weights)):
        if weights[i] != 0.0:
            for j in range(len(block)):
                block[j] += weights[i] * corners[i, j]
    return True


@law
def estimated(block: FloatArray, ends: FloatTable, s: float, space: FloatTable) -> None:
    """x_hat = z - E y, with y at a share ``s`` of the interval between two samples."""
    n = space.shape[1]
    outputs = ends.shape[1] - n
    at = n * n + n * outputs
    for i in range(n):
        total = space[STAGE, i]
        for j in range(outputs):
            y = (1.0 - s) * ends[0, j] + s * ends[1, j]
            total -= block[at + i * outputs + j] * y
        space[ESTIMATE, i] = total


@law
def push(
    block: FloatArray, c: FloatTable, ends: FloatTable, s: float, part: int, h: float, space: FloatTable
) -> None:
    """One of the four rates of a step of ``h`` s by Runge-Kutta, at x_hat and a share ``s`` of the interval.

    z' = Gamma x_hat + K (y - C x_hat) + T b.
    """
    n = space.shape[1]
    outputs = ends.shape[1] - n
    k_at, t_at = n * n, n * n + 2 * n * outputs
    for i in range(n):
        total = 0.0
        for j in range(n):
            b = (1.0 - s) * ends[0, outputs + j] + s * ends[1, outputs + j]
            total += block[i * n + j] * space[ESTIMATE, j] + block[t_at + i * n + j] * b
        space[RATE, i] = total
    for k in range(outputs):
        error = (1.0 - s) * ends[0, k] + s * ends[1, k]
        for j in range(n):
            error -= c[k, j] * space[ESTIMATE, j]
        for i in range(n):
            space[RATE, i] += block[k_at + i * outputs + k] * error
    for i in range(n):
        if part == 0:
            space[BASE, i], space[TOTAL, i] = space[STAGE, i], 0.0
        rate = space[RATE, i]
        space[TOTAL, i] += rate if part == 0 or part == 3 else 2.0 * rate
        if part == 3:
            space[STAGE, i] = space[BASE, i] + h / 6.0 * space[TOTAL, i]
        else:
            space[STAGE, i] = space[BASE, i] + (h if part == 2 else 0.5 * h) * rate


class InputReconstruction:
    """The unknown input d of y' = known + G d, G = C F; in discrete time y' is the next y.

    Without ``noise`` and ``density`` d is the least-squares solution over each interval by itself, the mean
    of d over it: exact without noise, half an interval late, and noise of the outputs is divided by the
    interval's length. With them it is the Kalman filter of (y, d), in discrete time of d: white noise of
    the outputs, d a random walk. Errors of the observer's estimate enter d. Missing outputs are left out.

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
        self.noise = None if noise is None else np.broadcast_to(_sizes("noise", noise, outputs), (outputs,))
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
        if self.noise is None or self.density is None:
            self._by_itself(known, g, h, before, after)
            return none if self.latest is None else self.latest, none
        variance, walk = np.diag(self.noise**2), np.diag(np.broadcast_to(self.density, g.shape[1:]))
        if self.latest is not None:
            self._filter(known, g, h, after, variance, walk, self.latest)
        elif not np.isnan([before, after] if self.time == "continuous" else after).any():
            inverse = self._by_itself(known, g, h, before, after)
            if inverse is None:
                return none, none
            self._covariance = inverse @ variance @ inverse.T
            if self.time == "continuous":
                self._y, across = after.copy(), variance @ inverse.T / h
                # The end of the interval is not its middle: a random walk adds a third of its growth.
                own = 2.0 / h**2 * self._covariance + walk * h / 3.0
                self._covariance = np.block([[variance, across], [across.T, own]])
        else:
            return none, none
        assert self.latest is not None
        return self.latest, np.sqrt(np.diag(self._covariance)[-len(none) :])

    def _by_itself(
        self, known: FloatArray, g: FloatArray, h: float, before: FloatArray, after: FloatArray
    ) -> FloatArray | None:
        """Estimate d over the interval; the inverse of the rows of G that were measured, if they tell d."""
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
        inverse = self._inverses[1]
        if inverse is not None:
            self.latest = np.asarray(inverse @ (moved - known)[seen], np.float64)
        return inverse

    def _filter(
        self,
        known: FloatArray,
        g: FloatArray,
        h: float,
        after: FloatArray,
        variance: FloatArray,
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
            rows, variance = rows[seen], variance[np.ix_(seen, seen)]
            gain = np.linalg.solve(rows @ covariance @ rows.T + variance, rows @ covariance).T
            kept = np.eye(len(state)) - gain @ rows
            state = state + gain @ error[seen]
            covariance = kept @ covariance @ kept.T + gain @ variance @ gain.T
        self._covariance = covariance
        self._y, self.latest = state[:-m], state[-m:]


def _sizes(name: str, given: Any, count: int | None) -> FloatArray:
    """Numbers above 0, one or ``count``."""
    sizes: FloatArray = matrix(name, given, 1)[0]
    if (sizes <= 0.0).any():
        raise wrong(name, "must lie above 0", given)
    if count is not None and len(sizes) not in (1, count):
        raise wrong(name, f"needs 1 or {count} numbers", given)
    return sizes


class UnknownInputStage:
    """A ``Stage[UnknownInputSample, UnknownInputEstimate]`` that runs a design.

    Assumes that y, b and the scheduling variables are linear between two samples; in discrete time each
    sample is a step, its index the last one plus 1. The matrices that run are those of the vertices, mixed:
    the ones that are proved. Outside the box they are those of the system, with the gains of the nearest
    point, and ``certified`` is false.

    While an output is missing at one end of an interval the model is followed, x' = A x + b + F d with the
    last estimate of d (zero before the first). At its end the outputs that are measured correct the
    estimate along F, x + F (C_s F)^+ (y_s - C_s x); other errors are not corrected, and nothing is proved.

    Parameters: ``design``; ``start`` the estimate at the first sample, by default 0, whose outputs the first
    sample replaces; ``noise`` and ``density`` as for ``InputReconstruction``. Memory: the estimate, one
    sample, a covariance, and the matrices at the vertices. Raises ParameterError; EventError,
    EventOrderError and DivergenceError from ``update``, which leaves it unchanged.

    >>> from pointpred_observers import Box, ParameterVaryingSystem, design
    >>> system = ParameterVaryingSystem(
    ...     lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), lambda p: np.array([[1.0], [0.0]]), np.eye(1, 2)
    ... )
    >>> observer = design(system, box=Box({"k": (-3.0, -1.0)}), decay=0.5)
    >>> running = observer.stage([0.0, 1.0])
    >>> for i in range(101):
    ...     sample = UnknownInputSample(i / 100, np.array([7.0]), np.zeros(2), lambda x: {"k": -2.0})
    ...     estimate = running.update(sample)
    >>> round(float(estimate.x[1] / np.exp(-2.0)), 6), estimate.certified
    (1.0, True)
    >>> bool(abs(estimate.d[0] + estimate.x[1]) < 0.01)  # y' = x2 + d = 0
    True
    """

    def __init__(
        self, design: UnknownInputObserver, start: Any = None, *, noise: Any = None, density: Any = None
    ) -> None:
        outputs, n = design.system.c.shape
        self.design = design
        self.start = np.zeros(n) if start is None else matrix("start", start, n, 1).ravel()
        self.reconstruction = InputReconstruction(outputs, design.system.time, noise=noise, density=density)
        corners = [design.equations(point) for point in design.box.corners]
        self._corners = np.array([np.concatenate([part.ravel() for part in one]) for one in corners])
        self._moving = any(not np.array_equal(one[2], corners[0][2]) for one in corners)  # E
        self._axes = design.box.axes
        self._fastest = design.fastest
        self.reset()

    def reset(self) -> None:
        """Forget every sample."""
        outputs, n = self.design.system.c.shape
        self._last: UnknownInputSample | None = None
        self._whole, self._x = True, self.start
        self._motion: tuple[FloatArray | None, FloatArray] = None, np.zeros((outputs, 0))
        self._p: list[float] | None = None
        self._inside = False
        self._block, self._weights = np.zeros(self._corners.shape[1]), np.zeros(len(self._corners))
        self._space, self._ends = np.zeros((5, n)), np.zeros((2, outputs + n))
        self.reconstruction.reset()

    def fresh(self) -> Self:
        """The same design and start, without memory."""
        of = self.reconstruction
        return type(self)(self.design, self.start, noise=of.noise, density=of.density)

    def update(self, given: UnknownInputSample, /) -> UnknownInputEstimate:
        """Consume one sample; a refused one changes nothing."""
        sample, old, system = self._checked(given), self._last, self.design.system
        whole = not np.isnan(sample.y).any()
        bridged = not (whole and self._whole)
        with np.errstate(over="ignore", invalid="ignore"):
            if old is None:
                seen = ~np.isnan(sample.y)
                x = self.start + np.linalg.pinv(system.c[seen]) @ (sample.y - system.c @ self.start)[seen]
            elif bridged:
                x = self._bridged(self._x, old, sample)
            elif system.time == "discrete":
                x = self._onward(self._x, old, sample)
            else:
                x = self._carried(self._x, old, sample)
        if not np.isfinite(x).all():
            raise DivergenceError(f"the estimate leaves every bound at t = {sample.t:g}")
        point = sample.schedule(x)
        certified = not (bridged or self.design.box.outside(point))
        g, after = system.c @ system.f(point), None
        with suppress(KeyError):  # of a system that gives T A, A may need more variables
            after = system.c @ (system.a(point) @ x + sample.known)
        known, g_before = self._motion
        d = spread = np.full(g.shape[1], np.nan)
        if old is not None and known is not None and after is not None:
            if system.time == "discrete":
                d, spread = self.reconstruction.update(known, g_before, 1.0, old.y, sample.y)
            else:
                middle, mean = 0.5 * (known + after), 0.5 * (g_before + g)
                d, spread = self.reconstruction.update(middle, mean, sample.t - old.t, old.y, sample.y)
        self._x, self._last, self._whole, self._motion = x, sample, whole, (after, g)
        return UnknownInputEstimate(sample.t, x.copy(), certified, d.copy(), spread)

    def _mixed(self, old: UnknownInputSample, new: UnknownInputSample, s: float, x: FloatArray) -> None:
        """The matrices at a share of the interval between two samples, where the estimate is x."""
        before, after = old.schedule(x), new.schedule(x)
        names = self.design.box.names
        try:
            p = [(1.0 - s) * before[name] + s * after[name] for name in names]
        except KeyError:
            raise ParameterError(
                f"a point needs {', '.join(names)}, received {', '.join(before)}", field="schedule"
            ) from None
        if p == self._p:
            return
        self._p = None
        self._inside = mix(self._corners, self._axes, np.array(p, np.float64), self._weights, self._block)
        if not self._inside:
            parts = self.design.equations(dict(zip(names, p, strict=True)))
            self._block[:] = np.concatenate([part.ravel() for part in parts])
        self._p = p

    def _carried(self, x: FloatArray, old: UnknownInputSample, new: UnknownInputSample) -> FloatArray:
        """The estimate at the next sample, with every output measured."""
        steps, space, ends = _steps(old, new, self._fastest), self._space, self._ends
        h, outputs = (new.t - old.t) / steps, len(old.y)
        ends[0, :outputs], ends[0, outputs:] = old.y, old.known
        ends[1, :outputs], ends[1, outputs:] = new.y, new.known
        self._mixed(old, old, 0.0, x)
        space[STAGE] = x + self._parts()[2] @ old.y
        for i in range(steps):
            for part, inner in enumerate((0.0, 0.5, 0.5, 1.0)):
                s = (i + inner) / steps
                self._mixed(old, new, s, self._estimate(old, new, s))
                push(self._block, self.design.system.c, ends, s, part, h, space)
        return self._estimate(old, new, 1.0)

    def _estimate(self, old: UnknownInputSample, new: UnknownInputSample, s: float) -> FloatArray:
        """x_hat; E depends on measured variables only, so z may stand in for the estimate."""
        if self._moving or not self._inside:
            self._mixed(old, new, s, self._space[STAGE].copy())
        estimated(self._block, self._ends, s, self._space)
        return np.array(self._space[ESTIMATE])

    def _parts(self) -> list[FloatArray]:
        """Gamma, K, E and T."""
        outputs, n = self.design.system.c.shape
        parts = np.split(self._block, np.cumsum([n * n, n * outputs, n * outputs]))
        return [part.reshape(n, -1) for part in parts]

    def _onward(self, x: FloatArray, old: UnknownInputSample, new: UnknownInputSample) -> FloatArray:
        """The next estimate of a discrete system, by E and T of the step that ends there."""
        self._mixed(old, old, 0.0, x)
        gamma, k, e, t = self._parts()
        z = gamma @ x + t @ old.known
        return np.asarray(z + k @ (old.y - self.design.system.c @ x) - e @ new.y, np.float64)

    def _bridged(self, x: FloatArray, old: UnknownInputSample, new: UnknownInputSample) -> FloatArray:
        """The estimate at the next sample by the model, corrected along F by the measured outputs."""
        system, latest, point = self.design.system, self.reconstruction.latest, old.schedule(x)
        try:
            system.a(point)
        except KeyError as unknown:
            raise EventError(
                "while an output is missing the model is followed: "
                f"the schedule needs the variable {unknown} of A",
                field="schedule",
            ) from unknown

        def rate(x: FloatArray, s: float) -> FloatArray:
            before, after = old.schedule(x), new.schedule(x)
            at = {name: (1.0 - s) * before[name] + s * after[name] for name in before}
            change: FloatArray = system.a(at) @ x + (1.0 - s) * old.known + s * new.known
            return change if latest is None else change + system.f(at) @ latest

        if system.time == "discrete":
            x = rate(x, 0.0)
        else:
            steps = _steps(old, new, 2.0 * perron_root(system.a(point)))
            h = (new.t - old.t) / steps
            for i in range(steps):
                k1 = rate(x, i / steps)
                k2 = rate(x + 0.5 * h * k1, (i + 0.5) / steps)
                k3 = rate(x + 0.5 * h * k2, (i + 0.5) / steps)
                k4 = rate(x + h * k3, (i + 1.0) / steps)
                x = x + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
            point = new.schedule(x)
        seen, f = ~np.isnan(new.y), system.f(point)
        inverse = np.linalg.pinv(system.c[seen] @ f, rcond=SINGULAR)
        return np.asarray(x + f @ inverse @ (new.y - system.c @ x)[seen], np.float64)

    def _checked(self, sample: UnknownInputSample) -> UnknownInputSample:
        if not isinstance(sample, UnknownInputSample):
            raise EventError(
                "update needs an UnknownInputSample, with y=None where every output is missing, received "
                f"{sample!r:.80}"
            )
        outputs, n = self.design.system.c.shape
        y = np.full(outputs, np.nan) if sample.y is None else _copied("y", sample.y, outputs)
        if np.isinf(y).any():
            raise _unusable("y", f"{outputs} finite numbers, NaN for a missing one", sample.y)
        known = _copied("known", sample.known, n)
        if not np.isfinite(known).all():
            raise _unusable("known", f"{n} finite numbers", sample.known)
        moment(sample.t, None)
        schedule = sample.schedule
        if isinstance(schedule, Mapping) and all(is_number(one) for one in schedule.values()):
            schedule = partial(_constant, dict(schedule))
        if not callable(schedule):
            raise _unusable("schedule", "a number for each variable, or a function of x", schedule)
        if self._last is not None and not sample.t > self._last.t:
            raise EventOrderError(f"t must increase: received {sample.t!r} s after {self._last.t!r} s")
        discrete = self.design.system.time == "discrete"
        if self._last is not None and discrete and sample.t - self._last.t != 1.0:
            raise EventError(
                f"the sample at index {sample.t:g} comes after index {self._last.t:g}, a sample is one step: "
                "give a sample without measurements, y=None, for each missing index, or reset the stage",
                field="t",
                value=sample.t,
            )
        return UnknownInputSample(sample.t, y, known, schedule)


def _copied(name: str, given: Any, count: int) -> FloatArray:
    """These numbers in an array of the stage's own."""
    try:
        numbers = np.array(given, np.float64)
    except (TypeError, ValueError, OverflowError) as unusable:
        raise _unusable(name, f"{count} numbers", given) from unusable
    if numbers.shape != (count,):
        raise _unusable(name, f"{count} numbers", given)
    return numbers


def _unusable(name: str, needs: str, given: Any) -> EventError:
    return EventError(f"{name} needs {needs}, received {given!r:.80}", field=name, value=given)


def _constant(point: dict[str, float], x: FloatArray) -> dict[str, float]:
    """A schedule that is the same for every x."""
    return point


def _steps(old: UnknownInputSample, new: UnknownInputSample, fastest: float) -> int:
    """Steps of an integration that are short beside 1 / ``fastest``; raises EventError for too many."""
    dt = new.t - old.t
    if not dt * fastest <= STEPS_MOST:
        raise EventError(
            f"the sample at t = {new.t!r} comes {dt:g} s after the last one, the observer bridges at most "
            f"{STEPS_MOST / fastest:g} s, {STEPS_MOST:.0e} steps: sample more often, or reset the stage",
            field="t",
            value=new.t,
        )
    return max(1, ceil(min(dt * fastest / SUBSTEP, STEPS_MOST)))
