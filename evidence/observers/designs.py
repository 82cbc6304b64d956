"""Count what becomes of random problems: ``python -m evidence observers designs [doors | facts | CALL ...]``.

``doors`` are all calls of the table; a call, such as "certify_tracking", measures its row only.
"""

from __future__ import annotations

import zlib
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import product
from typing import Any

import mpmath
import numpy as np

from evidence.arguments import parse
from evidence.data import Table, keep, stored
from evidence.machine import machine
from evidence.observers.plants import DOORS, KINDS, Problem
from pointpred.errors import InfeasibleError, PointpredError
from pointpred_observers import RecursiveLeastSquares, invariant_observer, steady_state_map
from pointpred_observers.camera import camera_box, camera_system
from pointpred_observers.examples import (
    ROBOT_INPUT_MODIFIED,
    UNMEASURED,
    Bioreactor,
    academic,
    chua_circuits,
    robotic_arm,
    two_masses,
    two_sensors,
    vapours,
)
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.interconnected.tracking import theorem_3_2_2, theorem_3_2_3
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.thesis import certify_convergence, certify_tracking, regression_margin
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.unknown_input.certificate import ROOMS
from pointpred_observers.unknown_input.observer import UnknownInputObserver


def least_gamma(p: mpmath.mpf, sigma: mpmath.mpf, bounds: dict[str, Any]) -> mpmath.mpf:
    """The largest eigenvalue of (-M)^-1 P R R' P over the vertices, with P = diag(p, 1) on (chi, eta)."""
    worst = mpmath.mpf(0)
    # The signs of a_z, w_x and w_y do not change the eigenvalues.
    a_z, w_x, w_y = (bounds[name][1] for name in ("a_z", "w_x", "w_y"))
    for zero, eta in product(bounds["zero"], bounds["eta"]):
        half = sigma / 2
        m = mpmath.matrix([[2 * p * (zero + half), a_z], [a_z, 2 * (eta + half)]])
        right = mpmath.matrix([[p * p, 0], [0, 1 + w_x**2 + w_y**2]])
        if m[0, 0] >= 0 or m[0, 0] * m[1, 1] - m[0, 1] ** 2 <= 0:
            return mpmath.inf
        whole = -(m**-1) * right
        trace, det = whole[0, 0] + whole[1, 1], whole[0, 0] * whole[1, 1] - whole[0, 1] * whole[1, 0]
        worst = max(worst, (trace + mpmath.sqrt(trace**2 - 4 * det)) / 2)
    return worst


def minimum(sigma: float, bounds: dict[str, tuple[float, float]]) -> mpmath.mpf:
    """The gamma at the least gamma + 0.01 trace P, which is convex in p, by golden sections in log p."""
    exact = {name: tuple(mpmath.mpf(str(round(one, 12))) for one in pair) for name, pair in bounds.items()}
    s, ratio = mpmath.mpf(str(sigma)), (mpmath.sqrt(5) - 1) / 2

    def value(log_p: mpmath.mpf) -> mpmath.mpf:
        p = mpmath.exp(log_p)
        return least_gamma(p, s, exact) + ROOMS[0].weight * (p + 1)

    low, high = mpmath.mpf(0), mpmath.mpf(14)
    for _ in range(50):
        one, two = high - ratio * (high - low), low + ratio * (high - low)
        first, second = value(one), value(two)
        if first == second == mpmath.inf or first > second:
            low = one
        else:
            high = two
    return least_gamma(mpmath.exp((low + high) / 2), s, exact)


DIGITS = 40
Fact = tuple[str, str, float, float]
"""Example, quantity, ours, and the same with 40 digits."""


def exact(matrix: Any) -> mpmath.matrix:
    """A matrix of floats, each as the number that it is."""
    return mpmath.matrix(np.atleast_2d(np.asarray(matrix, np.float64)).tolist())


def stacked(rows: list[list[Any]]) -> mpmath.matrix:
    """A matrix of blocks."""
    heights, widths = [row[0].rows for row in rows], [one.cols for one in rows[0]]
    whole = mpmath.zeros(sum(heights), sum(widths))
    for i, row in enumerate(rows):
        for j, one in enumerate(row):
            top, left = sum(heights[:i]), sum(widths[:j])
            for a in range(one.rows):
                for b in range(one.cols):
                    whole[top + a, left + b] = one[a, b]
    return whole


def values(matrix: mpmath.matrix) -> list[Any]:
    """The eigenvalues of a symmetric matrix, the least first."""
    half = (matrix + matrix.T) / 2
    return list(mpmath.eigsy(half, eigvals_only=True))


def least_ratio(theta: mpmath.matrix, p: mpmath.matrix) -> Any:
    """The least c with theta >= c p."""
    root = mpmath.cholesky(p) ** -1
    return values(root * theta * root.T)[0]


