"""Unknown input observers for parameter-varying systems: designed with a certificate, or refused."""

from __future__ import annotations

from functools import partial
from math import exp
from typing import Any, ClassVar, Self
from warnings import warn

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import Coordinates, inward, outward
from pointpred_observers.numerics.eigenvalues import number_text, perron_root
from pointpred_observers.numerics.matrices import instance, matrix, positive
from pointpred_observers.observer import Observer
from pointpred_observers.plants.boxes import Box, Point
from pointpred_observers.plants.documents import ParameterVaryingDocument
from pointpred_observers.plants.entries import (
    Document,
    Functions,
    Rows,
    Values,
    finite,
    gap_of,
    matrices_of,
    plain,
)
from pointpred_observers.plants.varying import (
    CornerSystem,
    ParameterVaryingSystem,
    independent,
    invariant_zeros,
    kernel,
)
from pointpred_observers.proofs.error_system import ErrorSystem
from pointpred_observers.proofs.search import least_in_both
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting, matrices_at, run, sampled, schedule_of
from pointpred_observers.unknown_input.certificate import (
    ROOMS,
    UnknownInputCertificate,
    audit,
    discrete_gain,
    gain,
    largest_decay,
    lyapunov,
)
from pointpred_observers.unknown_input.stage import UnknownInputSample, UnknownInputStage

OUTPUT_DECAY = 5.0
"""Decay of errors of the outputs in continuous time, in the balanced unit of time of the design."""


