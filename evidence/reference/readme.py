"""The README's scores: five predictors on the embedded sample, and how the learned ones do on real people."""

from __future__ import annotations

from typing import Any

from pages.results.page import overall
from pages.results.records import stored
from pointpred.errors import ParameterError
from pointpred.registry import RECOMMENDED

NAMES = ("hold", "minimum-jerk", "switched", "kinematic", RECOMMENDED)
"""No prediction, no training, the thesis, and what has learned."""


def context() -> dict[str, Any]:
    """What the template needs; raises ParameterError where the embedded sample was not scored."""
    sets = stored()
    sample = next((one for one in sets if one.summary.simulated), None)
    if sample is None:
        raise ParameterError("the embedded sample was not scored; run `make results`", code="missing")
    together = overall(sets)
    return {
        "made": sample.summary,
        "chosen": [sample.scored(name) for name in NAMES],
        "overall": together,
        "fitted": [one for one in together.learned if one.without == "set"],
    }
