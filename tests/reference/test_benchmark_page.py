"""The golden numbers of docs/guide/benchmark.md: by its definitions in plain Python, and by our scoring."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import pairwise
from math import exp, hypot, log, pi, sqrt
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np
import pytest

from pointpred.benchmark import benchmark_sets
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recording import Recording, Trial
from pointpred.recordings import read
from pointpred.records import BoolArray, EventColumns, FloatArray, MotionColumns
from pointpred.scoring import SetScore, SetSummary, score, summarise
from pointpred.scoring.summary.bootstrap import ratio_intervals
from tests.architecture.tree import ROOT
from tests.scripted import Scripted, pipeline_with

PAGE = (ROOT / "docs/guide/benchmark.md").read_text(encoding="utf-8")
TARGET = (300.0, 200.0, 44.0)
Q_TIME = [q / 100 for q in range(20, 91, 10)]
Q_PATH = [0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 1.0]
Q_AXIS = [q / 100 for q in range(5, 101, 5)]
TENTHS = [q / 10 for q in range(1, 10)]
LEVELS = {0.5: 0.674490, 0.8: 1.281552, 0.95: 1.959964}
Row = tuple[float, float, float, int]


def cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip("| \n").split("|")]


def movement() -> list[Row]:
    lines = [line for line in PAGE.splitlines() if re.match(r"\| (t, s|x, px|y, px|pressed) ", line)]
    columns = [[float(cell) for cell in cells(line)[1:]] for line in lines]
    return [(t, x, y, int(pressed)) for t, x, y, pressed in zip(*columns, strict=True)]


def dist(a: Any, b: Any) -> float:
    return hypot(a[0] - b[0], a[1] - b[1])


def cut(rows: list[Row]) -> tuple[list[Row], int]:
    """Points 1 to 3 of the protocol: the samples from onset to truth, and the place of the arrival."""
    far = [dist(row[1:3], rows[0][1:3]) > 3.0 for row in rows]
    presses = [i for i in range(1, len(rows)) if rows[i][3] and not rows[i - 1][3] and far[i]]
    rows = rows[: presses[-1] + 1] if presses else rows
    rows = rows[max(i for i in range(len(rows)) if not far[i]) :]
    ends = [dist(row[1:3], rows[-1][1:3]) for row in rows]
    near = max(8.0, 0.03 * ends[0])
    return rows, max(i for i, end in enumerate(ends) if end > near) + 1


def hold(rows: list[Row]) -> list[Any]:
    return [row[1:3] for row in rows]


def ahead(rows: list[Row]) -> list[Any]:
    return [None, *((b[1] + 2.0 * (b[1] - a[1]), b[2] + 2.0 * (b[2] - a[2])) for a, b in pairwise(rows))]


def protocol(rows: list[Row], answers: Callable[[list[Row]], list[Any]]) -> dict[str, list[float]]:
    """Every row of the page's table for one predictor; the claims are those of ``ahead``."""
    rows, arrival = cut(rows)
    made = answers(rows)
    t, at, truth = [row[0] for row in rows], [row[1:3] for row in rows], rows[-1][1:3]
    shown = [z if p is None else p for z, p in zip(at, made, strict=True)]
    error = [dist(p, truth) for p in shown]
    span = t[arrival] - t[0]
    weights = [min(t[i + 1] - t[i], 0.05) for i in range(arrival)]
    moment = {q: max(i for i in range(len(t)) if t[i] <= t[0] + q * span + 1e-6) for q in {*Q_TIME, *TENTHS}}

    def mean(values: list[float], of: list[bool] | None = None) -> float:
        kept = [w if of is None or of[i] else 0.0 for i, w in enumerate(weights)]
        return sum(w * v for w, v in zip(kept, values, strict=False)) / sum(kept)

    way = (truth[0] - at[0][0], truth[1] - at[0][1])
    progress = [
        ((z[0] - at[0][0]) * way[0] + (z[1] - at[0][1]) * way[1]) / dist(way, (0, 0)) ** 2 for z in at
    ]
    axis = int(abs(way[1]) > abs(way[0]))
    along = [(z[axis] - at[0][axis]) / way[axis] for z in at]

    def first(reached: list[float], q: float) -> int:
        return next(i for i, value in enumerate(reached) if value >= q - 1e-12)

    found = {
        "time-averaged error, px": [mean(error)],
        "error by time, px": [error[moment[q]] for q in Q_TIME],
        "error by path, px": [error[first(progress, q)] for q in Q_PATH],
        "single axis, px": [abs(shown[first(along, q)][axis] - truth[axis]) for q in Q_AXIS],
        "coverage": [sum(p is not None for p in made) / len(made)],
        "hit": [float(dist(shown[moment[q]], TARGET) <= TARGET[2] / 2) for q in Q_TIME],
    }
    if answers is hold:
        return found
    claimed = [p is not None for p in made]
    surprise = [dist(p, truth) ** 2 / 400.0 for p in shown]
    inside = {level: [float(u <= -2.0 * log(1.0 - level)) for u in surprise] for level in LEVELS}
    normal = NormalDist()

    def ranked(off: float) -> float:
        k = off / 20.0
        density = exp(-0.5 * k * k) / sqrt(2.0 * pi)
        return 20.0 * (k * (2.0 * normal.cdf(k) - 1.0) + 2.0 * density - 1.0 / sqrt(pi))

    scores = [0.5 * (ranked(p[0] - truth[0]) + ranked(p[1] - truth[1])) for p in shown]
    left = [t[arrival] - now for now in t]
    arrives = {
        level: [float(abs(log(max(rest, 1e-6) / 0.07)) <= k * 0.4) for rest in left]
        for level, k in LEVELS.items()
    }
    return found | {
        "inside 50, 80, 95 %": [mean(values, claimed) for values in inside.values()],
        **{
            f"inside {level:.0%} by time".replace("%", " %"): [values[moment[q]] for q in TENTHS]
            for level, values in inside.items()
        },
        "ranked score, px": [mean(scores, claimed)],
        "time left, s": [mean([abs(rest - 0.07) if p else abs(rest - (span - now + t[0])) for rest, now, p
                               in zip(left, t, claimed, strict=True)])],
        "time left of the clock, s": [mean([abs(rest - max(span - (now - t[0]), 0.0)) for rest, now
                                            in zip(left, t, strict=True)])],
        "arrival inside 50, 80, 95 %": [mean(values, claimed) for values in arrives.values()],
        **{
            f"arrival inside {level:.0%} by time".replace("%", " %"): [values[moment[q]] for q in TENTHS]
            for level, values in arrives.items()
        },
    }  # fmt: skip


