"""Candidate targets for recorded movements: the circle they go around, the targets of a block, or a grid.

Blocks are successive trials of a user with one width, one block and one condition of distance or transfer.
A block that each trial has another of is a number of the trial, and tells nothing.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from itertools import pairwise

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred.scoring.results import ScoredTrial
from pointpred.scoring.trials import Candidates, Prepared
from pointpred.targets import around
from pointpred.targets.rectangles import MOST_TARGETS, SMALLEST_PX, Target, table

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
    """The candidates of one trial, and which of them it was for."""

    trial: int
    targets: tuple[Target, ...]
    right: int

    @property
    def table(self) -> FloatArray:
        """The candidates as laws take them."""
        return table(self.targets)


def layouts(prepared: Prepared, seed: int = 0) -> dict[str, list[Layout]]:
    """What the candidates are, in words, and those of each trial.

    Those of ``own_layouts``; over every other trial a grid is laid.
    """
    by_kind = own_layouts(prepared)
    known = {layout.trial for own in by_kind.values() for layout in own}
    if free := [k for k in range(len(prepared.trials)) if k not in known]:
        by_kind[f"grid of {COLUMNS * ROWS}"] = grids(prepared, free, seed)
    return by_kind


def own_layouts(prepared: Prepared) -> dict[str, list[Layout]]:
    """What the candidates are, in words, and those of each trial that has a target of its own.

    A trial whose block is a circle is judged on that circle; one whose block has at least 5 different targets
    on all of those. A target is named by its place, so that it has one name in all trials of its block.
    """
    by_kind: dict[str, list[Layout]] = {}
    for block in _blocks(prepared):
        ends = np.array([(t.trial.target_x, t.trial.target_y) for t in (prepared.trials[k] for k in block)])
        starts = prepared.events.table[prepared.offsets[block], 1:3]
        widths = np.array([prepared.trials[k].trial.target_w for k in block])
        if len(block) < LEAST_BLOCK or not (np.isfinite(ends).all() and (widths >= SMALLEST_PX).all()):
            continue
        width, places = float(widths[0]), circle(ends, starts)
        if places is not None:
            named = zip(block, _followed(places), places, strict=True)
            same = [_layout(k, names, own, width, 0) for k, names, own in named]
            by_kind.setdefault(f"circle of {len(places[0])}", []).extend(same)
        elif LEAST_SCATTERED <= len(apart := _apart(ends, width)) <= MOST_TARGETS:
            right = [int(np.hypot(*(apart - end).T).argmin()) for end in ends]
            names = [_name(place) for place in apart]
            same = [_layout(k, names, apart, width, i) for k, i in zip(block, right, strict=True)]
            by_kind.setdefault("scattered targets", []).extend(same)
    return by_kind


def with_candidates(prepared: Prepared) -> Prepared:
    """The trials with all targets of their blocks, in an order that does not tell the right one."""
    by_kind = own_layouts(prepared)
    targets: list[tuple[Target, ...]] = [()] * len(prepared.trials)
    for layout in (one for own in by_kind.values() for one in own):
        targets[layout.trial] = tuple(sorted(layout.targets, key=lambda one: str(one.id)))
    kinds = {kind: len(own) for kind, own in by_kind.items()}
    return msgspec.structs.replace(prepared, candidates=Candidates(tuple(targets), kinds))


def _layout(trial: int, names: Sequence[Hashable], places: FloatArray, width: float, right: int) -> Layout:
    targets = (around(name, x, y, width) for name, (x, y) in zip(names, places.tolist(), strict=True))
    return Layout(trial, tuple(targets), right)


def _name(place: FloatArray) -> str:
    return " ".join(f"{value:.9g}" for value in place.tolist())


def _followed(found: Sequence[FloatArray]) -> list[list[str]]:
    """Names of the targets of each circle of a block: one that hardly moved since keeps its name."""
    known, names = np.empty((0, 2)), list[str]()
    every = []
    for places in found:
        near = 0.5 * float(np.hypot(*(places[1:] - places[0]).T).min())
        own = []
        for place in places:
            far = np.hypot(*(known - place).T)
            if not names or far.min() >= near:
                name = _name(place)
                names.append(name + "'" * sum(one.rstrip("'") == name for one in names))
                known, far = np.vstack([known, place]), np.append(far, 0.0)
            known[far.argmin()] = place
            own.append(names[far.argmin()])
        every.append(own)
    return every


def _apart(ends: FloatArray, width: float) -> FloatArray:
    """The targets of a block, each once."""
    places = np.empty((0, 2))
    for end in ends:
        if (np.hypot(*(places - end).T) > 0.5 * width).all():
            places = np.vstack([places, end])
    return places


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
        laid.append(_layout(k, range(len(cells)), cells + end - cells[right] - off, width, right))
    return laid


def _unlike(values: FloatArray) -> float:
    """The median deviation from the median."""
    return float(np.median(np.abs(values - np.median(values))))


def _blocks(prepared: Prepared) -> Sequence[list[int]]:
    """Successive trials that belong together."""
    blocks: list[list[int]] = []
    numbered = _numbered(prepared.trials)
    last: object = None
    for k, scored in enumerate(prepared.trials):
        trial = scored.trial
        parts = [
            value
            for name, value in sorted(trial.condition.items())
            if name.startswith(("block", "distance")) and (trial.user, name) not in numbered
        ]
        key = (trial.user, trial.target_w, trial.condition.get("transfer"), *parts)
        if key != last or not blocks:
            blocks.append([])
        blocks[-1].append(k)
        last = key
    return blocks


def _numbered(trials: Sequence[ScoredTrial]) -> set[tuple[str, str]]:
    """The users and conditions of blocks where no two successive trials are of one block."""
    several, shared = set(), set()
    for before, scored in pairwise(trials):
        one, other = before.trial, scored.trial
        if one.user != other.user:
            continue
        for name in other.condition:
            if name.startswith("block"):
                several.add((other.user, name))
                if one.condition.get(name) == other.condition[name]:
                    shared.add((other.user, name))
    return several - shared
