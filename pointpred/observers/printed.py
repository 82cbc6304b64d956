"""Audits of printed maps and observers: each equality's residual, and what rounding explains."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import CertificateError, ParameterError
from pointpred.observers.interconnected.generator import Generator, fitted
from pointpred.observers.interconnected.steady_state import residuals
from pointpred.observers.linear_systems import Plant, as_plant
from pointpred.observers.matrices import instance, matrix, positive
from pointpred.observers.persidskii import Persidskii

EXACT = 1e-9
"""A residual below this share of the largest entry is rounding of the computation."""

Residuals = Callable[[dict[str, FloatArray]], dict[str, FloatArray]]


def check_map(
    plant: Plant, generator: Generator, Pi: Any, *, relaxed: bool = False, rounding: float = 0.0
) -> dict[str, float]:
    """The largest residual of each equality of (3.3), or of Corollary 3.2.1, for a printed Pi.

    Parameters: ``relaxed`` as for ``steady_state_map``; ``rounding`` the largest error of an entry of Pi,
    such as half a unit of the last digit. Raises CertificateError naming each equality with a residual that
    the rounding cannot explain, to first order.

    Reference: Khalin 2022, Proposition 3.2.1, Corollary 3.2.1.

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
    return _audited(
        lambda given: residuals(one, generator, given["Pi"], relaxed=relaxed), {"Pi": pi}, (one, g), rounding
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

    def left(now: dict[str, FloatArray]) -> dict[str, FloatArray]:
        s0, b, onto = now.get("S0"), now.get("B"), z @ one.A0
        parts = {"Upsilon C1": upsilon @ one.C1}
        if s0 is not None or b is not None:
            if b is None:
                b = (onto - np.asarray(s0) @ z) @ np.linalg.pinv(one.C0)
            if s0 is None:
                s0 = (onto - b @ one.C0) @ np.linalg.pinv(z)
            parts["S0 Z + B C0 - Z A0"] = s0 @ z + b @ one.C0 - onto
        if "S1" in now:
            if b is None and one.C1.any():
                raise ParameterError("S1 depends on B where C1 is not 0: print S0 or B too", field="printed")
            parts["S1 - Z A1 + B C1"] = now["S1"] - z @ one.A1 + (0.0 if b is None else b @ one.C1)
        if "J" in now:
            parts["J Z - H"] = now["J"] @ z - one.H
        if "O" in now:
            parts["O - Z (B Q)"] = now["O"] - z @ inputs
        return parts

    return _audited(left, given, (one, upsilon, pi), rounding)


def _audited(
    left: Residuals, given: dict[str, FloatArray], sizes: tuple[Any, ...], rounding: float
) -> dict[str, float]:
    """The residuals; raises CertificateError for those that neither rounding explains."""
    rounding = positive("rounding", rounding, zero=True)
    found = left(given)
    effect = _effect(left, given, rounding) if rounding else dict.fromkeys(found, 0.0)
    scale = EXACT * max(1.0, *(_largest(one) for one in (*sizes, *given.values())))
    worst = {name: float(np.abs(one).max(initial=0.0)) for name, one in found.items()}
    failed = []
    for name, one in worst.items():
        if one > scale + effect[name]:
            excuse = (
                f"entries rounded by {rounding:g} explain at most {effect[name]:.6g}"
                if rounding
                else "nothing is rounded"
            )
            failed.append(f"{name} = 0 fails, its residual is {one:.6g}, {excuse}")
    if failed:
        raise CertificateError("; ".join(failed), field="printed", value=worst)
    return worst


def _effect(left: Residuals, given: dict[str, FloatArray], rounding: float) -> dict[str, float]:
    """How much each residual moves at most, to first order, if every printed entry moves by the rounding."""
    total: dict[str, FloatArray] = {}
    for name, value in given.items():
        for place in np.ndindex(value.shape):
            step = np.zeros_like(value)
            step[place] = rounding
            up, down = left({**given, name: value + step}), left({**given, name: value - step})
            for equality, one in up.items():
                total[equality] = total.get(equality, np.zeros_like(one)) + 0.5 * np.abs(one - down[equality])
    return {equality: float(one.max(initial=0.0)) for equality, one in total.items()}


def _largest(one: Any) -> float:
    if isinstance(one, Persidskii):
        return max(float(np.abs(part).max(initial=0.0)) for part in one.matrices(0.0).values())
    if isinstance(one, np.ndarray):
        return float(np.abs(one).max(initial=0.0))
    return max(
        float(np.abs(getattr(one, name)).max(initial=0.0)) for name in ("S0", "S1", "G", "L0", "L1", "E")
    )
