"""Tracking control: assumptions 3.2.3 to 3.2.6, theorems 3.2.2 and 3.2.3, for a regulator and its plant.

A motion that grows although f is a matrix of slopes excludes every choice of an assumption's matrices.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Self

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.steady_state import equalities, shares_left
from pointpred_observers.numerics.balance import Coordinates, balanced, inward
from pointpred_observers.numerics.eigenvalues import number_text
from pointpred_observers.numerics.equalities import TOLERANCE, largest
from pointpred_observers.numerics.matrices import instance, matrix, share, vector
from pointpred_observers.plants.generator import Fitted, Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, as_plant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities, Solution
from pointpred_observers.proofs.search import Posed, search

ComplexArray = NDArray[np.complex128]

CLOSE = 1e6
"""How much faster the motion must grow than the rounding of its derivative: a proof for P up to 1e12."""
TURNS: FloatArray = np.radians([0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 89.0])
"""Angles of the slopes that are tried, in rad."""
STARTS = 4
"""Slopes from where they are improved, beside zero."""


class GrowingMode(msgspec.Struct, frozen=True):
    """x exp(s t) with f = D H x exp(s t), ``value`` = D H x: x' = (a + b D H) x = s x, real part of s > 0.

    ``slopes`` is the diagonal of D; complex slopes turn f by a part of a period against its argument.
    ``share``: the real part of s beside the size of a + b D H.
    """

    state: ComplexArray
    value: ComplexArray
    slopes: ComplexArray
    eigenvalue: complex
    share: float


Admitted = Callable[[GrowingMode], bool]
Candidates = tuple[FloatArray, ComplexArray]
"""Slopes of one component that are tried: real ones, and others if none of them does."""


def growing_mode(
    a: FloatArray, b: FloatArray, h: FloatArray, candidates: list[Candidates], admitted: Admitted
) -> GrowingMode | None:
    """A growing motion of x' = a x + b f, f = D h x, with D of the ``candidates`` for each component.

    ``admitted`` says which motions exclude the matrices of the theorem. The slopes are searched component
    by component for the largest growth beside the size of a + b D h, real ones first. That none is found
    proves nothing.
    """
    k, best = len(candidates), None
    for each in ([one[i] for one in candidates] for i in range(2)):
        random = np.random.default_rng(0)
        starts: list[Any] = [np.array([one[0] for one in each])]
        starts += [np.array([random.choice(one) for one in each]) for _ in range(STARTS if k > 1 else 0)]
        for slopes in starts:
            for i in [*range(k), *range(k)] if k > 1 else range(1):
                tried = np.tile(slopes, (len(each[i]) if k else 1, 1))
                if k:
                    tried[:, i] = each[i]
                slopes, mode = _fastest(a, b, h, tried, admitted)
                if mode is not None and (best is None or mode.share > best.share):
                    best = mode
        if best is not None:
            break
    return best


def quadrant(unit: float) -> Candidates:
    """Slopes d with Re(d) >= 0 and Im(d) >= 0, of sizes around ``unit``: the real ones, then all."""
    sizes = np.concatenate([[0.0], unit * np.logspace(-4.0, 6.0, 41)])
    return sizes, np.outer(sizes, np.exp(1j * TURNS)).ravel()


def _fastest(
    a: FloatArray, b: FloatArray, h: FloatArray, tried: Any, admitted: Admitted
) -> tuple[Any, GrowingMode | None]:
    """Of all rows of ``tried`` the one with the largest share of growth, and the best admitted motion."""
    whole = a + (b * tried[:, None, :]) @ h
    values, vectors = np.linalg.eig(whole)
    shares = values.real / np.maximum(np.linalg.norm(whole, axis=(1, 2)), 1e-300)[:, None]
    order = [np.unravel_index(place, shares.shape) for place in np.argsort(-shares, axis=None)]
    for i, j in order:
        if shares[i, j] <= 0.0:
            break
        x, s = vectors[i, :, j], complex(values[i, j])
        f = tried[i] * (h @ x)
        # Re x*P x' = Re(s) x*P x + Re x*P r with the residual r = a x + b f - s x, and abs(x*P r) is at most
        # sqrt(condition number of P) abs(r) / abs(x) times x*P x. The rounding of r counts as well.
        residual = np.abs(a @ x + b @ f - s * x) + rounding((a, x), (b, f))
        mode = GrowingMode(x, f, tried[i], s, float(shares[i, j]))
        if s.real * np.linalg.norm(x) > CLOSE * np.linalg.norm(residual) and admitted(mode):
            return tried[i], mode
    return tried[order[0][0]], None


def rounding(*products: tuple[FloatArray, ComplexArray]) -> FloatArray:
    """The largest error of a sum of matrices times vectors, by component."""
    terms = sum(np.abs(matrix) @ np.abs(vector) for matrix, vector in products)
    length = sum(len(vector) for _, vector in products) + 2
    return np.asarray(length * np.finfo(np.float64).eps * terms, np.float64)


class SectorBounds(msgspec.Struct, frozen=True):
    """The constants of Assumption 3.2.4: ``Sigma1``, ``Psi1`` (n, n), the others diagonal (k, k)."""

    Sigma1: FloatArray
    Psi1: FloatArray
    Sigma2: FloatArray
    Sigma3: FloatArray
    Sigma4: FloatArray
    Psi2: FloatArray


def sector_bounds(plant: Plant, **values: Any) -> SectorBounds:
    """The constants that slopes of at most b_j imply, Sigma1 = Psi1 = H' diag(b^2) H, or those passed.

    Raises ParameterError where slopes are missing, unbounded or negative (Assumption 3.2.5 needs an f that
    increases), CertificateError where the passed Sigma1 or Psi1 lie below those that the slopes imply: to
    lie above is sufficient for Assumption 3.2.4, and necessary where the other constants are zero and the
    slopes are reached.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii(-np.eye(2), [0.0, 1.0], [0.0, 2.0], "tanh")
    >>> sector_bounds(plant).Sigma1.tolist()
    [[0.0, 0.0], [0.0, 4.0]]
    """
    plant = as_plant(plant)
    slopes = np.array(plant.slopes if plant.slopes is not None else [], np.float64).reshape(-1, 2)
    if len(slopes) != plant.k or not np.isfinite(slopes).all():
        raise ParameterError(f"Assumption 3.2.4 needs bounded slopes, received {plant.slopes}")
    if (slopes < 0.0).any():
        raise ParameterError(
            f"Assumption 3.2.5 needs an f that increases, received slopes {plant.slopes}: give those of a "
            "domain on which it does"
        )
    least: FloatArray = plant.H.T @ np.diag(slopes[:, 1] ** 2) @ plant.H
    none = np.zeros((plant.k, plant.k))
    constants = dict.fromkeys(SectorBounds.__struct_fields__, none) | {"Sigma1": least, "Psi1": least}
    if set(values) - set(constants):
        raise ParameterError(f"the constants are {', '.join(constants)}, received {', '.join(values)}")
    constants |= {name: matrix(name, one, *constants[name].shape) for name, one in values.items()}
    for name in ("Sigma1", "Psi1"):
        below = float(np.linalg.eigvalsh(constants[name] - least).min())
        if below < -1e-9 * max(1.0, float(np.abs(least).max(initial=0.0))):
            raise CertificateError(
                f"Assumption 3.2.4: {name} - H' diag(b^2) H has the eigenvalue {below:.6g}, must be >= 0"
            )
    return SectorBounds(**constants)


class Loop(msgspec.Struct, frozen=True):
    """x' = ``a`` x + ``b`` f(``h`` x) + disturbances, of which an assumption speaks."""

    a: FloatArray
    b: FloatArray
    h: FloatArray

    def inward(self, units: Coordinates) -> Self:
        """The same matrices in these units."""
        x, f, t = units.states, units.values, units.seconds
        return msgspec.structs.replace(
            self,
            a=inward(self.a, x, x, t),
            b=inward(self.b, x, f, t),
            h=inward(self.h, units.arguments, x),
        )

    def inequalities(self) -> MatrixInequalities:
        """Those of the assumption, with the conditions of its theorem."""
        raise NotImplementedError

    def growing(self) -> tuple[str, GrowingMode | None]:
        """A motion that excludes every choice, if one is found, and the matrix that has it."""
        raise NotImplementedError

    def found(self, units: Coordinates) -> Solution:
        """Matrices that satisfy the inequalities, found in balanced units and audited in the plant's."""

        def posed(units: Coordinates) -> Posed:
            form, t = np.outer(units.states, units.states), units.seconds
            rates = dict.fromkeys(("gamma1", "gamma2", "Omega", "Omega1", "Omega2", "Upsilon"), t)
            measured = {"P": form, "Gamma": form / t, "Xi": t * form, "Lambda": 1.0, **rates}
            return Posed(self.inward(units).inequalities(), measured)

        def audited(values: dict[str, Any], _: float) -> Solution:
            return Solution(values, self.inequalities().check(values, printed=False))

        return search(units, posed, audited)


