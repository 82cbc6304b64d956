"""Dynamic regulators (3.8): an observer of the plant, a feedback of its state, and a reference."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.equalities import TOLERANCE, share_of_terms
from pointpred_observers.interconnected.design import ObserverDesign, design_observer
from pointpred_observers.interconnected.generator import Generator, fitted
from pointpred_observers.interconnected.regulator_equations import RegulatorEquations, regulator_equations
from pointpred_observers.interconnected.state_feedback import StateFeedback, design_state_feedback
from pointpred_observers.linear_systems import Plant, as_plant
from pointpred_observers.matrices import positive
from pointpred_observers.persidskii import Persidskii


class RegulatorDesign(msgspec.Struct, frozen=True):
    """A regulator for ``regulator_stage``, and what proves that x follows Pi w.

    ``observer`` certifies z = x - Pi w: z' = (A0 - Pi G C0) z + (A1 - Pi G C1) df + d - Pi G v, its bound's
    ``w`` being d and its ``v`` the noise v. ``feedback`` certifies Pi w, driven by Pi G (C0 z + C1 df + v): a
    cascade, so that both approach their steady state. With a reference, the last states of w are the
    reference's, and ``equations`` are those that they satisfy.
    """

    plant: Persidskii
    regulator: Generator
    Pi: FloatArray
    observer: ObserverDesign
    feedback: StateFeedback
    equations: RegulatorEquations | None = None


def design_regulator(
    plant: Plant,
    *,
    decay: float = 1.0,
    observer_decay: float | None = None,
    L1: Any = None,
    reference: Generator | None = None,
    following: tuple[Any, Any] | None = None,
    solver: str = "CLARABEL",
    **bounds: float,
) -> RegulatorDesign:
    """A regulator w' = S0 w + S1 f(Jw) + G Y + E rho, u = L0 w + L1 f(Jw), with proofs of its convergence.

    Without ``reference`` Pi = I: w is an observer of the plant, and u feeds it back:
    S0 = A0 + B L0 - G C0, S1 = A1 + B L1 - G C1, J = H, E = Q. G comes from ``design_observer``, L0 and L1
    from ``design_state_feedback``; x - w does not depend on the feedback.

    With a ``reference`` r' = Sr r + Er rho and ``following`` = (R, F), R x approaches F r: w = (w1, r), Pi =
    (I 0), u = K w1 + (Lr - K Pir) r + L1 f(H w1), Pir and Lr from ``regulator_equations``. This needs a
    nonlinearity that the input can cancel, A1 + B L1 = 0, or none; else R x would have a steady state that is
    not linear in r.

    Proves more than Corollary 3.2.2 (global where the slopes are, slopes that change sign allowed) by other
    conditions; ``certify_tracking`` may refuse what is proved here, as its Assumption 3.2.3 needs J S~ < 0.

    Parameters: ``decay`` in 1/s (1/step) of the closed loop and, unless ``observer_decay`` is given, of x -
    w; ``L1`` as for ``design_state_feedback``; ``margin`` and ``kappa`` as for ``MatrixInequalities``.
    Raises InfeasibleError naming an undetectable mode, a mode that no input moves, or the equality of the
    reference that cannot hold; what the solver raises; ParameterError.

    Reference: Khalin 2022, section 3.2.3, (3.8), (3.12)-(3.15).

    >>> a0, b = [[0.0, 1.0], [0.0, 0.0]], [0.0, 1.0]
    >>> mass = Persidskii(a0, [0.0, 1.0], [1.0, 0.0], "sin", b, None, [1.0, 0.0])
    >>> design = design_regulator(mass, decay=1.0)
    >>> min(design.observer.margins.values()) > 0.0, min(design.feedback.certificate.margins.values()) > 0.0
    (True, True)
    """
    one, decay = as_plant(plant), positive("decay", decay)
    faster = decay if observer_decay is None else positive("observer_decay", observer_decay)
    if (reference is None) != (following is None):
        raise ParameterError("give reference and following = (R, F) together: R x is to follow F r")
    copied = Generator(one.A0, one.A1, one.H, E=one.Q)
    observer = design_observer(one, copied, np.eye(one.n), decay=faster, solver=solver, **bounds)
    if reference is None:
        feedback = design_state_feedback(one, decay=decay, L1=L1, solver=solver, **bounds)
        return RegulatorDesign(
            one, _regulator(one, observer.gain, feedback), np.eye(one.n), observer, feedback
        )
    if reference.S1 is not None and reference.S1.any():
        raise ParameterError(
            "a reference is linear, r' = Sr r + Er rho, received one with S1 other than 0", field="S1"
        )
    equations = regulator_equations(one, reference, following=following)
    cancelling = equations.L1 if L1 is None else L1
    feedback = design_state_feedback(one, decay=decay, L1=cancelling, solver=solver, **bounds)
    left, terms = (
        one.A1 + one.B @ feedback.L1,
        np.abs(one.A1) + np.abs(one.B) @ np.abs(feedback.L1),
    )
    if not share_of_terms(left, terms) <= TOLERANCE:
        raise InfeasibleError(
            f"a reference needs A1 + B L1 = 0, its residual is {np.abs(left).max():.6g}: f is not cancelled, "
            "and the steady state is not linear in r"
        )
    regulator, pi = _servo(one, observer.gain, feedback, reference, equations)
    return RegulatorDesign(one, regulator, pi, observer, feedback, equations)


def _regulator(plant: Persidskii, gain: FloatArray, feedback: StateFeedback) -> Generator:
    """The regulator with Pi = I, from (3.3)."""
    s0 = plant.A0 + plant.B @ feedback.L0 - gain @ plant.C0
    s1 = plant.A1 + plant.B @ feedback.L1 - gain @ plant.C1
    return Generator(s0, s1, plant.H, gain, feedback.L0, feedback.L1, plant.Q)


def _servo(
    plant: Persidskii,
    gain: FloatArray,
    feedback: StateFeedback,
    reference: Generator,
    equations: RegulatorEquations,
) -> tuple[Generator, FloatArray]:
    """The regulator with the reference's states behind its own, and Pi = (I 0)."""
    r, n, q = fitted(reference, plant, "reference"), plant.n, reference.q
    pi = np.hstack([np.eye(n), np.zeros((n, q))])
    l0 = np.hstack([feedback.L0, equations.L0 - feedback.L0 @ equations.Pi])
    whole = np.block([[plant.A0 + plant.B @ feedback.L0, plant.B @ l0[:, n:]], [np.zeros((q, n)), r.S0]])
    g = np.vstack([gain, np.zeros((q, plant.p))])
    s1 = plant.A1 + plant.B @ feedback.L1 - gain @ plant.C1
    return Generator(
        whole - g @ plant.C0 @ pi,
        np.vstack([s1, np.zeros((q, plant.k))]),
        plant.H @ pi,
        g,
        l0,
        feedback.L1,
        np.vstack([plant.Q, r.E]),
    ), pi
