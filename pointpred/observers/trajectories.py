"""Trajectories of systems and observers by independent integrators, with seeded noise."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, floor
from typing import Any

import numpy as np

from pointpred.errors import DivergenceError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.matrices import listed, matrix, one_of, positive

Field = Callable[[float, FloatArray], Any]
INTEGRATORS = ("rk4", "scipy", "stiff", "discrete")
METHODS = {"scipy": "DOP853", "stiff": "LSODA"}
CHUNK = 1024
OUTSIDE_MOST = 100
"""Most values of the field in succession that are not finite: a trial step may go too far."""
STANDING_MOST = 300_000
"""Most values of the field, of an adaptive integrator, at times that it has reached before."""
CALLS_MOST = 1_000_000
"""Most values of the field, of an adaptive integrator; beside them 1000 for each time."""


class SeededSignal:
    """A random signal as a function of time: constant over each period, and repeatable.

    Assumes that values of different periods are independent: the spectrum is white up to 1 / (2 period_s).

    Parameters: ``seed``; ``size`` of the vector; ``amplitude``, the largest value (``kind`` ``"uniform"``) or
    the standard deviation (``"normal"``), >= 0; ``period_s`` > 0.
    Memory: the last ``CHUNK`` values.

    >>> noise = SeededSignal(7, 2, 0.1)
    >>> bool(np.array_equal(noise(3.0), noise(3.0004))), bool(abs(noise(3.0)).max() <= 0.1)
    (True, True)
    """

    def __init__(
        self, seed: int, size: int, amplitude: float, *, kind: str = "uniform", period_s: float = 1e-2
    ) -> None:
        one_of("kind", kind, ("uniform", "normal"))
        positive("amplitude", amplitude, zero=True)
        positive("period_s", period_s)
        for name, number in (("seed", seed), ("size", size)):
            if not isinstance(number, int | np.integer) or isinstance(number, bool) or number < 0:
                raise ParameterError(
                    f"{name} must be a whole number not below 0, received {number!r}",
                    field=name,
                    value=number,
                )
        self.seed, self.size, self.amplitude, self.kind, self.period_s = seed, size, amplitude, kind, period_s
        self._chunk, self._values = -1, np.zeros((CHUNK, size))

    def __call__(self, t: float) -> FloatArray:
        """The value at t >= 0."""
        # A time within rounding of a multiple of the period belongs to the period that starts there.
        index = max(0, floor(t / self.period_s + 1e-10))
        if index // CHUNK != self._chunk:
            self._chunk = index // CHUNK
            generator = np.random.default_rng([self.seed, self._chunk])
            draw = generator.standard_normal if self.kind == "normal" else _symmetric(generator)
            self._values = self.amplitude * draw((CHUNK, self.size))
        value: FloatArray = self._values[index % CHUNK]
        return value


def _symmetric(generator: np.random.Generator) -> Callable[[tuple[int, int]], FloatArray]:
    return lambda shape: generator.uniform(-1.0, 1.0, shape)


def trajectory(
    field: Field,
    start: Any,
    times: Any,
    *,
    integrator: str = "rk4",
    step_s: float = 1e-3,
    tolerance: float = 1e-10,
) -> FloatArray:
    """The state at each of the times, one row a time, from ``start`` at the first of them.

    ``rk4`` takes equal steps of at most ``step_s`` between two times; ``scipy`` is DOP853 with relative and
    absolute ``tolerance`` and steps of at most a hundred ``step_s``, ``stiff`` the same with LSODA, for rates
    of different sizes; ``discrete`` takes indices as times and applies ``field(k, x)``, the next state, at
    each.

    Disturbances belong in the field. A ``SeededSignal`` jumps between its periods: a method keeps its order
    only if its steps end at the jumps.

    Raises ParameterError for times that do not increase, DivergenceError naming the time at which a state
    stops being finite, or after which an adaptive integrator needs too many steps.

    >>> trajectory(lambda t, x: -x, [1.0], [0.0, 1.0]).round(6).tolist()
    [[1.0], [0.367879]]
    >>> trajectory(lambda k, x: 0.5 * x, [1.0], range(3), integrator="discrete").ravel().tolist()
    [1.0, 0.5, 0.25]
    """
    one_of("integrator", integrator, INTEGRATORS)
    positive("step_s", step_s)
    if not callable(field):
        raise ParameterError(
            f"field must be a function of t and x, received {field!r}", field="field", value=field
        )
    t = matrix("times", listed("times", times), 1)[0]
    if (np.diff(t) <= 0.0).any():
        raise ParameterError("times must increase", field="times")
    if not len(t):
        raise ParameterError("times needs at least one time, received none", field="times")
    x0 = matrix("start", start, 1)[0]
    if integrator in METHODS:
        return _adaptive(METHODS[integrator], field, x0, t, 100.0 * step_s, tolerance)
    states = np.empty((len(t), len(x0)))
    states[0] = x0
    with np.errstate(over="ignore", invalid="ignore"):
        for i in range(1, len(t)):
            if integrator == "discrete":
                states[i] = field(t[i - 1], states[i - 1])
            else:
                states[i] = _rk4(field, t[i - 1], t[i], states[i - 1], step_s)
            if not np.isfinite(states[i]).all():
                raise DivergenceError(f"the trajectory leaves every bound before t = {t[i]:g}")
    return states


def _rk4(field: Field, begin: float, end: float, x: FloatArray, step_s: float) -> FloatArray:
    count = max(1, ceil((end - begin) / step_s - 1e-9))
    h = (end - begin) / count
    for i in range(count):
        t = begin + i * h
        k1 = np.asarray(field(t, x), np.float64)
        k2 = np.asarray(field(t + 0.5 * h, x + 0.5 * h * k1), np.float64)
        k3 = np.asarray(field(t + 0.5 * h, x + 0.5 * h * k2), np.float64)
        # The end of a step belongs to the period that ends there, so that no jump is applied early.
        k4 = np.asarray(field(t + h * (1.0 - 1e-8), x + h * k3), np.float64)
        x = x + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
    return x


def _adaptive(
    method: Any, field: Field, x0: FloatArray, t: FloatArray, longest: float, tolerance: float
) -> FloatArray:
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
            raise DivergenceError(
                f"the trajectory stands still near t = {now:g}: its numbers are too large, or it grows or "
                "turns too fast"
            )
        if calls > budget:
            raise DivergenceError(
                f"the trajectory needs more than {budget} values of the field and has reached t = {now:g}: "
                "it grows or turns too fast, take fewer or closer times, or a smaller start"
            )
        return change

    with np.errstate(over="ignore", invalid="ignore"):
        solution = solve_ivp(
            counted, (t[0], t[-1]), x0, method, t, rtol=tolerance, atol=tolerance, max_step=longest
        )
    if solution.status != 0:
        reached = solution.t[-1] if len(solution.t) else t[0]
        raise DivergenceError(f"the trajectory leaves every bound after t = {reached:g}: {solution.message}")
    if not (known := np.isfinite(solution.y).all(axis=0)).all():
        raise DivergenceError(f"the trajectory leaves every bound before t = {t[int(known.argmin())]:g}")
    states: FloatArray = np.ascontiguousarray(solution.y.T)
    return states
