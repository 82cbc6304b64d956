"""The sets a folder holds, their people, and who is held out when."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.recording import Recording
from pointpred.scoring.executors import Caller, Executor
from pointpred.training.examples import Examples, examples
from pointpred.training.variants import varied

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
    from pointpred.sources import read

    paths = {name: where / f"{name}_samples.parquet" for name in SETS}
    recordings = [read(path) for path in paths.values() if path.is_file()]
    if not recordings:
        message = f"POINTPRED_RECORDINGS must hold one of {', '.join(SETS)}, holds none"
        raise ParameterError(message, field="POINTPRED_RECORDINGS", value=str(where))
    return recordings
