"""Fit everybody's weights of the time left: ``python -m evidence person time_left [FOLDER]``.

Replays the movements of every person in POINTPRED_RECORDINGS, in the order of recording, with coefficients
that did not know the person, and fits the weights of ``pointpred.predictors.adaptation.time_left`` to the
time left at the moments by which a person is judged. Prints for each set the error over that of the clock,
with weights fitted to all sets and to the others only. Writes
pointpred/predictors/adaptation/time_left_prior.py, and for movements among targets
pointpred/targets/arrival_prior.py: those of the recordings, or a grid over each movement.
FOLDER: coefficients as ``python -m evidence.held_out FOLDER`` writes them; unless given, those of the cache.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import msgspec
import numpy as np

from evidence import ROOT
from evidence.arguments import parse
from evidence.held_out import HeldOut, held_out, stored, trained_predictors
from pointpred import build, run
from pointpred.predictors.adaptation import time_left
from pointpred.predictors.adaptation.arrival_intervals import Intervals
from pointpred.predictors.adaptation.predictor import Memory
from pointpred.predictors.adaptation.time_left import JUDGED, SMALL, TERMS
from pointpred.recording import Recording
from pointpred.records import EventColumns, FloatArray
from pointpred.scoring import Prepared, prepare, resolution
from pointpred.scoring.measures.time_left import clock_s
from pointpred.scoring.target_layouts import layouts
from pointpred.targets import Target, around, arrival
from pointpred.targets.aim import Memory as AimMemory
from pointpred.training import data

FILE = ROOT / "pointpred" / "predictors" / "adaptation" / "time_left_prior.py"
AMONG_TARGETS = ROOT / "pointpred" / "targets" / "arrival_prior.py"
PREDICTORS = ("kinematic", "kinematic-adaptive")
"""Among targets the weights are fitted behind both of these."""
MOVEMENTS = 2.0
"""Movements of the person that everybody's weights count for."""
RIDGE = 0.1
"""Share of the diagonal that is added to everybody's sums."""
ROUNDS = 30
"""Rounds of reweighting, for the least absolute error."""
MOST_WEIGHT = 8.0
"""No moment weighs more than so many of its set's clock errors."""
TEXT = '''"""Everybody's weights of the time left, fitted by ``python -m evidence person time_left``."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray

# Fitted to {movements:,} movements, each set counting as much as another, with predictions of coefficients
# that did not know the person:
# {names}.
PRIOR: FloatArray = np.array(
    (
{rows}
    )
)
"""The weights of the terms; then the sums of products of two movements, the lower triangle row after row."""
'''


