"""Reduced-order observers: Upsilon chosen by the inequality of the theorem that certifies it."""

from __future__ import annotations

from typing import Any, ClassVar

import msgspec
import numpy as np

from pointpred.errors import (
    CertificateError,
    InfeasibleError,
    PointpredError,
    UndecidedError,
)
from pointpred.records import FloatArray
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage, like, same
from pointpred_observers.numerics.balance import Coordinates, balanced, inward, outward
from pointpred_observers.numerics.eigenvalues import require_detectable, vertices
from pointpred_observers.numerics.equalities import NO_DIGIT, TOLERANCE, without_rounding
from pointpred_observers.numerics.matrices import matrix, positive
from pointpred_observers.observer import Observer
from pointpred_observers.plants.entries import Functions, Values, finite, gap_of, matrices_of, plain
from pointpred_observers.plants.linear_systems import Plant, constant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.bounds import ErrorBound
from pointpred_observers.proofs.error_system import ErrorSystem
from pointpred_observers.proofs.search import WORSE, least_in_both, outward_all
from pointpred_observers.proofs.stationary import filter_start
from pointpred_observers.reduced_order.reversed_certificate import (
    Convergence,
    certified_convergence,
    certify_convergence,
)
from pointpred_observers.reduced_order.reversed_connection import (
    InvariantDocument,
    InvariantObserver,
)
from pointpred_observers.reduced_order.upsilon import InjectionSearch, Split, split
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting

TINY = 1e-300
GAMMAS = (1.0, 1e-2)
"""The gamma of Theorem 3.3.1 that are tried, as shares of the decay."""