class Regulated(Loop, frozen=True):
    """The regulator with the plant on its steady state: a = S0 + G C0 Pi, b = S1 + G C1, h = J = H Pi."""

    @classmethod
    def of(cls, plant: Persidskii, g: Fitted, pi: FloatArray) -> Regulated:
        """The matrices of Assumption 3.2.3."""
        return cls(g.S0 + g.G @ plant.C0 @ pi, g.S1 + g.G @ plant.C1, plant.H @ pi)

    def inequalities(self) -> MatrixInequalities:
        """Assumption 3.2.3 with the condition of Theorem 3.2.2."""
        s, tilde, j = self.a, self.b, self.h
        q, k = tilde.shape
        problem = MatrixInequalities("Assumption 3.2.3").positive("P", q).symmetric("Gamma", q)
        problem.symmetric("Xi", q).diagonal("Omega", k).diagonal("Lambda", k)

        def block(v: Any) -> FloatArray:
            upper = s.T @ v.P + v.P @ s + v.Xi
            across = v.P @ tilde + s.T @ j.T @ v.Lambda + j.T @ v.Omega
            middle = tilde.T @ j.T @ v.Lambda + v.Lambda @ j @ tilde
            lift, none = j.T @ v.Lambda, np.zeros((q, q))
            return np.block(
                [
                    [upper, across, v.P, v.P],
                    [across.T, middle, lift.T, lift.T],
                    [v.P, lift, -v.Gamma, none],
                    [v.P, lift, none, -v.Gamma],
                ]
            )

        problem.below("Phi", block, strict=False).above("Gamma > 0", lambda v: v.Gamma)
        problem.above("Xi", lambda v: v.Xi, strict=False)
        return problem.above("Xi + J' Omega J", lambda v: v.Xi + j.T @ v.Omega @ j)

    def growing(self) -> tuple[str, GrowingMode | None]:
        """With v = (x, f, 0, 0) and f = D J x, v*Phi v is a sum of terms that are not negative.

        2 Re x*P x', x*Xi x, and the components of 2 Re f*Lambda J x' and of 2 Re f*Omega J x.
        """

        def admitted(mode: GrowingMode) -> bool:
            x, f = mode.state, mode.value
            speed = self.a @ x + self.b @ f
            error = np.abs(self.h) @ rounding((self.a, x), (self.b, f)) + rounding((self.h, speed))
            return _agree(f, self.h @ speed, error) and _agree(f, self.h @ x, rounding((self.h, x)))

        effect = float(np.linalg.norm(self.b) * np.linalg.norm(self.h))
        slopes = [quadrant(float(np.linalg.norm(self.a)) / effect if effect > 0.0 else 1.0)] * len(self.h)
        return "S + S~ D J", growing_mode(self.a, self.b, self.h, slopes, admitted)


