"""Measures of movements against printed figures, and against second ways of computing them."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, log, log2
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import statsmodels.api as sm
from scipy.ndimage import gaussian_filter1d
from scipy.signal import find_peaks

from pointpred.datasets import sample
from pointpred.errors import ParameterError
from pointpred.measures import (
    COLUMNS,
    accuracy,
    conditions,
    deviations,
    fitts_line,
    flips,
    line,
    means,
    measure,
    meyer_submovements,
    movements,
    persistent_submovements,
    reversals,
    sample_entropy,
    throughput,
    time_normalised,
    velocities,
)
from pointpred.measures.paths import area_under_curve, maximum_deviation
from pointpred.measures.speeds import ACCELERATION_NOISE_PX_S2, SHARE, SPEED_NOISE_PX_S
from pointpred.recording import Recording, Trial
from pointpred.recordings import read, write
from pointpred.records import EventColumns
from tests.architecture.tree import ROOT
from tests.building import reach
from tests.page import node

EXACT = {"rel": 1e-9, "abs": 1e-9}
DATA = ROOT / "tests" / "data" / "measures"


@pytest.fixture(scope="module")
def circle() -> Recording:
    return sample()


@pytest.fixture(scope="module")
def table(circle: Recording) -> pd.DataFrame:
    return measure(circle).to_pandas()


def wandering(seed: int, count: int = 300) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A path that turns often, in whole px, at uneven times."""
    random = np.random.default_rng(seed)
    t = np.cumsum(random.uniform(0.004, 0.012, count))
    x, y = (np.round(np.cumsum(gaussian_filter1d(random.normal(0.4, 9.0, count), 4.0))) for _ in range(2))
    return t, x, y


# What MacKenzie's AccuracyMeasures and Throughput print (https://www.yorku.ca/mack/FittsLawSoftware)


def test_accuracy_measures_as_mackenzie_prints_them() -> None:
    x, y = np.loadtxt(DATA / "accuracy_demo.csv", delimiter=",", skiprows=1).T
    found = accuracy(x, y, (856.5, 501.0), (515.0, 159.5), 60.0)
    assert found[:4] == (1, 4, 4, 5)
    rounded = accuracy(np.trunc(x - 856.5), np.trunc(y - 501.0), (0.0, 0.0), (-341.5, -341.5), 60.0)
    # There an offset is positive below the axis, whose right side is above where movements go to the left.
    assert rounded[4:] == pytest.approx((24.530310, 26.836838, -20.525079), abs=5e-7)
    assert found[4:] == pytest.approx(rounded[4:], abs=0.4)


SELECTED = [
    218,
    529,
    195,
    533,
    209,
    607,
    231,
    540,
    231,
    560,
    207,
    524,
    239,
    515,
    180,
    501,
    215,
    571,
    215,
    521,
]
TIMES = [262, 268, 248, 233, 251, 252, 283, 214, 301, 266, 258, 258, 248, 242, 241, 252, 243, 255, 252, 210]


def test_throughput_as_mackenzie_prints_it() -> None:
    targets, parts, trials = (540.0, 227.0), [], []
    for k, (before, end, took) in enumerate(zip([540, *SELECTED], SELECTED, TIMES, strict=False)):
        parts.append(
            EventColumns.of([0.0, took / 2e3, took / 1e3], [before, (before + end) / 2, end], [592] * 3)
        )
        source, to = targets[k % 2], targets[(k + 1) % 2]
        condition: dict[str, str | float] = {"from_x": source, "from_y": 592.0}
        trials.append(Trial("P07", str(k), to, 592.0, 130.0, condition=condition))
    (row,) = throughput(measure(Recording.of("example", parts, trials))).to_pylist()
    assert (row["trials"], row["error_rate"]) == (20, 0.05)
    assert row["effective_distance_px"] == pytest.approx(327.05, abs=1e-9)
    assert row["response_time_s"] == pytest.approx(0.25185, abs=1e-9)
    # It has the root of 2 pi e, 4.13273, where the standard prints 4.133.
    assert row["effective_width_px"] == pytest.approx(105.692130 * 4.133 / 4.132731354, rel=1e-7)
    assert row["throughput_bits_s"] == pytest.approx(8.074805, rel=1e-4)


