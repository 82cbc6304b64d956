"""The page's own arithmetic, run in the browser and held against Python's."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from pointpred import Prediction
from pointpred.recordings import read
from pointpred.simulation.circle import positions
from tests.server import browser, page_browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed


@pytest.fixture(scope="module")
def visitor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.service() as url, page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.open(f"{url}#circle")
        yield opened


def call(visitor: Visitor, module: str, expression: str, **given: Any) -> Any:
    """An expression with the module's exports as ``m`` and what is given by name."""
    names, values = ", ".join(given), ", ".join(json.dumps(value) for value in given.values())
    return visitor.value(f"import('/web/{module}.js').then((m) => (({names}) => {expression})({values}))")


@pytest.mark.parametrize(("distance", "count"), [(300.0, 13), (120.5, 3), (500.0, 41)])
def test_targets_lie_where_the_simulation_puts_them(visitor: Visitor, distance: float, count: int) -> None:
    placed = call(visitor, "page/study/task", "m.circle(d, [10, 20], n)", d=distance, n=count)
    assert np.allclose(placed, positions(distance, (10.0, 20.0), count), atol=1e-9)


def test_an_even_number_of_targets_is_refused(visitor: Visitor) -> None:
    attempt = "{ try { m.circle(100, [0, 0], 12) } catch (error) { return error.name } }"
    assert call(visitor, "page/study/task", attempt) == "RangeError"


@pytest.mark.parametrize("tail", [None, 0.6, 1.4, 30.0, 1e-3, 1e15, 1e200])
@pytest.mark.parametrize("scale", [(400.0, 120.0, 90.0), (9.0, 0.0, 25.0), (1.0, -0.9, 1.0), (9.0, 0.0, 9.0)])
def test_regions_are_those_of_the_package(
    visitor: Visitor, scale: tuple[float, float, float], tail: float | None
) -> None:
    """``tests/unit/test_regions.py`` holds the package's own against the laws."""
    sxx, sxy, syy = scale
    shown = {"x": 3.5, "y": -4.0, "region": {"sxx": sxx, "sxy": sxy, "syy": syy, "tail": tail}}
    levels = [1e-9, 0.5, 0.8, 0.95]
    drawn = call(visitor, "lib/client/regions", "levels.map((p) => m.regionOf(r, p))", r=shown, levels=levels)
    for level, found in zip(levels, drawn, strict=True):
        wanted = Prediction(0.0, 3.5, -4.0, scale, "ballistic", None, tail).region(level)
        if wanted is None or found is None:
            assert found is wanted
        else:
            assert found == pytest.approx(msgspec.to_builtins(wanted), rel=1e-12, abs=1e-15)


@pytest.mark.parametrize(
    "shown",
    [None, {"x": None, "y": None, "region": None}, {"x": 1, "y": 2, "region": None},
     {"x": 1, "y": 2, "region": {"sxx": 4, "sxy": 6, "syy": 9, "tail": None}},
     {"x": 1, "y": 2, "region": {"sxx": 4, "sxy": 0, "syy": 9, "tail": 0}},
     {"x": 1, "y": 2, "region": {"sxx": 4, "sxy": 0, "syy": 9, "tail": 1e-9}},
     {"x": 1, "y": 2, "region": {"sxx": 1e300, "sxy": 0, "syy": 1, "tail": 0.01}}],
)  # fmt: skip
def test_no_region_is_drawn_where_none_is_claimed(visitor: Visitor, shown: Any) -> None:
    assert call(visitor, "lib/client/regions", "m.regionOf(r, 0.5)", r=shown) is None


@pytest.mark.parametrize("level", [0, 1, -0.5, 2, None])
def test_a_region_of_no_possible_level_is_refused(visitor: Visitor, level: float | None) -> None:
    attempt = "{ try { m.regionOf(null, p) } catch (e) { return e instanceof RangeError } }"
    assert call(visitor, "lib/client/regions", attempt, p=level) is True


@pytest.mark.parametrize("values", [[3.0, 1.0, 2.0], [4.0, 1.0, 2.0, 10.0], [7.0]])
def test_median(visitor: Visitor, values: list[float]) -> None:
    assert call(visitor, "page/shell/numbers", "m.median(v)", v=values) == np.median(values)


