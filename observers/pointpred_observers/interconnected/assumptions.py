"""Assumptions 1.3.1 and 3.2.2, and the observer of Remark 3.2.2."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.design import DrivenObserver, FullOrderObserver
from pointpred_observers.numerics.eigenvalues import hidden, number_text, require_decay, unsettled
from pointpred_observers.numerics.equalities import without_rounding
from pointpred_observers.numerics.matrices import matrix
from pointpred_observers.plants.generator import Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, as_plant, constant
from pointpred_observers.plants.nonlinearity import NAMED
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.error_system import DecayCertificate, certify_decay, sloped_system

NEAR = 1e-6
"""Distance from 0 at which the derivative of f there is taken."""


class Moments(msgspec.Struct, frozen=True):
    """What Assumption 1.3.1 asks for, as far as the linear parts at 0 decide it.

    ``decay`` of the plant, 1/s (1/step); ``eigenvalues`` of the generator; ``assumed``: what only a nonlinear
    part decides, empty for linear systems.
    """

    decay: float
    eigenvalues: tuple[complex, ...]
    assumed: tuple[str, ...]


def assumption_1_3_1(plant: Plant, generator: Generator) -> Moments:
    """Assumption 1.3.1: a minimal, exponentially stable plant, an observable, neutrally stable generator.

    A linear generator is neutrally stable (stable, and its motions return: Poisson stability) exactly if
    every eigenvalue lies on the imaginary axis (the unit circle) and is simple in the minimal polynomial.
    Constant matrices only.

    Raises InfeasibleError naming an eigenvalue of the generator whose motion grows or decays, one of the
    plant that does not decay, or a mode that is not reached or not shown; ParameterError for a G.

    Reference: Khalin 2022, Assumption 1.3.1, definitions 1.3.10 and 1.3.11.

    >>> plant = Persidskii([[-1.0]], None, None, "sin", [1.0], None, [1.0])
    >>> assumption_1_3_1(plant, Generator([[0.0, 1.0], [-1.0, 0.0]], L0=[1.0, 0.0])).decay
    1.0
    >>> assumption_1_3_1(plant, Generator([[-0.5]], L0=[1.0]))
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: Assumption 1.3.1: the generator is not neutrally stable, a motion of \
the eigenvalue -0.5 decays
    """
    one = constant(plant, "Assumption 1.3.1")
    g = fitted(generator, one)
    if g.G.any():
        raise ParameterError("the generator of Assumption 1.3.1 has no G: its input is not y", field="G")
    driven = bool(g.S1.any() or g.L1.any())
    s, out = g.S0, g.L0
    if driven:
        f = one.f if generator.f is None else generator.f
        inner = _slope(f, np.zeros((0, g.q)) if g.J is None else g.J)
        s, out = g.S0 + g.S1 @ inner, g.L0 + g.L1 @ inner
    for value, motion in unsettled(s, one.time):
        if driven and "with t" in motion:  # a nonlinear part may hold a motion that only grows with t
            continue
        raise InfeasibleError(
            f"Assumption 1.3.1: the generator is not neutrally stable, {motion.format(number_text(value))}"
        )
    slope = _slope(one.f, one.H) if one.k else np.zeros((0, one.n))
    a, c = one.A0 + one.A1 @ slope, one.C0 + one.C1 @ slope
    slowest = require_decay([("", a)], one.time, "Assumption 1.3.1: the plant")
    # Where f acts, a mode that its linear part hides may be reached or shown all the same.
    bent = bool(one.A1.any() or one.C1.any())
    for left, right, acting, what in (
        (a.T, one.B.T, bent, "is reached by no input"),
        (a, c, bent, "of the plant never shows"),
        (s, out, driven, "of the generator never shows"),
    ):
        for mode in () if acting else hidden(left, right, one.time):
            raise InfeasibleError(f"Assumption 1.3.1: the mode of the eigenvalue {number_text(mode)} {what}")
    assumed = ("the generator is neutrally stable",) if g.S1.any() else ()
    return Moments(-slowest, tuple(complex(v) for v in np.linalg.eigvals(s)), assumed)


def _slope(f: Any, arguments: FloatArray) -> FloatArray:
    """The derivative of f(J w) at w = 0."""
    steps = NEAR * np.eye(arguments.shape[1])
    columns = [(f(arguments @ one) - f(-arguments @ one)) / (2.0 * NEAR) for one in steps]
    return np.array(columns).T


def joined(plant: Plant, generator: Generator) -> Persidskii:
    """The interconnection (3.1), (3.2) as one plant: states (x, w), the known input rho, the output y.

    Raises ParameterError for a generator whose f is another one, or without J where it has an f.
    """
    one = constant(plant, "a joint plant")
    g = fitted(generator, one)
    require_same_nonlinearity(one, generator)
    (n, p), q, count = (one.n, one.p), g.q, 1
    a1, h = np.vstack([one.A1, g.G @ one.C1]), np.hstack([one.H, np.zeros((one.r, q))])
    if g.S1.any() or g.L1.any():
        if g.J is None:
            raise ParameterError("the generator's f needs J: give it, or take it from steady_state_map")
        count = 2
        a1 = np.hstack([a1, np.vstack([one.B @ g.L1, g.S1])])
        h = np.vstack([h, np.hstack([np.zeros((len(g.J), n)), g.J])])
    f, r = one.f, one.r
    names = [NAMED[code] for code in f.codes] * count if f.codes is not None else None
    return Persidskii(
        np.block([[one.A0, one.B @ g.L0], [g.G @ one.C0, g.S0]]),
        a1,
        h,
        names if names is not None else lambda s: np.concatenate([f(part) for part in s.reshape(count, r)]),
        None,
        np.vstack([one.Q, g.E]),
        np.hstack([one.C0, np.zeros((p, q))]),
        np.hstack([one.C1] + [np.zeros_like(one.C1)] * (count - 1)),
        f.slopes * count if f.slopes else None,
        one.time,
        domain=one.domain,
    )


def remark_3_2_2(
    plant: Plant, generator: Generator, *, gains: tuple[Any, Any] | None = None, decay: float = 1.0
) -> DrivenObserver:
    """The observer of Remark 3.2.2: x^ and w^ together, corrected by L_x and L_w, with its certificate.

    It is the full-order observer of ``joined``: the first n rows of its ``gain`` are L_x, the others G + L_w.
    Unlike the observer of Theorem 3.2.1 it needs no x = Pi w.

    Parameters: ``gains`` (L_x, L_w) to certify, of shapes (n, p) and (q, p), by default computed ones; zeros
    are enough only where the generator's own motions approach each other; ``decay`` in 1/s (1/step), demanded
    of both errors. Raises as designs of full order do.

    >>> plant = Persidskii([[-1.0]], None, None, "sin", [1.0], None, [1.0])
    >>> found = remark_3_2_2(plant, Generator([[0.0, 1.0], [-1.0, 0.0]], L0=[1.0, 0.0]), decay=1.0)
    >>> found.gain.shape, min(found.margins.values()) > 0.0
    ((3, 1), True)
    """
    joint = joined(plant, generator)
    gain = None
    if gains is not None:
        g, n = fitted(generator, as_plant(plant)), joint.n - generator.q
        lx, lw = matrix("L_x", gains[0], n, joint.p), matrix("L_w", gains[1], g.q, joint.p)
        gain = np.vstack([lx, g.G + lw])
    return FullOrderObserver.design(joint, gain=gain, decay=decay)


def assumption_3_2_2(
    plant: Plant, generator: Generator | None = None, Pi: Any = None, *, decay: float | None = None
) -> DecayCertificate:
    """A certificate of incremental input-to-state stability, by a quadratic function of the difference.

    Sufficient for Assumption 3.2.2, as far as its consequence, Proposition 3.2.2, uses it: x approaches Pi w
    up to the disturbances d of the plant, w of the generator and v of the output. Global if the slopes of f
    hold globally. Two motions of an oscillator never approach each other. A refusal is not a proof of the
    contrary.

    z' = (A0 - Pi G C0) z + (A1 - Pi G C1) (f(Jw + Hz) - f(Jw)) + d - Pi w + Pi G v, (3.14) for Pi = I.

    Parameters: ``generator`` and ``Pi`` for a plant whose output is fed back (G != 0); ``decay`` in 1/s
    (1/step), > 0, by default a fraction of the slowest corner's.
    Raises what ``certify_decay`` raises; ParameterError for slopes that are missing or not bounded.

    Reference: Khalin 2022, Assumption 3.2.2, Proposition 3.2.2; Angeli 2002.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0, 0.5], [0.0, -2.0]], [0.0, -1.0], [1.0, 0.0], "tanh", [0.0, 1.0])
    >>> found = assumption_3_2_2(plant, decay=0.8)
    >>> round(found.bound.decay, 6), min(found.margins.values()) > 0.0
    (0.8, True)
    >>> assumption_3_2_2(Persidskii([[0.0, 1.0], [-1.0, 0.0]], None, None, "sin"))
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: Assumption 3.2.2: the error system has the eigenvalue 0+1j, must lie \
left of 0
    """
    one = constant(plant, "Assumption 3.2.2")
    disturbances, a0, a1 = {"d": np.eye(one.n)}, one.A0, one.A1
    if generator is not None:
        g = fitted(generator, one)
        if Pi is None and g.G.any():
            raise ParameterError("a generator with a G needs Pi: take it from steady_state_map", field="Pi")
        if Pi is not None:
            pi = matrix("Pi", Pi, one.n, g.q)
            a0 = a0 - pi @ g.G @ one.C0
            a1 = without_rounding(a1 - pi @ g.G @ one.C1, a1, pi @ g.G @ one.C1)
            disturbances |= {"w": -pi, "v": pi @ g.G}
    system = sloped_system(a0, a1, one.H, disturbances, slopes=one.slopes, time=one.time, domain=one.domain)
    try:
        return certify_decay(system, decay=decay)
    except ArithmeticError as failure:
        raise type(failure)(f"Assumption 3.2.2: {failure}") from failure
