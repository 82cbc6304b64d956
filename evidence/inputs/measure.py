"""Public recordings, each beside an independent reading: ``python -m evidence inputs FOLDER``.

``inputs.toml`` lists the files. They are fetched by hand into FOLDER, where each lies at
``OWNER+NAME/PATH``; the project ships none of them. Keeps the numbers; with ``--partial``
also where files are missing or differ from those of the list. Ends in an error where rows
are lost, values differ or a file is refused without a reason in the list.
"""

from __future__ import annotations

import argparse
import hashlib
import re
import shlex
import sys
import tomllib
import warnings
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pandas as pd

from evidence.data import Table, file_of, keep
from evidence.inputs.independent import LAYOUTS
from pointpred.errors import PointpredError
from pointpred.recording import Recording
from pointpred.recordings import read_any
from pointpred.recordings.reading import Reading

ROWS = re.compile(r"rows? (\d+)(?: to (\d+))?")
MORE = re.compile(r"(\d+) more rows")
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
            mine = remaining & (number >= int(span[1])) & (number <= int(span[2] or span[1]))
            mine &= skip.user in (None, "unknown") or (user == skip.user)
            left[skip.reason] += int(mine.sum())
            remaining &= ~mine
    rest = int(remaining.sum())
    counted = [(one.reason, more[1]) for one in recording.skipped if (more := MORE.fullmatch(one.trial))]
    counted += [(match[1], match[2]) for note in recording.notes if (match := NOTE.match(note))]
    for reason, rows in counted:
        count = min(rest, int(rows))
        left[reason] += count
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


LIST = Path(__file__).with_name("inputs.toml")
OUT = file_of("inputs")
HEADER = (
    "file",
    "what it is",
    "options",
    "trials",
    "rows read",
    "rows left out, and why",
    "largest difference",
)
MOST_REASONS = 4


