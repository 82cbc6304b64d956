"""The guarded transfer function as a stage: tables, pickles, refusals, and the same without compiling."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from math import inf

import numpy as np
import pytest

from pointpred import Prediction
from pointpred.errors import EventError, ParameterError
from pointpred.transfer import ConstantGain, GuardedTransfer

CPI, H = 2000.0, 2.0**-10


def made(strength: float = 0.5, **others: float) -> GuardedTransfer:
    return GuardedTransfer(ConstantGain(4.0), cpi=CPI, strength=strength, period_s=H, **others)


def prediction(x: float, y: float, sd: float | None = None) -> Prediction:
    """An endpoint, and a round region where a standard deviation is given."""
    covariance = None if sd is None else (sd**2, 0.0, sd**2)
    return Prediction(0.0, x, y, covariance, "ballistic", None)


def test_rows_equal_reports_and_it_pickles() -> None:
    random = np.random.default_rng(8)
    rows = np.column_stack(
        [np.arange(300) * H, random.integers(-9, 30, (300, 2)), random.uniform(-50, 900, (300, 2))]
    )
    rows = np.column_stack([rows, np.tile([4.0, 1.0, 9.0], (300, 1))])
    single, whole = made(), made()
    table = whole.walk(np.zeros(300, np.bool_), rows)
    each = [single.advance(tuple(r)) for r in rows.tolist()]
    assert np.array_equal(table, each)
    assert np.abs(table[:, 3:]).sum() > 100.0
    twin = pickle.loads(pickle.dumps(single))
    report = ((1.0, 30.0, 2.0), prediction(800.0, 0.0, 5.0), (1.0, 2.0))
    assert twin.update(*report) == single.update(*report)
    single.reset()
    assert np.array_equal(single._memory, made()._memory)


def test_refusals_change_nothing_and_say_why() -> None:
    stage = made()
    stage.update((1.0, 3.0, 1.0), prediction(5.0, 5.0))
    before = stage._memory.copy()
    for report, guess in (
        ((0.5, 1.0, 1.0), None),
        ((2.0, inf, 1.0), None),
        ((2.0, 1.0, 1.0), prediction(1e12, 0.0)),
    ):
        with pytest.raises(EventError, match=r"not before t = 1\.0 s"):
            stage.update(report, guess)
    assert np.array_equal(before, stage._memory)
    for name, value in {"strength": 1.5, "sideways": -0.1, "uncertain": 0.0, "rho": inf}.items():
        with pytest.raises(ParameterError) as refused:
            made(**{name: value})
        assert (refused.value.field, refused.value.value) == (name, value)


SCRIPT = """
import numpy as np
from pointpred.transfer import GuardedTransfer, SigmoidGain
random = np.random.default_rng(4)
rows = np.column_stack([np.arange(200) / 1000, random.integers(-9, 30, (200, 2)),
    random.uniform(-50, 900, (200, 2)), random.uniform(0, 1e4, 200), np.zeros(200), np.full(200, 900.0)])
print(GuardedTransfer(SigmoidGain(), cpi=800.0).walk(np.zeros(200, np.bool_), rows).tolist())
"""


def test_plain_python_says_the_same() -> None:
    said = [
        subprocess.run(
            [sys.executable, "-W", "error", "-c", SCRIPT],
            env={**os.environ, "POINTPRED_COMPILED": compiled},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for compiled in ("0", "1")
    ]
    assert said[0] == said[1]
    assert len(said[0]) > 1000


def test_the_same_matrix_with_a_smaller_tail_is_trusted_less() -> None:
    added = []
    for tail in (None, 2.0, 0.73, 0.3):
        transfer = GuardedTransfer(ConstantGain(4.0), cpi=2000.0)
        claim = Prediction(0.0, 600.0, 0.0, (3600.0, 0.0, 3600.0), "ballistic", None, tail)
        way = [transfer.update((i / 1000, 30.0, 0.0), claim, (100.0, 0.0))[0] for i in range(1, 200)]
        added.append(sum(way))
    assert added == sorted(added, reverse=True)
    assert added[0] > added[1] > added[2] > added[3]
