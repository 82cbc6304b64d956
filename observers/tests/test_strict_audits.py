"""What is printed as proved follows from margins above 0, and no proof reaches beyond the arithmetic."""

from __future__ import annotations

import json
import zlib
from fractions import Fraction
from typing import Any

import msgspec
import numpy as np
import pytest

from evidence.observers.plants import DOORS, KINDS, Problem
from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred_observers import Generator, Persidskii, audit
from pointpred_observers.cli.observer_tables import print_audit, print_design, summary
from pointpred_observers.files import decoded, encoded
from pointpred_observers.interconnected import design as interconnected
from pointpred_observers.interconnected.design import FullOrderObserver
from pointpred_observers.proofs.affine import Affine, Multipliers, reach
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.reduced_order.design import ReducedOrderObserver

MOTOR = Persidskii(
    [[0.0, 1.0, 0.0], [0.0, -0.5, 4.0], [0.0, -0.2, -8.0]], None, None, "sin", [0.0, 0.0, 2.0], None,
    [1.0, 0.0, 0.0],
)  # fmt: skip
CART = Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", C0=[1.0, 0.0])


def edge() -> MatrixInequalities:
    problem = MatrixInequalities("edge").positive("P", 2)
    return problem.above("P - 2", lambda v: v.P - 2.0 * np.eye(2), strict=False)


def test_a_margin_of_zero_is_for_prints_and_searches_only() -> None:
    values = {"P": 2.0 * np.eye(2)}
    assert edge().check(values)["P - 2"] == 0.0
    with pytest.raises(CertificateError, match=r"P - 2 has the eigenvalue 0, must lie above 0"):
        edge().check(values, printed=False)
    slightly = {"P": np.diag([2.0, 2.0 - 1e-12])}
    edge().check(slightly)
    with pytest.raises(CertificateError, match=r"P - 2 has the eigenvalue -1\.\d*e-12"):
        edge().check(slightly, printed=False)


def test_the_rounding_of_p_m_counts_where_p_is_nearly_singular() -> None:
    """With U = P M as it is computed the inequality holds, with the M that runs it fails in exact numbers."""
    small = 1e-11
    p = np.array([[1.0, 1.0 - small], [1.0 - small, 1.0]])

    def energy(m: float) -> tuple[Fraction, Fraction]:
        """What the gain takes along (1, -1), as it is and as computed."""
        u = [Fraction(float(one)) for one in p @ [m, -m]]
        return 4 * Fraction(m) * (1 - Fraction(float(p[0, 1]))), 2 * (u[0] - u[1])

    gains = np.random.default_rng(8).uniform(0.5, 1.0, 100).tolist()
    m = max(gains, key=lambda one: float(energy(one)[1] / energy(one)[0]))
    theta = float(sum(energy(m)) / 2)
    assert energy(m)[0] < theta < energy(m)[1]
    plant = Persidskii(-small * np.ones((2, 2)), None, None, "sin", C0=[1.0, -1.0])
    values = {"P": p, "Theta": theta * np.eye(2), "Gamma": np.array([[1e14]]), "Xi": 1e14 * np.eye(2)}
    with pytest.raises(CertificateError, match="the LMI has the eigenvalue"):
        interconnected.certified_design(plant, Generator(plant.A0), np.eye(2), [[m], [-m]], values)


def test_a_design_at_the_edge_is_neither_loaded_nor_audited() -> None:
    design = FullOrderObserver.design(CART)
    assert min(audit(design).values()) > 0.0
    document = json.loads(encoded(design))
    document["certificate"]["Gamma"] = (
        np.linalg.eigvalsh(np.asarray(document["certificate"]["Gamma"])).max() * 1e-6 * np.eye(1)
    ).tolist()
    with pytest.raises(CertificateError, match="the LMI has the eigenvalue"):
        decoded(json.dumps(document))


def test_no_proof_reaches_beyond_the_rounding_of_the_coefficients() -> None:
    """The slope of P is 0 up to rounding: what it is in truth nobody knows."""
    block = (np.array([[1.0]]), np.array([[[1e-16]]]))
    floor, cap = (np.eye(1), -np.ones((1, 1, 1))), (-np.eye(1), np.ones((1, 1, 1)))
    problem = Affine([block], [floor], [cap], np.zeros(1), np.eye(1), np.full(1, -np.inf), None, [(0, 1)])
    one = np.eye(1)
    assert 1e12 < reach(problem, Multipliers([one], [1e-16 * one], [0.0 * one])) < 1e33
    grown = msgspec.structs.replace(problem, strict=[(np.array([[1.0]]), np.array([[[1.0]]]))])
    assert reach(grown, Multipliers([one], [one], [0.0 * one])) < 1e17


