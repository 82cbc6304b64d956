"""What registered targets gain from a person's past: ``python -m pages.places.expected``.

The candidates are those of the page on targets: a circle, the targets of a block, or a grid laid so that
the movement ends in one of its squares. Each movement is judged twice, with the weights as they are given and
with those of ``Chooser.expect``, by the same predictions, whose coefficients do not know the person.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from pages.arguments import parse
from pages.data import Table
from pages.held_out import HeldOut, held_out
from pages.places.people import pipelines
from pointpred import Place
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.records import FloatArray
from pointpred.scoring import prepare, resolution
from pointpred.scoring.target_choice import decisions as replaying
from pointpred.scoring.target_choice.layouts import layouts
from pointpred.scoring.target_choice.scores import ASKS, FRACTIONS
from pointpred.targets import posterior
from pointpred.targets.expectation import expect
from pointpred.targets.rectangles import LOG_WEIGHT
from pointpred.training.data import folder

ASKED, ELSEWHERE, LEAST_WAY_PX = 0.8, 0.02, 3.0
SHOWN = (0.1, 0.3, 0.5, 0.7)
"""Shares of the time at which the likeliest target is looked at."""
WITHOUT, WITH = "as given", "from the past"


class Judged(NamedTuple):
    """One movement with one kind of weights: at shares of the time, and at each precision asked for."""

    by_time: FloatArray
    accounts: FloatArray


def replayed(recording: Recording, held: HeldOut) -> Iterator[tuple[str, str, Judged]]:
    """What the candidates are, the weights, and how they did, for each movement in its person's order."""
    prepared = prepare(recording, **resolution(recording, None, None), threads=1)
    laid = {one.trial: (kind, one) for kind, some in layouts(prepared, 0).items() for one in some}
    unseen = {user: one.fresh() for user, one in pipelines(recording, held, 1).items()}
    for k, scored in enumerate(prepared.trials):
        pipeline = unseen[scored.trial.user]
        first, stop = int(prepared.offsets[k]), int(prepared.offsets[k + 1])
        events = prepared.events.table[first:stop]
        answers, places = np.empty((len(events), 10)), tuple[Place, ...]()
        for i, row in enumerate(map(tuple, events.tolist())):
            answers[i] = pipeline.advance(row)
            if not places or places[0].before == 0.0:  # known once the movement has a direction
                places = pipeline.places
        pipeline.reset()
        if k in laid:
            kind, layout = laid[k]
            arrival = int(prepared.arrivals[k]) - first
            for words, known in ((WITHOUT, ()), (WITH, places)):
                table = expected(layout.table, known)
                yield kind, words, judged(events, answers, table, arrival, layout.right)


def expected(table: FloatArray, places: Sequence[Place]) -> FloatArray:
    """The targets with the weights that ``Chooser.expect`` gives them."""
    weighed = table.copy()
    known = np.array([(one.x, one.y, one.before, one.spread) for one in places]).reshape(-1, 4)
    expect(weighed, table[:, LOG_WEIGHT].copy(), known)
    return weighed


def judged(events: FloatArray, answers: FloatArray, table: FloatArray, arrival: int, right: int) -> Judged:
    """Shares and decisions of one movement."""
    shares = np.empty((len(events), len(table) + 1))
    replaying.weigh(events, answers, table, posterior.FITTED, ELSEWHERE, shares)
    by_time = np.empty((len(FRACTIONS), replaying.READ))
    replaying.read(events, table, shares, arrival, right, FRACTIONS, by_time)
    accounts = np.empty((len(ASKS), replaying.ACCOUNT))
    for i, ask in enumerate(ASKS):
        replaying.account(events, answers, table, shares, right, ask, 0.0, LEAST_WAY_PX, accounts[i])
    return Judged(by_time, accounts)


def cells(some: Sequence[Judged]) -> tuple[str, ...]:
    """The numbers of a set with one kind of weights."""
    by_time = np.mean([one.by_time for one in some], axis=0)
    at = [int(np.argmin(np.abs(FRACTIONS - share))) for share in SHOWN]
    return (
        str(len(some)),
        *(f"{100.0 * by_time[i, replaying.RIGHT]:.0f}" for i in at),
        f"{by_time[:, replaying.LOSS].mean():.3f}",
        *decided(np.array([one.accounts for one in some])),
    )


def decided(accounts: FloatArray) -> tuple[str, ...]:
    """At the lowest dial at which enough proposals were right: hits before the entry, lead, proposals."""
    for i in range(len(ASKS)):
        proposed = accounts[:, i, replaying.PROPOSED].sum()
        if proposed and accounts[:, i, replaying.PROPOSED_RIGHT].sum() >= ASKED * proposed:
            hits = accounts[:, i, replaying.HIT] == 1.0
            lead = float(np.median(accounts[hits, i, replaying.LEAD_ENTRY])) if hits.any() else np.nan
            return f"{hits.mean():.0%}", f"{1e3 * lead:.0f} ms", f"{proposed / len(accounts):.2f}"
    return "-", "-", "-"


HEADS = ("set", "candidates", "weights", "movements", *(f"{share:.0%}" for share in SHOWN), "log loss")


def measured(sets: Sequence[Recording], held: HeldOut) -> Table:
    """Every set and kind of candidates, with both kinds of weights."""
    rows = []
    for recording in sets:
        by: dict[tuple[str, str], list[Judged]] = {}
        for kind, words, one in replayed(recording, held):
            by.setdefault((kind, words), []).append(one)
        rows += [(recording.name, *key, *cells(some)) for key, some in by.items()]
        print(*rows[-len(by) :], sep="\n", flush=True)
    return Table.of((*HEADS, "before entry", "lead to entry", "proposals"), rows)


if __name__ == "__main__":
    parse(__doc__)
    measured([read(path) for path in sorted(folder().glob("*_samples.parquet"))], held_out(folder()))
