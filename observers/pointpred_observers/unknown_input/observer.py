"""Unknown input observers for parameter-varying systems: designed with a certificate, or refused."""

from __future__ import annotations

from math import exp
from typing import Any, Self

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.balance import form, inward, outward
from pointpred_observers.bounds import ErrorBound
from pointpred_observers.eigenvalues import number_text, perron_root
from pointpred_observers.error_systems.system import ErrorSystem
from pointpred_observers.matrices import instance, positive
from pointpred_observers.unknown_input.boxes import Box, Point
from pointpred_observers.unknown_input.certificate import UnknownInputCertificate, audit, largest_decay
from pointpred_observers.unknown_input.gains import ROOMS, discrete_gain, gain, lyapunov
from pointpred_observers.unknown_input.stage import UnknownInputStage
from pointpred_observers.unknown_input.system import ParameterVaryingSystem, invariant_zeros
from pointpred_observers.unknown_input.zeros import independent, kernel

OUTPUT_DECAY = 5.0
"""Decay of errors of the outputs in continuous time, in the balanced unit of time of the design."""


class UnknownInputObserver(msgspec.Struct, frozen=True, eq=False):
    """The design of an observer that estimates the state of a system with unmeasured inputs.

    Assumes that the scheduling variables stay in the box. It discards every output direction that an unknown
    input reaches; the modes that are then unobserved, the invariant zeros, follow the model at their own
    rate. With as many outputs as unknown inputs these are all modes: no measurement corrects the estimate.

    z' = N z + T b + L y, x_hat = z - E y, E = -F (C F)^+, T = I + E C, N = T A + T' - K C, L = K - N E.
    Then e = T x - z obeys e' = N e + T delta, delta = (A(p) - A(p_hat)) x: Theorem 1 with - W C in (27c). A
    discrete system has the next z, no T', and E and T of the step: T F = 0 where F d enters.

    Made by ``design``; ``stage`` runs it. Memory: one gain per vertex, (vertices, n, p). Raises
    ParameterError for invalid shapes, ranks and points; InfeasibleError if a zero reaches -decay, before any
    solver runs, with the largest feasible decay; UndecidedError if no solver could decide; CertificateError
    if recomputed eigenvalues fail.

    Reference: Benyoucef et al. 2021, equations (16) to (27), (44), corrected as docs/equations.md says.

    >>> system = ParameterVaryingSystem(
    ...     lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), lambda p: np.array([[1.0], [0.0]]), np.eye(1, 2)
    ... )
    >>> observer = UnknownInputObserver.design(system, Box({"k": (-3.0, -1.0)}), decay=0.5)
    >>> observer.certificate.largest_decay, observer.certificate.margin > 0.0
    (1.0, True)
    >>> UnknownInputObserver.design(system, Box({"k": (-3.0, 0.5)}), decay=0.5)
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: the invariant zero 0.5 1/s at {'k': 0.5} must lie below -decay = \
-0.5 1/s: no decay above 0 is feasible in this box
    """

    system: ParameterVaryingSystem
    box: Box
    gains: FloatArray
    certificate: UnknownInputCertificate

    @classmethod
    def design(
        cls, system: ParameterVaryingSystem, box: Box, decay: float, *, output_decay: float | None = None
    ) -> Self:
        """An observer whose error decays at least as exp(-decay t), with the proof.

        ``decay`` 1/s (1/step in discrete time), positive; ``output_decay`` 1/s, that of errors of the
        outputs themselves, by default 5 in the unit of time in which the system is balanced, so that the
        design does not depend on the unit of time; in discrete time these end at the next step.
        """
        discrete = instance("system", system, ParameterVaryingSystem).time == "discrete"
        positive("decay", decay)
        if output_decay is not None:
            positive("output_decay", output_decay)
            if discrete:
                raise ParameterError(
                    "a discrete observer has no output_decay: errors of the outputs end at the next step",
                    field="output_decay",
                    value=output_decay,
                )
        system.checked(box)
        system = system.weighted(box)
        zeros = invariant_zeros(system, box)
        _refuse(box, zeros, decay, system.time)
        gammas, ts = system.at_vertices(box)
        units, natural_seconds = system.units(gammas, decay)
        if output_decay is None:
            output_decay = OUTPUT_DECAY / natural_seconds
        x, y, t = units.states, units.outputs, units.seconds
        inner = np.array([inward(one, x, x, t) for one in gammas])
        inner_ts = np.array([inward(one, x, x) for one in ts])
        # Redundant outputs: C = R C' with independent rows in C', and K = K' R'.
        rows, c = independent(inward(system.c, y, x))
        failure = None
        for room in ROOMS:
            p, gamma, gap = lyapunov(inner, inner_ts, c, decay * t, room, system.time)
            if discrete:
                found = [discrete_gain(one, c, p) for one in inner]
            else:
                rates = decay * t, output_decay * t
                found = [gain(one, on, c, p, gamma, *rates) for one, on in zip(inner, inner_ts, strict=True)]
            ks = np.array([outward(one @ rows.T, x, y, t) for one in found])
            # In the user's units delta has the unit of a state in 1/s, and V' that of V in 1/s.
            p, force = form(0.5 * (p + p.T), x), form(gamma * np.eye(len(p)), x, 1.0 / t)
            try:
                proof = audit(gammas, ts, system.c, p, ks, force, decay, zeros, system.time)
            except CertificateError as edge:
                failure = edge
                continue
            return cls(system, box, ks, msgspec.structs.replace(proof, gap=gap))
        raise UndecidedError(
            f"the invariant zeros allow a decay of {decay:g}, but too closely: choose a smaller decay "
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
        decay: float,
        gap: float = np.inf,
    ) -> Self:
        """The observer of gains and matrices from any source, audited at every vertex.

        Parameters: ``gains`` K, (vertices, n, p); ``P`` and ``force``, F of the theorem, (n, n); ``decay``
        and ``gap`` as in the certificate. Raises CertificateError if an eigenvalue fails; ParameterError.
        """
        instance("system", system, ParameterVaryingSystem).checked(box)
        system = system.weighted(box)
        gammas, ts = system.at_vertices(box)
        wanted = (len(ts), *system.c.T.shape)
        if np.shape(gains) != wanted or not np.isfinite(gains).all():
            raise ParameterError(
                f"gains need shape {wanted}, one matrix a vertex, and finite numbers, received shape "
                f"{np.shape(gains)}",
                field="gains",
            )
        zeros = invariant_zeros(system, box)
        proof = audit(gammas, ts, system.c, P, gains, force, decay, zeros, system.time)
        return cls(system, box, np.asarray(gains, np.float64), msgspec.structs.replace(proof, gap=gap))

    def audited(self) -> Self:
        """The same observer, every eigenvalue of its certificate computed again; raises as ``certified``."""
        proof = self.certificate
        return self.certified(self.system, self.box, self.gains, proof.p, proof.force, proof.decay, proof.gap)

    @property
    def plant(self) -> ParameterVaryingSystem:
        """The system that is observed."""
        return self.system

    @property
    def decay(self) -> float:
        """The proved decay of the error, 1/s (1/step)."""
        return self.certificate.decay

    @property
    def margins(self) -> dict[str, float]:
        """How far each inequality holds."""
        return {"(27c)": self.certificate.margin}

    @property
    def bound(self) -> ErrorBound:
        """The proved bound of T x - z, disturbed by ``delta``."""
        return self.certificate.bound

    @property
    def bounds(self) -> dict[str, ErrorBound]:
        """The proved bounds by name."""
        return {"error": self.bound}

    @property
    def gap(self) -> float:
        """How far below what was minimised the least could lie, relative; infinite if nothing is proved."""
        return self.certificate.gap

    def error_system(self) -> ErrorSystem:
        """The system of T x - z at each vertex, disturbed by ``delta`` = (A(p) - A(p^)) x."""
        corners = self.box.corners
        a = np.array(self._error_rates())
        names = tuple(", ".join(f"{key} = {value:g}" for key, value in p.items()) for p in corners)
        ts, n = np.array([self.system.t(p) for p in corners]), a.shape[1]
        return ErrorSystem(a, ts, np.eye(n), names, {"delta": n}, self.system.time)

    def stage(self, start: Any = None, *, noise: Any = None, density: Any = None) -> UnknownInputStage:
        """The observer as a stage that starts at an estimate, or at 0; the first sample replaces its outputs.

        ``noise`` and ``density`` as for ``InputReconstruction``: without them the unknown input is
        estimated over each interval by itself.
        """
        return UnknownInputStage(self, start, noise=noise, density=density)

    def equations(self, point: Point) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Gamma, K, E and T at a point: z' = Gamma x_hat + K (y - C x_hat) + T b, x_hat = z - E y.

        Outside the box the gains are those of its nearest point, without a proof. Where C T = 0, with as many
        outputs as unknown inputs, no gain acts: K is zero, and all act on the kernel of C only.
        """
        system = self.system
        gamma, e, t = system.gamma(point), system.e(point), system.t(point, check=False)
        if not self.reducible:
            return gamma, self.box.mixed(self.gains, self.box.nearest(point)), e, t
        blind = kernel(system.c)
        onto = blind @ blind.T
        return onto @ gamma, np.zeros_like(e), e, onto @ t

    @property
    def reducible(self) -> bool:
        """Whether C T = 0: with as many outputs as unknown inputs no gain is needed."""
        return bool(self.system.f(self.box.corners[0]).shape[1] == len(self.system.c))

    @property
    def fastest(self) -> float:
        """A bound of the rates of z over the vertices, 1/s: the largest eigenvalue of absolute entries."""
        blind = kernel(self.system.c) if self.reducible else np.eye(self.system.c.shape[1])
        return max(perron_root(blind.T @ one @ blind) for one in self._error_rates())

    def _error_rates(self) -> list[FloatArray]:
        """N = Gamma - K C at each vertex."""
        pairs = zip(self.box.corners, self.gains, strict=True)
        return [np.asarray(self.system.gamma(point) - k @ self.system.c) for point, k in pairs]


def _refuse(box: Box, zeros: NDArray[np.complex128], decay: float, time: str) -> None:
    """Raise InfeasibleError, with the largest decay, if a zero reaches -decay.

    In discrete time if its modulus reaches exp(-decay).
    """
    most, discrete = largest_decay(zeros, time), time == "discrete"
    if decay < most:
        return
    sizes = np.abs(zeros) if discrete else zeros.real
    vertex = int(sizes.max(axis=1).argmax())
    value, unit = number_text(zeros[vertex][sizes[vertex].argmax()]), "1/step" if discrete else "1/s"
    place = f"the invariant zero {value}{'' if discrete else ' 1/s'} at {box.corners[vertex]} must "
    needed = (
        f"have a modulus below exp(-decay) = {exp(-decay):g}"
        if discrete
        else f"lie below -decay = {-decay:g} 1/s"
    )
    end = (
        f"the largest feasible decay is below {most:.6g} {unit}"
        if most > 0.0
        else "no decay above 0 is feasible in this box"
    )
    raise InfeasibleError(f"{place}{needed}: {end}")
