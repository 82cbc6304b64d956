"""``onIntent`` beside js.foresight in one Chromium: ``python -m evidence intent browser [LAYOUT ...]``.

Fetches js.foresight from npm into a temporary folder, opens a page with the targets of each movement, and
moves the mouse along it in real time through DevTools: real events, which both libraries hear at once.
Everything that was fitted to recordings does not know the people, or for the evidence and the settings the
group of sets. Each movement is met by a new page, which has heard the person's earlier movements, all at
once and with their times. Then the mouse is moved to the start, where it rests, and every target is armed
again, so that what fires counts once a movement. Written after every layout. Recordings come from the folder
named by POINTPRED_RECORDINGS. About three minutes a layout; the machine should have nothing else to do.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from evidence.arguments import parse
from evidence.data import Table, keep, stored
from evidence.held_out import HeldOut, held_out
from evidence.intent.firing import score
from evidence.intent.fit import GROUPS, Fits, fits, recorded
from evidence.intent.measure import HEADS, RULE, cells, draw
from evidence.intent.movements import Movement
from evidence.intent.proposals import BETWEEN_S
from evidence.intent.site import NpmMissingError, Site, install, site
from pointpred import EventColumns
from pointpred.live.devtools import Page, drive_mouse
from pointpred.records import FloatArray
from pointpred.targets import Target
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, WIDTH, table
from pointpred.training.data import folder
from tests.server import browser

PREDICTORS = ("kinematic-adaptive", "minimum-jerk")
RULES = (RULE, *PREDICTORS)
EACH = 49
"""Movements of a layout."""
REST_S, ARMED_S = 0.35, 0.1
"""Before every target is armed and before the movement; a pause of 0.3 s begins another."""
SETTLING, SETTLE_PX, SETTLE_S = 10, 0.5, 0.02
"""Events at the start before that, so that the jump to it is in nobody's memory of positions."""
MARGIN_PX = 40
"""Between the outermost target or position and the border of the page."""
LOADED_S = 0.3


class Played(msgspec.Struct, frozen=True):
    """What the page heard in one movement."""

    movement: Movement
    """As its events came to the page."""
    fired: dict[str, FloatArray]
    """Of each rule, when each target fired, s; infinite where it did not."""
    frames: int
    long: int
    """Frames that took more than 25 ms."""


class Player:
    """Plays movements in one tab."""

    def __init__(self, page: Page, host: Site, held: HeldOut, fitted: Fits) -> None:
        self.page, self.host, self.held, self.fitted = page, host, held, fitted

    def play(self, movement: Movement) -> Played:
        """Play a movement in a new page."""
        self.open(movement)
        plain = document(movement)
        events = np.array(plain["events"])
        self.page.evaluate(f"beside.learn({plain['earlier']})")
        self.page.evaluate(f"beside.show({plain['targets']})")
        self.settle(*events[0, 1:])
        time.sleep(REST_S)
        self.page.evaluate("beside.arm()")
        time.sleep(ARMED_S)
        drive_mouse(self.page, with_buttons(events, 0.0))
        time.sleep(3 * SETTLE_S)  # the last frame
        heard = self.page.evaluate("beside.heard()")
        return played(movement, plain["targets"], heard)

    def open(self, movement: Movement) -> None:
        """A new page, with nothing in it that was fitted to the person."""
        fold = self.held.fold_of.get(f"{movement.set} {movement.user}")
        self.host.hold_out(
            None if fold is None else self.held.folds[fold], self.fitted.without[GROUPS[movement.set]]
        )
        self.page.go(f"{self.host.address}/?{'&'.join(f'predictor={name}' for name in PREDICTORS)}")
        self.page.evaluate(
            "new Promise((done) => { const look = () => window.beside"
            " ? done(beside.opened) : setTimeout(look, 10); look(); })"
        )
        time.sleep(LOADED_S)

    def settle(self, x: float, y: float) -> None:
        """Bring the mouse to a place, and let it tremble there."""
        rows = [(i * SETTLE_S, x + SETTLE_PX * (i % 2), y) for i in reversed(range(SETTLING))]
        drive_mouse(self.page, with_buttons(np.array(sorted(rows)), 0.0))


def with_buttons(events: FloatArray, buttons: float) -> EventColumns:
    """Rows of t, x, y as events."""
    rows = np.full((len(events), 6), np.nan)
    rows[:, :3], rows[:, 5] = events, buttons
    return EventColumns(rows)


def played(movement: Movement, targets: Sequence[Sequence[float]], heard: dict[str, Any]) -> Played:
    """What the page heard, as the scores want it."""
    fired = {rule: np.full(len(targets), np.inf) for rule in RULES}
    for rule, place, at in heard["fired"]:
        fired[rule][place] = min(fired[rule][place], at)
    laid = table([Target(place, *rectangle) for place, rectangle in enumerate(targets)])
    own = msgspec.structs.replace(movement, events=np.array(heard["events"]), table=laid)
    return Played(own, fired, heard["frames"], heard["long"])


