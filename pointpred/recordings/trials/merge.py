"""Merge recordings of one format: the sessions of a folder, the devices of a file."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from pointpred.recording import Recording, Skip, Trial


def join(
    name: str, parts: Sequence[Recording], labels: Sequence[str], notes: Sequence[str] = ()
) -> Recording:
    """One recording of all trials, skips and notes of ``parts``, in their order.

    With more than one part, trials are renamed ``<label> <trial>`` so that names stay unique. The provenance
    is the first part's: join only recordings of one format. Memory: a copy of all tables.
    """

    def named(label: str, trial: str) -> str:
        return trial if len(parts) == 1 else f"{label} {trial}"

    tables = [part.rows(index) for part in parts for index in range(len(part.trials))]
    trials: list[Trial] = []
    skipped: list[Skip] = []
    all_notes: list[str] = []
    for label, part in zip(labels, parts, strict=True):
        trials += [msgspec.structs.replace(trial, trial=named(label, trial.trial)) for trial in part.trials]
        skipped += [msgspec.structs.replace(skip, trial=named(label, skip.trial)) for skip in part.skipped]
        all_notes += [named(f"{label}:", note) for note in part.notes]
    return Recording.of(
        name, tables, _of_one_kind(trials), skipped, parts[0].provenance, [*all_notes, *notes]
    )


def _of_one_kind(trials: list[Trial]) -> list[Trial]:
    """The trials with text for a condition that is a number in some parts and text in others."""
    kinds: dict[str, set[bool]] = {}
    for trial in trials:
        for name, value in trial.condition.items():
            kinds.setdefault(name, set()).add(isinstance(value, str))
    mixed = {name for name, types in kinds.items() if len(types) > 1}
    return [
        msgspec.structs.replace(trial, condition=trial.condition | _in_words(trial.condition, mixed))
        for trial in trials
    ]


def _in_words(condition: dict[str, str | float], names: set[str]) -> dict[str, str]:
    """The conditions of these names as text; whole numbers without a point."""
    return {
        name: value if isinstance(value, str) else f"{value:.17g}"
        for name, value in condition.items()
        if name in names
    }
