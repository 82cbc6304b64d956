"""Every foreign format from a hand-written file whose numbers were worked out by hand."""

from pathlib import Path

import numpy as np
import pytest

from pointpred.errors import ParameterError, RecordingError
from pointpred.recording import Recording, Skip
from pointpred.recordings import (
    FORMATS,
    Reading,
    format_of,
    read_any,
)

DATA = Path(__file__).parents[1] / "data" / "sources"
NONE = float("nan")


def one(name: str, reading: Reading | None = None) -> Recording:
    (recording,) = read_any(DATA / name) if reading is None else read_any(DATA / name, reading)
    return recording


def rows(recording: Recording) -> list[list[float]]:
    """t, x, y, buttons of all events, t in whole microseconds."""
    table = recording.events.table
    return np.column_stack([np.round(table[:, 0] * 1e6), table[:, 1], table[:, 2], table[:, 5]]).tolist()


def test_gofitts() -> None:
    recording = one("gofitts.sd3")
    assert rows(recording) == [
        [0, 101, 300, 0], [8000, 150, 305, 0], [20000, 297, 302, 0],
        [0, 112, 308, 0], [16000, 298, 301, 0],
    ]  # fmt: skip
    first = recording.trials[0]
    assert (first.user, first.target_x, first.target_y, first.target_w) == ("P01", 300.0, 300.0, 40.0)
    assert (first.condition["A"], first.condition["from_x"], first.condition["Block"]) == (
        200.0,
        100.0,
        "B04",
    )
    assert recording.skipped == (
        Skip("S03 B04 1 1", "2 times, 2 x and 1 y, expected as many of each", 3, "P01"),
    )
    assert np.isnan(recording.events.dx).all()


def test_balabit_is_cut_from_click_to_click() -> None:
    recording = one("user7/session_0000000001")
    assert rows(recording) == [
        [0, 100, 200, 0], [250000, 110, 190, 0], [250000, 120, 185, 0], [500000, 120, 185, 1],
        [0, 130, 185, 0], [250000, 140, 180, 0], [750000, 150, 180, 2],
    ]  # fmt: skip
    assert [trial.condition["begins_s"] for trial in recording.trials] == [10.0, 11.0]
    assert {trial.user for trial in recording.trials} == {"user7"}
    assert recording.skipped == (
        Skip("rows 4 to 4", "a button is held", 4, "user7"),
        Skip("rows 12 to 13", "no click ends it", 12, "user7"),
        Skip("2", "x is 65535, the logger had no position", 10, "user7"),
    )
    assert recording.notes == ("wheel rows left aside: 1",)


def test_sapimouse_counts_milliseconds() -> None:
    recording = one("user7/session_2020_05_14_1min.csv")
    assert rows(recording) == [
        [0, 10, 20, 0], [8000, 14, 23, 0], [16000, 14, 23, 1],
        [0, 14, 23, 0], [8000, 20, 31, 0], [150000, 22, 31, 1],
    ]  # fmt: skip
    assert recording.skipped == ()
    assert recording.provenance.clock == "the client's clock, ms"


def test_a_sample_at_an_infinite_time_is_left_out_and_named(tmp_path: Path) -> None:
    text = (DATA / "user7" / "session_2020_05_14_1min.csv").read_text(encoding="utf-8")
    path = tmp_path / "session"
    path.write_text(text.replace("8,NoButton,Move,14", "1e999,NoButton,Move,14", 1), encoding="utf-8")
    (recording,) = read_any(path)
    assert recording.skipped == ()
    assert rows(recording) == [
        [0, 10, 20, 0], [16000, 14, 23, 1],
        [0, 14, 23, 0], [8000, 20, 31, 0], [150000, 22, 31, 1],
    ]  # fmt: skip
    why = "t (client timestamp) is 'inf', expected a number"
    assert recording.notes == (f"rows left out: 1, the first is data row 1: {why}",)


