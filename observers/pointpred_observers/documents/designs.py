"""Designs as JSON: the matrices, from which every bound and every margin is computed again on reading."""

from __future__ import annotations

from typing import Any, Self

import msgspec
import numpy as np

from pointpred.errors import CertificateError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.bounds import ErrorBound
from pointpred_observers.documents.entries import (
    Document,
    Functions,
    Rows,
    entries,
    finite,
    gap_of,
)
from pointpred_observers.documents.plants import (
    GeneratorDocument,
    ParameterVaryingDocument,
    PlantDocument,
)
from pointpred_observers.documents.symbolic_plants import SteadyStateDocument
from pointpred_observers.equalities import TOLERANCE, share_of_terms
from pointpred_observers.error_systems.decay import certified_decay
from pointpred_observers.interconnected.design import ObserverDesign, certified_design, require_map
from pointpred_observers.interconnected.generator import Fitted, require_same_nonlinearity
from pointpred_observers.interconnected.regulator import RegulatorDesign
from pointpred_observers.interconnected.regulator_equations import (
    RegulatorEquations,
    checked_equations,
)
from pointpred_observers.interconnected.state_feedback import StateFeedback, closed_system
from pointpred_observers.matrices import matrix
from pointpred_observers.persidskii import Persidskii
from pointpred_observers.reduced_order.design import ReducedOrderDesign
from pointpred_observers.reduced_order.reversed_certificate import certified_convergence
from pointpred_observers.reduced_order.reversed_connection import (
    InvariantObserver,
    invariant_observer,
)
from pointpred_observers.triangular.interlaced_certificate import InterlacedCertificate, theorem_4_4_1
from pointpred_observers.triangular.interlaced_certificate import certificate as interlaced_certificate
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver, output_matrix
from pointpred_observers.unknown_input.corners import CornerSystem
from pointpred_observers.unknown_input.observer import UnknownInputObserver

Values = dict[str, Rows | float]
"""Matrices of a certificate by their names in the theorem."""


class ObserverDocument(Document, tag="observer", frozen=True):
    """An ``ObserverDesign``: plant, generator, map, gain, and the matrices of Theorem 3.2.1."""

    plant: PlantDocument
    generator: GeneratorDocument
    Pi: Rows
    gain: Rows
    certificate: Values
    gap: float | None = None

    @classmethod
    def of(cls, thing: ObserverDesign) -> Self:
        """The document of a design."""
        values = {name: one for name, one in thing.values.items() if name != "U"}
        return cls(
            plant=PlantDocument.of(thing.plant),
            generator=GeneratorDocument.of(thing.generator),
            Pi=entries(thing.Pi),
            gain=entries(thing.gain),
            certificate=_plain(values),
            gap=finite(thing.gap),
        )

    def made(self, functions: Functions) -> ObserverDesign:
        """The design, audited."""
        plant, generator = self.plant.made(functions), self.generator.made(functions)
        q, p = generator.q, plant.p
        shapes = {"P": (q, q), "Theta": (q, q), "Gamma": (p, p), "Xi": (q, q), "W": (q, q)}
        values = _matrices(self.certificate, shapes, optional=("W",))
        return certified_design(plant, generator, self.Pi, self.gain, values, gap_of(self.gap))


