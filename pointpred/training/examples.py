"""Recordings as examples: features of a moment, where the movement ended from there, and how long it took."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import ParameterError
from pointpred.predictors.kinematic import features as kinematic_features
from pointpred.predictors.kinematic import observation
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.registry import build
from pointpred.scoring import prepare
from pointpred.scoring.measures.endpoint import WEIGHT_S

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
    features = np.zeros((len(motions), kinematic_features.FEATURES))
    frames = np.zeros((len(motions), 3))
    memory = np.zeros(observation.STATES)
    observation.observe_all(memory, prepared.events.begin, motions, features, frames)
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
