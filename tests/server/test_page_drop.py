"""Recordings dragged onto the page by a real browser, good ones and others."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.recordings import write
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

SOURCE = "document.querySelector('#replay-source').dataset"
READOUT = "document.querySelector('#replay-readout').textContent"
LEAVE = """{
  const held = new DataTransfer();
  held.items.add(new File(["user,trial"], "one.csv"));
  document.body.dispatchEvent(new DragEvent("dragleave", { dataTransfer: held, bubbles: true }));
}"""
"""What a browser sends when what is dragged leaves its window, or is given up."""
OVER = "document.querySelector('#replay-drop').classList.contains('over')"


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at the replay view with its sample, who finds the page in order after whatever was dropped."""
    one.open(f"{url}#replay")
    one.wait("!document.querySelector('#replay-play').disabled")
    yield one
    assert one.value("location.href") == f"{url}#replay"
    assert one.complaints() == []
    assert not [address for address in one.asked() if address.startswith("ws")], "a file stays in the page"
    assert one.shift() < 0.001
    assert not one.value(OVER)


def drag(
    visitor: Visitor, kind: str, files: list[Path], part: str = "#replay-scene", words: str | None = None
) -> None:
    """One step of dragging files from the desktop, or words, over a part of the page."""
    left, top, width, height = visitor.corner(part)
    items = [] if words is None else [{"mimeType": "text/plain", "data": words}]
    data: dict[str, Any] = {"items": items, "files": [str(file) for file in files], "dragOperationsMask": 1}
    at = {"x": left + width / 2, "y": top + height / 2}
    visitor.hand.call("Input.dispatchDragEvent", type=kind, data=data, **at)


def drop(visitor: Visitor, files: list[Path], part: str = "#replay-scene") -> None:
    """Drag files over a part of the page and let go."""
    for kind in ("dragEnter", "dragOver", "drop"):
        drag(visitor, kind, files, part)


def study(folder: Path, trials: range = range(3, 6)) -> list[Path]:
    """The files of a recording: samples and trials."""
    whole = sample()
    told = [whole.trials[i] for i in trials]
    own = Recording.of("study", [whole.rows(i) for i in trials], told, provenance=whole.provenance)
    return list(write(own, folder / "study_samples.csv"))


def test_a_dropped_recording_is_shown(visitor: Visitor, tmp_path: Path) -> None:
    files = study(tmp_path)
    drag(visitor, "dragEnter", files)
    drag(visitor, "dragOver", files)
    assert visitor.value(OVER)
    drag(visitor, "drop", files)
    visitor.wait(f"{READOUT}.includes('Movement 1 of 3')")
    assert visitor.text("#replay-source").startswith("study: 3 movements.")


def test_the_mark_goes_when_the_files_leave_without_a_drop(visitor: Visitor, tmp_path: Path) -> None:
    files = study(tmp_path)
    drag(visitor, "dragEnter", files)
    drag(visitor, "dragOver", files)
    drag(visitor, "dragOver", files, "#replay-time")  # from the picture to another part: still over the page
    assert visitor.value(OVER)
    visitor.value(LEAVE)  # the protocol's dragCancel tells a page nothing
    assert not visitor.value(OVER)


HEAD = "user,trial,t_s,x_px,y_px\n"
SOUND = "".join(f"u,one,{i / 50},{i * i},0\n" for i in range(40))
FOREIGN = " is not pointpred's own CSV; the command pointpred convert makes one of it"
BAD = {
    "letter.txt": ("Dear Ann,\nall is well.\n", FOREIGN),
    "empty.csv": ("", FOREIGN),
    "short.csv": (f"{HEAD}u,one,0,1\n", ": row 0 has 4 cells, expected 5"),
    "words.csv": (
        f"{HEAD}u,one,zero,1,2\nu,one,1,1,2\n",
        ": 1 movement, none of which can be shown; u one: t_s in its row 0 is not a finite number",
    ),
    "backwards.csv": (
        f"{HEAD}u,one,1,1,2\nu,one,0,1,2\n",
        ": 1 movement, none of which can be shown; u one: the time decreases at its row 1",
    ),
    "nan.csv": (
        f"{HEAD}u,one,0,1,2\nu,one,1,NaN,2\n",
        ": 1 movement, none of which can be shown; u one: x_px in its row 1 is not a finite number",
    ),
    "half.csv": (f'# pointpred: {{"rows": 9}}\n{HEAD}{SOUND}', ": 40 rows, but its header says 9"),
    "torn.csv": (f'# pointpred: {{"rows"\n{HEAD}{SOUND}', ": its # pointpred: line is not JSON"),
    "list.csv": (f"# pointpred: null\n{HEAD}{SOUND}", ": its # pointpred: line is not a JSON object"),
    "night.parquet": ("PAR1\x15\x04\x15", FOREIGN),
    "trials.csv": ("user,trial,target_x,target_y\nu,one,1,2\n", " has trials but no samples"),
}
"""Files that cannot be opened, and what is said behind their names."""


