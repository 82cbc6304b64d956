"""Tables of regions: how often what is drawn holds the endpoint, and how large it is."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import msgspec
import numpy as np
from numpy.typing import NDArray

from pages.data import Table, keep
from pointpred.records import BoolArray, FloatArray

LEVELS, SHARES = (0.5, 0.8), (0.3, 0.5, 0.7)
"""The ellipses that are drawn, and when: shares of the time from onset to arrival."""
LEARNT, LEARNT_OF_FEW = 20, 12
"""Movements of a person after which an adaptive predictor is judged once more; where nobody makes so many."""
ADAPTIVE, MIXTURE = "kinematic-adaptive", "mixture"
MIDDLE = SHARES.index(0.5)
EVERY = "all"


class Drawn(msgspec.Struct, frozen=True):
    """A set and a predictor, a row a movement."""

    set: str
    predictor: str
    people: NDArray[np.str_]
    order: NDArray[np.int64]
    """Place among the movements of the person, from 0."""
    inside: FloatArray
    """(movements, shares, levels): 1 where the ellipse holds the endpoint, NaN where none is drawn."""
    size: FloatArray
    """(movements, levels): root of the product of the half axes at half of the time, px."""
    way: FloatArray
    """From the cursor to the endpoint at half of the time, px."""


def pooled(sets: Sequence[Drawn]) -> Drawn:
    """All movements of all sets, each counted once."""
    columns = {
        name: np.concatenate([getattr(one, name) for one in sets]) for name in Drawn.__struct_fields__[3:]
    }
    people = np.concatenate([np.char.add(f"{one.set} ", one.people) for one in sets])
    return Drawn(EVERY, sets[0].predictor, people, **columns)


def coverage(sets: Sequence[Drawn]) -> Table:
    """Shares inside, %, of all movements and of those after the first ones of each person."""
    rows = []
    for one in (*sets, pooled(sets)):
        for label, some in parts(one):
            people = len(set(one.people[some].tolist()))
            shares = [share(one.inside[some, :, k]) for k in range(len(LEVELS))]
            rows.append((one.set, label, str(people), str(int(some.sum())), *shares))
    times = " / ".join(f"{100 * share:.0f}" for share in SHARES)
    sentences = (f"in the {100 * level:.0f} % ellipse at {times} % of the time" for level in LEVELS)
    return Table.of(("set", "movements", "people", "number", *sentences), rows)


def parts(one: Drawn) -> list[tuple[str, BoolArray]]:
    """All movements, and those after the person's first ones where there are any."""
    learnt = learnt_of(one)
    every = ("all", np.ones(len(one.order), np.bool_))
    later = one.order >= learnt
    return [every, (f"after {learnt}", later)] if later.any() else [every]


def learnt_of(one: Drawn) -> int:
    """Movements after which the people of a set are known."""
    return LEARNT if (one.order >= LEARNT).any() else LEARNT_OF_FEW


def share(inside: FloatArray) -> str:
    """Shares of a column each, %; a dash where nothing is drawn at any movement."""
    return " / ".join(_mean(inside[:, k], lambda mean: f"{100 * mean:.0f}") for k in range(inside.shape[1]))


def sizes(sets: Sequence[Drawn]) -> Table:
    """Median size at half of the time, beside the way that is left."""
    rows = []
    for one in (*sets, pooled(sets)):
        half = [f"{np.nanmedian(one.size[:, k]):.0f}" for k in range(len(LEVELS))]
        rows.append((one.set, *half, f"{np.median(one.way):.0f}"))
    names = (f"{100 * level:.0f} % ellipse, px" for level in LEVELS)
    return Table.of(("set", *names, "from the cursor to the endpoint, px"), rows)


def areas(single: Sequence[Drawn], mixture: Sequence[Drawn]) -> Table:
    """The region of the mixture over the ellipse at half of the time, of people who are known."""
    rows = []
    for one, other in zip(single, mixture, strict=True):
        later = one.order >= learnt_of(one)
        logs = 2.0 * np.log(other.size[later] / one.size[later])
        means = [f"{np.exp(np.nanmean(logs[:, k])):.2f}" for k in range(len(LEVELS))]
        medians = [
            f"{np.pi * np.nanmedian(which.size[later, k]) ** 2:.0f}" for k in (0, 1) for which in (one, other)
        ]
        rows.append((one.set, str(int(later.sum())), *means, *medians))
    return Table.of(
        (
            "set",
            "number",
            "50 %: mixture over ellipse",
            "80 %: mixture over ellipse",
            *("50 % ellipse, px^2", "mixture, px^2", "80 % ellipse, px^2", "mixture, px^2"),
        ),
        rows,
    )


def _mean(values: FloatArray, text: Callable[[float], str]) -> str:
    there = values[~np.isnan(values)]
    return text(float(there.mean())) if len(there) else "-"


def written(results: Sequence[Drawn]) -> None:
    """Keep the tables."""
    tables = {}
    for name in dict.fromkeys(one.predictor for one in results):
        mine = [one for one in results if one.predictor == name]
        tables[f"coverage {name}"] = coverage(mine)
        tables[f"sizes {name}"] = sizes(mine)
    one, other = ([result for result in results if result.predictor == name] for name in (ADAPTIVE, MIXTURE))
    tables["areas"] = areas(one, other)
    keep("regions", tables)
