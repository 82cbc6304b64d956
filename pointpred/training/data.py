"""Recordings as examples to learn from, as people moved and as they might have, and who is held out when."""

from __future__ import annotations

import os
from collections.abc import Callable
from math import cos, log, pi, sin
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import ParameterError
from pointpred.predictors.kinematic import features as kinematic_features
from pointpred.recording import Recording
from pointpred.records import EventColumns, FloatArray
from pointpred.registry import build
from pointpred.scoring import prepare
from pointpred.scoring.executors import Caller, Executor
from pointpred.scoring.measures.endpoint import WEIGHT_S

TEMPO = (0.35, 1.6)
"""Bounds on how much longer a movement is made, even on a logarithmic scale."""
SIZE = (0.4, 2.5)
"""Bounds on how much larger a movement is made, even on a logarithmic scale."""
TINY, TINY_TEMPO, TINY_SHARE = (0.1, 0.4), (0.25, 1.6), 0.13
"""The same for this share of them: where no flick goes some dozen px every start looks like a long way."""
RATES_HZ = (60.0, 75.0, 100.0, 125.0, 200.0, 250.0, 500.0, 1000.0)
ROUGH_SHARE = 0.3
"""Share of movements that run on straight lines between their samples instead of smoothly."""


def varied(recording: Recording, seed: int) -> Recording:
    """Every trial stretched in time, scaled, turned, mirrored and resampled at random, in whole pixels.

    Of samples of one time the last counts; trials of fewer than three times stay as they are but for that.
    Counts are left out.
    """
    random = np.random.default_rng(seed)
    paths = []
    for number in range(len(recording.trials)):
        first, stop = int(recording.offsets[number]), int(recording.offsets[number + 1])
        paths.append(_vary(recording.events.table[first:stop], random))
    return Recording.of(recording.name, paths, recording.trials)


def _vary(table: FloatArray, random: np.random.Generator) -> EventColumns:
    bounds = (TINY_TEMPO, TINY) if random.random() < TINY_SHARE else (TEMPO, SIZE)
    tempo, size = (float(np.exp(random.uniform(log(low), log(high)))) for low, high in bounds)
    angle, mirror = float(random.uniform(0.0, 2.0 * pi)), 1.0 if random.random() < 0.5 else -1.0
    rate, rough = float(random.choice(RATES_HZ)), bool(random.random() < ROUGH_SHARE)
    table = table[np.append(np.diff(table[:, 0]) > 0.0, True)]  # of events at one time the last counts
    if len(table) < 3:
        return EventColumns.of(table[:, 0], table[:, 1], table[:, 2])
    t = (table[:, 0] - table[0, 0]) * tempo
    place = (table[:, 1:3] - table[0, 1:3]) * size
    turned = place @ np.array([[cos(angle), sin(angle)], [-mirror * sin(angle), mirror * cos(angle)]])
    grid = np.append(np.arange(0.0, t[-1] - 0.5 / rate, 1.0 / rate), t[-1])
    return EventColumns.of(grid, *np.round(_between(t, turned, grid, rough)).T)


def _between(t: FloatArray, place: FloatArray, grid: FloatArray, rough: bool) -> FloatArray:
    """Positions at other times: on lines, or on a curve that overshoots nowhere."""
    from scipy.interpolate import PchipInterpolator

    if rough:
        return np.stack([np.interp(grid, t, axis) for axis in place.T], axis=1)
    smooth: FloatArray = np.asarray(PchipInterpolator(t, place)(grid), dtype=np.float64)
    return smooth


APART_S = 0.025
"""Moments of one movement are drawn about so far apart: closer ones say the same."""