def dissipation(design: Any) -> Any:
    """The largest eigenvalue of the block of Theorem 3.2.1."""
    v, g, plant = {name: exact(one) for name, one in design.values.items()}, design.generator, design.plant
    p, u, s0, output = v["P"], v["U"], exact(g.S0), exact(plant.C0) * exact(design.Pi)
    upper = p * s0 - u * output
    upper = upper + upper.T + v["Theta"]
    if "W" in v:
        upper = upper + 2 * v["W"]
    q, outputs = p.rows, plant.p
    across = [-p * exact(g.G), -u, p]
    zero = [[mpmath.zeros(a, b) for b in (outputs, outputs, q)] for a in (outputs, outputs, q)]
    for i, name in enumerate(("Gamma", "Gamma", "Xi")):
        zero[i][i] = -v[name]
    rows = [[upper, *across], *[[across[i].T, *zero[i]] for i in range(3)]]
    return values(stacked(rows))[-1]


def of_design(name: str, design: Any) -> list[Fact]:
    """The facts of a design by Theorem 3.2.1."""
    v = {name: exact(one) for name, one in design.values.items()}
    c, p = least_ratio(v["Theta"], v["P"]), values(v["P"])
    ways = 2 if design.generator.G.any() else 1  # noise of Y reaches the error through M, and through G
    noise = mpmath.sqrt(ways * values(v["Gamma"])[-1] / (c * p[0]))
    return [
        (name, "rate, 1/s", design.bound.decay, c / 2),
        (name, "overshoot", design.bound.overshoot, mpmath.sqrt(p[-1] / p[0])),
        (name, "gain of the noise", design.bound.gains[0], noise),
        (name, "margin of the inequality", design.margins["the LMI"], -dissipation(design)),
    ]


def bioreactor() -> list[Fact]:
    """The printed map of example 2 beside the one that is found, up to the direction that is free."""
    reactor = Bioreactor()
    found = steady_state_map(reactor.plant, reactor.generator, relaxed=True)
    k1, k2, k3 = (mpmath.mpf(text) for text in ("42.14", "116.5", "268"))
    wanted = [[k2 / k3, 1 / k3], [-k1 * k2 / k3, -k1 / k3]]
    names = ("Pi[1, 1]", "Pi[1, 2]", "Pi[2, 1]", "Pi[2, 2]")
    cells = [(i, j) for i in range(2) for j in range(2)]
    return [
        ("2", name, float(found.Pi[i, j]), wanted[i][j]) for name, (i, j) in zip(names, cells, strict=True)
    ]


def of_blocks(name: str, theorem: MatrixInequalities, solution: Any) -> list[Fact]:
    """The margin of the block Phi, summed with 40 digits from its coefficients."""
    constant, slopes = theorem.unknowns.coefficients("Phi", theorem.blocks["Phi"])
    numbers = theorem.unknowns.numbers(solution.values)
    whole = exact(constant)
    for number, slope in zip(numbers, slopes, strict=True):
        if number:
            whole = whole + mpmath.mpf(float(number)) * exact(slope)
    return [("3", f"margin of Phi, {theorem.name}", solution.margins["Phi"], -values(whole)[-1])]


def arm() -> list[Fact]:
    """Both certificates of example 3 with the thesis's B~."""
    plant, regulator = robotic_arm(ROBOT_INPUT_MODIFIED)
    certificate = certify_tracking(plant, regulator, np.eye(4))
    first, second = theorem_3_2_2(plant, regulator, np.eye(4)), theorem_3_2_3(plant, regulator, np.eye(4))
    return [*of_blocks("3", first, certificate.regulator), *of_blocks("3", second, certificate.error)]


def masses() -> list[Fact]:
    """The certificate of the printed observer of example 5 within 1."""
    observer = invariant_observer(two_masses(domain=1.0), UNMEASURED, [[-1, 0], [0, 0]])
    certificate, now = certify_convergence(observer, decay=0.2), observer.at(0.0)
    v = {name: exact(one) for name, one in certificate.values.items()}
    p, gamma = v["P"], v["gamma"][0, 0]
    whole = p * exact(now.S0)
    whole = whole + whole.T + v["Xi"] + gamma * p + 2 * v["W"]
    c, sizes = least_ratio(v["Xi"], p), values(p)
    overshoot = mpmath.sqrt(sizes[-1] / sizes[0])
    return [
        ("5", "rate, 1/s", certificate.bound.decay, c / 2),
        ("5", "overshoot", certificate.bound.overshoot, overshoot),
        ("5", "gain of delta", certificate.bound.gains[0], overshoot / mpmath.sqrt(c * gamma)),
        ("5", "margin of the inequality", certificate.margins["the inequality"], -values(whole)[-1]),
    ]


