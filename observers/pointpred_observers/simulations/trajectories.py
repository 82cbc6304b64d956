"""The state of a system over time, by the integrators of scipy or step by step; a seeded disturbance."""

from __future__ import annotations

from collections.abc import Callable
from itertools import accumulate
from math import floor
from typing import Any

import numpy as np

from pointpred.errors import DivergenceError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import TIMES, listed, matrix, one_of, positive, wrong

Field = Callable[[float, FloatArray], Any]
CHUNK = 1024
OUTSIDE_MOST = 100
"""Most values of the field in succession that are not finite: a trial step may go too far."""
STANDING_MOST = 300_000
"""Most values of the field at times that the integrator has reached before."""
CALLS_MOST = 1_000_000
"""Most values of the field; beside them 1000 for each time."""


class SeededSignal:
    """A random signal as a function of time: uniform within +-``amplitude``, constant over each period."""

    def __init__(self, seed: int, size: int, amplitude: float, *, period_s: float = 1e-2) -> None:
        self.seed, self.size, self.amplitude, self.period_s = seed, size, amplitude, period_s
        self._chunk, self._values = -1, np.zeros((CHUNK, size))

    def __call__(self, t: float) -> FloatArray:
        """The value at t >= 0."""
        # A time within rounding of a multiple of the period belongs to the period that starts there.
        index = max(0, floor(t / self.period_s + 1e-10))
        if index // CHUNK != self._chunk:
            self._chunk = index // CHUNK
            generator = np.random.default_rng([self.seed, self._chunk])
            self._values = self.amplitude * generator.uniform(-1.0, 1.0, (CHUNK, self.size))
        value: FloatArray = self._values[index % CHUNK]
        return value


def trajectory(
    field: Field,
    start: Any,
    times: Any,
    *,
    time: str = "continuous",
    step_s: float | None = None,
    tolerance: float = 1e-10,
) -> FloatArray:
    """The state at each of the times, one row a time, from ``start`` at the first of them.

    x' = ``field(t, x)`` is integrated by scipy's LSODA, for slow and for stiff systems, with relative and
    absolute ``tolerance`` and steps of at most ``step_s``, by default the least distance of two times: no
    change of an input that lasts so long is stepped over. In discrete time the times are indices, and
    ``field(k, x)`` is the next state.

    Raises ParameterError for times that do not increase, DivergenceError naming the time at which a state
    stops being finite, or after which the integrator needs too many steps.

    >>> trajectory(lambda t, x: -x, [1.0], [0.0, 1.0]).round(6).tolist()
    [[1.0], [0.367879]]
    >>> trajectory(lambda k, x: 0.5 * x, [1.0], range(3), time="discrete").ravel().tolist()
    [1.0, 0.5, 0.25]
    """
    one_of("time", time, TIMES)
    positive("tolerance", tolerance)
    if not callable(field):
        raise wrong("field", "must be a function of t and x", field)
    t = matrix("times", listed("times", times), 1)[0]
    if not len(t):
        raise ParameterError("times needs at least one time, received none", field="times")
    if (np.diff(t) <= 0.0).any():
        raise ParameterError("times must increase", field="times")
    x0 = matrix("start", start, 1)[0]
    with np.errstate(over="ignore", invalid="ignore"):
        if time == "discrete":
            each = accumulate(t[:-1], lambda x, k: np.asarray(field(k, x), np.float64), initial=x0)
            states = np.array(list(each))
        elif len(t) == 1:
            states = np.array([x0])
        else:
            longest = float(np.diff(t).min()) if step_s is None else positive("step_s", step_s)
            states = _integrated(field, x0, t, longest, tolerance)
    known = np.isfinite(states).all(axis=1)
    if not known.all():
        raise DivergenceError(f"the trajectory leaves every bound before t = {t[int(known.argmin())]:g}")
    return states


def _integrated(field: Field, x0: FloatArray, t: FloatArray, longest: float, tolerance: float) -> FloatArray:
    from scipy.integrate import solve_ivp

    budget = CALLS_MOST + 1000 * len(t)
    calls = outside = advanced = 0
    furthest = -np.inf

    def counted(now: float, x: FloatArray) -> FloatArray:
        nonlocal calls, outside, advanced, furthest
        change = np.asarray(field(now, x), np.float64)
        calls, outside = calls + 1, 0 if np.isfinite(change).all() else outside + 1
        if outside > OUTSIDE_MOST:
            raise DivergenceError(f"the trajectory leaves every bound near t = {now:g}")
        if now > furthest:
            furthest, advanced = now, calls
        if calls - advanced > STANDING_MOST:
            raise DivergenceError(f"the trajectory stands still near t = {now:g}: it grows or turns too fast")
        if calls > budget:
            reached = f"needs more than {budget} values of the field and has reached t = {now:g}"
            raise DivergenceError(f"the trajectory {reached}: it grows or turns too fast")
        return change

    ends = (t[0], t[-1])
    solution = solve_ivp(counted, ends, x0, "LSODA", t, rtol=tolerance, atol=tolerance, max_step=longest)
    if solution.status != 0:
        reached = solution.t[-1] if len(solution.t) else t[0]
        raise DivergenceError(f"the trajectory leaves every bound after t = {reached:g}: {solution.message}")
    return np.ascontiguousarray(solution.y.T)
