"""Takagi-Sugeno models: matrices at the vertices of a box, mixed by multilinear weights."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Self

import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import ParameterError
from pointpred.observers.matrices import matrix
from pointpred.observers.unknown_input.boxes import Box

Scheduled = Callable[[Mapping[str, float]], FloatArray]
"""A matrix as a function of the scheduling variables."""
ROUNDING = 1e-9
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

    Exact on the whole box for matrices that are affine in each variable on its own; others are refused,
    because a proof at the vertices would not cover them.

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
    pointpred.errors.ParameterError: the matrix must be affine in each variable; it is off by 0.25
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
    def of(cls, function: Scheduled, box: Box, name: str = "the matrix") -> Self:
        """The model of a function; raises ParameterError where it is not affine in each variable."""
        model = cls(box, np.array([function(box.named(vertex)) for vertex in box.vertices]))
        lows, highs = np.array(list(box.bounds.values())).T
        random = np.random.default_rng(SEED)
        shares = np.vstack([np.full(len(lows), 0.5), random.uniform(size=(POINTS, len(lows)))])
        error = 0.0
        for share in shares:
            point = box.named(lows + share * (highs - lows))
            error = max(error, float(np.abs(model.at(point) - function(point)).max()))
        if error > ROUNDING * max(1.0, float(np.abs(model.matrices).max())):
            raise ParameterError(
                f"{name} must be affine in each variable; it is off by {error:.3g}", field=name
            )
        return model

    def at(self, point: Mapping[str, float]) -> FloatArray:
        """The matrix at a point of the box; raises ParameterError for a point outside."""
        mixed: FloatArray = np.tensordot(self.box.weights(point), self.matrices, 1)
        return mixed
