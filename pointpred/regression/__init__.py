"""Online linear regression: unknown constants from measurements, and the excitation of the data."""

from pointpred.regression.drem import DynamicRegressorExtension, Estimate
from pointpred.regression.least_squares import Fit, RecursiveLeastSquares

__all__ = ["DynamicRegressorExtension", "Estimate", "Fit", "RecursiveLeastSquares"]
