"""What docs/evidence/ktm.md shows: the protocol of template matching, from the results of all sets."""

from __future__ import annotations

from typing import Any

import msgspec

from pages import data
from pages.results.records import SetResults, stored
from pointpred.scoring import FLOOR
from pointpred.scoring.ktm_protocol import FRACTIONS, LIBRARY, ProtocolPredictor, ProtocolSummary

LEFT_OUT = " left out)"


class Matched(msgspec.Struct, frozen=True):
    """Template matching on one set, by the published rule, and what is best without the library."""

    name: str
    simulated: bool
    drawn: ProtocolSummary
    shown: tuple[ProtocolPredictor, ...]
    """Without those that have learned from recordings: they are in the results' JSON."""
    skill: dict[float, float]
    best: dict[float, ProtocolPredictor]
    """At each share of the distance, the lowest error of the others."""


def matched(one: SetResults) -> Matched | None:
    """The published rule on one set; ``None`` where nobody has enough movements."""
    summary = next((draw for draw in one.templates if draw.monotone and draw.predictors), None)
    if summary is None:
        return None
    shown = tuple(p for p in summary.predictors if not p.name.endswith(LEFT_OUT))
    library = next(p for p in shown if p.name == LIBRARY)
    others = [p for p in shown if p.name != LIBRARY]
    best = {at: min(others, key=lambda p, at=at: p.px[at]) for at in FRACTIONS}
    return Matched(one.summary.name, one.summary.simulated, summary, shown, library.skill, best)


def context() -> dict[str, Any]:
    """What the template needs."""
    tables = data.stored("ktm")
    return {
        "sets": [match for one in stored() if (match := matched(one)) is not None],
        "fractions": FRACTIONS,
        "library": LIBRARY,
        "floor": FLOOR,
        "tables": tables.tables,
        "machine": tables.machine,
    }
