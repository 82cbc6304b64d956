"""How laws run: as the C function of their name where there is one, else as they are written."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable

import pytest

from pointpred import compiled


def doubled(x: float) -> float:
    return 2.0 * x


def twice(inner: Callable[[float], float]) -> Callable[[float], float]:
    def outer(x: float) -> float:
        return inner(inner(x))

    return outer


PLAIN = """
from types import FunctionType
from pointpred import compiled
from pointpred.pipeline import joint_of
from pointpred.predictors.hold import HoldPredictor
from pointpred.differentiators import HomogeneousDifferentiator
laws = HoldPredictor.step, HoldPredictor.loop, joint_of(HomogeneousDifferentiator.step, HoldPredictor.step)
assert not compiled.COMPILED
assert all(isinstance(law, FunctionType) for law in laws), laws
"""


def test_everything_is_plain_python_where_that_is_chosen() -> None:
    subprocess.run([sys.executable, "-c", PLAIN], env=os.environ | {"POINTPRED_COMPILED": "0"}, check=True)


def test_a_law_that_is_not_in_c_runs_as_it_is() -> None:
    assert compiled.law(doubled) is doubled


def test_a_law_in_c_is_found_by_its_name(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        compiled, "_functions", {f"{__name__}:doubled": abs, f"{__name__}:twice ({__name__}:doubled)": min}
    )
    assert compiled.law(doubled) is abs
    assert compiled.law(twice(doubled)) is min
    assert compiled.law(twice) is twice


def test_a_law_made_around_laws_is_called_by_its_maker_and_theirs() -> None:
    assert compiled.key_of(doubled) == f"{__name__}:doubled"
    assert compiled.key_of(twice(doubled)) == f"{__name__}:twice ({__name__}:doubled)"
    assert compiled.key_of(twice(twice(doubled))) == f"{__name__}:twice ({compiled.key_of(twice(doubled))})"
