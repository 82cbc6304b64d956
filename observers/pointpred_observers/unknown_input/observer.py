"""Unknown input observers for parameter-varying systems: designed with a certificate, or refused."""

from __future__ import annotations

from math import exp, isfinite
from typing import Any, Self

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.balance import form, inward, outward
from pointpred_observers.eigenvalues import number_text, perron_root
from pointpred_observers.matrices import instance
from pointpred_observers.unknown_input import discrete_gains
from pointpred_observers.unknown_input.boxes import Box
from pointpred_observers.unknown_input.certificate import (
    UnknownInputCertificate,
    audit,
    largest_sigma,
)
from pointpred_observers.unknown_input.gains import ROOMS, Room, gain, lyapunov
from pointpred_observers.unknown_input.invariant_zeros import fixed_modes, independent, kernel
from pointpred_observers.unknown_input.reconstruction import InputReconstruction
from pointpred_observers.unknown_input.run import (
    RunningUnknownInputObserver,
    UnknownInputEstimate,
    UnknownInputSample,
)
from pointpred_observers.unknown_input.system import ParameterVaryingSystem, Point
from pointpred_observers.unknown_input.takagi_sugeno import TakagiSugeno

OUTPUT_RATE = 5.0
"""Decay rate of errors of the outputs in continuous time, in the balanced unit of time of the design."""


