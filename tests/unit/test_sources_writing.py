"""A conversion that fails leaves no file and replaces none; what holds no trial is not written."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from pointpred.errors import RecordingError
from pointpred.files import beside
from pointpred.recordings import convert, read_any, writing
from pointpred.recordings.writing import write_together

SOURCES = Path(__file__).parents[1] / "data/sources"
FITTS = SOURCES / "gofitts.sd3"


def contents(folder: Path) -> dict[str, bytes | None]:
    return {file.name: file.read_bytes() if file.is_file() else None for file in folder.iterdir()}


class Full:
    """A disk that is full, or an interrupt, at the nth table that is written."""

    def __init__(self, at: int, error: BaseException) -> None:
        self.left, self.error, self.write = at, error, writing.write_table

    def __call__(self, path: Path, part: Path, table: object, header: dict[str, object]) -> None:
        self.write(path, part, table, header)
        self.left -= 1
        if not self.left:
            raise self.error


@pytest.mark.parametrize("before", [False, True], ids=["new", "replaced"])
@pytest.mark.parametrize("error", [RecordingError("full"), KeyboardInterrupt()])
@pytest.mark.parametrize("at", [1, 2, 3, 4])
def test_a_failure_at_any_table_leaves_the_folder_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, at: int, error: BaseException, before: bool
) -> None:
    source = tmp_path / "in"
    shutil.copytree(SOURCES / "user7", source / "user7")
    shutil.copy(FITTS, source)
    out = tmp_path / "out"
    out.mkdir()
    if before:
        convert(source, out / "all.csv")
        for file in out.iterdir():
            file.write_text("before", encoding="utf-8")
    was = contents(out)
    monkeypatch.setattr(writing, "write_table", Full(at, error))
    with pytest.raises(type(error)):
        convert(source, out / "all.csv")
    assert contents(out) == was
    monkeypatch.undo()
    convert(source, out / "all.csv")
    assert len(contents(out)) == 4
    assert b"before" not in contents(out).values()


@pytest.mark.parametrize("links", [True, False], ids=["links", "no links"])
@pytest.mark.parametrize("at", [1, 2])
def test_a_file_that_cannot_take_its_place_brings_back_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, at: int, links: bool
) -> None:
    names = ["study_samples.csv", "study_trials.csv"]
    for name in names:
        (tmp_path / name).write_text(name, encoding="utf-8")
    was = contents(tmp_path)
    replace = Path.replace

    def refuse(file: Path, target: Path) -> Path:
        if file == beside(tmp_path / names[at - 1], "part"):
            raise PermissionError(13, "opened by another program")
        return replace(file, target)

    def no_links(*_: object) -> None:
        raise PermissionError(1, "no links here")

    monkeypatch.setattr(Path, "replace", refuse)
    if not links:
        monkeypatch.setattr("os.link", no_links)
    with pytest.raises(RecordingError, match=rf"{names[at - 1]}: cannot be written: opened by"):
        convert(FITTS, tmp_path / "study.csv")
    assert contents(tmp_path) == was
    (tmp_path / names[0]).unlink()
    with pytest.raises(RecordingError, match="opened by"):
        convert(FITTS, tmp_path / "study.csv")
    assert contents(tmp_path) == {names[1]: was[names[1]]}


@pytest.mark.parametrize("name", ["study_samples.parquet", "study_trials.parquet"])
def test_a_folder_in_the_place_of_a_file_is_an_error(tmp_path: Path, name: str) -> None:
    (tmp_path / name).mkdir()
    with pytest.raises(RecordingError, match=rf"{name}: cannot be written"):
        convert(FITTS, tmp_path / "study.parquet")
    assert contents(tmp_path) == {name: None}


def test_nothing_is_written_where_no_trial_was_read(tmp_path: Path) -> None:
    source = tmp_path / "in" / "still.csv"
    source.parent.mkdir()
    source.write_text('timestamps_r,xpos_r,ypos_r\n"1, 2","3, 3","5, 5"\n', encoding="utf-8")
    out = tmp_path / "out"
    out.mkdir()
    summary = convert(source, out / "still.csv")
    assert (summary.files, summary.trials, sum(summary.skipped.values())) == ((), 0, 1)
    assert contents(out) == {}
    shutil.copy(FITTS, source.parent)
    assert len(convert(source.parent, out / "all.csv").files) == len(contents(out)) == 2


def test_files_take_their_places_at_the_end_of_the_block(tmp_path: Path) -> None:
    [recording] = read_any(FITTS)
    with write_together() as part:
        paths = writing.write_parts(recording, tmp_path / "study.csv", part)
        assert not any(path.exists() for path in paths)
    assert sorted(contents(tmp_path)) == sorted(path.name for path in paths)


def test_notes_of_a_folder_name_their_file(tmp_path: Path) -> None:
    for name in ("one", "two"):
        shutil.copy(SOURCES / "pair_samples.csv", tmp_path / f"{name}_samples.csv")
        text = (tmp_path / f"{name}_samples.csv").read_text(encoding="utf-8")
        lines = [line for line in text.splitlines() if not line.startswith("#")]
        (tmp_path / f"{name}_samples.csv").write_text("\n".join(lines), encoding="utf-8")
    shutil.copy(SOURCES / "jspsych.json", tmp_path)
    notes = [note for recording in read_any(tmp_path) for note in recording.notes]
    assert notes
    assert all(
        note.startswith(("one_samples.csv: ", "two_samples.csv: ", "jspsych.json: ")) for note in notes
    )
    assert {note.partition(":")[0] for note in notes} == {
        "one_samples.csv",
        "two_samples.csv",
        "jspsych.json",
    }


def test_a_file_that_somebody_calls_part_is_not_touched(tmp_path: Path) -> None:
    other = tmp_path / "study_samples.csv.part"
    other.write_text("somebody's", encoding="utf-8")
    convert(FITTS, tmp_path / "study.csv")
    assert other.read_text(encoding="utf-8") == "somebody's"
