"""Files that are nearly right, as a spreadsheet or another lab writes them: read, or told what is missing."""

from pathlib import Path

import pytest

from pointpred.errors import ColumnsError
from pointpred.recordings import Reading, read, read_any

DATA = Path(__file__).parents[1] / "data" / "sources"
HEADER = "user,trial,t_s,x_px,y_px\n"
ROWS = "u,1,0,0,0\nu,1,0.01,3,4\n"
MARK = "\N{ZERO WIDTH NO-BREAK SPACE}"


@pytest.mark.parametrize("above", ["", '# pointpred:{"version":1,"name":"study"}\n'])
def test_a_byte_order_mark_is_no_part_of_the_first_name(above: str, tmp_path: Path) -> None:
    path = tmp_path / "study_samples.csv"
    path.write_text(MARK + (above + HEADER + ROWS).replace("\n", "\r\n"), encoding="utf-8", newline="")
    (recording,) = read_any(path)
    assert recording.name == "study"
    assert [(trial.user, trial.trial) for trial in recording.trials] == [("u", "1")]
    assert recording.events.x.tolist() == [0, 3]


def test_a_byte_order_mark_hides_no_foreign_format(tmp_path: Path) -> None:
    path = tmp_path / "fitts.sd3"
    path.write_bytes(MARK.encode() + (DATA / "gofitts.sd3").read_bytes())
    assert [t.trial for t in read_any(path)[0].trials] == [
        t.trial for t in read_any(DATA / "gofitts.sd3")[0].trials
    ]


def test_times_that_look_like_milliseconds_are_asked_about(tmp_path: Path) -> None:
    path = tmp_path / "study_samples.csv"
    rows = [f"u,{k},{10 * i},{3 * i},0\n" for k in range(3) for i in range(5)]
    path.write_text(HEADER + "".join(rows))
    assert read(path).notes == ("the median interval is 10 s; t_s is in seconds: are these milliseconds?",)
    path.write_text(HEADER + "".join(f"u,1,{i},{3 * i},0\n" for i in range(5)))
    assert read(path).notes == ()  # 1 s is slow, but no more than a pause


@pytest.mark.parametrize(
    "text",
    [
        (HEADER + ROWS).replace(",", ";"),
        (HEADER + ROWS).replace(",", "\t"),
        (HEADER + ROWS).replace(",", " , "),
        "participant" + HEADER[4:] + ROWS,
        MARK + "participant" + HEADER[4:] + ROWS,
    ],
)
def test_a_file_that_is_nearly_ours_is_read_as_any_table(text: str, tmp_path: Path) -> None:
    path = tmp_path / "study.csv"
    path.write_text(text, encoding="utf-8")
    (recording,) = read_any(path)
    assert [(trial.user, trial.trial) for trial in recording.trials] == [("u", "1")]
    assert recording.events.table[:, :3].tolist() == [[0, 0, 0], [0.01, 3, 4]]


def test_a_table_that_holds_no_movement_names_its_columns(tmp_path: Path) -> None:
    path = tmp_path / "study.csv"
    path.write_text("colour,size\nred,3\n")
    with pytest.raises(ColumnsError) as refusal:
        read_any(path)
    assert refusal.value.columns == ("colour", "size")
    (tmp_path / "good_samples.csv").write_text(HEADER + ROWS)
    (found,) = read_any(tmp_path)
    assert found.notes[-1].startswith("study.csv is not read: ")


def test_a_way_of_cutting_that_does_nothing_is_said(tmp_path: Path) -> None:
    (recording,) = read_any(DATA / "gofitts.sd3", Reading(cut="bursts"))
    assert recording.notes[-1] == "cut 'bursts' has no effect: the file has trials of its own"
    (stream,) = read_any(DATA / "mouse.evemu", Reading(cut="whole"))
    assert not [note for note in stream.notes if "no effect" in note]


def test_a_misspelt_target_is_asked_about(tmp_path: Path) -> None:
    (tmp_path / "study_samples.csv").write_text(HEADER + ROWS)
    (tmp_path / "study_trials.csv").write_text("user,trial,targetx,Target_Y,width,block\nu,1,3,4,10,2\n")
    assert read(tmp_path / "study_samples.csv").notes == (
        "targets are unknown: no column target_x; did 'targetx' mean it?",
        "targets are unknown: no column target_y; did 'Target_Y' mean it?",
    )