@pytest.mark.parametrize("name", BAD)
def test_a_bad_file_is_named_with_the_reason_and_the_page_goes_on(
    visitor: Visitor, tmp_path: Path, name: str
) -> None:
    text, reason = BAD[name]
    (tmp_path / name).write_text(text, encoding="utf-8")
    before = visitor.value(READOUT)
    drop(visitor, [tmp_path / name])
    visitor.wait(f"{SOURCE}.state === 'failed'")
    said = visitor.text("#replay-source")
    assert f"{name}{reason}" in said
    assert "the embedded sample" in said, "what is still open"
    assert visitor.value(READOUT) == before
    visitor.value("document.querySelector('#replay-next').click()")
    visitor.wait(f"{READOUT}.includes('Movement 2 of')")
    drop(visitor, study(tmp_path))
    visitor.wait(f"{READOUT}.includes('Movement 1 of 3')")


def test_a_folder_is_named_as_one(visitor: Visitor, tmp_path: Path) -> None:
    (tmp_path / "week").mkdir()
    drop(visitor, [tmp_path / "week"])
    visitor.wait(f"{SOURCE}.state === 'failed'")
    assert "week cannot be read: is it a folder?" in visitor.text("#replay-source")


def test_two_recordings_at_once_are_refused(visitor: Visitor, tmp_path: Path) -> None:
    for name in ("monday.csv", "tuesday.csv"):
        (tmp_path / name).write_text(HEAD + SOUND, encoding="utf-8")
    drop(visitor, [tmp_path / "monday.csv", tmp_path / "tuesday.csv"])
    visitor.wait(f"{SOURCE}.state === 'failed'")
    assert "only one recording can be opened at a time, not monday.csv, tuesday.csv" in visitor.text(
        "#replay-source"
    )


def test_a_movement_that_cannot_be_predicted_does_not_stop_the_others(
    visitor: Visitor, tmp_path: Path
) -> None:
    """The first one has a position that no screen has; the second one is sound."""
    wild = "".join(f"u,wild,{i / 50},{1e300 * i},0\n" for i in range(5))
    (tmp_path / "wild.csv").write_text(HEAD + wild + SOUND, encoding="utf-8")
    drop(visitor, [tmp_path / "wild.csv"])
    visitor.wait("!document.querySelector('#replay-retry').hidden")
    assert "Movement 1" in visitor.value(READOUT)
    assert visitor.value("document.querySelector('#replay-play').disabled")
    visitor.value("document.querySelector('#replay-next').click()")
    visitor.wait(f"{READOUT}.includes('Movement 2 of 2')")
    assert not visitor.value("document.querySelector('#replay-play').disabled")


def test_words_that_are_dragged_are_left_to_the_browser(visitor: Visitor) -> None:
    visitor.value(
        "window.kept = []; addEventListener('dragover', (dragged) => kept.push(dragged.defaultPrevented))"
    )
    before = visitor.text("#replay-source")
    for kind in ("dragEnter", "dragOver"):
        drag(visitor, kind, [], words="a word")
    assert visitor.value("kept.length > 0 && !kept.some(Boolean)")
    assert visitor.text("#replay-source") == before


@pytest.mark.parametrize("view", ["live", "circle"])
def test_other_views_refuse_files_instead_of_giving_way_to_them(
    one: Visitor, url: str, tmp_path: Path, view: str
) -> None:
    one.open(f"{url}#{view}")
    one.wait(f"!document.querySelector('#view-{view} select').disabled")
    one.value(
        "window.kept = []; addEventListener('dragover', (dragged) => kept.push("
        "[dragged.defaultPrevented, dragged.dataTransfer.dropEffect, dragged.dataTransfer.types[0]]))"
    )
    drop(one, study(tmp_path), f"#{view}-scene")
    assert one.value("kept")[0] == [True, "none", "Files"]
    assert one.value("location.hash") == f"#{view}"
    assert one.complaints() == []
