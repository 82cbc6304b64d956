"""Fit the prefetch policy to recordings: ``python -m evidence intent fit [settings]``.

First the evidence, by the cases of many movements, then the policy's settings: as few firings, as many
movements that fire before the entry and twice the median lead of ForesightJS's rule, on every layout at
once; the layout that is worst off counts. Fitted once without each group of sets, for the measurement, and
once to all, which is what comes with pointpred: evidence is written to pointpred/targets/coefficients.py,
settings are printed. With ``settings`` the evidence stays as it was fitted last, which saves most of the
time. Recordings come from the folder named by POINTPRED_RECORDINGS.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import exp, hypot, inf, log
from typing import NamedTuple

import msgspec
import numpy as np

from evidence.arguments import parse
from evidence.data import file_of, write
from evidence.data import read as stored
from evidence.held_out import held_out
from evidence.intent import targets_fit
from evidence.intent.firing import FRAME_S, Score, by_rule, frame_end, score, shares_of
from evidence.intent.movements import PAGES, Movement, movements
from evidence.intent.targets_fit import Cases
from pointpred.recordings import read
from pointpred.records import FloatArray
from pointpred.targets import cursor, prefetch
from pointpred.targets.posterior import FEATURES, Law, features, unclaimed
from pointpred.training.data import folder

CLAIMING, SILENT = "kinematic-adaptive", "minimum-jerk"
"""The predictors that it is fitted with: one that claims a law and one that does not."""
MOMENTS, LATEST_S, EARLIEST_S = 8, 0.06, 0.42
"""Of each movement, drawn evenly from so long before the entry: when a firing is of use and may be right."""
FIRST_S = 0.01
"""None is nearer to the movement's start."""
MOST_MOVEMENTS = 330
"""Of each layout and each group of sets."""


def coefficients(movements: Sequence[Movement], groups: dict[str, int]) -> FloatArray:
    """Coefficients as ``posterior`` takes them, each layout of each group of sets with the same weight."""
    fitted = []
    for predictor in (CLAIMING, SILENT):
        parts = []
        for layout in PAGES:
            for group in sorted({groups[one.set] for one in movements}):
                own = [one for one in movements if one.layout == layout and groups[one.set] == group]
                if own:
                    parts.append(cases(own, predictor, np.random.default_rng([group, len(layout)])))
        fitted.append(targets_fit.fit(parts, around=False))
    return np.concatenate(fitted)


def cases(movements: Sequence[Movement], predictor: str, generator: np.random.Generator) -> Cases:
    """The situations of movements; in a quarter of them the right target is taken away."""
    chosen = generator.permutation(len(movements))[:MOST_MOVEMENTS].tolist()
    parts = [part for k in chosen for part in _moments(movements[k], predictor, generator)]
    return targets_fit.arranged(parts, generator)


def _moments(
    movement: Movement, predictor: str, generator: np.random.Generator
) -> list[tuple[FloatArray, float, int]]:
    """Features of all candidates at moments of one movement before it enters its target."""
    events, answers, last = movement.events, movement.answers[predictor], movement.entry
    t = events[:, 0]
    drawn = t[last] - generator.uniform(LATEST_S, EARLIEST_S, MOMENTS)
    wanted = set(np.searchsorted(t[: last + 1], np.maximum(drawn, t[0] + FIRST_S)).tolist())
    now, parts = cursor.State(np.zeros(cursor.State.length)), []
    for i in range(last):
        cursor.follow(now.memory, t[i], events[i, 1], events[i, 2], 0.0)
        if i in wanted:
            rows = np.empty((len(movement.table), FEATURES))
            x, y, sxx, sxy, syy, tail = answers[i][[1, 2, 3, 4, 5, 8]].tolist()
            if x != x:
                x, y = float(now.x), float(now.y)
            if not (sxx > 0.0 and syy > 0.0 and sxx * syy > sxy * sxy):
                (sxx, sxy, syy), tail = unclaimed(now.memory, x, y), float("nan")
            features(now.memory, movement.table, Law(x, y, sxx, sxy, syy, tail), rows)
            fast = now.speed / now.peak if now.peak > 0.0 else 0.0
            parts.append((rows, min(float(fast), 1.0), movement.right))
    return parts


