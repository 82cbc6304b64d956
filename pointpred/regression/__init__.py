"""Online linear regression: unknown constants from measurements, and the excitation of the data."""

from pointpred.regression.extension import DynamicRegressorExtension, Estimate
from pointpred.regression.recursive_least_squares import Fit, RecursiveLeastSquares

__all__ = ["DynamicRegressorExtension", "Estimate", "Fit", "RecursiveLeastSquares"]
