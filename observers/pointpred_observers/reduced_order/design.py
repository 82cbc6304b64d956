"""Reduced-order observers: Upsilon chosen by the inequality of the theorem that certifies it."""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from math import exp
from typing import Any, ClassVar

import msgspec
import numpy as np

from pointpred.errors import (
    CertificateError,
    InfeasibleError,
    ParameterError,
    PointpredError,
    UndecidedError,
)
from pointpred.records import FloatArray
from pointpred_observers.interconnected.design import symmetric
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage, like, same
from pointpred_observers.numerics.balance import Coordinates, balanced, inward, outward
from pointpred_observers.numerics.eigenvalues import require_detectable, vertices
from pointpred_observers.numerics.equalities import NO_DIGIT, TOLERANCE, cleared, without_rounding
from pointpred_observers.numerics.matrices import matrix, positive
from pointpred_observers.observer import Observer
from pointpred_observers.plants.entries import Functions, Values, finite, gap_of, matrices_of, plain
from pointpred_observers.plants.linear_systems import Plant, constant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.error_system import ErrorSystem
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import WORSE, cover, filter_start, least_in_both, middle
from pointpred_observers.reduced_order.reversed_certificate import (
    Convergence,
    Slopes,
    certified_convergence,
    certify_convergence,
    lipschitz,
)
from pointpred_observers.reduced_order.reversed_connection import (
    InvariantDocument,
    InvariantObserver,
)
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting

TINY = 1e-300
GAMMAS = (1.0, 1e-2)
"""The gamma of Theorem 3.3.1 that are tried, as shares of the decay."""