class Examples(msgspec.Struct, frozen=True):
    """Moments of movements, a row each; everything that has a length is in px or s."""

    features: NDArray[np.float32]
    reach: FloatArray
    along: FloatArray
    """From the cursor to the endpoint, along the direction from the start to the cursor."""
    across: FloatArray
    left_s: FloatArray
    """Time until the arrival."""
    share: FloatArray
    """How much of the time from onset to arrival has passed."""
    weight: FloatArray
    """Share of its trial's time that a moment stands for."""
    trial: NDArray[np.int64]
    set: NDArray[np.int64]
    user: NDArray[np.int64]
    own: NDArray[np.bool_]
    """Whether the movement is as it was made: neither its tempo nor its size was changed."""

    def only(self, rows: NDArray[Any]) -> Examples:
        """Some of the rows."""
        return Examples(**{name: getattr(self, name)[rows] for name in self.__struct_fields__})

    def hold(self) -> FloatArray:
        """The error of the cursor's own position."""
        error: FloatArray = np.hypot(self.along, self.across)
        return error


def examples(
    recording: Recording, set_number: int, users: dict[str, int], seed: int, *, own: bool = True
) -> Examples:
    """Examples of one recording; ``users`` numbers the users of all sets, named set and user.

    Raises ParameterError for a recording in which nobody moves.
    """
    prepared = prepare(recording, threads=1)
    if not prepared.trials:
        message = f"{recording.name} must hold a movement to learn from, holds none"
        raise ParameterError(message, field="recording", value=recording.name)
    motions = build("hold").differentiator.run(prepared.events).table
    features = np.zeros((len(motions), kinematic_features.Values.length))
    frames = np.zeros((len(motions), 3))
    memory = kinematic_features.State(np.zeros(kinematic_features.State.length))
    kinematic_features.observe_all(memory, prepared.events.begin, motions, features, frames)
    first, last = prepared.offsets[:-1], prepared.offsets[1:] - 1
    trial = np.repeat(np.arange(len(first)), last + 1 - first)
    t, x, y = motions[:, 0], motions[:, 1], motions[:, 2]
    dx, dy = x[last][trial] - x, y[last][trial] - y
    weight = np.append(np.minimum(np.diff(t), WEIGHT_S), 0.0)
    weight[np.arange(len(t)) >= prepared.arrivals[trial]] = 0.0
    weight /= np.bincount(trial, weight, len(first))[trial]
    passed, whole = t - t[first][trial], (t[prepared.arrivals] - t[first])[trial]
    user = np.array([users[f"{recording.name} {one.trial.user}"] for one in prepared.trials])
    every = Examples(
        features.astype(np.float32),
        frames[:, 0],
        dx * frames[:, 1] + dy * frames[:, 2],
        dy * frames[:, 1] - dx * frames[:, 2],
        np.maximum(whole - passed, 0.0),
        passed / whole,
        weight,
        trial,
        np.full(len(t), set_number),
        user[trial],
        np.full(len(t), own),
    )
    return _thinned(every, passed, np.random.default_rng(seed))


def _thinned(every: Examples, passed: FloatArray, random: np.random.Generator) -> Examples:
    """One moment of each stretch of time, drawn by its weight, with the weight of the whole stretch."""
    key = every.trial * 10**6 + np.floor(passed / APART_S).astype(np.int64)
    rows = np.flatnonzero((every.weight > 0.0) & (every.reach > 0.0))
    # The largest of u^(1/w) is drawn with probability proportional to w.
    order = rows[np.lexsort((np.log(random.random(len(rows))) / every.weight[rows], key[rows]))]
    final = np.append(np.diff(key[order]) != 0, True)
    total = np.add.reduceat(every.weight[order], np.flatnonzero(np.append(True, final[:-1])))
    sample = every.only(order[final])
    return msgspec.structs.replace(sample, weight=total)


def join(parts: list[Examples]) -> Examples:
    """Examples of several recordings, their trials numbered through."""
    numbered, trials = [], 0
    for part in parts:
        numbered.append(msgspec.structs.replace(part, trial=part.trial + trials))
        trials += int(part.trial.max()) + 1
    names = Examples.__struct_fields__
    return Examples(**{name: np.concatenate([getattr(part, name) for part in numbered]) for name in names})


