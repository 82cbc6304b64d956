"""Golden vectors: movements of every kind, and what the laws of Python answer to each of their events."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from pointpred import REGISTRY, build
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.pipeline import Pipeline
from pointpred.records import row_at
from pointpred.registry import GAINS
from pointpred.targets import around, choice_law, decision, posterior, prefetch
from pointpred.targets.rectangles import table
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
        "answers": answers,
    }


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


def _counts(row: list[float]) -> tuple[float, float]:
    """Counts that a device may have reported beside a place; both missing where that row has one only."""
    if row[3] == row[3]:
        return row[3], row[4]
    return float(round(row[1]) % 7 - 3), float(round(row[2]) % 5 - 2)


def targets() -> dict[str, Any]:
    """Shares of thirty targets, and what is decided, over the events of a learned predictor."""
    events = movements(5, rate_hz=125.0, count=10)
    pipeline = build("kinematic-adaptive")
    answers = np.array([pipeline.advance(tuple(row)) for row in events.tolist()])
    places = np.random.default_rng(4).uniform(0.0, 1000.0, (30, 2))
    places[:6] = events[events[:, 5] == 1.0][:6, 1:3]  # where movements end, and the next ones start
    rectangles = table([around(str(k), x, y, 40.0 + k) for k, (x, y) in enumerate(places.tolist())])
    settings = posterior.Settings(0.4, 0.02, 0.0, 3.0)
    inside, shares = np.zeros(30), np.zeros(31)
    memory, standing = np.zeros(prefetch.State.length), decision.NOBODY
    thresholds = np.where(np.arange(30) % 2, 0.4, 0.9999)
    prefetched = rectangles, thresholds, np.zeros(30), np.zeros(30)
    decisions, all_shares, fired = [], [], []
    for i, row in enumerate(events):
        event = float(row[0]), float(row[1]), float(row[2]), float(int(row[5]) & 1)
        known = (rectangles, inside, shares), posterior.FITTED, settings
        made = choice_law.step(memory, event, row_at(answers, i), *known, standing)
        standing = made[0]
        decisions.append(list(made))
        all_shares.append(shares.tolist())
        prefetch.step(memory, prefetched, shares, np.array(prefetch.FITTED))
        fired.append(prefetched[-1].tolist())
    states = {state for one in fired for state in one}
    assert {prefetch.PREDICTED, prefetch.ENTERED, prefetch.RESTING} <= states
    return {
        "table": rectangles.tolist(),
        "settings": list(settings),
        "events": events.tolist(),
        "answers": answers.tolist(),
        "shares": all_shares,
        "decisions": decisions,
        "thresholds": thresholds.tolist(),
        "fired": fired,
    }


def cases() -> dict[str, Any]:
    """Everything that is compared."""
    return {"streams": list(streams()), "targets": targets()}