class ReducedOrderObserver(Observer, msgspec.Struct, frozen=True):
    """A reduced-order observer, its Upsilon, and its certificate.

    ``gap``: how far the least size of Upsilon in balanced units could lie below that of this one, relative to
    it; infinite if nothing is proved, 0 where the equalities leave no choice.
    """

    kind: ClassVar[str] = "reduced"

    observer: InvariantObserver
    Upsilon: FloatArray
    certificate: Convergence
    gap: float = np.inf

    @property
    def plant(self) -> Persidskii:
        """The plant."""
        plant: Persidskii = self.observer.plant
        return plant

    @property
    def margins(self) -> dict[str, float]:
        """Those of Theorem 3.3.1, in discrete time 3.3.2."""
        return self.certificate.margins

    @property
    def bounds(self) -> dict[str, ErrorBound]:
        """The bound of w^ - (Pi x + Upsilon y)."""
        return {"error": self.certificate.bound}

    @property
    def lyapunov(self) -> dict[str, FloatArray]:
        """The P of the theorem."""
        return {"": self.certificate.values["P"]}

    @property
    def chosen(self) -> dict[str, FloatArray]:
        """Upsilon."""
        return {"Upsilon": self.Upsilon}

    @classmethod
    def design(cls, plant: Plant, *, Pi: Any = None, decay: float = 1.0) -> ReducedOrderObserver:
        """The reduced-order observer with Upsilon from the inequality, and its certificate.

        Assumes y = C0 x and constant matrices. The measured output enters f, f(J w + R y), so that every
        Upsilon is allowed and the problem is convex; for the thesis's J Z = H, which leaves few of them, give
        an Upsilon of your own to ``invariant_observer``.

        Continuous: the inequality of Theorem 3.3.1 with Xi = 2 ``decay`` P, linear in P, P Upsilon and W; of
        all Upsilon one with small Upsilon'P Upsilon. gamma is ``decay``, or, if none exists then, 1 % of it.
        The certificate is then computed separately.

        Parameters: ``Pi`` (n - p, n), by default a basis of the unmeasured part, and where rounding leaves
        the design undecided in it, one whose axes are those of a stationary filter; ``decay`` of the error in
        1/s (per step in discrete time), > 0. Raises InfeasibleError naming the undetectable mode, or the
        equality, or from the solver; UndecidedError; ParameterError.

        Reference: Khalin 2022, section 3.3.3, (3.33)-(3.40), Theorems 3.3.1 and 3.3.2.
        """
        plant, decay = constant(plant), positive("decay", decay)
        even = balanced(
            plant.A0,
            seen=plant.C0,
            driven=plant.A1,
            inner=plant.H,
            slopes=plant.slopes if plant.A1.any() and np.isfinite(plant.slopes or [np.inf]).all() else None,
            rates=(decay,),
            time=plant.time,
        )

        def attempt(units: Coordinates) -> ReducedOrderObserver:
            inner = _inward(plant, units)
            pi = _unmeasured(inner) / units.states if Pi is None else Pi
            parts = split(inner, matrix("Pi", pi, None, plant.n) * units.states)
            sloped = bool(parts.driven.any() or parts.shown.any())
            corners = vertices(plant.slopes) if sloped else {"": np.zeros((plant.k, plant.r))}
            for name, corner in corners.items():
                a = parts.drift + parts.driven @ corner @ parts.inner
                c = parts.seen + parts.shown @ corner @ parts.inner
                require_detectable(
                    a, c, plant.time, f"the unmeasured part{f' at D = diag({name})' if name else ''}"
                )

            def designed(basis: Any, gamma: float) -> ReducedOrderObserver:
                parts = split(inner, matrix("Pi", basis, None, plant.n) * units.states)
                chosen, gap, near = _chosen(plant, parts, sloped, (decay, 2.0 * decay + gamma), units is even)
                upsilon = chosen / units.outputs
                try:
                    observer = InvariantObserver(plant, basis, upsilon, injection=True)
                    certificate = certify_convergence(
                        observer, decay=decay, gamma=gamma, times=None, near=near
                    )
                except InfeasibleError as failure:
                    # The equalities and the inequality hold for this Upsilon, as its choice has shown.
                    raise UndecidedError(
                        f"decay = {decay:g} is too large for the arithmetic: Upsilon has entries of "
                        f"{np.abs(upsilon).max():.1g}, and in its rounding {failure}; require less decay"
                    ) from failure
                return cls(observer, upsilon, certificate, gap)

            turned = _turned(inner, decay) if Pi is None else None
            for share in GAMMAS:
                for basis in [pi] if turned is None else [pi, turned / units.states]:
                    try:
                        return designed(basis, share * decay)
                    except InfeasibleError as failure:
                        reason: PointpredError = failure
                        break
                    except (UndecidedError, CertificateError) as failure:
                        reason = failure
            raise reason

        def size(found: ReducedOrderObserver) -> list[float]:
            return [float(np.log(found.bound.overshoot)), float(np.log(np.linalg.norm(found.Upsilon) + TINY))]

        return least_in_both(even, attempt, size, WORSE)

    def error_system(self) -> ErrorSystem:
        """That of the observer without its certificate."""
        return self.observer.error_system()

    def stage(
        self, *, start: Any = None, step_s: float | None = None, gap_s: float | None = None
    ) -> PersidskiiStage:
        """Inputs are y, then u; it returns the plant's x; see ``InvariantObserver.stage``."""
        return self.observer.stage(start=start, step_s=step_s, gap_s=gap_s)

    def simulated(self, plant: Any, setting: Setting) -> Simulation:
        """The plant that nothing feeds back, with the bound that the certificate proves."""
        observer, one = self.observer, like(plant, self.plant)
        bound = np.zeros(0)
        proving = setting.silent and np.isinf(self.certificate.domain) and not observer.varying
        if proving and same(one, self.plant):
            observer.at(0.0).require_equalities()
            onto = observer.recovery(0.0)[0]
            x, x_hat = setting.begin(one.n), setting.begin(one.n, "estimate", 0.0)
            first = float(np.linalg.norm(observer.at(0.0).Z @ (x_hat - x)))
            times = setting.samples(one.time == "discrete")
            proved = np.array([self.bound(float(t - times[0]), first) for t in times])
            bound = np.linalg.norm(onto, 2) * proved
        return observer.simulated(one, setting, "reduced-order observer", bound)

    def document(self) -> ReducedOrderDocument:
        """The observer of constant maps, and the matrices of its certificate."""
        # The certificate needed the default tolerance, and so does the file.
        kept = self.observer.kept() | {"tolerance": min(self.observer.tolerance, TOLERANCE)}
        return ReducedOrderDocument(
            **kept,
            certificate=plain(self.certificate.values),
            certificate_gap=finite(self.certificate.gap),
            gap=finite(self.gap),
        )


