"""Nonlinear observers with certificates that are proved: chapters 3 and 4 of the thesis."""

from pointpred.observers.matrix_inequalities import MatrixInequalities, Solution

__all__ = [
    "MatrixInequalities",
    "Solution",
]
