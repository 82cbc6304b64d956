"""A line of a device's recording that is cut or unknown costs itself alone, and a note counts it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pointpred.recordings import read_any

SOURCES = Path(__file__).parents[1] / "data/sources"
EVENT = {
    "mouse.evemu": "E: 9.000000 0002 0000 0012",
    "evtest.txt": "Event: time 1600000009.000000, type 2 (EV_REL), code 0 (REL_X), value 12",
    "libinput.yml": "    - [  9, 900000,   2,   0,      12]",
    "hid-recorder.txt": "E: 000009.000000 5 01 00 05 d0 ff",
}


@pytest.mark.parametrize("name", EVENT)
def test_a_last_line_that_is_cut_anywhere_costs_itself_alone(tmp_path: Path, name: str) -> None:
    whole = (SOURCES / name).read_text(encoding="utf-8")
    if name == "libinput.yml":
        whole = whole[: whole.index("- node: /dev/input/event6")]
    path = tmp_path / name
    path.write_text(whole, encoding="utf-8")
    [expected] = read_any(path)
    assert not any("cannot be read" in note for note in expected.notes)
    line = EVENT[name]
    counted = 0
    for size in range(1, len(line)):
        path.write_text(whole + line[:size], encoding="utf-8")
        [found] = read_any(path)
        np.testing.assert_array_equal(found.events.table, expected.events.table)
        counted += any("left aside: 1, the first is line" in note for note in found.notes)
    assert counted >= len(line) // 2


def test_lines_of_other_kinds_and_short_reports_of_hid_recorder_are_counted(tmp_path: Path) -> None:
    whole = (SOURCES / "hid-recorder.txt").read_text(encoding="utf-8")
    [expected] = read_any(SOURCES / "hid-recorder.txt")
    path = tmp_path / "hid-recorder.txt"
    more = "P: usb-0000:00:14.0-2/input0\nB: 000000.000100 x\nE: 000009.000000 2 01 00\nE: 000009.1\n"
    at = whole.index("I: ")
    path.write_text(whole[:at] + "P: usb\n" + whole[at:] + more, encoding="utf-8")
    [found] = read_any(path)
    np.testing.assert_array_equal(found.events.table, expected.events.table)
    assert sum("left aside: 3, the first is line 5 ('P: usb')" in note for note in found.notes) == 1
    assert sum("reports that cannot be read" in note for note in found.notes) == 2