class Movement(msgspec.Struct, frozen=True):
    """One movement after a person's first."""

    user: str
    state: FloatArray
    """What the law remembers of it."""
    span: tuple[float, float]
    """Its start and its arrival, s."""
    median: float
    """Of the person's durations before it, s; among targets their mean."""

    def judged(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Of each moment by which it is judged: the terms, the time left and the time passed, s."""
        state, k, rows = time_left.Movement(self.state), 0, []
        for n in range(JUDGED):
            k = time_left.moment_at(self.state, k, self.span, (n + 0.5) / JUDGED)
            rows.append(state.moments[k])
        t = np.array([one.t for one in rows])
        return np.array([one.terms for one in rows]), np.maximum(self.span[1] - t, 0.0), t - self.span[0]


class Set(msgspec.Struct, frozen=True):
    """The movements of a set, and what its clock has, s."""

    name: str
    movements: list[Movement]
    clock: float

    def clock_error(self) -> float:
        """Mean error of the clock, s."""
        parts = (one.judged() for one in self.movements)
        return float(np.mean([np.abs(left - np.maximum(self.clock - past, 0.0)) for _, left, past in parts]))


def gather(recording: Recording, coefficients: HeldOut) -> Set:
    """The movements of a set, each person predicted by coefficients that did not know them."""
    prepared = prepare(recording, threads=1)
    pipelines = coefficients.of_people("kinematic-adaptive", recording)
    movements = []
    for user in dict.fromkeys(one.trial.user for one in prepared.trials):
        pipeline = pipelines[user].fresh()
        for k in (k for k, one in enumerate(prepared.trials) if one.trial.user == user):
            run(pipeline, prepared.rows(k))
            memory = Memory(np.frombuffer(pipeline.predictor.remembered()))
            movements += movement(user, memory, prepared, k)
    return Set(recording.name, movements, clock_s([one.arrival_s for one in prepared.trials]))


def gather_among_targets(recording: Recording, predictor: str, coefficients: HeldOut) -> Set:
    """As ``gather``, each movement among its candidates."""
    prepared = prepare(recording, threads=1)
    among = {one.trial: targets_at(one.table) for same in layouts(prepared).values() for one in same}
    known = coefficients.of_people(predictor, recording) if predictor in trained_predictors() else {}
    movements, user = [], None
    for k in sorted(among, key=lambda k: (prepared.trials[k].trial.user, k)):
        if user != prepared.trials[k].trial.user:
            user = prepared.trials[k].trial.user
            pipeline = known[user].fresh() if known else build(predictor, **resolution(recording, None, None))
        pipeline.reset()
        pipeline.register(among[k])
        run(pipeline, EventColumns(prepared.rows(k).table))
        movements += movement(user, AimMemory(np.frombuffer(pipeline.aim.remembered())), prepared, k)
    name = f"{recording.name}, {predictor}"
    return Set(name, movements, clock_s([one.arrival_s for one in prepared.trials]))


def targets_at(table: FloatArray) -> list[Target]:
    """Targets that are named by their places."""
    places = [(x, y, width, height) for x, y, width, height, _ in table.tolist()]
    return [around(f"{x:.0f} {y:.0f}", x, y, width, height) for x, y, width, height in places]


def movement(user: str, memory: Memory | AimMemory, prepared: Prepared, k: int) -> list[Movement]:
    """The movement that a pipeline has just followed; none where nothing was known of the person."""
    state, known = memory.movement.time_left, memory.person.durations
    median = arrival.mean(known) if isinstance(memory, AimMemory) else float(known.median)
    if state.ready == 0.0:
        return []
    t, first = prepared.events.t, prepared.offsets[k]
    return [Movement(user, state.memory.copy(), (float(t[first]), float(t[prepared.arrivals[k]])), median)]


def fitted(sets: Sequence[Set]) -> FloatArray:
    """The prior: weights of the least absolute error, each set's in shares of its clock's, and their sums."""
    terms, left, weight = [], [], []
    for one in sets:
        error = one.clock_error()
        for movement in one.movements:
            known, seconds, _ = movement.judged()
            terms.append(known)
            left.append(seconds / movement.median)
            weight.append(np.full(JUDGED, min(movement.median / error, MOST_WEIGHT) / len(one.movements)))
    x, y, share = np.concatenate(terms), np.concatenate(left), np.concatenate(weight)
    share /= share.sum()
    weights = np.zeros(TERMS)
    for _ in range(ROUNDS):
        rows = x * (share / np.maximum(np.abs(y - x @ weights), SMALL))[:, None]
        sums = rows.T @ x
        weights = np.linalg.solve(sums + 1e-6 * np.eye(TERMS), rows.T @ y)
    precision = MOVEMENTS * (sums + RIDGE * np.diag(np.diag(sums)))
    prior = np.concatenate([weights, precision[np.tril_indices(TERMS)]])
    rounded: FloatArray = np.round(prior, 3)
    return rounded


def share_of_clock(one: Set, prior: FloatArray) -> float:
    """Error over that of the clock of a law that starts with this prior, at the moments it is judged by."""
    known: dict[str, tuple[FloatArray, FloatArray]] = {}
    errors = []
    for movement in one.movements:
        nobody = np.zeros(time_left.Sums.length), np.zeros(Intervals.length)
        sums, intervals = known.setdefault(movement.user, nobody)
        state = movement.state.copy()
        weights = time_left.Movement(state).weights
        time_left.solve(sums, prior, weights)
        terms, left, _ = movement.judged()
        errors.append(np.abs(np.maximum(terms @ weights, 0.0) * movement.median - left).mean())
        time_left.learn(sums, intervals, state, movement.span, movement.median, prior)
    return float(np.mean(errors) / one.clock_error())


def text(sets: Sequence[Set], prior: FloatArray) -> str:
    """The file of the prior."""
    rows, first = [], 0
    for count in (TERMS, *range(1, TERMS + 1)):
        numbers = ", ".join(str(value) for value in prior[first : first + count].tolist())
        rows.append(f"        *({numbers}{',' if count == 1 else ''}),")
        first += count
    movements = sum(len(one.movements) for one in sets)
    names = ", ".join(dict.fromkeys(one.name.split(",")[0] for one in sets))
    return TEXT.format(movements=movements, names=names, rows="\n".join(rows))


def write(sets: Sequence[Set], file: Path) -> None:
    """Fit, print what the weights are worth, and write them."""
    prior = fitted(sets)
    for one in sets:
        of = one.name.split(",")[0]
        others = fitted([other for other in sets if other.name.split(",")[0] != of])
        own, without = share_of_clock(one, prior), share_of_clock(one, others)
        print(f"{one.name}: {own:.3f}, fitted to the other sets {without:.3f}")
    file.write_text(text(sets, prior), encoding="utf-8")


def main(coefficients: HeldOut, recordings: Sequence[Recording]) -> None:
    """Write the weights without and with targets."""
    write([gather(recording, coefficients) for recording in recordings], FILE)
    among = [
        gather_among_targets(recording, predictor, coefficients)
        for recording in recordings
        for predictor in PREDICTORS
    ]
    write(among, AMONG_TARGETS)


if __name__ == "__main__":
    arguments = parse(__doc__, metavar="folder", most=1)
    folder = data.folder()
    main(stored(Path(arguments[0])) if arguments else held_out(folder), data.read_sets(folder))
