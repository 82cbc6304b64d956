"""libinput's YAML is read line by line: as a YAML library reads it, and a damaged line costs itself alone."""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import numpy as np
import pytest
import yaml

from pointpred.errors import RecordingError
from pointpred.recordings.formats import libinput
from tests.building import text_file

MOUSE = """# libinput record
ndevices: 2
libinput: {version: "1.25.0"}
devices:
- evdev: {name: "Mouse"}
  events:
  - evdev:
    - [0, 0, 2, 0, 3]
    - [0, 0, 0, 0, 0]
    - [0, 8000, 2, 0, 4]
    - [0, 8000, 0, 0, 0]
"""
BROKEN = """- evdev: {name: "Lost"}
  events:
  - evdev:
    - [0, 0, broken]
"""
STILL = """- evdev: {name: "Keyboard"}
  events:
  - evdev:
    - [0, 0, 1, 30, 1]
    - [0, 0, 0, 0, 0]
"""
UNREAD = "events that cannot be read, left aside: 1"


def written(folder: Path, text: str) -> Path:
    return text_file(folder / "devices.yml", text)


def generated(seed: int, frames: int) -> str:
    """A recording of two mice as libinput writes it, with other entries between the events."""
    generator = np.random.default_rng(seed)
    text = "# libinput record\nversion: 1\nndevices: 2\nlibinput:\n  version: 1.25\ndevices:\n"
    for device in range(2):
        text += f"- node: /dev/input/event{device}\n  evdev:\n    # Name: x\n    name: 'Mouse {device}'\n"
        text += "    absinfo:\n      0: [0, 1, 2, 3, 4]\n  hid: [\n    0x05, 0x01\n  ]\n  events:\n"
        text += "  # Current time is 12:00:00\n"
        for time, (x, y) in enumerate(generator.integers(-300, 300, (frames, 2)).tolist()):
            stamp = f"{time // 125:3d}, {time % 125 * 8000:6d}"
            text += f"  - evdev:\n    - [{stamp},   2,   0, {x:7d}] # EV_REL / REL_X\n"
            text += f"    - [{stamp},   2,   1, {y:7d}]\n    - [{stamp},   0,   0,       0] # -- +8ms\n"
            text += f"  - libinput:\n    - {{time: {time}.5, type: POINTER_MOTION}}\n"
            text += f"  - hid:\n      time: [0, {time}]\n      hidraw0: [0x01, 0x04]\n"
    return text + "system: {os: x}\n"


@pytest.mark.parametrize("seed", [1, 2])
def test_counts_and_times_are_those_that_a_yaml_library_finds(tmp_path: Path, seed: int) -> None:
    text = generated(seed, 40)
    devices = yaml.load(text, Loader=yaml.CSafeLoader)["devices"]
    recording = libinput.read(written(tmp_path, text))
    assert [trial.condition["device"] for trial in recording.trials] == ["Mouse 0", "Mouse 1"]
    assert recording.notes == ()
    for index, device in enumerate(devices):
        rows = np.array([row for entry in device["events"] for row in entry.get("evdev", [])])
        x, y = (rows[(rows[:, 2] == 2) & (rows[:, 3] == axis)] for axis in (0, 1))
        found = recording.rows(index).table
        np.testing.assert_array_equal(found[:, 3], x[:, 4])
        np.testing.assert_array_equal(found[:, 4], y[:, 4])
        np.testing.assert_allclose(found[:, 0], x[:, 0] + x[:, 1] / 1e6, rtol=0, atol=1e-9)


def test_memory_grows_with_the_frames_and_not_with_the_text(tmp_path: Path) -> None:
    path = written(tmp_path, generated(3, 4000))
    tracemalloc.start()
    libinput.read(path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 5 * path.stat().st_size


def test_a_line_that_cannot_be_read_costs_itself_alone(tmp_path: Path) -> None:
    recording = libinput.read(written(tmp_path, MOUSE + BROKEN))
    assert len(recording.events) == 2
    assert any(note.startswith(UNREAD) and "line 15" in note for note in recording.notes)
    cut = libinput.read(written(tmp_path, MOUSE + "    - [0, 16000, 2, 0,"))
    assert len(cut.events) == 2
    assert any(note.startswith(UNREAD) for note in cut.notes)
    with pytest.raises(RecordingError, match=UNREAD):
        libinput.read(written(tmp_path, MOUSE[: MOUSE.index("- evdev")] + BROKEN))


def test_a_still_device_is_a_note_and_only_still_ones_are_an_error(tmp_path: Path) -> None:
    said = "device Keyboard: no relative motion in 2 events, expected REL_X or REL_Y in a complete frame"
    assert said in libinput.read(written(tmp_path, MOUSE + STILL)).notes
    alone = MOUSE[: MOUSE.index("- evdev")] + STILL
    with pytest.raises(RecordingError, match=said):
        libinput.read(written(tmp_path, alone))


@pytest.mark.parametrize("text", ["- evdev: {name: [\n", "- 5\n", "-\n"])
def test_what_a_device_says_of_itself_may_be_damaged(tmp_path: Path, text: str) -> None:
    with pytest.raises(RecordingError, match=r"devices\.yml: "):
        libinput.read(written(tmp_path, MOUSE[: MOUSE.index("- evdev")] + text))


def test_a_file_without_devices_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="no devices"):
        libinput.read(written(tmp_path, MOUSE[: MOUSE.index("- evdev")]))


def test_a_device_that_is_no_yaml_list_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "mouse.yml"
    path.write_text("libinput:\ndevices:\n---\n", encoding="utf-8")
    with pytest.raises(RecordingError, match="no YAML in the device from line 3"):
        libinput.read(path)
