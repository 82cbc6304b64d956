"""A circle run by a simulated hand in a real browser: the page says what the saved recording says."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from pointpred import RECOMMENDED
from pointpred.cli.app import app
from pointpred.recordings import read
from tests.server import browser, page_browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

TARGETS, DISTANCE, WIDTH, BLOCKS = 7, 300.0, 40.0, 2
MISSED = 4
"""The movement that is ended beside its target."""


def aim(
    goal: dict[str, Any], corner: tuple[float, float], number: int, rng: np.random.Generator
) -> tuple[float, float]:
    """Where a hand presses: about the centre, once beside the target."""
    beside = 0.9 * goal["width"] if number == MISSED else 0.0
    x, y = rng.normal(0.0, goal["width"] / 8, 2)
    return corner[0] + goal["x"] + round(x) + beside, corner[1] + goal["y"] + round(y)


def run_blocks(visitor: Visitor) -> int:
    """Click every target until the page names none; returns how many clicks that took."""
    rng = np.random.default_rng(7)
    left, top, *_ = visitor.corner("#circle-scene")
    place, clicks = (left + 10.0, top + 10.0), 0
    goal = "document.querySelector('#circle-scene').dataset.target"
    while (wanted := json.loads(visitor.value(goal))) is not None:
        end = aim(wanted, (left, top), clicks, rng)
        visitor.reach(place, end, 0.22)
        visitor.click(*end)
        place, clicks = end, clicks + 1
        assert clicks <= 2 * BLOCKS * TARGETS, "the run does not end"
    return clicks


def download(visitor: Visitor, folder: Path) -> Path:
    """Save both files by their links; returns the samples file."""
    for part in ("samples", "trials"):
        with visitor.page.expect_download() as saved:
            visitor.value(f"document.querySelector('#circle-{part}').click()")
        saved.value.save_as(folder / saved.value.suggested_filename)
    return next(folder.glob("circle-*_samples.csv"))


def every(part: str, expression: str) -> str:
    """An expression of each element ``one`` that a selector finds."""
    return f"[...document.querySelectorAll({part!r})].map((one) => {expression})"


SEEN = f"""import('/web/lib/pointpred.js').then(({{ Connection }}) => {{
  window.seen = [];
  const on = Connection.prototype.on;
  Connection.prototype.on = function (name, hear) {{
    const note = ({{ t, x, y }}) => seen.push([t, x, y]);
    return on.call(this, name, name === "prediction" ? (told) => (note(told), hear(told)) : hear);
  }};
  for (const name of ["hold", "{RECOMMENDED}"]) {{
    const select = document.querySelector("#circle-predictor");
    select.value = name;
    select.dispatchEvent(new Event("change"));
  }}
}})"""
"""Notes what the page is told from now on: choosing another predictor and this one again connects anew."""


class Finished:
    """What the page showed at the end of a run, and what it let be saved."""

    def __init__(self, visitor: Visitor, folder: Path) -> None:
        self.clicks = run_blocks(visitor)
        visitor.wait("!document.querySelector('#circle-result').hidden")
        visitor.wait(f"{every('#circle-rows tr', 'one.dataset.px')}.every((px) => px !== undefined)")
        self.trial_px = [float(px) for px in visitor.value(every("#circle-rows tr", "one.dataset.px"))][::-1]
        self.missed = visitor.value(every("#circle-rows tr", "one.classList.contains('missed')"))[::-1]
        tiles = every("#circle-tiles div", "[one.firstChild.textContent, one.lastChild.dataset.exact]")
        self.tiles = {name: float(exact) for name, exact in visitor.value(tiles)}
        self.file = download(visitor, folder)
        self.seen = [[math.nan if v is None else v for v in one] for one in visitor.value("seen")]
        self.complaints = visitor.complaints()
        self.shift = visitor.shift()


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Finished]:
    with page_browser.service() as url, page_browser.visitor(tmp_path_factory.mktemp("profile")) as visitor:
        visitor.open(f"{url}#circle")
        visitor.wait("!document.querySelector('#circle-start').disabled")
        for name, value in {
            "targets": TARGETS,
            "distance": DISTANCE,
            "width": WIDTH,
            "blocks": BLOCKS,
        }.items():
            visitor.value(f"document.querySelector('[name={name}]').value = {value}")
        visitor.value(SEEN)
        visitor.wait("document.querySelector('#circle-connection').dataset.state === 'open'")
        visitor.value("document.querySelector('#circle-start').click()")
        yield Finished(visitor, tmp_path_factory.mktemp("downloads"))


@pytest.fixture(scope="module")
def scored(finished: Finished) -> dict[str, Any]:
    """The one set that the command line scores in the downloaded file."""
    said = CliRunner().invoke(app, ["score", str(finished.file), "--json", "-"])
    assert said.exit_code == 0, said.output
    [found] = json.loads(said.stdout)["sets"]
    return dict(found)


def test_every_movement_of_every_block_was_made(finished: Finished) -> None:
    assert finished.clicks == BLOCKS * (TARGETS + 1)
    assert len(finished.trial_px) == BLOCKS * TARGETS
    assert [i for i, missed in enumerate(finished.missed) if missed] == [MISSED - 1]
    assert finished.complaints == []
    assert finished.shift < 0.01


def shown_px(finished: Finished) -> list[float]:
    """How far what the page was told to show was from the end of each movement, time-averaged, px.

    At each sample the newest prediction since the movement began counts, before the first the pointer itself;
    from the last sample within 3 px of the start to the first after which it stays near the end.
    """
    recording, errors = read(finished.file), []
    for i, trial in enumerate(recording.trials):
        events = recording.rows(i)
        t, path = events.t, np.column_stack([events.x, events.y])
        started = float(trial.condition["started_s"])
        shown = [(s, x, y) for s, x, y in finished.seen if s > started]
        newest = np.searchsorted([s for s, *_ in shown], t, side="right") - 1
        point = np.array(
            [shown[k][1:] if k >= 0 else at for k, at in zip(newest.tolist(), path, strict=True)]
        ).astype(float)
        point = np.where(np.isnan(point), path, point)
        far = np.linalg.norm(path - path[-1], axis=1)
        onset = np.flatnonzero(np.linalg.norm(path - path[0], axis=1) <= 3.0)[-1]
        arrival = np.flatnonzero(far > max(8.0, 0.03 * far[onset]))[-1] + 1
        weight = np.minimum(np.diff(t), 0.05)[onset:arrival]
        errors.append(
            float(np.average(np.linalg.norm(point - path[-1], axis=1)[onset:arrival], weights=weight))
        )
    return errors


def test_each_row_says_what_was_shown_during_its_movement(finished: Finished, scored: dict[str, Any]) -> None:
    assert scored["trials"] == BLOCKS * TARGETS
    assert scored["skipped"] == []
    assert finished.trial_px == pytest.approx(shown_px(finished), rel=1e-9)
    [alone] = [one for one in scored["predictors"] if one["name"] == "kinematic"]
    assert np.mean(finished.trial_px) < 0.7 * alone["time_averaged"]["px"]


def test_the_recording_says_who_moved_towards_what(finished: Finished) -> None:
    recording = read(finished.file)
    assert recording.skipped == ()
    assert recording.notes == ()
    assert len(recording.trials) == BLOCKS * TARGETS
    assert recording.provenance.clock == "seconds of the browser's clock"
    for i, trial in enumerate(recording.trials):
        events = recording.rows(i)
        assert trial.target_w == WIDTH
        assert trial.condition["block"] == 1 + i // TARGETS
        off = math.hypot(events.x[-1] - trial.target_x, events.y[-1] - trial.target_y)
        assert (off <= WIDTH / 2) == (trial.condition["hit"] == 1.0) == (i != MISSED - 1)
        assert events.buttons[-1] == 1.0
        assert trial.condition["started_s"] <= events.t[0]


def test_iso_statistics_are_those_of_the_recording(finished: Finished) -> None:
    """Worked out from the files with the standard's formulas, without the page's code."""
    recording = read(finished.file)
    blocks: dict[float, list[tuple[float, float, float]]] = {}
    for i, trial in enumerate(recording.trials):
        events, told = recording.rows(i), trial.condition
        origin = np.array([told["from_x"], told["from_y"]], dtype=float)
        goal = np.array([trial.target_x, trial.target_y])
        axis = (goal - origin) / np.linalg.norm(goal - origin)
        end = np.array([events.x[-1], events.y[-1]]) @ axis
        start = np.array([told["start_x"], told["start_y"]], dtype=float) @ axis
        seconds = float(events.t[-1]) - float(told["started_s"])
        blocks.setdefault(float(told["block"]), []).append((end - goal @ axis, end - start, seconds))
    throughputs, widths, distances, times = [], [], [], []
    for rows in blocks.values():
        beside, way, seconds = np.array(rows).T
        widths.append(4.133 * np.std(beside, ddof=1))
        distances.append(way.mean())
        throughputs.append(math.log2(way.mean() / widths[-1] + 1.0) / seconds.mean())
        times += seconds.tolist()
    tiles = finished.tiles
    assert tiles["Throughput"] == pytest.approx(np.mean(throughputs), rel=1e-9)
    assert tiles["Effective width"] == pytest.approx(np.mean(widths), rel=1e-9)
    assert tiles["Effective distance"] == pytest.approx(np.mean(distances), rel=1e-9)
    assert tiles["Movement time"] == pytest.approx(np.mean(times), rel=1e-9)
    assert tiles["Errors"] == pytest.approx(1 / (BLOCKS * TARGETS))


def test_files_begin_with_the_header_and_have_a_row_an_event(finished: Finished) -> None:
    with finished.file.open(encoding="utf-8") as file:
        mark, _, said = file.readline().partition("# pointpred: ")
        rows = list(csv.DictReader(file))
    assert mark == ""
    assert json.loads(said)["rows"] == len(rows) > 10 * BLOCKS * TARGETS
