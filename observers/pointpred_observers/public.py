"""The public names of the package."""

from pointpred.regression import RecursiveLeastSquares
from pointpred_observers.bounds import ErrorBound, convergence_bound, interconnection_bound
from pointpred_observers.detectability import undetectable
from pointpred_observers.discretisation import c2d
from pointpred_observers.documents.files import audit, load, save
from pointpred_observers.error_equations import error_system
from pointpred_observers.error_systems.decay import DecayCertificate, certify_decay
from pointpred_observers.error_systems.l2_gain import L2Gain, l2_gain
from pointpred_observers.error_systems.system import ErrorSystem
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities, Solution, check
from pointpred_observers.interconnected.assumptions import assumption_3_2_3, assumption_3_2_6
from pointpred_observers.interconnected.design import ObserverDesign, design_observer
from pointpred_observers.interconnected.full_order import design_full_order
from pointpred_observers.interconnected.generator import Generator
from pointpred_observers.interconnected.incremental import assumption_3_2_2
from pointpred_observers.interconnected.interconnection import theorem_3_2_1
from pointpred_observers.interconnected.missing_inputs import MissingInputs
from pointpred_observers.interconnected.persidskii_observer import (
    PersidskiiObserver,
    observer_stage,
    regulator_stage,
)
from pointpred_observers.interconnected.regulator import RegulatorDesign, design_regulator
from pointpred_observers.interconnected.regulator_equations import RegulatorEquations, regulator_equations
from pointpred_observers.interconnected.sector import SectorBounds, sector_bounds
from pointpred_observers.interconnected.state_feedback import StateFeedback, design_state_feedback
from pointpred_observers.interconnected.steady_state import SteadyState, residuals, steady_state_map
from pointpred_observers.interconnected.tracking import (
    TrackingCertificate,
    certify_tracking,
    closed_loop,
    theorem_3_2_2,
    theorem_3_2_3,
)
from pointpred_observers.linear_systems import as_plant
from pointpred_observers.persidskii import Persidskii
from pointpred_observers.reduced_order.convergence import Convergence
from pointpred_observers.reduced_order.design import ReducedOrderDesign, design_reduced_order
from pointpred_observers.reduced_order.invariant_stage import invariant_stage
from pointpred_observers.reduced_order.reversed_certificate import (
    certify_convergence,
    theorem_3_3_1,
    theorem_3_3_2,
)
from pointpred_observers.reduced_order.reversed_connection import (
    InvariantObserver,
    invariant_observer,
)
from pointpred_observers.regressors.excitation import (
    Excitation,
    RegressionMargin,
    linear_independence,
    persistent_excitation,
    regression_margin,
)
from pointpred_observers.regressors.gradient import GradientRegressor, NonlinearRegressor
from pointpred_observers.simulations.regressions import Regression
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.simulate import simulate
from pointpred_observers.trajectories import SeededSignal, trajectory
from pointpred_observers.triangular.attraction import AttractionCertificate, assumption_4_4_2
from pointpred_observers.triangular.forms import interlaced
from pointpred_observers.triangular.interlaced_observer import (
    InterlacedCertificate,
    InterlacedEstimate,
    InterlacedObserver,
    InterlacedStage,
    theorem_4_4_1,
)
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.triangular.system import (
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    check_steady_state,
)
from pointpred_observers.unknown_input.boxes import Box
from pointpred_observers.unknown_input.certificate import UnknownInputCertificate
from pointpred_observers.unknown_input.corners import CornerSystem
from pointpred_observers.unknown_input.invariant_zeros import invariant_zeros
from pointpred_observers.unknown_input.observer import UnknownInputObserver, zeros_over
from pointpred_observers.unknown_input.run import UnknownInputEstimate, UnknownInputSample
from pointpred_observers.unknown_input.system import ParameterVaryingSystem
from pointpred_observers.unknown_input.takagi_sugeno import TakagiSugeno

__all__ = [
    "AttractionCertificate",
    "Box",
    "Convergence",
    "CornerSystem",
    "DecayCertificate",
    "ErrorBound",
    "ErrorSystem",
    "Excitation",
    "Generator",
    "GradientRegressor",
    "InterlacedCertificate",
    "InterlacedEstimate",
    "InterlacedObserver",
    "InterlacedStage",
    "InvariantObserver",
    "L2Gain",
    "MatrixInequalities",
    "MissingInputs",
    "NonlinearRegressor",
    "ObserverDesign",
    "ParameterVaryingSystem",
    "Persidskii",
    "PersidskiiObserver",
    "RecursiveLeastSquares",
    "ReducedOrderDesign",
    "Regression",
    "RegressionMargin",
    "RegulatorDesign",
    "RegulatorEquations",
    "SectorBounds",
    "SeededSignal",
    "Simulation",
    "Solution",
    "StateFeedback",
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
    "as_plant",
    "assumption_3_2_2",
    "assumption_3_2_3",
    "assumption_3_2_6",
    "assumption_4_4_2",
    "audit",
    "c2d",
    "certify_convergence",
    "certify_decay",
    "certify_interlaced",
    "certify_tracking",
    "check",
    "check_steady_state",
    "closed_loop",
    "convergence_bound",
    "design_full_order",
    "design_observer",
    "design_reduced_order",
    "design_regulator",
    "design_state_feedback",
    "error_system",
    "interconnection_bound",
    "interlaced",
    "invariant_observer",
    "invariant_stage",
    "invariant_zeros",
    "l2_gain",
    "linear_independence",
    "load",
    "observer_stage",
    "persistent_excitation",
    "regression_margin",
    "regulator_equations",
    "regulator_stage",
    "residuals",
    "save",
    "sector_bounds",
    "simulate",
    "steady_state_map",
    "theorem_3_2_1",
    "theorem_3_2_2",
    "theorem_3_2_3",
    "theorem_3_3_1",
    "theorem_3_3_2",
    "theorem_4_4_1",
    "trajectory",
    "undetectable",
    "zeros_over",
]
