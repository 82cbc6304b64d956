"""Recorded movements over pages: the events, what is predicted at them, the targets, the right one.

The targets of the recordings where these are known (circles, scattered squares); for every set cards, links
in text and a menu, laid so that each movement ends in one of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import msgspec
import numpy as np

from evidence.held_out import HeldOut, trained_predictors
from evidence.intent.proposals import BETWEEN_S, CLICK_ROWS, LAYOUTS, LEAST_PX, placed, with_click
from pointpred import EventColumns, build, run
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.scoring import resolution
from pointpred.scoring.target_layouts import layouts
from pointpred.scoring.trials import Prepared, prepare
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, WIDTH, table

PAGES = tuple(LAYOUTS)
"""Layouts that are laid under every set."""
MOVEMENTS = 160
"""Of a set under cards, links and the menu, evenly from its people."""


class Movement(msgspec.Struct, frozen=True):
    """One movement over one page."""

    layout: str
    set: str
    user: str
    table: FloatArray
    """A row a target."""
    right: int
    events: FloatArray
    """Rows of ``EventColumns`` without the click at the end."""
    earlier: FloatArray
    """Rows of the person's earlier movements, each ended by a click; this one begins BETWEEN_S later."""
    answers: dict[str, FloatArray]
    """Of each predictor, rows of predictions made at the events."""

    @property
    def entry(self) -> int:
        """The first event in the right target; the last where the cursor never gets there."""
        within = inside(self.table[self.right], self.events)
        return int(np.argmax(within)) if within.any() else len(self.events) - 1


def inside(row: FloatArray, events: FloatArray) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """At which events the cursor is in a target."""
    near_x = np.abs(events[:, 1] - row[CENTRE_X]) <= 0.5 * row[WIDTH]
    within: np.ndarray[tuple[int], np.dtype[np.bool_]] = near_x & (
        np.abs(events[:, 2] - row[CENTRE_Y]) <= 0.5 * row[HEIGHT]
    )
    return within


def movements(recording: Recording, predictors: Sequence[str], held: HeldOut) -> Iterator[Movement]:
    """The movements of a set over every page that can be laid under them.

    Each person is met by a fresh predictor that was not fitted to this person, and makes all movements in
    their order, each ended by a click.
    """
    prepared = prepare(recording, **resolution(recording, None, None))
    parts = [prepared.events.table[a:b] for a, b in zip(prepared.offsets, prepared.offsets[1:], strict=False)]
    people = sessions(prepared, parts)
    answers = {name: predicted(recording, people, name, held) for name in predictors}
    earlier = {
        k: rows[:begin]
        for own in people.values()
        for rows in [np.vstack(list(own.values()))]
        for k, begin in zip(own, np.cumsum([0, *map(len, own.values())])[:-1], strict=True)
    }
    for layout, k, targets, right in pages(prepared, parts):
        movement = Movement(
            layout,
            recording.name,
            prepared.trials[k].trial.user,
            targets,
            right,
            parts[k],
            earlier[k],
            {name: rows[k] for name, rows in answers.items()},
        )
        within = inside(targets[right], parts[k])
        if within.any() and not within[0]:
            yield movement


def sessions(prepared: Prepared, parts: Sequence[FloatArray]) -> dict[str, dict[int, FloatArray]]:
    """Of each person the movements by their numbers, in turn, each ended by a click."""
    people: dict[str, dict[int, FloatArray]] = {}
    now: dict[str, float] = {}
    for k, one in enumerate(prepared.trials):
        user = one.trial.user
        rows = with_click(parts[k], now.get(user, 0.0))
        people.setdefault(user, {})[k] = rows
        now[user] = rows[-1, 0] + BETWEEN_S
    return people


def predicted(
    recording: Recording, people: Mapping[str, Mapping[int, FloatArray]], name: str, held: HeldOut
) -> dict[int, FloatArray]:
    """What a predictor says at each event of each movement, by the movement's number."""
    unseen = held.of_people(name, recording) if name in trained_predictors() else {}
    answers: dict[int, FloatArray] = {}
    for user, session in people.items():
        pipeline = unseen.get(user) or build(name, **resolution(recording, None, None))
        rows = run(pipeline.fresh(), EventColumns(np.vstack(list(session.values())))).table
        ends = np.cumsum([len(part) for part in session.values()])[:-1]
        for (k, part), own in zip(session.items(), np.split(rows, ends), strict=True):
            answers[k] = own[: len(part) - CLICK_ROWS].copy()
    return answers


def pages(prepared: Prepared, parts: Sequence[FloatArray]) -> Iterator[tuple[str, int, FloatArray, int]]:
    """The name of a layout, the number of a movement, the targets and the place of the right one."""
    own = {name: laid for name, laid in layouts(prepared).items() if not name.startswith("grid")}
    for name, laid in own.items():
        for one in laid:
            yield name.removesuffix(" targets"), one.trial, one.table, one.right
    chosen = evenly(prepared, parts)
    for name, layout in LAYOUTS.items():
        generator = np.random.default_rng([7, len(name)])
        for k in chosen:
            place = placed(layout, parts[k][0, 1:3], parts[k][-1, 1:3], generator)
            if place is not None:
                yield name, k, table(place[0]), place[1]


def evenly(prepared: Prepared, parts: Sequence[FloatArray]) -> list[int]:
    """The numbers of MOVEMENTS movements, evenly from all people and over each one's session."""
    people: dict[str, list[int]] = {}
    for k, one in enumerate(prepared.trials):
        if np.hypot(*(parts[k][-1, 1:3] - parts[k][0, 1:3])) >= LEAST_PX:
            people.setdefault(one.trial.user, []).append(k)
    most = max(1, MOVEMENTS // max(len(people), 1))
    chosen: list[int] = []
    for own in people.values():
        chosen += [own[i] for i in np.unique(np.linspace(0, len(own) - 1, min(most, len(own))).astype(int))]
    return chosen
