"""Movements for a browser: ``python -m evidence intent sample FILE`` writes some of each layout as JSON.

A list of objects: ``layout``, ``set``, ``user``, ``events`` as [t s, x px, y px], ``targets`` as [left, top,
width, height] px, ``right``, the place of the target that the movement is for, and ``entry``, the place of
the first event in it. All targets and events of a movement are moved alike, so that the least coordinate is
MARGIN_PX. Recordings come from the folder named by POINTPRED_RECORDINGS; the file is not to be committed.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from evidence.arguments import parse
from evidence.intent.fit import recorded
from evidence.intent.movements import Movement
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, WIDTH

EACH = 90
"""Movements of a layout, evenly from all sets."""
MARGIN_PX = 20.0


def document(movement: Movement) -> dict[str, Any]:
    """A movement as JSON."""
    table, events = movement.table, movement.events
    left, top = table[:, CENTRE_X] - 0.5 * table[:, WIDTH], table[:, CENTRE_Y] - 0.5 * table[:, HEIGHT]
    x, y = min(left.min(), events[:, 1].min()) - MARGIN_PX, min(top.min(), events[:, 2].min()) - MARGIN_PX
    rows = np.column_stack([events[:, 0] - events[0, 0], events[:, 1] - x, events[:, 2] - y])
    targets = np.column_stack([left - x, top - y, table[:, WIDTH], table[:, HEIGHT]])
    return {
        "layout": movement.layout,
        "set": movement.set,
        "user": movement.user,
        "events": np.round(rows, 4).tolist(),
        "targets": np.round(targets, 3).tolist(),
        "right": movement.right,
        "entry": movement.entry,
    }


def sampled(movements: Sequence[Movement], each: int = EACH) -> list[Movement]:
    """So many movements of every layout, evenly from its sets and over each of them."""
    chosen: list[Movement] = []
    for layout in dict.fromkeys(one.layout for one in movements):
        by_set: dict[str, list[Movement]] = {}
        for one in movements:
            if one.layout == layout:
                by_set.setdefault(one.set, []).append(one)
        most = -(-each // len(by_set))
        for own in by_set.values():
            places = np.linspace(0, len(own) - 1, min(most, len(own))).astype(int)
            chosen += [own[i] for i in places]
    return chosen


def main(file: Path) -> None:
    """Write the sample."""
    chosen = sampled(recorded(()))
    file.write_text(json.dumps([document(one) for one in chosen]), encoding="utf-8")
    print(f"wrote {len(chosen)} movements to {file}")


if __name__ == "__main__":
    (name,) = parse(__doc__, metavar="file", most=1) or [None]
    if name is None:
        raise SystemExit("name the file to write")
    main(Path(name))
