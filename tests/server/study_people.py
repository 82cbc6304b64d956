"""Participants of a study in a real browser, and its service as a process that can be killed."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from tests.server.page_browser import Visitor, until

GOAL = """document.querySelector("#task").hidden ? null
  : JSON.parse(document.querySelector("#task-scene").dataset.target ?? "null")"""
SHEET = "document.querySelector('#sheet').hidden ? '' : document.querySelector('#sheet-title').textContent"
TROUBLE = "document.querySelector('#task-trouble').textContent"
FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


class Served:
    """``pointpred study serve`` on one port, whichever process answers there."""

    def __init__(self, design: Path) -> None:
        self.design = design
        self.links: dict[str, str] = {}
        self._process: subprocess.Popen[str] | None = None
        self._port = "0"

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
            if code == "P02":
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
    """A participant at the page of a study: a hand of least jerk, which misses some targets."""

    def __init__(self, visitor: Visitor, link: str, seed: int, seconds: float = 0.12) -> None:
        self.visitor = visitor
        self.link = link
        self.clicks = 0
        self._rng = np.random.default_rng(seed)
        self._seconds = seconds
        self._place = (10.0, 10.0)

    def open(self) -> None:
        """Open the link, or open it again."""
        self.visitor.open(self.link)

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
            title, goal = self.visitor.value(f"[{SHEET}, {GOAL}]")
            return (title, goal) if goal or title not in ("", "One moment…") else None

        found: tuple[str, dict[str, Any] | None] = until(asked, "a sheet or a target")
        return found

    def _answer(self) -> None:
        page = self.visitor.page
        for radio in page.query_selector_all("#sheet-form [type=radio]")[:1]:
            radio.check()
        for number in page.query_selector_all("#sheet-form [type=number]"):
            number.fill("40")
        page.click("#sheet-form [type=submit]:enabled")
        self.visitor.value(FRAMES)

    def _click(self, goal: dict[str, Any]) -> None:
        left, top, *_ = self.visitor.corner("#task-scene")
        x, y = self._rng.normal(0.0, goal["width"] / 4.0 if goal["running"] else 0.0, 2)
        end = left + goal["x"] + round(x), top + goal["y"] + round(y)
        self.visitor.reach(self._place, end, self._seconds)
        self.visitor.click(*end)
        self._place, self.clicks = end, self.clicks + 1
        self.visitor.value(FRAMES)


def rows_of(file: Path) -> list[dict[str, Any]]:
    """The participants' state as ``pointpred study status --json`` tells it."""
    command = [sys.executable, "-m", "pointpred", "study", "status", str(file), "--json"]
    told = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    rows: list[dict[str, Any]] = json.loads(told)["participants"]
    return rows