def rows(layout: str, done: Sequence[Played]) -> list[tuple[str, ...]]:
    """The rows of a layout."""
    found = []
    for rule in RULES:
        one = score([part.movement for part in done], [part.fired[rule] for part in done])
        name = rule if rule == RULE else f"`{rule}`"
        found.append((layout, name, str(one.movements), *cells(one)))
    return found


def document(movement: Movement) -> dict[str, Any]:
    """A movement as JSON."""
    table, events = movement.table, movement.events
    left, top = table[:, CENTRE_X] - 0.5 * table[:, WIDTH], table[:, CENTRE_Y] - 0.5 * table[:, HEIGHT]
    x, y = (
        min(left.min(), events[:, 1].min()) - 0.5 * MARGIN_PX,
        min(top.min(), events[:, 2].min()) - 0.5 * MARGIN_PX,
    )
    rows = np.column_stack([events[:, 0] - events[0, 0], events[:, 1] - x, events[:, 2] - y])
    targets = np.column_stack([left - x, top - y, table[:, WIDTH], table[:, HEIGHT]])
    begin = movement.earlier[-1, 0] + BETWEEN_S if len(movement.earlier) else 0.0
    earlier = movement.earlier[:, [0, 1, 2, 5]] - (begin, x, y, 0.0)
    return {
        "layout": movement.layout,
        "set": movement.set,
        "user": movement.user,
        "earlier": np.round(earlier, 4).tolist(),
        "events": np.round(rows, 4).tolist(),
        "targets": np.round(targets, 3).tolist(),
        "right": movement.right,
        "entry": movement.entry,
    }


def sampled(movements: Sequence[Movement]) -> list[Movement]:
    """So many movements of every layout, evenly from its sets and over each of them."""
    chosen: list[Movement] = []
    for layout in dict.fromkeys(one.layout for one in movements):
        by_set: dict[str, list[Movement]] = {}
        for one in movements:
            if one.layout == layout:
                by_set.setdefault(one.set, []).append(one)
        most = -(-EACH // len(by_set))
        for own in by_set.values():
            places = np.linspace(0, len(own) - 1, min(most, len(own))).astype(int)
            chosen += [own[i] for i in places]
    return chosen


def main(layouts: Sequence[str]) -> None:
    """Play the movements of these layouts, or of all."""
    every = sorted(sampled(recorded(())), key=lambda one: (one.layout, one.set, one.user))
    names = layouts or sorted({one.layout for one in every})
    with ExitStack() as stack:
        scratch = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        host = stack.enter_context(site(install(scratch / "npm")))
        chromium = stack.enter_context(browser.running(scratch / "profile"))
        page = stack.enter_context(chromium.hand(stack.enter_context(chromium.tab())))
        player = Player(page, host, held_out(folder()), fits())
        for layout in names:
            chosen = [one for one in every if one.layout == layout]
            resize(page, chosen)
            done = [player.play(one) for one in chosen]
            write(layout, done)
    draw()


def resize(page: Page, chosen: Sequence[Movement]) -> None:
    """Make the viewport as large as the layout and the movements."""
    plain = [document(one) for one in chosen]
    right = max(max(left + width for left, _, width, _ in one["targets"]) for one in plain)
    bottom = max(max(top + height for _, top, _, height in one["targets"]) for one in plain)
    x, y = np.vstack([np.array(one["events"])[:, 1:] for one in plain]).max(axis=0)
    size = {"width": int(max(right, x)) + MARGIN_PX, "height": int(max(bottom, y)) + MARGIN_PX}
    page.call("Emulation.setDeviceMetricsOverride", **size, deviceScaleFactor=1, mobile=False)


def write(layout: str, done: Sequence[Played]) -> None:
    """Put the rows of a layout in the place of its old ones."""
    old = stored("intent", "policy").tables.get("browser")
    others = [tuple(row) for row in old.texts() if row[0] != layout] if old else []
    new = rows(layout, done)
    frames = sum(one.frames for one in done)
    late = 100.0 * sum(one.long for one in done) / max(frames, 1)
    print(f"{layout}: {late:.1f} % of frames late, load {os.getloadavg()[0]:.1f}", flush=True)
    for row in new:
        print(*row, sep=" | ", flush=True)
    whole = Table.of(("layout", "rule", "movements", *HEADS), sorted([*others, *new], key=lambda row: row[0]))
    numbers = stored("intent", "policy").numbers.get("late frames", {}) | {layout: late}
    keep("intent", {"browser": whole}, part="policy", numbers={"late frames": numbers})


if __name__ == "__main__":
    wanted = parse(__doc__, metavar="layout")
    if browser.BROWSER is None:
        sys.exit("no chromium on this machine")
    try:
        main(wanted)
    except NpmMissingError as error:
        sys.exit(str(error))