def sensors() -> list[Fact]:
    """The margin of Theorem 3.3.3 for example 6: P' = g (P J'J + J'J P) - I solved backwards, J held."""
    t = np.arange(0.0, 2.0 * np.pi, 0.05)
    j, weight, _ = two_sensors(t)
    gain, p = mpmath.mpf("0.75"), mpmath.zeros(2)
    squares = [exact(row).T * exact(row) for row in j]
    kept: list[Any] = []
    for _ in range(6):
        kept = []
        for k in range(len(t) - 2, -1, -1):
            middle, h = (
                (squares[k] + squares[k + 1]) / 2,
                mpmath.mpf(float(t[k + 1])) - mpmath.mpf(float(t[k])),
            )
            rates, vectors = mpmath.eigsy(middle)
            fade = [mpmath.exp(-gain * rate * h) for rate in rates]
            new = [
                -mpmath.expm1(-2 * gain * rate * h) / (2 * gain * rate) if rate > 1e-30 else h
                for rate in rates
            ]
            forget = vectors * mpmath.diag(fade) * vectors.T
            p = vectors * mpmath.diag(new) * vectors.T + forget * p * forget
            kept.append(p)
    worst = max(
        gain * mpmath.mpf(float(weight[k])) * values(p * squares[k] + squares[k] * p)[-1] / 2
        for k, p in zip(range(len(t) - 2, -1, -1), kept, strict=True)
    )
    ours = regression_margin(t, j, weight, 0.75).margin
    return [("6", "margin of Theorem 3.3.3", ours, mpmath.mpf(1) / 2 - worst)]


def estimates() -> list[Fact]:
    """Least squares on the stand-in for the data of example 7."""
    rows, outputs = vapours()
    stage = RecursiveLeastSquares(4)
    for row, output in zip(rows, outputs, strict=True):
        stage.update(tuple(row), float(output))
    estimate = stage.fit().values
    a, b = exact(rows), exact(outputs.reshape(-1, 1))
    wanted = mpmath.lu_solve(a.T * a, a.T * b)
    return [("7", f"parameter {i + 1}", float(estimate[i]), wanted[i]) for i in range(4)]


def of_interlaced(name: str, row: list[float]) -> list[Fact]:
    """Theorem 4.4.1 for the oscillator of examples 8 and 9."""
    certificate = certify_interlaced([[0.0, 1.0], [-1.0, 0.0]], [row], decay=0.25)
    p, q, gamma, u = (exact(one) for one in (certificate.P, certificate.Q, certificate.Gamma, certificate.U))
    corner = p * exact([[0.0, 1.0], [-1.0, 0.0]]) - u * exact([row])
    c, sizes = least_ratio(q, p), values(p)
    whole = stacked([[corner + corner.T + q, -u], [-u.T, -gamma]])
    return [
        (name, "rate, 1/s", certificate.bound.decay, c / 2),
        (name, "overshoot", certificate.bound.overshoot, mpmath.sqrt(sizes[-1] / sizes[0])),
        (
            name,
            "gain of the noise",
            certificate.bound.gains[0],
            mpmath.sqrt(values(gamma)[-1] / (c * sizes[0])),
        ),
        (name, "margin of (4.16)", certificate.margins["the matrix of (4.16)"], -values(whole)[-1]),
    ]


def camera() -> list[Fact]:
    """The least gamma, minimised with 40 digits: see ``least.py``."""
    from evidence.observers.designs import minimum

    facts: list[Fact] = []
    for decay in (0.005, 0.025, 0.045, 0.046, 0.0475):
        box = camera_box((-2.0, -0.07), turn=(-0.02, 0.02), a_z=(-0.1, 0.1), w=(-0.06, 0.06), dw=(-0.1, 0.1))
        gamma = UnknownInputObserver.design(camera_system(), box, decay).certificate.gamma / ROOMS[0].factor
        facts.append(
            ("camera", f"least gamma, decay = {decay:g} 1/s", gamma, minimum(2.0 * decay, box.bounds))
        )
    return facts


EXAMPLES: dict[str, Callable[[], list[Fact]]] = {
    "1": lambda: of_design("1", DrivenObserver.design(academic()[0], generator=academic()[1], decay=0.0)),
    "2": bioreactor,
    "3": arm,
    "4": lambda: of_design(
        "4",
        DrivenObserver.design(
            chua_circuits(0.5)[0], generator=chua_circuits(0.5)[1], Pi=np.eye(3), decay=0.0
        ),
    ),
    "5": masses,
    "6": sensors,
    "7": estimates,
    "8": partial(of_interlaced, "8", [1.0, 0.0]),
    "9": partial(of_interlaced, "9", [1.0, 1.0]),
    "camera": camera,
}
"""By example."""