class Ahead(Scripted):
    """The page's predictor, asked as every predictor is."""

    def answers(self, motions: MotionColumns, begin: BoolArray) -> FloatArray:
        table = np.full((len(motions), 10), np.nan)
        for i in np.flatnonzero(~begin).tolist():
            now, before = motions.table[i, 1:3], motions.table[i - 1, 1:3]
            table[i, 1:3] = now + 2.0 * (now - before)
            table[i, 3:7] = 400.0, 0.0, 400.0, 0.07
            table[i, 9] = 0.4
        return table


def scored() -> SetScore:
    t, x, y, buttons = zip(*movement(), strict=True)
    events = EventColumns.of(t, x, y, buttons=buttons)
    one = Recording.of("page", [events], [Trial("ann", "1", *TARGET)])
    return score([one], [pipeline_with("ahead", Ahead())])[0]


def ours(summary: SetSummary, name: str) -> dict[str, list[Any]]:
    """The same rows from the document of ``pointpred score``."""
    one = next(p for p in summary.predictors if p.name == name)
    assert one.hits is not None
    found: dict[str, list[Any]] = {
        "time-averaged error, px": [one.time_averaged.px],
        "error by time, px": [one.by_time[q].px for q in Q_TIME],
        "error by path, px": [one.by_path[q].px for q in Q_PATH],
        "single axis, px": [one.single_axis[q].px for q in Q_AXIS],
        "coverage": [one.coverage],
        "hit": [one.hits.by_time[q].share for q in Q_TIME],
    }
    if one.calibration is None or one.time_left is None:
        return found
    regions, left = one.calibration, one.time_left
    assert regions.by_time is not None
    assert left.by_time is not None
    assert left.inside is not None
    for words, inside, by_time in (
        ("inside", regions.inside, regions.by_time),
        ("arrival inside", left.inside, left.by_time),
    ):
        found[f"{words} 50, 80, 95 %"] = list(inside.values())
        for level in LEVELS:
            named = f"{words} {level:.0%} by time".replace("%", " %")
            found[named] = [by_time[q].inside[level] for q in TENTHS]
    return found | {
        "ranked score, px": [regions.ranked_score_px],
        "time left, s": [left.s],
        "time left of the clock, s": [left.clock_s],
    }


