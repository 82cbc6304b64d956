"""Counts the rows of a file: read, left out with a reason, or lost without one."""

from __future__ import annotations

import re
from collections import Counter

import msgspec
import numpy as np
import pandas as pd

from pointpred.recording import Recording

ROWS = re.compile(r"rows (\d+) to (\d+)")
NUMBER = re.compile(r"-?\d+(\.\d+)?(e[+-]?\d+)?")
NOTE = re.compile(
    r"(?:.*: )?((?:wheel |further )?(?:rows|frames|reports|samples)\b[^:]*left (?:out|aside)): (\d+)"
)


class Account(msgspec.Struct, frozen=True):
    """Trials and rows read; rows left out by reason; rows that nothing explains; the largest differences."""

    trials: int
    read: int
    left: dict[str, int]
    lost: int
    px: float
    s: float

    @property
    def agrees(self) -> bool:
        """Whether every row is accounted for and every value is the same but for rounding."""
        return not self.lost and self.px <= 1e-6 and self.s <= 1e-6


def account(rows: pd.DataFrame, recording: Recording) -> Account:
    """Compare a recording with the independent reading ``rows`` of the same file."""
    keys = list(zip(rows["user"], rows["trial"], strict=True))
    place = {(trial.user, trial.trial): index for index, trial in enumerate(recording.trials)}
    owner = np.array([place.get(key, -1) for key in keys], dtype=np.int64)
    owner[~rows[["t", "x", "y"]].notna().all(axis=1)] = -1  # a sample without a position belongs to no trial
    left = _left(rows, owner < 0, recording)
    lost = int(np.count_nonzero(owner < 0)) - sum(left.values())
    px = s = 0.0
    order = np.argsort(owner[owner >= 0], kind="stable")
    values = rows.loc[owner >= 0, ["t", "x", "y"]].to_numpy(dtype=float)[order]
    sizes = np.bincount(owner[owner >= 0], minlength=len(place))
    starts = np.concatenate([[0], np.cumsum(sizes)])
    for index in range(len(recording.trials)):
        mine, events = values[starts[index] : starts[index + 1]], recording.rows(index)
        if len(mine) != len(events):
            lost += abs(len(mine) - len(events))
            continue
        px = max(px, *np.abs(mine[:, 1] - events.x), *np.abs(mine[:, 2] - events.y))
        s = max(s, *np.abs(mine[:, 0] - mine[0, 0] - events.t))
    return Account(len(recording.trials), len(recording.events), left, lost, px, s)


def _left(rows: pd.DataFrame, out: np.ndarray, recording: Recording) -> dict[str, int]:
    """Rows left out by reason: by the skips that name them, then by the notes that count them."""
    left: Counter[str] = Counter()
    remaining = out.copy()
    number, user, trial = (rows[name].to_numpy() for name in ("row", "user", "trial"))
    named = {(one.user, one.trial): one.reason for one in recording.skipped}
    for at in np.flatnonzero(remaining):
        reason = named.get((user[at], trial[at])) or named.get((None, trial[at]))
        if reason and trial[at]:
            left[reason] += 1
            remaining[at] = False
    for skip in recording.skipped:
        if span := ROWS.fullmatch(skip.trial):
            mine = remaining & (number >= int(span[1])) & (number <= int(span[2]))
            mine &= skip.user in (None, "unknown") or (user == skip.user)
            left[skip.reason] += int(mine.sum())
            remaining &= ~mine
    rest = int(remaining.sum())
    for note in recording.notes:
        if match := NOTE.match(note):
            count = min(rest, int(match[2]))
            left[match[1]] += count
            rest -= count
    return _alike(left)


def _alike(left: Counter[str]) -> dict[str, int]:
    """Reasons that differ in numbers alone as one, with an ellipsis for each number."""
    groups: dict[str, list[str]] = {}
    for reason in left:
        groups.setdefault(NUMBER.sub("...", reason), []).append(reason)
    counts = {
        some[0] if len(some) == 1 else like: sum(left[one] for one in some) for like, some in groups.items()
    }
    return {reason: count for reason, count in counts.items() if count}
