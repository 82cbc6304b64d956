"""Linear regression on line: unknown constants from what is measured, and how far the data reach."""

from pointpred.regression.extension import DynamicRegressorExtension, Estimate
from pointpred.regression.recursive_least_squares import Fit, RecursiveLeastSquares

__all__ = ["DynamicRegressorExtension", "Estimate", "Fit", "RecursiveLeastSquares"]
