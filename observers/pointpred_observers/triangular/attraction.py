"""Assumption 4.4.2: the generator is seen in the output, and the plant is drawn to its steady state."""

from __future__ import annotations

from itertools import product
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.eigenvalues import require_detectable
from pointpred_observers.plants.symbolic import SymbolicSteadyState, symbolic
from pointpred_observers.proofs.bounds import ErrorBound
from pointpred_observers.proofs.decay import DecayCertificate, certify_decay
from pointpred_observers.proofs.error_system import ErrorSystem
from pointpred_observers.triangular.interlaced_observer import output_matrix
from pointpred_observers.triangular.ranges import StateRegion, enclosure, intervals_of

TERMS_MOST = 8
"""Most different terms of the Jacobian: each doubles the number of corners."""
RESIDUAL_PARTS = 256
"""Parts of the box over which a residual is enclosed: a long expression, of which the size will do."""


class AttractionCertificate(msgspec.Struct, frozen=True):
    """Both parts of Assumption 4.4.2: ``C`` of h(rho, pi) = C w, and that x - pi(w), z - rho(w) decay.

    ``terms``: the terms of the Jacobian that vary, with their bounds over the ``region``; the ``certificate``
    holds while the plant's state, its steady state and w stay in it. ``residual``: the largest norm there of
    what a truncated steady state leaves of its equations, 0 for an exact one; the rest of ``bound`` is what
    it makes of the error.
    """

    C: FloatArray
    certificate: DecayCertificate
    terms: dict[str, tuple[float, float]]
    region: dict[str, tuple[float, float]]
    residual: float = 0.0

    @property
    def bound(self) -> ErrorBound:
        """The bound of x - pi(w), z - rho(w), for ``d`` in their equations."""
        return self.certificate.bound


def assumption_4_4_2(
    steady: SymbolicSteadyState,
    region: StateRegion = None,
    *,
    decay: float | None = None,
) -> AttractionCertificate:
    """A certificate of Assumption 4.4.2 in a region: detectable output, incrementally stable plant.

    1. h(rho(w), pi(w)) must be C w with (A, C) detectable. 2. Under u = l(w) two solutions of the plant
    approach each other, up to a disturbance d of its equations. By the mean value theorem their difference
    obeys the Jacobian somewhere in the box; each of its terms lies between its bounds over the box, so that
    one quadratic function for all corners of these bounds is a proof. The residuals of a steady state that is
    not exact are a disturbance d that never ends: the bound holds the largest over the region. A refusal
    proves nothing unless it names an eigenvalue at a point of the region.

    Parameters: ``region`` of the states x and z and of the generator's w that the Jacobian or the residuals
    contain, each (low, high), by symbol or by name; not needed for a linear plant; ``decay`` in 1/s, > 0, by
    default a fraction of the slowest corner's. Raises InfeasibleError naming the undetectable mode, or an
    eigenvalue that does not decay and its corner; ParameterError for an output that is not C w, a missing
    bound or more than 8 terms; what the solver raises.

    Reference: Khalin 2022, Assumption 4.4.2; Lohmiller and Slotine 1998.

    >>> import sympy as sp
    >>> from pointpred_observers import SymbolicGenerator, SymbolicSystem, interlaced
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2**2, -x2 + u), u, outputs=(x2,))
    >>> steady = interlaced(plant, SymbolicGenerator((w1, w2), (w2, -w1)), upper=1, first=w1, degree=2)
    >>> found = assumption_4_4_2(steady, {x2: (-1.0, 1.0)}, decay=0.5)
    >>> found.C.tolist(), {name: [round(one, 6) for one in pair] for name, pair in found.terms.items()}
    ([[1.0, 0.0]], {'x2': [-1.0, 1.0]})
    """
    c = output_matrix(steady)
    require_detectable(steady.generator.matrix(), c, "continuous", "(A, C)")
    system, states = steady.system, (*steady.system.states, *steady.system.zero)
    if parameters := system.parameters() - {*steady.generator.states}:
        raise ParameterError(f"parameters without value: {sorted(map(str, parameters))}")
    box = {} if region is None else intervals_of(region, (*states, *steady.generator.states))
    n = len(states)
    # The Jacobian under u = l(w): a constant part, and the coefficients of each term that varies.
    constant, terms = np.zeros((n, n)), dict[Any, FloatArray]()
    for (i, row), (j, state) in product(enumerate((*system.field, *system.zero_field)), enumerate(states)):
        entry = symbolic().expand(symbolic().diff(row, state).subs(system.input, steady.input))
        for summand in symbolic().Add.make_args(entry):
            factor, term = summand.as_independent(*summand.free_symbols, as_Add=False)
            if summand.free_symbols:
                terms.setdefault(term, np.zeros((n, n)))[i, j] += float(factor)
            else:
                constant[i, j] += float(summand)
    if len(terms) > TERMS_MOST:
        raise ParameterError(
            f"the Jacobian has {len(terms)} different terms, at most {TERMS_MOST} are allowed: "
            f"{', '.join(map(str, terms))}"
        )
    ranges = {term: enclosure(term, box) for term in terms}
    names, corners = [], []
    for chosen in product(*ranges.values()):
        corners.append(sum((v * slope for v, slope in zip(chosen, terms.values(), strict=True)), constant))
        names.append(", ".join(f"{term} = {v:.6g}" for term, v in zip(terms, chosen, strict=True)))
    drive = np.broadcast_to(np.eye(n), (len(corners), n, n)).copy()
    errors = ErrorSystem(np.array(corners), drive, np.eye(n), tuple(names), {"d": n}, "continuous")
    try:
        found = certify_decay(errors, decay=decay)
    except ArithmeticError as failure:
        raise type(failure)(f"Assumption 4.4.2: {failure}") from failure
    ends = [enclosure(one, box, RESIDUAL_PARTS) for one in steady.residuals if one != 0]
    residual = float(np.linalg.norm([max(-low, high) for low, high in ends]))
    rest = found.bound.gains[0] * residual
    found = msgspec.structs.replace(found, bound=msgspec.structs.replace(found.bound, rest=rest))
    named, within = ({str(one): pair for one, pair in part.items()} for part in (ranges, box))
    return AttractionCertificate(c, found, named, within, residual)