def test_the_line_of_fitts_1954() -> None:
    distance, width = np.repeat([2.0, 4.0, 8.0, 16.0], 4), np.tile([0.25, 0.5, 1.0, 2.0], 4)
    ms = [392, 281, 212, 180, 484, 372, 260, 203, 580, 469, 357, 279, 731, 595, 481, 388]
    found = line(np.log2(2.0 * distance / width), np.array(ms, dtype=float))
    assert found is not None
    assert (round(found.intercept, 1), round(found.slope, 1), round(found.r2**0.5, 4)) == (12.8, 94.7, 0.9831)
    assert line(np.array([1.0, 2.0]), np.array([1.0, 2.0])) is line(np.ones(5), np.arange(5.0)) is None


# mousetrap and pracma, written after their descriptions


@pytest.mark.parametrize("seed", range(6))
def test_paths_as_mousetrap_measures_them(seed: int) -> None:
    _, x, y = wandering(seed)
    up = -y
    foot = np.array([x[0], up[0]])
    way = np.array([x[-1], up[-1]]) - foot
    share = (np.column_stack([x, up]) - foot) @ way / (way @ way)
    ideal = foot + share[:, None] * way
    distance = np.hypot(*(np.column_stack([x, up]) - ideal).T) * np.where(ideal[:, 1] > up, -1.0, 1.0)
    distance *= -1.0 if up[0] > up[-1] else 1.0
    along, deviation = deviations(x, y)
    assert deviation == pytest.approx(distance, **EXACT)
    assert abs(maximum_deviation(deviation)) == pytest.approx(np.abs(distance).max(), **EXACT)
    closed = [*zip(share * hypot(*way), distance, strict=True)]
    area = sum(b[0] * a[1] - a[0] * b[1] for a, b in pairwise([*closed, closed[0]])) / 2.0
    assert area_under_curve(along, deviation) == pytest.approx(area, **EXACT)
    moves = [b - a for a, b in pairwise(x.tolist()) if a != b]
    assert flips(x) == sum(a * b < 0 for a, b in pairwise(moves))


def pracma(series: list[float], r: float) -> float:
    """``sample_entropy`` with edim 2."""
    n, counts = len(series), []
    for m in (2, 3):
        count = 0
        for i in range(n - m - 1):
            for j in range(i + 1, n - 2):
                count += max(abs(series[i + k] - series[j + k]) for k in range(m)) < r
        counts.append(count)
    return log(counts[0] / counts[1])


def test_sample_entropy_as_mousetrap_computes_it(circle: Recording, table: pd.DataFrame) -> None:
    found, _ = movements(circle)
    steps = [np.diff(np.interp(np.linspace(m.t[0], m.t[-1], 101), m.t, m.x)) for m in found]
    r = 0.2 * np.concatenate(steps).std(ddof=1)
    for k in range(0, 240, 24):
        assert table["sample_entropy"][k] == pytest.approx(pracma(steps[k][::3].tolist(), r), **EXACT)
    assert np.isnan(sample_entropy(np.zeros(5), 0.1))
    assert sample_entropy(np.array([0.0, 0, 0, 9, 9, 9, 0, 0, 0, 9, 9, 9, 5, 5, 5, 1, 1, 1]), 0.1) == np.inf


def test_a_path_is_normalised_in_time() -> None:
    t, x, y = wandering(3)
    path = time_normalised(t, x, y)
    frame = pd.DataFrame({"x": x, "y": y}, index=t).reindex(sorted({*t, *path[:, 0]})).interpolate("index")
    assert path.shape == (101, 3)
    assert path[:, 1:] == pytest.approx(frame.loc[path[:, 0]].to_numpy(), **EXACT)


# Speeds and sub-movements