class ReducedOrderDocument(InvariantDocument, tag="reduced-order observer", frozen=True, kw_only=True):
    """A ``ReducedOrderObserver``."""

    certificate: Values
    certificate_gap: float | None = None
    gap: float | None = None

    def made(self, functions: Functions) -> ReducedOrderObserver:
        """The observer, and its certificate audited."""
        if self.tolerance > TOLERANCE:
            raise CertificateError(
                f"tolerance is {self.tolerance:g}, but a certificate needs equalities that hold to "
                f"{TOLERANCE:g}: to run matrices that are rounded, make an invariant_observer",
                field="tolerance",
                value=self.tolerance,
            )
        observer: InvariantObserver = super().made(functions)
        q, discrete = observer.q, observer.plant.time == "discrete"
        shapes = dict.fromkeys(("P", "Xi", "Gamma" if discrete else "W"), (q, q))
        values = matrices_of(self.certificate, shapes, ("alpha" if discrete else "gamma",), optional=("W",))
        convergence = certified_convergence(observer, values, gap_of(self.certificate_gap, "certificate_gap"))
        return ReducedOrderObserver(observer, observer.chosen["Upsilon"], convergence, gap_of(self.gap))


def _turned(plant: Persidskii, decay: float) -> FloatArray | None:
    """The unmeasured part turned to the axes of the stationary filter's P, if there is a filter.

    A state that the outputs barely show is then a coordinate of its own, and no small difference of large
    numbers.
    """
    pi = _unmeasured(plant)
    parts = split(plant, pi)
    start = filter_start(parts.drift, parts.seen, decay, plant.time)
    if start is None:
        return None
    turned = np.linalg.eigh(start[0])[1].T @ pi
    return without_rounding(turned, np.ones_like(turned), share=NO_DIGIT)


def _inward(plant: Persidskii, units: Coordinates) -> Persidskii:
    """The plant with its states and outputs in these units; f, inputs and time keep theirs."""
    x, y = units.states, units.outputs
    return Persidskii(
        inward(plant.A0, x, x),
        plant.A1 / x[:, None],
        plant.H * x,
        plant.f,
        C0=inward(plant.C0, y, x),
        C1=plant.C1 / y[:, None],
        time=plant.time,
        domain=plant.domain,
    )


def _chosen(
    plant: Persidskii,
    parts: Split,
    sloped: bool,
    rates: tuple[float, float],
    balancing: bool,
) -> tuple[FloatArray, float, dict[str, Any]]:
    """Upsilon, its gap and its P, by balanced units or those of ``parts``; ``rates`` of e and of V."""
    units = balanced(
        parts.drift,
        seen=parts.seen,
        driven=parts.driven,
        shown=parts.shown,
        inner=parts.inner,
        slopes=plant.slopes if sloped else None,
        rates=rates[:1],
        time=plant.time,
    )

    def made(units: Coordinates) -> tuple[FloatArray, float, dict[str, Any]]:
        x, t, slopes = units.states, units.seconds, units.slopes(plant.slopes)
        corners = vertices(slopes) if sloped else {}
        choice = InjectionSearch(parts.inward(units), corners, slopes, plant.time, rates[1] * t)
        upsilon, gap, proof = choice.made()
        form = np.outer(x, x)
        return (
            outward(upsilon, x, units.outputs, t),
            gap,
            outward_all(proof, {"P": form, "W": t * form, "alpha": 1.0}),
        )

    return least_in_both(units, made) if balancing else made(units.plain)


def _unmeasured(plant: Persidskii) -> FloatArray:
    """An orthonormal basis of the null space of the output."""
    basis = np.linalg.svd(plant.C0)[2][plant.p :]
    return without_rounding(basis, np.ones_like(basis), share=NO_DIGIT)
