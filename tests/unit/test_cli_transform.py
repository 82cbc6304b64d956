"""``pointpred simulate`` and ``convert``: what they write, and that they replace nothing unasked."""

from pathlib import Path

import pytest

from pointpred.recordings import read

DATA = Path(__file__).parents[1] / "data" / "sources"
SHORT = ("--people", "1", "--trials", "1")


@pytest.mark.parametrize("existing", ["study_samples.csv", "study_trials.csv"])
@pytest.mark.parametrize(
    "words", [("simulate", *SHORT), ("convert", DATA / "gofitts.sd3")], ids=lambda words: str(words[0])
)
def test_files_that_exist_are_replaced_only_when_asked(
    command, tmp_path: Path, words: tuple[str | Path, ...], existing: str
) -> None:
    (tmp_path / existing).write_text("mine\n")
    out = tmp_path / "study_samples.csv"
    left = command(*words, "--out", out)
    assert left.code == 2
    assert f"{existing} exists; pass --force to replace it and study_" in left.err
    assert [file.name for file in tmp_path.iterdir()] == [existing]
    assert (tmp_path / existing).read_text() == "mine\n"
    assert command(*words, "--out", out, "--force").code == 0
    assert (tmp_path / existing).read_text() != "mine\n"


def test_a_folder_of_several_recordings_replaces_nothing_either(command, tmp_path: Path) -> None:
    source, out = tmp_path / "in", tmp_path / "all.csv"
    source.mkdir()
    for name in ("one", "two"):
        text = (DATA / "pair_samples.csv").read_text().replace("pair", name)
        (source / f"{name}_samples.csv").write_text(text)
    taken = tmp_path / "two_all_samples.csv"
    taken.write_text("mine\n")
    left = command("convert", source, "--out", out)
    assert left.code == 2
    assert "two_all_samples.csv exists; pass --force" in left.err
    assert not list(tmp_path.glob("one_*"))
    assert command("convert", source, "--out", out, "--force").code == 0
    assert taken.read_text() != "mine\n"


def test_one_of_a_thing_is_not_called_many(command, tmp_path: Path) -> None:
    source = tmp_path / "walk.csv"
    source.write_text("user,trial,t_s,x_px,y_px\nu,1,0,0,0\nu,1,1,3,4\n")
    left = command("convert", source, "--out", tmp_path / "out.csv")
    assert "kept 1 trial of 1 user, 2 rows" in left.err


def test_an_unknown_ending_is_refused_before_anything_is_simulated(command, tmp_path: Path) -> None:
    left = command("simulate", "--people", "1000", "--out", tmp_path / "study.xlsx")
    assert left.code == 2
    assert "cannot write .xlsx, expected .parquet or .csv" in left.err


def test_a_desktop_is_written_with_its_windows(command, tmp_path: Path) -> None:
    out = tmp_path / "work_samples.csv"
    left = command("simulate", "--desktop", "moved", "--people", "1", "--trials", "4", "--out", out)
    assert (left.code, left.err.split(",")[0]) == (0, "4 trials")
    known = [trial.condition for trial in read(out).trials]
    assert [one["changed"] for one in known] == [0.0, 0.0, 1.0, 1.0]
    assert known[0]["window_x"] != known[2]["window_x"]
    assert {one["window"] for one in known} == {"window 0"}


def test_an_unknown_desktop_is_refused(command, tmp_path: Path) -> None:
    left = command("simulate", "--desktop", "tidy", "--out", tmp_path / "work.csv")
    assert left.code == 2
    assert "steady, moved, habits, menus, windows" in left.err
