"""Theorems, assumptions and equations of the sources by their numbers, for researchers who check them."""

from pointpred_observers.interconnected.assumptions import (
    assumption_1_3_1,
    assumption_3_2_2,
    remark_3_2_2,
)
from pointpred_observers.interconnected.design import theorem_3_2_1
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage, regulator_stage
from pointpred_observers.interconnected.regulator import design_state_feedback
from pointpred_observers.interconnected.steady_state import regulator_equations, residuals
from pointpred_observers.interconnected.tracking import (
    SectorBounds,
    assumption_3_2_3,
    assumption_3_2_6,
    certify_tracking,
    closed_loop,
    sector_bounds,
    theorem_3_2_2,
    theorem_3_2_3,
)
from pointpred_observers.numerics.eigenvalues import undetectable
from pointpred_observers.plants.symbolic import check_steady_state
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities, check
from pointpred_observers.reduced_order.reversed_certificate import (
    certify_convergence,
    theorem_3_3_1,
    theorem_3_3_2,
)
from pointpred_observers.regressors.excitation import linear_independence, regression_margin
from pointpred_observers.triangular.interlaced_observer import assumption_4_4_2, theorem_4_4_1
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced

__all__ = [
    "MatrixInequalities",
    "PersidskiiStage",
    "SectorBounds",
    "assumption_1_3_1",
    "assumption_3_2_2",
    "assumption_3_2_3",
    "assumption_3_2_6",
    "assumption_4_4_2",
    "certify_convergence",
    "certify_interlaced",
    "certify_tracking",
    "check",
    "check_steady_state",
    "closed_loop",
    "design_state_feedback",
    "linear_independence",
    "regression_margin",
    "regulator_equations",
    "regulator_stage",
    "remark_3_2_2",
    "residuals",
    "sector_bounds",
    "theorem_3_2_1",
    "theorem_3_2_2",
    "theorem_3_2_3",
    "theorem_3_3_1",
    "theorem_3_3_2",
    "theorem_4_4_1",
    "undetectable",
]
