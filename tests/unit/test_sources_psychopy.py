"""PsychoPy: units that a file does not say are asked for; separators, clicks, people, conditions."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pointpred.errors import RecordingError
from pointpred.recordings import Reading, convert, read, read_any
from tests.building import lines_file

SOURCES = Path(__file__).parents[1] / "data/sources"
TRACK = {
    "mouse.x": "[-120.0, 40.0, 300.5]",
    "mouse.y": "[0.0, 10.0, 20.0]",
    "mouse.leftButton": "[0, 0, 1]",
    "mouse.time": "[0.5, 0.516, 0.533]",
}
DEGREES = TRACK | {"mouse.x": "[-12.5, 4.0, 9.25]", "mouse.y": "[0.0, 1.5, 2.0]"}
CLICKS = TRACK | {"mouse.leftButton": "[1, 1, 1]", "mouse.time": "[0.5, 1.25, 3.0]"}


def written(folder: Path, *rows: dict[str, Any], separator: str = ",", name: str = "study.csv") -> Path:
    quoted = [[f'"{cell}"' if "[" in str(cell) else str(cell) for cell in row.values()] for row in rows]
    lines = [separator.join(rows[0]), *(separator.join(cells) for cells in quoted)]
    return lines_file(folder / name, *lines)


def test_pixels_are_assumed_with_a_note_and_taken_without_when_told(tmp_path: Path) -> None:
    path = written(tmp_path, TRACK)
    [assumed] = read_any(path)
    [told] = read_any(path, Reading(px_per_unit=1.0))
    assert sum("taken as px" in note for note in assumed.notes) == 1
    assert not any("taken as px" in note for note in told.notes)
    np.testing.assert_array_equal(assumed.events.table, told.events.table)


def test_degrees_are_not_taken_for_pixels(tmp_path: Path) -> None:
    path = written(tmp_path, DEGREES)
    with pytest.raises(RecordingError, match="--px-per-unit 38 for deg"):
        read_any(path)
    told = written(tmp_path, DEGREES | {"units": "deg"}, name="told.csv")
    with pytest.raises(RecordingError, match=r"positions in deg need .* --px-per-unit 38 for deg"):
        read_any(told)
    [recording] = read_any(told, Reading(px_per_unit=40.0))
    np.testing.assert_array_equal(recording.events.table[:, 1], [-500, 160, 370])
    np.testing.assert_array_equal(recording.events.table[:, 2], [0, -60, -80])
    assert recording.provenance.unit == "deg"
    assert not any("no effect" in note for note in recording.notes)
    [pixels] = read_any(path, Reading(px_per_unit=1.0))
    np.testing.assert_array_equal(pixels.events.table[:, 1], [-12.5, 4, 9.25])


def test_few_whole_pixels_are_pixels(tmp_path: Path) -> None:
    [recording] = read_any(written(tmp_path, DEGREES | {"mouse.x": "[0, 3, 9]", "mouse.y": "[0, 1, 2]"}))
    np.testing.assert_array_equal(recording.events.table[:, 1], [0, 3, 9])


@pytest.mark.parametrize(("column", "cell"), [("units", "cm"), ("win.units", "CM"), ("mouse.units", "cm")])
def test_the_unit_is_taken_from_the_file(tmp_path: Path, column: str, cell: str) -> None:
    [recording] = read_any(written(tmp_path, DEGREES | {column: cell}), Reading(dpi=254.0))
    np.testing.assert_allclose(recording.events.table[:, 1], [-1250, 400, 925], rtol=1e-12)
    assert any(column in note for note in recording.notes)
    mixed = written(tmp_path, TRACK | {column: cell}, TRACK | {column: "pix"})
    assert any("taken as px" in note for note in read_any(mixed)[0].notes)


@pytest.mark.parametrize("separator", [";", "\t"])
def test_separators(tmp_path: Path, separator: str) -> None:
    [expected] = read_any(written(tmp_path, TRACK | {"participant": "a"}))
    [found] = read_any(written(tmp_path, TRACK | {"participant": "a"}, separator=separator))
    np.testing.assert_array_equal(found.events.table, expected.events.table)
    assert (found.trials[0].user, found.provenance.format) == ("a", "psychopy")


def test_clicks_alone_are_no_movement(tmp_path: Path) -> None:
    one = {"mouse.x": "[5]", "mouse.y": "[5]", "mouse.leftButton": "[1]", "mouse.time": "[0.5]"}
    drag = TRACK | {"mouse.leftButton": "[1, 1, 1]"}
    [recording] = read_any(written(tmp_path, CLICKS, TRACK, one, drag))
    assert [trial.trial for trial in recording.trials] == ["1", "3"]
    assert [(skip.trial, "on click" in skip.reason) for skip in recording.skipped] == [
        ("0", True),
        ("2", True),
    ]


def test_a_file_that_names_nobody_is_one_person(tmp_path: Path) -> None:
    for name in ("anna", "ben"):
        written(tmp_path, TRACK | {"favourite": "tea"}, name=f"{name}.csv")
    [folder] = read_any(tmp_path)
    assert sorted(trial.user for trial in folder.trials) == ["anna", "ben"]
    assert sum("one user" in note for note in folder.notes) == 2
    named = written(tmp_path, TRACK | {"subject_id": "s4"}, TRACK | {"subject_id": ""}, name="x.csv")
    [recording] = read_any(named)
    assert [trial.user for trial in recording.trials] == ["s4"]
    assert "rows without user or trial left out: 1, the first is data row 1" in recording.notes


def test_conditions_are_kept_and_come_back(tmp_path: Path) -> None:
    rows = [
        TRACK | {"cue": cue, "trials.thisN": n, "answers": "[1, 2]"} for n, cue in enumerate(("left", ""))
    ]
    for ending in ("csv", "parquet"):
        summary = convert(written(tmp_path, *rows), tmp_path / f"out.{ending}")
        assert [trial.condition for trial in read(summary.files[0]).trials] == [
            {"cue": "left", "trials.thisN": 0.0, "mouse": "mouse"},
            {"trials.thisN": 1.0, "mouse": "mouse"},
        ]


def test_conditions_that_are_words_in_one_file_and_numbers_in_another_are_words(tmp_path: Path) -> None:
    written(tmp_path, TRACK | {"block": 1}, name="a.csv")
    written(tmp_path, TRACK | {"block": "practice"}, name="b.csv")
    summary = convert(tmp_path, tmp_path / "all.csv")
    assert [trial.condition["block"] for trial in read(summary.files[0]).trials] == ["1", "practice"]


def test_mousetrap_keeps_conditions_and_gives_a_person_a_file(tmp_path: Path) -> None:
    text = "timestamps_r;xpos_r;ypos_r;congruency;block\n'1, 2';'3, 4';'5, 6';low;2\n".replace("'", '"')
    (tmp_path / "p4.csv").write_text(text, encoding="utf-8")
    [recording] = read_any(tmp_path / "p4.csv")
    [trial] = recording.trials
    assert (trial.user, trial.condition) == ("p4", {"congruency": "low", "block": 2.0, "item": "r"})
    assert recording.provenance.format == "mousetrap"