SETS = {
    "freihaut2021": "GPL-3.0",
    "pvplib23714": "GPL-3.0",
    "cryslacks": "MIT",
    "kh2017": "GPL-3",
    "humanmovemouse": "MIT",
    "gofitts_demo": "MIT",
    "jrcalgo": "MIT",
}
"""The sets trained on, with their licences."""
FOLDS = 5
VARIANTS = 6
"""How often each movement is seen otherwise."""

Log = Callable[[str], None]


class TrainingData(msgspec.Struct, frozen=True):
    """Everything there is to learn from: recordings, examples, users numbered through all sets."""

    recordings: tuple[Recording, ...]
    own: tuple[Examples, ...]
    """Of each set, as its people moved."""
    varied: tuple[Examples, ...]
    """Of each set and variant, one set after another."""
    users: dict[str, int]
    """``set user`` to a number; one number for one person."""

    def fold(self) -> dict[int, int]:
        """The fold of each user: those of all sets dealt in turn, in an order that a seed fixes."""
        order = np.random.default_rng(0).permutation(len(set(self.users.values()))).tolist()
        return {user: place % FOLDS for place, user in enumerate(order)}


def folder() -> Path:
    """The folder of recordings; raises ParameterError where the environment names none."""
    named = os.environ.get("POINTPRED_RECORDINGS")
    if not named or not Path(named).is_dir():
        message = f"POINTPRED_RECORDINGS must name a folder of recordings, received {named!r}"
        raise ParameterError(message, field="POINTPRED_RECORDINGS", value=named)
    return Path(named)


def numbered(recordings: list[Recording], *, by_name: bool = False) -> dict[str, int]:
    """``set user`` to a number; ``by_name``: users of one name have one number in all recordings."""
    users: dict[str, int] = {}
    numbers: dict[str, int] = {}
    for recording in recordings:
        for trial in recording.trials:
            key = f"{recording.name} {trial.user}"
            users.setdefault(key, numbers.setdefault(trial.user if by_name else key, len(numbers)))
    return users


class Collection(msgspec.Struct, frozen=True):
    """One recording of which examples are made, as it is or in one of its variants."""

    recording: Recording
    number: int
    users: dict[str, int]
    seed: int
    own: bool


def training_data(
    recordings: list[Recording],
    seed: int,
    log: Log,
    variants: int = VARIANTS,
    *,
    by_name: bool = False,
    executor: Executor | None = None,
) -> TrainingData:
    """Make the examples of recordings; ``by_name``: users of one name are one person in all of them.

    ``executor``: where the recordings and their variants are worked on, by default here; the examples are the
    same, bit for bit.
    """
    users = numbered(recordings, by_name=by_name)
    collections = [
        Collection(recording, number, users, seed if own else seed + 1000 * (number + 1) + variant, own)
        for number, recording in enumerate(recordings)
        for variant, own in [(0, True), *((variant, False) for variant in range(variants))]
    ]
    made = dict((executor or Caller()).each(collect, collections))
    each = [
        [made[number * (variants + 1) + k] for k in range(variants + 1)] for number in range(len(recordings))
    ]
    for recording, (own, *_) in zip(recordings, each, strict=True):
        log(f"{recording.name}: {len(recording.trials)} trials, {len(own.reach)} moments")
    return TrainingData(
        tuple(recordings),
        tuple(own for own, *_ in each),
        tuple(one for _, *otherwise in each for one in otherwise),
        users,
    )


def collect(one: Collection) -> Examples:
    """The examples of one recording or variant."""
    recording = one.recording if one.own else varied(one.recording, one.seed)
    return examples(recording, one.number, one.users, one.seed, own=one.own)


def read_sets(where: Path) -> list[Recording]:
    """The known sets that a folder holds; raises ParameterError where it holds none."""
    from pointpred.recordings import read

    paths = {name: where / f"{name}_samples.parquet" for name in SETS}
    recordings = [read(path) for path in paths.values() if path.is_file()]
    if not recordings:
        message = f"POINTPRED_RECORDINGS must hold one of {', '.join(SETS)}, holds none"
        raise ParameterError(message, field="POINTPRED_RECORDINGS", value=str(where))
    return recordings
