"""Which rows belong to which trial, by their columns user and trial."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray

Codes = tuple[IntArray, list[str]]
"""For each row the index of its value among the distinct values, and these."""


def codes_of(column: Any) -> Codes:
    """The codes of a text column without missing values."""
    encoded = column.combine_chunks().dictionary_encode()
    return arrow_tables.as_array(encoded.indices).astype(np.int64), encoded.dictionary.to_pylist()


def keys_of(users: Codes, trials: Codes) -> tuple[IntArray, list[tuple[str, str]]]:
    """For each row the index of its trial, and (user, trial) of each in the order of first appearance."""
    (user, user_names), (trial, trial_names) = users, trials
    joint = user * max(len(trial_names), 1) + trial
    starts = np.flatnonzero(np.diff(joint, prepend=-1))
    unique, first, run = np.unique(joint[starts], return_index=True, return_inverse=True)
    rank = np.empty(len(unique), dtype=np.int64)
    rank[np.argsort(first)] = np.arange(len(unique))
    group = np.repeat(rank[run], np.diff(starts, append=len(joint)))
    keys = [(user_names[user[row]], trial_names[trial[row]]) for row in np.sort(starts[first])]
    return group, keys
