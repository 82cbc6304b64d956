"""Persidskii systems: linear except for one sector nonlinearity of a linear function of the state."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import TIMES, dimensions, matrix, one_of, wrong
from pointpred_observers.plants.nonlinearity import Nonlinearity, nonlinearity, require_slopes

NAMES = ("A0", "A1", "H", "B", "Q", "C0", "C1")


class Persidskii:
    """The plant of chapter 3: x' = A0 x + A1 f(Hx) + B u + Q rho + d, y = C0 x + C1 f(Hx) + v.

    In discrete time x' is the next x.

    Assumes of f only its ``slopes``, and that it is elementwise where it has any: component i depends upon
    argument i alone. Those of a name are compared with its true ones. A function is compared at sample points
    within ``domain``: its differences with its slopes, and each component with itself while another argument
    moves, which is no proof.

    Parameters: ``A0`` (n, n), ``A1`` (n, k), ``H`` (r, n), ``B`` (n, m), ``Q`` (n, z), ``C0`` (p, n), ``C1``
    (p, k); each an array or a function of t in s (of the index where ``time`` is ``"discrete"``), ``None``
    for zero; ``f`` a name, a name for each component (then r = k), or a function from R^r to R^k, not needed
    without A1; ``slopes`` the interval of each component's slope (then r = k and f is elementwise), ``None``
    for the global ones of a named f;
    ``domain`` the bound of abs(Hx) within which the slopes hold, infinite if they hold everywhere.
    Raises ParameterError (a ValueError) naming a matrix of the wrong shape, with NaN, inf or complex entries,
    and slopes that f does not keep within ``domain``, with the true ones.

    Reference: Khalin 2022, (3.1), (3.16), (3.18); Efimov and Aleksandrov 2019.

    >>> arm = Persidskii([[0.0, 1.0], [0.0, -1.0]], [0.0, -2.0], [1.0, 0.0], "sin", C0=[1.0, 0.0])
    >>> arm.field(0.0, [0.5, 0.0]).round(3).tolist()
    [0.0, -0.959]
    >>> Persidskii([[0.0, 1.0]], None, None, "sin", C0=[1.0, 0.0])
    Traceback (most recent call last):
    pointpred.errors.ParameterError: A0 has shape (1, 2), needs (1, 1)
    """

    def __init__(
        self,
        A0: Any,
        A1: Any = None,
        H: Any = None,
        f: Any = (),
        B: Any = None,
        Q: Any = None,
        C0: Any = None,
        C1: Any = None,
        slopes: Any = None,
        time: str = "continuous",
        *,
        domain: float = np.inf,
    ) -> None:
        one_of("time", time, TIMES)
        if not is_number(domain) or not domain > 0.0:
            raise wrong("domain", "must lie above 0", domain)
        self.time, self.domain = time, float(domain)
        self._given = dict(zip(NAMES, (A0, A1, H, B, Q, C0, C1), strict=True))
        self.varying = tuple(name for name, one in self._given.items() if callable(one))
        first = self.matrices(0.0)
        self._given |= {name: one for name, one in first.items() if name not in self.varying}
        for name, one in first.items():
            setattr(self, name, one)
        self.n, self.k, self.r = len(self.A0), self.A1.shape[1], len(self.H)
        self.m, self.z, self.p = self.B.shape[1], self.Q.shape[1], len(self.C0)
        if self.k and H is None:
            raise ParameterError(
                f"A1 needs H, and H x is what f is of: {self.k} rows of {self.n} entries", field="H"
            )
        if self.k and isinstance(f, tuple | list) and not len(f):
            raise ParameterError("A1 needs f: a name, a name for each column of A1, or a function", field="f")
        self.f: Nonlinearity = nonlinearity(f, self.k, slopes)
        if self.f.codes is not None and self.r != self.k:
            raise ParameterError(f"H has {self.r} rows, an elementwise f needs {self.k}", field="H")
        if self.k and self.f.slopes is not None and len(self.f.slopes) != self.k:
            raise ParameterError(f"f has {len(self.f.slopes)} components, A1 has {self.k} columns", field="f")
        if self.k and self.f.slopes is not None and self.r != self.k:
            raise ParameterError(
                "slopes need an f of which each component has its own argument: f has "
                f"{self.k} components (columns of A1) and {self.r} arguments (rows of H); leave out slopes",
                field="slopes",
            )
        if self.k and self.f.checked < self.domain:
            require_slopes(self.f, self.k, self.r, self.domain)
            self.f = msgspec.structs.replace(self.f, checked=self.domain)

    A0: FloatArray
    A1: FloatArray
    H: FloatArray
    B: FloatArray
    Q: FloatArray
    C0: FloatArray
    C1: FloatArray

    @property
    def slopes(self) -> tuple[tuple[float, float], ...] | None:
        """The interval of each component's slope."""
        return self.f.slopes

    def given(self, name: str) -> Any:
        """A matrix, or the function of t (of the index) that gives it."""
        return self._given[name]

    def matrices(self, t: float) -> dict[str, FloatArray]:
        """Every matrix at a time (or an index), its shape checked."""
        now = {name: one(t) if callable(one) else one for name, one in self._given.items()}
        n = len(a0 := matrix("A0", now["A0"]))
        if not a0.size:
            raise ParameterError("A0 is empty: a plant needs at least one state", field="A0")
        shaped = {"A0": matrix("A0", now["A0"], n, n)}
        shaped["A1"] = column("A1", now["A1"], n)
        k = shaped["A1"].shape[1]
        shaped["H"] = row("H", now["H"], n)
        shaped["B"], shaped["Q"] = column("B", now["B"], n), column("Q", now["Q"], n)
        p = len(row("C1", now["C1"], k) if now["C0"] is None else row("C0", now["C0"], n))
        shaped["C0"] = np.zeros((p, n)) if now["C0"] is None else row("C0", now["C0"], n)
        shaped["C1"] = np.zeros((p, k)) if now["C1"] is None else matrix("C1", now["C1"], p, k)
        return {name: shaped[name] for name in NAMES}

    def at(self, t: float) -> Persidskii:
        """The plant with its matrices fixed at those of a time (or an index)."""
        return Persidskii(f=self.f, time=self.time, domain=self.domain, **self.matrices(t))

    def field(self, t: float, x: Any, u: Any = None, rho: Any = None, d: Any = None) -> FloatArray:
        """The x' at t (or the next x); omitted inputs are zero."""
        now = self.matrices(t) if self.varying else self.__dict__
        x = np.asarray(x, np.float64)
        change: FloatArray = now["A0"] @ x + now["A1"] @ self.f(now["H"] @ x)
        for name, signal in (("B", u), ("Q", rho)):
            if signal is not None:
                change = change + now[name] @ np.atleast_1d(signal)
        return change if d is None else change + d

    def output(self, t: float, x: Any, v: Any = None) -> FloatArray:
        """The output y at t."""
        now = self.matrices(t) if self.varying else self.__dict__
        x = np.asarray(x, np.float64)
        y: FloatArray = now["C0"] @ x + now["C1"] @ self.f(now["H"] @ x)
        return y if v is None else y + v


def column(name: str, given: Any, rows: int) -> FloatArray:
    """A matrix with this number of rows; a flat list is one column, ``None`` no column."""
    if given is None:
        return np.zeros((rows, 0))
    flat = dimensions(given) == 1
    return matrix(name, given, rows, 1 if flat else None)


def row(name: str, given: Any, columns: int) -> FloatArray:
    """A matrix with this number of columns; a flat list is one row, ``None`` no row."""
    return np.zeros((0, columns)) if given is None else matrix(name, given, None, columns)
