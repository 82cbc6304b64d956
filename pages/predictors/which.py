"""Which predictor to take, with the numbers of the results: part of ``make docs``."""

from __future__ import annotations

import re
from pathlib import Path

from pages.markdown import table
from pages.results.verdict import recorded_shares
from pointpred.errors import ParameterError
from pointpred.registry import RECOMMENDED
from pointpred.scoring import FLOOR

HEADER = ("when", "predictor", "error on recorded people, `hold` = 1", "cost of an event, us")
CASES = (
    ("a person uses it live: a page, a mouse, an experiment", RECOMMENDED),
    (
        "single movements of unknown people, or results that must not depend on order",
        "kinematic",
    ),
    (
        "no learned coefficients, or the law of the thesis (its values: `switched-printed`)",
        "switched",
    ),
    ("one person who repeats a few movements, and nothing may be known of other people", "ktm"),
    ("least computing, nothing to set (`hold`, no prediction, costs about the same)", "minimum-jerk"),
)
"""Five cases and the predictor for each."""


def which(docs: Path) -> str:
    """The table of cases, and a sentence on what the recommended predictor has shown."""
    shares, _ = recorded_shares(docs / "evidence" / "results.md")
    costs = streaming_us(docs / "evidence" / "cost.md")
    rows = [
        (when, f"`{name}`", f"{min(shares[name]):.2f} to {max(shares[name]):.2f}", f"{costs[name]:.1f}")
        for when, name in CASES
    ]
    sets = len(shares[RECOMMENDED])
    wins = f"`{RECOMMENDED}` has the lowest error of all predictors on {_wins(docs)} of {sets} recorded sets."
    return f"{table(HEADER, rows)}\n\n{wins} `{FLOOR}` costs {costs[FLOOR]:.1f} us an event."


def _wins(docs: Path) -> int:
    """On how many recorded sets the recommended one is best: two digits of the tables do not tell."""
    page = docs / "evidence" / "results.md"
    found = re.search(rf"`{RECOMMENDED}` \((\d+)\)", page.read_text(encoding="utf-8"))
    return int(found[1]) if found else 0


def streaming_us(page: Path) -> dict[str, float]:
    """Microseconds of an event in a live session, by name; raises ParameterError where the page has none."""
    found = re.findall(r"^\| `([a-z-]+)` \| (\d+) \|", page.read_text(encoding="utf-8"), flags=re.MULTILINE)
    if not found:
        raise ParameterError(f"{page.name} holds no cost of a pipeline; run `make bench`")
    return {name: int(ns) / 1000 for name, ns in found}
