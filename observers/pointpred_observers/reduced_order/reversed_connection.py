"""The reversed connection of section 3.3: an observer whose state is a linear function of the plant's."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.persidskii_stage import MissingInputs, PersidskiiStage, alone, like
from pointpred_observers.numerics.equalities import (
    NO_DIGIT,
    TOLERANCE,
    cleared,
    column_units,
    largest,
    or_one,
    share_of_terms,
    summed,
    without_rounding,
)
from pointpred_observers.numerics.matrices import dimensions, flag, instance, matrix, share
from pointpred_observers.observer import Observer
from pointpred_observers.plants.documents import PlantDocument
from pointpred_observers.plants.entries import Document, Functions, Rows, entries
from pointpred_observers.plants.linear_systems import Plant, as_plant
from pointpred_observers.proofs.error_system import ErrorSystem, sloped_system
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting

Given = Any
"""A matrix, or a function of t (of the index in discrete time)."""


class Connection(msgspec.Struct, frozen=True):
    """The observer's matrices at one time: w' = S0 w + S1 f(J w + R y) + B y + O u, with w = Z x invariant.

    ``R`` is zero without injection. ``residuals`` of each equality, ``shares`` of its terms.
    """

    Z: FloatArray
    S0: FloatArray
    S1: FloatArray
    J: FloatArray
    B: FloatArray
    O: FloatArray
    R: FloatArray
    residuals: dict[str, float]
    shares: dict[str, float] = {}

    def require_equalities(self) -> None:
        """Raise CertificateError unless every equality holds to ``TOLERANCE``: w = Z x is invariant."""
        for name, share_left in self.shares.items():
            if not share_left <= TOLERANCE:
                raise CertificateError(
                    f"{name} = 0 fails: its residual is {self.residuals[name]:.3g}, {share_left:.1g} of its "
                    f"terms, and a certificate needs {TOLERANCE:g} whatever the tolerance of the "
                    "observer: leave out B, which is then computed, and give Pi and Upsilon with all digits",
                    field=name,
                    value=self.residuals[name],
                )


class InvariantObserver(Observer):
    """The observer w' = S0 w + S1 f(Jw) + B y + O u that w = Pi x + Upsilon y solves for every x(0) and u.

    Assumes y = C0 x + C1 f(Hx) without noise, and nothing about stability: that w converges needs a
    certificate. If the equalities do not determine S0 and B (q + p > n), B is by default the one of least
    norm, which need not give a stable observer.

    With Z = Pi + Upsilon C0: Upsilon C1 = 0, J Z = H, S0 Z + B C0 = Z A0 + Z', S1 = Z A1 - B C1, O = Z
    (B Q). In discrete time the Z before A0, A1 and the inputs is that of the next index, and there is
    no Z'. ``injection`` weakens J Z = H to J Z + R C0 = H with f(J w + R y): the measured output within f,
    which the thesis does not have. J is not needed if S1 = 0.

    Parameters: ``Pi`` (q, n), ``Upsilon`` (q, p), ``B`` (q, p): arrays or functions of t (of the index);
    ``rates`` in continuous time the derivatives of those of Pi, Upsilon and C0 that vary;
    ``tolerance`` of a residual relative to the plant's largest entry, for matrices rounded in print: such an
    observer runs, but a certificate needs the default. Raises InfeasibleError naming the violated equality
    and its residual; ParameterError for a shape.

    Reference: Khalin 2022, Propositions 3.3.1 and 3.3.2, (3.20)-(3.25); C0, C1 and Q are its D0, D1 and Q.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", B=[0.0, 1.0], C0=[1.0, 0.0])
    >>> now = invariant_observer(plant, [[0.0, 1.0]], [[-3.0]]).at(0.0)
    >>> now.S0.round(9).tolist(), now.B.round(9).tolist(), now.O.tolist()
    ([[-4.0]], [[-12.0]], [[1.0]])
    >>> plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], [0.0, -2.0], [1.0, 0.0], "sin", C0=[1.0, 0.0])
    >>> invariant_observer(plant, [[0.0, 1.0]], [[-3.0]])  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: J (Pi + Upsilon C0) - H = 0 cannot hold: its residual is 0.5 ...
    >>> invariant_observer(plant, [[0.0, 1.0]], [[-3.0]], injection=True).at(0.0).R.round(9).tolist()
    [[1.0]]
    """

    kind: ClassVar[str] = "invariant"
    plant: Any = None  # set at once: it stands in place of the property of ``Observer``

    def __init__(
        self,
        plant: Plant,
        Pi: Given,
        Upsilon: Given = None,
        *,
        B: Given = None,
        injection: bool = False,
        rates: dict[str, Callable[[float], Any]] | None = None,
        tolerance: float = TOLERANCE,
    ) -> None:
        plant = as_plant(plant)
        self.plant, self.injection = plant, flag("injection", injection)
        self.tolerance = share("tolerance", tolerance)
        self._given = {"Pi": Pi, "Upsilon": np.zeros((0, 0)) if Upsilon is None else Upsilon, "B": B}
        self.q = len(matrix("Pi", _at(Pi, 0.0), None, plant.n))
        self._rates: dict[str, Any] = instance("rates", {} if rates is None else rates, dict)
        self.varying = bool(plant.varying) or any(callable(one) for one in self._given.values())
        moving = {name for name in ("Pi", "Upsilon") if callable(self._given[name])}
        if "C0" in plant.varying and not _empty(self._given["Upsilon"]):
            moving.add("C0")
        if foreign := set(self._rates) - {"Pi", "Upsilon", "C0"}:
            raise ParameterError(f"rates may name Pi, Upsilon and C0, received {sorted(foreign)}")
        missing = moving - set(self._rates)
        if missing and plant.time == "continuous":
            raise ParameterError(
                f"{', '.join(sorted(missing))} vary in continuous time: give their derivatives in rates"
            )
        self._latest = 0.0, self._connection(0.0)

    def at(self, t: float) -> Connection:
        """The matrices at t (at the index, in discrete time)."""
        if self.varying and t != self._latest[0]:
            self._latest = t, self._connection(t)
        return self._latest[1]

    def field(self, t: float, w: Any, y: Any, u: Any = None) -> FloatArray:
        """The w' at t (or the next w); ``u`` are the inputs of the plant's B, then those of its Q."""
        now = self.at(t)
        w, y = np.asarray(w, np.float64), np.atleast_1d(np.asarray(y, np.float64))
        change: FloatArray = now.S0 @ w + now.B @ y
        if now.S1.size:
            change = change + now.S1 @ self.plant.f(now.J @ w + now.R @ y)
        return change if u is None else change + now.O @ np.atleast_1d(u)

    def invariant(self, t: float, x: Any) -> FloatArray:
        """The w of a state of the plant: Z x."""
        return np.asarray(self.at(t).Z @ np.asarray(x, np.float64))

    def recovery(self, t: float) -> tuple[FloatArray, FloatArray]:
        """X, Y with x = X w + Y y on the invariant solution; raises ParameterError where there are none."""
        now, pi, upsilon, _ = self._maps(t)
        if now["C1"].any():
            raise ParameterError("the state is recovered linearly from w and y, which needs C1 = 0")
        # From w - Upsilon y = Pi x: beside a large Upsilon C0 rounding would take that of Pi.
        both = np.vstack([pi, now["C0"]])
        sizes = or_one(np.linalg.norm(both, axis=1, keepdims=True))
        rank = np.linalg.matrix_rank(both / sizes, tol=1e-9)
        if rank < self.plant.n:
            raise ParameterError(f"w and y hold {rank} combinations of the {self.plant.n} states, not all")
        inverse = np.linalg.pinv(both / sizes) / sizes.T
        onto = inverse[:, : self.q]
        return onto, inverse[:, self.q :] - onto @ upsilon

    def output_rate(self, t: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """V0, V1, V2 with y' = V0 w + V1 f(Hx) + V2 (y, u), in discrete time the next y, as the plant has it.

        Zero, so that outputs stay, if C0 varies in continuous time and its derivative is not known.
        """
        plant, now, discrete = self.plant, self.plant.matrices(t), self.plant.time == "discrete"
        onto, straight = self.recovery(t)
        c, change = now["C0"], np.zeros((plant.p, plant.n))
        if discrete and self.varying:
            c = plant.matrices(t + 1)["C0"]
        elif "C0" in self._rates:
            change = self._rate("C0", t)
        elif "C0" in plant.varying:
            v0, v1 = np.zeros((plant.p, self.q)), np.zeros((plant.p, plant.k))
            return v0, v1, np.zeros((plant.p, plant.p + plant.m + plant.z))
        drift = c @ now["A0"] + change
        driven = c @ np.hstack([now["B"], now["Q"]])
        return drift @ onto, c @ now["A1"], np.hstack([drift @ straight, driven])

    def estimate(self, t: float, w: Any, y: Any) -> FloatArray:
        """The plant's state from w and y."""
        onto, straight = self.recovery(t)
        return np.asarray(onto @ np.asarray(w, np.float64) + straight @ np.atleast_1d(y))

    @property
    def chosen(self) -> dict[str, FloatArray]:
        """Upsilon at the start."""
        return {"Upsilon": self._maps(0.0)[2]}

    def error_system(self) -> ErrorSystem:
        """(3.26): w^ - (Pi x + Upsilon y), disturbed by ``delta`` of the observer's equation and ``v`` of y.

        Raises ParameterError where matrices vary, CertificateError where w = Pi x + Upsilon y is not
        invariant.
        """
        if self.varying:
            raise ParameterError("an error system needs constant matrices, those of the observer vary")
        now, plant = self.at(0.0), self.plant
        now.require_equalities()
        return sloped_system(
            now.S0,
            without_rounding(now.S1, now.Z @ plant.A1),
            now.J,
            {"delta": np.eye(self.q), "v": now.B},
            slopes=plant.slopes,
            time=plant.time,
            through={"v": now.R},
            domain=plant.domain,
        )

    def stage(
        self, *, start: Any = None, step_s: float | None = None, gap_s: float | None = None
    ) -> PersidskiiStage:
        """Observer (3.17) or (3.19) as a stage: inputs are y, then u; it returns the plant's x.

        Assumes C1 = 0 and that w and y determine x. The measured part of the output is the measurement with
        its noise, which also enters the rest through Upsilon. While an output is missing it follows y' = C0
        x'; a missing u keeps its last value. ``start`` a guess of the plant's state, default zeros; the
        rest as ``PersidskiiStage``.
        """
        plant, now = self.plant, self.at(0.0)
        m, inputs = plant.p + plant.m + plant.z, plant.m + plant.z
        guess = np.zeros(plant.n) if start is None else matrix("start", start, 1, plant.n)[0]
        stay = np.eye(m)[plant.p :] if plant.time == "discrete" else np.zeros((inputs, m))

        def of(one: Callable[[float], Any]) -> Any:
            return one if self.varying else one(0.0)

        def below(part: int, rest: FloatArray) -> Any:
            return of(lambda t: np.vstack([self.output_rate(t)[part], rest]))

        def inner(t: float) -> tuple[FloatArray, FloatArray]:
            """J and R with Hx = Jw + Ry, also where the observer has no f of its own."""
            one = self.at(t)
            if one.S1.any():
                return one.J, one.R
            onto, straight = self.recovery(t)
            h = plant.matrices(t)["H"]
            return h @ onto, h @ straight

        missing = MissingInputs(
            (False,) * m,
            below(0, np.zeros((inputs, self.q))),
            below(1, np.zeros((inputs, plant.k))),
            below(2, stay),
            np.concatenate([plant.C0 @ guess, np.zeros(inputs)]),
        )
        return PersidskiiStage(
            of(lambda t: self.at(t).S0),
            of(lambda t: self.at(t).S1),
            of(lambda t: inner(t)[0]),
            of(lambda t: np.hstack([self.at(t).B, self.at(t).O])),
            plant.f,
            R0=of(lambda t: self.recovery(t)[0]),
            R=of(lambda t: np.hstack([inner(t)[1], np.zeros((plant.r, inputs))])),
            R2=of(lambda t: np.hstack([self.recovery(t)[1], np.zeros((plant.n, inputs))])),
            start=now.Z @ guess,
            missing=missing,
            time=plant.time,
            step_s=step_s,
            gap_s=gap_s,
        )

    def simulated(
        self, plant: Any, setting: Setting, title: str = "observer", bound: FloatArray | None = None
    ) -> Simulation:
        """The plant that nothing feeds back."""
        return alone(like(plant, self.plant), self, setting, title, bound)

    def document(self) -> InvariantDocument:
        """Plant and maps, which must not vary."""
        return InvariantDocument(**self.kept())

    def kept(self) -> dict[str, Any]:
        """The fields of its document; raises ParameterError for maps that vary."""
        given = self._given
        if moving := [name for name, one in given.items() if callable(one)]:
            raise ParameterError(
                f"an observer whose {', '.join(moving)} vary cannot be saved: save the plant, and make the "
                "observer again with invariant_observer"
            )
        return {
            "plant": PlantDocument.of(self.plant),
            "Pi": entries(matrix("Pi", given["Pi"], None, self.plant.n)),
            "Upsilon": entries(matrix("Upsilon", given["Upsilon"], self.q))
            if np.size(given["Upsilon"])
            else [],
            "B": None if given["B"] is None else entries(matrix("B", given["B"], self.q)),
            "injection": self.injection,
            "tolerance": self.tolerance,
        }

    def _maps(self, t: float) -> tuple[dict[str, FloatArray], FloatArray, FloatArray, FloatArray]:
        """The plant's matrices, Pi, Upsilon and Z at t."""
        now = self.plant.matrices(t)
        pi = matrix("Pi", _at(self._given["Pi"], t), self.q, self.plant.n)
        given = _at(self._given["Upsilon"], t)
        upsilon = np.zeros((self.q, self.plant.p)) if _empty(given) else given
        upsilon = matrix("Upsilon", upsilon, self.q, self.plant.p)
        return now, pi, upsilon, cleared((pi,), (upsilon, now["C0"]), share=NO_DIGIT)

    @np.errstate(all="ignore")  # what overflows is not finite, and refused
    def _connection(self, t: float) -> Connection:
        now, _, upsilon, z = self._maps(t)
        discrete = self.plant.time == "discrete"
        onward = self._maps(t + 1)[3] if discrete and self.varying else z
        change = onward @ now["A0"]
        if not discrete:
            # Z' = Pi' + Upsilon' C0 + Upsilon C0'
            change = change + self._rate("Pi", t) + self._rate("Upsilon", t) @ now["C0"]
            change = change + upsilon @ self._rate("C0", t)
        given, both = self._given["B"], np.vstack([z, now["C0"]])
        if given is None:
            s0, b = np.split(_right(both, change), [self.q], axis=1)
        else:
            b = matrix("B", _at(given, t), self.q, self.plant.p)
            s0 = _right(z, change - b @ now["C0"])
        s1 = cleared((onward, now["A1"]), (-b, now["C1"]), share=NO_DIGIT)
        jr = _right(both if self.injection else z, now["H"])
        j, r = jr[:, : self.q], jr[:, self.q :] if self.injection else np.zeros((len(jr), self.plant.p))
        # A large gain makes large terms, which round by a share of their own size.
        terms = summed((s0, z), (b, now["C0"]), (onward, now["A0"]))[1]
        invariance = s0 @ z + b @ now["C0"] - change
        none = np.zeros(0), np.zeros(0)
        left = {
            "Upsilon C1": summed((upsilon, now["C1"])),
            "J (Pi + Upsilon C0) - H": summed((j, z), (r, now["C0"]), (-now["H"],)) if s1.any() else none,
            "S0 Z + B C0 - Z A0 - Z'": (invariance, terms + np.abs(change)),
            "R C1": summed((r, now["C1"])),
        }
        size = max(1.0, *(float(np.abs(m).max(initial=0.0)) for m in (terms, *now.values())))
        residuals = largest(left)
        if not np.isfinite([size, *residuals.values()]).all():
            raise ParameterError(
                f"the equalities hold numbers that are too large to compute with at t = {t:g}: check the "
                "largest entries of the plant, of Pi, Upsilon and B"
            )
        for name, residual in residuals.items():
            if residual > self.tolerance * size:
                raise InfeasibleError(f"{name} = 0 cannot hold: its residual is {residual:.3g} at t = {t:g}")
        # In no unit may a large entry elsewhere, or the 1 above, hide that one of these fails.
        units, gains = column_units(both), {"Upsilon C1": upsilon, "R C1": r}
        shares = {}
        for name, one in left.items():
            before = gains.get(name)
            shares[name] = share_of_terms(*one, units) if before is None else _share_before_f(before, now)
        inputs = onward @ np.hstack([now["B"], now["Q"]])
        return Connection(z, s0, s1, j, b, inputs, r, residuals, shares)

    def _rate(self, name: str, t: float) -> FloatArray:
        """The derivative of Pi, Upsilon or C0, zero where none was passed."""
        rows, columns = (self.plant.p if name == "C0" else self.q), self.plant.n
        if name == "Upsilon":
            columns = self.plant.p
        if name not in self._rates:
            return np.zeros((rows, columns))
        return matrix(f"{name}'", self._rates[name](t), rows, columns)


