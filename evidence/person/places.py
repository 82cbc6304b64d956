"""Measure proposals of places that nobody registered: ``python -m evidence person places``.

Replays every person's movements in the order of recording through the recommended predictor, with
coefficients that do not know the person, and lets ``PlaceChooser``'s rules decide among the places that the
person has visited so far. Targets of the recordings are not used. Recordings come from the folder named by
POINTPRED_RECORDINGS. Takes half an hour.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot, nan
from typing import NamedTuple

import numpy as np

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.held_out import HeldOut, held_out
from pointpred import RECOMMENDED, Pipeline, Place, PointerEvent, build
from pointpred.predictors import AdaptiveKinematicPredictor
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.records import FloatArray, event_row, row_at
from pointpred.scoring import resolution
from pointpred.targets import Choice, PlaceChooser, Target
from pointpred.targets.aim import Aim
from pointpred.training.data import folder

DIALS = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 0.98)
ASKED = 0.8
"""Share of proposals that shall be right."""
NEAR_PX, NEAR_SHARE = 20.0, 0.03
"""An end that repeats lies so near one of the last 64 of its person, px; a proposal is right in the strict
sense within this share of the movement's distance of the place's centre: there visits are merged."""


class Moment(NamedTuple):
    """What is known at an event: the places, and the time left that is predicted."""

    event: PointerEvent
    places: tuple[Place, ...]
    remaining_s: float


class Movement(NamedTuple):
    """One movement: its events, whether its end lies near an earlier one."""

    moments: list[Moment]
    repeats: bool


class Outcome(NamedTuple):
    """What was proposed in one movement."""

    proposed: int
    right: int
    """Proposals of a place in whose square the movement ends."""
    strict: int
    """Those whose centre lies within 3 % of the movement's distance of the end."""
    lead_entry_s: float
    """From a right proposal that stood at the first entry into its square to this entry; NaN for none."""
    lead_end_s: float
    repeats: bool


def pipelines(recording: Recording, held: HeldOut, sequence: int) -> dict[str, Pipeline]:
    """For each user a pipeline whose coefficients have not seen them; ``sequence`` as in the predictor."""
    start, own = f"{recording.name} ", build(RECOMMENDED, **resolution(recording, None, None))

    def unseen(fold: int) -> Pipeline:
        predictor = AdaptiveKinematicPredictor(coefficients=held.folds[fold], sequence=sequence)
        return Pipeline(own.name, own.differentiator.fresh(), predictor)

    return {who[len(start) :]: unseen(fold) for who, fold in held.fold_of.items() if who.startswith(start)}


def movements(recording: Recording, pipeline: Pipeline, user: str) -> Iterator[Movement]:
    """The movements of a person in their order, as somebody sees them who knows the earlier ones."""
    ends: list[tuple[float, float]] = []
    for k, trial in enumerate(recording.trials):
        rows = recording.rows(k).table
        if trial.user != user or not len(rows):
            continue
        moments = []
        for row in map(tuple, rows.tolist()):
            answer = pipeline.advance(row)
            left = answer[6]
            moments.append(Moment(PointerEvent(row[0], row[1], row[2]), pipeline.places, left))
        pipeline.reset()
        x, y = rows[-1, 1:3].tolist()
        yield Movement(moments, any(hypot(x - a, y - b) <= NEAR_PX for a, b in ends[-64:]))
        ends.append((x, y))


class Told:
    """What a chooser decides by, where the places and the time left are known already."""

    def __init__(self) -> None:
        self.aim, self.places = Aim(learn=0), tuple[Place, ...]()

    def take(self, moment: Moment) -> None:
        """Take in an event, the places after it and the time left that is predicted."""
        self.places = moment.places
        unstated = [moment.event.t, *[nan] * 5, moment.remaining_s, 0.0, nan, nan]
        self.aim.given(event_row(moment.event), row_at(np.array([unstated]), 0))


def outcome(movement: Movement, told: Told, chooser: PlaceChooser) -> Outcome:
    """What the chooser proposes in a movement, and what becomes of it."""
    told.aim.reset()
    chooser.reset()
    changes: list[tuple[float, Choice, Target]] = []
    path = []
    for moment in movement.moments:
        told.take(moment)
        event = moment.event
        path.append((event.t, event.x, event.y))
        changes += [(event.t, one, one.place) for one in chooser.update() if one.place is not None]
    return account(np.array(path), changes, repeats=movement.repeats)


