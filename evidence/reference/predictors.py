"""What docs/reference/predictors.md shows: the registry, and which predictor to take."""

from __future__ import annotations

from typing import Any

import msgspec

from pages import data
from pages.results.page import overall
from pages.results.records import stored
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.parameter import Parameter
from pointpred.registry import GAINS, RECOMMENDED, REGISTRY, describe
from pointpred.registry import parameters as values_of
from pointpred.scoring import FLOOR


def gains_of(name: str) -> dict[str, float]:
    """The parameters of the differentiator that ``build(name)`` takes from the registry."""
    stage = DIFFERENTIATORS[REGISTRY[name].differentiator]
    chosen = GAINS | REGISTRY[name].preset
    return {p.name: values_of(name)[p.name][1] for p in stage.parameters if p.name in chosen}


def predictor(name: str) -> dict[str, Any]:
    """One name of the registry: its own parameters, its differentiator, what it sets."""
    one, entry = describe(name), REGISTRY[name]
    own = {parameter.name for parameter in entry.predictor.parameters}
    return {
        **one,
        "own": [p for p in one["parameters"] if p["of"] == "predictor"],
        "gains": gains_of(name),
        "sets": {key: value for key, value in entry.preset.items() if key in own},
    }


class DifferentiatorEntry(msgspec.Struct, frozen=True):
    """One differentiator with the defaults of its class."""

    name: str
    title: str
    own: tuple[Parameter, ...]


def differentiator(name: str) -> DifferentiatorEntry:
    """The entry of one name."""
    stage = DIFFERENTIATORS[name]
    return DifferentiatorEntry(name, (stage.__doc__ or "").strip().splitlines()[0], tuple(stage.parameters))


def grouped() -> list[tuple[dict[str, float], list[str]]]:
    """The names that share their gains."""
    groups: dict[tuple[tuple[str, float], ...], list[str]] = {}
    for name in REGISTRY:
        groups.setdefault(tuple(gains_of(name).items()), []).append(name)
    return [(dict(gains), names) for gains, names in groups.items()]


def streaming_us() -> dict[str, float]:
    """Microseconds of an event in a live session, by name."""
    cost = data.stored("costs", "events").tables["cost"]
    at = cost.columns.index("streaming, ns")
    return {str(row[0]).strip("`"): float(row[at]) / 1000 for row in cost.rows}


def context() -> dict[str, Any]:
    """What the template needs."""
    together = overall(stored())
    return {
        "recommended": RECOMMENDED,
        "floor": FLOOR,
        "shares": together.shares,
        "wins": dict(together.wins),
        "recorded": together.recorded,
        "costs": streaming_us(),
        "predictors": [predictor(name) for name in REGISTRY],
        "differentiators": [differentiator(name) for name in DIFFERENTIATORS],
        "groups": grouped(),
    }
