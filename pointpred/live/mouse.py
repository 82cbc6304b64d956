"""Moves the mouse of a real page along a recorded path, to test what the mouse does there."""

from __future__ import annotations

import math
import time
from collections import Counter
from typing import Any

import msgspec

from pointpred.errors import ParameterError
from pointpred.live.devtools import Page
from pointpred.live.replay_trials import Pacing
from pointpred.records import EventColumns

BUTTONS = {1: "left", 2: "right", 4: "middle", 8: "back", 16: "forward"}
"""Bits of W3C ``buttons`` and their names in the DevTools protocol."""


class Driven(msgspec.Struct, frozen=True):
    """How often the mouse was moved, pressed and released."""

    moves: int
    presses: int
    releases: int
    seconds: float


def drive_mouse(
    page: Page,
    events: EventColumns,
    *,
    speed: float = 1.0,
    offset: tuple[float, float] = (0.0, 0.0),
    scale: float = 1.0,
) -> Driven:
    """Move a page's mouse along events, pressing and releasing its buttons where they say so.

    A point goes to ``scale * (x, y) + offset``, CSS px of the viewport. ``speed``: 1 as recorded, infinity
    as fast as the browser takes it (some 2,000 a second). No command waits for the last one's result, so
    that the browser merges moves within a frame as it does for a real mouse. A button still held at the end
    is released there. Raises SourceError where the browser refuses a command or goes away, ParameterError
    for a speed or a scale that is not positive.
    """
    if not scale > 0.0:
        raise ParameterError(f"scale must be positive, received {scale!r}")
    pacing = Pacing(events.t, speed)
    counts: Counter[str] = Counter()
    rows, held, x, y, began = events.table.tolist(), 0, 0.0, 0.0, time.perf_counter()
    while due := pacing.take():
        for row in rows[due.start : due.stop]:
            x, y = (scale * value + shift for value, shift in zip(row[1:3], offset, strict=True))
            buttons = 0 if math.isnan(row[5]) else int(row[5])
            for command in _commands(x, y, held, buttons):
                counts[command["type"]] += 1
                page.send("Input.dispatchMouseEvent", **command)
            held = buttons
    if held:
        for command in _commands(x, y, held, 0):
            counts[command["type"]] += 1
            page.send("Input.dispatchMouseEvent", **command)
    page.wait_for_results()
    moves, presses, releases = (counts[kind] for kind in ("mouseMoved", "mousePressed", "mouseReleased"))
    return Driven(moves, presses, releases, time.perf_counter() - began)


def _commands(x: float, y: float, held: int, buttons: int) -> list[dict[str, Any]]:
    """The commands for a move, or for a change of buttons."""
    place = {"x": x, "y": y, "pointerType": "mouse"}
    drag = next((name for bit, name in BUTTONS.items() if held & bit), "none")
    commands: list[dict[str, Any]] = []
    if buttons == held:
        return [{"type": "mouseMoved", "button": drag, "buttons": held, **place}]
    for bit, name in BUTTONS.items():
        if (held ^ buttons) & bit:
            kind = "mousePressed" if buttons & bit else "mouseReleased"
            held ^= bit
            commands.append({"type": kind, "button": name, "buttons": held, "clickCount": 1, **place})
    return commands
