"""Headers of pointpred's own files that nobody of ours wrote, stray quotes, files that are cut."""

from __future__ import annotations

from pathlib import Path

import pytest

from pointpred.errors import RecordingError
from pointpred.recording import Skip
from pointpred.recordings import read, read_any
from tests.building import text_file

HEADER = "user,trial,t_s,x_px,y_px\n"
ROWS = "u,1,0,0,0\nu,1,1,3,4\nu,2,0,0,0\nu,2,1,5,12\n"


def written(folder: Path, text: str, name: str = "set_samples.csv") -> Path:
    return text_file(folder / name, text)


@pytest.mark.parametrize(
    ("field", "message"),
    [
        ('"notes":5', "not as expected"),
        ('"text":5', "not as expected"),
        ('"name":5', "not as expected"),
        ('"rows":"x"', "not as expected"),
        ('"skipped":[[1]]', "not as expected"),
        ('"append":"yes"', "not as expected"),
        ('"x":' + "[" * 3000, "not JSON"),
        ('"provenance":{"format":"csv","cpi":0.5}', r"cpi .* must lie in \[1, 1e\+06\], received 0.5"),
        ('"provenance":{"format":"csv","dpi":0}', r"dpi .* must lie in \[1, 100000\], received 0"),
        ('"provenance":{"format":"csv","cpi":1e300}', "cpi .* must lie in"),
        ('"provenance":{"format":"csv","dpi":1e300}', "dpi .* must lie in"),
    ],
)
@pytest.mark.parametrize("append", ["", '"append":true,'])
def test_a_header_of_other_contents_is_an_error(
    append: str, field: str, message: str, tmp_path: Path
) -> None:
    path = written(tmp_path, f'# pointpred:{{"version":1,{append}{field}}}\n{HEADER}{ROWS}')
    with pytest.raises(RecordingError, match=message):
        read_any(path)


def test_the_header_of_the_trials_is_checked_as_well(tmp_path: Path) -> None:
    path = written(tmp_path, HEADER + ROWS)
    written(tmp_path, '# pointpred:{"version":1,"text":5}\nuser,trial,block\nu,1,a\n', "set_trials.csv")
    with pytest.raises(RecordingError, match=r"set_trials\.csv.*not as expected"):
        read(path)


def test_a_file_of_an_impossible_resolution_is_left_out_and_the_others_are_scored(
    command, tmp_path: Path
) -> None:
    good = written(tmp_path, HEADER + ROWS, "good.csv")
    head = '# pointpred:{"version":1,"provenance":{"format":"csv","cpi":0.5}}\n'
    bad = written(tmp_path, head + HEADER + ROWS, "bad.csv")
    left = command("score", bad, good, "--predictors", "hold")
    assert "left out" in left.err
    assert "bad.csv" in left.err
    assert "good: " in left.out


@pytest.mark.parametrize("column", range(5))
def test_a_quote_that_is_not_closed_swallows_no_rows(column: int, tmp_path: Path) -> None:
    """Two stray quotes in two rows make one cell of all between them."""
    rows = [line.split(",") for line in ROWS.splitlines()]
    for row in (rows[1], rows[2]):
        row[column] = '"' + row[column]
    path = written(tmp_path, HEADER + "\n".join(",".join(row) for row in rows) + "\n")
    with pytest.raises(RecordingError, match=r"data row 1 \(counted from 0\).*unclosed quote\?"):
        read(path)


def test_a_long_cell_is_cut_in_what_is_said(tmp_path: Path) -> None:
    path = written(tmp_path, HEADER + ROWS + "u,3,0,0,0\nu,3,1," + "z" * 500 + ",0\n")
    (skip,) = read(path).skipped
    assert skip.reason == f"x_px is '{'z' * 40}...', expected a number"


def test_a_last_line_without_an_end_costs_the_last_trial(tmp_path: Path) -> None:
    reason = "the last line has no end: the file may be cut"
    recording = read(written(tmp_path, HEADER + ROWS.rstrip("\n")[:-1]))
    assert [trial.trial for trial in recording.trials] == ["1"]
    assert recording.skipped == (Skip("2", reason, 2, "u"),)
    assert recording.notes == (reason,)


def test_a_last_target_without_an_end_costs_its_trial(tmp_path: Path) -> None:
    written(tmp_path, "user,trial,target_x\nu,1,9\nu,2,102", "set_trials.csv")
    recording = read(written(tmp_path, HEADER + ROWS))
    assert [trial.trial for trial in recording.trials] == ["1"]
    assert "set_trials.csv: the last line has no end" in recording.skipped[0].reason


def test_a_file_without_rows_says_so(tmp_path: Path) -> None:
    recording = read(written(tmp_path, HEADER))
    assert recording.trials == ()
    assert recording.notes == ("no rows below the header",)


def test_a_table_with_blanks_beside_the_names_of_its_columns_is_read(tmp_path: Path) -> None:
    plain = read(written(tmp_path, HEADER + ROWS))
    [recording] = read_any(written(tmp_path, HEADER.replace(",", ", ") + ROWS))
    assert recording.events.table[:, :3].tolist() == plain.events.table[:, :3].tolist()
    assert [trial.trial for trial in recording.trials] == [trial.trial for trial in plain.trials]
