"""``pointpred score --targets``: which target a movement is for, beside the nearest to the cursor."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

from rich.table import Table

from pointpred.console import counted, results
from pointpred.scoring.results import TIME_FRACTIONS

if TYPE_CHECKING:
    from pointpred.recording import Recording
    from pointpred.scoring.target_choice import ChoiceSummary, TargetSummary

DIAL = 0.5
"""The precision that is shown: the one that sessions begin with."""
HEADINGS = ("predictor", *(f"{time:.0%}" for time in TIME_FRACTIONS))
DECIDED = (
    "predictor",
    "right",
    "before entry",
    "lead to entry",
    "lead to click",
    "proposed",
    "retracted",
)


def target_summaries(
    recordings: Iterable[Recording],
    predictors: list[str],
    failed: Callable[[Recording, Exception], None],
    **settings: Any,
) -> list[TargetSummary]:
    """The summary of each kind of layout of each recording; ``failed`` gets what cannot be scored."""
    from pointpred.scoring.target_choice import score_targets, summarise_targets

    sets = []
    for recording in recordings:
        try:
            scored = score_targets(recording, tuple(predictors), **settings)
        except Exception as error:  # as in ``score``: the other recordings are scored all the same
            failed(recording, error)
            continue
        sets += [summarise_targets(one) for one in scored]
    return sets


def print_targets(sets: Sequence[TargetSummary]) -> None:
    """Two tables a set: shares right by time, and decisions at the usual precision."""
    for one in sets:
        title = f"{one.name}: {counted(one.trials, 'movement')}, {one.layout}"
        results().print(title, style="bold", markup=False)
        results().print(_table(HEADINGS, [_right(predictor) for predictor in one.predictors]))
        results().print(_table(DECIDED, [_decided(predictor) for predictor in one.predictors]))
    if sets:
        results().print(
            "First table: movements whose likeliest target is the right one, by share of the time.\n"
            f"Second table, precision set to {DIAL}: share of proposals that are right; share of movements "
            "with a right one before the cursor enters; median times from the proposal to entry and click; "
            "proposals and retractions per movement.",
            style="dim",
        )


def _table(headings: tuple[str, ...], rows: list[tuple[str, ...]]) -> Table:
    table = Table(box=None, pad_edge=False)
    for i, heading in enumerate(headings):
        table.add_column(heading, justify="left" if i == 0 else "right", no_wrap=i == 0)
    for row in rows:
        table.add_row(*row)
    return table


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
