"""XDF with a mouse and the accelerometer on it: its samples stand beside the events of each trial."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pointpred import build, run
from pointpred.batch.digests import digest
from pointpred.batch.plan import plan
from pointpred.recording import Recording
from pointpred.records import EventColumns
from pointpred.scoring import score
from pointpred.sources import Reading, convert, read_any
from pointpred.sources.trials.samples import samples_of_trials
from tests.unit.writing_containers import chunk, clock_offset, stream_header, stream_samples

STANDARD_GRAVITY = 9.80665
MOUSE_T = np.concatenate([1.0 + 0.01 * np.arange(30), 3.0 + 0.01 * np.arange(30)])
"""Two bursts, from 1 and from 3 s on the recorder's clock."""
SAMPLE_T = 0.5 + 0.005 * np.arange(600)


def mouse(number: int = 1) -> list[bytes]:
    way = np.tile(np.arange(30.0) ** 2, 2)
    rows = list(zip(way.tolist(), (0.5 * way).tolist(), strict=True))
    return [
        stream_header(number, "Pointer", "Mouse", ["x", "y"]),
        stream_samples(number, MOUSE_T.tolist(), rows),
    ]


def accelerometer(
    number: int,
    kind: str = "ACC",
    labels: tuple[str, ...] = ("X", "Y", "Z"),
    unit: str = "m/s^2",
    gravity: float = 9.81,
    times: Any = SAMPLE_T,
    offset: float | None = None,
) -> list[bytes]:
    """A stream whose x is the number of the sample / 100 and whose z is gravity; a gyroscope's are 7."""
    rows = [
        tuple(
            7.0 if label.startswith("gyr") else {"x": at / 100.0, "y": 0.0, "z": gravity}[label[-1].lower()]
            for label in labels
        )
        for at in range(len(times))
    ]
    offsets = [clock_offset(number, t, offset) for t in (0.0, 5.0) if offset is not None]
    head = stream_header(number, f"Sensor {number}", kind, list(labels), unit=unit)
    # A chunk says in one byte how many samples it has up to 255, else in four.
    return [head, *offsets, stream_samples(number, list(times), rows)]


def written(path: Path, *streams: list[bytes]) -> Path:
    parts = [b"XDF:", chunk(1, b"<?xml version='1.0'?><info><version>1.0</version></info>")]
    path.write_bytes(b"".join([*parts, *(part for stream in streams for part in stream)]))
    return path


def the_recording(path: Path, *streams: list[bytes], reading: Reading | None = None) -> Recording:
    (recording,) = read_any(written(path, *streams), reading or Reading())
    return recording


def test_each_trial_has_the_samples_since_the_row_before_it(tmp_path: Path) -> None:
    recording = the_recording(tmp_path / "two.xdf", mouse(), accelerometer(2))
    assert len(recording.trials) == 2
    first, second = (recording.rows(k) for k in (0, 1))
    begins = 1.0, 3.0
    for events, begin, since in ((first, begins[0], 0.0), (second, begins[1], MOUSE_T[29])):
        beside = events.accelerations
        ends = begin + events.t[-1] + 1e-12
        wanted = SAMPLE_T[(since < SAMPLE_T) & (ends >= SAMPLE_T)]
        np.testing.assert_allclose(beside.table[:, 0], wanted - begin, atol=1e-9)
        np.testing.assert_allclose(beside.table[:, 1], (np.flatnonzero(np.isin(SAMPLE_T, wanted))) / 100.0)
        np.testing.assert_allclose(beside.table[:, 3], 9.81)
        later = np.searchsorted(beside.table[:, 0], events.t, side="right")
        assert beside.before.tolist() == later.tolist()
    assert any("accelerometer on the mouse: stream Sensor 2" in note for note in recording.notes)
    assert not any("left aside: Sensor" in note for note in recording.notes)


def test_a_trial_has_at_most_ten_seconds_of_samples_before_it() -> None:
    samples = np.column_stack([np.arange(0.0, 60.0, 0.5), np.ones((120, 3))])
    clock = np.array([50.0, 50.1, 50.2, 58.0, 58.1])
    parts = samples_of_trials(samples, clock, np.array([0, 1, 3, 4]), np.array([0, 0, 1, 1]), 3)
    assert parts[0][[0, -1], 0].tolist() == [-9.5, 0.0]
    assert parts[1][[0, -1], 0].tolist() == [-7.5, 0.0]  # since the row at 50.2 s, which is in no trial
    assert parts[2].shape == (0, 4)


def test_clock_offsets_of_both_streams_are_removed(tmp_path: Path) -> None:
    moved = accelerometer(2, times=SAMPLE_T - 40.0, offset=40.0)
    plain = the_recording(tmp_path / "a.xdf", mouse(), accelerometer(2)).events.accelerations
    other = the_recording(tmp_path / "b.xdf", mouse(), moved).events.accelerations
    np.testing.assert_allclose(other.table, plain.table, atol=1e-6)