GROUPS = {
    "pvplib23714": 0,
    "gofitts_demo": 1,
    "freihaut2021": 1,
    "jrcalgo": 1,
    "cryslacks": 2,
    "kh2017": 2,
    "humanmovemouse": 2,
}
"""Sets that are left out together; none has people or blocks of another."""
START, SPREAD = (1.5, 0.7, 0.3, 0.1, 0.7, 2.5), (0.4, 0.2, 0.15, 0.1, 0.2, 0.5)
"""Where the search begins, and how far each setting is varied at first."""
GENERATIONS, CHILDREN, PARENTS = 45, 24, 6
WORST = 120.0
"""How sharply the worst layout decides."""


class Fitted(msgspec.Struct, frozen=True):
    """Coefficients of the evidence, and settings of the policy."""

    evidence: list[float]
    settings: list[float]


class Fits(msgspec.Struct, frozen=True):
    """To all sets, and without each group of GROUPS."""

    whole: Fitted
    without: list[Fitted]


def fits() -> Fits:
    """What was fitted last."""
    return stored(file_of("intent", "fits"), Fits)


def recorded(predictors: Sequence[str]) -> list[Movement]:
    """The movements of all sets over every layout."""
    where = folder()
    held = held_out(where)
    return [
        one for name in GROUPS for one in movements(read(where / f"{name}_samples.parquet"), predictors, held)
    ]


def margin(ours: dict[str, Score], rule: dict[str, Score]) -> float:
    """How far the policy is from what is asked of it on its worst layouts, as a logarithm; 0 reaches it."""
    parts = [
        part
        for layout, own in ours.items()
        for part in (
            1.3 * log(rule[layout].firings / own.firings),
            log(max(own.lead_s, 1e-3) / (2.0 * rule[layout].lead_s)),
            10.0 * (own.before - rule[layout].before),
        )
    ]
    return -log(sum(exp(-WORST * max(part, -1.0)) for part in parts) / len(parts)) / WORST


def by_layout(chosen: Sequence[Movement], fired: Sequence[FloatArray]) -> dict[str, Score]:
    """The score of each layout."""
    places: dict[str, list[int]] = {}
    for i, one in enumerate(chosen):
        places.setdefault(one.layout, []).append(i)
    return {
        layout: score([chosen[i] for i in own], [fired[i] for i in own]) for layout, own in places.items()
    }


class Chances(NamedTuple):
    """Every moment at which a target may fire in some movements: a row a frame and target, in turn."""

    target: np.ndarray[tuple[int], np.dtype[np.int64]]
    """Counted over the targets of all movements."""
    now: FloatArray
    log_odds: FloatArray
    """Of a visit; infinite where the cursor is in the target, and it fires at the latest."""
    terms: FloatArray
    """What the settings weigh."""


def chances(chosen: Sequence[Movement], shares: Sequence[FloatArray]) -> Chances:
    """The moments of these movements, by the laws of the policy."""
    rows: list[tuple[float, ...]] = []
    first = 0
    for one, own in zip(chosen, shares, strict=True):
        s, visits = cursor.State(np.zeros(cursor.State.length)), np.zeros(len(one.table))
        x0, y0 = one.events[0, 1:3].tolist()
        resting = [prefetch.inside(x0, y0, row) for row in one.table]
        for i, event in enumerate(one.events):
            cursor.follow(s.memory, *event[:3].tolist(), 0.0)
            if (now := frame_end(one.events, i, FRAME_S)) == inf:
                continue
            x, y = event[1:3].tolist()
            prefetch.visit(x, y, one.table, own[i], visits)
            expected = prefetch.expect(x, y, one.table, visits, own[i])
            moves = hypot(x - x0, y - y0) >= prefetch.LEAST_WAY_PX
            for k, row in enumerate(one.table):
                within = prefetch.inside(x, y, row)
                resting[k] = resting[k] and within
                if resting[k] or not (moves or within):
                    continue
                odds = inf if within else prefetch.log_odds(visits[k])
                rows.append(
                    (first + k, now, odds, *prefetch.terms(s.memory, row, own[i, k], visits[k], expected))
                )
        first += len(one.table)
    table = np.array(rows)
    table = table[np.argsort(table[:, 0], kind="stable")]
    return Chances(table[:, 0].astype(np.int64), table[:, 1], table[:, 2], table[:, 3:])


