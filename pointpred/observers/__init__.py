"""Nonlinear observers with certificates that are proved: chapters 3 and 4 of the thesis."""

from pointpred.observers.excitation import (
    Excitation,
    discrete_excitation,
    linear_independence,
    persistent_excitation,
)
from pointpred.observers.generator import Generator
from pointpred.observers.matrix_inequalities import MatrixInequalities, Solution
from pointpred.observers.persidskii import Persidskii
from pointpred.observers.regressors import GradientRegressor
from pointpred.observers.simulate import SeededSignal, simulate
from pointpred.regression import RecursiveLeastSquares

__all__ = [
    "Excitation",
    "Generator",
    "GradientRegressor",
    "MatrixInequalities",
    "Persidskii",
    "RecursiveLeastSquares",
    "SeededSignal",
    "Solution",
    "discrete_excitation",
    "linear_independence",
    "persistent_excitation",
    "simulate",
]