@pytest.mark.parametrize(
    ("unit", "gravity", "scale", "words"),
    [
        ("g", 1.0, STANDARD_GRAVITY, "unit g as stated"),
        ("mg", 1000.0, 1e-3 * STANDARD_GRAVITY, "unit mg as stated"),
        ("m/s²", 9.81, 1.0, "as stated"),
        ("", 1.02, STANDARD_GRAVITY, "unit g, since gravity is"),
        ("", 9.7, 1.0, "unit m/s^2, since gravity is"),
    ],
)
def test_units_are_as_stated_else_as_gravity_says(
    unit: str, gravity: float, scale: float, words: str, tmp_path: Path
) -> None:
    times = SAMPLE_T[:110]  # x stays small beside gravity
    streams = mouse(), accelerometer(2, unit=unit, gravity=gravity, times=times)
    recording = the_recording(tmp_path / "a.xdf", *streams)
    np.testing.assert_allclose(recording.events.accelerations.table[:, 3], gravity * scale)
    assert any(words in note for note in recording.notes)


@pytest.mark.parametrize(
    ("streams", "words"),
    [
        ([accelerometer(2, unit="counts")], "its unit 'counts' is none of m/s"),
        ([accelerometer(2, unit="", gravity=40.0)], "its median of 40.1 is gravity in none of"),
        (
            [accelerometer(2), accelerometer(3)],
            "2 streams may be the accelerometer on the mouse, none is used",
        ),
        ([accelerometer(2, times=[])], "no accelerometer: "),
    ],
)
def test_what_is_not_certain_is_not_used_and_a_note_says_why(
    streams: list[list[bytes]], words: str, tmp_path: Path
) -> None:
    recording = the_recording(tmp_path / "a.xdf", mouse(), *streams)
    assert len(recording.events.accelerations) == 0
    assert any(words in note for note in recording.notes), recording.notes


def test_the_channels_of_an_imu_are_found_by_their_labels(tmp_path: Path) -> None:
    labels = ("gyr_x", "gyr_y", "gyr_z", "Acc_X", "Acc_Y", "Acc_Z")
    imu = accelerometer(2, "IMU", labels)
    recording = the_recording(tmp_path / "a.xdf", mouse(), imu)
    np.testing.assert_allclose(recording.events.accelerations.table[:, 3], 9.81)
    gyroscope = accelerometer(2, "GYRO")
    assert len(the_recording(tmp_path / "b.xdf", mouse(), gyroscope).events.accelerations) == 0


def test_a_clock_of_the_rows_that_is_not_the_recorders_has_no_samples(tmp_path: Path) -> None:
    rows = [(1000.0 * t, float(i * i), 0.0) for i, t in enumerate(MOUSE_T[:30].tolist())]
    head = stream_header(1, "Pointer", "Mouse", ["device_ms", "x", "y"])
    stream = [head, stream_samples(1, MOUSE_T[:30].tolist(), rows)]
    reading = Reading(columns={"t": "device_ms", "x": "x", "y": "y"}, time_unit="ms")
    recording = the_recording(tmp_path / "a.xdf", stream, accelerometer(2), reading=reading)
    assert len(recording.events.accelerations) == 0
    assert any("the accelerometer is not used: its clock is time_stamps" in note for note in recording.notes)


def test_samples_that_run_backwards_or_are_no_numbers_are_left_out_and_counted(tmp_path: Path) -> None:
    times = SAMPLE_T.copy()
    times[200] = times[150]
    recording = the_recording(tmp_path / "a.xdf", mouse(), accelerometer(2, times=times))
    plain = the_recording(tmp_path / "b.xdf", mouse(), accelerometer(2))
    assert len(plain.events.accelerations) - len(recording.events.accelerations) == 1
    assert any("1 samples are stamped before the one before them: left out" in n for n in recording.notes)
    wild = accelerometer(2, gravity=float("nan"))
    recording = the_recording(tmp_path / "c.xdf", mouse(), wild)
    assert len(recording.events.accelerations) == 0
    assert any("600 samples are no numbers" in note for note in recording.notes)


def test_the_name_scores_a_recording_with_its_samples(tmp_path: Path) -> None:
    """From the file to the score by names alone, and the answers are those of the samples in the file."""
    recording = the_recording(tmp_path / "a.xdf", mouse(), accelerometer(2))
    parameters = {"minimum-jerk": {"differentiator": "inertial"}}
    (scored,) = score([recording], ["minimum-jerk"], parameters=parameters)
    assert [one.failed for one in scored.predictors if one.name == "minimum-jerk"] == [()]
    pipeline = build("minimum-jerk", differentiator="inertial")
    run(pipeline, recording.rows(0))
    sensed: Any = pipeline.differentiator
    assert sensed.sensor is not None


def test_a_chunk_with_other_samples_has_another_digest(tmp_path: Path) -> None:
    one = the_recording(tmp_path / "a.xdf", mouse(), accelerometer(2))
    two = the_recording(tmp_path / "a.xdf", mouse(), accelerometer(2, gravity=9.9))
    pipelines = {"hold": build("hold")}
    names = {digest(each, pipelines, plan(each, pipelines)) for each in (one, two)}
    assert len(names) == 2


def test_own_files_have_no_samples_and_say_so(tmp_path: Path) -> None:
    path = written(tmp_path / "a.xdf", mouse(), accelerometer(2))
    summary = convert(path, tmp_path / "own.parquet")
    samples = len(read_any(path)[0].events.accelerations)
    words = f"{samples} samples of an accelerometer are not written"
    assert any(words in note for note in summary.notes)
    (again,) = read_any(tmp_path / "own_samples.parquet")
    assert any(words in note for note in again.notes)
    assert isinstance(again.events, EventColumns)
    assert len(again.events.accelerations) == 0