class Followed(Loop, frozen=True):
    """The tracking error x - Pi w, whose f is f(Jw + h z) - f(Jw): a = A0 - Pi G C0, b = A1 - Pi G C1.

    ``sector`` holds the constants of Assumption 3.2.4.
    """

    sector: SectorBounds

    @classmethod
    def of(cls, plant: Persidskii, g: Fitted, pi: FloatArray, sector: SectorBounds) -> Followed:
        """The matrices of Assumption 3.2.6."""
        return cls(plant.A0 - pi @ g.G @ plant.C0, plant.A1 - pi @ g.G @ plant.C1, plant.H, sector)

    def inequalities(self) -> MatrixInequalities:
        """Assumption 3.2.6 with the conditions of Theorem 3.2.3."""
        a0, a1, h, bound = self.a, self.b, self.h, self.sector
        n, k = a1.shape
        problem = MatrixInequalities("Assumption 3.2.6").positive("P", n).symmetric("Gamma", n)
        problem.symmetric("Xi", n).number("gamma1").number("gamma2")
        for name in ("Lambda", "Omega1", "Omega2", "Upsilon"):
            problem.diagonal(name, k)

        def block(v: Any) -> FloatArray:
            first = a0.T @ h.T @ v.Lambda + h.T @ v.Omega1
            second = v.P @ a1 + h.T @ v.Omega2
            third = v.Lambda @ h @ a1 + v.Upsilon
            lift, none = v.Lambda @ h, np.zeros((k, n))
            return np.block(
                [
                    [a0.T @ v.P + v.P @ a0 + v.Xi, first, second, v.P],
                    [first.T, -v.gamma1 * np.eye(k), third, lift],
                    [second.T, third.T, -v.gamma2 * np.eye(k), none],
                    [v.P, lift.T, none.T, -v.Gamma],
                ]
            )

        conditions: dict[str, Callable[[Any], FloatArray]] = {
            "Xi": lambda v: v.Xi,
            "R1": lambda v: v.Xi - v.gamma1 * bound.Sigma1 - v.gamma2 * bound.Psi1,
            "R2": lambda v: v.Omega1 - v.gamma1 * bound.Sigma2 - v.gamma2 * bound.Psi2,
            "R3": lambda v: v.Omega2 - v.gamma1 * bound.Sigma3,
            "R4": lambda v: v.Upsilon - v.gamma1 * bound.Sigma4,
        }
        problem.below("Phi", block, strict=False).above("Gamma > 0", lambda v: v.Gamma)
        for name, left in conditions.items():
            problem.above(name, left, strict=False)
        r1, r2, r3 = (conditions[name] for name in ("R1", "R2", "R3"))
        return problem.above("R1 + H'(R2 + R3) H", lambda v: r1(v) + h.T @ (r2(v) + r3(v)) @ h)

    def growing(self) -> tuple[str, GrowingMode | None]:
        """With v = (x, 0, f, 0) and f = D H x, v*Phi v is a sum of terms that are not negative.

        2 Re x*P x', x*R1 x, 2 Re x*H'R3 f, gamma1 (x*Sigma1 x + 2 Re x*H'Sigma3 f), gamma2 (x*Psi1 x - f*f).
        """
        bound = self.sector

        def admitted(mode: GrowingMode) -> bool:
            x, f, argument = mode.state, mode.value, self.h @ mode.state
            first = float((x.conj() @ bound.Sigma1 @ x + 2.0 * argument.conj() @ bound.Sigma3 @ f).real)
            second = float((x.conj() @ bound.Psi1 @ x - f.conj() @ f).real)
            return first >= 0.0 and second >= 0.0 and _agree(f, argument, rounding((self.h, x)))

        slopes = []
        for row in self.h:
            onto = np.linalg.pinv(bound.Psi1) @ row
            near = 1e-9 * float(np.abs(row).max(initial=0.0))
            within = np.allclose(bound.Psi1 @ onto, row, rtol=0.0, atol=near) and row @ onto > 0.0
            # Up to the largest d with d^2 row' row <= Psi1; Re(d) >= 0 keeps the sign of f.
            steepest = 1.0 / float(np.sqrt(row @ onto)) if within else 0.0
            sizes: FloatArray = 0.999999 * steepest * np.arange(11.0) / 10.0
            back = np.outer(sizes[1:], np.exp(-1j * TURNS[1:])).ravel()
            slopes.append((sizes, np.concatenate([np.outer(sizes, np.exp(1j * TURNS)).ravel(), back])))
        return "A~0 + A~1 D H", growing_mode(self.a, self.b, self.h, slopes, admitted)

    def inward(self, units: Coordinates) -> Self:
        """The same matrices in these units; gamma1 weighs the components of f alike."""
        x = units.states
        forms = {name: getattr(self.sector, name) * x * x[:, None] for name in ("Sigma1", "Psi1")}
        sector = msgspec.structs.replace(self.sector, **forms)
        return msgspec.structs.replace(super().inward(units), sector=sector)


