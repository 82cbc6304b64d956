"""jsPsych's rectangles are a target only when one is named; JATOS' lines and late tracks are read."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pointpred.errors import RecordingError
from pointpred.recordings import Reading, convert, format_of, read, read_any
from tests.building import text_file

SOURCES = Path(__file__).parents[1] / "data/sources"
CONTAINER = {"x": 100, "y": 50, "width": 804, "height": 604}
BUTTON = {"x": 880, "y": 60, "width": 24, "height": 40}


def trial(index: int, **more: Any) -> dict[str, Any]:
    track = [{"x": 500 + index + k, "y": 400 - 3 * k, "t": 7 * k, "event": "mousemove"} for k in range(5)]
    about = {"trial_type": "html-button-response", "trial_index": index, "time_elapsed": 1000 * index}
    return about | {"mouse_tracking_data": track} | more


def written(folder: Path, text: str, name: str = "study.json") -> Path:
    return text_file(folder / name, text)


def targets(recording: Any) -> list[tuple[float, float, float]]:
    return [(trial.target_x, trial.target_y, trial.target_w) for trial in recording.trials]


def test_a_selector_that_is_named_gives_the_target(tmp_path: Path) -> None:
    rectangles = {"#container": CONTAINER, "#left": BUTTON}
    path = written(tmp_path, json.dumps([trial(0, mouse_tracking_targets=rectangles), trial(1)]))
    [plain] = read_any(path)
    assert np.isnan(targets(plain)).all()
    assert any("#container (1), #left (1)" in note and "--target" in note for note in plain.notes)
    [named] = read_any(path, Reading(target="#left"))
    assert targets(named)[0] == (880 + 12, 60 + 20, 24)
    assert np.isnan(targets(named)[1]).all()
    assert sum("1 of 2 trials" in note for note in named.notes) == 1


def test_a_rectangle_around_the_start_is_no_target(tmp_path: Path) -> None:
    path = written(tmp_path, json.dumps([trial(0, mouse_tracking_targets={"#container": CONTAINER})]))
    [recording] = read_any(path, Reading(target="#container"))
    assert np.isnan(targets(recording)).all()
    assert any("begins inside #container" in note for note in recording.notes)


@pytest.mark.parametrize("rectangle", [{"x": 1}, 7, BUTTON | {"width": 0}, BUTTON | {"x": "wide"}])
def test_what_is_no_rectangle_is_no_target(tmp_path: Path, rectangle: Any) -> None:
    path = written(tmp_path, json.dumps([trial(0, mouse_tracking_targets={"#left": rectangle})]))
    [recording] = read_any(path, Reading(target="#left"))
    assert np.isnan(targets(recording)).all()
    assert any("no rectangle" in note for note in recording.notes)


def test_a_track_beyond_the_first_64_kib_is_found_and_other_json_is_not_claimed(tmp_path: Path) -> None:
    before = [trial(index, mouse_tracking_data=None, stimulus="x" * 500) for index in range(300)]
    path = written(tmp_path, json.dumps([{k: v for k, v in t.items() if "data" not in k} for t in before]))
    early = format_of(path)
    assert early is None or early.key != "jspsych"
    path = written(tmp_path, json.dumps([*before, trial(300)]).replace("mouse_tracking_data", "x", 300))
    assert path.read_bytes().index(b"mouse_tracking_data") > 1 << 17
    [recording] = read_any(path)
    assert [trial.trial for trial in recording.trials] == ["300"]


def test_jatos_gives_a_person_a_line(tmp_path: Path) -> None:
    """Compared with the standard library's reading of the same lines."""
    lines = [[trial(0), trial(1, subject="anna")], [trial(0), trial(1)], [trial(0)]]
    text = "\n".join(map(json.dumps, lines)) + "\n\n" + json.dumps([trial(2)])[:-9]
    [recording] = read_any(written(tmp_path, text, "jatos_results.txt"))
    assert [(trial.user, trial.trial) for trial in recording.trials] == [
        ("anna", "1 0"),
        ("anna", "1 1"),
        ("2", "2 0"),
        ("2", "2 1"),
        ("3", "3 0"),
    ]
    assert [skip.trial for skip in recording.skipped] == ["line 5"]
    samples = [
        [(s["t"] - t["mouse_tracking_data"][0]["t"]) / 1000, s["x"], s["y"]]
        for line in text.splitlines()[:3]
        for t in json.loads(line)
        for s in t["mouse_tracking_data"]
    ]
    np.testing.assert_array_equal(recording.events.table[:, :3], samples)


def test_lines_that_are_no_json_are_refused(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="no JSON"):
        read_any(written(tmp_path, '[{"mouse_tracking_data": \n[{"x": \n'))


@pytest.mark.parametrize("ending", ["csv", "parquet"])
def test_conditions_are_kept_and_come_back(tmp_path: Path, ending: str) -> None:
    rows = [
        trial(0, cue="left", block=1, ok=True, stimulus="<p>" + "x" * 200, rt=None, clean="x", answers=[1]),
        trial(1, cue="right", block=2, ok=False, rt=350.5),
        trial(2, cue=3, block=2, rt="late"),
    ]
    summary = convert(written(tmp_path, json.dumps(rows)), tmp_path / f"out.{ending}")
    about = [
        {k: v for k, v in trial.condition.items() if k not in ("targets", "time_elapsed", "trial_type")}
        for trial in read(summary.files[0]).trials
    ]
    assert about == [
        {"cue": "left", "block": 1.0, "ok": "true", "clean_column": "x"},
        {"cue": "right", "block": 2.0, "ok": "false", "rt": "350.5"},
        {"cue": "3", "block": 2.0, "rt": "late"},
    ]


def test_json_and_csv_of_the_same_experiment_agree(tmp_path: Path) -> None:
    rows = [trial(0, subject=4, cue="left"), trial(1, subject=4, cue="right")]
    with (tmp_path / "study.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), quoting=csv.QUOTE_ALL)
        writer.writeheader()
        for row in rows:
            writer.writerow(row | {"mouse_tracking_data": json.dumps(row["mouse_tracking_data"])})
    [as_json] = read_any(written(tmp_path, json.dumps(rows)))
    [as_csv] = read_any(tmp_path / "study.csv")
    assert repr(as_csv.trials) == repr(as_json.trials)
    np.testing.assert_array_equal(as_csv.events.table, as_json.events.table)