@pytest.mark.parametrize("seed", range(6))
def test_speeds_and_submovements_found_by_scipy(seed: int) -> None:
    t, x, y = wandering(seed)
    found = velocities(t, x, y)
    times = t[0] + 0.01 * np.arange(-60, len(found.t) + 60)
    smooth = [gaussian_filter1d(np.interp(times, t, axis), 2.0, truncate=4.0) for axis in (x, y)]
    vx, vy = (np.gradient(axis, 0.01) for axis in smooth)
    inner = slice(60, -60)
    assert found.speed == pytest.approx(np.hypot(vx, vy)[inner], rel=1e-9, abs=1e-7)
    acceleration = np.gradient(vx, 0.01)[inner]
    assert found.ax == pytest.approx(acceleration, rel=1e-9, abs=1e-6)
    least = max(SHARE * found.speed.max(), SPEED_NOISE_PX_S)
    peaks, _ = find_peaks([0.0, *found.speed, 0.0], prominence=least)
    assert persistent_submovements(found.speed) == len(peaks) > 2

    count, largest = 0, max(SHARE * np.abs(acceleration).max(), ACCELERATION_NOISE_PX_S2)
    signs = np.sign(found.vx)
    for piece in np.split(np.arange(len(signs)), np.flatnonzero(np.diff(signs)) + 1):
        if np.abs(found.vx[piece]).max() > max(SHARE * np.abs(found.vx).max(), SPEED_NOISE_PX_S):
            push = signs[piece[0]] * acceleration[piece]
            eased, _ = find_peaks(push, prominence=largest)
            count += 1 + sum(bool((push[:k] < 0.0).any()) for k in eased)
    assert meyer_submovements(found.vx, found.ax) == count > 2


@pytest.mark.parametrize(
    ("ends", "pause_s", "count"),
    [([400.0], 0.0, 1), ([350.0, 400.0], 0.1, 2), ([350.0, 400.0], 0.8, 2), ([430.0, 400.0], 0.0, 2)],
)
def test_submovements_that_are_known(ends: list[float], pause_s: float, count: int) -> None:
    """One reach; one that stops short and is corrected; one that goes too far and returns."""
    parts = [reach((a, 0.0), (b, 0.0), rest_s=0.01 + pause_s) for a, b in pairwise([0.0, *ends])]
    x = np.concatenate([part.x for part in parts])
    t = 0.01 * np.arange(len(x))
    found = velocities(t, x, np.zeros(len(x)))
    assert persistent_submovements(found.speed) == meyer_submovements(*found.along(1.0, 0.0)) == count
    peak = 1.875 * max(ends) / 0.6  # of a movement of least jerk, in its middle
    if count == 1:
        assert found.speed.max() == pytest.approx(peak, rel=0.01)
        assert found.t[found.speed.argmax()] == pytest.approx(0.3)
        assert found.acceleration.max() == pytest.approx(5.7735 * 400.0 / 0.36, rel=0.05)


def test_an_easing_of_the_braking_is_a_submovement_of_meyers_only() -> None:
    """Two reaches that overlap: the speed has one peak and a shoulder."""
    first, second = reach((0.0, 0.0), (400.0, 0.0), rest_s=0.4), reach((0.0, 0.0), (150.0, 0.0), rest_s=0.4)
    x = first.x + np.concatenate([np.zeros(30), second.x[:-30]])
    found = velocities(0.01 * np.arange(len(x)), x, np.zeros(len(x)))
    assert persistent_submovements(found.speed) == 1
    assert meyer_submovements(*found.along(1.0, 0.0)) == 2


@pytest.mark.parametrize("least", [0.0, 5.0, 20.0])
def test_reversals_are_what_persistence_leaves(least: float) -> None:
    values = np.array([-1e6, *wandering(1)[1], -1e6])
    peaks, _ = find_peaks(values, prominence=least + 0.5)  # values are whole
    turns = reversals(values, least)
    assert values[turns[::2]].tolist() == values[peaks].tolist()
    assert len(turns) == 2 * len(peaks) - 1 > 1


# Throughput and the line, by pandas and statsmodels


