"""What the results' pages show, taken from the JSON of all sets: no words, only numbers and names."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import msgspec

from evidence import FIGURES
from evidence.held_out import PEOPLE_OUT, SET_OUT
from evidence.rendering import number, percents, share, table
from evidence.results.records import SetResults, stored
from evidence.thinning import save
from pointpred.datasets import listing
from pointpred.drawing import Picture
from pointpred.errors import ParameterError
from pointpred.predictors.kinematic import coefficient_file
from pointpred.registry import RECOMMENDED, parameters
from pointpred.scoring import FLOOR, SetSummary
from pointpred.scoring.report.figures import curves
from pointpred.scoring.report.report import highlighted
from pointpred.scoring.summary import PredictorSummary

EARLY = 0.2
"""The share of the time at which a predictor that only looks a fixed time ahead gives itself away."""
MOMENTS = (0.3, 0.5, 0.7)
"""Shares of the time that the page shows."""


class Learned(msgspec.Struct, frozen=True):
    """A predictor that has learned from recordings, on the people whom its coefficients did not see."""

    name: str
    without: str
    """``set`` or ``person``: what its coefficients did not see."""
    low: float
    high: float
    below: int
    """Sets with the whole interval below 1."""
    sets: int
    worst: float
    """At the worst share of the time, on the worst set."""
    worst_set: str
    worst_time: float


class Cautious(msgspec.Struct, frozen=True):
    """The most frequent winner, where it only looks a fixed time ahead."""

    name: str
    horizon_s: float
    early: tuple[float, float]
    lowest: tuple[float, float]


def shares(sets: Sequence[SetResults]) -> dict[str, list[float]]:
    """The time-averaged error over hold's, a number a set, of each predictor but hold that has all."""
    ratios: dict[str, list[float]] = {}
    for one in sets:
        for name, predictor in one.judged.items():
            if name != FLOOR and predictor.time_averaged.of_hold is not None:
                ratios.setdefault(name, []).append(predictor.time_averaged.of_hold)
    return {name: values for name, values in ratios.items() if len(values) == len(sets)}


def winners(sets: Sequence[SetResults]) -> Counter[str]:
    """On how many sets each predictor has the lowest error in px, which has more digits than the ratio."""
    counts: Counter[str] = Counter()
    for one in sets:
        px = {name: p.time_averaged.px for name, p in one.judged.items() if name != FLOOR}
        counts[min(px, key=lambda name: float("inf") if px[name] is None else float(px[name] or 0.0))] += 1
    return counts


def spread(rows: Mapping[str, Sequence[float | None]]) -> tuple[float, float]:
    """The smallest and the largest of the sets' lowest shares; ``None``, a share that is unknown, is none."""
    columns = (
        [share for share in column if share is not None] for column in zip(*rows.values(), strict=True)
    )
    lowest = [min(column) for column in columns if column]
    return min(lowest), max(lowest)


def learned(people: Sequence[SetResults]) -> list[Learned]:
    """How what has learned does without the set, and without the person; unknown errors are left out."""
    rows_of = []
    for without, ending in (("set", SET_OUT), ("person", PEOPLE_OUT)):
        names = dict.fromkeys(p.name for one in people for p in one.summary.predictors if not p.ablates)
        for name in (name for name in names if name.endswith(ending)):
            rows = {one.summary.name: p for one in people for p in one.summary.predictors if p.name == name}
            ratios = [p.time_averaged.of_hold for p in rows.values() if p.time_averaged.of_hold is not None]
            bounds = [p.time_averaged.interval for p in rows.values()]
            moments = [
                (cell.of_hold, which, t)
                for which, p in rows.items()
                for t, cell in p.by_time.items()
                if cell.of_hold is not None
            ]
            if not ratios or not moments:
                continue
            worst, where, when = max(moments)
            below = sum(bound is not None and bound[1] < 1.0 for bound in bounds)
            rows_of.append(
                Learned(
                    name.removesuffix(ending), without, min(ratios), max(ratios), below, len(rows), worst,
                    where, when,
                )
            )  # fmt: skip
    return rows_of


def cautious(people: Sequence[SetResults]) -> Cautious | None:
    """The most frequent winner and its early errors.

    ``None`` where it looks at the movement, or where none of its early errors is known.
    """
    (name, _), *_ = winners(people).most_common()
    horizon = parameters(name).get("horizon_s")
    if horizon is None:
        return None
    early = {other: [one.judged[other].by_time[EARLY].of_hold for one in people] for other in shares(people)}
    own = [share for share in early.get(name, ()) if share is not None]
    if not own:
        return None
    return Cautious(name, float(horizon[1]), (min(own), max(own)), spread(early))


def matched_better(sets: Sequence[SetResults]) -> list[str]:
    """Recorded sets on which template matching of the session has a lower error than `kinematic`."""
    names, found = ("ktm", "kinematic"), []
    for one in (one for one in sets if not one.summary.simulated and one.judged.keys() >= set(names)):
        matched, learned = (one.scored(name).time_averaged.px or 0.0 for name in names)
        if matched < learned:
            found.append(one.summary.name)
    return found


class Overall(msgspec.Struct, frozen=True):
    """The results of all sets together."""

    recorded: int
    """Recorded sets"""
    shares: dict[str, list[float]]
    """Time-averaged error over hold's on the recorded sets, by predictor"""
    predictors: int
    steady: list[str]
    """Below 1 on every set"""
    worse: int
    worse_recorded: int
    """Predictors worse than no prediction on a set, and on a recorded set"""
    lowest: tuple[float, float]
    wins: list[tuple[str, int]]
    learned: list[Learned]
    cautious: Cautious | None
    alone: list[str]
    """Sets of one person"""
    ablated: dict[str, list[float]]
    """Time-averaged error over hold's on the recorded sets, of predictors without their memory."""
    repeats: list[tuple[float, float]]
    """Shares of ends and of distances that repeat on the recorded sets."""
    recommended: str = RECOMMENDED


