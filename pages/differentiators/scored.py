"""The same predictors behind other differentiators: ``python -m pages.differentiators.scored``.

Scores the embedded sample and the sets in the folder that POINTPRED_RECORDINGS names; without one the page
is left as it is.
"""

from __future__ import annotations

from typing import Any

from benchmarks.arguments import words
from pages import DOCS
from pages.markdown import filled, table
from pages.sets import folder, recordings
from pointpred import build
from pointpred.pipeline import Pipeline
from pointpred.scoring import score, summarise

PAGE = DOCS / "evidence" / "differentiators.md"
PREDICTORS = ("minimum-jerk", "switched-direction")
PRINTED = {"gain_lambda": 5.0, "gain_xi": 2.0, "alpha": -0.2}
CHOICES: dict[str, dict[str, Any]] = {
    "HOMD": {},
    "HOMD, printed gains": PRINTED,
    "kalman": {"differentiator": "kalman"},
    "reduced-order": {"differentiator": "reduced-order"},
}


def patterns() -> list[Pipeline]:
    """Every predictor behind every differentiator, each under a name of its own."""
    made = []
    for predictor in PREDICTORS:
        for choice, parameters in CHOICES.items():
            one = build(predictor, **parameters)
            made.append(Pipeline(f"{predictor}, {choice}", one.differentiator, one.predictor))
    return made


def main() -> None:
    """Print the table, and write it where recordings are at hand."""
    found, unread = folder(), {}
    shares: dict[str, dict[str, float]] = {}
    for recording in recordings(found, unread):
        for one in map(summarise, score([recording], patterns())):
            for predictor in one.predictors:
                shares.setdefault(predictor.name, {})[one.name] = predictor.time_averaged.of_hold
    sets = list(shares.pop("hold"))
    rows = []
    for name, values in shares.items():
        predictor, _, choice = name.partition(", ")
        rows.append((predictor, choice, *(f"{values[one]:.3f}" for one in sets)))
    text = table(("predictor", "differentiator", *sets), rows)
    print(text)
    for file, reason in unread.items():
        print(f"{file}: {reason}")
    if found:
        PAGE.write_text(filled(PAGE.read_text(encoding="utf-8"), "scored", text), encoding="utf-8")


if __name__ == "__main__":
    words(__doc__)
    main()