class UnknownInputObserver:
    """Estimates the state of a system with unmeasured inputs.

    Assumes that the scheduling variables stay in the box. It discards every output direction that an unknown
    input reaches; the modes that are then unobserved, the invariant zeros, follow the model at their own
    rate. With as many outputs as unknown inputs these are all modes: no measurement corrects the estimate.

    z' = N z + T b + L y, x_hat = z - E y, E = -F (C F)^+, T = I + E C, N = T A + T' - K C, L = K - N E.
    Then e = T x - z obeys e' = N e + T delta, delta = (A(p) - A(p_hat)) x: Theorem 1 with - W C in (27c). A
    discrete system has the next z, no T', and E and T of the step: T F = 0 where F d enters.

    Made by ``design``; ``start`` and ``update`` run it. Memory: one gain per vertex, and one sample. Raises
    ParameterError for invalid shapes, ranks and points; InfeasibleError if a zero reaches -sigma/2, before
    any solver runs, with the largest feasible sigma; UndecidedError if no solver could decide;
    CertificateError if recomputed eigenvalues fail.

    Reference: Benyoucef et al. 2021, equations (16) to (27), (44), corrected as docs/equations.md says.

    >>> system = ParameterVaryingSystem(
    ...     lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), lambda p: np.array([[1.0], [0.0]]), np.eye(1, 2)
    ... )
    >>> observer = UnknownInputObserver.design(system, Box({"k": (-3.0, -1.0)}), sigma=1.0)
    >>> observer.certificate.largest_sigma, observer.certificate.margin > 0.0
    (2.0, True)
    >>> UnknownInputObserver.design(system, Box({"k": (-3.0, 0.5)}), sigma=1.0)
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: the invariant zero 0.5 1/s at {'k': 0.5} must lie below -sigma/2 = \
-0.5 1/s: no sigma above 0 is feasible in this box
    """

    def __init__(
        self,
        system: ParameterVaryingSystem,
        box: Box,
        certificate: UnknownInputCertificate,
        gains: TakagiSugeno,
    ) -> None:
        self.system, self.box, self.certificate, self.gains = system, box, certificate, gains
        self._blind = kernel(system.c)
        self._running: RunningUnknownInputObserver | None = None

    @classmethod
    def design(
        cls, system: ParameterVaryingSystem, box: Box, sigma: float, *, output_rate: float | None = None
    ) -> Self:
        """An observer whose error decays at least as exp(-sigma t / 2), with the proof.

        ``sigma`` 1/s (1/step in discrete time), positive; ``output_rate`` 1/s, decay rate of errors of the
        outputs themselves, by default 5 in the unit of time in which the system is balanced, so that the
        design does not depend on the unit of time; in discrete time these end at the next step.
        """
        instance("system", system, ParameterVaryingSystem)
        rates = {"sigma": sigma} if output_rate is None else {"sigma": sigma, "output_rate": output_rate}
        for name, value in rates.items():
            if not (is_number(value) and isfinite(value) and value > 0.0):
                raise ParameterError(
                    f"{name} must be positive and finite, received {value!r}", field=name, value=value
                )
        if output_rate is not None and system.time == "discrete":
            raise ParameterError(
                "a discrete observer has no output_rate: errors of the outputs end at the next step",
                field="output_rate",
                value=output_rate,
            )
        system.checked(box)
        system = system.weighted(box)
        zeros = zeros_over(system, box)
        refuse(box, zeros, sigma, system.time)
        gammas, ts = system.at_vertices(box)
        units = system.units(gammas, sigma)
        if output_rate is None:
            output_rate = OUTPUT_RATE / system.natural_seconds(gammas, sigma)
        x, y, t = units.states, units.outputs, units.seconds
        inner = np.array([inward(one, x, x, t) for one in gammas])
        inner_ts = np.array([inward(one, x, x) for one in ts])
        # Redundant outputs: C = R C' with independent rows in C', and K = K' R'.
        rows, c = independent(inward(system.c, y, x))
        solve = _discrete if system.time == "discrete" else _continuous
        failure = None
        for room in ROOMS:
            p, gamma, gap, inner_ks = solve(inner, inner_ts, c, (sigma * t, output_rate * t), room)
            ks = np.array([outward(one @ rows.T, x, y, t) for one in inner_ks])
            # In the user's units delta has the unit of a state in 1/s, and V' that of V in 1/s.
            p, force = form(0.5 * (p + p.T), x), form(gamma * np.eye(len(p)), x, 1.0 / t)
            try:
                certificate = audit(gammas, ts, system.c, p, ks, force, sigma, zeros, system.time)
            except CertificateError as edge:
                failure = edge
                continue
            return cls(system, box, msgspec.structs.replace(certificate, gap=gap), TakagiSugeno(box, ks))
        raise UndecidedError(
            f"the invariant zeros allow sigma = {sigma:g}, but too closely: choose a smaller sigma "
            f"or a smaller box ({failure})"
        ) from failure

    @classmethod
    def certified(
        cls,
        system: ParameterVaryingSystem,
        box: Box,
        gains: FloatArray,
        P: FloatArray,
        force: FloatArray,
        sigma: float,
        gap: float = np.inf,
    ) -> Self:
        """The observer of gains and matrices from any source, audited at every vertex.

        Parameters: ``gains`` K, (vertices, n, p); ``P`` and ``force``, F of the theorem, (n, n); ``sigma``
        and ``gap`` as in the certificate. Raises CertificateError if an eigenvalue fails; ParameterError.
        """
        instance("system", system, ParameterVaryingSystem).checked(box)
        system = system.weighted(box)
        gammas, ts = system.at_vertices(box)
        model = TakagiSugeno(box, gains)
        zeros = zeros_over(system, box)
        certificate = audit(gammas, ts, system.c, P, model.matrices, force, sigma, zeros, system.time)
        return cls(system, box, msgspec.structs.replace(certificate, gap=gap), model)

    def audited(self) -> Self:
        """The same observer, every eigenvalue of its certificate computed again; raises as ``certified``."""
        proof = self.certificate
        if proof.force is None:
            raise ParameterError(
                "the certificate lacks the matrix F of the theorem: design the observer again"
            )
        return self.certified(
            self.system, self.box, self.gains.matrices, proof.p, proof.force, proof.sigma, proof.gap
        )

    def start(self, estimate: FloatArray, *, noise: Any = None, density: Any = None) -> None:
        """Forget every sample and start at an estimate; the first sample replaces its outputs.

        ``noise`` and ``density`` as for ``InputReconstruction``: without them the unknown input is
        estimated over each interval by itself.
        """
        reconstruction = InputReconstruction(
            len(self.system.c), self.system.time, noise=noise, density=density
        )
        self._running = RunningUnknownInputObserver(self, estimate, reconstruction)

    def update(self, sample: UnknownInputSample, /) -> UnknownInputEstimate:
        """Consume one sample after ``start``; a refused one changes nothing."""
        if self._running is None:
            raise ParameterError("an estimate to start with is needed: call start(estimate) first")
        return self._running.update(sample)

    def matrices(self, point: Point) -> tuple[FloatArray, FloatArray, FloatArray]:
        """N, Y and T of z' = N z + Y y + T b at a point, in the form that runs.

        The reduced form where there is one, written for z; else the full form.
        """
        if not self.reducible:
            return self._full(point)
        onto = self._blind @ self._blind.T
        inner = onto @ self.system.gamma(point)
        return inner @ onto, -inner @ self.system.e(point), onto @ self.system.t(point, check=False)

    def rate(self, z: FloatArray, y: FloatArray, point: Point, known: FloatArray) -> FloatArray:
        """The rate of z in the full form; ``known`` is b(y, u).

        Outside the box the gains are those of its nearest point, without a proof.
        """
        n, seen, t = self._full(point)
        rate: FloatArray = n @ z + t @ known + seen @ y
        return rate

    def _full(self, point: Point) -> tuple[FloatArray, FloatArray, FloatArray]:
        k = self.gains.at(self.box.nearest(point))
        n = self.system.gamma(point) - k @ self.system.c
        return n, k - n @ self.system.e(point), self.system.t(point, check=False)

    def onward(self, estimate: FloatArray, y: FloatArray, point: Point, known: FloatArray) -> FloatArray:
        """The next z of a discrete system, from the estimate x_hat = z - E y."""
        k = self.gains.at(self.box.nearest(point))
        z: FloatArray = self.system.ta(point) @ estimate + self.system.t(point, check=False) @ known
        return np.asarray(z + k @ (y - self.system.c @ estimate), np.float64)

    @property
    def fastest(self) -> float:
        """A bound of the rates of z over the vertices, 1/s: the largest eigenvalue of absolute entries."""
        if self.reducible:
            forms = [self._blind.T @ self._error_rate(i) @ self._blind for i in range(len(self.box.vertices))]
        else:
            forms = [self._error_rate(i) for i in range(len(self.box.vertices))]
        return max(perron_root(one) for one in forms)

    def _error_rate(self, vertex: int) -> FloatArray:
        """N at a vertex."""
        point = self.box.named(self.box.vertices[vertex])
        n: FloatArray = self.system.gamma(point) - self.gains.matrices[vertex] @ self.system.c
        return n

    def estimate(self, z: FloatArray, y: FloatArray, point: Point) -> FloatArray:
        """x_hat = z - E y."""
        state: FloatArray = z - self.system.e(point) @ y
        return state

    def begin(self, estimate: FloatArray, point: Point) -> FloatArray:
        """The z of an estimate: T x_hat."""
        z: FloatArray = self.system.t(point, check=False) @ estimate
        return z

    @property
    def reducible(self) -> bool:
        """Whether C T = 0: with as many outputs as unknown inputs no gain is needed."""
        middle = self.box.named(self.box.vertices[0])
        return bool(self.system.f(middle).shape[1] == self.system.c.shape[0])

    def reduce(self, z: FloatArray) -> FloatArray:
        """The coordinates of the reduced form: z in the kernel of C."""
        if not self.reducible:
            inputs = self.system.f(self.box.named(self.box.vertices[0])).shape[1]
            raise ParameterError(
                f"the reduced form needs as many outputs as unknown inputs, received "
                f"{self.system.c.shape[0]} outputs and {inputs} inputs"
            )
        reduced: FloatArray = self._blind.T @ z
        return reduced

    def expand(self, reduced: FloatArray) -> FloatArray:
        """The z with these coordinates of the reduced form."""
        z: FloatArray = self._blind @ reduced
        return z

    def reduced_rate(self, reduced: FloatArray, y: FloatArray, point: Point, known: FloatArray) -> FloatArray:
        """The rate of the reduced form, which needs no gain and holds outside the box as well.

        Equal to the full form started with C x_hat = y: C z = 0 stays true, so K never acts.
        """
        estimate = self.expand(reduced) - self.system.e(point) @ y
        return self.reduce(self.system.gamma(point) @ estimate + self.system.t(point, check=False) @ known)


