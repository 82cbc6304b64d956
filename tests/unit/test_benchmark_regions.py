"""The table of what is drawn: who is judged by which coefficients, and what counts as inside."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from evidence.held_out import HeldOut
from evidence.person import regions
from evidence.person.regions import LEVELS, SHARES, Drawn
from pointpred import EventColumns, run
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recording import Recording, Trial
from pointpred.records import RegionColumns
from pointpred.scoring import prepare

EACH = 12


def recording() -> Recording:
    """Twelve movements of each of two people, in turn: who learns must be told them apart."""
    random, s = np.random.default_rng(3), np.linspace(0.0, 1.0, 40)
    way = s**3 * (10 - 15 * s + 6 * s**2)
    ends = random.uniform(-600, 600, (2 * EACH, 2, 1))
    parts = [EventColumns.of(0.016 * np.arange(40), *(end * way)) for end in ends]
    return Recording.of("freihaut2021", parts, [Trial(f"u{i % 2}", str(i)) for i in range(2 * EACH)])


@pytest.fixture(scope="module")
def held(tmp_path_factory: pytest.TempPathFactory) -> HeldOut:
    """Two files that differ in one number, so that their answers do."""
    folder, made = tmp_path_factory.mktemp("coefficients"), []
    with np.load(coefficient_file.OWN) as file:
        own = {key: file[key] for key in file.files}
    for number in range(2):
        made.append(folder / f"{number}.npz")
        np.savez(made[-1], **own | {"offset2": own["offset2"] + np.float32(0.1 * number)})
    return HeldOut({}, made, {"freihaut2021 u0": 0, "freihaut2021 u1": 1})


@pytest.fixture(scope="module", params=regions.NAMES)
def drawn(request: pytest.FixtureRequest, held: HeldOut) -> Drawn:
    return regions.drawn(request.param, held, recording())


def test_each_person_is_judged_in_order_by_the_fold_without_him(drawn: Drawn, held: HeldOut) -> None:
    """Worked out anew: batch predictions, Mahalanobis distances, the drawn time found by hand."""
    prepared = prepare(recording())
    assert drawn.people.tolist() == ["u0"] * EACH + ["u1"] * EACH
    assert drawn.order.tolist() == [*range(EACH)] * 2
    wanted = []
    for user in ("u0", "u1"):
        pipeline = held.of_people(drawn.predictor, recording())[user].fresh()
        for k, scored in enumerate(prepared.trials):
            if scored.trial.user != user:
                continue
            pipeline.reset()
            events = prepared.rows(k)
            answers = run(pipeline, EventColumns(events.table))
            arrival = events.t[prepared.arrivals[k] - prepared.offsets[k]]
            for share in SHARES:
                then = events.t[0] + share * (arrival - events.t[0])
                one = answers[int(np.flatnonzero(events.t <= then)[-1])]
                assert one is not None
                assert one.scale is not None
                assert one.tail is not None
                sxx, sxy, syy = one.scale
                off = np.array([events.x[-1] - one.x, events.y[-1] - one.y])
                far = off @ np.linalg.solve([[sxx, sxy], [sxy, syy]], off)
                wanted.append([far <= one.tail * ((1 - p) ** (-2 / one.tail) - 1) for p in LEVELS])
    assert drawn.inside.reshape(-1, len(LEVELS)).tolist() == np.array(wanted, float).tolist()
    assert 0.0 < drawn.inside.mean() < 1.0


def test_inside_is_inside_the_ellipse() -> None:
    ellipses = RegionColumns([[10, 20, 5, 1, np.pi / 2], [10, 20, 5, 1, 0.0], [np.nan] * 5]).table
    assert regions.holds(ellipses, 10.0, 24.9).tolist()[:2] == [1.0, 0.0]
    assert regions.holds(ellipses, 14.9, 20.0).tolist()[:2] == [0.0, 1.0]
    assert np.isnan(regions.holds(ellipses, 10.0, 20.0)[2])


def test_tables_count_each_movement_once_and_leave_out_the_first(tmp_path: Path) -> None:
    def one(name: str, count: int, held: float) -> Drawn:
        inside = np.full((count, len(SHARES), len(LEVELS)), held)
        size, way = np.full((count, len(LEVELS)), 10.0 * count), np.full(count, 7.0)
        return Drawn(name, "kinematic", np.array(["a"] * count), np.arange(count), inside, size, way)

    cells = regions.coverage([one("small", 10, 0.0), one("large", 30, 1.0)]).texts()
    assert [row[:5] for row in cells] == [
        ["small", "all", "1", "10", "0 / 0 / 0"],
        ["large", "all", "1", "30", "100 / 100 / 100"],
        ["large", "after 20", "1", "10", "100 / 100 / 100"],
        ["all", "all", "2", "40", "75 / 75 / 75"],
        ["all", "after 20", "1", "10", "100 / 100 / 100"],
    ]
    sizes = regions.sizes([one("small", 10, 0.0), one("large", 30, 1.0)]).texts()[-1]
    assert sizes == ["all", "300", "300", "7"]


def test_the_mixture_is_read_at_the_same_moments(held: HeldOut) -> None:
    """Worked out anew, the last movement of a person: the events before half of the time, then the region."""
    mixed, prepared = regions.mixed(held, recording()), prepare(recording())
    pipeline = held.of_people("kinematic-adaptive", recording())["u0"].fresh()
    mine = [k for k, one in enumerate(prepared.trials) if one.trial.user == "u0"]
    for k in mine[:-1]:
        run(pipeline, prepared.rows(k))
    events = prepared.rows(mine[-1])
    t, arrival = events.t - events.t[0], int(prepared.arrivals[mine[-1]] - prepared.offsets[mine[-1]])
    run(pipeline, events.rows(0, int((t <= 0.5 * t[arrival]).sum())))
    assert pipeline.mixture is not None
    last = mixed.people.tolist().index("u1") - 1
    for which, level in enumerate(LEVELS):
        region = pipeline.mixture.region(level)
        inside = region.contains(float(events.x[-1]), float(events.y[-1]))
        assert mixed.inside[last, SHARES.index(0.5), which] == inside
        assert mixed.size[last, which] == pytest.approx(np.sqrt(region.area / np.pi))
