"""Score every predictor on every set at hand: ``make results``.

Sets are the embedded sample and the recordings in the folder that POINTPRED_RECORDINGS names. Each is
written to ``evidence/results/data/SET.json``; ``make docs`` shows them. What has learned from recordings is
judged by coefficients that did not see the set, or the person: ``evidence.held_out`` fits them, which takes
minutes once.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path

import msgspec
import numpy as np

from evidence import held_out, sets
from evidence.arguments import parse
from evidence.held_out import PEOPLE_OUT, SET_OUT, HeldOut, trained_predictors, training_sets
from evidence.results.records import FOLDER, SetResults, write
from pointpred import REGISTRY
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.registry import settings_in
from pointpred.scoring import PredictorErrors, SetScore, prepare, replay, resolution, score, summarise
from pointpred.scoring.scorer import with_ablations
from pointpred.scoring.trials import Prepared

ARRAYS = ("time_averaged", "by_time", "by_path", "single_axis", "coverage")
CLAIMS = ("calibration", "inside_by_time", "time_left", "time_inside_by_time", "hits")


def patterns(
    recording: Recording, predictors: Sequence[str], held: HeldOut
) -> tuple[list[str | Pipeline], list[tuple[str, dict[str, Pipeline]]], list[str]]:
    """What may judge a recording: names and pipelines; pipelines by person; what cannot be, in words."""
    plain: list[str | Pipeline] = []
    by_person, missing = [], []
    for name in predictors:
        if settings_in(name)[0] not in trained_predictors() or recording.name not in training_sets():
            plain.append(name)
            continue
        alone = held.of_set(name, recording)
        if alone is None:
            missing.append(f"`{name}{SET_OUT}`: no other set at hand to learn from")
        else:
            plain.append(alone)
        if name not in trained_predictors():
            continue  # the sets say what memory gains
        people = held.of_people(name, recording)
        unknown = {trial.user for trial in recording.trials} - people.keys()
        if unknown:
            missing.append(f"`{name}{PEOPLE_OUT}`: {len(unknown)} people of the set are in no fold")
        else:
            by_person.append((name + PEOPLE_OUT, people))
    return plain, by_person, missing


def scored(recording: Recording, predictors: Sequence[str], held: HeldOut, seed: int) -> SetScore:
    """The set's score; rows of what has learned stand last."""
    plain, by_person, missing = patterns(recording, predictors, held)
    (whole,) = score([recording], plain, seed=seed)
    prepared = prepare(recording, **resolution(recording, None, None)) if by_person else None
    rows = [replay_by_person(prepared, name, people) for name, people in by_person if prepared is not None]
    rows = [*whole.predictors, *rows]
    notes = [f"not scored: {one}" for one in missing]
    return msgspec.structs.replace(whole, predictors=tuple(rows), notes=(*whole.notes, *notes))


def replay_by_person(prepared: Prepared, name: str, people: Mapping[str, Pipeline]) -> PredictorErrors:
    """Each trial judged by the pipeline of its person; those of the others are thrown away."""
    users = np.array([one.trial.user for one in prepared.trials], dtype=str)
    chosen = {id(people[user]): people[user] for user in np.unique(users).tolist()}
    parts = {key: replay(prepared, pattern) for key, pattern in chosen.items()}
    mask = {key: np.array([id(people[user]) == key for user in users.tolist()]) for key in parts}
    first = next(iter(parts.values()))
    whole = {field: getattr(first, field).copy() for field in ARRAYS}
    for field in CLAIMS:
        some = next((getattr(one, field) for one in parts.values() if getattr(one, field) is not None), None)
        whole[field] = None if some is None else np.full_like(some, np.nan)
    for key, part in parts.items():
        for field, values in whole.items():
            if values is not None and getattr(part, field) is not None:
                values[mask[key]] = getattr(part, field)[mask[key]]
    own = {user: id(pattern) for user, pattern in people.items()}
    failed = [skip for key, part in parts.items() for skip in part.failed if own[str(skip.user)] == key]
    learns = any(pattern.learns for pattern in chosen.values())
    cost = float(np.mean([part.us_per_event for part in parts.values()]))
    return PredictorErrors(name, **whole, us_per_event=cost, failed=tuple(failed), learns=learns)


SEED = 0


def results_of(recording: Recording, predictors: Sequence[str], held: HeldOut) -> SetResults:
    """Every predictor on one set."""
    began = time.monotonic()
    print(f"scoring {recording.name}: {len(recording.events)} events", flush=True)
    summary = summarise(scored(recording, predictors, held, SEED))
    print(f"{recording.name}: {time.monotonic() - began:.0f} s", flush=True)
    versions = {name: version(name) for name in ("pointpred", "numpy")}
    return SetResults(versions, summary)


def measure(folder: Path | None, predictors: Sequence[str], out: Path = FOLDER) -> dict[str, str]:
    """Score every set and keep its results; returns why files could not be read, by name."""
    unread: dict[str, str] = {}
    learns = any(settings_in(name)[0] in held_out.trained_predictors() for name in predictors)
    held = held_out.held_out(folder if learns else None)
    for recording in sets.recordings(folder, unread):
        print(f"wrote {write(results_of(recording, predictors, held), out)}")
    return unread


if __name__ == "__main__":
    parse(__doc__)
    for reason in measure(sets.folder(), with_ablations(list(REGISTRY))).values():
        print(f"not read: {reason}")
