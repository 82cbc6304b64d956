"""The protocol of template matching for the results: KTM with a library of the same person, run again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import msgspec
import numpy as np

from pages.held_out import HeldOut
from pages.ktm import measure as ktm_protocol
from pages.markdown import table
from pages.results.scores import patterns
from pointpred import build
from pointpred.console import counted
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.scoring import ktm_protocol as protocol
from pointpred.scoring import prepare, resolution
from pointpred.scoring.ktm_protocol import Drawn, Read
from pointpred.scoring.summary.bootstrap import ratio_intervals

Json = dict[str, Any]

WORDS = """Pasqual and Wobbrock 2014, run again on the same trials ([ktm.md](ktm.md)): their predictor with a
library of all other movements of the same person against every predictor, which sees none of them but what
its own session brought. Errors in px at 50, 75 and 90 % of the straight distance; *of KTM*: that error over
KTM's, with its 95 % interval over people (trials where a set has one). Published: skill 63 / 57 / 13 %."""


def measured(recording: Recording, predictors: Sequence[str], held: HeldOut) -> list[Json]:
    """For each rule of drawing the trials: what was tested, and a row a predictor."""
    plain, by_person, _ = patterns(recording, predictors, held)
    settings = {k: v for k, v in resolution(recording, None, None).items() if v is not None}
    prepared = prepare(recording, **settings)
    found = []
    for monotone, rule in ktm_protocol.RULES:
        drawn = protocol.draw(prepared, only_monotone=monotone, share=1.0)
        if not drawn.tested:
            found.append({"rule": rule, "tested": 0, "rows": []})
            continue
        print(f"protocol of template matching: {recording.name}, {rule}", flush=True)
        others = [one if isinstance(one, Pipeline) else build(one, **settings) for one in plain]
        read = [protocol.without_library(drawn, one) for one in others]
        read += [_by_person(drawn, name, people) for name, people in by_person]
        floor = [one for one in read if one.name == ktm_protocol.FLOOR]
        results = [*floor, protocol.with_library(drawn), *(one for one in read if one not in floor)]
        found.append(
            {
                "rule": rule,
                "tested": len(drawn.tested),
                "users": len(drawn.libraries),
                "left_out": len(drawn.left_out),
                "distance_px": float(results[0].distances.mean()),
                "rows": [
                    (*row, share)
                    for row, share in zip(ktm_protocol.rows(results), _of_ktm(drawn, results), strict=True)
                ],
            }
        )
    return found


def _by_person(drawn: Drawn, name: str, people: Mapping[str, Pipeline]) -> Read:
    """Each trial read from the pipeline of its person."""
    users = [drawn.prepared.trials[k].trial.user for k in drawn.tested]
    patterns = {id(people[user]): people[user] for user in users}
    parts = {key: protocol.without_library(drawn, one) for key, one in patterns.items()}
    errors = [parts[id(people[user])].errors[row] for row, user in enumerate(users)]
    first = next(iter(parts.values()))
    return msgspec.structs.replace(first, name=name, errors=np.array(errors))


def _of_ktm(drawn: Drawn, results: Sequence[Read]) -> list[str]:
    """Mean error over that of KTM with its library, with intervals."""
    users = [drawn.prepared.trials[k].trial.user for k in drawn.tested]
    matched = results[1]
    said = []
    for one in results:
        bounds = ratio_intervals(one.errors, matched.errors, users)
        ratios = one.mean_px() / matched.mean_px()
        cells = zip(ratios.tolist(), bounds.low.tolist(), bounds.high.tolist(), strict=True)
        said.append(" / ".join(f"{ratio:.2f} [{low:.2f}, {high:.2f}]" for ratio, low, high in cells))
    return said


def section(found: Sequence[Json]) -> list[str]:
    """The tables of one set."""
    parts = []
    for one in found:
        if not one["rows"]:
            parts.append(f"*{one['rule']}*: no person has the movements that a library needs.")
            continue
        parts.append(
            f"*{one['rule']}*: {counted(one['tested'], 'trial')} of {counted(one['users'], 'user')}, mean "
            f"distance {one['distance_px']:.0f} px; {one['left_out']} left out."
        )
        parts.append(table((*ktm_protocol.HEADER, "of KTM"), one["rows"]))
    return parts