class File(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A public file: where it is from, the options a user passes, how it is read independently.

    ``layout`` names a function of ``evidence.inputs.independent``, ``arguments`` are its arguments;
    ``refused`` is the reason why a file is expected to be refused.
    """

    repository: str
    commit: str
    path: str
    sha256: str
    licence: str
    what: str
    options: dict[str, Any] = {}
    layout: str = ""
    arguments: dict[str, Any] = {}
    refused: str = ""

    def under(self, folder: Path) -> Path:
        """Where the file lies in a folder."""
        return folder / self.repository.replace("/", "+") / self.path


class Outcome(msgspec.Struct, frozen=True):
    """What became of a file: its account, or a refusal; ``astray``: read although none expects it."""

    file: File
    account: Account | None = None
    refusal: str = ""
    astray: bool = False

    @property
    def good(self) -> bool:
        """Whether the file was read as independently, or refused for a reason in the list."""
        return self.account.agrees if self.account else bool(self.file.refused) and not self.astray


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    parser.add_argument("--partial", action="store_true", help="keep the numbers although files are missing")
    parser.add_argument("--list", type=Path, default=LIST, help="the files, instead of inputs.toml")
    parser.add_argument("--out", type=Path, default=OUT, help="the numbers, instead of data.json")
    args = parser.parse_args(arguments)
    files = listed(args.list)
    absent = missing(files, args.folder)
    for line in absent:
        print(line, file=sys.stderr)
    if absent and not args.partial:
        raise SystemExit(
            f"{len(absent)} of {len(files)} files are missing: --partial keeps the numbers without"
        )
    present = [
        file for file in files if not any(line.startswith(f"{file.under(args.folder)}:") for line in absent)
    ]
    outcomes = []
    for number, file in enumerate(present, 1):
        outcomes.append(outcome(file, args.folder))
        print(f"{number} of {len(present)} {file.path}: {brief(outcomes[-1])}", file=sys.stderr)
    files = Table.of(HEADER, [row(one) for one in outcomes])
    keep("inputs", {"files": files}, numbers={"totals": totals(outcomes)}, file=args.out)
    raise SystemExit(not all(one.good for one in outcomes))


def listed(path: Path) -> list[File]:
    """The files of a list."""
    return msgspec.convert(tomllib.loads(path.read_text(encoding="utf-8"))["file"], list[File])


def missing(files: Sequence[File], folder: Path) -> list[str]:
    """A line for each file that the folder lacks or holds in another version."""
    lines = []
    for file in files:
        path = file.under(folder)
        if not path.is_file():
            lines.append(
                f"{path}: missing; it is {file.path} of github.com/{file.repository} at {file.commit}"
            )
        elif hashlib.sha256(path.read_bytes()).hexdigest() != file.sha256:
            lines.append(f"{path}: another file than the list's, whose SHA-256 is {file.sha256}")
    return lines


def outcome(file: File, folder: Path) -> Outcome:
    """Read a file as a user does and independently; what is no error of ours goes through."""
    path = file.under(folder)
    try:
        [recording] = read_any(path, reading_of(file))
    except PointpredError as error:
        return Outcome(file, refusal=str(error).removeprefix(f"{path}: ").replace(str(path), path.name))
    if not file.layout:
        return Outcome(file, refusal=f"{len(recording.trials)} trials are read", astray=True)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # pandas on columns of mixed kinds, which are not used
        rows = LAYOUTS[file.layout](path, **file.arguments)
    return Outcome(file, account(rows, recording))


def reading_of(file: File) -> Reading:
    """The options as a ``Reading``."""
    return msgspec.convert(file.options, Reading)


def options_of(file: File) -> str:
    """The options as a user writes them on the command line."""
    words = []
    for name, value in file.options.items():
        text = str(value)
        if isinstance(value, dict):
            text = ",".join(f"{field}={column}" for field, column in value.items())
        words += [f"--{name.replace('_', '-')}"] if value is True else [f"--{name.replace('_', '-')}", text]
    return f"`{shlex.join(words)}`" if words else "none"


def brief(one: Outcome) -> str:
    """An outcome in one line."""
    if one.account is None:
        return f"{'refused' if one.good else 'NOT AS EXPECTED'}: {one.refusal[:150]}"
    account = one.account
    text = f"{account.trials} trials, {account.read} rows, {sum(account.left.values())} left out"
    return text if account.agrees else f"{text}, {account.lost} LOST, {account.px:g} px, {account.s:g} s"


def row(one: Outcome) -> tuple[str, ...]:
    """A file's row of the table."""
    file = one.file
    url = f"https://github.com/{file.repository}/blob/{file.commit}/{file.path}".replace(" ", "%20")
    head = (
        f"[{Path(file.path).name}]({url}), {file.repository} ({file.licence})",
        file.what,
        options_of(file),
    )
    account = one.account
    if account is None:
        why = f"refused: {file.refused}" if one.good else "**not as expected**"
        return (*head, why, "0", short(one.refusal), "-")
    reasons = sorted(account.left.items(), key=lambda item: -item[1])
    parts = [f"{count} {reason}" for reason, count in reasons[:MOST_REASONS]]
    more = sum(count for _, count in reasons[MOST_REASONS:])
    left = "; ".join([*parts, f"{more} for other reasons"] if more else parts) or "0"
    lost = f"**{account.lost} rows lost**; " if account.lost else ""
    counts = (str(account.trials), str(account.read))
    return (*head, *counts, left, f"{lost}{account.px:.1g} px, {account.s:.1g} s")


def short(words: str) -> str:
    """A refusal without the list of formats or columns, which is long."""
    return words if len(words) <= 160 else f"{words[:157]}..."


def totals(outcomes: Sequence[Outcome]) -> dict[str, float]:
    """What became of all files together."""
    read = [one.account for one in outcomes if one.account]
    sources = len({one.file.repository for one in outcomes})
    plain = sum(1 for one in outcomes if one.account and not one.file.options)
    left, lost = sum(sum(one.left.values()) for one in read), sum(one.lost for one in read)
    px, s = max((one.px for one in read), default=0.0), max((one.s for one in read), default=0.0)
    return {
        "files": len(outcomes),
        "sources": sources,
        "read": len(read),
        "plain": plain,
        "refused": len(outcomes) - len(read),
        "trials": sum(one.trials for one in read),
        "rows": sum(one.read for one in read),
        "left": left,
        "lost": lost,
        "px": px,
        "s": s,
    }


if __name__ == "__main__":
    main()