def _agree(f: ComplexArray, other: ComplexArray, error: FloatArray) -> bool:
    """Whether no component of Re f* other lies below 0, for every ``other`` within this error."""
    return bool(((f.conj() * other).real >= np.abs(f) * error).all())


class TrackingCertificate(msgspec.Struct, frozen=True):
    """Both theorems: the ``regulator`` is ISS (3.2.2) and so is the ``error`` z = x - Pi w (3.2.3).

    Local if the slopes hold on a ``domain`` only: abs(Jw), abs(Hz) and abs(Jw + Hz) must stay below it.
    """

    regulator: Solution
    error: Solution
    margins: dict[str, float]
    domain: float


def theorem_3_2_2(plant: Plant, regulator: Generator, Pi: Any) -> MatrixInequalities:
    """Assumption 3.2.3 with the condition of Theorem 3.2.2: the regulator is ISS with respect to z, w and v.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Omega, Lambda >= 0; S = S0 + G C0 Pi, S~ = S1 + G C1. The
    condition Xi + mu J' Omega J > 0 holds for some mu exactly if it holds for mu = 1, as both terms are
    positive semidefinite; so it is solved like the other inequalities.

    Assumes r = k, as the thesis does, and strict inequalities in ``solve``: with J S~ = 0 the block of f(Jw)
    is zero and none can hold.
    """
    plant, g, pi = _shared(plant, regulator, Pi)
    return Regulated.of(plant, g, pi).inequalities()