class UnknownInputObserver(Observer, msgspec.Struct, frozen=True, eq=False):
    """The design of an observer that estimates the state of a system with unmeasured inputs.

    Assumes that the scheduling variables stay in the box. The modes that are unobserved without the output
    directions that an unknown input reaches, the invariant zeros, follow the model at their own rate. With as
    many outputs as unknown inputs these are all modes: no measurement corrects the estimate.

    z' = N z + T b + L y, x_hat = z - E y, E = -F (C F)^+, T = I + E C, N = T A + T' - K C, L = K - N E.
    Then e = T x - z obeys e' = N e + T delta, delta = (A(p) - A(p_hat)) x: Theorem 1 with - W C in (27c). A
    discrete system has the next z, no T', and E and T of the step: T F = 0 where F d enters.

    Memory: one gain per vertex, (vertices, n, p). Raises ParameterError for invalid shapes, ranks and points;
    InfeasibleError if a zero reaches -decay, before any solver runs, with the largest feasible decay;
    UndecidedError if no solver could decide; CertificateError if recomputed eigenvalues fail.

    Reference: Benyoucef et al. 2021, equations (16) to (27), (44), corrected as docs/equations.md says.

    >>> system = ParameterVaryingSystem(
    ...     lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), lambda p: np.array([[1.0], [0.0]]), np.eye(1, 2)
    ... )
    >>> observer = UnknownInputObserver.design(system, box=Box({"k": (-3.0, -1.0)}), decay=0.5)
    >>> observer.certificate.largest_decay, observer.certificate.margin > 0.0
    (1.0, True)
    >>> UnknownInputObserver.design(system, box=Box({"k": (-3.0, 0.5)}), decay=0.5)
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: the invariant zero 0.5 1/s at {'k': 0.5} must lie below -decay = \
-0.5 1/s: no decay above 0 is feasible in this box
    """

    kind: ClassVar[str] = "unknown-input"

    system: ParameterVaryingSystem
    box: Box
    gains: FloatArray
    certificate: UnknownInputCertificate

    @classmethod
    def design(
        cls,
        plant: ParameterVaryingSystem,
        box: Box | None = None,
        decay: float = 1.0,
        *,
        output_decay: float | None = None,
    ) -> Self:
        """An observer whose error decays at least as exp(-decay t), with the proof.

        ``box`` of the scheduling variables, by default that of a ``CornerSystem``; ``decay`` 1/s (1/step in
        discrete time), positive; ``output_decay`` 1/s, that of errors of the outputs themselves, by default 5
        in the unit of time in which the system is balanced; in discrete time these end at the next step.
        """
        system = instance("plant", plant, ParameterVaryingSystem)
        discrete = system.time == "discrete"
        if box is None:
            if not isinstance(system, CornerSystem):
                raise ParameterError("a system of functions needs box, that of its variables", field="box")
            box = system.box
        positive("decay", decay)
        if output_decay is not None:
            positive("output_decay", output_decay)
            if discrete:
                words = "a discrete observer has no output_decay: errors of the outputs end at the next step"
                raise ParameterError(words, field="output_decay", value=output_decay)
        system.checked(box)
        system = system.weighted(box)
        zeros = invariant_zeros(system, box)
        _refuse(box, zeros, decay, system.time)
        gammas, ts = system.at_vertices(box)
        units, natural_seconds = system.units(gammas, decay)
        if output_decay is None:
            output_decay = OUTPUT_DECAY / natural_seconds
        rate: float = output_decay

        def designed(units: Coordinates) -> Any:
            x, y, t = units.states, units.outputs, units.seconds
            inner = np.array([inward(one, x, x, t) for one in gammas])
            inner_ts = np.array([inward(one, x, x) for one in ts])
            # Redundant outputs: C = R C' with independent rows in C', and K = K' R'.
            rows, c = independent(inward(system.c, y, x))
            failure = None
            for room in ROOMS:
                p, gamma, gap = lyapunov(inner, inner_ts, c, decay * t, room, system.time)
                found = [
                    discrete_gain(one, c, p) if discrete else gain(one, on, c, p, gamma, decay * t, rate * t)
                    for one, on in zip(inner, inner_ts, strict=True)
                ]
                ks = np.array([outward(one @ rows.T, x, y, t) for one in found])
                # In the user's units delta has the unit of a state in 1/s, and V' that of V in 1/s.
                form = np.outer(x, x)
                p, force = 0.5 * (p + p.T) / form, gamma * np.eye(len(p)) / form * t
                try:
                    proof = audit(gammas, ts, system.c, p, ks, force, decay, zeros, system.time)
                    return cls(system, box, ks, msgspec.structs.replace(proof, gap=gap))
                except CertificateError as edge:
                    failure = edge
            raise UndecidedError(
                f"the invariant zeros allow a decay of {decay:g}, but too closely: choose a smaller decay "
                f"or a smaller box ({failure})"
            ) from failure

        found: Self = least_in_both(units, designed)
        return found

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
            needs = f"need shape {wanted}, one matrix a vertex, and finite numbers, received shape"
            raise ParameterError(f"gains {needs} {np.shape(gains)}", field="gains")
        zeros = invariant_zeros(system, box)
        proof = audit(gammas, ts, system.c, P, gains, force, decay, zeros, system.time)
        return cls(system, box, np.asarray(gains, np.float64), msgspec.structs.replace(proof, gap=gap))

    def audited(self) -> Self:
        """The same observer, every eigenvalue of its certificate computed again; raises as ``certified``."""
        proof = self.certificate
        return self.certified(self.system, self.box, self.gains, proof.P, proof.force, proof.decay, proof.gap)

    @property
    def plant(self) -> ParameterVaryingSystem:
        """The system that is observed."""
        return self.system

    @property
    def decay(self) -> float:
        """The proved decay of the error, 1/s (1/step)."""
        return self.certificate.decay

    def error_system(self) -> ErrorSystem:
        """The system of T x - z at each vertex, disturbed by ``delta`` = (A(p) - A(p^)) x."""
        corners = self.box.corners
        a = np.array(self._error_rates())
        names = tuple(", ".join(f"{key} = {value:g}" for key, value in p.items()) for p in corners)
        ts, n = np.array([self.system.t(p) for p in corners]), a.shape[1]
        return ErrorSystem(a, ts, np.eye(n), names, {"delta": n}, self.system.time)

    def stage(self, start: Any = None, *, noise: Any = None, density: Any = None) -> UnknownInputStage:
        """The observer as a stage that starts at an estimate, by default zeros; see ``UnknownInputStage``."""
        return UnknownInputStage(self, start, noise=noise, density=density)

    def simulated(self, plant: Any, setting: Setting) -> Simulation:
        """A plant whose scheduling variables may depend on its state, and the observer."""
        system = instance("plant", plant, ParameterVaryingSystem)
        known = self.system
        if system.c.shape != known.c.shape or system.time != known.time:
            raise ParameterError(
                f"the observer was designed for C of shape {known.c.shape} in {known.time} time, received a "
                f"plant of shape {system.c.shape} in {system.time} time",
                field="plant",
            )
        n, discrete = system.c.shape[1], system.time == "discrete"
        times, start = setting.samples(discrete), setting.begin(n)
        schedule = schedule_of(setting.schedule, self.box)
        width = matrices_at(system, schedule(float(times[0]), start))[1].shape[1]
        b, d = setting.signal("input", n), setting.signal("unknown_input", width)
        shake = setting.signal("disturbance", n)

        def field(t: float, x: FloatArray) -> FloatArray:
            a, f = matrices_at(system, schedule(t, x))
            change: FloatArray = a @ x + b(t) + f @ d(t) + shake(t)
            return change

        state = run(field, start, times, discrete)
        outputs = setting.measured(state @ system.c.T)
        running = self.stage(setting.begin(n, "estimate", 0.0))
        inputs, unknown = sampled(b, times), sampled(d, times)
        samples = zip(times.tolist(), outputs, inputs, strict=True)
        answers = [running.update(UnknownInputSample(t, y, u, partial(schedule, t))) for t, y, u in samples]
        estimate, found = np.array([one.x for one in answers]), np.array([one.d for one in answers])
        left: list[str] = []
        for t, true, x in zip(times.tolist(), state, estimate, strict=True):
            if names := self.box.outside(schedule(t, true)) or self.box.outside(schedule(t, x)):
                left.append(f"{', '.join(names)} at t = {t:g}")
        if left:
            warn(
                f"schedule leaves the box of the design at {len(left)} samples, first {left[0]}: what is "
                "proved of the error does not cover them",
                stacklevel=3,
            )
        return Simulation(
            times, state, estimate, outputs, inputs, tuple(f"x{i + 1}" for i in range(n)),
            "unknown-input observer", discrete, unknown, found,
        )  # fmt: skip

    def document(self) -> UnknownInputDocument:
        """Plant and box, a gain for each corner, and the matrices of Theorem 1.

        Raises ParameterError unless A and F are affine in each variable.
        """
        system, proof = self.system, self.certificate
        if not isinstance(system, CornerSystem) or system.box.bounds != self.box.bounds:
            system = CornerSystem.of(system, self.box)
        return UnknownInputDocument(
            plant=ParameterVaryingDocument.of(system),
            gains=self.gains.tolist(),
            decay=proof.decay,
            certificate=plain({"P": proof.P, "F": proof.force}),
            gap=finite(proof.gap),
        )

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


