"""The public names of the package; what the thesis calls by numbers is in ``thesis``."""

from pointpred.regression import RecursiveLeastSquares
from pointpred_observers.files import audit, load, save
from pointpred_observers.interconnected.steady_state import steady_state_map
from pointpred_observers.kinds import design, simulate, stage
from pointpred_observers.observer import Observer
from pointpred_observers.plants.boxes import Box
from pointpred_observers.plants.generator import Generator, c2d
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.plants.symbolic import SymbolicGenerator, SymbolicSystem
from pointpred_observers.plants.varying import (
    CornerSystem,
    ParameterVaryingSystem,
    invariant_zeros,
)
from pointpred_observers.proofs.error_system import ErrorSystem, certify_decay, l2_gain
from pointpred_observers.reduced_order.reversed_connection import invariant_observer
from pointpred_observers.regressors.excitation import persistent_excitation
from pointpred_observers.regressors.gradient import GradientRegressor, NonlinearRegressor
from pointpred_observers.simulations.signals import trajectory
from pointpred_observers.triangular.forms import interlaced
from pointpred_observers.unknown_input.stage import UnknownInputSample

__all__ = [
    "Box",
    "CornerSystem",
    "ErrorSystem",
    "Generator",
    "GradientRegressor",
    "NonlinearRegressor",
    "Observer",
    "ParameterVaryingSystem",
    "Persidskii",
    "RecursiveLeastSquares",
    "SymbolicGenerator",
    "SymbolicSystem",
    "UnknownInputSample",
    "audit",
    "c2d",
    "certify_decay",
    "design",
    "interlaced",
    "invariant_observer",
    "invariant_zeros",
    "l2_gain",
    "load",
    "persistent_excitation",
    "save",
    "simulate",
    "stage",
    "steady_state_map",
    "trajectory",
]