def by_pandas(circle: Recording, table: pd.DataFrame) -> pd.DataFrame:
    """Throughput from the recording itself: MacKenzie's triangles instead of projections."""
    rows = []
    for k, trial in enumerate(circle.trials):
        events = circle.rows(k)
        pressed = np.flatnonzero(np.diff(events.buttons % 2, prepend=events.buttons[0] % 2) == 1)
        end, at = pressed[-1], (trial.target_x, trial.target_y)
        start, select = (events.x[0], events.y[0]), (events.x[end], events.y[end])
        a, b, c = (hypot(p[0] - q[0], p[1] - q[1]) for p, q in ((start, at), (select, at), (start, select)))
        dx = (c * c - b * b - a * a) / (2.0 * a)
        rows.append((events.t[end] - events.t[0], a, a + dx, dx, b * b - dx * dx, b > trial.target_w / 2.0))
    names = ["mt", "a", "ae", "dx", "dy2", "missed"]
    frame = pd.DataFrame(rows, columns=names).join(table[["user", *BY]])
    cross = np.sqrt(frame["dy2"].clip(lower=0.0)) * np.sign(table["end_across_px"])
    return frame.assign(w=[t.target_w for t in circle.trials], c=table["amplitude_px"], dy=cross)


BY = ["distance_mm", "transfer", "width_mm"]


def test_throughput_and_the_line_as_pandas_and_statsmodels_compute_them(
    circle: Recording, table: pd.DataFrame
) -> None:
    assert conditions(table) == BY
    frame = by_pandas(circle, table)
    grouped = frame.groupby(["user", *BY])
    mean, sd = grouped.mean(), grouped.std(ddof=1)
    we, we_2d = 4.133 * sd["dx"], 4.133 * np.sqrt(sd["dx"] ** 2 + sd["dy"] ** 2)
    wanted = pd.DataFrame(
        {
            "error_rate": mean["missed"],
            "response_time_s": mean["mt"],
            "throughput_bits_s": np.log2(mean["ae"] / we + 1.0) / mean["mt"],
            "iso_throughput_bits_s": np.log2(mean["a"] / we + 1.0) / mean["mt"],
            "throughput_2d_bits_s": np.log2(mean["c"] / we_2d + 1.0) / mean["mt"],
            "id_bits": grouped.apply(lambda one: np.log2(one["a"] / one["w"] + 1.0).mean()),
        }
    )
    groups = throughput(table)
    found = groups.to_pandas().set_index(["user", *BY]).loc[wanted.index, wanted.columns]
    assert np.abs(found - wanted).to_numpy().max() < 1e-9

    overall = means(means(groups, ["dataset", "user"]), ["dataset"]).to_pylist()[0]
    people = wanted["throughput_bits_s"].groupby("user").mean()
    assert overall["throughput_bits_s"] == pytest.approx(people.mean(), **EXACT)
    points = wanted.groupby(BY).mean()
    fit = sm.OLS(points["response_time_s"], sm.add_constant(points["id_bits"])).fit()
    drawn = fitts_line(groups)
    assert drawn is not None
    assert (drawn.intercept, drawn.slope, drawn.r2) == pytest.approx((*fit.params, fit.rsquared), **EXACT)


@node.needed
def test_throughput_as_the_circle_view_shows_it(circle: Recording, tmp_path: Path) -> None:
    """The files that the page saves, read and measured, against what the page computed of its trials."""
    shown: list[dict[str, Any]] = []
    parts, trials = [], []
    for k in range(36):
        events, target = circle.rows(k), (circle.trials[k].target_x, circle.trials[k].target_y)
        source = (circle.trials[k - 1].target_x, circle.trials[k - 1].target_y) if k else (960.0, 254.0)
        end = int(np.flatnonzero(np.diff(events.buttons % 2) == 1)[-1]) + 1
        rows, block, width = events.table[: end + 1], 1 + k // 12, 10.0
        hit = hypot(rows[-1, 1] - target[0], rows[-1, 2] - target[1]) <= width / 2.0
        start, last = rows[0, :3].tolist(), rows[-1, :3].tolist()
        sides = {"from": source, "target": target, "start": start, "end": last}
        shown.append({"sequence": {"block": block}, **sides, "hit": bool(hit)})
        parts.append(EventColumns.of(*rows[40:, :3].T))  # no sample where the cursor rests
        places = dict(
            zip(("from_x", "from_y", "started_s", "start_x", "start_y"), (*source, *start), strict=True)
        )
        about: dict[str, str | float] = {**places, "block": float(block), "hit": float(hit)}
        trials.append(Trial("page", f"block-{block}-{k}", *target, width, condition=about))
    file = write(Recording.of("circle", parts, trials), tmp_path / "circle_samples.csv")[0]
    run = node.run("circle.mjs", shown)
    groups = throughput(measure(read(file)), ["block"])
    named = {
        "movementTime": "response_time_s",
        "effectiveWidth": "effective_width_px",
        "effectiveDistance": "effective_distance_px",
        "throughput": "throughput_bits_s",
        "errorRate": "error_rate",
    }
    for row, block in zip(groups.to_pylist(), run["blocks"], strict=True):
        assert [row[ours] for ours in named.values()] == pytest.approx([block[n] for n in named], **EXACT)
    mean = means(groups, ["user"]).to_pylist()[0]["throughput_bits_s"]
    assert mean == pytest.approx(run["throughput"], **EXACT)