def theorem_3_2_3(
    plant: Plant, regulator: Generator, Pi: Any, sector: SectorBounds | None = None
) -> MatrixInequalities:
    """Assumption 3.2.6 with the conditions of Theorem 3.2.3: z = x - Pi w is ISS with respect to d, w and v.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Lambda, Omega1, Omega2, Upsilon >= 0, gamma1, gamma2 > 0;
    A~0 = A0 - Pi G C0, A~1 = A1 - Pi G C1. As above, mu = 1 is enough.
    """
    plant, g, pi = _shared(plant, regulator, Pi)
    bound = sector_bounds(plant) if sector is None else instance("sector", sector, SectorBounds)
    return Followed.of(plant, g, pi, bound).inequalities()


def assumption_3_2_3(plant: Plant, regulator: Generator, Pi: Any) -> MatrixInequalities:
    """The inequalities of Assumption 3.2.3: ``solve`` finds matrices, ``check`` audits printed ones.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Omega, Lambda >= 0; S = S0 + G C0 Pi, S~ = S1 + G C1, J = H Pi.

    [S'P + P S + Xi, P S~ + S'J'Lambda + J'Omega, P, P; *, S~'J'Lambda + Lambda J S~, Lambda J, Lambda J;
    *, *, -Gamma, 0; *, *, *, -Gamma] <= 0. ``solve`` wants it strict, which cannot hold with J S~ = 0.
    Assumes r = k, as the thesis does.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
    >>> regulator = Generator([[-3.0]], [-2.0], None, [2.0], [0.0], [-1.0])
    >>> printed = {"P": 2.0, "Gamma": 99.0, "Xi": 1.0, "Omega": 4.0, "Lambda": 1.0}
    >>> sorted(assumption_3_2_3(plant, regulator, [[1.0]]).check(printed))
    ['Gamma > 0', 'Lambda >= 0', 'Omega >= 0', 'P > 0', 'Phi', 'Xi']
    """
    problem = theorem_3_2_2(plant, regulator, Pi)
    problem.blocks.pop("Xi + J' Omega J", None)
    return problem


def assumption_3_2_6(
    plant: Plant, regulator: Generator, Pi: Any, sector: SectorBounds | None = None
) -> MatrixInequalities:
    """The inequalities of Assumption 3.2.6: ``solve`` finds matrices, ``check`` audits printed ones.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Lambda, Omega1, Omega2, Upsilon >= 0, gamma1, gamma2 > 0;
    A~0 = A0 - Pi G C0, A~1 = A1 - Pi G C1.

    [A~0'P + P A~0 + Xi, A~0'H'Lambda + H'Omega1, P A~1 + H'Omega2, P; *, -gamma1 I, Lambda H A~1 + Upsilon,
    Lambda H; *, *, -gamma2 I, 0; *, *, *, -Gamma] <= 0.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
    >>> regulator = Generator([[-3.0]], [-2.0], None, [2.0], [0.0], [-1.0])
    >>> found = assumption_3_2_6(plant, regulator, [[1.0]]).solve()
    >>> min(found.margins.values()) > 0.0
    True
    """
    problem = theorem_3_2_3(plant, regulator, Pi, sector)
    for name in ("R1", "R2", "R3", "R4", "R1 + H'(R2 + R3) H"):
        problem.blocks.pop(name, None)
    return problem