PRESSES = """(() => {
  const one = { width: 20, height: null, movements: 3, places: m.circle(100, [0, 0], 3) };
  const task = new m.PointingTask([{ ...one, block: 1 }, { ...one, block: 2 }], [0, 0]);
  const press = (t, off = 0) => {
    const { x, y } = task.goal;
    const row = [t, x + off, y, null, null, 1];
    task.move([[t - 0.01, x, y, null, null, 0], row]);
    return task.select(row);
  };
  press(0, 15);
  const before = [task.running, task.misplaced, task.trials.length];
  const ends = [press(1), press(2), press(3, 15), press(4), press(5, -15)];
  const between = [task.running, task.sequence.block, task.misplaced, task.done];
  press(6); press(7); press(8); press(9);
  const late = press(10);
  const ended = ends.map((one) => one && [one.number, one.hit, one.rows.length]);
  const told = ({ sequence, number, rows }) => [sequence.block, number, rows[0][0], rows.length];
  return { before, between, ended, done: task.done, late, all: task.trials.map(told) };
})()"""


def test_a_block_begins_on_its_first_target_and_a_miss_counts(visitor: Visitor) -> None:
    found = call(visitor, "page/study/task", PRESSES)
    assert found["before"] == [False, 1, 0]
    assert found["ended"] == [None, [1, True, 2], [2, False, 2], [3, True, 2], None]
    assert found["between"] == [False, 2, 2, False]
    assert found["done"] is True
    assert found["late"] is None
    assert [row[:2] for row in found["all"]] == [[1, 1], [1, 2], [1, 3], [2, 1], [2, 2], [2, 3]]
    assert [row[2] for row in found["all"]] == pytest.approx([1.99, 2.99, 3.99, 6.99, 7.99, 8.99])


ON_ERROR = """["go-on", "repeat", "until-inside"].map((onError) => {
  const one = { width: 20, height: 60, movements: 2, places: [[-50, 0], [50, 0]] };
  const task = new m.PointingTask([one], [100, 100], onError);
  const press = (t, dx, dy = 0) => {
    const row = [t, task.goal.x + dx, task.goal.y + dy, null, null, 1];
    task.move([row]);
    task.select(row);
  };
  press(0, 0); press(1, 11); press(2, 0, 29); press(3, 0); press(4, 0); press(5, 0);
  const told = ({ number, hit, clicks, from, rows }) => [number, hit, clicks, from[0], rows.length];
  return [task.done, ...task.trials.map(told)];
})"""


def test_what_follows_a_miss_of_a_bar(visitor: Visitor) -> None:
    go_on, repeat, inside = call(visitor, "page/study/task", ON_ERROR)
    assert go_on == [True, [1, False, 1, 50, 1], [2, True, 1, 150, 1]]
    assert repeat == [True, [1, False, 1, 50, 1], [1, True, 1, 50, 1], [2, True, 1, 150, 1]]
    assert inside == [True, [1, False, 2, 50, 2], [2, True, 1, 150, 1]]


MANY = """(() => {
  const one = { width: 20, height: null, movements: 1, places: [[0, 0], [50, 0]] };
  const task = new m.PointingTask([one], [0, 0]);
  task.select([0, 0, 0]);
  for (let i = 1; i <= 700; i++) task.move(Array.from({ length: 100 }, (_, k) => [i + k / 100, 0, 0]));
  task.move([[800, 50, 0]]);
  const { rows, lost } = task.select([800, 50, 0]);
  return [rows.length, rows.at(-1)[0], lost];
})()"""


def test_a_movement_without_end_keeps_its_end_and_counts_what_is_lost(visitor: Visitor) -> None:
    assert call(visitor, "page/study/task", MANY) == [60_000, 800, 70_001 - 60_000]


def trial(number: int, start: list[float], end: list[float], block: int = 1, **other: Any) -> dict[str, Any]:
    """A movement along the x axis from 0 to 100."""
    sequence = {"block": block, "width": 20.0, "distance": 100.0}
    about = {"from": [0.0, 0.0], "target": [100.0, 0.0], "sequence": sequence, "hit": True}
    rows = [[*start, None, None, 0], [*end, None, None, 1]]
    return about | {"number": number, "start": rows[0], "end": rows[1], "rows": rows} | other