def _continuous(
    gammas: FloatArray, ts: FloatArray, c: FloatArray, rates: tuple[float, float], room: Room
) -> tuple[FloatArray, float, float, list[FloatArray]]:
    """P, gamma, the gap and the gain of each vertex; ``rates`` are sigma and that of the outputs."""
    sigma, output_rate = rates
    p, gamma, gap = lyapunov(gammas, ts, c, sigma, room)
    ws = [gain(one, two, c, p, gamma, sigma, output_rate) for one, two in zip(gammas, ts, strict=True)]
    return p, gamma, gap, [np.asarray(np.linalg.solve(p, one), np.float64) for one in ws]


def _discrete(
    gammas: FloatArray, ts: FloatArray, c: FloatArray, rates: tuple[float, float], room: Room
) -> tuple[FloatArray, float, float, list[FloatArray]]:
    """The same in discrete time, where nothing depends on the rate of the outputs."""
    p, gamma, gap = discrete_gains.lyapunov(gammas, ts, c, rates[0], room)
    return p, gamma, gap, [discrete_gains.gain(one, c, p) for one in gammas]


def zeros_over(system: ParameterVaryingSystem, box: Box) -> NDArray[np.complex128]:
    """The invariant zeros, one row per vertex; needs no solver."""
    instance("system", system, ParameterVaryingSystem)
    points = [box.named(vertex) for vertex in instance("box", box, Box).vertices]
    rows = [fixed_modes(system.ta(p), system.c) for p in points]
    widest = max(len(row) for row in rows)
    if any(len(row) != widest for row in rows):
        raise ParameterError(
            f"the number of invariant zeros must not change over the box, it lies between "
            f"{min(len(row) for row in rows)} and {widest}"
        )
    return np.array(rows).reshape(len(rows), widest)


def refuse(box: Box, zeros: NDArray[np.complex128], sigma: float, time: str = "continuous") -> None:
    """Raise InfeasibleError, with the largest sigma, if a zero reaches -sigma/2.

    In discrete time if its modulus reaches exp(-sigma/2).
    """
    most = largest_sigma(zeros, time)
    if sigma < most:
        return
    sizes = np.abs(zeros) if time == "discrete" else zeros.real
    vertex = int(sizes.max(axis=1).argmax())
    zero = zeros[vertex][sizes[vertex].argmax()]
    value = number_text(zero)
    unit = "1/step" if time == "discrete" else "1/s"
    end = (
        f"the largest feasible sigma is below {most:.6g} {unit}"
        if most > 0.0
        else "no sigma above 0 is feasible in this box"
    )
    if time == "discrete":
        raise InfeasibleError(
            f"the invariant zero {value} at {box.named(box.vertices[vertex])} must have a modulus below "
            f"exp(-sigma/2) = {exp(-0.5 * sigma):g}: {end}"
        )
    raise InfeasibleError(
        f"the invariant zero {value} 1/s at {box.named(box.vertices[vertex])} must lie below "
        f"-sigma/2 = {-0.5 * sigma:g} 1/s: {end}"
    )