@pytest.mark.parametrize(
    ("door", "decay"),
    [
        (FullOrderObserver.design, 1e10),
        (ReducedOrderObserver.design, 1e12),
        (ReducedOrderObserver.design, 1e9),
    ],
)
def test_an_observable_plant_is_never_refused_for_every_p(door: Any, decay: float) -> None:
    refused = ""
    try:
        door(MOTOR, decay=decay)
    except InfeasibleError as failure:
        refused = str(failure)
    except UndecidedError:
        pass
    assert "inf" not in refused
    assert "cannot hold" not in refused


def test_an_equality_that_only_rounding_violates_is_undecided() -> None:
    plant = Persidskii(MOTOR.A0, [0.0, -2.0, 0.0], [1.0, 0.0, 0.0], "sin", C0=[1.0, 0.0, 0.0])
    with pytest.raises(UndecidedError, match=r"too large for the arithmetic"):
        ReducedOrderObserver.design(plant, decay=1e8)


def test_a_design_that_fails_its_own_audit_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(*given: Any, **options: Any) -> None:
        raise CertificateError("Theorem 3.2.1: the LMI has the eigenvalue 1, must lie below 0")

    monkeypatch.setattr(interconnected, "certified_design", failing)
    with pytest.raises(UndecidedError, match=r"the LMI has the eigenvalue 1.*require less decay"):
        FullOrderObserver.design(CART)


def test_the_gap_of_a_file_is_a_claim(capsys: pytest.CaptureFixture[str]) -> None:
    design = FullOrderObserver.design(CART)
    document = json.loads(encoded(design))
    with pytest.raises(ParameterError, match=r"gap must be a number not below 0, .* received -5") as wrong:
        decoded(json.dumps({**document, "gap": -5}))
    assert wrong.value.field == "gap"
    print_audit(design, audit(design))
    assert "as stored, not recomputed" in " ".join(capsys.readouterr().out.split())
    print_design(design)
    assert "not recomputed" not in capsys.readouterr().out
    for stored, shown in ((1e9, None), (11.0, None), (9.5, 9.5), (None, None)):
        claimed = decoded(json.dumps({**document, "gap": stored}))
        assert summary(claimed).gap == shown
        print_audit(claimed, claimed.margins)
        assert ("not known" if shown is None else "950.00%") in capsys.readouterr().out


def plant_of_the_table(door: str, kind: str, seed: int) -> Problem:
    return Problem(kind, np.random.default_rng([zlib.crc32(door.encode()), KINDS.index(kind), seed]))


NEAR_THE_LIMIT = (
    ("`design_observer`", "stiff", 12),
    ("`UnknownInputObserver.design`", "random", 17),
    ("`UnknownInputObserver.design`", "stiff", 9),
)
"""Problems whose first answer fails the audit of the gains that run: which of them, the processor decides."""


def test_a_design_whose_gains_round_too_far_is_searched_again() -> None:
    """One with more room passes the audit; how far it is from the least is then not known."""
    gaps = []
    for problem in NEAR_THE_LIMIT:
        design = DOORS[problem[0]](plant_of_the_table(*problem))
        gaps.append(design.gap if hasattr(design, "gap") else design.certificate.gap)
        assert audit(design)
        assert decoded(encoded(design)) is not None
    assert np.inf in gaps


def test_a_proof_that_rounding_ends_below_kappa_may_reach_further_from_a_larger_one() -> None:
    """Rounding differs between processors: of these problems at least one is refused with a proof."""
    reached = []
    for seed in (2, 7, 11):
        try:
            DOORS["`design_observer`"](plant_of_the_table("`design_observer`", "nearly unobservable", seed))
        except InfeasibleError as refused:
            reached.append(float(str(refused).rpartition("proved for P with a condition number up to ")[2]))
        except UndecidedError:
            pass
    assert max(reached) >= 1e12
