"""Tables of claims for the results: hits in the target, regions, the time left."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pages.markdown import table
from pointpred.scoring.measures.moments import DECILES
from pointpred.scoring.measures.regions import LEVELS
from pointpred.scoring.results import TIME_FRACTIONS

Json = dict[str, Any]
MIDDLE = "0.8"


def section(one: Json) -> list[str]:
    """What a set's predictors claim, and how it turned out."""
    return [*hits(one), *regions(one), *time_left(one)]


def name_of(predictor: Json, words: str = "") -> str:
    """The first cell of a row."""
    return f"`{predictor['name']}`{words}"


def both(one: Json, kind: str) -> Iterator[tuple[str, Json | None]]:
    """Each predictor's claims of one kind, of all trials and of the clean ones."""
    for predictor in one["predictors"]:
        yield name_of(predictor), predictor[kind]
        clean = predictor["groups"].get("clean_trials")
        if clean and clean[kind]:
            yield name_of(predictor, ", clean"), clean[kind]


def percent(value: float | None) -> str:
    """A share as a whole number of percent."""
    return "-" if value is None else f"{100 * value:.0f}"


def hits(one: Json) -> list[str]:
    """Share of trials whose prediction lies in the target, where the set knows it."""
    known = [p["hits"]["trials"] for p in one["predictors"] if p["hits"]]
    if not known:
        return ["### Hits in the target", "This set does not know its targets."]
    rows = []
    for name, told in both(one, "hits"):
        cells = [told["by_time"][str(t)] if told else None for t in TIME_FRACTIONS]
        rows.append((name, *(_spread(cell) for cell in cells)))
    return [
        f"### Hits in the target, % of the {known[0]} trials whose target is known, by time",
        table(("predictor", *(f"{t:.0%}" for t in TIME_FRACTIONS)), rows),
    ]


def _spread(cell: Json | None) -> str:
    if cell is None or cell["share"] is None:
        return "-"
    low, high = cell["interval"] or (None, None)
    return f"{percent(cell['share'])} [{percent(low)}, {percent(high)}]"


def regions(one: Json) -> list[str]:
    """Shares of endpoints inside the regions, by decile of the time."""
    return [
        "### Endpoints inside the regions of 50 / 80 / 95 %, %, by time",
        _inside(one, "calibration", "claims no region"),
    ]


def _inside(one: Json, kind: str, silent: str) -> str:
    rows, quiet = [], []
    for name, told in both(one, kind):
        if not told or not told["by_time"]:
            quiet.append(name)
            continue
        cells, whole = told["by_time"], told["inside"]
        rows.append((name, _levels(whole), *(_levels(cells[str(t)]["inside"]) for t in DECILES)))
        if not name.endswith("clean"):
            bounds = (cells[str(t)]["interval"][MIDDLE] for t in DECILES)
            spread = ("-" if b is None else f"[{percent(b[0])}, {percent(b[1])}]" for b in bounds)
            rows.append((f"{name}, interval of the 80 %", "", *spread))
    said = f"{', '.join(quiet)}: {silent}." if quiet else ""
    if not rows:
        return said
    return f"{table(('predictor', 'all the time', *(f'{t:.0%}' for t in DECILES)), rows)}\n\n{said}"


def _levels(inside: Json) -> str:
    return " / ".join(percent(inside[str(level)]) for level in LEVELS)


def time_left(one: Json) -> list[str]:
    """Error beside the clock, then the intervals by decile."""
    rows = []
    for name, told in both(one, "time_left"):
        if told and told["of_clock"] is not None:
            low, high = told["interval"] or (float("nan"), float("nan"))
            rows.append(
                (
                    name,
                    f"{1e3 * told['s']:.0f}",
                    f"{1e3 * told['clock_s']:.0f}",
                    f"{told['of_clock']:.2f} [{low:.2f}, {high:.2f}]",
                    f"{told['claimed']:.0%}",
                )
            )
    if not rows:
        return ["### Time left", "Nobody claims it."]
    return [
        "### Time left: time-averaged absolute error, ms, beside a clock that knows the set's median time",
        table(("predictor", "error", "clock", "of the clock", "claimed"), rows),
        "### Arrivals inside the intervals of 50 / 80 / 95 %, %, by time",
        _inside(one, "time_left", "claims no interval"),
    ]
