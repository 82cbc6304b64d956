"""What docs/evidence/kinematic.md shows: the card of the coefficients, and scores on held-out people."""

from __future__ import annotations

from typing import Any

from evidence import data
from evidence.kinematic.records import Held, Levels, Validation
from evidence.results.records import SetResults, stored
from pointpred.predictors.kinematic import coefficient_file

LEVELS = (0.5, 0.8, 0.95)
ALLOWED = 0.03
"""How far a share may be from its level."""


def worst_decile(scores: Held) -> tuple[float, str, float]:
    """The largest error over that of `hold` at any share of the time, with its set and time."""
    return max((value, row.name, at) for row in scores.sets for at, value in row.by_time.items())


def off(claims: tuple[Levels, ...]) -> tuple[float, float, float]:
    """The share farthest from its level: its distance, the level, and the share of the time."""
    return max(
        (abs(share - level), level, round(0.1 * (at + 1), 1))
        for at, shares in enumerate(claims)
        for share, level in zip(shares, LEVELS, strict=True)
    )


def worst_region(scores: Held) -> tuple[float, float, float, str]:
    """The same over single sets, with the set."""
    return max((*off(row.claims.regions), row.name) for row in scores.sets)


def matched_better(sets: list[SetResults]) -> list[str]:
    """Recorded sets on which template matching of the session has a lower error than `kinematic`."""
    return [
        one.summary.name
        for one in sets
        if not one.summary.simulated
        and (one.scored("ktm").time_averaged.px or 0.0) < (one.scored("kinematic").time_averaged.px or 0.0)
    ]


def context() -> dict[str, Any]:
    """What the template needs."""
    validation = data.read(data.file_of("kinematic"), Validation)
    ways = {"people held out": validation.people_out, "sets left out": validation.sets_out}
    return {
        "card": coefficient_file.card(),
        "file": coefficient_file.OWN.name,
        "version": coefficient_file.VERSION,
        "size": coefficient_file.OWN.stat().st_size,
        "digest": coefficient_file.digest(),
        "ways": ways,
        "allowed": ALLOWED,
        "worst_decile": {name: worst_decile(scores) for name, scores in ways.items()},
        "regions_off": {name: off(scores.together.regions) for name, scores in ways.items()},
        "arrivals_off": {name: off(scores.together.arrivals) for name, scores in ways.items()},
        "worst_region": {name: worst_region(scores) for name, scores in ways.items()},
        "slower": {name: sum(row.of_clock > 1.0 for row in scores.sets) for name, scores in ways.items()},
        "matched": matched_better(stored()),
    }