# The table


def test_the_table_agrees_with_pandas_where_pandas_can_tell(circle: Recording, table: pd.DataFrame) -> None:
    assert [name for name in table.columns if name in COLUMNS] == list(COLUMNS)
    samples = pd.concat(
        pd.DataFrame({"k": k, "t": m.t, "x": m.x, "y": m.y}) for k, m in enumerate(movements(circle)[0])
    )
    path = samples.groupby("k").apply(lambda one: np.hypot(one["x"].diff(), one["y"].diff()).sum())
    assert table["path_px"].to_numpy() == pytest.approx(path.to_numpy(), **EXACT)
    took = samples.groupby("k")["t"].agg(lambda t: t.iloc[-1] - t.iloc[0])
    assert table["movement_time_s"].to_numpy() == pytest.approx(took.to_numpy(), **EXACT)
    whole = table["initiation_time_s"] + table["movement_time_s"]
    assert table["response_time_s"].to_numpy() == pytest.approx(whole.to_numpy(), **EXACT)
    assert (table["dwell_time_s"] < table["movement_time_s"]).all()
    for peak in ("peak_speed", "peak_acceleration"):
        share = table[f"{peak}_time_s"] / table["movement_time_s"]
        assert table[f"{peak}_share"].to_numpy() == pytest.approx(share.to_numpy(), **EXACT)
    ids = [log2(a / w + 1.0) for a, w in zip(table["target_distance_px"], table["target_w"], strict=True)]
    assert table["id_bits"].to_list() == pytest.approx(ids, **EXACT)


def test_conditions_are_what_an_experiment_varies() -> None:
    columns: dict[str, list[Any]] = {
        "user": ["ann"] * 8 + ["bob"] * 8,
        "width": [1.0, 2.0] * 8,
        "order": ["a", "a", "b", "b"] * 4,
        "group": ["x"] * 8 + ["y"] * 8,  # of people
        "stimulus": [f"s{k % 8}" for k in range(16)],  # of single trials
        "score": list(range(16)),
        "hit": [0.0, 1.0] * 8,
        "from_x": [0.0, 1.0] * 8,
        "movement": [0.0, 1.0] * 8,  # these and the next as a study names them
        "sequence": [0.0, 1.0] * 8,
        "attempt": [0.0, 1.0] * 8,
        "clicks": [0.0, 1.0] * 8,
        "lost_samples": [0.0, 1.0] * 8,
        "phase": [None, "main"] * 8,
    }
    assert conditions(pd.DataFrame(columns)) == ["width", "order"]


def test_what_is_not_known_is_empty_and_names_stay_apart() -> None:
    parts = [reach((0.0, 0.0), (300.0, 40.0)), reach((0.0, 0.0), (9.0, 300.0))]
    about: list[dict[str, str | float]] = [
        {"path_px": 1.0, "kind": 2.0},
        {"path_px": 2.0, "kind": "b", "hit": "No"},
    ]
    trials = [Trial("ann", str(k), condition=one) for k, one in enumerate(about)]
    found = measure([Recording.of("one", parts, trials)])
    assert found["path_px_column"].to_pylist() == [1.0, 2.0]
    assert found["kind"].to_pylist() == ["2", "b"]
    assert found["error"].to_pylist() == [None, True]
    assert found["tre"].null_count == found["id_bits"].null_count == 2
    assert throughput(found).num_rows == 0
    assert fitts_line(throughput(found)) is None
    with pytest.raises(ParameterError, match="no column 'width'; the conditions are: path_px_column, kind"):
        throughput(found, ["width"])
