"""JSON and JSON lines: the same samples in every arrangement that programs write."""

from __future__ import annotations

import contextlib
import gc
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.errors import RecordingError
from pointpred.recordings import (
    Reading,
    format_of,
    read_any,
    table_choice,
)
from pointpred.recordings.columns.list_cells import is_list, split
from pointpred.recordings.columns.names import guess
from pointpred.recordings.formats import json_records as records_json
from tests.unit.writing_containers import NAMES, ROWS, TRIALS, nested

SAMPLES = [{"t": 8.0 * at, "x": 2.0 * at, "y": float(at % 3)} for at in range(20)]
ARRAYS = [list(sample.values()) for sample in SAMPLES]
COLUMNS = {name: [sample[name] for sample in SAMPLES] for name in ("t", "x", "y")}
LISTS = {f"samples.{name}": [cells, cells[:5]] for name, cells in COLUMNS.items()}
FRAME = pd.DataFrame(SAMPLES)


def columns_of(path: Path, document: Any, **columns: str) -> dict[str, Any]:
    path.write_text(document if isinstance(document, str) else json.dumps(document), encoding="utf-8")
    form = format_of(path)
    assert form is not None
    assert form.key == "json"
    return records_json.read(path, Reading(columns=dict(columns) or None)).columns


@pytest.mark.parametrize(
    ("document", "expected"),
    [
        (SAMPLES, COLUMNS),
        ([list("txy"), *ARRAYS], COLUMNS),
        (ARRAYS, {str(at): cells for at, cells in enumerate(COLUMNS.values())}),
        (list(COLUMNS.values()), {str(at): cells for at, cells in enumerate(COLUMNS.values())}),
        (COLUMNS, COLUMNS),
        ({"user": "p", "log": COLUMNS | {"rate": 9}}, COLUMNS | {"rate": [9] * 20, "user": ["p"] * 20}),
        (FRAME.to_json(), COLUMNS),
        (FRAME.to_json(orient="split"), COLUMNS),
        (FRAME.to_json(orient="table", index=False), COLUMNS),
        (FRAME.to_json(orient="index"), COLUMNS | {"trial": [str(at) for at in range(20)]}),
        (FRAME.to_json(orient="records", lines=True), COLUMNS),
        ({"meta": {"w": 1}, "data": {"mouse": SAMPLES, "keys": [{"t": 1, "key": "a", "code": 2}]}}, COLUMNS),
        (
            [{"t": at, "pos": {"x": 1, "y": [at]}, "goal": [3, 4]} for at in range(3)],
            {
                "t": [0, 1, 2],
                "pos.x": [1] * 3,
                "pos.y": [[0], [1], [2]],
                "goal.0": [3] * 3,
                "goal.1": [4] * 3,
            },
        ),
        (
            {"trials": [{"n": 1, "samples": SAMPLES}, {"n": 2, "samples": SAMPLES[:5]}]},
            {"n": [1, 2], **LISTS},
        ),
        (
            [{"samples": ARRAYS}, {"samples": ARRAYS[:5]}],
            {f"samples.{at}": cells for at, cells in enumerate(LISTS.values())},
        ),
        ([COLUMNS, COLUMNS], {name: [cells, cells] for name, cells in COLUMNS.items()}),
        (
            [SAMPLES, SAMPLES[:5]],
            {name: cells + cells[:5] for name, cells in COLUMNS.items()} | {"trial": [0] * 20 + [1] * 5},
        ),
        (
            {"-Kx1": {"who": "a", "samples": SAMPLES}, "-Kx2": {"who": "b", "samples": SAMPLES[:5]}},
            {"who": ["a", "b"], **LISTS, "trial": ["-Kx1", "-Kx2"]},
        ),
        ('[{"t": 1, "x": NaN, "id": 12345678901234567890}]', {"t": [1], "id": ["12345678901234567890"]}),
    ],
)
def test_arrangements(document: Any, expected: dict[str, Any], tmp_path: Path) -> None:
    found = columns_of(tmp_path / "own.json", document)
    found = {name: cells for name, cells in found.items() if cells == cells and name != "index"}
    assert {name: cells for name, cells in found.items() if name in expected} == expected
    assert found.keys() - expected.keys() <= {"x"}  # not a number differs from itself


def test_pandas_reads_the_same_columns(tmp_path: Path) -> None:
    rows = [dict(zip(NAMES, row, strict=True)) for row in ROWS]
    text = json.dumps(rows)
    assert columns_of(tmp_path / "own.json", rows) == pd.read_json(io.StringIO(text)).to_dict("list")