class ReducedOrderObserver(Observer, msgspec.Struct, frozen=True):
    """A reduced-order observer, its Upsilon, and its certificate, which bounds w^ - (Pi x + Upsilon y).

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
                chosen, gap = _chosen(plant, parts, sloped, (decay, 2.0 * decay + gamma), units is even)
                upsilon = chosen / units.outputs
                try:
                    observer = InvariantObserver(plant, basis, upsilon, injection=True)
                    certificate = certify_convergence(observer, decay=decay, gamma=gamma)
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


class Split(msgspec.Struct, frozen=True):
    """The plant in the coordinates (Pi x, y): the observer's matrices are affine in Upsilon.

    S0 = ``drift`` + Upsilon ``seen``, S1 = ``driven`` + Upsilon ``shown``, J = ``inner``.
    """

    drift: FloatArray
    seen: FloatArray
    driven: FloatArray
    shown: FloatArray
    inner: FloatArray

    def inward(self, units: Coordinates) -> Split:
        """The same in these units."""
        x, y, f, t = units.states, units.outputs, units.values, units.seconds
        return Split(
            inward(self.drift, x, x, t),
            inward(self.seen, y, x),
            inward(self.driven, x, f, t),
            inward(self.shown, y, f),
            inward(self.inner, units.arguments, x),
        )


def split(plant: Persidskii, Pi: Any) -> Split:
    """The plant with its outputs as coordinates; raises ParameterError where that is impossible."""
    if plant.C1.any():
        raise ParameterError("a reduced-order design needs y = C0 x, received C1 other than 0")
    q = plant.n - plant.p
    if q < 1:
        raise ParameterError(f"all {plant.n} states are measured by {plant.p} outputs: nothing to observe")
    pi = matrix("Pi", Pi, q, plant.n)
    both = np.vstack([pi, plant.C0])
    least = float(np.linalg.svd(both, compute_uv=False)[-1])
    if least <= 1e-9 * float(np.linalg.norm(both, 2)):
        raise ParameterError(
            f"the rows of Pi and C0 must be independent, their least singular value is {least:.3g}"
        )
    inverse = np.linalg.inv(both)
    inverse = without_rounding(inverse, np.abs(inverse) @ np.abs(both) @ np.abs(inverse), share=NO_DIGIT)
    hidden = inverse[:, :q]
    products = (pi, plant.A0, hidden), (plant.C0, plant.A0, hidden), (pi, plant.A1), (plant.C0, plant.A1)
    return Split(*(cleared(factors, share=NO_DIGIT) for factors in (*products, (plant.H, hidden))))


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
    plant: Persidskii, parts: Split, sloped: bool, rates: tuple[float, float], balancing: bool
) -> tuple[FloatArray, float]:
    """Upsilon and its gap, by balanced units or those of ``parts``; ``rates`` of e and of V."""
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

    def made(units: Coordinates) -> tuple[FloatArray, float]:
        x, t, slopes = units.states, units.seconds, units.slopes(plant.slopes)
        corners = vertices(slopes) if sloped else {}
        upsilon, gap = _injection(parts.inward(units), corners, slopes, plant.time, rates[1] * t)
        return outward(upsilon, x, units.outputs, t), gap

    return least_in_both(units, made) if balancing else made(units.plain)


def _injection(
    parts: Split, corners: dict[str, FloatArray], slopes: Slopes, time: str, rate: float
) -> tuple[FloatArray, float]:
    """An Upsilon with a small output injection, and the gap of its size.

    One P proves V' <= -``rate`` V (V+ <= exp(-``rate``) V in discrete time) at the ``corners`` of the slopes,
    none if f does not matter: an inequality that is linear in P and U = P Upsilon.
    """
    q, p = len(parts.drift), len(parts.seen)
    modes = [
        np.linalg.eigvals(parts.drift + parts.driven @ corner @ parts.inner)
        for corner in corners.values() or [np.zeros((parts.driven.shape[1], len(parts.inner)))]
    ]
    slowest, most = np.real(modes).max(), -0.5 * rate
    if time == "discrete":
        slowest, most = np.abs(modes).max(), exp(most)
    if slowest < most:
        with suppress(InfeasibleError, UndecidedError, CertificateError):
            _problem(parts, corners, slopes, time, rate, False).solve()
            return np.zeros((q, p)), 0.0
    problem = _problem(parts, corners, slopes, time, rate, True).number("size")
    problem.above(
        "size - U' P^-1 U", lambda v: np.block([[v.size * np.eye(p), v.U.T], [v.U, v.P]]), strict=False
    )
    solution = problem.solve(minimise=lambda v: v.size, near=_start(parts, corners, slopes, time, rate))
    upsilon = np.asarray(np.linalg.solve(solution.values["P"], solution.values["U"]))
    return upsilon, np.inf if solution.gap is None else solution.gap


def _start(
    parts: Split, corners: dict[str, FloatArray], slopes: Slopes, time: str, rate: float
) -> dict[str, Any] | None:
    """The matrices of the stationary filter at the middle of the slopes."""
    slope = np.zeros((parts.driven.shape[1], len(parts.drift)))
    if corners:
        slope = np.asarray(middle(slopes) @ parts.inner)
    start = filter_start(
        parts.drift + parts.driven @ slope, parts.seen + parts.shown @ slope, 0.5 * rate, time
    )
    if start is None:
        return None
    p, u = start
    values: dict[str, Any] = {"P": p, "U": -u, "size": 1.1 * np.linalg.norm(u.T @ np.linalg.solve(p, u), 2)}
    if time == "discrete":
        values["alpha"] = 1.0
    elif corners:
        values["W"] = cover(p @ parts.driven - u @ parts.shown, parts.inner, slopes)
    return values


def _problem(
    parts: Split, corners: dict[str, FloatArray], slopes: Slopes, time: str, rate: float, injected: bool
) -> MatrixInequalities:
    """Theorem 3.3.1 without delta, 2 sym(P S0) + 2 W + rate P < 0, or the LMI of Theorem 3.3.2."""
    q, k = parts.driven.shape
    problem = MatrixInequalities("choice of Upsilon" if injected else "analysis").positive("P", q)
    if injected:
        problem.free("U", q, len(parts.seen))

    def closed(v: Any, first: FloatArray, second: FloatArray) -> FloatArray:
        return np.asarray(v.P @ first + v.U @ second if injected else v.P @ first)

    def sector(v: Any, within: FloatArray) -> FloatArray:
        return np.asarray(v.W - symmetric(closed(v, parts.driven, parts.shown) @ within))

    def dissipation(v: Any) -> FloatArray:
        onward = 2.0 * symmetric(closed(v, parts.drift, parts.seen)) + rate * v.P
        return np.asarray(onward + 2.0 * v.W if corners else onward)

    if time == "continuous":
        if corners:
            problem.symmetric("W", q)
        for name, corner in corners.items():
            problem.above(
                f"W - sym(F D J), D = diag({name})",
                partial(sector, within=corner @ parts.inner),
                strict=False,
            )
        return problem.below("the inequality", dissipation)
    steepest, keep = lipschitz(slopes, parts.inner), exp(-rate)

    def block(v: Any) -> FloatArray:
        diagonal = np.zeros((q + k, q + k))
        diagonal[:q, :q] = v.alpha * steepest.T @ steepest - keep * v.P
        diagonal[q:, q:] = -v.alpha * np.eye(k)
        onward = np.hstack([closed(v, parts.drift, parts.seen), closed(v, parts.driven, parts.shown)])
        return np.block([[diagonal, onward.T], [onward, -v.P]])

    return problem.number("alpha").below("the LMI", block)


def _unmeasured(plant: Persidskii) -> FloatArray:
    """An orthonormal basis of the null space of the output."""
    basis = np.linalg.svd(plant.C0)[2][plant.p :]
    return without_rounding(basis, np.ones_like(basis), share=NO_DIGIT)
