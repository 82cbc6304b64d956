"""The generator (or the dynamic regulator) that drives a Persidskii plant; both sampled."""

from __future__ import annotations

from typing import Any, overload

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.equalities import TOLERANCE, column_units, share_of_terms, summed
from pointpred_observers.numerics.matrices import TIMES, instance, matrix, one_of, positive
from pointpred_observers.plants.linear_systems import Plant, as_plant, constant
from pointpred_observers.plants.nonlinearity import NAMED, Nonlinearity, nonlinearity, same
from pointpred_observers.plants.persidskii import Persidskii, column


class Fitted(msgspec.Struct, frozen=True):
    """A generator with every matrix, in the shape that a plant needs; ``J`` may be ``None``."""

    q: int
    S0: FloatArray
    S1: FloatArray
    J: FloatArray | None
    G: FloatArray
    L0: FloatArray
    L1: FloatArray
    E: FloatArray


class Generator:
    """The signal generator of chapter 3: w' = S0 w + S1 f(Jw) + G y + E rho, u = L0 w + L1 f(Jw).

    With y measured instead of known it is the dynamic regulator of (3.8). Constant matrices only.

    Parameters: ``S0`` (q, q), ``S1`` (q, k), ``J`` (r, q) or ``None`` for the plant's, J = H Pi; ``G`` (q,
    p), ``L0`` (m, q), ``L1`` (m, k), ``E`` (q, z), ``None`` for zero; ``f`` the generator's own nonlinearity,
    ``None`` for the plant's; ``time`` ``"continuous"`` or ``"discrete"``, ``None`` for the plant's.
    Raises ParameterError (a ValueError) naming the matrix.

    Reference: Khalin 2022, (3.2), (3.8).

    >>> Generator([[0.0, 1.0], [-1.0, 0.0]], L0=[1.0, 0.0]).q
    2
    """

    def __init__(
        self,
        S0: Any,
        S1: Any = None,
        J: Any = None,
        G: Any = None,
        L0: Any = None,
        L1: Any = None,
        E: Any = None,
        f: Any = None,
        *,
        time: str | None = None,
    ) -> None:
        self.time = None if time is None else one_of("time", time, TIMES)
        self.S0: FloatArray = matrix("S0", S0, len(matrix("S0", S0)), len(matrix("S0", S0)))
        self.q = len(self.S0)
        if not self.q:
            raise ParameterError("S0 needs at least one state, received none", field="S0")
        self._fitted: tuple[Plant, Fitted] | None = None
        self.S1 = None if S1 is None else column("S1", S1, self.q)
        self.J = None if J is None else matrix("J", J, None, self.q)
        self.G = None if G is None else column("G", G, self.q)
        self.E = None if E is None else column("E", E, self.q)
        self.L0 = None if L0 is None else matrix("L0", L0, None, self.q)
        self.L1 = None if L1 is None else matrix("L1", L1, None if self.L0 is None else len(self.L0))
        values = [one.shape[1] for one in (self.S1, self.L1) if one is not None]
        self.f = None if f is None else nonlinearity(f, values[0] if values else 1)

    def beside(self, plant: Plant) -> Fitted:
        """Every matrix in the shape that the plant needs, zero where left out; raises ParameterError."""
        if self._fitted is not None and self._fitted[0] is plant:
            return self._fitted[1]
        given, plant, q = plant, as_plant(plant), self.q
        if self.time not in (None, plant.time):
            words = f"the generator is {self.time} and the plant {plant.time}: sample the continuous one, c2d"
            raise ParameterError(words, field="time")
        own = [one.shape[1] for one in (self.S1, self.L1) if self.f is not None and one is not None]
        k = own[0] if own else plant.k
        m = plant.m
        needed = {"S1": (q, k), "G": (q, plant.p), "L0": (m, q), "L1": (m, k), "E": (q, plant.z)}
        full = {
            name: np.zeros(shape) if (one := getattr(self, name)) is None else matrix(name, one, *shape)
            for name, shape in needed.items()
        }
        j = None if self.J is None else matrix("J", self.J, plant.r if self.f is None else None, q)
        self._fitted = given, Fitted(q=q, S0=self.S0, J=j, **full)
        return self._fitted[1]


def fitted(generator: Any, plant: Plant, name: str = "generator") -> Fitted:
    """Every matrix of a generator, or of a regulator, in the shape that the plant needs; checked."""
    return instance(name, generator, Generator).beside(plant)


