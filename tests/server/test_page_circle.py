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

from pointpred import RECOMMENDED, build
from pointpred.cli.app import app
from pointpred.protocol.scores import score_of
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.scoring import prepare, replay
from pointpred.targets import Target
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


class Finished:
    """What the page showed at the end of a run, and what it let be saved."""

    def __init__(self, visitor: Visitor, folder: Path) -> None:
        self.clicks = run_blocks(visitor)
        visitor.wait("!document.querySelector('#circle-result').hidden")
        # each movement's score comes by the socket, whenever the service has time for it
        visitor.wait(f"{every('#circle-rows tr', 'one.dataset.px')}.every((px) => px !== undefined)")
        self.trial_px = [float(px) for px in visitor.value(every("#circle-rows tr", "one.dataset.px"))][::-1]
        self.missed = visitor.value(every("#circle-rows tr", "one.classList.contains('missed')"))[::-1]
        tiles = every("#circle-tiles div", "[one.firstChild.textContent, one.lastChild.dataset.exact]")
        self.tiles = {name: float(exact) for name, exact in visitor.value(tiles)}
        self.file = download(visitor, folder)
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


def given_the_circle(file: Path) -> list[float]:
    """The time-averaged error of each movement of a recording where its targets are registered, px.

    The client sends places in steps of 1/64 px.
    """
    recording = read(file)
    centres = dict.fromkeys((trial.target_x, trial.target_y) for trial in recording.trials)
    corners = [[round(64.0 * (float(at) - WIDTH / 2)) / 64.0 for at in centre] for centre in centres]
    circle = [Target(str(i), x, y, WIDTH, WIDTH) for i, (x, y) in enumerate(corners)]
    errors = []
    for i, trial in enumerate(recording.trials):
        prepared = prepare(Recording.of("trial", [recording.rows(i)], [trial]), threads=1)
        own, floor = (
            replay(prepared, each, threads=1) for each in (build(RECOMMENDED, targets=circle), build("hold"))
        )
        errors.append(score_of(prepared, 0, own, floor).time_averaged_px or 0.0)
    return errors


def test_each_movement_was_scored_given_the_targets_of_the_circle(
    finished: Finished, scored: dict[str, Any]
) -> None:
    assert scored["trials"] == BLOCKS * TARGETS
    assert scored["skipped"] == []
    assert finished.trial_px == pytest.approx(given_the_circle(finished.file), rel=1e-9)
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