@pytest.mark.parametrize("name", ["jspsych.json", "jspsych.csv"])
def test_jspsych(name: str) -> None:
    recording = one(name)
    assert rows(recording) == [
        [0, 10, 20, 0], [16000, 16, 28, 0], [100000, 100, 60, 1], [160000, 100, 60, 0],
        [0, 5, 5, 0], [17000, 9, 2, 0],
    ]  # fmt: skip
    only, among = recording.trials
    assert (only.user, only.trial) == ("s9", "1")
    assert only.condition == {"trial_type": "html-button-response", "targets": 1.0}
    assert np.isnan([only.target_x, among.target_x]).all()
    assert recording.notes[0] == "1 of 3 rows track no mouse"


def test_mousetrap_with_and_without_brackets() -> None:
    recording = one("mousetrap.csv")
    assert rows(recording) == [
        [0, 0, 350, 0], [10000, 3, 340, 0], [20000, -200, -300, 0],
        [0, 5, 348, 0], [10000, 5, 340, 0], [25000, 250, -310, 0],
    ]  # fmt: skip
    assert [(trial.user, trial.trial) for trial in recording.trials] == [("4", "0"), ("4", "2")]
    assert recording.skipped == (Skip("1", "no movement: every position equals the first", 1, "4"),)
    assert recording.notes == ("rows without lists of times and positions: 1",)
    assert (recording.provenance.origin, recording.provenance.y_axis) == ("centre of the screen", "down")


def test_psychopy_turns_y() -> None:
    recording = one("psychopy.csv")
    assert rows(recording) == [
        [0, -100, -50, 0], [16000, -60.5, -50, 0], [250000, 40, 20, 1],
        [0, 0, 0, 0], [500000, 8, -4, 3],
    ]  # fmt: skip
    assert (recording.provenance.y_axis, recording.provenance.unit) == ("up", "px")


@pytest.mark.parametrize(
    ("reading", "gain"),
    [
        (Reading(px_per_unit=900.0), (900, 900)),
        (Reading(px_per_unit=(800.0, 450.0)), (800, 450)),
    ],
)
def test_psychopy_in_the_units_of_the_experiment(reading: Reading, gain: tuple[float, float]) -> None:
    table = one("psychopy.csv", reading).events.table
    np.testing.assert_allclose(table[0, 1:3], [-100 * gain[0], -50 * gain[1]], rtol=1e-12)
    assert one("psychopy.csv", reading).provenance.unit == "told"


def test_psychopy_says_when_the_unit_cannot_be_pixels(tmp_path: Path) -> None:
    path = tmp_path / "height.csv"
    path.write_text('mouse.x,mouse.y,mouse.time\n"[-0.3, 0.4]","[0.1, 0.2]","[0.0, 0.1]"\n', encoding="utf-8")
    with pytest.raises(RecordingError, match="hardly pix"):
        read_any(path)
    (recording,) = read_any(path, Reading(px_per_unit=500.0))
    np.testing.assert_allclose(recording.events.y, [-50, -100], rtol=1e-12)


def test_pointing_dynamics_in_one_dimension() -> None:
    recording = one("P3/Data0,-1,512,16.csv", Reading(dpi=254.0))  # 10,000 px a metre
    np.testing.assert_allclose(recording.events.x, [0, 100, 990, 980, -500], rtol=1e-12)
    np.testing.assert_allclose(recording.events.t, [0, 0.002, 0.004, 0, 0.002], atol=1e-12)
    assert (recording.events.y == 0).all()
    np.testing.assert_allclose([trial.target_x for trial in recording.trials], [1000, -1000], rtol=1e-12)
    np.testing.assert_allclose([trial.target_w for trial in recording.trials], [40, 40], rtol=1e-12)
    assert recording.trials[0].user == "P3"
    assert recording.notes == ("columns left aside: sgv, sga",)