def printed() -> dict[str, dict[str, list[float]]]:
    """The page's table by predictor and row."""
    rows = PAGE.partition("| golden |")[2].partition("\n\n")[0].splitlines()[2:]
    table: dict[str, dict[str, list[float]]] = {"hold": {}, "ahead": {}}
    for name, *values in map(cells, rows):
        for predictor, text in zip(table, values, strict=True):
            if text != "-":
                table[predictor][name] = [float(number) for number in text.split()]
    return table


def test_the_page_is_what_its_definitions_give_and_what_is_scored() -> None:
    summary, table = summarise(scored()), printed()
    for name, answers in (("hold", hold), ("ahead", ahead)):
        plain, own = protocol(movement(), answers), ours(summary, name)
        assert table[name].keys() == plain.keys() == own.keys()
        for row, numbers in plain.items():
            assert own[row] == pytest.approx(numbers, rel=1e-12, abs=1e-12), row
            assert table[name][row] == pytest.approx(numbers, abs=5.01e-5), row
    best = summary.predictors[1].time_averaged
    (a,), (b,) = (table[name]["time-averaged error, px"] for name in ("ahead", "hold"))
    assert (best.of_hold, best.interval) == (pytest.approx(a / b, abs=1e-6), None)
    (trial,) = scored().trials
    assert (trial.distance_px, trial.arrival_s, trial.clean) == (
        pytest.approx(222.266, abs=5e-4), pytest.approx(0.14), True,
    )  # fmt: skip


def test_the_interval_is_what_numpy_draws() -> None:
    sums = re.findall(r"^Example: sums (.*) of a predictor and (.*) of `hold`", PAGE, re.MULTILINE)[0]
    above, below = (np.array([float(number) for number in text.split(", ")]) for text in sums)
    drawn = np.random.default_rng(0).integers(0, 8, (2000, 8))
    bounds = np.quantile(above[drawn].sum(axis=1) / below[drawn].sum(axis=1), [0.025, 0.975])
    own = ratio_intervals(above[:, None], below[:, None], list("abcdefgh"))
    assert [own.low[0], own.high[0]] == pytest.approx(bounds.tolist(), rel=1e-12)
    share, low, high = re.findall(r"`hold`: ([\d.]+) in all, interval ([\d.]+) to ([\d.]+)\.", PAGE)[0]
    assert float(share) == pytest.approx(above.sum() / below.sum(), abs=5e-7)
    assert [float(low), float(high)] == pytest.approx(bounds.tolist(), abs=5e-7)


def test_the_coefficients_did_not_see_the_set() -> None:
    for entry in benchmark_sets():
        file = ROOT / "pointpred/datasets/set_left_out" / f"{entry.name}.npz"
        assert entry.name not in coefficient_file.sets(file)
        assert len(coefficient_file.sets(file)) == 6
        assert f"`{coefficient_file.digest(file)}` {entry.name}" in PAGE


@pytest.mark.recordings
@pytest.mark.parametrize("name", ["gofitts_demo", "kh2017"])
def test_the_sets_have_the_numbers_of_the_page(recordings: Path, name: str) -> None:
    """Of the two whose converted files hold the same samples as the originals."""
    summary = summarise(score([read(recordings / f"{name}_samples.parquet")], ["linear"])[0], draws=2)
    for one in summary.predictors:
        (line,) = re.findall(rf"^\| `{name}` \| `{one.name}` \|(.*)$", PAGE, re.MULTILINE)
        errors = [measure[0.5].px for measure in (one.by_time, one.by_path, one.single_axis)]
        numbers = [one.time_averaged.px, *errors, one.coverage]
        assert [float(cell) for cell in cells(line)] == pytest.approx(numbers, abs=6e-10)
