"""Trial numbers that restart per block: joined columns, told or assumed, and runs of their own."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from pointpred.errors import ColumnsError
from pointpred.recording import Recording
from pointpred.recordings import read, read_any, write
from tests.building import lines_file


def table(folder: Path, header: str, *runs: tuple[str, int]) -> Path:
    """A table of runs of five samples, each with its first cells and the time at which it begins."""
    lines = [f"{cells},{begin + 10 * i},{begin + i},{i}" for cells, begin in runs for i in range(5)]
    return lines_file(folder / "study.csv", f"{header},t_ms,x,y", *lines)


def trials(recording: Recording) -> list[tuple[str, str]]:
    return [(trial.user, trial.trial) for trial in recording.trials]


def begins(recording: Recording) -> list[float]:
    return [float(recording.rows(at).x[0]) for at in range(len(recording.trials))]


BLOCKS = [("a,1,1", 0), ("a,1,2", 100), ("a,2,1", 10), ("a,2,2", 110), ("b,1,1", 5), ("b,2,1", 7)]
JOINED = [("a", "1+1"), ("a", "1+2"), ("a", "2+1"), ("a", "2+2"), ("b", "1+1"), ("b", "2+1")]


@pytest.mark.parametrize("told", [None, "part+trial"])
def test_columns_are_joined_as_told_or_where_a_usual_one_separates_the_runs(
    told: str, tmp_path: Path
) -> None:
    path = table(tmp_path, "sid,part,trial" if told else "sid,block_nr,trial", *BLOCKS)
    [recording] = read_any(path, columns={"trial": told} if told else None)
    assert trials(recording) == JOINED
    assert begins(recording) == [0, 100, 10, 110, 5, 7]
    assert any("joined" in note for note in recording.notes) == (told is None)


def test_a_clock_that_goes_on_hides_no_restart(tmp_path: Path) -> None:
    path = table(tmp_path, "block,trial", ("1,1", 0), ("1,2", 100), ("2,1", 200), ("2,2", 300))
    [recording] = read_any(path)
    assert [name for _, name in trials(recording)] == ["1+1", "1+2", "2+1", "2+2"]


def test_two_columns_separate_what_one_does_not(tmp_path: Path) -> None:
    cells = ["1,1,1", "1,2,1", "2,1,1", "2,2,1"]
    runs = [run for at, cell in enumerate(cells) for run in ((cell, at), (cell[:-1] + "2", 100 + at))]
    [recording] = read_any(table(tmp_path, "session,block,trial", *runs))
    assert len(set(trials(recording))) == 8
    assert begins(recording) == [begin for _, begin in runs]


def test_runs_that_nothing_separates_are_trials_of_their_own(tmp_path: Path) -> None:
    runs = [("a,1", 0), ("a,2", 100), ("a,1", 10), ("a,1 (2)", 200), ("b,1", 5), ("a,1", 3), ("a,1 (2)", 300)]
    [recording] = read_any(table(tmp_path, "sid,trial", *runs))
    assert trials(recording)[:4] == [("a", "1"), ("a", "2"), ("a", "1 (2)'"), ("a", "1 (2)")]
    assert trials(recording)[4:] == [("b", "1"), ("a", "1 (3)")]
    assert len(recording.events) == 35
    assert any("restart" in note for note in recording.notes)
    assert recording.skipped == ()


def test_users_whose_rows_alternate_are_no_restart(tmp_path: Path) -> None:
    [recording] = read_any(table(tmp_path, "sid,block,trial", ("a,1,1", 0), ("b,1,1", 0), ("a,1,1", 100)))
    assert trials(recording) == [("a", "1"), ("b", "1")]
    assert not any("restart" in note for note in recording.notes)


def test_a_column_that_varies_within_a_run_is_not_joined(tmp_path: Path) -> None:
    runs = [("go,1", 0), ("hit,1", 50), ("go,2", 100), ("hit,2", 150)]
    [recording] = read_any(table(tmp_path, "phase,trial", *runs))
    assert trials(recording) == [("study", "1"), ("study", "2")]
    [recording] = read_any(table(tmp_path, "phase,trial", *runs, *runs))
    assert [name for _, name in trials(recording)] == ["1", "2", "1 (2)", "2 (2)"]


def test_a_name_with_a_plus_wins_and_an_unknown_part_is_refused(tmp_path: Path) -> None:
    path = table(tmp_path, "a,b,a+b", ("1,2,own", 0))
    [recording] = read_any(path, columns={"trial": "a+b", "user": "b+a"})
    assert trials(recording) == [("2+1", "own")]
    with pytest.raises(ColumnsError, match="no column 'c' for trial"):
        read_any(path, columns={"trial": "a+c"})


def test_rows_without_one_of_the_joined_words_are_counted(tmp_path: Path) -> None:
    [recording] = read_any(
        table(tmp_path, "block,trial", ("1,1", 0), (",1", 9), ("x+1,1", 0)), columns={"trial": "block+trial"}
    )
    assert [name for _, name in trials(recording)] == ["1|1", "x+1|1"]
    assert any("left out: 5" in note for note in recording.notes)


def test_columns_named_as_pointpreds_own_can_be_written_as_conditions(tmp_path: Path) -> None:
    path = table(tmp_path, "block,trial,dataset", ("1,1,pilot", 0), ("2,1,pilot", 0))
    [recording] = read_any(path, columns={"trial": "block+trial"})
    again = read(write(recording, tmp_path / "again.csv")[0])
    assert trials(again) == trials(recording) == [("study", "1+1"), ("study", "2+1")]
    assert again.trials[1].condition == {"block": 2.0, "trial_column": 1.0, "dataset_column": "pilot"}


def test_blocks_of_one_trial_each_are_told_apart(tmp_path: Path) -> None:
    """Their trials all have the number 1 and follow each other."""
    lines = ["block,trial,t_ms,x,y"]
    lines += [f"{block},1,{16 * at},{block * at},{at}" for block in (1, 2, 3) for at in range(8)]
    path = tmp_path / "study.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    [recording] = read_any(path)
    assert [trial.trial for trial in recording.trials] == ["1+1", "2+1", "3+1"]
    assert recording.skipped == ()


def test_a_late_sample_restarts_nothing(tmp_path: Path) -> None:
    lines = ["block,trial,t_ms,x,y"]
    order = [1, 2, 3, 5, 4, *range(6, 40)]
    lines += [f"1,{trial},{16 * at},{at},{at}" for trial in (1, 2) for at in order]
    path = tmp_path / "study.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    [recording] = read_any(path)
    assert [trial.trial for trial in recording.trials] == ["1", "2"]


def test_rows_of_lists_without_a_user_are_left_out_and_counted(tmp_path: Path) -> None:
    path = tmp_path / "study.csv"
    rows = [f'{user},"[0,16,32,48]","[1,2,3,4]","[5,6,7,9]"' for user in ("ann", "ann", "", "ben")]
    path.write_text("\n".join(["user,t_ms,x,y", *rows]) + "\n", encoding="utf-8")
    [recording] = read_any(path)
    assert [trial.user for trial in recording.trials] == ["ann", "ann", "ben"]
    assert "rows without user or trial left out: 1, the first is data row 2" in recording.notes


def test_many_short_lists_of_one_length_are_asked_about(tmp_path: Path) -> None:
    path = tmp_path / "study.json"
    rows = [[10.0 * trial + 0.016 * at for trial in range(3)] for at in range(40)]
    document = {"t": rows, "x": [[at + trial for trial in range(3)] for at in range(40)], "y": rows}
    path.write_text(json.dumps(document), encoding="utf-8")
    [recording] = read_any(path, time_unit="s")
    assert any("is a column a trial" in note for note in recording.notes)
