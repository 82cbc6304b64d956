"""Several recordings of one kind as one: the sessions of a folder, the devices of a file."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from pointpred.recording import Recording, Skip, Trial


def join(
    name: str, parts: Sequence[Recording], labels: Sequence[str], notes: Sequence[str] = ()
) -> Recording:
    """One recording of all trials, skips and notes of ``parts``, in their order.

    Trials are renamed ``<label> <trial>`` where there is more than one part, so that names stay unique.
    The provenance is the first part's: join only recordings of one format. Memory: a copy of all tables.
    """

    def named(label: str, trial: str) -> str:
        return trial if len(parts) == 1 else f"{label} {trial}"

    tables = [part.rows(index) for part in parts for index in range(len(part.trials))]
    trials: list[Trial] = []
    skipped: list[Skip] = []
    said: list[str] = []
    for label, part in zip(labels, parts, strict=True):
        trials += [msgspec.structs.replace(trial, trial=named(label, trial.trial)) for trial in part.trials]
        skipped += [msgspec.structs.replace(skip, trial=named(label, skip.trial)) for skip in part.skipped]
        said += [named(f"{label}:", note) for note in part.notes]
    return Recording.of(name, tables, trials, skipped, parts[0].provenance, [*said, *notes])
