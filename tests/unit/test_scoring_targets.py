"""Layouts found again, and the scorer's account against a chooser and its ledger."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pointpred import build
from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.records import EventColumns
from pointpred.scoring import target_choice as replaying
from pointpred.scoring.target_choice import ASKS, NEAREST, score_targets, summarise_targets
from pointpred.scoring.target_layouts import circle, grids, layouts
from pointpred.scoring.trials import prepare
from pointpred.simulation.circle import positions
from pointpred.targets import Chooser, posterior
from tests.building import recording as recorded
from tests.building import way
from tests.conftest import Left


@pytest.mark.parametrize("count", [9, 13, 21])
@pytest.mark.parametrize("mirrored", [False, True])
def test_a_circle_is_found_from_targets_in_the_order_across(count: int, mirrored: bool) -> None:
    generator = np.random.default_rng(count)
    angles = 2.0 * np.pi * np.arange(count) * (count // 2) / count * (-1.0 if mirrored else 1.0)
    order = np.column_stack([500.0 + 300.0 * np.cos(angles), 400.0 + 300.0 * np.sin(angles)])
    starts = order[:-1] + generator.normal(0.0, 4.0, (count - 1, 2))
    found = circle(order[1:], starts)
    assert found is not None
    for places, end in zip(found, order[1:], strict=True):
        assert len(places) == count
        assert np.hypot(*(places[0] - end)) < 1e-9
        assert all(np.hypot(*(order - place).T).min() < 1.5 for place in places)


def test_scattered_targets_are_no_circle() -> None:
    ends = np.random.default_rng(0).uniform(0.0, 900.0, (20, 2))
    assert circle(ends, np.roll(ends, 1, axis=0)) is None


def test_the_circles_of_the_sample_are_those_it_was_made_with() -> None:
    recording = sample()
    (found,) = layouts(prepare(recording)).values()
    assert len(found) == len(recording.trials)
    for layout in found:
        trial = recording.trials[layout.trial]
        places = np.array(positions(float(trial.condition["distance_mm"]) * 96.0 / 25.4, (960.0, 540.0)))
        off = np.hypot(*(places[:, None] - layout.table[:, :2]).transpose(2, 0, 1)).min(axis=0)
        assert off.max() < 2.0
        assert np.allclose(layout.table[layout.right, :2], (trial.target_x, trial.target_y), atol=0.01)


def free(count: int = 30) -> Recording:
    generator = np.random.default_rng(9)
    parts = []
    for _ in range(count):
        angle, far = generator.uniform(0.0, 6.28), generator.uniform(200.0, 800.0)
        s = np.linspace(0.0, 1.0, 60)
        gone = far * way(s)
        parts.append(EventColumns.of(t=0.8 * s, x=gone * np.cos(angle), y=gone * np.sin(angle)))
    return recorded(parts, "free")


def test_the_end_of_a_free_movement_lies_in_the_right_cell_of_its_grid_and_the_seed_decides_which() -> None:
    prepared = prepare(free(200))
    found = grids(prepared, range(200), 1)
    for layout in found:
        end = prepared.rows(layout.trial).table[-1, 1:3]
        off = np.abs(layout.table[:, :2] - end)
        inside = (off <= 0.5 * layout.table[:, 2:4] + 1e-9).all(axis=1)
        assert np.flatnonzero(inside).tolist() == [layout.right]
    again = grids(prepared, range(200), 1)
    assert all((a.table == b.table).all() and a.right == b.right for a, b in zip(found, again, strict=True))
    other = grids(prepared, range(200), 2)
    assert any(a.right != b.right for a, b in zip(found, other, strict=True))
    assert len({layout.right for layout in found}) == 15


def test_the_account_is_that_of_a_chooser_and_its_ledger() -> None:
    """Two books on the same movements: the compiled one of the scorer, the ledger of a chooser."""
    recording = free()
    (scored,) = score_targets(recording, ("minimum-jerk",), threads=1)
    ours = next(one for one in scored.scores if one.name == "minimum-jerk")
    prepared = prepare(recording)
    (found,) = layouts(prepared).values()
    asked = ASKS.index(0.26)
    pipeline = build("minimum-jerk", learn=0)
    chooser = Chooser(pipeline, precision=0.26)
    for place, layout in enumerate(found):
        pipeline.reset()
        chooser.reset()
        pipeline.register(layout.targets)
        chooser.follow_targets()
        for event in prepared.rows(layout.trial).events():
            pipeline.update(event)
            chooser.update()
        done, account = chooser.finish(layout.right), ours.accounts[place, asked]
        assert account[replaying.PROPOSED] == done.proposed
        assert account[replaying.PROPOSED_RIGHT] == done.proposed - done.wasted
        assert account[replaying.RETRACTED] == done.retracted
        assert account[replaying.HIT] == done.hit
        lead = np.nan if done.lead_entry_s is None else done.lead_entry_s
        assert account[replaying.LEAD_ENTRY] == pytest.approx(lead, nan_ok=True)
    assert chooser.ledger.hits > 0
    assert chooser.ledger.wasted > 0


def test_nearest_is_right_where_plain_geometry_says_so() -> None:
    recording = free()
    (scored,) = score_targets(recording, (), threads=1)
    prepared = prepare(recording)
    (found,) = layouts(prepared).values()
    right = []
    for layout in found:
        rows = prepared.rows(layout.trial)
        first, arrival = int(prepared.offsets[layout.trial]), int(prepared.arrivals[layout.trial])
        until = rows.t[0] + 0.5 * (rows.t[arrival - first] - rows.t[0])
        x, y = rows.table[rows.t <= until][-1, 1:3]
        right.append(np.hypot(layout.table[:, 0] - x, layout.table[:, 1] - y).argmin() == layout.right)
    described = summarise_targets(scored)
    assert described.nearest_centre[0.5] == pytest.approx(np.mean(right))
    assert described.predictors[0].name == NEAREST
    assert described.predictors[0].right[0.5] == pytest.approx(np.mean(right))


def test_what_comes_later_does_not_change_a_choice() -> None:
    (layout,) = [found[0] for found in layouts(prepare(free(1))).values()]
    events = prepare(free(1)).events.table
    answers = np.full((len(events), 10), np.nan)
    whole, half = np.empty((len(events), 16)), np.empty((30, 16))
    replaying.weigh(events, answers, layout.table, posterior.FITTED, 0.1, whole)
    replaying.weigh(events[:30], answers[:30], layout.table, posterior.FITTED, 0.1, half)
    assert (whole[:30] == half).all()


def test_the_command_prints_tables_and_json(command: Callable[..., Left], tmp_path: Path) -> None:
    target = tmp_path / "out.json"
    told = command("score", "--targets", "--predictors", "minimum-jerk", "--json", target)
    document = json.loads(target.read_text(encoding="utf-8"))
    assert told.code == 0
    assert "nearest to the cursor" in told.out
    assert [one["layout"] for one in document["targets"]] == ["circle of 13"]
    assert [p["name"] for p in document["targets"][0]["predictors"]] == [NEAREST, "minimum-jerk"]