def certify_tracking(
    plant: Plant,
    regulator: Generator,
    Pi: Any,
    *,
    sector: SectorBounds | None = None,
    tolerance: float = TOLERANCE,
) -> TrackingCertificate:
    """Corollary 3.2.2: the plant follows Pi w under regulator (3.8), locally where slopes hold locally.

    Assumes that x = Pi w is the desired trajectory; checks that it is a solution (Assumption 3.2.1).

    Parameters: ``sector`` the constants of Assumption 3.2.4, by default from the slopes; ``tolerance``
    of the equalities, a share of their own terms, for matrices rounded in print.
    Raises InfeasibleError naming an equality with its residual, or the assumption that cannot be satisfied;
    UndecidedError, CertificateError and ParameterError as for ``MatrixInequalities``.

    Reference: Khalin 2022, section 3.2.3.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
    >>> regulator = Generator([[-3.0]], [-2.0], None, [2.0], [0.0], [-1.0])
    >>> certificate = certify_tracking(plant, regulator, [[1.0]])
    >>> min(certificate.margins.values()) > 0.0
    True
    """
    plant, tolerance = as_plant(plant), share("tolerance", tolerance)
    require_same_nonlinearity(plant, instance("regulator", regulator, Generator), name="regulator")
    held = equalities(plant, regulator, Pi)
    for name, part in shares_left(held).items():
        if not part <= tolerance:
            raise InfeasibleError(
                f"Assumption 3.2.1: {name} = 0 fails, its residual is {largest(held)[name]:.6g}"
            )
    # With a larger tolerance J is checked to that share of its terms, above.
    g = fitted(regulator, plant, "regulator")
    pi = matrix("Pi", Pi, plant.n, g.q)
    bound = sector_bounds(plant) if sector is None else instance("sector", sector, SectorBounds)
    both: dict[str, Loop] = {"3.2.3": Regulated.of(plant, g, pi), "3.2.6": Followed.of(plant, g, pi, bound)}
    # f keeps its units, and so do its arguments.
    units = {name: balanced(one.a, driven=one.b, inner=one.h, plain=True) for name, one in both.items()}
    reasons = []
    for name, one in both.items():
        matrix_name, mode = one.inward(units[name]).growing()
        if mode is not None:
            slopes = ", ".join(number_text(complex(each)) for each in mode.slopes)
            at = f" at D = diag({slopes})" if slopes else ""
            value = number_text(mode.eigenvalue / units[name].seconds)
            reasons.append(
                f"Assumption {name}: {matrix_name} has the eigenvalue {value}{at}, must lie left of 0"
            )
    if reasons:
        raise InfeasibleError("; ".join(reasons))
    solutions: list[Solution] = []
    failed: list[Exception] = []
    for name, one in both.items():
        try:
            solutions.append(one.found(units[name]))
        except (InfeasibleError, UndecidedError, CertificateError) as failure:
            failed.append(failure)
    if failed:
        # One assumption that no matrices satisfy is enough for a refusal.
        kind = next((type(one) for one in failed if isinstance(one, InfeasibleError)), type(failed[0]))
        raise kind("; ".join(str(one) for one in failed)) from failed[0]
    margins = {
        f"{number}: {name}": margin
        for number, one in zip(both, solutions, strict=True)
        for name, margin in one.margins.items()
    }
    return TrackingCertificate(solutions[0], solutions[1], margins, plant.domain)


def _shared(plant: Plant, regulator: Any, Pi: Any) -> tuple[Persidskii, Fitted, FloatArray]:
    """The plant, the regulator's matrices and Pi, once they are known to share f and its arguments."""
    plant = as_plant(plant)
    g = fitted(regulator, plant, "regulator")
    pi = matrix("Pi", Pi, plant.n, g.q)
    require_same_nonlinearity(plant, regulator, pi, "regulator")
    return plant, g, pi


def closed_loop(plant: Plant, regulator: Generator, t: float, both: Any, **signals: Any) -> FloatArray:
    """The derivative of (x, w) under the regulator; ``rho``, ``v``, ``d`` and ``w`` are signals at t."""
    plant = as_plant(plant)
    g = fitted(regulator, plant, "regulator")
    require_same_nonlinearity(plant, regulator, name="regulator")
    sizes = {"rho": plant.z, "v": plant.p, "d": plant.n, "w": g.q}
    if unknown := set(signals) - set(sizes):
        raise ParameterError(f"the signals are rho, v, d and w, received {', '.join(sorted(unknown))}")
    signals = {name: vector(name, one, sizes[name]) for name, one in signals.items() if one is not None}
    x, w = np.split(vector("both", both, plant.n + g.q), [plant.n])
    if g.J is None:
        raise ParameterError("a regulator needs J: give it, or take it from the steady-state map, J = H Pi")
    nonlinear = plant.f(g.J @ w)
    dx = plant.field(t, x, g.L0 @ w + g.L1 @ nonlinear, signals.get("rho"), signals.get("d"))
    dw = g.S0 @ w + g.S1 @ nonlinear + g.G @ plant.output(t, x, signals.get("v"))
    if "rho" in signals:
        dw = dw + g.E @ signals["rho"]
    return np.concatenate([dx, dw + signals.get("w", 0.0)])
