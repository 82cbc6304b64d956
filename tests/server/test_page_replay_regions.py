"""The regions of a replay: those that Python gives for the same events, from the sample and from a file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pointpred import RECOMMENDED, build, run
from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.recordings import write
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

DRAWN = """
window.drawn = [];
const pen = CanvasRenderingContext2D.prototype;
const { ellipse, clearRect } = pen;
const ours = (one) => one.canvas.id === "replay-scene";
pen.clearRect = function (...box) {
  if (ours(this)) window.drawn = [];
  return clearRect.apply(this, box);
};
pen.ellipse = function (...about) {
  if (ours(this)) drawn.push(about.slice(0, 5));
  return ellipse.apply(this, about);
};
"""
"""Keeps centre, half axes and angle of each ellipse in the picture since it was last cleared."""
TRIAL = 30
READOUT = "document.querySelector('#replay-readout').textContent"


@pytest.fixture(scope="module")
def watched(one: Visitor) -> Visitor:
    """Somebody whose ellipses are kept."""
    one.page.add_init_script(DRAWN)
    return one


@pytest.fixture
def visitor(watched: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at the replay of one movement of the sample."""
    one = watched
    one.open(f"{url}#replay")
    one.wait("!document.querySelector('#replay-play').disabled")
    one.value(
        "{ const list = document.querySelector('#replay-trials');"
        f"list.selectedIndex = {TRIAL}; list.dispatchEvent(new Event('change')); }}"
    )
    one.wait(f"{READOUT}.includes('Movement {TRIAL + 1} of')")
    yield one
    assert one.complaints() == []


def ellipses(visitor: Visitor, share: float) -> tuple[int, list[list[float]]]:
    """The event that is shown at a share of the time, and the ellipses drawn for it, the larger first."""
    visitor.value(
        "{ const slider = document.querySelector('#replay-time');"
        f"slider.value = Math.round({share} * slider.max);"
        "slider.dispatchEvent(new Event('input')); }"
    )
    event = int(visitor.value("document.querySelector('#replay-scene').dataset.event"))
    found: list[list[float]] = visitor.value("drawn")
    return event, found


def regions(event: int) -> tuple[Any, Any]:
    """The regions of 80 and 50 % that Python gives after an event of the sample's movement."""
    whole = sample()
    pipeline = build(RECOMMENDED, cpi=whole.provenance.cpi, dpi=whole.provenance.dpi)
    prediction = run(pipeline, whole.rows(TRIAL))[event]
    assert prediction is not None
    return prediction.region(0.8), prediction.region(0.5)


def test_both_regions_are_those_of_python_on_the_picture_s_scale(visitor: Visitor) -> None:
    first, second = ellipses(visitor, 0.45), ellipses(visitor, 0.6)
    centres, axes = [], []
    for event, drawn in (first, second):
        wanted = regions(event)
        assert len(drawn) == 2
        for (*_, major, minor, angle), region in zip(drawn, wanted, strict=True):
            assert math.remainder(angle - region.angle, math.pi) == pytest.approx(0.0, abs=1e-3)
            axes.append([major / region.major, minor / region.minor])
        centres.append([*drawn[0][:2], wanted[0].x, wanted[0].y])
    (ax, ay, px, py), (bx, by, qx, qy) = centres
    scale = math.dist((ax, ay), (bx, by)) / math.dist((px, py), (qx, qy))
    assert np.allclose(axes, scale, rtol=2e-3)


def test_a_file_shows_the_same_regions_as_the_sample(visitor: Visitor, tmp_path: Path) -> None:
    shown = [ellipses(visitor, share) for share in (0.3, 0.45, 0.6, 0.9)]
    whole = sample()
    files = write(
        Recording.of("one", [whole.rows(TRIAL)], [whole.trials[TRIAL]], provenance=whole.provenance),
        tmp_path / "one_samples.csv",
    )
    visitor.give_files({file.name: file.read_text() for file in files})
    visitor.wait(f"{READOUT}.includes('Movement 1 of 1')")
    again = [ellipses(visitor, share) for share in (0.3, 0.45, 0.6, 0.9)]
    assert [event for event, _ in again] == [event for event, _ in shown]
    assert sum(len(drawn) for _, drawn in shown) >= 6
    for (_, one), (_, other) in zip(shown, again, strict=True):
        assert np.allclose(one, other, rtol=2e-3, atol=0.05)


def test_a_predictor_without_regions_has_none(visitor: Visitor) -> None:
    visitor.choose("#replay-predictor-0", "minimum-jerk")
    visitor.wait(f"{READOUT}.includes('minimum-jerk')")
    assert ellipses(visitor, 0.5)[1] == []
