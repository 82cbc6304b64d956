"""What ``pointpred score`` prints: errors of predictors, and with ``--targets`` how a target is chosen."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rich.table import Table

from pointpred.console import NARROW, counted, remark, results, table
from pointpred.recording import Skip, kinds_of
from pointpred.registry import REGISTRY
from pointpred.scoring import HEADINGS, about_memory, about_targets, footnotes, rows
from pointpred.scoring.results import TIME_FRACTIONS
from pointpred.scoring.summary import SetSummary

if TYPE_CHECKING:
    from pointpred.scoring.target_choice import ChoiceSummary, TargetSummary

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
LONGEST_NAME = max(map(len, REGISTRY))
WHOLE = ("clean", "answers", "us/event")
"""Columns that only the table of all trials has."""
REASONS_SHOWN = 5
DIAL = 0.5
"""The precision that is shown: the one that sessions begin with."""
RIGHT = ("predictor", *(f"{time:.0%}" for time in TIME_FRACTIONS))
DECIDED = (
    "predictor",
    "right",
    "before entry",
    "lead to entry",
    "lead to click",
    "proposed",
    "retracted",
)


def print_sets(sets: Sequence[SetSummary], *, drawn: bool = False) -> None:
    """Print a table a set; remarks about skipped trials and mended rows go to stderr.

    ``drawn``: a report was written too.
    """
    for one in sets:
        if one.trials:
            results().print(title(one), style="bold")
            results().print(_table(one))
            for words in filter(None, (about_targets(one), about_memory(one))):
                results().print(words)
            for note in footnotes(one):
                results().print(note, style="red")
            for key, group in one.groups.items():
                if group.column:
                    words = f"{group.label}: {counted(group.trials, 'trial')}"
                    results().print(words, style="bold")
                    results().print(_table(one, key))
            if one.contrasts:
                _print_contrasts(one)
        for words in _remarks(one):
            remark(f"{one.name}: {words}")
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


def _table(one: SetSummary, group: str = "") -> Table:
    longer = max(len(row[0]) for row in rows(one)) - LONGEST_NAME
    wide = results().width >= NARROW + max(longer, 0)
    names = {heading: heading for heading in HEADINGS} if wide else {**IN_NARROW}
    if longer > 0:
        names["share of hold's error"] = IN_NARROW["share of hold's error"]
    shown = [i for i, heading in enumerate(HEADINGS) if heading in names and not (group and heading in WHOLE)]
    headings = [names[HEADINGS[i]] for i in shown]
    return table(
        headings, [[row[i] for i in shown] for row in rows(one, group)], whole=headings, right=headings[1:]
    )


def _print_contrasts(one: SetSummary) -> None:
    """Pairs of predictors compared over people."""
    cells = [
        (
            each.first, each.second, f"{each.px:.1f}", f"{each.interval[0]:.1f} to {each.interval[1]:.1f}",
            *(("-",) * 3 if each.t is None else (f"{each.t:.2f}", _p(each.p), _p(each.p_holm))),
        )
        for each in one.contrasts
    ]  # fmt: skip
    people = one.contrasts[0].people
    results().print(f"Compared over {people} people:", style="bold")
    headings = ("first", "second", f"first - second, {one.unit}", "95 % interval", "t", "p", "p (Holm)")
    results().print(table(headings, cells, whole=headings[:2], right=headings[2:]))
    results().print(
        f"Paired t tests of each person's mean error, {people - 1} degrees of freedom.", style="dim"
    )


def _p(value: float | None) -> str:
    return "-" if value is None else "< .001" if value < 0.001 else f"{value:.3f}"


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
    kinds = kinds_of(skipped)
    for kind, some in kinds[:REASONS_SHOWN]:
        yield f"skipped {len(some)}: {kind} (first: {some[0].place})"
    rest = sum(len(some) for _, some in kinds[REASONS_SHOWN:])
    if rest:
        yield f"skipped {rest} more for other reasons; --json lists each"
    for predictor in one.predictors:
        failed = predictor.failed
        if failed:
            trials = counted(len(failed), "trial")
            yield f"{predictor.name} failed in {trials}: {failed[0].reason} (first: trial {failed[0].trial})"


def print_targets(sets: Sequence[TargetSummary]) -> None:
    """Two tables a set: shares right by time, and decisions at the usual precision."""
    for one in sets:
        title = f"{one.name}: {counted(one.trials, 'movement')}, {one.layout}"
        results().print(title, style="bold")
        for headings, cells in (
            (RIGHT, [_right(predictor) for predictor in one.predictors]),
            (DECIDED, [_decided(predictor) for predictor in one.predictors]),
        ):
            results().print(table(headings, cells, whole=headings[:1], right=headings[1:]))
    if sets:
        results().print(
            "First table: movements whose likeliest target is the right one, by share of the time.\n"
            f"Second table, precision set to {DIAL}: share of proposals that are right; share of movements "
            "with a right one before the cursor enters; median times from the proposal to entry and click; "
            "proposals and retractions per movement.",
            style="dim",
        )


def _right(predictor: ChoiceSummary) -> tuple[str, ...]:
    return predictor.name, *(_share(predictor.right[time]) for time in TIME_FRACTIONS)


def _decided(predictor: ChoiceSummary) -> tuple[str, ...]:
    one = predictor.decisions[DIAL]
    return (
        predictor.name,
        _share(one.precision),
        _share(one.before_entry),
        _ms(one.lead_entry_s),
        _ms(one.lead_click_s),
        _number(one.proposals),
        _number(one.retractions),
    )


def _share(value: float | None) -> str:
    return "-" if value is None else f"{value:.0%}"


def _ms(value: float | None) -> str:
    return "-" if value is None else f"{1e3 * value:.0f} ms"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.2f}"