def test_evemu_counts_are_the_position() -> None:
    recording = one("mouse.evemu")
    expected = [
        [0.0, 3, -2, 3, -2, 0],
        [0.016, 7, -2, 4, 0, 0],
        [0.0, 7, 5, 0, 7, 0],
        [0.008, 2, 5, -5, 0, 0],
    ]
    np.testing.assert_allclose(recording.events.table, expected, atol=1e-12)
    assert recording.skipped == (Skip("rows 7 to 7", "no movement", 7, "unknown"),)
    assert recording.notes == ("frames without motion or button left aside: 1",)
    assert (recording.provenance.unit, recording.trials[0].condition["device"]) == (
        "counts",
        "Hand-made Mouse",
    )


def test_evemu_cut_at_clicks_and_as_a_whole() -> None:
    clicks = one("mouse.evemu", Reading(cut="clicks"))
    assert clicks.offsets.tolist() == [0, 3]
    assert [skip.reason for skip in clicks.skipped] == ["no click ends it"]
    assert len(one("mouse.evemu", Reading(cut="whole")).events) == 5


@pytest.mark.parametrize("name", ["evtest.txt", "libinput.yml"])
def test_other_kernel_events(name: str) -> None:
    table = one(name).events.table
    np.testing.assert_allclose(table[0], [0, 3, -2, 3, -2, 0], atol=1e-12)
    np.testing.assert_allclose(table[-1, 1:], [7, -2, 4, 0, 1], atol=1e-12)


def test_libinput_names_the_device_that_never_moves() -> None:
    (note,) = one("libinput.yml").notes
    assert note.startswith("device Hand-made Keyboard: no relative motion in 2 events")


def test_hid_recorder_decodes_signed_fields() -> None:
    recording = one("hid-recorder.txt")
    expected = [
        [0.0, 5, -3, 5, -3, 0],
        [0.001, 5 - 2048, 2047 - 3, -2048, 2047, 17],
        [0.002, 5 - 2048 - 300, 2047 - 3 + 256, -300, 256, 17],
    ]
    np.testing.assert_allclose(recording.events.table, expected, atol=1e-12)
    assert recording.notes == ("reports without motion or button left aside: 1",)


def test_dropped_kernel_events_cost_the_trial(tmp_path: Path) -> None:
    path = tmp_path / "lost.evemu"
    path.write_text(
        "E: 1.000000 0002 0000 3\nE: 1.000000 0000 0000 0\nE: 1.100000 0002 0000 9\nE: 1.100000 0000 0003 0\n"
        "E: 1.100000 0000 0000 0\nE: 1.200000 0002 0000 4\nE: 1.200000 0000 0000 0\n",
        encoding="utf-8",
    )
    (recording,) = read_any(path)
    assert recording.trials == ()
    assert recording.skipped == (Skip("0", "the kernel dropped events (SYN_DROPPED)", 2, "unknown"),)


def test_every_example_is_recognised_by_its_content(tmp_path: Path) -> None:
    found = set()
    for number, file in enumerate(sorted(DATA.rglob("*"))):
        if file.is_file():
            renamed = tmp_path / f"{number}.data"
            renamed.write_bytes(file.read_bytes())
            form = format_of(renamed)
            assert form is not None, file.name
            found.add(form.key)
    assert found == {form.key for form in FORMATS}


def test_an_unknown_file_names_every_format(tmp_path: Path) -> None:
    path = tmp_path / "letter.txt"
    path.write_text("Dear reader,\n", encoding="utf-8")
    with pytest.raises(RecordingError) as caught:
        read_any(path)
    assert all(form.title in str(caught.value) for form in FORMATS)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("least_samples", 1),
        ("least_s", -1.0),
        *(("dpi", dpi) for dpi in (0.0, 0.5, 1e6)),
        *(("cpi", cpi) for cpi in (-1.0, 0.5, 1e8, float("nan"))),
        ("px_per_unit", (0.0, 5.0)),
    ],
)
def test_reading_refuses_what_cannot_be(name: str, value: object) -> None:
    with pytest.raises(ParameterError, match=f"{name} must be .* received"):
        Reading(**{name: value})  # type: ignore[arg-type]
