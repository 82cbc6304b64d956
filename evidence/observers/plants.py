"""Random problems of every kind for every door: those that the table of designs counts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pointpred.errors import UndecidedError
from pointpred.records import FloatArray
from pointpred_observers import Box, Generator, ParameterVaryingSystem, Persidskii, invariant_observer
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.proofs.search import filter_start
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import certify_convergence, certify_tracking
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.unknown_input.observer import UnknownInputObserver

KINDS = ("random", "stiff", "slow", "badly scaled", "nearly unobservable")
SLOW = 1e-5
"""How much slower the slow plants are, and how much smaller their required rates."""
UNITS, CLOCK = 6.0, 5.0
"""Largest powers of ten of the units of states and outputs, and of time, where they are bad."""
DECAY = 0.5


class Problem:
    """A random e' = A e + A1 f(H e), y = C e of one kind, in its units, and the rate that is asked for."""

    def __init__(self, kind: str, random: np.random.Generator, *, largest: int = 8) -> None:
        n = int(random.integers(2, largest + 1))
        p = int(random.integers(1, max(2, n // 2) + 1))
        k = int(random.integers(1, 3))
        self.n, self.p, self.k, self.kind = n, min(p, n - 1), k, kind
        self.a = random.standard_normal((n, n)) / np.sqrt(n) - 0.3 * np.eye(n)
        if kind == "stiff":
            turn = np.eye(n) + 0.3 * random.standard_normal((n, n)) / np.sqrt(n)
            rates = -(10.0 ** random.uniform(-2.0, 3.0, n))
            rates[0] = 0.2
            self.a = turn @ np.diag(rates) @ np.linalg.inv(turn)
        self.a1 = 0.3 * random.standard_normal((n, k)) / np.sqrt(k)
        self.h = random.standard_normal((k, n)) / np.sqrt(n)
        self.c = random.standard_normal((self.p, n))
        if kind == "nearly unobservable":
            self.c = hiding(self.a, self.c, 10.0 ** random.uniform(-4.0, -2.0))
        self.x, self.y, self.t = np.ones(n), np.ones(self.p), 1.0
        if kind == "badly scaled":
            self.x = 10.0 ** random.uniform(-UNITS, UNITS, n)
            self.y = 10.0 ** random.uniform(-UNITS, UNITS, self.p)
            self.t = 10.0 ** random.uniform(-CLOCK, CLOCK)
        if kind == "slow":
            self.t = SLOW
        self.random = random

    @property
    def decay(self) -> float:
        """The required rate in 1/s."""
        return DECAY * self.t

    def inner(self, matrix: Any) -> FloatArray:
        """A matrix in 1/s between states, in the problem's units."""
        return np.asarray(self.t * matrix * self.x / self.x[:, None])

    def plant(self, *, linear: bool = False, time: str = "continuous") -> Persidskii:
        """The problem as a plant; in discrete time sampled by Euler's method with a step of 0.1."""
        a, a1, seen = self.a, self.a1, self.c * self.x / self.y[:, None]
        driven, h = self.t * a1 / self.x[:, None], self.h * self.x
        if time == "discrete":
            step = 0.1 / max(1.0, float(np.abs(np.linalg.eigvals(a)).max()))
            moved = np.eye(self.n) + step * a
            drift, driven = moved * self.x / self.x[:, None], step * a1 / self.x[:, None]
        else:
            drift = self.inner(a)
        if linear:
            return Persidskii(drift, None, None, "tanh", C0=seen, time=time)
        return Persidskii(drift, driven, h, "tanh", C0=seen, time=time)


def hiding(a: FloatArray, c: FloatArray, share: float) -> FloatArray:
    """C with the direction of the slowest mode seen by a ``share`` of before."""
    values, vectors = np.linalg.eig(a)
    slowest = vectors[:, int(values.real.argmax())]
    basis = np.linalg.qr(np.column_stack([slowest.real, slowest.imag]))[0]
    basis = basis if abs(slowest.imag).max() > 1e-12 else basis[:, :1]
    return np.asarray(c - (1.0 - share) * c @ basis @ basis.T)


def copied(one: Problem, time: str) -> Any:
    """An observer of all states: the generator copies the plant, Pi = I."""
    plant = one.plant(time=time)
    generator = Generator(plant.A0, plant.A1, plant.H)
    decay = one.decay if time == "continuous" else 0.02
    return DrivenObserver.design(plant, generator=generator, Pi=np.eye(one.n), decay=decay)


def reduced(one: Problem, *, linear: bool, time: str = "continuous") -> Any:
    """An observer of the states that are not measured."""
    decay = one.decay if time == "continuous" else 0.02
    return ReducedOrderObserver.design(one.plant(linear=linear, time=time), decay=decay)


def certified(one: Problem) -> Any:
    """A certificate for an observer whose gain comes from a Kalman filter without the nonlinearity."""
    turn = np.linalg.qr(one.c.T, mode="complete")[0]
    seen, blind = turn[:, : one.p], turn[:, one.p :]
    start = filter_start(blind.T @ one.a @ blind, seen.T @ one.a @ blind, DECAY, "continuous")
    if start is None:
        raise UndecidedError("no filter")
    upsilon = -np.linalg.solve(*start) @ np.linalg.inv(one.c @ seen)
    observer = invariant_observer(one.plant(), blind.T * one.x, upsilon * one.y, injection=True)
    return certify_convergence(observer, decay=0.2 * one.t)


def followed(one: Problem) -> Any:
    """The regulator with Pi = I that drives the plant by one input and reads its outputs."""
    random, n = one.random, one.n
    a = one.a - (max(0.0, float(np.linalg.eigvals(one.a).real.max())) + 0.3) * np.eye(n)
    b, g = random.standard_normal((n, 1)), 0.3 * random.standard_normal((n, one.p))
    l0, l1 = -0.3 * random.standard_normal((1, n)), -0.1 * random.standard_normal((1, one.k))
    x, y, t = one.x, one.y, one.t
    plant = Persidskii(
        one.inner(a),
        t * one.a1 / x[:, None],
        one.h * x,
        "tanh",
        t * b / x[:, None],
        t * b / x[:, None],
        one.c * x / y[:, None],
    )
    regulator = Generator(
        one.inner(a + b @ l0 - g @ one.c),
        t * (one.a1 + b @ l1) / x[:, None],
        one.h * x,
        t * g * y / x[:, None],
        l0 * x,
        l1,
        t * b / x[:, None],
    )
    return certify_tracking(plant, regulator, np.eye(n))


def interlaced(one: Problem) -> Any:
    """The observer of an interlaced system: a generator and the row that it shows."""
    return certify_interlaced(one.inner(one.a), one.c[:1] * one.x / one.y[0], decay=one.decay)


def unknown(one: Problem) -> Any:
    """One unknown input that reaches the outputs, and a scheduled part of A."""
    random, x, y = one.random, one.x, one.y
    force = random.standard_normal((one.n, 1))
    moving = 0.2 * random.standard_normal((one.n, one.n)) / one.n
    system = ParameterVaryingSystem(
        lambda p: one.inner(one.a + p["s"] * moving),
        lambda p: force / x[:, None],
        one.c * x / y[:, None],
    )
    return UnknownInputObserver.design(system, Box({"s": (-1.0, 1.0)}), 0.1 * one.t)


DOORS: dict[str, Callable[[Problem], Any]] = {
    "`design_observer`": lambda one: copied(one, "continuous"),
    "`design_observer`, discrete": lambda one: copied(one, "discrete"),
    "`design_reduced_order`, linear": lambda one: reduced(one, linear=True),
    "`design_reduced_order`, `injection=True`": lambda one: reduced(one, linear=False),
    "`design_reduced_order`, discrete": lambda one: reduced(one, linear=False, time="discrete"),
    "`certify_convergence`": certified,
    "`certify_tracking`": followed,
    "`certify_interlaced`": interlaced,
    "`UnknownInputObserver.design`": unknown,
}
"""What each row of the table calls."""
