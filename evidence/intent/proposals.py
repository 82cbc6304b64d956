"""Measure a page's proposals with the defaults: ``python -m evidence intent proposals``.

Lays cards, links and a menu under recorded movements, so that each
movement ends in one of them, and counts what a page would receive. The recommended predictor's coefficients
do not know the people; the evidence that turns predictions into shares was fitted on all sets. Recordings
come from the folder named by POINTPRED_RECORDINGS.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

import msgspec
import numpy as np

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.held_out import HeldOut, held_out
from pointpred import RECOMMENDED, EventColumns, Place, build, run
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.records import FloatArray
from pointpred.scoring import resolution
from pointpred.targets import Chooser, Target
from pointpred.targets.aim import Aim
from pointpred.targets.posterior import FITTED, FITTED_NEAREST
from pointpred.training.data import folder

Layout = Callable[[np.random.Generator], list[Target]]
EFFECTIVE, EDGE = 4.133, 0.49
"""People aim at centres with a deviation of the width over the first, here within the second of it."""
TRIES = 50


def cards(generator: np.random.Generator) -> list[Target]:
    """Eight cards of 200 x 142 px in two rows, 24 px apart."""
    return [Target(i, 224.0 * (i % 4), 166.0 * (i // 4), 200.0, 142.0) for i in range(8)]


def links(generator: np.random.Generator) -> list[Target]:
    """Links of 50 to 150 px in six lines of text, 40 to 160 px apart."""
    targets: list[Target] = []
    for line in range(6):
        x = 0.0
        while True:
            x, width = x + generator.uniform(40.0, 160.0), generator.uniform(50.0, 150.0)
            if x + width > 640.0:
                break
            targets.append(Target(len(targets), x, 26.0 * line, width, 20.0))
            x += width
    return targets


def menu(generator: np.random.Generator) -> list[Target]:
    """Twenty rows of 180 x 24 px without a gap."""
    return [Target(i, 0.0, 24.0 * i, 180.0, 24.0) for i in range(20)]


LAYOUTS: dict[str, Layout] = {"cards": cards, "links": links, "menu": menu}


def placed(
    layout: Layout, start: FloatArray, end: FloatArray, generator: np.random.Generator
) -> tuple[list[Target], int] | None:
    """The targets, and the place of the one that the movement ends in; it does not start in that one.

    ``None`` where no such place was found.
    """
    for _ in range(TRIES):
        targets = layout(generator)
        right = int(generator.integers(len(targets)))
        goal = targets[right]
        size = np.array([goal.width, goal.height])
        off = np.clip(generator.normal(0.0, size / EFFECTIVE), -EDGE * size, EDGE * size)
        dx, dy = (end - off - (goal.x + 0.5 * goal.width, goal.y + 0.5 * goal.height)).tolist()
        moved = [Target(one.id, one.x + dx, one.y + dy, one.width, one.height) for one in targets]
        goal = moved[right]
        x, y = (start - (goal.x, goal.y)).tolist()
        if not (0.0 <= x <= goal.width and 0.0 <= y <= goal.height):
            return moved, right
    return None


MOVEMENTS, LEAST_PX = 160, 80.0
"""Movements of a set, evenly from its people, in their order, each at least so long."""
BETWEEN_S, HELD_S, CLICK_S = 1.0, 0.08, 0.02
"""From a release to the next movement; how long the button is held, and how long after the end."""
DIALS = tuple(round(0.05 + 0.01 * i, 2) for i in range(75))
Movements = list[tuple[FloatArray, FloatArray]]
"""The movements of a person: rows of events, and the predictions made at them."""


class Told(NamedTuple):
    """What a chooser decides by, where the predictions are known already."""

    aim: Aim
    places: tuple[Place, ...] = ()


class Defaults(msgspec.Struct, frozen=True):
    """How a page may choose."""

    name: str
    predictor: str
    make: Callable[[Told], Chooser]
    entries: bool = True
    """Whether a target is proposed when the cursor enters it."""
    coefficients: FloatArray = FITTED


BEFORE = Defaults(
    "`switched`, precision 0.8 (before)",
    "switched",
    lambda told: Chooser(told, precision=0.8, least_lead_s=0.05),
    False,
)
NOW = Defaults(f"`{RECOMMENDED}`, precision 0.5 (now)", RECOMMENDED, Chooser)


class Outcome(msgspec.Struct, frozen=True):
    """What a page receives in one movement."""

    lead_s: float | None
    """From the prediction of the right target that stood at its entry; ``None`` where none stood."""
    by_entry: bool
    """The right target was proposed when the cursor had entered it."""
    predicted: int
    wrong: int
    """Predictions of other targets."""
    passed: int
    """Other targets proposed because the cursor went through them."""


def predict_people(recording: Recording, predictor: str, held: HeldOut) -> Iterator[Movements]:
    """Each person's movements in one session, each ended by a click, and what is predicted."""
    users = list(dict.fromkeys(trial.user for trial in recording.trials))
    unseen = held.of_people(predictor, recording) if predictor == RECOMMENDED else {}
    for user in users:
        parts: list[FloatArray] = []
        for k, trial in enumerate(recording.trials):
            rows = recording.rows(k).table
            if trial.user == user and len(rows) and np.hypot(*(rows[-1, 1:3] - rows[0, 1:3])) >= LEAST_PX:
                parts.append(with_click(rows, parts[-1][-1, 0] + BETWEEN_S if parts else 0.0))
            if len(parts) == max(1, MOVEMENTS // len(users)):
                break
        if parts:
            pipeline = unseen.get(user) or build(predictor, **resolution(recording, None, None))
            answers = run(pipeline.fresh(), EventColumns(np.vstack(parts))).table
            ends = np.cumsum([len(part) for part in parts])[:-1]
            yield list(zip(parts, np.split(answers, ends), strict=True))


CLICK_ROWS = 2


def with_click(rows: FloatArray, begin_s: float) -> FloatArray:
    """A movement that begins then, with a click at its end."""
    moved = rows.copy()
    moved[:, 0] += begin_s - rows[0, 0]
    moved[:, 5] = 0.0
    press, release = moved[-1].copy(), moved[-1].copy()
    press[0], press[5] = press[0] + CLICK_S, 1.0
    release[0] += CLICK_S + HELD_S
    return np.vstack([moved, press, release])


def outcomes(people: Sequence[Movements], layout: str, way: Defaults) -> list[Outcome]:
    """What a page with this layout hears of everybody."""
    results = []
    for number, movements in enumerate(people):
        generator = np.random.default_rng([7, number])
        told = Told(Aim(learn=0, coefficients=way.coefficients))
        chooser = way.make(told)
        for events, answers in movements:
            place = placed(LAYOUTS[layout], events[0, 1:3], events[-1, 1:3], generator)
            if place is None:
                continue
            targets, right = place
            told.aim.register(targets)
            changes = []
            for event, answer in zip(map(tuple, events.tolist()), map(tuple, answers.tolist()), strict=True):
                told.aim.given(event, answer)
                changes += [(event[0], change) for change in chooser.update()]
            results.append(account(targets[right], events, changes))
    return results


def account(goal: Target, events: FloatArray, changes: Sequence[tuple[float, Any]]) -> Outcome:
    """What the choices of one movement came to."""
    x, y = events[:, 1] - goal.x, events[:, 2] - goal.y
    inside = (x >= 0.0) & (x <= goal.width) & (y >= 0.0) & (y <= goal.height)
    entry = float(events[int(np.argmax(inside)), 0])
    since: float | None = None
    by_entry, predicted, wrong, passed = False, 0, 0, 0
    for t, one in changes:
        if one.reason == "predicted":
            predicted, wrong = predicted + 1, wrong + (one.id != goal.id)
        passed += one.reason == "entered" and one.id != goal.id
        if one.id == goal.id and (t < entry or (t == entry and one.action == "propose")):
            by_entry = one.action == "propose"
            since = t if one.reason == "predicted" else None
    return Outcome(None if since is None else entry - since, by_entry, predicted, wrong, passed)


def summary(rows: Sequence[Outcome], entries: bool = True) -> tuple[float, ...]:
    """Shares before and by entry, median lead s, predictions, wrong ones and targets passed a movement."""
    leads = [one.lead_s for one in rows if one.lead_s is not None]
    return (
        len(leads) / len(rows),
        float(np.mean([one.by_entry if entries else one.lead_s is not None for one in rows])),
        float(np.median(leads)) if leads else float("nan"),
        *(float(np.mean([getattr(one, name) for one in rows])) for name in ("predicted", "wrong")),
        float(np.mean([one.passed for one in rows])) if entries else 0.0,
    )


def cells(values: Sequence[float]) -> tuple[str, ...]:
    """Numbers as a table shows them."""
    before, by_entry, lead, predicted, wrong, passed = values
    shown = "-" if np.isnan(lead) else f"{1e3 * lead:.0f} ms"
    return f"{before:.0%}", f"{by_entry:.0%}", shown, f"{predicted:.2f}", f"{wrong:.2f}", f"{passed:.2f}"


def nearest(people: dict[str, list[Movements]], layout: str, proposals: float) -> Defaults:
    """The nearest target, with the dial at which it proposes about as often."""

    def often(dial: float) -> float:
        results = [outcomes(one, layout, way(dial)) for one in people.values()]
        return abs(float(np.mean([summary(rows)[3] for rows in results])) - proposals)

    def way(dial: float) -> Defaults:
        name = f"nearest target, dial {dial:g}"
        make = partial(Chooser, precision=dial)
        return Defaults(name, "hold", make, coefficients=FITTED_NEAREST)

    dial = min(DIALS[::5], key=often)
    return way(min((one for one in DIALS if abs(one - dial) < 0.05), key=often))


HEADS = ("right before entry", "right at entry at the latest", "lead", "predictions", "wrong", "passed")


def measured(sets: Sequence[Recording], held: HeldOut) -> dict[str, Table]:
    """The table of every set, and that of their means."""
    people = {
        name: {one.name: list(predict_people(one, name, held)) for one in sets}
        for name in (RECOMMENDED, "switched", "hold")
    }
    every, means = [], []
    for layout in LAYOUTS:
        ours = [summary(outcomes(one, layout, NOW)) for one in people[RECOMMENDED].values()]
        near = nearest(people["hold"], layout, float(np.mean([one[3] for one in ours])))
        for way in (NOW, BEFORE, near):
            tables = {
                name: summary(outcomes(one, layout, way), way.entries)
                for name, one in people[way.predictor].items()
            }
            every += [(layout, name, way.name, *cells(values)) for name, values in tables.items()]
            columns = list(zip(*tables.values(), strict=True))
            middle = [float(np.mean(column)) for column in columns]
            leads = [lead for lead in columns[2] if not np.isnan(lead)]
            middle[2] = float(np.median(leads)) if leads else float("nan")
            means.append((layout, way.name, *cells(middle)))
            print(layout, way.name, means[-1][2:], flush=True)
    return {
        "layouts": Table.of(("layout", "set", "chosen by", *HEADS), every),
        "means": Table.of(("layout", "chosen by", *HEADS), means),
    }


def main() -> None:
    """Measure every set at hand."""
    where = folder()
    sets = [read(path) for path in sorted(where.glob("*_samples.parquet"))]
    keep("intent", measured(sets, held_out(where)), part="proposals")


if __name__ == "__main__":
    parse(__doc__)
    main()