def account(path: FloatArray, changes: Sequence[tuple[float, Choice, Target]], *, repeats: bool) -> Outcome:
    """How the proposals of a movement came out; ``path``: t, x, y."""
    end, far = path[-1], hypot(*(path[-1, 1:] - path[0, 1:]))
    predicted = [(t, one, place) for t, one, place in changes if one.reason == "predicted"]
    right = [(t, one, place) for t, one, place in predicted if inside(place, path[-1:])[0]]
    strict = [one for one in predicted if off(one[2], end) <= NEAR_SHARE * far]
    leads = []
    for t, one, place in right:
        entry = float(path[int(np.argmax(inside(place, path))), 0])
        ends = [u for u, other, _ in changes if other.id == one.id and u > t and other.action == "retract"]
        if t < entry and not any(u < entry for u in ends):
            leads.append((entry - t, float(end[0]) - t))
    entry_s, end_s = leads[0] if leads else (nan, nan)
    return Outcome(len(predicted), len(right), len(strict), entry_s, end_s, repeats)


def inside(place: Target, path: FloatArray) -> FloatArray:
    """Whether each position lies in the square of a place."""
    across = np.abs(path[:, 1] - place.x - place.width / 2.0) <= place.width / 2.0
    return np.asarray(across & (np.abs(path[:, 2] - place.y - place.height / 2.0) <= place.height / 2.0))


def off(place: Target, end: FloatArray) -> float:
    """How far a position lies from the centre of a place, px."""
    return hypot(end[1] - place.x - place.width / 2.0, end[2] - place.y - place.height / 2.0)


def outcomes(people: Sequence[Sequence[Movement]], dial: float) -> list[Outcome]:
    """Every movement of everybody at a dial."""
    found = []
    for person in people:
        told = Told()
        chooser = PlaceChooser(told, precision=dial)
        found += [outcome(one, told, chooser) for one in person]
    return found


HEADS = (
    "ends that repeat",
    "dial",
    "right",
    "near the centre",
    "movements",
    "of those that repeat",
    "lead to entry",
    "lead to the end",
    "proposals a movement",
)


def cells(rows: Sequence[Outcome], dial: float) -> tuple[str, ...]:
    """The numbers of a set at a dial."""
    proposed = sum(one.proposed for one in rows)
    early = [one for one in rows if one.lead_entry_s == one.lead_entry_s]
    again = [one for one in rows if one.repeats]
    early_again = [one for one in early if one.repeats]

    def share(part: int, whole: int) -> str:
        return f"{part / whole:.0%}" if whole else "-"

    def middle(leads: Sequence[float]) -> str:
        return f"{1e3 * float(np.median(leads)):.0f} ms" if leads else "-"

    return (
        share(len(again), len(rows)),
        f"{dial:g}",
        share(sum(one.right for one in rows), proposed),
        share(sum(one.strict for one in rows), proposed),
        share(len(early), len(rows)),
        share(len(early_again), len(again)),
        middle([one.lead_entry_s for one in early]),
        middle([one.lead_end_s for one in early]),
        f"{proposed / len(rows):.2f}",
    )


def precise(rows: Sequence[Outcome]) -> bool:
    """Whether at least the share asked for of the proposals were right."""
    proposed = sum(one.proposed for one in rows)
    return proposed > 0 and sum(one.right for one in rows) >= ASKED * proposed


def measured(sets: Sequence[Recording], held: HeldOut) -> dict[str, Table]:
    """Each set at each dial, and at the lowest one that is right often enough; with and without order."""
    every, chosen = [], []
    for recording in sets:
        for sequence, words in ((1, "with order"), (0, "without order")):
            people = [
                list(movements(recording, pipeline.fresh(), user))
                for user, pipeline in pipelines(recording, held, sequence).items()
            ]
            rows = {dial: outcomes(people, dial) for dial in DIALS}
            every += [(recording.name, words, *cells(rows[dial], dial)) for dial in DIALS]
            dial = next((dial for dial in DIALS if precise(rows[dial])), DIALS[-1])
            chosen.append((recording.name, words, *cells(rows[dial], dial)))
            print(*chosen[-1], flush=True)
    heads = ("set", "places", *HEADS)
    return {"dials": Table.of(heads, every), "decisions": Table.of(heads, chosen)}


def main() -> None:
    """Measure every set at hand."""
    where = folder()
    sets = [read(path) for path in sorted(where.glob("*_samples.parquet"))]
    held = held_out(where)
    keep("person", measured(sets, held), part="places")


if __name__ == "__main__":
    parse(__doc__)
    main()
