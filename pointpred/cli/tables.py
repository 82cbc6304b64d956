"""Scored sets as tables in the terminal, with what was skipped and why."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from rich.table import Table

from pointpred.console import NARROW, counted, remarks, results
from pointpred.recording import Skip
from pointpred.scoring import HEADINGS, footnotes, rows
from pointpred.scoring.summary import SetSummary

IN_NARROW = {
    "predictor": "predictor",
    "share of hold's error": "error",
    "95 % interval": "95 % interval",
    "time 30 %": "time 30 %",
    "time 50 %": "50 %",
    "time 70 %": "70 %",
    "answers": "answers",
}
"""What a narrow terminal shows, and what it is called there."""
REASONS_SHOWN = 5


def print_sets(sets: Sequence[SetSummary], *, drawn: bool = False) -> None:
    """Print a table a set; remarks about skipped trials and mended rows go to stderr.

    ``drawn``: a report was written too.
    """
    for one in sets:
        if one.trials:
            results().print(title(one), style="bold", markup=False)
            results().print(_table(one))
            for note in footnotes(one):
                results().print(note, style="red", markup=False)
        _print_remarks(one)
    if any(one.trials for one in sets):
        results().print(
            "Errors are shares of the error of hold (no prediction), time-averaged in the first column; "
            "below 1 is better.\nAll measures, in px as well: --json FILE"
            + ("" if drawn else "; drawn: --report out.html"),
            style="dim",
        )


def title(one: SetSummary) -> str:
    """What the table is about, in one line."""
    floor = one.predictors[0].time_averaged.px
    skipped = f", {len(one.skipped)} skipped" if one.skipped else ""
    noun = "person" if one.users == 1 else "people"
    people = f"{one.users} {'simulated ' if one.simulated else ''}{noun}"
    trials = counted(one.trials, "trial")
    return f"{one.name}: {trials}{skipped}, {people}; hold is {floor:.1f} {one.unit} off"


def _table(one: SetSummary) -> Table:
    table = Table(box=None, pad_edge=False)
    names = {heading: heading for heading in HEADINGS} if results().width >= NARROW else IN_NARROW
    shown = [i for i, heading in enumerate(HEADINGS) if heading in names]
    for i in shown:
        table.add_column(names[HEADINGS[i]], justify="left" if i == 0 else "right", no_wrap=True)
    for row in rows(one):
        table.add_row(*(row[i] for i in shown))
    return table


def _print_remarks(one: SetSummary) -> None:
    for remark in _remarks(one):
        remarks().print(f"{one.name}: {remark}", markup=False)


def _is_file(skip: Skip) -> bool:
    """Whether a whole file was skipped: its reason begins with its path."""
    whole = skip.row is None and skip.user is None
    return whole and skip.reason.partition(": ")[0].endswith(skip.trial)


def _remarks(one: SetSummary) -> Iterator[str]:
    """What was mended, what was skipped and why, where a predictor failed."""
    yield from one.notes
    for skip in filter(_is_file, one.skipped):
        yield f"not read: {skip.reason}"
    skipped = [skip for skip in one.skipped if not _is_file(skip)]
    reasons = Counter(skip.reason for skip in skipped)
    frequent = reasons.most_common(REASONS_SHOWN)
    for reason, count in frequent:
        first = next(skip for skip in skipped if skip.reason == reason)
        row = "" if first.row is None else f", data row {first.row} (counted from 0)"
        user = "" if first.user is None else f" of {first.user}"
        yield f"skipped {count}: {reason} (first: trial {first.trial}{user}{row})"
    rest = reasons.total() - sum(count for _, count in frequent)
    if rest:
        yield f"skipped {rest} more for other reasons; --json lists each"
    for predictor in one.predictors:
        failed = predictor.failed
        if failed:
            trials = counted(len(failed), "trial")
            yield f"{predictor.name} failed in {trials}: {failed[0].reason} (first: trial {failed[0].trial})"