def test_statistics_of_a_block_worked_out_by_hand(visitor: Visitor) -> None:
    trials = [
        trial(1, [0.0, 2.0, 5.0], [0.5, 98.0, 0.0]),
        trial(2, [1.0, 0.0, 0.0], [1.7, 104.0, 3.0]),
        trial(3, [2.0, -2.0, 1.0], [2.9, 100.0, 0.0], hit=False),
    ]
    found = call(visitor, "page/circle/statistics", "m.blockStatistics(t)", t=trials)
    width = 4.133 * math.sqrt(28.0 / 3.0)  # beside by -2, 4 and 0: mean 2/3
    assert found["effectiveWidth"] == pytest.approx(width)
    assert found["effectiveDistance"] == pytest.approx((96 + 104 + 102) / 3)
    assert found["movementTime"] == pytest.approx(0.7)
    assert found["throughput"] == pytest.approx(math.log2(302 / 3 / width + 1) / 0.7)
    assert (found["misses"], found["trials"]) == (1, 3)


def test_statistics_say_nothing_where_they_mean_nothing(visitor: Visitor) -> None:
    same = [trial(i, [i, 0.0, 0.0], [i + 0.5, 100.0, 0.0]) for i in (1, 2)]
    close = [trial(i, [i, 0.0, 0.0], [i + 0.5, 100.0 + 1e-6 * i, 0.0]) for i in (1, 2)]
    for trials in ([], same[:1], same, close):
        found = call(visitor, "page/circle/statistics", "m.statistics(t)", t=trials)
        assert found["throughput"] is None
        assert found["trials"] == len(trials)


def test_throughput_is_the_mean_over_blocks(visitor: Visitor) -> None:
    first = [trial(i, [i, 0.0, 0.0], [i + 0.5, 99.0 + 2 * (i % 2), 0.0]) for i in range(1, 5)]
    second = [trial(i, [i, 0.0, 0.0], [i + 0.8, 97.0 + 6 * (i % 2), 0.0], block=2) for i in range(1, 5)]
    each = [
        call(visitor, "page/circle/statistics", "m.blockStatistics(t)", t=part) for part in (first, second)
    ]
    found = call(visitor, "page/circle/statistics", "m.statistics(t)", t=first + second)
    assert found["throughput"] == pytest.approx((each[0]["throughput"] + each[1]["throughput"]) / 2)
    assert [block["block"] for block in found["blocks"]] == [1, 2]


def test_recordings_read_back_to_the_same_bits(visitor: Visitor, tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    trials = []
    for number in (1, 2, 3):
        rows = [
            [t, *rng.normal(300.0, 200.0, 2).tolist(), None, None, 0]
            for t in (10.0 * number + np.sort(rng.random(5))).tolist()
        ]
        trials.append(trial(number, [10.0 * number, 0.1, 0.2], [rows[-1][0], 99.7, 1e-7], rows=rows))
    trials[1]["rows"] = []
    files = call(visitor, "page/circle/recording", "m.recording(t, 'night', 'P07')", t=trials)
    for file in files.values():
        (tmp_path / file["name"]).write_text(file["text"], encoding="utf-8")
    recording = read(tmp_path / "night_samples.csv")
    assert recording.name == "night"
    assert {one.user for one in recording.trials} == {"P07"}
    assert [skip.trial for skip in recording.skipped] == ["block-1-movement-2"]
    assert [one.condition["hit"] for one in recording.trials] == [1.0, 1.0]
    for i, one in enumerate((trials[0], trials[2])):
        events = recording.rows(i)
        written = np.array([row[:3] for row in one["rows"]])
        assert np.array_equal(np.column_stack([events.t, events.x, events.y]), written)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("user,trial,t_s\nu,1,0\n", "row 0 has 3 cells, expected 4"),
        ('# pointpred: {"rows": 2}\na,b\n1,2\n', "1 rows, but its header says 2"),
    ],
)
def test_damaged_tables_are_refused(visitor: Visitor, text: str, sentence: str) -> None:
    damaged = text.replace("t_s\n", "t_s,x_px\n")
    catch = "{ try { m.parse(text) } catch (error) { return error.message } }"
    assert call(visitor, "page/replay/csv", catch, text=damaged) == sentence


