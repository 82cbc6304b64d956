"""Movements to draw: of simulated people, or of the recording that the user names."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec

from pointpred.errors import ParameterError
from pointpred.recording import Recording
from pointpred.recordings import read_any
from pointpred.scoring import Prepared, prepare, resolution
from pointpred.simulation import Condition, Person, people, simulate_circle, thesis_setup

SEED = 1
CPI = 2000.0
"""Counts per inch of the thesis's mouse and of the simulated one."""
CONDITION = Condition(150.0, 7.0, "constant")
"""The larger distance and width in mm, with the constant gain of 4."""
READS = "a recording"


class Movements(msgspec.Struct, frozen=True):
    """The scored trials of a recording, the settings that its pipelines need, and whose they are."""

    recording: Recording
    prepared: Prepared
    settings: dict[str, Any]
    words: str

    def first(self, *, divided: bool) -> int:
        """The first trial with or without sub-movements; raises ParameterError where there is none."""
        for k, trial in enumerate(self.prepared.trials):
            if trial.submovements == divided:
                return k
        kind = "with" if divided else "without"
        raise ParameterError(
            f"{self.recording.name} has no trial {kind} sub-movements: name another recording"
        )


def novice_and_expert() -> tuple[Person, Person]:
    """The least and the most skilled of ten simulated people."""
    ten = sorted(people(10, SEED), key=lambda one: one.skill)
    return ten[0], ten[-1]


def movements(data: Path | None) -> Movements:
    """The named recording, or one circle of a simulated novice and of a simulated expert."""
    if data is None:
        return _prepared(simulate_circle(novice_and_expert(), [CONDITION], seed=SEED, name="two people"))
    return _prepared(_read(data))


def experiment(data: Path | None) -> Movements:
    """The named recording, or the thesis's experiment of 960 trials with ten simulated people."""
    return _prepared(thesis_setup(SEED) if data is None else _read(data))


def _read(data: Path) -> Recording:
    found = read_any(data)
    if len(found) > 1:
        names = ", ".join(one.name for one in found[:5])
        more = ", ..." if len(found) > 5 else ""
        raise ParameterError(f"{data} holds {len(found)} recordings ({names}{more}): name one of them")
    return found[0]


def _prepared(recording: Recording) -> Movements:
    given = resolution(recording, None, None)
    settings = {name: value for name, value in given.items() if value is not None}
    whose = "simulated people" if recording.provenance.simulated else recording.name
    return Movements(recording, prepare(recording, **settings), settings, whose)