def test_what_lies_beside_the_path_is_repeated(tmp_path: Path) -> None:
    path = tmp_path / "own.json"
    found = columns_of(path, nested())
    samples = [found[f"samples.{name}"] for name in NAMES[:3]]
    rows = [
        (*sample, user, trial)
        for *lists, user, trial in zip(*samples, found["user"], found["trial"], strict=True)
        for sample in zip(*lists, strict=True)
    ]
    assert rows == ROWS
    assert set(found["study"]) == {"our own"}
    (recording,) = read_any(path)
    assert [(trial.user, trial.trial) for trial in recording.trials] == [(u, str(n)) for u, n in TRIALS]
    np.testing.assert_allclose(recording.events.x, [row[1] for row in ROWS], atol=1e-12)
    assert columns_of(path, {"a.b": {"c": SAMPLES}}) == COLUMNS
    outer = columns_of(path, {"t": "12:30", "x": 0, "samples": SAMPLES})
    assert outer["t"] == COLUMNS["t"]
    assert set(outer["outer.t"]) == {"12:30"}
    assert set(outer["outer.x"]) == {0}


def test_short_tracks_are_no_points(tmp_path: Path) -> None:
    """Lists of two numbers are a point; as three fields of one length they are a track."""
    path = tmp_path / "own.json"
    tracks = [{"t": [0, 8], "x": [1, 2], "y": [3, 4]}] * 5
    assert columns_of(path, tracks) == {"t": [[0, 8]] * 5, "x": [[1, 2]] * 5, "y": [[3, 4]] * 5}


def test_a_group_of_columns_is_taken_where_it_is_the_only_one() -> None:
    names = [f"samples.{name}" for name in "txy"]
    assert guess([*names, "start.x", "start.y"]).columns == dict(zip("txy", names, strict=True))
    assert guess(["a.t", "a.x", "a.y", "b.t", "b.x", "b.y"]).columns == {}


def test_trials_in_lists_of_lists_stay_apart(tmp_path: Path) -> None:
    people = {"people": [{"id": "a", "tracks": [ARRAYS, ARRAYS]}, {"id": "b", "tracks": [ARRAYS]}]}
    found = columns_of(tmp_path / "own.json", people)
    assert [*dict.fromkeys(zip(found["id"], found["trial"], strict=True))] == [("a", 0), ("a", 1), ("b", 0)]
    deep = columns_of(tmp_path / "own.json", {"data": [[ARRAYS, ARRAYS], [ARRAYS]]})
    assert [*dict.fromkeys(deep["trial"])] == ["0.0", "0.1", "1.0"]


@pytest.mark.parametrize(
    ("document", "words"),
    [
        ({"mouse": SAMPLES, "gaze": SAMPLES}, ["mouse (20 rows: t, x, y)", "gaze", "as CSV", "--columns t="]),
        ([1, 2, 3], ["no list of records"]),
        ({"a": 1}, ["no list of records"]),
        ('{"t": 1,\n "x": 2,,}', ["no JSON"]),
        ('{"t": 1}\n{"t": 2\n{"t": 3}\n', ["line 2"]),
        ("[" * 100_000, ["nested"]),
        ('{"a":' * 200 + "1" + "}" * 200, ["nested"]),
    ],
)
def test_refusals_name_the_paths_that_hold_records(document: Any, words: list[str], tmp_path: Path) -> None:
    with pytest.raises(RecordingError) as caught:
        columns_of(tmp_path / "own.json", document)
    assert all(word in str(caught.value) for word in ["own.json", *words])


def test_of_several_lists_the_one_with_times_and_positions_is_read(tmp_path: Path) -> None:
    keys = [{"time": at, "key": "a", "code": at} for at in range(90)]
    gaze = [{"at": at, "gx": at, "gy": at, "size": 1} for at in range(25)]
    document = {"keys": keys, "mouse": SAMPLES, "gaze": gaze}
    assert columns_of(tmp_path / "own.json", document) == COLUMNS
    assert columns_of(tmp_path / "own.json", document, t="at", x="gx", y="gy")["gx"] == [*range(25)]
    assert columns_of(tmp_path / "own.json", document, user="code", x="key", y="time")["code"] == [*range(90)]
    (recording,) = read_any(tmp_path / "own.json")
    assert any(
        note == "other lists of records left aside: keys (90 rows: time, key, code); "
        "gaze (25 rows: at, gx, gy, size)"
        for note in recording.notes
    )


def test_a_cut_last_line_is_left_aside(tmp_path: Path) -> None:
    path = tmp_path / "own.jsonl"
    path.write_text(FRAME.to_json(orient="records", lines=True)[:-9], encoding="utf-8")
    table = records_json.read(path)
    assert table.columns["t"] == COLUMNS["t"][:-1]
    assert any("line 20" in note for note in table.notes)


def test_records_of_ever_new_fields_are_bounded(tmp_path: Path) -> None:
    rows = [
        {"t": 1, **{f"a{at}": 1 for at in range(20_000)}},
        *({"t": 1, "x": 1, "y": 2} for _ in range(6000)),
    ]
    with pytest.raises(RecordingError, match="cells"):
        columns_of(tmp_path / "own.json", rows)


