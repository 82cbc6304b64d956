"""The unknown matrices of a design problem as one vector, and affine functions of them found by probing.

A block is written once, as a numpy function of the matrices. Its coefficients are found by evaluating it at
unit vectors, so the solver's problem and the audit cannot differ.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from types import SimpleNamespace
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics import matrices

Block = Callable[[Any], Any]
"""A function of the matrices (attributes of its argument) that returns a symmetric matrix or a number."""

AFFINE = 1e-9
"""Relative error below which a block counts as symmetric and affine."""


class Unknown(msgspec.Struct, frozen=True):
    """One unknown matrix: ``kind`` is ``symmetric``, ``free``, ``diagonal`` or ``number``."""

    name: str
    kind: str
    rows: int
    columns: int
    low: float
    """Least value of each entry: 0 for diagonals and numbers that must not be negative."""

    def matrix(self, numbers: FloatArray) -> Any:
        """The matrix (or the number) from its entries in the vector."""
        if self.kind == "number":
            return float(numbers[0])
        found, (row, column) = np.zeros((self.rows, self.columns)), _places(self)
        found[row, column] = numbers
        if self.kind == "symmetric":
            found[column, row] = numbers
        return found

    def numbers(self, matrix: Any) -> FloatArray:
        """The entries of a matrix; raises ParameterError if its shape or its structure differs."""
        entries = matrices.matrix(self.name, matrix, self.rows, self.columns)
        numbers: FloatArray = entries[_places(self)]
        if not np.array_equal(np.atleast_2d(self.matrix(numbers)), entries):
            raise ParameterError(f"{self.name} must be {self.kind}, received {matrix!r}")
        return numbers


@cache
def _places(one: Unknown) -> tuple[Any, Any]:
    """The row and the column of each of its numbers."""
    if one.kind == "symmetric":
        return np.triu_indices(one.rows)
    row, column = np.indices((one.rows, one.columns)).reshape(2, -1)
    kept = row == column if one.kind == "diagonal" else np.ones(len(row), bool)
    return row[kept], column[kept]


class Unknowns:
    """All unknown matrices in order, and the conversion between them and one vector."""

    def __init__(self) -> None:
        self.listed: dict[Unknown, slice] = {}
        """Each with its place in the vector."""
        self.count = 0
        self._kept: dict[str, tuple[Block, FloatArray, FloatArray]] = {}
        self._terms: dict[str, FloatArray] = {}

    def add(self, unknown: Unknown) -> None:
        """Add one; raises ParameterError for a name in use."""
        if not unknown.name.isidentifier() or unknown.name in {one.name for one in self.listed}:
            raise ParameterError(
                f"an unknown needs a new name that is an identifier, received {unknown.name!r}"
            )
        start, self.count = self.count, self.count + len(_places(unknown)[0])
        self.listed[unknown] = slice(start, self.count)

    def matrices(self, numbers: FloatArray) -> SimpleNamespace:
        """The matrices as attributes."""
        return SimpleNamespace(**{one.name: one.matrix(numbers[at]) for one, at in self.listed.items()})

    def numbers(self, matrices: dict[str, Any]) -> FloatArray:
        """The vector of some matrices; raises ParameterError for a missing, unknown or misshapen one."""
        names = [one.name for one in self.listed]
        if set(matrices) != set(names):
            raise ParameterError(f"needs the matrices {names}, received {sorted(matrices)}")
        return np.concatenate([one.numbers(matrices[one.name]) for one in self.listed])

    def coefficients(self, name: str, block: Block) -> tuple[FloatArray, FloatArray]:
        """The constant part of a block and its coefficients, shape (numbers, n, n), found by probing.

        Raises ParameterError for a block that is not symmetric or not affine.
        """
        kept = self._kept.get(name)
        if kept is None or kept[0] is not block or len(kept[2]) != self.count:
            kept = self._kept[name] = (block, *self._probed(name, lambda at: symmetric(name, block(at))))
        return kept[1], kept[2]

    def equalities(self, blocks: dict[str, Block]) -> tuple[FloatArray, FloatArray]:
        """All numbers that satisfy every equality, as one solution and a basis of the rest.

        Raises InfeasibleError, with the residual, if the equalities contradict each other.
        """
        if not blocks:
            return np.zeros(self.count), np.eye(self.count)
        constants, slopes = [], []
        for name, block in blocks.items():
            constant, slope = self._probed(name, block)
            constants.append(constant.ravel())
            slopes.append(slope.reshape(self.count, -1).T)
        matrix, target = np.vstack(slopes), -np.concatenate(constants)
        x0: FloatArray = np.asarray(np.linalg.lstsq(matrix, target, rcond=None)[0], np.float64)
        residual = float(np.abs(matrix @ x0 - target).max())
        if residual > AFFINE * max(1.0, np.abs(target).max()):
            raise InfeasibleError(f"{', '.join(blocks)} cannot hold: the least residual is {residual:.3g}")
        _, sizes, rows = np.linalg.svd(matrix)
        rank = int((sizes > AFFINE * sizes.max(initial=0.0)).sum())
        basis: FloatArray = np.asarray(rows[rank:].T, np.float64)
        return x0, basis

    def _probed(self, name: str, function: Callable[[Any], Any]) -> tuple[FloatArray, FloatArray]:
        """The constant part and the slopes; only matrices that change the function are probed."""
        zero = vars(self.matrices(np.zeros(self.count)))
        constant: FloatArray = np.asarray(function(SimpleNamespace(**zero)), np.float64)
        slopes: FloatArray = np.zeros((self.count, *constant.shape))
        point = np.cos(np.arange(1.0, self.count + 1.0))
        for one, at in self.listed.items():

            def moved(numbers: FloatArray, one: Unknown = one) -> Any:
                return function(SimpleNamespace(**{**zero, one.name: one.matrix(numbers)}))

            if not np.array_equal(moved(point[at]), constant):
                slopes[at] = [moved(unit) - constant for unit in np.eye(at.stop - at.start)]
        expected = constant + np.tensordot(point, slopes, 1)
        error = np.abs(function(self.matrices(point)) - expected).max(initial=0.0)
        if not np.isfinite(error):
            raise ParameterError(
                f"{name} holds numbers that are too large to compute with: check the largest matrices",
                field=name,
            )
        if not error <= AFFINE * max(1.0, np.abs(expected).max(initial=0.0)):
            raise ParameterError(
                f"{name} must be affine in the unknown matrices; it is off by {error:.3g}", field=name
            )
        return constant, slopes

    def sizes(self, name: str, block: Block, numbers: FloatArray) -> FloatArray:
        """The size of each entry of a block, summed over its terms before they cancel."""
        constant, slopes = self.coefficients(name, block)
        largest = np.abs(numbers)
        for one, at in self.listed.items():
            if one.name in self._terms:
                largest[at] = np.maximum(largest[at], one.numbers(self._terms[one.name]))
        return np.asarray(np.abs(constant) + np.tensordot(largest, np.abs(slopes), 1))

    def computed(self, name: str, terms: FloatArray) -> None:
        """Give the sizes of the terms of a matrix that is computed, of which it may be a small difference."""
        self._terms[name] = terms

    def equality(self, name: str, block: Block, numbers: FloatArray) -> tuple[FloatArray, FloatArray]:
        """A block of any shape as rows, and the size of each entry's terms before they cancel."""
        constant, slopes = self._probed(name, block)
        terms = np.abs(constant) + np.tensordot(np.abs(numbers), np.abs(slopes), 1)
        left = np.asarray(block(self.matrices(numbers)), np.float64)
        return np.atleast_2d(left), np.atleast_2d(terms)


def symmetric(name: str, given: Any) -> FloatArray:
    """A matrix made exactly symmetric; raises ParameterError if it is not symmetric."""
    value: FloatArray = np.atleast_2d(np.asarray(given, np.float64))
    if value.ndim != 2 or value.shape[0] != value.shape[1]:
        raise ParameterError(f"{name} must be a square matrix, received shape {value.shape}", field=name)
    skew = np.abs(value - value.T).max(initial=0.0)
    if skew > AFFINE * max(1.0, np.abs(value).max(initial=0.0)):
        raise ParameterError(
            f"{name} must be symmetric; it differs from its transpose by {skew:.3g}", field=name
        )
    return 0.5 * (value + value.T)
