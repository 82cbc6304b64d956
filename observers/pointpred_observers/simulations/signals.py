"""What drives a simulation: samples, starts, signals and scheduling variables."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import isfinite
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError, PointpredError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import matrix, vector, wrong
from pointpred_observers.plants.boxes import Box, Point
from pointpred_observers.plants.varying import ParameterVaryingSystem
from pointpred_observers.simulations.trajectories import Field, trajectory

Signal = Callable[[float], FloatArray]
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
        return self.disturbance is None and not np.any(self.noise)


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
    needed = (
        f"a dict of {', '.join(names)}, each a number or a function of t, or a function of t and x"
    )
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
