"""A small study for tests, and movements as its page sends them."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.studies.folder import Participant, Study
from pointpred.studies.messages import Agreed, Answered, Moved, PageAbout

DESIGN = """
name = "pointing"
participants = 3
title = "A study"
consent = "I agree."
instructions = "Click."
tasks = ["circle", "reciprocal"]
distances_px = [200]
widths_px = [20, 40]
movements = 3
break_s = 1
[[questions]]
name = "hand"
text = "Which hand?"
when = "before"
choices = ["left", "right"]
[[questions]]
name = "effort"
text = "How hard?"
kind = "number"
low = 0
high = 100
"""
PAGE = PageAbout("Chromium", "en", "fine", (1920.0, 1080.0), (1280.0, 720.0), 1.0, 16.7, 0.005)
CENTRE = (640.0, 360.0)


def study_in(folder: Path, design: str = DESIGN) -> Study:
    """A study whose design lies in a folder; its data beside it."""
    file = folder / "pointing.toml"
    file.write_text(design, encoding="utf-8")
    return Study(file)


def movement(one: Participant, number: int | None = None, *, hit: bool = True, t: float = 1.0) -> Moved:
    """The next movement of a participant: a straight line that ends in the target, or beside it."""
    done = one.done()
    following = one.next(done) or (1, 1)
    sequence = one.plan[following[0] - 1]
    at = sequence.places[(following[1] - 1) % len(sequence.places)]
    begin = (CENTRE[0] + at[0], CENTRE[1] + at[1])
    x, y, width = one.target_of(following, CENTRE)
    end = (x + (0.0 if hit else width), y)
    share = np.linspace(0.05, 1.0, 20)
    rows = [
        (t + s, begin[0] + s * (end[0] - begin[0]), begin[1] + s * (end[1] - begin[1]), None, None, 0)
        for s in share.tolist()
    ]
    start = (t, *begin, None, None, 1)
    return Moved(len(done) if number is None else number, CENTRE, start, rows, 1.7e9 + t, hit, 1)  # type: ignore[arg-type]


def take_part(one: Participant, movements: float = math.inf, **about: Any) -> None:
    """Agree, answer, and do so many movements, or all."""
    one.take(Agreed(PAGE))
    one.take(Answered("before", {"hand": "left"}))
    t = 1.0
    while movements > 0 and one.next(one.done()) is not None:
        one.take(movement(one, t=t, **about))
        movements, t = movements - 1, t + 2.0
    if one.next(one.done()) is None:
        one.take(Answered("after", {"effort": "40"}))