def require_same_nonlinearity(
    plant: Persidskii, generator: Generator, Pi: FloatArray | None = None, name: str = "generator"
) -> None:
    """Raise ParameterError unless generator and plant share f and, with ``Pi``, its arguments, J = H Pi.

    Every proof compares f(Hx) with f(Jw).
    """
    used = [one for one in (generator.S1, generator.L1) if one is not None]
    if generator.f is not None and used:
        widths = {one.shape[1] for one in used}
        if widths != {plant.k} or (any(one.any() for one in used) and not same(generator.f, plant.f)):
            both = f"an f of its own, {_text(generator.f)}, and the plant {_text(plant.f)}"
            raise ParameterError(f"the {name} has {both}: leave out that of the {name}", field="f")
    if Pi is None or generator.J is None:
        return
    left, terms = summed((matrix("J", generator.J, plant.r, Pi.shape[1]),), (-plant.H, Pi))
    units = column_units(summed((plant.A0, Pi), (Pi, generator.S0))[1])
    if not share_of_terms(left, terms, units) <= TOLERANCE:
        raise ParameterError(f"J must be H Pi, differs by {np.abs(left).max():.3g}", field="J")


def _text(f: Nonlinearity) -> str:
    """The names of f, or that it is a function."""
    if f.codes is None:
        return "a function"
    return ", ".join(dict.fromkeys(NAMED[code] for code in f.codes)) or "none"


@overload
def c2d(system: Generator, step_s: float, *, method: str = "zoh") -> Generator: ...
@overload
def c2d(system: Plant, step_s: float, *, method: str = "zoh") -> Persidskii: ...
def c2d(system: Any, step_s: float, *, method: str = "zoh") -> Any:
    """The discrete plant (or generator) whose next state is the state after ``step_s``.

    ``"zoh"`` holds the inputs u, rho (y and rho of a generator), and the value of f, over the step: exact for
    a linear plant under held inputs, else off by terms of step_s^2 each step, as f moves meanwhile.
    ``"euler"`` is x + step_s x', off by terms of step_s^2 as well, and keeps the steady-state map: (3.3)
    holds for the discrete pair with the same Pi. Slopes, domain, C0, C1, H, J, L0 and L1 stay.

    zoh: (Ad Nd; 0 I) = exp(step_s (A0 N; 0 0)) with N = (A1 B Q) or (S1 G E).

    Parameters: ``step_s`` in s, > 0. Raises ParameterError for a plant or a generator that is discrete, and
    for matrices that vary.

    >>> held = c2d(Persidskii([[-1.0]], None, None, "sin", B=[1.0]), 0.1)
    >>> held.A0.round(6).tolist(), held.B.round(6).tolist(), held.time
    ([[0.904837]], [[0.095163]], 'discrete')
    """
    step_s = positive("step_s", step_s)
    one_of("method", method, ("zoh", "euler"))
    given = system if isinstance(system, Generator) else constant(system, "c2d")
    if given.time == "discrete":
        kind = "generator" if isinstance(given, Generator) else "plant"
        raise ParameterError(f"c2d needs a continuous {kind}, received a discrete one", field="system")
    if isinstance(given, Generator):
        held = {name: one for name in ("S1", "G", "E") if (one := getattr(given, name)) is not None}
        s0, parts = _sampled(given.S0, list(held.values()), step_s, method)
        driven: dict[str, Any] = dict(zip(held, parts, strict=True))
        kept = {name: getattr(given, name) for name in ("J", "L0", "L1", "f")}
        return Generator(s0, **driven, **kept, time="discrete")
    a0, (a1, b, q) = _sampled(given.A0, [given.A1, given.B, given.Q], step_s, method)
    outputs: dict[str, Any] = {"C0": given.C0, "C1": given.C1, "domain": given.domain}
    return Persidskii(a0, a1, given.H, given.f, b, q, **outputs, time="discrete")


def _sampled(
    a: FloatArray, parts: list[FloatArray], step_s: float, method: Any
) -> tuple[FloatArray, list[FloatArray]]:
    from scipy.signal import cont2discrete

    widths = np.cumsum([one.shape[1] for one in parts])[:-1]
    drive, none = np.hstack([np.zeros((len(a), 0)), *parts]), np.zeros((0, len(a)))
    system: Any = a, drive, none, np.zeros((0, drive.shape[1]))
    held: Any = cont2discrete(system, step_s, method)
    return np.asarray(held[0], np.float64), np.split(np.asarray(held[1], np.float64), widths, axis=1)