class ReducedOrderDocument(Document, tag="reduced-order observer", frozen=True):
    """A ``ReducedOrderDesign``, or an ``InvariantObserver`` where there is no certificate."""

    plant: PlantDocument
    Pi: Rows
    tolerance: float
    Upsilon: Rows | None = None
    B: Rows | None = None
    injection: bool = False
    certificate: Values | None = None
    certificate_gap: float | None = None
    gap: float | None = None

    @classmethod
    def of(cls, thing: ReducedOrderDesign | InvariantObserver) -> Self:
        """The document of an observer with constant maps."""
        observer = thing.observer if isinstance(thing, ReducedOrderDesign) else thing
        given = {name: observer.given(name) for name in ("Pi", "Upsilon", "B")}
        if moving := [name for name, one in given.items() if callable(one)]:
            raise ParameterError(
                f"an observer whose {', '.join(moving)} vary cannot be saved: save the plant, and make the "
                "observer again with invariant_observer"
            )
        certificate = thing.certificate if isinstance(thing, ReducedOrderDesign) else None
        return cls(
            plant=PlantDocument.of(observer.plant),
            Pi=entries(matrix("Pi", given["Pi"], None, observer.plant.n)),
            Upsilon=entries(
                matrix("Upsilon", given["Upsilon"], observer.q) if np.size(given["Upsilon"]) else []
            ),
            B=None if given["B"] is None else entries(matrix("B", given["B"], observer.q)),
            injection=bool(observer.injection),
            # Its certificate needed the default, and so does the file.
            tolerance=observer.tolerance if certificate is None else min(observer.tolerance, TOLERANCE),
            certificate=None if certificate is None else _plain(certificate.values),
            certificate_gap=None if certificate is None else finite(certificate.gap),
            gap=finite(thing.gap) if isinstance(thing, ReducedOrderDesign) else None,
        )

    def made(self, functions: Functions) -> ReducedOrderDesign | InvariantObserver:
        """The observer, and its certificate audited."""
        if self.certificate is not None and self.tolerance > TOLERANCE:
            raise CertificateError(
                f"tolerance is {self.tolerance:g}, but a certificate needs equalities that hold to "
                f"{TOLERANCE:g}: leave out the certificate to run matrices that are rounded, or design again",
                field="tolerance",
                value=self.tolerance,
            )
        observer = invariant_observer(
            self.plant.made(functions),
            self.Pi,
            self.Upsilon,
            B=self.B,
            injection=self.injection,
            tolerance=self.tolerance,
        )
        if self.certificate is None:
            return observer
        q, discrete = observer.q, observer.plant.time == "discrete"
        shapes = dict.fromkeys(("P", "Xi", "Gamma" if discrete else "W"), (q, q))
        values = _matrices(self.certificate, shapes, ("alpha" if discrete else "gamma",), optional=("W",))
        convergence = certified_convergence(observer, values, gap_of(self.certificate_gap, "certificate_gap"))
        upsilon = (
            np.zeros((q, observer.plant.p)) if self.Upsilon is None else matrix("Upsilon", self.Upsilon, q)
        )
        return ReducedOrderDesign(observer, upsilon, convergence, gap_of(self.gap))


