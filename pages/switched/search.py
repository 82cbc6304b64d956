"""The search for the five constants of ``switched-direction``: ``python -m pages.switched.measure search``.

Seeded, on half the users of freihaut2021 alone. A set of one distance and one pace would teach that pace, so
its movements are also played at 0.25 to 1.6 times their time, and as a mouse of 1 kHz would report them, in
whole pixels: what is chosen has to serve all of them. The bound by the stopping distance is physics and not
searched: it stands aside, and what is left is said by the approach alone.
"""

from __future__ import annotations

import os
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.predictors import SwitchedDirectionPredictor
from pointpred.recordings import read
from pointpred.records import BoolArray, EventColumns, FloatArray, MotionColumns
from pointpred.scoring import Prepared, prepare
from pointpred.scoring.measures import endpoint

SEED = 0
STEPS = 100
PACES, DENSE_PACES = (0.25, 0.5, 1.0, 1.6), (0.3, 1.0)
GAINS = (100.0,)
NAMES = ("rise", "typical_s", "own", "turn", "watched")
LOW, HIGH = np.array([0.05, 0.005, 0.0, 0.05, 0.0]), np.array([2.0, 0.5, 1.0, 1.0, 3.0])
FIRST, STEP = np.array([0.35, 0.05, 0.5, 0.5, 0.45]), np.array([0.15, 0.02, 0.2, 0.2, 0.2])
WEIGHT = 0.3
"""Of what the error at deciles of the time exceeds that of no prediction by."""


class Played(msgspec.Struct, frozen=True):
    """Movements at one pace: motions, where trials begin and arrive, and the errors of no prediction."""

    motions: MotionColumns
    begin: BoolArray
    offsets: NDArray[np.int64]
    arrivals: NDArray[np.int64]
    floor: FloatArray


def learners(prepared: Prepared) -> list[int]:
    """The trials of half the users, drawn by the seed."""
    users = sorted({trial.trial.user for trial in prepared.trials})
    order = np.random.default_rng(SEED).permutation(len(users))[: len(users) // 2]
    chosen = {users[i] for i in order.tolist()}
    return [k for k, trial in enumerate(prepared.trials) if trial.trial.user in chosen]


def retimed(rows: FloatArray, pace: float, dense: bool) -> FloatArray:
    """A trial at another pace; ``dense``: a whole pixel every millisecond."""
    rows = rows.copy()
    rows[:, 0] = pace * (rows[:, 0] - rows[0, 0])
    if not dense:
        return rows
    t = np.arange(0.0, rows[-1, 0], 0.001)
    table = np.full((len(t), rows.shape[1]), np.nan)
    table[:, 0], table[:, 5] = t, 0.0
    for column in (1, 2):
        table[:, column] = np.round(np.interp(t, rows[:, 0], rows[:, column]))
    return table


def play(prepared: Prepared, trials: list[int], pace: float, dense: bool, gain: float) -> Played:
    """The chosen trials at one pace, through the differentiator."""
    parts, arrivals, offsets = [], [], [0]
    for k in trials:
        rows = prepared.rows(k).table
        part = retimed(rows, pace, dense)
        arrival = rows[prepared.arrivals[k] - prepared.offsets[k], 0] - rows[0, 0]
        arrivals.append(offsets[-1] + min(int(np.searchsorted(part[:, 0], pace * arrival)), len(part) - 2))
        offsets.append(offsets[-1] + len(part))
        parts.append(part)
    begin = np.zeros(offsets[-1], np.bool_)
    begin[offsets[:-1]] = True
    events = EventColumns(np.concatenate(parts), begin)
    motions = HomogeneousDifferentiator(gain_lambda=gain, gain_xi=1.6, alpha=0.0).run(events)
    where = np.array(offsets), np.array(arrivals)
    silence = np.full((len(begin), 10), np.nan)
    return Played(motions, begin, *where, errors(motions, silence, *where))


def errors(
    motions: MotionColumns, answers: FloatArray, offsets: NDArray[np.int64], arrivals: NDArray[np.int64]
) -> FloatArray:
    """Time-averaged error, then the errors by time, in the mean over trials."""
    out = np.empty((len(offsets) - 1, endpoint.MEASURES))
    faults = np.empty(len(offsets) - 1, dtype=np.int64)
    endpoint.measure(motions.table, answers, endpoint.FRACTIONS, offsets, arrivals, out, faults)
    chosen = [endpoint.TIME_AVERAGED, *range(endpoint.BY_TIME, endpoint.BY_PATH)]
    means: FloatArray = out[:, chosen].mean(axis=0)
    return means


def loss(played: list[Played], constants: FloatArray) -> float:
    """Mean share of the error of no prediction, and a share of what deciles are worse by."""
    values = dict(zip(NAMES, constants.tolist(), strict=True))
    total = 0.0
    for one in played:
        predictor = SwitchedDirectionPredictor(**values, stopping=1e6)
        answers = predictor.run(one.motions, one.begin).table
        shares = errors(one.motions, answers, one.offsets, one.arrivals) / one.floor
        total += float(shares[0] + WEIGHT * np.maximum(0.0, shares[1:] - 1.0).sum())
    return total / len(played)


def search() -> None:
    """Random steps from one start; those that help are kept."""
    folder = os.environ.get("POINTPRED_RECORDINGS")
    if not folder:
        raise SystemExit("POINTPRED_RECORDINGS must name a folder with freihaut2021_samples.parquet")
    prepared = prepare(read(Path(folder) / "freihaut2021_samples.parquet"))
    trials = learners(prepared)
    for gain in GAINS:
        played = [play(prepared, trials, pace, False, gain) for pace in PACES]
        played += [play(prepared, trials, pace, True, gain) for pace in DENSE_PACES]
        random = np.random.default_rng(SEED)
        best, least = FIRST, loss(played, FIRST)
        for _ in range(STEPS):
            moved = random.normal(size=5) * STEP * (random.random(5) < 0.5) * random.choice([0.3, 1.0])
            tried = np.clip(best + moved, LOW, HIGH)
            trial_loss = loss(played, tried)
            if trial_loss < least:
                best, least = tried, trial_loss
        chosen = ", ".join(f"{name} {value:.3f}" for name, value in zip(NAMES, best, strict=True))
        print(f"gain_lambda {gain:g}: loss {least:.4f} with {chosen}", flush=True)
