"""HOMD gives on a small generated recording what it gave when the file was written."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np
import pytest

from pointpred import EventColumns

HERE = Path(__file__).parent


@pytest.fixture(scope="module")
def golden() -> np.ndarray:
    return np.loadtxt(HERE / "homogeneous.csv", delimiter=",")


def test_the_outputs_are_the_golden_ones(golden: np.ndarray) -> None:
    answers = runpy.run_path(str(HERE / "regenerate_homogeneous.py"))["answers"]
    got = answers(EventColumns(golden[:, :6].copy()))
    np.testing.assert_allclose(got, golden[:, 6:], rtol=1e-12, atol=1e-12)


def test_the_events_are_those_that_the_command_generates(golden: np.ndarray) -> None:
    recording = runpy.run_path(str(HERE / "regenerate_homogeneous.py"))["recording"]
    np.testing.assert_array_equal(recording().table, golden[:, :6])


def test_the_recording_has_what_makes_it_worth_keeping(golden: np.ndarray) -> None:
    t, buttons = golden[:, 0], golden[:, 5]
    assert np.sum(np.diff(t) == 0.0) == 2
    assert np.diff(t).max() > 0.3
    assert buttons.max() == 1.0
    assert np.abs(golden[:, 6]).max() == pytest.approx(1.875 * 0.12 / 0.6, rel=0.03)
