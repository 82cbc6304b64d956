"""Template matching in its own protocol, beside every predictor: part of ``make results``.

Pasqual and Wobbrock 2014: their predictor with a library of all other movements of the same person against
predictors that see none of these but what their own session brought.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import msgspec
import numpy as np

from pages.held_out import HeldOut
from pages.results.scores import patterns
from pointpred import build
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.scoring import FLOOR, prepare, resolution
from pointpred.scoring import ktm_protocol as protocol
from pointpred.scoring.ktm_protocol import ProtocolErrors, ProtocolSummary, Selection, summarise_protocol


def measured(recording: Recording, predictors: Sequence[str], held: HeldOut) -> tuple[ProtocolSummary, ...]:
    """The published rule of drawing trials, and all trials."""
    plain, by_person, _ = patterns(recording, predictors, held)
    settings = {k: v for k, v in resolution(recording, None, None).items() if v is not None}
    prepared = prepare(recording, **settings)
    summaries = []
    for monotone in (True, False):
        selection = protocol.select(prepared, only_monotone=monotone, share=1.0)
        reads: list[ProtocolErrors] = []
        if selection.tested:
            print(f"protocol of template matching: {recording.name}", flush=True)
            others = [one if isinstance(one, Pipeline) else build(one, **settings) for one in plain]
            read = [protocol.without_library(selection, one) for one in others]
            read += [_by_person(selection, name, people) for name, people in by_person]
            floor = [one for one in read if one.name == FLOOR]
            reads = [*floor, protocol.with_library(selection), *(one for one in read if one not in floor)]
        summaries.append(summarise_protocol(selection, reads, monotone=monotone))
    return tuple(summaries)


def _by_person(selection: Selection, name: str, people: Mapping[str, Pipeline]) -> ProtocolErrors:
    """Each trial read from the pipeline of its person."""
    users = [selection.prepared.trials[k].trial.user for k in selection.tested]
    patterns = {id(people[user]): people[user] for user in users}
    parts = {key: protocol.without_library(selection, one) for key, one in patterns.items()}
    errors = [parts[id(people[user])].errors[row] for row, user in enumerate(users)]
    first = next(iter(parts.values()))
    return msgspec.structs.replace(first, name=name, errors=np.array(errors))