class InvariantDocument(Document, tag="invariant observer", frozen=True):
    """An ``InvariantObserver`` of constant maps."""

    plant: PlantDocument
    Pi: Rows
    tolerance: float
    Upsilon: Rows | None = None
    B: Rows | None = None
    injection: bool = False

    def made(self, functions: Functions) -> Any:
        """The observer."""
        return InvariantObserver(
            self.plant.made(functions),
            self.Pi,
            self.Upsilon,
            B=self.B,
            injection=self.injection,
            tolerance=self.tolerance,
        )


invariant_observer = InvariantObserver


def _empty(given: Given) -> bool:
    """Whether a matrix was left out; rows of different lengths are refused where it is used."""
    return dimensions(given) > 0 and np.size(given) == 0


def _at(given: Given, t: float) -> Any:
    return given(t) if callable(given) else given


def _right(a: FloatArray, b: FloatArray) -> FloatArray:
    """The least-squares X of X a = b, of least norm in units of rows and columns; rounding is 0."""
    if not a.size:
        return np.zeros((len(b), len(a)))
    columns = or_one(np.abs(a).max(axis=0))
    rows = or_one(np.abs(a / columns).max(axis=1))
    scaled = a / columns / rows[:, None]
    right = b / columns
    solution = np.asarray(np.linalg.lstsq(scaled.T, right.T, rcond=None)[0].T, np.float64)
    inverse = np.asarray(np.linalg.pinv(scaled), np.float64)
    answer: FloatArray = without_rounding(solution, np.abs(right) @ np.abs(inverse), share=NO_DIGIT) / rows
    return answer


def _share_before_f(gain: FloatArray, plant: dict[str, FloatArray]) -> float:
    """How much of f a gain of the outputs lets through, as a share of what it would without cancelling."""
    c0, c1 = plant["C0"], plant["C1"]
    both = np.hstack([np.abs(c0) / column_units(c0), np.abs(c1)])
    outputs = or_one(both.max(axis=1, initial=0.0))
    most = (np.abs(gain) * outputs).max(axis=1, initial=0.0)[:, None]
    rounding = NO_DIGIT * most * (np.abs(c1) / outputs[:, None]).max(axis=0, initial=0.0)
    return share_of_terms(*summed((gain, c1)), rounding=rounding)
