"""A device that never moves is named by what was found, not by the words of an error."""

from __future__ import annotations

from pathlib import Path

import pytest

from pointpred.errors import RecordingError
from pointpred.sources import libinput

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
BROKEN = """- evdev: {name: "expected REL_X"}
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


def written(folder: Path, text: str) -> Path:
    path = folder / "devices.yml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_broken_device_is_an_error_whatever_it_is_called(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="device expected REL_X: entry 0 is"):
        libinput.read(written(tmp_path, MOUSE + BROKEN))


def test_a_still_device_is_a_note_and_only_still_ones_are_an_error(tmp_path: Path) -> None:
    said = "device Keyboard: no relative motion in 2 events, expected REL_X or REL_Y in a complete frame"
    assert said in libinput.read(written(tmp_path, MOUSE + STILL)).notes
    alone = MOUSE[: MOUSE.index("- evdev")] + STILL
    with pytest.raises(RecordingError, match=said):
        libinput.read(written(tmp_path, alone))
