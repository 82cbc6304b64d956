"""An unknown input observer at run time, for any system: samples in, estimates out, in plain numpy."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, isfinite
from typing import Protocol, Self

import msgspec
import numpy as np

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.eigenvalues import perron_root
from pointpred_observers.unknown_input.boxes import Box
from pointpred_observers.unknown_input.reconstruction import SINGULAR, InputReconstruction
from pointpred_observers.unknown_input.system import ParameterVaryingSystem, Point

Schedule = Callable[[FloatArray], Point]
"""The scheduling variables at a time as a function of the estimate; it holds the measured ones itself."""
SUBSTEP = 0.2
"""Longest step of an integration, a share of the shortest time constant."""
STEPS_MOST = 100_000
"""Most steps between two samples: within as many time constants the steps grow with the interval."""


class UnknownInputSample(msgspec.Struct, frozen=True):
    """The outputs y and the known part b(y, u) at ``t`` s (or the index), and the scheduling variables there.

    An output that is NaN is missing, ``None`` for all of them.
    """

    t: float
    y: FloatArray | None
    known: FloatArray
    schedule: Schedule


class _Measured(msgspec.Struct, frozen=True):
    """A sample as arrays, NaN for each missing output."""

    t: float
    y: FloatArray
    known: FloatArray
    schedule: Schedule
    whole: bool
    """Whether no output is missing."""


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


class Design(Protocol):
    """The design that is run, an ``UnknownInputObserver``."""

    system: ParameterVaryingSystem
    box: Box

    @property
    def fastest(self) -> float:
        """A bound of the rates of z, 1/s."""

    def onward(self, estimate: FloatArray, y: FloatArray, point: Point, known: FloatArray) -> FloatArray:
        """The next z in discrete time."""

    def begin(self, estimate: FloatArray, point: Point) -> FloatArray:
        """The z of an estimate."""

    def estimate(self, z: FloatArray, y: FloatArray, point: Point) -> FloatArray:
        """The estimate of a z."""

    def matrices(self, point: Point) -> tuple[FloatArray, FloatArray, FloatArray]:
        """N, Y and T of z' = N z + Y y + T b at a point, in the form that runs."""


class _Constant(msgspec.Struct, frozen=True):
    """The matrices of an observer at a point at which the scheduling variables rest, and E, C A and C F.

    ``onto`` is C A, ``None`` where the point lacks a variable of A.
    """

    point: Point
    n: FloatArray
    y: FloatArray
    t: FloatArray
    e: FloatArray
    onto: FloatArray | None
    g: FloatArray
    certified: bool

    @classmethod
    def at(cls, design: Design, point: Point) -> Self:
        """The matrices of a design at a point."""
        system = design.system
        try:
            onto = system.c @ system.a(point)
        except KeyError:  # of a system that gives T A, A may need more variables
            onto = None
        e, g = system.e(point), system.c @ system.f(point)
        return cls(point, *design.matrices(point), e, onto, g, not design.box.outside(point))