def first_firings(moments: Chances, values: FloatArray, targets: int) -> FloatArray:
    """When each target first fires, s; infinite where it never does. As ``firing.by_policy`` says."""
    fires = np.flatnonzero(moments.log_odds + moments.terms @ values >= 0.0)
    fired_at = np.full(targets, inf)
    fired_at[moments.target[fires[::-1]]] = moments.now[fires[::-1]]  # the first one is written last
    return fired_at


def settings(chosen: Sequence[Movement], shares: Sequence[FloatArray], last: Sequence[float]) -> list[float]:
    """The settings of largest margin that are found from START and from those of the last fit."""
    rule = by_layout(chosen, [by_rule(one, FRAME_S) for one in chosen])
    moments, ends = chances(chosen, shares), np.cumsum([len(one.table) for one in chosen])

    def worth(values: FloatArray) -> float:
        fired = np.split(first_firings(moments, values, ends[-1]), ends[:-1])
        return margin(by_layout(chosen, fired), rule)

    found = [searched(worth, np.array(start), np.array(SPREAD)) for start in (START, last)]
    best: list[float] = max(found, key=worth).tolist()
    return best


def searched(worth: Callable[[FloatArray], float], start: FloatArray, spread: FloatArray) -> FloatArray:
    """The best of an evolution strategy: the mean of the better children, and how far these lie apart."""
    generator = np.random.default_rng(1)
    middle, best, reached = start, start, worth(start)
    for _ in range(GENERATIONS):
        children = middle + spread * generator.standard_normal((CHILDREN, len(start)))
        worths = np.array([worth(child) for child in children])
        order = np.argsort(-worths)
        if worths[order[0]] > reached:
            best, reached = children[order[0]], float(worths[order[0]])
        parents = children[order[:PARENTS]]
        middle = parents.mean(axis=0)
        spread = np.maximum(0.8 * spread + 0.2 * parents.std(axis=0), 0.02 * np.array(SPREAD))
    print(f"margin {reached:.4f}", flush=True)
    return best


def evidence(everything: Sequence[Movement]) -> tuple[FloatArray, list[FloatArray]]:
    """Coefficients for all movements, and without each group."""
    groups = sorted(set(GROUPS.values()))
    apart = [coefficients([one for one in everything if GROUPS[one.set] != k], GROUPS) for k in groups]
    return coefficients(everything, GROUPS), apart


def fit(everything: Sequence[Movement], whole: FloatArray, apart: Sequence[FloatArray]) -> Fits:
    """The settings for this evidence, fitted to shares that do not know the group."""
    shares = [shares_of(one, CLAIMING, apart[GROUPS[one.set]], FRAME_S) for one in everything]

    def without(group: int | None, last: Fitted) -> list[float]:
        chosen = [i for i, one in enumerate(everything) if GROUPS[one.set] != group]
        return settings([everything[i] for i in chosen], [shares[i] for i in chosen], last.settings)

    before = fits()
    return Fits(
        Fitted(whole.tolist(), without(None, before.whole)),
        [Fitted(own.tolist(), without(k, before.without[k])) for k, own in enumerate(apart)],
    )


def main(parts: Sequence[str]) -> None:
    """Fit without each group and to all."""
    everything = recorded((CLAIMING, SILENT))
    if parts == ["settings"]:
        last = fits()
        known = np.array(last.whole.evidence), [np.array(one.evidence) for one in last.without]
    else:
        known = evidence(everything)
    done = fit(everything, *known)
    write(done, file_of("intent", "fits"))
    claimed, unclaimed = np.split(np.array(done.whole.evidence), 2)
    targets_fit.put(targets_fit.named("PAGES_", claimed) | targets_fit.named("PAGES_UNCLAIMED_", unclaimed))
    print("settings:", ", ".join(f"{value:.4g}" for value in done.whole.settings))


if __name__ == "__main__":
    main(parse(__doc__, choices=("settings",), most=1))
