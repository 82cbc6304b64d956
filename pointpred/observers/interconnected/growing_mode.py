"""A motion that grows although f is a matrix of slopes: it excludes every choice of a theorem's matrices."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.records import FloatArray
from pointpred_observers.eigenvalues import number_text

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
    """

    state: ComplexArray
    value: ComplexArray
    slopes: ComplexArray
    eigenvalue: complex
    share: float
    """The real part of s beside the size of a + b D H."""

    def text(self, matrix: str, seconds: float) -> str:
        """The eigenvalue in 1/s and the slopes; ``seconds`` is the unit of time."""
        slopes = ", ".join(number_text(complex(one)) for one in self.slopes)
        at = f" at D = diag({slopes})" if len(self.slopes) else ""
        return f"{matrix} has the eigenvalue {number_text(self.eigenvalue / seconds)}{at}"


Admitted = Callable[[GrowingMode], bool]
Candidates = tuple[FloatArray, ComplexArray]
"""Slopes of one component that are tried: real ones, and others if none of them does."""


def growing_mode(
    a: FloatArray, b: FloatArray, h: FloatArray, candidates: list[Candidates], admitted: Admitted
) -> GrowingMode | None:
    """A growing motion of x' = a x + b f, f = D h x, with D of the ``candidates`` for each component.

    ``admitted`` says which motions exclude the matrices of the theorem. The slopes are searched component by
    component for the largest growth beside the size of a + b D h, real ones first: with them the plant itself
    is unstable. That no motion is found proves nothing.

    Shapes: ``a`` (n, n), ``b`` (n, k), ``h`` (k, n).

    >>> a, b, h = np.array([[-1.0]]), np.array([[2.0]]), np.array([[1.0]])
    >>> growing_mode(a, b, h, [disc(0.4)], lambda mode: True) is None
    True
    >>> growing_mode(a, b, h, [disc(1.0)], lambda mode: True).text("a + b D h", 1.0)
    'a + b D h has the eigenvalue 0.199999 at D = diag(0.599999)'
    """
    for i in range(2):
        mode = _search(a, b, h, [one[i] for one in candidates], admitted)
        if mode is not None:
            return mode
    return None


def disc(radius: float) -> Candidates:
    """Slopes that keep the sign of f, Re(d) >= 0, up to this size: the real ones, then all."""
    sizes = np.asarray(0.999999 * radius * np.arange(11) / 10.0, np.float64)
    return sizes, np.concatenate([_turned(sizes, TURNS), _turned(sizes[1:], -TURNS[1:])])


def quadrant(unit: float) -> Candidates:
    """Slopes d with Re(d) >= 0 and Im(d) >= 0, of sizes around ``unit``: the real ones, then all."""
    sizes = np.concatenate([[0.0], unit * np.logspace(-4.0, 6.0, 41)])
    return sizes, _turned(sizes, TURNS)


def _turned(sizes: FloatArray, angles: FloatArray) -> ComplexArray:
    return np.outer(sizes, np.exp(1j * angles)).ravel()


def _search(
    a: FloatArray, b: FloatArray, h: FloatArray, candidates: list[Any], admitted: Admitted
) -> GrowingMode | None:
    """The best motion for slopes of these candidates, improved component by component."""
    k, random = len(candidates), np.random.default_rng(0)
    starts = [np.array([one[0] for one in candidates])]
    starts += [np.array([random.choice(one) for one in candidates]) for _ in range(STARTS if k > 1 else 0)]
    best: GrowingMode | None = None
    for slopes in starts:
        for i in [*range(k), *range(k)] if k > 1 else range(1):
            tried = np.tile(slopes, (len(candidates[i]) if k else 1, 1))
            if k:
                tried[:, i] = candidates[i]
            fastest, mode = _fastest(a, b, h, tried, admitted)
            slopes = fastest
            if mode is not None and (best is None or mode.share > best.share):
                best = mode
    return best


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
        mode = GrowingMode(x, tried[i] * (h @ x), tried[i], s, float(shares[i, j]))
        if _grows(a, b, mode) and admitted(mode):
            return tried[i], mode
    return tried[order[0][0]], None


def _grows(a: FloatArray, b: FloatArray, mode: GrowingMode) -> bool:
    """Whether the motion solves its equation so well that it grows whatever P it is measured by.

    Re x*P x' = Re(s) x*P x + Re x*P r with the residual r = a x + b f - s x, and abs(x*P r) is at most
    sqrt(condition number of P) abs(r) / abs(x) times x*P x. The rounding of r counts as well.
    """
    x, f = mode.state, mode.value
    residual = np.abs(a @ x + b @ f - mode.eigenvalue * x) + rounding((a, x), (b, f))
    return mode.eigenvalue.real * float(np.linalg.norm(x)) > CLOSE * float(np.linalg.norm(residual))


def rounding(*products: tuple[FloatArray, ComplexArray]) -> FloatArray:
    """The largest error of a sum of matrices times vectors, by component."""
    terms = sum(np.abs(matrix) @ np.abs(vector) for matrix, vector in products)
    length = sum(len(vector) for _, vector in products) + 2
    return np.asarray(length * np.finfo(np.float64).eps * terms, np.float64)