class Feedback(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A ``StateFeedback``: u = L0 x + L1 f(Hx), and what proves its decay."""

    L0: Rows
    L1: Rows | None
    decay: float
    certificate: Values


class Equations(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """``RegulatorEquations``: the matrices, of which everything else is computed again."""

    Pi: Rows
    L0: Rows
    L1: Rows | None
    R: Rows
    F: Rows


class RegulatorDocument(Document, tag="regulator", frozen=True):
    """A ``RegulatorDesign``: its observer with the plant, its feedback, and the regulator with its map."""

    observer: ObserverDocument
    regulator: GeneratorDocument
    Pi: Rows
    plant: PlantDocument
    feedback: Feedback
    equations: Equations | None = None

    @classmethod
    def of(cls, thing: RegulatorDesign) -> Self:
        """The document of a design."""
        feedback, solved = thing.feedback, thing.equations
        return cls(
            observer=ObserverDocument.of(thing.observer),
            regulator=GeneratorDocument.of(thing.regulator),
            Pi=entries(thing.Pi),
            plant=PlantDocument.of(thing.plant),
            feedback=Feedback(
                L0=entries(feedback.L0),
                L1=entries(feedback.L1),
                decay=feedback.certificate.bound.decay,
                certificate=_plain(feedback.certificate.values),
            ),
            equations=None
            if solved is None
            else Equations(
                Pi=entries(solved.Pi),
                L0=entries(solved.L0),
                L1=entries(solved.L1),
                R=entries(solved.R),
                F=entries(solved.F),
            ),
        )

    def made(self, functions: Functions) -> RegulatorDesign:
        """The design: both proofs audited, and whether the regulator is the one that they speak of."""
        plant, regulator = self.plant.made(functions), self.regulator.made(functions)
        observer, pi = self.observer.made(functions), matrix("Pi", self.Pi, plant.n, regulator.q)
        _require_plant(observer, plant)
        require_same_nonlinearity(plant, regulator, pi, "regulator")
        require_map(plant, regulator, pi)
        l0 = matrix("L0", self.feedback.L0, plant.m, plant.n)
        l1 = (
            np.zeros((plant.m, plant.k))
            if self.feedback.L1 is None
            else matrix("L1", self.feedback.L1, plant.m)
        )
        g = regulator.beside(plant)
        own = {"G": (g.G[: plant.n], observer.gain), "L0": (g.L0[:, : plant.n], l0), "L1": (g.L1, l1)}
        for name, (left, right) in own.items():
            if not np.array_equal(left, right):
                raise CertificateError(
                    f"{name} of the regulator is not the {name} that was certified", field=name
                )
        system = closed_system(plant, l0, l1)
        numbers = tuple(f"bound_{i}" for i in range(len(system.disturbances)))
        values = _matrices(self.feedback.certificate, {"P": (plant.n, plant.n)}, numbers)
        proof = certified_decay(system, values, self.feedback.decay)
        return RegulatorDesign(
            plant, regulator, pi, observer, StateFeedback(l0, l1, proof), self._equations(plant, g, l0)
        )

    def _equations(self, plant: Persidskii, g: Fitted, l0: FloatArray) -> RegulatorEquations | None:
        """The equations, checked: the reference's states are the last ones of the regulator."""
        solved = self.equations
        if solved is None:
            return None
        s0 = g.S0[plant.n :, plant.n :]
        l1 = np.zeros((plant.m, plant.k)) if solved.L1 is None else solved.L1
        checked = checked_equations(plant, s0, solved.Pi, solved.L0, l1, solved.R, solved.F)
        straight = g.L0[:, plant.n :]
        terms = np.abs(straight) + np.abs(checked.L0) + np.abs(l0) @ np.abs(checked.Pi)
        if not share_of_terms(straight - checked.L0 + l0 @ checked.Pi, terms) <= TOLERANCE:
            raise CertificateError(
                "L0 of the regulator does not apply the L0 and Pi of its equations: design it again",
                field="equations.L0",
            )
        return checked


def _require_plant(observer: ObserverDesign, plant: Persidskii) -> None:
    """Raise CertificateError unless the observer estimates the states of this very plant."""
    own, ours = observer.plant.matrices(0.0), plant.matrices(0.0)
    different = [name for name in own if not np.array_equal(own[name], ours[name])]
    settings = ("time", "domain", "slopes")
    different += [name for name in settings if getattr(observer.plant, name) != getattr(plant, name)]
    if observer.plant.f.codes != plant.f.codes:
        different.append("f")
    if not np.array_equal(observer.Pi, np.eye(plant.n)):
        raise CertificateError(
            "the observer's Pi is not the identity: a regulator's observer estimates the plant's own states",
            field="observer.Pi",
        )
    if different:
        raise CertificateError(
            f"{different[0]} of observer.plant is not the {different[0]} of plant: both must be the plant "
            "that the regulator was designed for, design it again",
            field=f"observer.plant.{different[0]}",
        )


class UnknownInputDocument(Document, tag="unknown-input observer", frozen=True):
    """An ``UnknownInputObserver``: plant and box, a gain for each corner, and the matrices of Theorem 1."""

    plant: ParameterVaryingDocument
    gains: list[Rows]
    sigma: float
    certificate: Values
    gap: float | None = None

    @classmethod
    def of(cls, thing: UnknownInputObserver) -> Self:
        """The document of a design, whose A and F must be affine in each variable."""
        system, proof = thing.system, thing.certificate
        if not isinstance(system, CornerSystem) or system.box.bounds != thing.box.bounds:
            system = CornerSystem.of(system, thing.box)
        if proof.force is None:
            raise ParameterError(
                "the certificate lacks the matrix F of the theorem: design the observer again"
            )
        return cls(
            plant=ParameterVaryingDocument.of(system),
            gains=thing.gains.matrices.tolist(),
            sigma=proof.sigma,
            certificate=_plain({"P": proof.p, "F": proof.force}),
            gap=finite(proof.gap),
        )

    def made(self, functions: Functions) -> UnknownInputObserver:
        """The design, audited at every corner."""
        system = self.plant.made(functions)
        n, p = system.c.shape[1], len(system.c)
        values = _matrices(self.certificate, {"P": (n, n), "F": (n, n)})
        gains = np.array([matrix("gains", one, n, p) for one in self.gains])
        return UnknownInputObserver.certified(
            system, system.box, gains, values["P"], values["F"], self.sigma, gap_of(self.gap)
        )


class InterlacedDocument(Document, tag="interlaced observer", frozen=True):
    """An ``InterlacedObserver``: the steady state, and the matrices of Theorem 4.4.1."""

    steady: SteadyStateDocument
    certificate: Values
    start: list[float]
    gap_s: float | None = None
    gap: float | None = None

    @classmethod
    def of(cls, thing: InterlacedObserver) -> Self:
        """The document of an observer; its memory of samples is not kept."""
        proof = thing.certificate
        return cls(
            steady=SteadyStateDocument.of(thing.steady),
            certificate=_plain({name: getattr(proof, name) for name in ("P", "Q", "Gamma", "U")}),
            gap=finite(proof.gap),
            start=thing.start.tolist(),
            gap_s=thing.gap_s,
        )

    def made(self, functions: Functions) -> InterlacedObserver:
        """The observer: the equations of its maps and its inequalities audited."""
        steady = self.steady.made(functions)
        a, c = steady.generator.matrix(), output_matrix(steady)
        q, p = len(a), len(c)
        values = _matrices(self.certificate, {"P": (q, q), "Q": (q, q), "Gamma": (p, p), "U": (q, p)})
        proof = interlaced_certificate(values, theorem_4_4_1(a, c).check(values), gap_of(self.gap))
        return InterlacedObserver(steady, proof, start=self.start, gap_s=self.gap_s)


def margins_of(thing: Any) -> dict[str, float]:
    """How far each audited inequality of a design holds; none for what has no certificate."""
    if isinstance(thing, RegulatorDesign):
        parts = {"observer": thing.observer.margins, "feedback": thing.feedback.certificate.margins}
        return {f"{part}: {name}": one for part, each in parts.items() for name, one in each.items()}
    if isinstance(thing, UnknownInputObserver):
        return {"(27c)": thing.certificate.margin}
    proof = getattr(thing, "certificate", thing)
    return dict(getattr(proof, "margins", {}))


def bounds_of(thing: Any) -> list[ErrorBound]:
    """The bounds of the error that a design carries; none for what has no such bound."""
    if isinstance(thing, RegulatorDesign):
        return [thing.observer.bound, thing.feedback.certificate.bound]
    proof = getattr(thing, "certificate", thing)
    if isinstance(proof, InterlacedCertificate):
        return [ErrorBound(proof.overshoot, proof.rate, (proof.noise_gain,), ("noise",))]
    bound = getattr(proof, "bound", None)
    return [bound] if isinstance(bound, ErrorBound) else []


def _plain(values: dict[str, Any]) -> Values:
    """Matrices as lists, numbers as they are."""
    return {name: float(one) if np.ndim(one) == 0 else entries(one) for name, one in values.items()}


def _matrices(
    values: Values,
    shapes: dict[str, tuple[int, int]],
    numbers: tuple[str, ...] = (),
    *,
    optional: tuple[str, ...] = (),
) -> dict[str, Any]:
    """The matrices of a certificate in their shapes; raises ParameterError for a missing or unknown one."""
    known = (*shapes, *numbers)
    if unknown := [name for name in values if name not in known]:
        raise ParameterError(f"certificate: {unknown[0]} is not known, it may hold {', '.join(known)}")
    if missing := [name for name in known if name not in values and name not in optional]:
        raise ParameterError(f"certificate: {missing[0]} is missing, it needs {', '.join(known)}")
    found: dict[str, Any] = {}
    for name, one in values.items():
        if name in numbers:
            if not isinstance(one, float):
                raise ParameterError(f"certificate: {name} must be a number, received a matrix")
            found[name] = one
        else:
            found[name] = matrix(f"certificate: {name}", one, *shapes[name])
    return found
