"""Audits of printed maps and observers: each equality's residual, and what rounding explains."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pointpred.errors import CertificateError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.steady_state import equalities, residuals
from pointpred_observers.numerics.equalities import allowed
from pointpred_observers.numerics.matrices import instance, matrix, positive
from pointpred_observers.plants.generator import Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, as_plant

Residuals = Callable[[dict[str, FloatArray]], dict[str, FloatArray]]


def check_map(
    plant: Plant, generator: Generator, Pi: Any, *, relaxed: bool = False, rounding: float = 0.0
) -> dict[str, float]:
    """The largest residual of each equality of (3.3), or of Corollary 3.2.1, for a printed Pi.

    Parameters: ``relaxed`` as for ``steady_state_map``; ``rounding`` the largest error of an entry of Pi,
    such as half a unit of the last digit. Raises CertificateError naming each equality with a residual that
    the rounding cannot explain, to first order.

    Reference: Khalin 2022, Proposition 3.2.1, Corollary 3.2.1.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-3.0]], None, None, "sin", B=[1.0])
    >>> generator = Generator([[0.0]], L0=[1.0])
    >>> found = check_map(plant, generator, [[0.333]], rounding=5e-4)
    >>> {name: round(residual, 9) for name, residual in found.items()}
    {'A0 Pi - Pi G C0 Pi - Pi S0 + B L0': 0.001}
    >>> check_map(plant, generator, [[0.3]], rounding=0.025)
    Traceback (most recent call last):
    pointpred.errors.CertificateError: A0 Pi - Pi G C0 Pi - Pi S0 + B L0 = 0 fails, its residual is 0.1, \
