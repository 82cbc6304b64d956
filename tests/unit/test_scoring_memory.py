"""Beside a predictor that remembers: how much of a set repeats, and the same predictor without memory."""

from __future__ import annotations

import json
from math import hypot
from pathlib import Path

import numpy as np
import pytest

from pointpred import build
from pointpred.datasets import sample
from pointpred.recordings import write
from pointpred.records import EventColumns
from pointpred.registry import REGISTRY, ablation
from pointpred.scoring import about_memory, prepare, rows, score, summarise
from pointpred.scoring.scorer import with_ablations
from pointpred.scoring.trials import LAST_DISTANCES, LAST_ENDS, repeats

LEARNS = "kinematic-adaptive"
WITHOUT = f"{LEARNS}:places=0:distances=0"


def test_what_repeats_is_found_as_by_looking_at_each_pair() -> None:
    random = np.random.default_rng(8)
    count = 400
    users = [f"p{k}" for k in random.integers(0, 2, count)]  # their trials alternate
    spots = (
        random.integers(0, 1000, (count, 2, 2)).astype(float) // random.choice([1, 250], (count, 1, 1)) * 7
    )
    spots[:, 1] += [3.0, 4.0]
    points = spots.reshape(-1, 2)
    events = EventColumns.of(np.arange(2.0 * count) / 100, points[:, 0], points[:, 1])
    ends, distances = repeats(events, np.arange(0, 2 * count + 1, 2), users)
    for k in range(count):
        (a, b), mine = spots[k], [j for j in range(k) if users[j] == users[k]]
        far = hypot(*(b - a))
        near = [j for j in mine[-LAST_ENDS:] if hypot(*(spots[j][1] - b)) <= 0.03 * far]
        alike = [
            j for j in mine[-LAST_DISTANCES:] if abs(hypot(*(spots[j][1] - spots[j][0])) - far) <= 0.03 * far
        ]
        assert (ends[k], distances[k]) == (bool(near), bool(alike))
    assert 0.1 < ends.mean() < 0.9
    assert 0.1 < distances.mean() < 0.9


def test_what_remembers_is_followed_by_the_same_without() -> None:
    assert with_ablations(["linear", LEARNS, "ktm"]) == ["linear", LEARNS, WITHOUT, "ktm"]
    assert with_ablations([WITHOUT, LEARNS]) == [WITHOUT, LEARNS]
    for name in (WITHOUT, f"{LEARNS}:adapt=0", "ktm"):
        assert ablation(name) is None
    for entry in REGISTRY.values():
        assert set(entry.predictor.without_memory) <= {one.name for one in entry.predictor.parameters}


@pytest.mark.parametrize("spot", [(900.0, 400.0), (40.0, 860.0)])
def test_without_memory_nothing_draws_towards_where_movements_ended(spot: tuple[float, float]) -> None:
    """The same movement after ten to one place and after ten to another, equally fast and far, ends alike."""
    fast = 10 * np.linspace(0, 1, 60) ** 3 - 15 * np.linspace(0, 1, 60) ** 4 + 6 * np.linspace(0, 1, 60) ** 5
    ends = []
    for last in (spot, (spot[0], -spot[1])):
        pipeline = build(LEARNS, **REGISTRY[LEARNS].predictor.without_memory)
        for target in (*[last] * 10, (500.0, 10.0)):
            pipeline.reset()
            table = np.column_stack([np.arange(60) / 100, fast * target[0], fast * target[1]])
            answers = pipeline.push(EventColumns.of(*table.T))
        ends.append(answers[30, 1:3])
        assert pipeline.places == ()
    assert np.hypot(*(ends[0] - ends[1])) < 1.0


def test_the_table_and_the_document_say_how_much_is_memory(command, tmp_path: Path) -> None:
    short = sample().part(0, 48)
    (one,) = score([short], with_ablations([LEARNS]))
    summary = summarise(one)
    prepared = prepare(short).trials
    assert summary.repeats.ends == np.mean([each.end_repeats for each in prepared])
    assert summary.repeats.distances == np.mean([each.distance_repeats for each in prepared])
    hold, learns, without = summary.predictors
    assert (hold.learns, learns.learns, learns.ablates, without.ablates) == (False, True, "", LEARNS)
    assert [row[0] for row in rows(summary)] == ["hold", LEARNS, "  without memory"]
    assert WITHOUT in about_memory(summary)
    plain = summarise(score([short], ["linear"])[0])
    assert (plain.repeats, about_memory(plain)) == (None, "")
    file, _ = write(short, tmp_path / "short_samples.parquet")
    left = command("score", file, "--predictors", LEARNS, "--json", "-")
    (told,) = json.loads(left.out)["sets"]
    assert [each["name"] for each in told["predictors"]] == ["hold", LEARNS, WITHOUT]
    assert told["repeats"]["distances"] > 0.5
