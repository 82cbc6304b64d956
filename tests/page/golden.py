"""Golden vectors: movements of every kind, and what the laws of Python answer to each of their events."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from pointpred import REGISTRY, build
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.pipeline import Pipeline
from pointpred.registry import GAINS
from pointpred.targets import Target, around, choice_law, decision, ledger, prefetch
from tests.page.movements import movements

RATES_HZ = (60.0, 125.0, 1000.0, 8000.0)
RESET: list[float] = []
"""A row without numbers stands for a reset."""


def rows_of(rate_hz: float, seed: int) -> list[list[float]]:
    """Movements with pauses, equal times, clicks and sub-movements, resets and events that are refused."""
    random = np.random.default_rng([seed, int(rate_hz)])
    events = movements(seed, rate_hz=rate_hz, count=3 if rate_hz > 500.0 else 8)
    rows: list[list[float]] = []
    for i, event in enumerate(events.tolist()):
        rows.append(event)
        chance = random.uniform()
        t, x, y = event[:3]
        if chance < 0.004:
            rows.append(RESET)
        elif chance < 0.012:
            rows.append([t - 0.01, x, y, np.nan, np.nan, 0.0])  # time runs backwards
        elif chance < 0.016:
            rows.append([t, 1e10, y, np.nan, np.nan, 0.0])
        elif chance < 0.02:
            rows.append([t, x, y, 1.0, np.nan, 0.0])
        elif chance < 0.03:
            rows.append([t, x + 1.0, y, np.nan, np.nan, event[5]])
        elif chance < 0.035 and i % 2:
            rows.append([t, x, y, np.nan, np.nan, 0.5])
    return rows


def stream(
    name: str, rows: list[list[float]], pipeline: Pipeline, settings: dict[str, Any]
) -> dict[str, Any]:
    """A stream through a pipeline, which may know its person: its answers, None where an event is refused."""
    known = pipeline.predictor.known.tolist()
    answers: list[list[float] | None] = []
    for row in rows:
        if not row:
            pipeline.reset()
            answers.append(None)
        else:
            answer = pipeline.advance(tuple(row))
            answers.append([float(one) for one in answer] if answer[0] == answer[0] else None)
    return {
        "name": name,
        "differentiator": _name_of(pipeline),
        "settings": settings,
        "rows": rows,
        "known": known,
        "targets": _registered(pipeline),
        "answers": answers,
    }


def _registered(pipeline: Pipeline) -> dict[str, Any] | None:
    """The targets of a fresh pipeline as laws take them."""
    aim = pipeline.fresh().aim
    return {"table": aim.table.tolist(), "keys": aim.keys.tolist()} if aim.ids else None


def _name_of(pipeline: Pipeline) -> str:
    return next(name for name, kind in DIFFERENTIATORS.items() if type(pipeline.differentiator) is kind)


def _settings(name: str, **parameters: Any) -> dict[str, Any]:
    return {**GAINS, **REGISTRY[name].preset, **parameters}


def streams() -> Iterator[dict[str, Any]]:
    """Every predictor at every rate, every differentiator, counts of a device, and persons who are known."""
    for name in REGISTRY:
        for seed, rate_hz in enumerate(RATES_HZ):
            if rate_hz > 500.0 and name == "ktm":
                continue  # its memory compares 64 templates: the other rates say the same
            yield stream(name, rows_of(rate_hz, seed), build(name), _settings(name))
    for other in DIFFERENTIATORS:
        pipeline = build("switched", differentiator=other)
        yield stream("switched", rows_of(125.0, 7), pipeline, _settings("switched"))
    counts = [[*row[:3], *_counts(row), row[5]] if row else row for row in rows_of(125.0, 8)]
    for name in ("switched-direction", "kinematic-adaptive"):
        pipeline = build(name, cpi=800.0)
        yield stream(name, counts, pipeline, _settings(name, cpi=800.0))
    for seed in range(3):
        learned = build("kinematic-adaptive")
        for event in movements(20 + seed, rate_hz=100.0, count=16).tolist():
            learned.advance(tuple(event))
        again = build("kinematic-adaptive", person=learned.person)
        yield stream("kinematic-adaptive", rows_of(125.0, 9 + seed), again, _settings("kinematic-adaptive"))


def among_targets() -> Iterator[dict[str, Any]]:
    """Predictors with what can be pointed at: where movements end, beside these, and of many sizes."""
    for seed, name in enumerate(("hold", "minimum-jerk", "ktm", "kinematic", "kinematic-adaptive")):
        rows = rows_of(125.0, 40 + seed)
        ends = [row for row in rows if row and row[5] == 1.0]
        random = np.random.default_rng(seed)
        sides = zip(random.uniform(0.0, 900.0, (30, 2)), random.uniform(8.0, 120.0, (30, 2)), strict=True)
        listed = [
            Target(f"{i}", float(x), float(y), float(width), float(height), 1.0 + i % 3, "a" * (i % 2))
            for i, ((x, y), (width, height)) in enumerate(sides)
        ]
        listed += [around(f"end {k}", row[1], row[2] + 9.0 * (k % 2), 40.0) for k, row in enumerate(ends)]
        yield stream(name, rows, build(name, targets=listed), _settings(name))


def _counts(row: list[float]) -> tuple[float, float]:
    """Counts that a device may have reported beside a place; both missing where that row has one only."""
    if row[3] == row[3]:
        return row[3], row[4]
    return float(round(row[1]) % 7 - 3), float(round(row[2]) % 5 - 2)


def targets() -> dict[str, Any]:
    """Shares of thirty targets, and what is decided, over the events of a learned predictor."""
    events = movements(5, rate_hz=125.0, count=10)
    places = np.random.default_rng(4).uniform(0.0, 1000.0, (30, 2))
    places[:6] = events[events[:, 5] == 1.0][:6, 1:3]  # where movements end, and the next ones start
    pipeline, alone = build("kinematic-adaptive"), build("kinematic-adaptive")
    pipeline.register([around(str(k), x, y, 40.0 + k) for k, (x, y) in enumerate(places.tolist())])
    aim, settings = pipeline.aim, decision.Settings(0.4, 0.0, 3.0)
    keys, rectangles = aim.keys.tolist(), aim.table.tolist()
    inside, shares = np.zeros(30), aim.shares
    account, rows = ledger.Account(np.zeros(ledger.Account.length)), np.empty((60, ledger.FIELDS))
    state, changes = choice_law.State(np.full(choice_law.State.length, -1.0)), np.zeros(4)
    ledger.drop(account.memory)
    memory = prefetch.State(np.zeros(prefetch.State.length))
    thresholds = np.where(np.arange(30) % 2, 0.4, 0.9999)
    prefetched = aim.table, thresholds, np.zeros(30), np.zeros(30)
    decisions, all_shares, fired, answers = [], [], [], []
    for row in events.tolist():
        pipeline.advance(tuple(row))
        answers.append(list(alone.advance(tuple(row))))
        given = (aim.table, inside, shares), aim.keys, settings, account.memory, rows
        changed = choice_law.update(state.memory, aim.memory, *given, changes)
        decisions.append([*state.memory.tolist(), *(changes.tolist() if changed else [])])
        all_shares.append(shares.tolist())
        memory.cursor.memory[:] = aim.cursor.memory
        prefetch.step(memory.memory, prefetched, shares, np.array(prefetch.FITTED))
        fired.append(prefetched[-1].tolist())
    states = {one for each in fired for one in each}
    assert {prefetch.PREDICTED, prefetch.ENTERED, prefetch.RESTING} <= states
    return {
        "table": rectangles,
        "keys": keys,
        "settings": list(settings),
        "events": events.tolist(),
        "answers": answers,
        "shares": all_shares,
        "decisions": decisions,
        "account": account.memory.tolist(),
        "thresholds": thresholds.tolist(),
        "fired": fired,
    }


def cases() -> dict[str, Any]:
    """Everything that is compared."""
    return {"streams": [*streams(), *among_targets()], "targets": targets()}
