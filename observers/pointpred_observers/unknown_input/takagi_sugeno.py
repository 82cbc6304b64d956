"""Takagi-Sugeno models: matrices at the vertices of a box, mixed by multilinear weights."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Self

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers import equalities
from pointpred_observers.matrices import matrix
from pointpred_observers.unknown_input.boxes import Box

Scheduled = Callable[[Mapping[str, float]], FloatArray]
"""A matrix as a function of the scheduling variables."""
NO_DIFFERENCE = 1e-9
"""A difference below this share of the largest value of the same entry counts as none."""
CANCELLED = 4.0 * equalities.REMAINDER
"""The same beside the terms of a computed entry: one below ``equalities.REMAINDER`` of them may have been set
to zero at any of the points."""
POINTS = 16
SEED = 20211217


def scheduled(name: str, given: Any) -> Scheduled:
    """A matrix as a function of the scheduling variables; an array is the same everywhere.

    Raises ParameterError for what is neither a function nor a matrix.

    >>> scheduled("A", [[0.0, 1.0]])({}).tolist()
    [[0.0, 1.0]]
    """
    if callable(given):
        function: Scheduled = given
        return function
    constant = matrix(name, given)
    return lambda point: constant


class TakagiSugeno:
    """A matrix that depends on scheduling variables, as a convex combination of constant ones.

    Exact on the whole box for matrices that are affine in each variable on its own: a proof at the vertices
    covers no others. ``of`` compares a function with the model in the middle and at random points of the box,
    and refuses one that differs there; one that differs elsewhere only is not noticed.

    M(p) = sum_i mu_i(p) M_i, M_i the value at vertex i, mu_i the weights of the box.

    Parameters: ``box``; ``matrices`` of shape (vertices, rows, columns), finite.
    Memory: the matrices. Raises ParameterError.

    Reference: Benyoucef et al. 2021, equations (24), (25).

    >>> box = Box({"a": (0.0, 1.0), "b": (-1.0, 1.0)})
    >>> model = TakagiSugeno.of(lambda p: np.array([[p["a"] * p["b"], 1.0]]), box)
    >>> model.at({"a": 0.5, "b": -0.5}).tolist()
    [[-0.25, 1.0]]
    >>> TakagiSugeno.of(lambda p: np.array([[p["a"] ** 2]]), box)
    Traceback (most recent call last):
    pointpred.errors.ParameterError: the matrix must be affine in each variable; it is off by 0.25 in row 1, \
column 1: make an expression that is not a variable of its own, and 0 of what is only rounding
    """

    def __init__(self, box: Box, matrices: FloatArray) -> None:
        self.box, self.matrices = box, np.asarray(matrices, np.float64)
        count = len(box.vertices)
        if self.matrices.ndim != 3 or len(self.matrices) != count:
            raise ParameterError(
                f"a model needs {count} matrices, one a vertex, received shape {self.matrices.shape}"
            )
        if not np.isfinite(self.matrices).all():
            raise ParameterError("a model needs finite matrices")

    @classmethod
    def of(
        cls, function: Scheduled, box: Box, name: str = "the matrix", *, terms: Scheduled | None = None
    ) -> Self:
        """The model of a function; raises ParameterError where it is not affine in each variable.

        Each entry is compared with the model by its own size, so that none hides behind larger ones.
        ``terms``: for a function that is itself computed, the sizes of the terms of its entries.
        """
        model = cls(box, np.array([function(box.named(vertex)) for vertex in box.vertices]))
        inside = samples(box)
        values = np.array([function(point) for point in inside])
        beside = None if terms is None else np.array([terms(point) for point in corners(box) + inside])
        place = difference(np.array([model.at(point) for point in inside]), values, model.matrices, beside)
        if place is not None:
            row, column, error = place
            raise ParameterError(
                f"{name} must be affine in each variable; it is off by {error:.3g} in row {row + 1}, "
                f"column {column + 1}: make an expression that is not a variable of its own, and 0 of "
                "what is only rounding",
                field=name,
            )
        return model

    def at(self, point: Mapping[str, float]) -> FloatArray:
        """The matrix at a point of the box; raises ParameterError for a point outside."""
        mixed: FloatArray = np.tensordot(self.box.weights(point), self.matrices, 1)
        return mixed


def corners(box: Box) -> list[dict[str, float]]:
    """The vertices of a box as points."""
    return [box.named(vertex) for vertex in box.vertices]


def samples(box: Box) -> list[dict[str, float]]:
    """The middle of a box and points that are spread in it, the same every time."""
    lows, highs = np.array(list(box.bounds.values())).T
    random = np.random.default_rng(SEED)
    shares = np.vstack([np.full(len(lows), 0.5), random.uniform(size=(POINTS, len(lows)))])
    return [box.named(lows + share * (highs - lows)) for share in shares]


def difference(
    left: FloatArray, right: FloatArray, more: FloatArray, terms: FloatArray | None
) -> tuple[int, int, float] | None:
    """The row and the column where two lists of matrices differ by more than rounding, and by how much.

    An entry is compared with its own largest value, also over the matrices ``more``, and with the largest of
    its ``terms``. ``None`` if all are equal.

    >>> one, other = np.array([[[1e6, 1e-6]]]), np.array([[[1e6, 2e-6]]])
    >>> difference(one, other, one, None)
    (0, 1, 1e-06)
    """
    sizes = np.abs(np.concatenate([left, right, more])).max(axis=0)
    allowed = NO_DIFFERENCE * sizes + (0.0 if terms is None else CANCELLED * np.abs(terms).max(axis=0))
    error = np.abs(left - right).max(axis=0)
    wrong = ~(error <= allowed)
    if not wrong.any():
        return None
    with np.errstate(all="ignore"):
        share = np.where(wrong, error / sizes, -1.0)
    row, column = np.unravel_index(int(np.nan_to_num(share, nan=np.inf).argmax()), share.shape)
    return int(row), int(column), float(error[row, column])