class UnknownInputDocument(Document, tag="unknown-input observer", frozen=True):
    """An ``UnknownInputObserver``."""

    plant: ParameterVaryingDocument
    gains: list[Rows]
    decay: float
    certificate: Values
    gap: float | None = None

    def made(self, functions: Functions) -> UnknownInputObserver:
        """The design, audited at every corner."""
        system = self.plant.made(functions)
        n, p = system.c.shape[1], len(system.c)
        values = matrices_of(self.certificate, {"P": (n, n), "F": (n, n)})
        gains = np.array([matrix("gains", one, n, p) for one in self.gains])
        return UnknownInputObserver.certified(
            system, system.box, gains, values["P"], values["F"], self.decay, gap_of(self.gap)
        )


def _refuse(box: Box, zeros: NDArray[np.complex128], decay: float, time: str) -> None:
    """Raise InfeasibleError, with the largest decay, if a zero reaches -decay.

    In discrete time if its modulus reaches exp(-decay).
    """
    most, discrete = largest_decay(zeros, time), time == "discrete"
    if decay < most:
        return
    sizes = np.abs(zeros) if discrete else zeros.real
    vertex = int(sizes.max(axis=1).argmax())
    value = number_text(zeros[vertex][sizes[vertex].argmax()])
    unit, of_zero, needed = "1/s", " 1/s", f"lie below -decay = {-decay:g} 1/s"
    if discrete:
        unit, of_zero, needed = "1/step", "", f"have a modulus below exp(-decay) = {exp(-decay):g}"
    end = f"the largest feasible decay is below {most:.6g} {unit}"
    if most <= 0.0:
        end = "no decay above 0 is feasible in this box"
    place = f"the invariant zero {value}{of_zero} at {box.corners[vertex]}"
    raise InfeasibleError(f"{place} must {needed}: {end}")
