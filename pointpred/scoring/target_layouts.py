"""Candidate targets for recorded movements: the circle they go around, the targets of a block, or a grid.

Blocks are successive trials of a user with one width, one block and one condition of distance or transfer.
"""

from __future__ import annotations

from collections.abc import Sequence

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred.scoring.trials import Prepared
from pointpred.targets import around
from pointpred.targets.rectangles import table

LEAST_BLOCK, LEAST_SCATTERED = 3, 5
"""A circle is found from this many movements on; scattered targets are judged from this many on."""
SAME = 0.05
"""Successive movements of a circle are equally far within this share."""
SAME_TURN = 0.05
"""And turn equally far within this many rad."""
COLUMNS, ROWS = 5, 3
PITCH, FILLED = 0.4, 0.5
"""The cells of a grid lie this share of the set's median distance apart, and targets fill this of it."""


class Layout(msgspec.Struct, frozen=True):
    """The candidates of one trial as a table of targets, and which of them it was for."""

    trial: int
    table: FloatArray
    right: int


def layouts(prepared: Prepared, seed: int = 0) -> dict[str, list[Layout]]:
    """What the candidates are, in words, and those of each trial.

    A trial whose block is a circle is judged on that circle; one whose block has at least 5 other targets on
    those; over every other a grid is laid.
    """
    by_kind: dict[str, list[Layout]] = {}
    free: list[int] = []
    for block in _blocks(prepared):
        ends = np.array([(t.trial.target_x, t.trial.target_y) for t in (prepared.trials[k] for k in block)])
        starts = prepared.events.table[prepared.offsets[block], 1:3]
        widths = [prepared.trials[k].trial.target_w for k in block]
        has_targets = len(block) >= LEAST_BLOCK and bool(
            np.isfinite(ends).all() and np.isfinite(widths).all()
        )
        places = circle(ends, starts) if has_targets else None
        if places is not None:
            same = [_layout(k, points, widths[0], 0) for k, points in zip(block, places, strict=True)]
            by_kind.setdefault(f"circle of {len(places[0])}", []).extend(same)
        elif has_targets and len(apart := _apart(ends, widths[0])) >= LEAST_SCATTERED:
            right = [int(np.hypot(*(apart - end).T).argmin()) for end in ends]
            same = [_layout(k, apart, widths[0], i) for k, i in zip(block, right, strict=True)]
            by_kind.setdefault("scattered targets", []).extend(same)
        else:
            free += block
    if free:
        by_kind[f"grid of {COLUMNS * ROWS}"] = grids(prepared, free, seed)
    return by_kind


def _layout(trial: int, places: FloatArray, width: float, right: int) -> Layout:
    return Layout(trial, table([around(i, x, y, width) for i, (x, y) in enumerate(places.tolist())]), right)


def _apart(ends: FloatArray, width: float) -> FloatArray:
    """The targets of a block, each once."""
    places: list[FloatArray] = []
    for end in ends:
        if all(np.hypot(*(end - other)) > 0.5 * width for other in places):
            places.append(end)
    return np.array(places)


def circle(ends: FloatArray, starts: FloatArray) -> list[FloatArray] | None:
    """For each movement of a block its circle of targets, its own first; ``None`` where there is none.

    The task of ISO 9241-411 takes targets in the order across the circle: each movement is as long as the
    last and turns by pi (1 - 1/n), n the number of targets, which the median turn tells. The chord is that
    between successive targets, or from where the movement starts to its target where these are more alike
    (as where the screen is laid anew for each movement).
    """
    between, reached = np.diff(ends, axis=0, prepend=starts[:1]), ends - starts
    chords = min((between, reached), key=lambda chord: _unlike(np.hypot(*chord[1:].T)))
    lengths = np.hypot(*chords.T)
    length = float(np.median(lengths[1:]))
    turns = np.diff(np.arctan2(chords[:, 1], chords[:, 0]))
    turns = (turns + np.pi) % (2.0 * np.pi) - np.pi
    turn = float(np.median(np.abs(turns[1:])))
    if length == 0.0 or _unlike(lengths[1:]) > SAME * length or _unlike(np.abs(turns[1:])) > SAME_TURN:
        return None
    if not 0.75 * np.pi <= turn <= 0.995 * np.pi:
        return None
    count = round(np.pi / (np.pi - turn))
    half = np.pi * (count // 2) / count
    radius, side = length / (2.0 * np.sin(half)), float(np.sign(np.median(np.sign(turns))))
    if chords is between:  # nobody says where the target before the first one was: the order does
        turned = -side * np.pi * (1.0 - 1.0 / count)
        ux, uy = chords[1]
        chords[0] = ux * np.cos(turned) - uy * np.sin(turned), ux * np.sin(turned) + uy * np.cos(turned)
        lengths[0] = lengths[1]
    angles = 2.0 * np.pi * np.arange(count) / count
    places = []
    for end, start, chord, far in zip(ends, starts, chords, lengths, strict=True):
        along = (
            chord / far if abs(far - length) <= SAME * length else (end - start) / np.hypot(*(end - start))
        )
        across = side * np.array([-along[1], along[0]])
        centre = end - 0.5 * length * along + radius * np.cos(half) * across
        first = np.arctan2(*(end - centre)[::-1])
        places.append(centre + radius * np.column_stack([np.cos(first + angles), np.sin(first + angles)]))
    return places


def grids(prepared: Prepared, trials: Sequence[int], seed: int = 0) -> list[Layout]:
    """For each of these movements a grid of 5 x 3 squares, laid so that its end lies in one of them.

    Which one, and where in it, is drawn: normally about the centre with a deviation of width / 4.133 along
    each axis, as people aim, and never outside. Distances are shares of the set's median distance, so that
    sets are equally hard. The same seed lays the same grids.
    """
    generator = np.random.default_rng([seed, 15])
    pitch = PITCH * float(np.median([trial.distance_px for trial in prepared.trials]))
    width = FILLED * pitch
    column, row = np.meshgrid(np.arange(COLUMNS), np.arange(ROWS))
    cells = pitch * np.column_stack([column.ravel(), row.ravel()])
    laid = []
    for k in trials:
        right = int(generator.integers(len(cells)))
        off = np.clip(generator.normal(0.0, width / 4.133, 2), -0.5 * width, 0.5 * width)
        end = prepared.events.table[prepared.offsets[k + 1] - 1, 1:3]
        laid.append(_layout(k, cells + end - cells[right] - off, width, right))
    return laid


def _unlike(values: FloatArray) -> float:
    """The median deviation from the median."""
    return float(np.median(np.abs(values - np.median(values))))


def _blocks(prepared: Prepared) -> Sequence[list[int]]:
    """Successive trials that belong together."""
    blocks: list[list[int]] = []
    last: object = None
    for k, scored in enumerate(prepared.trials):
        trial = scored.trial
        parts = [v for name, v in sorted(trial.condition.items()) if name.startswith(("block", "distance"))]
        key = (trial.user, trial.target_w, trial.condition.get("transfer"), *parts)
        if key != last or not blocks:
            blocks.append([])
        blocks[-1].append(k)
        last = key
    return blocks
