"""What the numbers of the results say together, in words made from them; the README's line on people."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pages.held_out import PEOPLE_OUT, SET_OUT
from pointpred.console import counted
from pointpred.errors import ParameterError
from pointpred.registry import parameters
from pointpred.scoring import FLOOR

Json = dict[str, Any]
Shares = Mapping[str, Sequence[float]]
"""Of each predictor but hold, the share of hold's error on each set."""
EARLY = "0.2"
OVERVIEW = "## Time-averaged error of all sets"


def verdict(sets: Sequence[Json]) -> list[str]:
    """Who stays below hold everywhere, who is best on people, what that means, whose intervals say little."""
    scored = [one for one in sets if one["trials"]]
    people = [one for one in scored if not one["simulated"]]
    said = [steady(shares_of(scored), "sets")] if scored else []
    if people:
        said.append(best_of(shares_of(people)))
        said += learned(people)
        said += cautious(people)
    alone = [one["name"] for one in scored if one["users"] == 1]
    if alone:
        said.append(f"Intervals say nothing about other people on sets of one person: {', '.join(alone)}.")
    return [" ".join(said)] if said else []


def rows_of(one: Json) -> dict[str, Json]:
    """Predictors by name; what has learned stands for itself by its row without the set."""
    rows = {p["name"].removesuffix(SET_OUT): p for p in one["predictors"]}
    return {name: p for name, p in rows.items() if not name.endswith(PEOPLE_OUT)}


def shares_of(sets: Iterable[Json]) -> Shares:
    """The time-averaged error over hold's, a number a set, of each predictor but hold that has all."""
    found: dict[str, list[float]] = {}
    listed = list(sets)
    for one in listed:
        for name, predictor in rows_of(one).items():
            if name != FLOOR:
                share = predictor["time_averaged"]["of_hold"]
                found.setdefault(name, []).append(float("nan") if share is None else share)
    return {name: shares for name, shares in found.items() if len(shares) == len(listed)}


def learned(people: Sequence[Json]) -> list[str]:
    """How what has learned does on the sets that it did not see, and on the people that it did not see."""
    said = []
    for words, ending in (("without the set", SET_OUT), ("without the person", PEOPLE_OUT)):
        names = dict.fromkeys(p["name"] for one in people for p in one["predictors"])
        for name in [name for name in names if name.endswith(ending)]:
            rows = {one["name"]: p for one in people for p in one["predictors"] if p["name"] == name}
            shares = [p["time_averaged"]["of_hold"] for p in rows.values()]
            below = sum(p["time_averaged"]["interval"][1] < 1.0 for p in rows.values())
            worst, where, when = max(
                (cell["of_hold"], which, f"{float(t):.0%}")
                for which, p in rows.items()
                for t, cell in p["by_time"].items()
            )
            said.append(
                f"`{name.removesuffix(ending)}`, fitted {words} it is judged on, has {min(shares):.2f} to "
                f"{max(shares):.2f} of hold's error, with the interval below 1 on {below} of "
                f"{counted(len(rows), 'set')}; at its worst share of the time {worst:.2f} ({where}, {when})."
            )
    return said


def steady(shares: Shares, noun: str) -> str:
    """Which predictors are better than hold on every set."""
    count = len(next(iter(shares.values()), ()))
    good = [f"`{name}`" for name, values in shares.items() if max(values) < 1.0]
    others = len(shares) - len(good)
    rest = f"; {others} of {len(shares)} predictors do worse on at least one" if others else ""
    return f"Below 1 on each of the {count} {noun}: {', '.join(good) or 'none'}{rest}."


def best_of(shares: Shares) -> str:
    """The lowest error on each set: by whom, and how low."""
    low, high = spread(shares)
    wins = Counter(winners(shares)).most_common()
    names = ", ".join(f"`{name}` ({count})" for name, count in wins)
    return (
        f"On people the lowest time-averaged error is {low:.2f} to {high:.2f} of hold's; "
        f"number of recorded sets on which each predictor has it: {names}."
    )


def winners(shares: Shares) -> list[str]:
    """The best predictor of each set."""
    return [min(shares, key=lambda name: shares[name][i]) for i in range(len(next(iter(shares.values()))))]


def spread(shares: Shares) -> tuple[float, float]:
    """The smallest and the largest of the sets' lowest shares."""
    lowest = [min(column) for column in zip(*shares.values(), strict=True)]
    return min(lowest), max(lowest)


def cautious(people: Sequence[Json]) -> list[str]:
    """What to think of the most frequent winner where it only looks a fixed time ahead."""
    (name, _), *_ = Counter(winners(shares_of(people))).most_common()
    horizon = parameters(name).get("horizon_s")
    if horizon is None:
        return []
    early = {
        other: [rows_of(one)[other]["by_time"][EARLY]["of_hold"] for one in people]
        for other in shares_of(people)
    }
    low, high = spread(early)
    return [
        f"`{name}` predicts where the cursor will be {1e3 * horizon[1]:g} ms later, whatever the movement: "
        "it wins the time average because it risks little, not because it knows the endpoint. "
        f"At {float(EARLY):.0%} of the time it has {min(early[name]):.2f} to {max(early[name]):.2f} of "
        f"hold's error on these sets; the lowest of all predictors is {low:.2f} to {high:.2f}."
    ]


def recorded_shares(page: Path) -> tuple[Shares, list[str]]:
    """The first table of the results: shares of hold's error on the recorded sets, and who has learned.

    What has learned stands there by its scores on sets that it did not see. Raises ParameterError where the
    page holds no recorded set.
    """
    first = page.read_text(encoding="utf-8").partition(f"\n{OVERVIEW}\n")[2].partition("\n## ")[0]
    lines = [line for line in first.splitlines() if line.startswith("| ")] or ["", ""]
    head, _, *rows = [[cell.strip(" `") for cell in line.strip("| ").split("|")] for line in lines]
    columns = [i for i, title in enumerate(head) if i and "(simulated)" not in title]
    shares = {
        row[0].removesuffix(SET_OUT): [float(row[i]) for i in columns]
        for row in rows
        if row[0] != FLOOR and not row[0].endswith(PEOPLE_OUT) and all(row[i] != "-" for i in columns)
    }
    if not columns or not shares:
        raise ParameterError(f"{page.name} holds no recorded set; run `make results` with recordings")
    return shares, [row[0].removesuffix(SET_OUT) for row in rows if row[0].endswith(SET_OUT)]


def recorded(page: Path) -> str:
    """The README's warning about simulated people, from the first table of docs/evidence/results.md."""
    shares, learners = recorded_shares(page)
    worse = sum(max(values) > 1.0 for values in shares.values())
    fitted = " and ".join(
        f"`{name}` {min(shares[name]):.2f} to {max(shares[name]):.2f}" for name in learners if name in shares
    )
    sets = counted(len(next(iter(shares.values()))), "recorded set")
    learned = f"fitted without the set, {fitted} of hold's error, " if fitted else ""
    return (
        f"These people are simulated and easier to predict. Real people, {sets}: {learned}"
        f"and {worse} of {len(shares)} predictors do worse than no prediction on at least one set "
        "([all numbers](docs/evidence/results.md))."
    )
