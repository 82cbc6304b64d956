"""Any table: written under any names and marks it is read back by its mapping, and no row is lost unseen."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from pointpred.recording import Recording
from pointpred.recordings import read_any
from pointpred.recordings.columns.clocks import PER_SECOND

FEW = settings(max_examples=60, deadline=None)
NAMES = (
    st.text("abcdefghklmnopqruvwz \u00e9_", min_size=3, max_size=9)
    .map(str.strip)
    .filter(lambda n: len(n) > 2)
)
EIGHTHS = st.integers(-80_000, 80_000).map(lambda n: n / 8)


@st.composite
def movements(draw: st.DrawFn) -> dict[tuple[str, str], list[tuple[int, float, float]]]:
    """Trials by user and name: rows of ticks, x and y."""
    begin = draw(st.sampled_from([0, 10**6, 17 * 10**17]))
    keys = draw(st.lists(st.tuples(st.sampled_from("ab"), st.sampled_from("123")), min_size=1, unique=True))
    found = {}
    for key in keys:
        steps = draw(st.lists(st.integers(0, 900), min_size=2, max_size=6))
        places = draw(st.lists(st.tuples(EIGHTHS, EIGHTHS), min_size=len(steps), max_size=len(steps)))
        places[-1] = (places[0][0] + 1, places[0][1])  # it moves
        ticks = begin + draw(st.integers(0, 10**7)) + np.cumsum(steps)
        found[key] = [(int(t), x, y) for t, (x, y) in zip(ticks, places, strict=True)]
    return found


@FEW
@given(
    movements(),
    st.lists(NAMES, min_size=5, max_size=5, unique_by=lambda name: re.sub(r"[\W_]", "", name)),
    st.permutations(range(5)),
    st.sampled_from([",", ";", "\t", "|"]),
    st.sampled_from([".", ","]),
    st.sampled_from(["s", "ms", "us", "ns"]),
    st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "cp1252"]),
    st.sampled_from(["\n", "\r\n", "\r"]),
    st.booleans(),
    st.booleans(),
)
def test_a_table_is_read_back_by_its_mapping(
    tmp_path_factory: pytest.TempPathFactory,
    trials: dict[tuple[str, str], list[tuple[int, float, float]]],
    names: list[str],
    order: list[int],
    separator: str,
    mark: str,
    unit: str,
    encoding: str,
    end: str,
    header: bool,
    y_up: bool,
) -> None:
    mark = "." if separator == "," else mark
    text = io.StringIO()
    writer = csv.writer(text, delimiter=separator, lineterminator=end)
    rows: list[list[Any]] = [
        [t, str(x).replace(".", mark), str(y).replace(".", mark), *key]
        for key, samples in trials.items()
        for t, x, y in samples
    ]
    if header:
        writer.writerow([names[place] for place in order])
    writer.writerows([[row[place] for place in order] for row in rows])
    # Where three digits follow every comma, the column may hold thousands, and is refused.
    for place in (1, 2):
        decimals = [str(row[place]).partition(",")[2] for row in rows if "," in str(row[place])]
        assume(not decimals or any(len(digits) != 3 for digits in decimals))
    path = tmp_path_factory.mktemp("table") / "table.txt"
    path.write_bytes(text.getvalue().encode(encoding))
    fields = ("t", "x", "y", "user", "trial")
    columns = {field: names[i] if header else order.index(i) for i, field in enumerate(fields)}
    (found,) = read_any(path, columns=columns, time_unit=unit, y_up=y_up)  # type: ignore[arg-type]
    assert found.skipped == ()
    assert [(trial.user, trial.trial) for trial in found.trials] == list(trials)
    for at, samples in enumerate(trials.values()):
        expected = [[(t - samples[0][0]) / PER_SECOND[unit], x, (-y if y_up else y)] for t, x, y in samples]
        assert found.rows(at).table[:, :3].tolist() == expected


CELLS = st.one_of(st.integers(-99, 99).map(str), st.sampled_from(["", "NA", "x", "1e3", "inf", "--"]))


@FEW
@given(
    st.lists(
        st.tuples(st.sampled_from(["u", "v", ""]), st.sampled_from(["1", "2", ""]), CELLS, CELLS), min_size=12
    )
)
def test_each_row_of_a_trial_is_read_or_skipped_or_counted(
    tmp_path_factory: pytest.TempPathFactory, cells: list[tuple[str, str, str, str]]
) -> None:
    good = [("w", "9", str(i), str(2 * i)) for i in range(2 * len(cells))]
    rows = [*cells, *good]
    path = tmp_path_factory.mktemp("table") / "rows.csv"
    lines = [f"{user},{trial},{0.01 * i:.2f},{x},{y}" for i, (user, trial, x, y) in enumerate(rows)]
    path.write_text("\n".join(["user,trial,t_s,x,y", *lines, ""]))
    (found,) = read_any(path)
    sizes: dict[tuple[str, str], int] = {}
    for user, trial, _, _ in rows:
        sizes[user, trial] = sizes.get((user, trial), 0) + 1
    nameless = sum(size for key, size in sizes.items() if not all(key))
    read = {(trial.user, trial.trial): len(found.rows(at)) for at, trial in enumerate(found.trials)}
    skipped = {(skip.user, skip.trial) for skip in found.skipped}
    assert set(read) | skipped == {key for key in sizes if all(key)}
    assert not set(read) & skipped
    assert all(sizes[key] == size for key, size in read.items())
    assert _counted(found, "rows without user or trial left out") == nameless


@FEW
@given(st.lists(st.tuples(st.integers(0, 3000), CELLS), min_size=3, max_size=40))
def test_each_row_of_a_stream_is_read_or_skipped_or_counted(
    tmp_path_factory: pytest.TempPathFactory, cells: list[tuple[int, str]]
) -> None:
    good = [(8, str(i)) for i in range(2 * len(cells))]
    rows = [*cells, *good]
    clock = np.cumsum([step for step, _ in rows])
    path = tmp_path_factory.mktemp("table") / "rows.csv"
    path.write_text(
        "\n".join(["t_ms,x,y", *(f"{t},{x},5" for t, (_, x) in zip(clock, rows, strict=True)), ""])
    )
    (found,) = read_any(path)
    numbers = pd.to_numeric(pd.Series([x for _, x in rows]), errors="coerce").to_numpy()
    usable = np.isfinite(numbers)
    left = _counted(found, "rows left out")
    assert left == np.count_nonzero(~usable)
    skipped = 0
    for skip in found.skipped:
        if bounds := re.fullmatch(r"rows (\d+) to (\d+)", skip.trial):
            first, last = map(int, bounds.groups())
            skipped += np.count_nonzero(usable[first : last + 1])
    still = [skip for skip in found.skipped if not skip.trial.startswith("rows")]
    assert all(skip.reason.startswith("no movement") for skip in still)
    assert len(found.events) + skipped + left <= len(rows)
    if not still:
        assert len(found.events) + skipped + left == len(rows)


def test_a_table_is_what_pandas_reads(tmp_path: Path) -> None:
    random = np.random.default_rng(13)
    count = 3000
    frame = pd.DataFrame(
        {
            "participant": np.repeat(["p1", "p2", "p3"], count // 3),
            "trial_number": np.arange(count) // 100,
            "timestamp": 1_700_000_000_000 + np.cumsum(random.integers(1, 20, count)),
            "mouseX": random.normal(500, 90, count),
            "mouseY": random.normal(400, 90, count),
            "block": np.where(np.arange(count) % 200 < 100, "first", "second"),
        }
    )
    frame.to_csv(tmp_path / "study.csv", index=False)
    (found,) = read_any(tmp_path / "study.csv")
    read = pd.read_csv(tmp_path / "study.csv")
    for at, (key, trial) in enumerate(read.groupby(["participant", "trial_number"])):
        known, rows = found.trials[at], found.rows(at)
        assert (known.user, known.trial) == (key[0], str(key[1]))
        assert known.condition == {"block": trial["block"].iloc[0]}
        assert rows.t.tolist() == ((trial["timestamp"] - trial["timestamp"].iloc[0]) / 1000).tolist()
        assert np.allclose(rows.table[:, 1:3], trial[["mouseX", "mouseY"]], rtol=0, atol=1e-9)
    assert at == len(found.trials) - 1


def _counted(found: Recording, words: str) -> int:
    """The number of rows in the note that begins with ``words``; 0 without it."""
    numbers = [re.match(rf"{words}: (\d+)", note) for note in found.notes]
    return sum(int(number[1]) for number in numbers if number)
