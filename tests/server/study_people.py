"""Participants of a study in a real browser, and its service as a process that can be killed."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numpy as np
from playwright.sync_api import Error

from pointpred.errors import SourceError
from pointpred.simulation.circle import SETUP
from pointpred.simulation.movement import Aim, move
from pointpred.simulation.person import Person
from pointpred.studies.design import read_design
from tests.server.page_browser import Visitor, until

GOAL = """document.querySelector("#task").hidden ? null
  : JSON.parse(document.querySelector("#task-scene").dataset.target ?? "null")"""
SHEET = "document.querySelector('#sheet').hidden ? '' : document.querySelector('#sheet-title').textContent"
LOADED = """new Promise((done) => {
  const end = performance.now() + 3000;
  (function look() {
    if (document.title !== "Study" || performance.now() > end) done(document.title !== "Study");
    else setTimeout(look, 50);
  })();
})"""
"""Whether the page's own modules have come, too."""
TROUBLE = "document.querySelector('#task-trouble').textContent"
FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


class Served:
    """``pointpred study serve`` on one port, whichever process answers there."""

    def __init__(self, design: Path) -> None:
        self.design = design
        self.links: dict[str, str] = {}
        self._process: subprocess.Popen[str] | None = None
        self._port, self._last = "0", read_design(design).codes[-1]

    def start(self) -> None:
        """Start, at the port of before where there was one, and wait for the links."""
        command = [
            sys.executable,
            "-m",
            "pointpred",
            "study",
            "serve",
            str(self.design),
            "--port",
            self._port,
        ]
        self._process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        assert self._process.stdout is not None
        for line in self._process.stdout:
            code, link = line.split()
            self.links[code] = link
            if code == self._last:
                break
        self._port = link.split(":")[2].split("/")[0]

    def kill(self) -> None:
        """End it as a crash or a loss of power does."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            assert self._process.stdout is not None
            self._process.stdout.close()


@contextmanager
def served(design: Path) -> Iterator[Served]:
    """The service of a study until the block ends."""
    service = Served(design)
    service.start()
    try:
        yield service
    finally:
        service.kill()


class Hand:
    """A participant at the page of a study, who misses some targets.

    A hand of least jerk in little time, or that of a simulated ``person`` in theirs.
    """

    def __init__(self, visitor: Visitor, link: str, seed: int, person: Person | None = None) -> None:
        self.visitor = visitor
        self.link = link
        self.clicks = 0
        self._rng = np.random.default_rng(seed)
        self._person = person
        self._place = (10.0, 10.0)

    def open(self) -> None:
        """Open the link, or open it again, as often as it takes while the service is down."""
        for _ in range(20):
            with suppress(Error):
                self.visitor.open(self.link)
                if self.visitor.value(LOADED):
                    return
            time.sleep(1.0)
        raise AssertionError("the page cannot be opened")

    def go_on(self, clicks: int | None = None) -> str:
        """Do what the page asks for, so many clicks or to the end; returns the sheet that is shown, or ''."""
        while clicks is None or clicks > 0:
            title, goal = self._asked()
            if title == "The end":
                return title
            if goal is None:
                self._answer()
                continue
            self._click(goal)
            clicks = None if clicks is None else clicks - 1
        return ""

    def until_trouble(self) -> str:
        """Go on until the page cannot; returns what it says."""
        while not (words := self.visitor.value(TROUBLE)):
            if (goal := self.visitor.value(GOAL)) is not None:
                self._click(goal)
        return str(words)

    def _asked(self) -> tuple[str, dict[str, Any] | None]:
        def asked() -> Any:
            with suppress(SourceError):  # the page is loaded again
                title, goal = self.visitor.value(f"[{SHEET}, {GOAL}]")
                return (title, goal) if goal or title not in ("", "One moment…") else None
            return None

        found: tuple[str, dict[str, Any] | None] = until(asked, "a sheet or a target")
        return found

    def _answer(self) -> None:
        page = self.visitor.page
        if page.query_selector("#sheet-form [type=submit]:enabled") is None:
            return  # it counts down, or waits for the service
        for radio in page.query_selector_all("#sheet-form [type=radio]")[:1]:
            radio.check()
        for number in page.query_selector_all("#sheet-form [type=number]"):
            number.fill("40")
        self.visitor.value("document.querySelector('#sheet-form [type=submit]')?.click()")
        with suppress(SourceError):
            self.visitor.value(FRAMES)

    def _click(self, goal: dict[str, Any]) -> None:
        left, top, *_ = self.visitor.corner("#task-scene")
        target = left + goal["x"], top + goal["y"]
        if self._person is None or not goal["running"]:
            x, y = self._rng.normal(0.0, goal["width"] / 4.0 if goal["running"] else 0.0, 2)
            target = target[0] + round(x), target[1] + round(y)
            self.visitor.reach(self._place, target, 0.12)
        else:
            target = self._move(self._person, target, goal["width"])
        self.visitor.click(*target)
        self._place, self.clicks = target, self.clicks + 1
        self.visitor.value(FRAMES)

    def _move(self, person: Person, target: tuple[float, float], width: float) -> tuple[float, float]:
        """Play a simulated movement at 200 Hz without its reaction time; returns where it ends, whole px."""
        (x, y), start = target, self._place
        moved = move(person, SETUP, Aim(x - start[0], y - start[1], width), self._rng).events(start).table
        path = moved[(moved[:, 3:5] != 0.0).any(axis=1)][::5]
        began = time.perf_counter() - path[0, 0]
        for t, *at in path[:, :3].tolist():
            time.sleep(max(0.0, began + t - time.perf_counter()))
            self.visitor.mouse("mouseMoved", *at)
        return float(round(moved[-1, 1])), float(round(moved[-1, 2]))