def compared(name: str) -> list[Fact]:
    """The facts of one example."""
    with mpmath.workdps(DIGITS):
        return [(one, what, float(ours), float(wanted)) for one, what, ours, wanted in EXAMPLES[name]()]


def facts() -> dict[str, Table]:
    """A row a fact."""
    rows = []
    for example in EXAMPLES:
        for name, what, ours, wanted in compared(example):
            rows.append([name, what, f"{ours:.8g}", f"{wanted:.8g}", f"{abs(ours / wanted - 1.0):.1e}"])
            print(" | ".join(rows[-1]), flush=True)
    return {"facts": Table.of(["example", "quantity", "ours", "40 digits", "difference"], rows)}


COUNT = 20
"""Problems of each kind at each door."""
OUTCOMES = ("designed", "refused", "undecided")
CLOSE = 1e-2
"""A gap that counts as a minimum."""


def outcome(door: str, kind: str, seed: int) -> tuple[str, float | None]:
    """What becomes of one problem, and the gap of the design."""
    random = np.random.default_rng([zlib.crc32(door.encode()), KINDS.index(kind), seed])
    try:
        design = DOORS[door](Problem(kind, random))
    except InfeasibleError:
        return "refused", None
    except PointpredError as error:
        return type(error).__name__, None
    return "designed", gap(design)


def gap(design: Any) -> float | None:
    """The gap of an answer, None where nothing is minimised."""
    certificate = getattr(design, "certificate", None)
    return getattr(design, "gap", None) if hasattr(design, "gap") else getattr(certificate, "gap", None)


def cell(door: str, kind: str) -> tuple[Counter[str], list[bool]]:
    """What becomes of the problems of one kind at one door, and whether the gap of each design is small."""
    counts, close = Counter[str](), []
    for seed in range(COUNT):
        what, one = outcome(door, kind, seed)
        counts[what if what in ("designed", "refused") else "undecided"] += 1
        if what == "designed" and one is not None:
            close.append(one <= CLOSE)
    return counts, close


SHOWN = {
    "`design_observer`": "`driven`",
    "`design_observer`, discrete": "`driven`, discrete",
    "`design_reduced_order`, linear": "`reduced`, linear",
    "`design_reduced_order`, `injection=True`": "`reduced`",
    "`design_reduced_order`, discrete": "`reduced`, discrete",
    "`UnknownInputObserver.design`": "`unknown-input`",
    "`certify_interlaced`": "`interlaced`",
}
"""The kinds of the doors, whose own names the seeds of their problems are made from."""


def doors(measured: list[str]) -> dict[str, Table]:
    """A row a door: designed / refused / undecided of each kind, in problems; rows not measured stay."""
    old = stored("observers", "designs").tables.get("doors")
    rows = {str(row[0]): [str(one) for one in row] for row in (old.rows if old else [])}
    places = [(door, kind) for door in measured for kind in KINDS]
    with ProcessPoolExecutor() as pool:
        results = dict(zip(places, pool.map(cell, *zip(*places, strict=True)), strict=True))
    for door in measured:
        shown = SHOWN.get(door, door)
        cells = [" / ".join(str(results[door, kind][0][name]) for name in OUTCOMES) for kind in KINDS]
        close = [one for kind in KINDS for one in results[door, kind][1]]
        rows[shown] = [shown, *cells, f"{np.mean(close):.0%}" if close else "-"]
        print(" | ".join(rows[shown]), flush=True)
    listed = [rows[one] for one in (SHOWN.get(door, door) for door in DOORS) if one in rows]
    counts = np.array([[one.split(" / ") for one in row[1:-1]] for row in listed], int).sum(axis=(0, 1))
    shares = dict(zip(OUTCOMES, (counts / counts.sum()).tolist(), strict=True))
    numbers = {"problems": int(counts.sum()), "count": COUNT, **shares}
    keep("observers", {}, part="designs", numbers=numbers, machine=machine())
    return {"doors": Table.of(["call", *KINDS, "gap <= 1 %"], listed)}


CALLS = {door.replace("`", ""): door for door in DOORS}
"""The doors by the names that the command takes."""


def main(parts: list[str]) -> None:
    if not parts or "doors" in parts:
        keep("observers", doors(list(DOORS)), part="designs")
    elif calls := [CALLS[one] for one in parts if one in CALLS]:
        keep("observers", doors(calls), part="designs")
    if not parts or "facts" in parts:
        keep("observers", facts(), part="designs")


if __name__ == "__main__":
    main(parse(__doc__, metavar="part", choices=("doors", "facts", *CALLS)))