def overall(sets: Sequence[SetResults]) -> Overall:
    """The results of all sets together; raises ParameterError where no recorded set was scored."""
    scored = [one for one in sets if one.summary.trials]
    people = [one for one in scored if not one.summary.simulated]
    if not people:
        raise ParameterError("no recorded set was scored; run `make results` with recordings", code="missing")
    every, recorded = shares(scored), shares(people)
    return Overall(
        recorded=len(people),
        shares=recorded,
        predictors=len(every),
        steady=[name for name, values in every.items() if max(values) < 1.0],
        worse=sum(max(values) > 1.0 for values in every.values()),
        worse_recorded=sum(max(values) > 1.0 for values in recorded.values()),
        lowest=spread(recorded),
        wins=winners(people).most_common(),
        learned=learned(people),
        cautious=cautious(people),
        alone=[one.summary.name for one in scored if one.summary.users == 1],
        ablated={
            name: [row.time_averaged.of_hold for row in rows if row and row.time_averaged.of_hold is not None]
            for name in recorded
            if any(rows := [one.without_memory(name) for one in people])
        },
        repeats=[
            (again.ends, again.distances) for one in people if (again := one.summary.repeats) is not None
        ],
    )


def by_set(
    sets: Sequence[SetResults], cell: Callable[[PredictorSummary], str | None]
) -> dict[str, list[str]]:
    """A row a predictor, a column a set, a dash where it was not scored; rows without any cell go.

    The package's own coefficients never saw a simulated set: there they stand for those without the set.
    """
    learners = {
        p.name.removesuffix(SET_OUT) for one in sets for p in one.summary.predictors if SET_OUT in p.name
    }
    rows: dict[str, list[str]] = {}
    for place, one in enumerate(sets):
        for p in one.summary.predictors:
            text = cell(p)
            if text is not None:
                name = p.name + SET_OUT if p.name in learners else p.name
                rows.setdefault(name, ["-"] * len(sets))[place] = text
    return rows


def moments(p: PredictorSummary) -> str:
    """The error over hold's at 30, 50 and 70 % of the time."""
    return " / ".join(number(p.by_time[t].of_hold) for t in MOMENTS)


def claims(p: PredictorSummary) -> str | None:
    """How often regions hold the endpoint, and the time left beside a clock; ``None`` without either."""
    inside = percents(list(p.calibration.inside.values())) if p.calibration else None
    left = number(p.time_left.of_clock) if p.time_left else None
    return None if inside is None and left is None else f"{inside or '-'}; {left or '-'}"


def costs(sets: Sequence[SetResults]) -> dict[str, tuple[list[float], list[float]]]:
    """Of each predictor the least and the most answers in percent, and microseconds an event."""
    found: dict[str, tuple[list[float], list[float]]] = {}
    for p in (p for one in sets for p in one.summary.predictors):
        answers, us = found.setdefault(p.name.removesuffix(SET_OUT).removesuffix(PEOPLE_OUT), ([], []))
        answers.append(100 * p.coverage)
        us.append(p.us_per_event)
    return found


def drawn(one: SetSummary) -> Picture:
    """The error of a set against time."""
    plain = msgspec.structs.replace(one, predictors=tuple(p for p in one.predictors if not p.ablates))
    judged = tuple(p for p in plain.predictors if not p.name.endswith(PEOPLE_OUT))
    shown = highlighted(msgspec.structs.replace(one, predictors=judged))
    return curves(plain, shown, "by_time", "of_hold")


def save_figures() -> None:
    """Write the figures of the stored results into ``docs/figures``."""
    for one in stored():
        if one.summary.trials:
            save(drawn(one.summary).svg, FIGURES / f"{one.summary.name}-by-time.svg")


def context(sets: Sequence[SetResults] | None = None) -> dict[str, Any]:
    """What the template of ``docs/evidence/results.md`` needs."""
    results = stored() if sets is None else list(sets)
    catalogue = {entry.name: entry for entry in listing()}
    card = coefficient_file.card()
    heads = [f"{one.summary.name}{' (simulated)' * one.summary.simulated}" for one in results]
    present = {one.summary.name for one in results}
    return {
        "sets": results,
        "overall": overall(results),
        "averages": by_set(results, lambda p: share(p.time_averaged)),
        "moments": by_set(results, moments),
        "claims": by_set(results, claims),
        "costs": costs(results),
        "by_set": lambda rows: table(
            ("predictor", *heads), [(f"`{name}`", *cells) for name, cells in rows.items()]
        ),
        "catalogue": catalogue,
        "absent": [name for name in catalogue if name not in present],
        "skipped": {one.summary.name: Counter(s.reason for s in one.summary.skipped) for one in results},
        "figures": [one.summary.name for one in results if one.summary.trials],
        "versions": results[0].versions,
        "card": card,
        "moments_of": Counter({one["name"]: one["moments"] for one in card["sets"]}),
        "coefficients": {
            "file": coefficient_file.OWN.name,
            "version": coefficient_file.VERSION,
            "size": coefficient_file.OWN.stat().st_size,
            "digest": coefficient_file.digest(),
        },
        "matched": matched_better(results),
    }
