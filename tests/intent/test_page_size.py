"""What a page loads stays small, as a bundler makes it."""

from __future__ import annotations

from pathlib import Path

import pytest

from evidence.costs.page_size import LIB, reached, sizes

SMALL, LEARNED = 15_000, 90_000
"""Bytes that `onIntent` may take with a small predictor, and with the learned one and its coefficients."""

SHARED = {"prediction/row.js", "prediction/leads.js"}
"""What the lean page shares with the whole pipeline."""


def test_nothing_is_loaded_that_the_predictor_does_not_need() -> None:
    names = {path.relative_to(LIB).as_posix() for path in reached("intent/index.js", "minimum-jerk")}
    assert "laws/predictors/minimum_jerk.js" in names
    assert not any("kinematic" in name for name in names)
    assert {name for name in names if name.startswith("prediction/")} <= SHARED
    assert not any("overlay" in name or name == "pointpred.js" for name in names)


@pytest.mark.parametrize(("predictor", "most"), [("minimum-jerk", SMALL), ("kinematic-adaptive", LEARNED)])
def test_a_bundle_is_small(predictor: str, most: int, tmp_path: Path) -> None:
    _, plain, bundled = sizes("intent/register.js", predictor, tmp_path)
    if bundled is None:
        pytest.skip("npm cannot fetch esbuild")
    assert bundled < most
    assert bundled < plain