def test_quoted_cells(visitor: Visitor) -> None:
    text = '"a","b"\n"one, two","say ""so"""\n,3\n'
    assert call(visitor, "page/replay/csv", "m.parse(text).rows", text=text) == [
        ["one, two", 'say "so"'],
        ["", "3"],
    ]


@pytest.mark.parametrize("rate_hz", [60, 125, 1000])
def test_a_constant_speed_is_shown_whatever_the_rate(visitor: Visitor, rate_hz: int) -> None:
    trail = [[i / rate_hz, 300.0 * i / rate_hz, 400.0 * i / rate_hz] for i in range(rate_hz)]
    last = trail[-1][0]
    found = call(
        visitor, "page/live/movement", "[0, 0.01, 0.03, 0.051].map((s) => m.speed(t, l + s))", t=trail, l=last
    )
    assert found == pytest.approx([500.0, 500.0, 500.0, 0.0])


def test_a_pause_does_not_slow_what_comes_after_it(visitor: Visitor) -> None:
    trail = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.01, 5.0, 0.0]]
    assert call(visitor, "page/live/movement", "m.speed(t, 1.01)", t=trail) == pytest.approx(500.0)
    assert call(visitor, "page/live/movement", "m.speed(t.slice(0, 2), 1.01)", t=trail) == 0.0
    assert call(visitor, "page/live/movement", "m.speed([], 1)") == 0.0


def test_phase_intervals(visitor: Visitor) -> None:
    samples = [
        [0, "still"],
        [1, "ballistic"],
        [2, "ballistic"],
        [3, "corrective"],
        [4, None],
        [5, "ballistic"],
    ]
    found = call(visitor, "page/live/strip", "m.phaseIntervals(s)", s=samples)
    assert found == [["ballistic", 1, 3], ["corrective", 3, 4]]


def test_an_entry_takes_nothing_from_the_prediction_of_another_tile(visitor: Visitor) -> None:
    """Of each choice: time, target, what to do, why; the tile that is predicted is what the demo shows."""
    rows = [
        (1.0, "goal", "propose", "predicted"),
        (2.0, "passed", "propose", "entered"),
        (3.0, "passed", "retract", None),
        (5.0, "goal", "retract", None),
        (5.0, "other", "propose", "predicted"),
    ]
    choices = [dict(zip(("t", "id", "action", "reason"), row, strict=True)) for row in rows]
    times = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    said = call(visitor, "page/live/takes", "m.proposedAt(times, choices)", times=times, choices=choices)
    assert said == [None, "goal", "goal", "goal", "goal", "other", "other"]


def test_a_row_is_scored_by_what_was_shown_meanwhile(visitor: Visitor) -> None:
    """The same by numpy: at each sample the newest prediction counts, from the onset to the arrival."""
    t = np.arange(0.0, 0.5, 0.01)
    x = 400.0 * np.clip(t / 0.4, 0.0, 1.0) ** 2
    rows = [[2.0 + s, p, 10.0, None, None, 0] for s, p in zip(t.tolist(), x.tolist(), strict=True)]
    shown = [{"t": 2.0 + s, "x": 300.0 + 200.0 * s, "y": 10.0} for s in (-0.05, 0.12, 0.2, 0.31)]
    shown.append({"t": 2.35, "x": None, "y": None})
    found = call(visitor, "page/circle/rows", "m.scoreOfShown({ start: [2.0], rows: r }, s)", r=rows, s=shown)
    point = x.copy()
    for one, until in zip(shown[1:4], (0.2, 0.31, 0.35), strict=True):
        point[(2.0 + t >= one["t"]) & (t < until)] = one["x"]
    onset, stop = int(np.flatnonzero(x <= 3.0)[-1]), int(np.flatnonzero(np.abs(x - 400.0) > 12.0)[-1]) + 1
    weight = np.diff(t)[onset:stop]
    for name, at in (("time_averaged_px", point), ("hold_px", x)):
        assert found[name] == pytest.approx(
            np.average(np.abs(at - 400.0)[onset:stop], weights=weight), rel=1e-9
        )