entries rounded by 0.025 explain at most 0.075
    """
    one = as_plant(plant)
    g = fitted(generator, one)
    pi = matrix("Pi", Pi, one.n, g.q)
    if not relaxed:
        require_same_nonlinearity(one, generator)
    return _audited(
        lambda given: residuals(one, generator, given["Pi"], relaxed=relaxed),
        {name: terms for name, (_, terms) in equalities(one, generator, pi, relaxed=relaxed).items()},
        {"Pi": pi},
        rounding,
    )


def check_observer(
    plant: Plant, Pi: Any, Upsilon: Any, printed: dict[str, Any], *, rounding: float = 0.0
) -> dict[str, float]:
    """The largest residual of each equality of (3.20), (3.21) for the printed matrices of an observer.

    With Z = Pi + Upsilon C0: Upsilon C1 = 0, S0 Z + B C0 = Z A0, S1 = Z A1 - B C1, J Z = H, O = Z (B Q). An
    equality is checked if its matrices are printed; where only one of S0 and B is, the other is the best
    there is. Discrete observers of constant matrices have the same equalities, (3.23), (3.24).

    Parameters: ``printed`` some of S0 (q, q), S1 (q, k), J (r, q), B (q, p), O (q, inputs); ``rounding`` the
    largest error of a printed entry (not of Pi and Upsilon). Raises CertificateError naming each equality
    with a residual that the rounding cannot explain; ParameterError for an unknown name or a shape.

    Reference: Khalin 2022, Propositions 3.3.1 and 3.3.2; its C0, C1 are D0, D1.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", B=[0.0, 1.0], C0=[1.0, 0.0])
    >>> check_observer(plant, [[0.0, 1.0]], [[-3.0]], {"S0": [[-4.0]], "O": [[1.0]]})
    {'Upsilon C1': 0.0, 'S0 Z + B C0 - Z A0': 0.0, 'O - Z (B Q)': 0.0}
    >>> check_observer(plant, [[0.0, 1.0]], [[-3.0]], {"S0": [[-2.0]], "B": [[-12.0]]})
    Traceback (most recent call last):
    pointpred.errors.CertificateError: S0 Z + B C0 - Z A0 = 0 fails, its residual is 6, nothing is rounded
    """
    one = as_plant(plant)
    if one.varying:
        raise ParameterError(
            f"printed observers are checked for constant matrices; {', '.join(one.varying)} vary"
        )
    pi = matrix("Pi", Pi, None, one.n)
    q = len(pi)
    upsilon = np.zeros((q, one.p)) if Upsilon is None else matrix("Upsilon", Upsilon, q, one.p)
    z, inputs = pi + upsilon @ one.C0, np.hstack([one.B, one.Q])
    shapes = {"S0": (q, q), "S1": (q, one.k), "J": (one.r, q), "B": (q, one.p), "O": (q, inputs.shape[1])}
    instance("printed", printed, dict)
    if not printed or set(printed) - set(shapes):
        raise ParameterError(
            f"printed may hold {', '.join(shapes)}, received {', '.join(map(str, printed)) or 'nothing'}",
            field="printed",
        )
    given = {name: matrix(name, value, *shapes[name]) for name, value in printed.items()}

    if "S1" in given and not {"S0", "B"} & set(given) and one.C1.any():
        raise ParameterError("S1 depends on B where C1 is not 0: print S0 or B too", field="printed")

    def dynamics(now: dict[str, FloatArray]) -> dict[str, FloatArray]:
        """The matrices, with the best S0 or B where only the other one is printed."""
        s0, b, onto = now.get("S0"), now.get("B"), z @ one.A0
        if b is None and s0 is not None:
            return {**now, "B": (onto - s0 @ z) @ np.linalg.pinv(one.C0)}
        if s0 is None and b is not None:
            return {**now, "S0": (onto - b @ one.C0) @ np.linalg.pinv(z)}
        return now

    def parts(whole: dict[str, FloatArray], part: Any, minus: float) -> dict[str, FloatArray]:
        """The left side of each equality, of the ``part`` of each matrix; ``minus`` is the sign within it."""
        whole = {name: part(value) for name, value in whole.items()}
        a0, a1, h, c0, c1 = (part(value) for value in (one.A0, one.A1, one.H, one.C0, one.C1))
        onto = part(pi) + part(upsilon) @ c0
        listed = {"Upsilon C1": part(upsilon) @ c1}
        if "S0" in whole:
            listed["S0 Z + B C0 - Z A0"] = whole["S0"] @ onto + whole["B"] @ c0 + minus * (onto @ a0)
        if "S1" in whole:
            listed["S1 - Z A1 + B C1"] = whole["S1"] + minus * (onto @ a1)
            if "B" in whole:
                listed["S1 - Z A1 + B C1"] = listed["S1 - Z A1 + B C1"] + whole["B"] @ c1
        if "J" in whole:
            listed["J Z - H"] = whole["J"] @ onto + minus * h
        if "O" in whole:
            listed["O - Z (B Q)"] = whole["O"] + minus * (onto @ part(inputs))
        return listed

    terms = parts(dynamics(given), np.abs, 1.0)
    return _audited(lambda now: parts(dynamics(now), np.asarray, -1.0), terms, given, rounding)


def _audited(
    left: Residuals, terms: dict[str, FloatArray], given: dict[str, FloatArray], rounding: float
) -> dict[str, float]:
    """The residuals; raises CertificateError for an entry that neither rounding explains.

    What is rounding of the computation is a share of the entry's own terms.
    """
    rounding = positive("rounding", rounding, zero=True)
    found = left(given)
    none = {name: np.zeros_like(one) for name, one in found.items()}
    effect = _effect(left, given, rounding) if rounding else none
    failed = []
    for name, one in found.items():
        excess = np.abs(one) - effect[name] - allowed(terms[name])
        if not (excess <= 0.0).all():
            place = np.unravel_index(int(np.argmax(excess)), excess.shape)
            excuse = (
                f"entries rounded by {rounding:g} explain at most {effect[name][place]:.6g}"
                if rounding
                else "nothing is rounded"
            )
            failed.append(f"{name} = 0 fails, its residual is {abs(one[place]):.6g}, {excuse}")
    worst = {name: float(np.abs(one).max(initial=0.0)) for name, one in found.items()}
    if failed:
        raise CertificateError("; ".join(failed), field="printed", value=worst)
    return worst


def _effect(left: Residuals, given: dict[str, FloatArray], rounding: float) -> dict[str, FloatArray]:
    """How much each entry of a residual moves at most, to first order, where printed entries are rounded."""
    total: dict[str, FloatArray] = {}
    for name, value in given.items():
        for place in np.ndindex(value.shape):
            step = np.zeros_like(value)
            step[place] = rounding
            up, down = left({**given, name: value + step}), left({**given, name: value - step})
            for equality, one in up.items():
                total[equality] = total.get(equality, np.zeros_like(one)) + 0.5 * np.abs(one - down[equality])
    return total