class RunningUnknownInputObserver:
    """A ``Stage[UnknownInputSample, UnknownInputEstimate]`` around a design.

    Assumes that y, b and the scheduling variables are linear between two samples; in discrete time each
    sample is a step, its index the last one plus 1. With as many outputs as unknown inputs it runs in the
    reduced form, without gains; otherwise in the full form, outside the box with the gains of its nearest
    point and ``certified`` false. In numpy: some 40 us a step while the scheduling variables are the same at
    both samples, whose matrices are kept, and 0.4 ms while they change; for the camera there is a compiled
    law.

    While an output is missing at one end of an interval the model is followed, x' = A x + b + F d with the
    last estimate of d (zero before the first). At its end the outputs that are measured correct the
    estimate along F: x + F (C_s F)^+ (y_s - C_s x), which is the observer's own equation if none is
    missing. Other errors are not corrected in such an interval, and nothing is proved. A sensor that is
    gone for good needs a design of its own.

    Parameters: ``design``; ``start`` the estimate at the first sample, whose outputs the first sample
    replaces; ``reconstruction`` of the unknown input. Memory: the estimate, one sample, and a covariance.
    Raises ParameterError; EventError and EventOrderError from ``update``, which leaves it unchanged.

    >>> from pointpred_observers.unknown_input.boxes import Box
    >>> from pointpred_observers.unknown_input.observer import UnknownInputObserver
    >>> from pointpred_observers.unknown_input.system import ParameterVaryingSystem
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
    >>> bool(abs(estimate.d[0] + estimate.x[1]) < 0.01)  # y' = x2 + d = 0
    True
    """

    def __init__(
        self, design: Design, start: FloatArray, reconstruction: InputReconstruction | None = None
    ) -> None:
        self.design = design
        self.start = np.asarray(start, np.float64)
        outputs, states = design.system.c.shape
        if self.start.shape != (states,) or not np.isfinite(self.start).all():
            raise ParameterError(
                f"start needs {states} finite numbers, received {start!r:.80}", field="start"
            )
        if reconstruction is None:
            reconstruction = InputReconstruction(outputs, design.system.time)
        self.reconstruction = reconstruction.fresh()
        self._fastest = design.fastest
        self.reset()

    def reset(self) -> None:
        """Forget every sample."""
        self._last: _Measured | None = None
        self._x = self.start
        self._point: Point = {}
        self._constant: _Constant | None = None
        self._latest: list[tuple[Point, tuple[FloatArray, FloatArray, FloatArray]]] = []
        self.reconstruction.reset()

    def fresh(self) -> Self:
        """The same design and start, without memory."""
        return type(self)(self.design, self.start, self.reconstruction)

    def update(self, given: UnknownInputSample, /) -> UnknownInputEstimate:
        """Consume one sample; a refused one changes nothing."""
        sample = self._checked(given)
        old, system, y = self._last, self.design.system, sample.y
        bridged = not sample.whole
        if old is None:
            seen = ~np.isnan(y)
            x = self.start + np.linalg.pinv(system.c[seen]) @ (y - system.c @ self.start)[seen]
        elif bridged or not old.whole:
            x, bridged = self._bridged(self._x, old, sample), True
        elif (resting := self._resting(old, sample)) is not None:
            return resting
        else:
            x = self._carried(self._x, old, sample)
        point = sample.schedule(x)
        certified = not (bridged or self.design.box.outside(point))
        if old is None:
            none = np.full(system.f(point).shape[1], np.nan)
            d, spread = none, none
        else:
            d, spread = self._reconstructed(x, point, old, sample)
        self._x, self._last, self._point = x, sample, point
        return UnknownInputEstimate(sample.t, x, certified, d, spread)

    def _resting(self, old: _Measured, new: _Measured) -> UnknownInputEstimate | None:
        """The step of a continuous system whose scheduling variables are the same at both samples, else None.

        They are linear between the samples, so that they rest: the matrices are those of the last such step.
        """
        point = self._point
        if self.design.system.time == "discrete" or new.schedule(self._x) != point:
            return None
        at = self._constant
        if at is None or at.point != point:
            at = self._constant = _Constant.at(self.design, dict(point))
        first, last = at.y @ old.y + at.t @ old.known, at.y @ new.y + at.t @ new.known
        change = last - first

        def rate(z: FloatArray, s: float) -> FloatArray:
            moved: FloatArray = at.n @ z
            moved += first
            moved += s * change
            return moved

        x = _integrated(rate, self._x + at.e @ old.y, old.t, new.t, self._fastest) - at.e @ new.y
        if new.schedule(x) != point:
            return None  # they follow the estimate
        if at.onto is None:
            d = spread = np.full(at.g.shape[1], np.nan)
        else:
            known = 0.5 * (at.onto @ (self._x + x) + self.design.system.c @ (old.known + new.known))
            d, spread = self.reconstruction.update(known, at.g, new.t - old.t, old.y, new.y)
        self._x, self._last = x, new
        return UnknownInputEstimate(new.t, x, at.certified, d, spread)

    def _carried(self, x: FloatArray, old: _Measured, new: _Measured) -> FloatArray:
        """The estimate at the next sample, with every output measured."""
        point, system = old.schedule(x), self.design.system
        if system.time == "discrete":
            z = self.design.onward(x, old.y, point, old.known)
            return self.design.estimate(z, new.y, point)

        def rate(z: FloatArray, s: float) -> FloatArray:
            y, known = _between(old.y, new.y, s), _between(old.known, new.known, s)
            here = self._estimate(z, y, _schedule(old, new, s))
            n, seen, t = self._matrices(_schedule(old, new, s)(here))
            return np.asarray(n @ z + seen @ y + t @ known, np.float64)

        z = _integrated(rate, x + system.e(point) @ old.y, old.t, new.t, self._fastest)
        return self._estimate(z, new.y, new.schedule)

    def _matrices(self, point: Point) -> tuple[FloatArray, FloatArray, FloatArray]:
        """The design's at a point; a step of the integration asks twice for its middle and for its ends."""
        for known, found in self._latest:
            if known == point:
                return found
        found = self.design.matrices(point)
        self._latest = [(point, found), *self._latest[:1]]
        return found

    def _bridged(self, x: FloatArray, old: _Measured, new: _Measured) -> FloatArray:
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

        def moved(x: FloatArray, point: Point, known: FloatArray) -> FloatArray:
            change = system.a(point) @ x + known
            return change if latest is None else change + system.f(point) @ latest

        def rate(x: FloatArray, s: float) -> FloatArray:
            return moved(x, _schedule(old, new, s)(x), _between(old.known, new.known, s))

        if system.time == "discrete":
            x = moved(x, point, old.known)
        else:
            x = _integrated(rate, x, old.t, new.t, perron_root(system.a(point)), 0.5 * SUBSTEP)
            point = new.schedule(x)
        seen, f = ~np.isnan(new.y), system.f(point)
        inverse = np.linalg.pinv(system.c[seen] @ f, rcond=SINGULAR)
        return np.asarray(x + f @ inverse @ (new.y - system.c @ x)[seen], np.float64)

    def _reconstructed(
        self, x: FloatArray, point: Point, old: _Measured, new: _Measured
    ) -> tuple[FloatArray, FloatArray]:
        """The unknown input of the interval, from the known part of the outputs' motion at its ends."""
        system = self.design.system
        first = old.schedule(self._x)
        g = system.c @ system.f(first)
        try:
            known = system.c @ (system.a(first) @ self._x + old.known)
            if system.time == "continuous":
                known = 0.5 * (known + system.c @ (system.a(point) @ x + new.known))
                g = 0.5 * (g + system.c @ system.f(point))
        except KeyError:  # of a system that gives T A, A may need more variables
            none = np.full(g.shape[1], np.nan)
            return none, none
        return self.reconstruction.update(known, g, new.t - old.t, old.y, new.y)

    def _estimate(self, z: FloatArray, y: FloatArray, schedule: Schedule) -> FloatArray:
        """x_hat = z - E y; E depends on measured variables only, so z may stand in for the estimate."""
        return self.design.estimate(z, y, schedule(z))

    def _checked(self, sample: UnknownInputSample) -> _Measured:
        if not isinstance(sample, UnknownInputSample):
            raise EventError(
                "update needs an UnknownInputSample, with y=None where every output is missing, received "
                f"{sample!r:.80}"
            )
        outputs, states = self.design.system.c.shape
        y = np.full(outputs, np.nan) if sample.y is None else sample.y
        whole = np.shape(y) == (outputs,) and bool(np.isfinite(y).all())
        if not whole and (np.shape(y) != (outputs,) or np.isinf(y).any()):
            raise EventError(
                f"y needs {outputs} finite numbers, NaN for a missing one, received {sample.y!r:.80}",
                field="y",
            )
        if np.shape(sample.known) != (states,) or not np.isfinite(sample.known).all():
            raise EventError(
                f"known needs {states} finite numbers, received {sample.known!r:.80}", field="known"
            )
        if not isfinite(sample.t):
            raise EventError(f"t must be finite, received {sample.t!r}")
        if self._last is not None and not sample.t > self._last.t:
            raise EventOrderError(f"t must increase: received {sample.t!r} s after {self._last.t!r} s")
        discrete = self.design.system.time == "discrete"
        if self._last is not None and discrete and sample.t - self._last.t != 1.0:
            raise EventError(
                f"the sample at index {sample.t:g} comes after index {self._last.t:g}, a sample is one step: "
                "give a sample without measurements, y=None, for each missing index, or call start again",
                field="t",
                value=sample.t,
            )
        return _Measured(
            sample.t,
            np.asarray(y, np.float64),
            np.asarray(sample.known, np.float64),
            sample.schedule,
            whole,
        )


