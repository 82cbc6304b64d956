"""What drives a simulation: samples, starts, signals, scheduling variables; and the state over time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import accumulate
from math import floor, isfinite
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import DivergenceError, ParameterError, PointpredError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import TIMES, listed, matrix, one_of, positive, vector, wrong
from pointpred_observers.plants.boxes import Box, Point
from pointpred_observers.plants.varying import ParameterVaryingSystem

Signal = Callable[[float], FloatArray]
Field = Callable[[float, FloatArray], Any]
CHUNK = 1024
OUTSIDE_MOST = 100
"""Most values of the field in succession that are not finite: a trial step may go too far."""
STANDING_MOST = 300_000
"""Most values of the field at times that the integrator has reached before."""
CALLS_MOST = 1_000_000
"""Most values of the field; beside them 1000 for each time."""
SAMPLES, STEP_S = 1001, 1e-2
"""The samples of a simulation that names none: as many, and in continuous time as far apart in s."""
TOLERANCE = 1e-9


class Setting(msgspec.Struct, frozen=True):
    """What a simulation was asked for; ``None`` where nothing was."""

    times: Any
    start: Any
    estimate: Any
    input: Any
    disturbance: Any
    unknown_input: Any
    schedule: Any
    noise: Any
    seed: int

    def samples(self, discrete: bool) -> FloatArray:
        """The times of the samples, or the indices; raises ParameterError unless they increase."""
        if self.times is None:
            return np.asarray(np.arange(SAMPLES) * (1.0 if discrete else STEP_S), np.float64)
        times: FloatArray = matrix("times", self.times, 1)[0]
        if len(times) < 2 or (np.diff(times) <= 0.0).any():
            raise wrong("times", "needs two samples or more that increase", times)
        if discrete and (np.diff(times) != 1.0).any():
            raise ParameterError("the samples of a discrete plant are its steps: times must go up by 1")
        return times

    def begin(self, size: int, what: str = "start", default: float = 1.0) -> FloatArray:
        """A state to start with: ``start`` or ``estimate``."""
        value = self.start if what == "start" else self.estimate
        return np.full(size, default) if value is None else vector(what, value, size).copy()

    def signal(self, name: str, size: int) -> Signal:
        """A signal as a function of time, zero if it was not given."""
        given = getattr(self, name)
        if given is None:
            zero = np.zeros(size)
            return lambda t: zero
        if not callable(given):
            constant = vector(name, given, size)
            return lambda t: constant

        def value(t: float) -> FloatArray:
            now = vector(name, _called(name, "a function of t", lambda: given(t), t), size)
            if not np.isfinite(now).all():
                raise ParameterError(f"{name} must be finite, it is {now.tolist()} at t = {t:g}", field=name)
            return now

        value(0.0)
        return value

    def refuse(self, kind: str, *names: str) -> None:
        """Raise ParameterError for what a plant of this kind has no place for."""
        for name in names:
            if getattr(self, name) is not None:
                raise ParameterError(f"{kind} has no {name}: leave it out", field=name)

    def measured(self, exact: FloatArray) -> FloatArray:
        """Outputs (N, p) with the noise."""
        sizes = matrix("noise", self.noise, 1)[0]
        if (sizes < 0.0).any() or len(sizes) not in (1, exact.shape[1]):
            must = f"needs a standard deviation not below 0, or {exact.shape[1]} of them"
            raise wrong("noise", must, self.noise)
        drawn = np.random.default_rng(self.seed).standard_normal(exact.shape)
        return np.asarray(exact + sizes * drawn)

    @property
    def silent(self) -> bool:
        """Whether neither noise nor disturbance was asked for."""
        return self.disturbance is None and not matrix("noise", self.noise, 1).any()


def run(field: Field, start: FloatArray, times: FloatArray, discrete: bool) -> FloatArray:
    """The states at the samples; no change of an input that lasts a sample is stepped over."""
    time = "discrete" if discrete else "continuous"
    return trajectory(field, start, times, time=time, tolerance=TOLERANCE)


def sampled(signal: Signal, times: FloatArray) -> FloatArray:
    """A signal at the samples, (N, size)."""
    return np.array([signal(float(t)) for t in times])


def schedule_of(given: Any, box: Box) -> Callable[[float, FloatArray], Point]:
    """The scheduling variables as a function of t and x; the middle of the box where nothing is given."""
    names = box.names
    if given is None:
        given = {name: 0.5 * (low + high) for name, (low, high) in box.bounds.items()}
    needed = f"a dict of {', '.join(names)}, each a number or a function of t, or a function of t and x"
    if not (callable(given) or isinstance(given, Mapping)):
        raise wrong("schedule", f"must be {needed}", given)

    def asked(t: float, x: FloatArray) -> Any:
        if callable(given):
            return given(t, x)
        return {name: one(t) if callable(one) else one for name, one in given.items()}

    return lambda t, x: _point(_called("schedule", needed, lambda: asked(t, x), t), names, t)


def _called(name: str, needed: str, call: Callable[[], Any], t: float) -> Any:
    """What a function of a caller gives; raises ParameterError where it fails."""
    try:
        return call()
    except PointpredError:
        raise
    except (TypeError, ValueError, ArithmeticError, LookupError, AttributeError) as failure:
        words = f"{name} must be {needed}, it fails at t = {t:g}: {type(failure).__name__}: {failure}"
        raise ParameterError(words, field=name) from failure


def _point(given: Any, names: tuple[str, ...], t: float) -> Point:
    """Scheduling variables as finite numbers; raises ParameterError for others, and for a missing one."""
    if not isinstance(given, Mapping):
        words = f"schedule must return a dict of {', '.join(names)}, received {given!r:.60} at t = {t:g}"
        raise ParameterError(words, field="schedule", value=given)
    if missing := [name for name in names if name not in given]:
        words = f"schedule lacks {', '.join(missing)}, received {', '.join(map(str, given))}"
        raise ParameterError(words, field="schedule")
    point = {}
    for name, one in given.items():
        value = one.item() if isinstance(one, np.ndarray) and one.size == 1 else one
        if not (is_number(value) and isfinite(value)):
            words = f"schedule needs a finite number for {name}, received {value!r:.60} at t = {t:g}"
            raise ParameterError(words, field="schedule", value=value)
        point[name] = float(value)
    return point


def matrices_at(system: ParameterVaryingSystem, point: Point) -> tuple[FloatArray, FloatArray]:
    """A and F at a point; raises ParameterError for a variable of the plant that the schedule lacks."""
    try:
        return system.a(point), system.f(point)
    except KeyError as missing:
        words = f"schedule lacks the variable {missing} of the plant, received {', '.join(point)}"
        raise ParameterError(words, field="schedule") from missing


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

    def change(now: float, x: FloatArray) -> FloatArray:
        value = field(now, x)
        return vector("field", value.ravel() if isinstance(value, np.ndarray) else value, len(x0))

    with np.errstate(over="ignore", invalid="ignore"):
        if time == "discrete":
            each = accumulate(t[:-1], lambda x, k: change(k, x), initial=x0)
            states = np.array(list(each))
        elif len(t) == 1:
            states = np.array([x0])
        else:
            longest = float(np.diff(t).min()) if step_s is None else positive("step_s", step_s)
            states = _integrated(change, x0, t, longest, tolerance)
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
        change: FloatArray = field(now, x)
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
