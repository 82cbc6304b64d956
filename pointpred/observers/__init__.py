"""Nonlinear observers with certificates that are proved: chapters 3 and 4 of the thesis."""

from pointpred.observers.bounds import ErrorBound, convergence_bound, interconnection_bound
from pointpred.observers.boxes import Box
from pointpred.observers.design import ObserverDesign, design_observer
from pointpred.observers.detectability import undetectable
from pointpred.observers.excitation import (
    Excitation,
    discrete_excitation,
    linear_independence,
    persistent_excitation,
)
from pointpred.observers.feedback_form import feedback
from pointpred.observers.feedforward_form import feedforward
from pointpred.observers.generator import Generator
from pointpred.observers.interconnection import theorem_3_2_1
from pointpred.observers.interlaced_certificate import InterlacedCertificate
from pointpred.observers.interlaced_certificate import certify as certify_interlaced
from pointpred.observers.interlaced_form import interlaced
from pointpred.observers.interlaced_observer import InterlacedEstimate, InterlacedObserver
from pointpred.observers.invariant_stage import invariant_stage
from pointpred.observers.matrix_inequalities import MatrixInequalities, Solution
from pointpred.observers.nonlinear_regression import NonlinearRegressor, RegressionMargin, regression_margin
from pointpred.observers.persidskii import Persidskii
from pointpred.observers.persidskii_observer import PersidskiiObserver, observer_stage, regulator_stage
from pointpred.observers.printed import check
from pointpred.observers.reduced_order import ReducedOrderDesign, design_reduced_order
from pointpred.observers.regressors import GradientRegressor
from pointpred.observers.reversed_certificate import Convergence, certify_convergence
from pointpred.observers.reversed_connection import InvariantObserver, invariant_observer
from pointpred.observers.sector import SectorBounds, sector_bounds
from pointpred.observers.simulate import SeededSignal, simulate
from pointpred.observers.steady_state import SteadyState, residuals, steady_state_map
from pointpred.observers.takagi_sugeno import TakagiSugeno
from pointpred.observers.tracking import (
    TrackingCertificate,
    certify_tracking,
    closed_loop,
    theorem_3_2_2,
    theorem_3_2_3,
)
from pointpred.observers.triangular import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem
from pointpred.observers.unknown_input import UnknownInputObserver
from pointpred.observers.unknown_input_certificate import UnknownInputCertificate
from pointpred.observers.unknown_input_run import UnknownInputEstimate, UnknownInputSample
from pointpred.observers.unknown_input_system import ParameterVaryingSystem
from pointpred.regression import RecursiveLeastSquares

__all__ = [
    "Box",
    "Convergence",
    "ErrorBound",
    "Excitation",
    "Generator",
    "GradientRegressor",
    "InterlacedCertificate",
    "InterlacedEstimate",
    "InterlacedObserver",
    "InvariantObserver",
    "MatrixInequalities",
    "NonlinearRegressor",
    "ObserverDesign",
    "ParameterVaryingSystem",
    "Persidskii",
    "PersidskiiObserver",
    "RecursiveLeastSquares",
    "ReducedOrderDesign",
    "RegressionMargin",
    "SectorBounds",
    "SeededSignal",
    "Solution",
    "SteadyState",
    "SymbolicGenerator",
    "SymbolicSteadyState",
    "SymbolicSystem",
    "TakagiSugeno",
    "TrackingCertificate",
    "UnknownInputCertificate",
    "UnknownInputEstimate",
    "UnknownInputObserver",
    "UnknownInputSample",
    "certify_convergence",
    "certify_interlaced",
    "certify_tracking",
    "check",
    "closed_loop",
    "convergence_bound",
    "design_observer",
    "design_reduced_order",
    "discrete_excitation",
    "feedback",
    "feedforward",
    "interconnection_bound",
    "interlaced",
    "invariant_observer",
    "invariant_stage",
    "linear_independence",
    "observer_stage",
    "persistent_excitation",
    "regression_margin",
    "regulator_stage",
    "residuals",
    "sector_bounds",
    "simulate",
    "steady_state_map",
    "theorem_3_2_1",
    "theorem_3_2_2",
    "theorem_3_2_3",
    "undetectable",
]