def _between(before: FloatArray, after: FloatArray, s: float) -> FloatArray:
    mixed: FloatArray = (1.0 - s) * before + s * after
    return mixed


def _schedule(old: _Measured, new: _Measured, s: float) -> Schedule:
    """The scheduling variables at a share of the interval."""

    def schedule(x: FloatArray) -> Point:
        before, after = old.schedule(x), new.schedule(x)
        return {name: (1.0 - s) * before[name] + s * after[name] for name in before}

    return schedule


def _integrated(
    rate: Callable[[FloatArray, float], FloatArray],
    z: FloatArray,
    last: float,
    t: float,
    fastest: float,
    share: float = SUBSTEP,
) -> FloatArray:
    """The classical Runge-Kutta method from ``last`` to ``t``, in steps short beside 1 / ``fastest``.

    ``rate`` of z and the share of the interval. Raises EventError for too long an interval.
    """
    dt = t - last
    if not dt * fastest <= STEPS_MOST:
        raise EventError(
            f"the sample at t = {t!r} comes {dt:g} s after the last one, the observer bridges at most "
            f"{STEPS_MOST / fastest:g} s, {STEPS_MOST:.0e} steps: sample more often, or call start again",
            field="t",
            value=t,
        )
    steps = max(1, ceil(min(dt * fastest / share, STEPS_MOST)))
    h = dt / steps
    for i in range(steps):
        s, half, end = i / steps, (i + 0.5) / steps, (i + 1.0) / steps
        k1 = rate(z, s)
        k2 = rate(z + 0.5 * h * k1, half)
        k3 = rate(z + 0.5 * h * k2, half)
        k4 = rate(z + h * k3, end)
        z = z + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
    return z
