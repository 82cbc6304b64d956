"""``pointpred score``: the walk from a recording to a number, and what happens to a bad one."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from pointpred.recording import Recording, Trial
from pointpred.recordings import read_any, write
from pointpred.records import EventColumns
from tests import building

T = [0.0, 0.1, 0.2, 0.3]
X = [0.0, 1.0, 60.0, 101.0]


@pytest.fixture
def good(tmp_path: Path) -> Path:
    path = EventColumns.of(t=T, x=X, y=[0.0] * 4)
    still = EventColumns.of(t=T, x=[5.0] * 4, y=[0.0] * 4)
    trials = [Trial("ann", "1"), Trial("bob", "1"), Trial("bob", "2")]
    return write(Recording.of("walk", [path, path, still], trials), tmp_path / "walk_samples.csv")[0]


@pytest.fixture
def bad(tmp_path: Path) -> Path:
    return building.text_file(tmp_path / "bad_samples.csv", "user,trial,t_s,x_px\nann,1,0.0,1.0\n")


def test_json_is_the_published_document(command, good: Path) -> None:
    left = command("score", good, "--predictors", "hold", "--json", "-")
    assert left.code == 0
    document = json.loads(left.out)
    assert document["version"] == 1
    (one,) = document["sets"]
    assert (one["name"], one["trials"], one["users"]) == ("walk", 2, 2)
    assert [skip["trial"] for skip in one["skipped"]] == ["2"]
    assert one["skipped"][0]["reason"]
    (hold,) = one["predictors"]
    assert hold["name"] == "hold"
    assert hold["coverage"] == 1.0
    # From the onset at 0.1 s: 0.05 s at 100 px, then 0.05 s at 41 px (a sample counts for 50 ms at most).
    assert hold["time_averaged"]["px"] == pytest.approx(70.5)
    assert hold["time_averaged"]["of_hold"] == 1.0
    assert hold["time_averaged"]["interval"] == [1.0, 1.0]
    assert hold["by_time"]["0.2"]["px"] == pytest.approx(100.0)
    assert hold["by_path"]["1.0"]["px"] == pytest.approx(0.0)
    assert hold["us_per_event"] > 0.0


def test_table_has_hold_whoever_was_asked_for_and_counts_what_it_skips(command, good: Path) -> None:
    left = command("score", good, "--predictors", "hold")
    assert left.code == 0
    assert "walk: 2 trials, 1 skipped, 2 people; hold is 70.5 px off" in left.out
    assert any(line.split()[:2] == ["hold", "1.00"] for line in left.out.splitlines())
    assert "walk: skipped 1: " in left.err
    assert "(first: trial 2" in left.err
    assert "1 trials" not in left.out + left.err


def test_a_faulty_row_is_counted_as_the_messages_say(command, tmp_path: Path) -> None:
    path = tmp_path / "walk.csv"
    path.write_text("user,trial,t_s,x_px,y_px\nu,1,0,0,0\nu,1,1,9,0\nu,2,0,0,0\nu,2,1,left,0\n")
    left = command("score", path, "--predictors", "hold")
    assert "walk: 1 trial, 1 skipped, 1 person; hold is 9.0 px off" in left.out
    assert "(first: trial 2 of u, data row 3 (counted from 0))" in left.err


def test_scores_on_what_was_learned_from_carry_a_warning(command, good: Path, tmp_path: Path) -> None:
    known, page = tmp_path / "kh2017_samples.csv", tmp_path / "out.html"
    known.write_text(good.read_text().replace("walk", "kh2017"))
    warning = "kinematic: fitted to people of this set: too good; see docs/evidence/results.md"
    left = command("score", known, "--predictors", "kinematic", "--report", page)
    assert warning in left.out
    assert warning in page.read_text()
    left = command("score", good, "--predictors", "kinematic", "--report", page, "--force")
    assert "too good" not in left.out + page.read_text()
    (one,) = json.loads(command("score", known, "--predictors", "kinematic", "--json", "-").out)["sets"]
    assert [predictor["seen"] for predictor in one["predictors"]] == [False, True]


def test_two_recordings_of_one_name_are_told_apart(command, good: Path, tmp_path: Path) -> None:
    files = []
    for folder in ("c", "d"):
        (tmp_path / folder).mkdir()
        files.append(tmp_path / folder / good.name)
        files[-1].write_bytes(good.read_bytes())
    page = tmp_path / "out.html"
    left = command("score", *files, files[1], "--predictors", "hold", "--json", "-", "--report", page)
    names = ["walk", "d/walk", "d/walk_2"]
    assert [one["name"] for one in json.loads(left.out)["sets"]] == names
    assert left.err.count("is called 'd/walk' here: 'walk' is " + str(files[0])) == 1
    assert page.read_text().count("Worst trials of hold") >= 3


def test_counts_are_not_called_pixels(command) -> None:
    stream = Path(__file__).parents[1] / "data" / "sources" / "hid-recorder.txt"
    left = command("score", stream, "--predictors", "hold")
    assert " counts off" in left.out
    assert "counts of the device and not pixels" in left.err
    (one,) = json.loads(command("score", stream, "--predictors", "hold", "--json", "-").out)["sets"]
    assert one["unit"] == "counts"


def test_json_to_a_file_leaves_the_table(command, good: Path, tmp_path: Path) -> None:
    left = command("score", good, "--predictors", "hold", "--json", tmp_path / "out.json")
    assert "hold" in left.out
    assert json.loads((tmp_path / "out.json").read_text())["sets"][0]["name"] == "walk"


def test_a_report_reads_each_recording_once(
    command, good: Path, bad: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    read: list[Path] = []

    def counted(file: Path, *rest: object) -> object:
        read.append(file)
        return read_any(file, *rest)

    monkeypatch.setattr("pointpred.recordings.open_any", counted)
    report = tmp_path / "out.html"
    left = command("score", good, bad, "--predictors", "linear", "--report", report)
    assert left.code == 0
    assert read == [good, bad]
    assert "Worst trials of" in report.read_text(encoding="utf-8")


def test_nothing_scored_is_1_and_says_why(command, bad: Path) -> None:
    left = command("score", bad, "--predictors", "hold")
    assert left.code == 1
    assert left.out == ""
    assert "bad_samples.csv" in left.err
    assert "no column for y" in left.err
    assert "no trial could be scored" in left.err
    assert "Traceback" not in left.err


def test_a_bad_file_does_not_stop_the_good_one(command, good: Path, bad: Path) -> None:
    left = command("score", bad, good, "--predictors", "hold", "--json", "-")
    assert left.code == 0
    document = json.loads(left.out)
    assert [one["name"] for one in document["sets"]] == ["walk"]
    assert [one["file"] for one in document["unread"]] == [str(bad)]
    assert "bad_samples.csv" in left.err


def test_checkpoints_that_cannot_be_kept_are_no_fault_of_the_recordings(
    command, good: Path, tmp_path: Path
) -> None:
    document = tmp_path / "scores.json"
    left = command("score", good, "--predictors", "hold", "--checkpoints", good / "done", "--json", document)
    assert left.code == 2
    assert "cannot keep checkpoints" in left.err
    assert "left out" not in left.err
    assert not document.exists()


def test_without_files_the_sample_is_scored_and_named(command) -> None:
    left = command("score", "--predictors", "hold")
    assert left.code == 0
    assert "embedded sample of simulated people" in left.err
    assert "10 simulated people" in left.out


@pytest.mark.recordings
def test_scores_a_recording_of_a_person(command, recordings: Path) -> None:
    left = command(
        "score", recordings / "gofitts_demo_samples.parquet", "--predictors", "hold", "--json", "-"
    )
    assert left.code == 0
    (one,) = json.loads(left.out)["sets"]
    assert one["trials"] + len(one["skipped"]) == 81