def test_the_text_of_a_refused_file_is_not_kept(tmp_path: Path) -> None:
    """An error holds the whole text: where it is part of a cycle, a folder of such files fills the memory."""
    path = tmp_path / "cut.json"
    text = '[{"t": 1.0625, "x": 2'  # as in no other test
    path.write_text(text, encoding="utf-8")
    gc.collect()
    gc.disable()
    try:
        with contextlib.suppress(RecordingError):
            read_any(path)
        # By type: a weak proxy of another test whose object is gone answers no question about its class.
        errors = [one for one in gc.get_objects() if type(one) is json.JSONDecodeError]
        assert text not in [error.doc for error in errors]
    finally:
        gc.enable()


def test_what_begins_like_json_and_is_none(tmp_path: Path) -> None:
    for text in ("[section]\nkey = 1\n", "{not json}\n"):
        (tmp_path / "own.ini").write_text(text, encoding="utf-8")
        assert format_of(tmp_path / "own.ini") is None


numbers = st.one_of(st.integers(-(10**6), 10**6), st.floats(allow_nan=False, allow_infinity=False))


@given(
    st.lists(st.tuples(numbers, numbers, numbers), min_size=2), st.sampled_from(["records", "split", "lists"])
)
def test_any_numbers_come_back(rows: list[tuple[float, ...]], arrangement: str) -> None:
    columns = {name: [row[at] for row in rows] for at, name in enumerate("txy")}
    documents = {
        "records": [dict(zip("txy", row, strict=True)) for row in rows],
        "split": {"columns": list("txy"), "data": rows},
        "lists": columns,
    }
    value = records_json.parse(json.dumps(documents[arrangement]))
    assert table_choice.table_in(Path("own.json"), value, "JSON", Reading()).columns == columns


@given(
    st.lists(numbers, min_size=2),
    st.sampled_from([", ", ",", "; ", "|", " ", "\n"]),
    st.sampled_from(["[]", "()", "{}", ""]),
)
def test_numbers_in_a_cell_come_back(values: list[float], mark: str, brackets: str) -> None:
    cell = brackets[:1] + mark.join(map(repr, values)) + brackets[1:]
    assert is_list(cell)
    assert [float(item) for item in split(cell)] == values
    assert not is_list(cell + "x")
    if brackets:
        assert not is_list(cell[:-1])


@pytest.mark.parametrize(
    "cell", ["", " ", "left", "7", "2020-01-01 10:00", "[", "[1, 2", "1_0, 2", "a, b", "nan 1"]
)
def test_words_are_no_list(cell: str) -> None:
    assert not is_list(cell)


def test_lists_of_other_programs() -> None:
    for cell in (
        "c(1, 2)",
        "array([1., 2.])",
        "[1. 2.]",
        '["1", "2"]',
        "1,0;2,0;",
        "[np.float64(1.0), np.int64(2)]",
    ):
        assert is_list(cell)
        assert [float(item) for item in split(cell)] == [1, 2], cell
    assert split("[1,,2,]") == ["1", "", "2"]
    assert is_list("[]")
    assert split("[]") == []


def test_a_cut_list_and_a_hole_cost_their_trials(tmp_path: Path) -> None:
    rows = [
        "trial;t;x;y",
        *(f"{n};[0, 8, 16];[1, 2, 3];[4, 5, {end}" for n, end in enumerate(("6]", "6", ", 6]"))),
    ]
    rows.append("3;[0, 8, 1;[1, 2, 3];[4, 5, 6]")
    (tmp_path / "own.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    (recording,) = read_any(tmp_path / "own.csv")
    assert [trial.trial for trial in recording.trials] == ["0"]
    assert [skip.row for skip in recording.skipped] == [1, 2, 3]


def test_tracks_as_json_in_the_cells_of_a_table(tmp_path: Path) -> None:
    """The samples of each trial in one cell; one is cut, one is empty."""
    frame = pd.DataFrame([{"user": user, "trial": trial, "trajectory": None} for user, trial in TRIALS])
    frame["trajectory"] = [
        json.dumps([dict(zip(NAMES, sample, strict=False)) for sample in samples])
        for samples in TRIALS.values()
    ]
    frame.loc[1, "trajectory"] = frame.loc[1, "trajectory"][:50]
    frame.loc[2, "trajectory"] = ""
    frame.to_csv(tmp_path / "own.csv", index=False)
    (recording,) = read_any(tmp_path / "own.csv")
    assert [(trial.user, trial.trial) for trial in recording.trials] == [("p1", "1"), ("p2", "2")]
    for index, key in enumerate([("p1", 1), ("p2", 2)]):
        np.testing.assert_allclose(recording.rows(index).table[:, :3] * [1000, 1, 1], TRIALS[key], atol=1e-9)
    assert any("trajectory that are no JSON: 1" in note for note in recording.notes)


def test_no_column_is_lost_where_names_occur_twice(tmp_path: Path) -> None:
    names = ["t", "x", "y", "a", "a", "a.4"]
    columns = columns_of(tmp_path / "own.json", [names, *([8.0 * at, at, 1, 2, 3, 4] for at in range(20))])
    assert [cells[0] for cells in columns.values()] == [0.0, 0, 1, 2, 3, 4]
