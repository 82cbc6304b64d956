"""An unknown input observer at run time, for any system: samples in, estimates out, in plain numpy."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, isfinite
from typing import Protocol, Self

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.observers.unknown_input.boxes import Box
from pointpred.observers.unknown_input.system import ParameterVaryingSystem, Point

Schedule = Callable[[FloatArray], Point]
"""The scheduling variables at a time as a function of the estimate; it holds the measured ones itself."""
SUBSTEP_S = 0.02


class UnknownInputSample(msgspec.Struct, frozen=True):
    """The outputs y and the known part b(y, u) at ``t`` s, and the scheduling variables there."""

    t: float
    y: FloatArray
    known: FloatArray
    schedule: Schedule


class UnknownInputEstimate(msgspec.Struct, frozen=True):
    """The estimate of the state; ``certified`` while the scheduling variables lie in the design's box."""

    t: float
    x: FloatArray
    certified: bool


class Design(Protocol):
    """The design that is run, an ``UnknownInputObserver``."""

    system: ParameterVaryingSystem
    box: Box

    @property
    def reducible(self) -> bool:
        """Whether the reduced form can run."""

    def begin(self, estimate: FloatArray, point: Point) -> FloatArray:
        """The z of an estimate."""

    def estimate(self, z: FloatArray, y: FloatArray, point: Point) -> FloatArray:
        """The estimate of a z."""

    def rate(self, z: FloatArray, y: FloatArray, point: Point, known: FloatArray) -> FloatArray:
        """The rate of z in the full form."""

    def reduce(self, z: FloatArray) -> FloatArray:
        """The coordinates of the reduced form."""

    def expand(self, reduced: FloatArray) -> FloatArray:
        """The z of the reduced form's coordinates."""

    def reduced_rate(self, reduced: FloatArray, y: FloatArray, point: Point, known: FloatArray) -> FloatArray:
        """The rate of the reduced form."""


class RunningUnknownInputObserver:
    """A ``Stage[UnknownInputSample, UnknownInputEstimate]`` around a design.

    Assumes measurements linear between two samples; the error of that is of second order in the interval. F
    may depend on measured variables only. With as many outputs as unknown inputs it runs in the reduced form,
    without gains; otherwise in the full form, outside the box with the gains of its nearest point and
    ``certified`` false. Slow (numpy, some 100 us a step): for the camera there is a compiled law.

    Parameters: ``design``; ``start`` the estimate at the first sample, whose outputs the first sample
    replaces. Memory: the state and one sample. Raises ParameterError; EventError and EventOrderError from
    ``update``, which leaves it unchanged.

    >>> from pointpred.observers.unknown_input.boxes import Box
    >>> from pointpred.observers.unknown_input.observer import UnknownInputObserver
    >>> from pointpred.observers.unknown_input.system import ParameterVaryingSystem
    >>> system = ParameterVaryingSystem(
    ...     lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), lambda p: np.array([[1.0], [0.0]]), np.eye(1, 2)
    ... )
    >>> design = UnknownInputObserver.design(system, Box({"k": (-3.0, -1.0)}), sigma=1.0)
    >>> running = RunningUnknownInputObserver(design, np.array([0.0, 1.0]))
    >>> for i in range(101):
    ...     sample = UnknownInputSample(i / 100, np.array([7.0]), np.zeros(2), lambda x: {"k": -2.0})
    ...     estimate = running.update(sample)
    >>> round(float(estimate.x[1] / np.exp(-2.0)), 6), estimate.certified
    (1.0, True)
    """

    def __init__(self, design: Design, start: FloatArray) -> None:
        self.design = design
        self.start = np.asarray(start, np.float64)
        states = design.system.c.shape[1]
        if self.start.shape != (states,) or not np.isfinite(self.start).all():
            raise ParameterError(
                f"start needs {states} finite numbers, received {start!r:.80}", field="start"
            )
        self.reset()

    def reset(self) -> None:
        """Forget every sample."""
        self._z: FloatArray | None = None
        self._last: UnknownInputSample | None = None

    def fresh(self) -> Self:
        """The same design and start, without memory."""
        return type(self)(self.design, self.start)

    def update(self, sample: UnknownInputSample, /) -> UnknownInputEstimate:
        """Consume one sample; a refused one changes nothing."""
        self._check(sample)
        observer = self.design
        if self._z is None or self._last is None:
            inverse = np.linalg.pinv(observer.system.c)
            x = self.start + inverse @ (sample.y - observer.system.c @ self.start)
            z = observer.begin(x, sample.schedule(x))
        else:
            z = self._carried(self._z, self._last, sample)
        x = self._estimate(z, sample.y, sample.schedule)
        point = sample.schedule(x)
        self._z, self._last = z, sample
        return UnknownInputEstimate(sample.t, x, not observer.box.outside(point))

    def _carried(self, z: FloatArray, old: UnknownInputSample, new: UnknownInputSample) -> FloatArray:
        """The classical Runge-Kutta method in steps of at most 20 ms."""
        dt = new.t - old.t
        steps = ceil(dt / SUBSTEP_S)
        h = dt / steps

        def rate(z: FloatArray, s: float) -> FloatArray:
            def schedule(x: FloatArray) -> Point:
                before, after = old.schedule(x), new.schedule(x)
                return {name: (1.0 - s) * before[name] + s * after[name] for name in before}

            y, known = (1.0 - s) * old.y + s * new.y, (1.0 - s) * old.known + s * new.known
            return self._rate(z, y, schedule(self._estimate(z, y, schedule)), known)

        for i in range(steps):
            s, half, end = i / steps, (i + 0.5) / steps, (i + 1.0) / steps
            k1 = rate(z, s)
            k2 = rate(z + 0.5 * h * k1, half)
            k3 = rate(z + 0.5 * h * k2, half)
            k4 = rate(z + h * k3, end)
            z = z + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        return z

    def _rate(self, z: FloatArray, y: FloatArray, point: Point, known: FloatArray) -> FloatArray:
        if self.design.reducible:
            return self.design.expand(self.design.reduced_rate(self.design.reduce(z), y, point, known))
        return self.design.rate(z, y, point, known)

    def _estimate(self, z: FloatArray, y: FloatArray, schedule: Schedule) -> FloatArray:
        """x_hat = z - E y; E depends on measured variables only, so z may stand in for the estimate."""
        return self.design.estimate(z, y, schedule(z))

    def _check(self, sample: UnknownInputSample) -> None:
        outputs, states = self.design.system.c.shape
        for name, value, size in (("y", sample.y, outputs), ("known", sample.known, states)):
            if np.shape(value) != (size,) or not np.isfinite(value).all():
                raise EventError(f"{name} needs {size} finite numbers, received {value!r:.80}", field=name)
        if not isfinite(sample.t):
            raise EventError(f"t must be finite, received {sample.t!r}")
        if self._last is not None and not sample.t > self._last.t:
            raise EventOrderError(f"t must increase: received {sample.t!r} s after {self._last.t!r} s")
