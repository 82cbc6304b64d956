"""What a scored set shows, in a sentence: who has the lowest error, by how much, and how sure that is."""

from __future__ import annotations

import msgspec

from pointpred.report.style import HOLD
from pointpred.scoring.summary import Measure, PredictorSummary, SetSummary
from pointpred.scoring.summary.document import or_nan


def ranked(described: SetSummary) -> SetSummary:
    """The same set with its predictors by their time-averaged error, the lowest first."""
    return msgspec.structs.replace(described, predictors=tuple(sorted(described.predictors, key=_error)))


def _error(predictor: PredictorSummary) -> float:
    px = predictor.time_averaged.px
    return float("inf") if px is None else float(px)


def leader(described: SetSummary) -> PredictorSummary | None:
    """The predictor with the lowest error, hold apart; fitted to people of the set only where all are."""
    others = [p for p in ranked(described).predictors if p.name != HOLD]
    unseen = [p for p in others if not p.seen]
    return next(iter(unseen or others), None)


def conclusion(described: SetSummary) -> str:
    """The sentence at the top of a set, as plain text; numbers are those of the JSON document, rounded.

    It is honest where nothing is better than no prediction, where the interval holds "no difference", and
    where a predictor was fitted to people of the set.
    """
    best = leader(described)
    trials = f"{_count(described.trials, 'trial')} of {_people(described.users)}"
    if best is None:
        return f"Only hold (no prediction) was scored, on {trials}."
    measure = best.time_averaged
    if measure.of_hold is None:
        return f"On {trials} hold (no prediction) has no error: nothing can be compared with it."
    seen = _seen(described, best)
    scope = " that was not fitted to these people" if seen and not best.seen else ""
    if measure.of_hold >= 1.0:
        verdict = (
            f"No predictor{scope} has a lower error than no prediction (hold). The closest is {best.name}:"
        )
    else:
        verdict = f"{best.name} has the lowest error{' of any' * bool(scope)}{scope}:"
    less = f"{_difference(measure.of_hold)} than no prediction (hold){_interval(described, measure)}"
    return f"{verdict} {measure.px:.1f} {described.unit}, {less}, on {trials}.{_doubt(measure)}{seen}"


def _difference(ratio: float) -> str:
    return f"{abs(100 * (1 - ratio)):.0f} % {'more' if ratio > 1.0 else 'less'}"


def _interval(described: SetSummary, measure: Measure) -> str:
    """The interval of the difference; one person's says nothing about others, and one trial has none."""
    if measure.interval is None:
        return " (one trial has no interval)" if described.trials == 1 else ""
    low, high = measure.interval
    worst, best = _difference(high), _difference(low)
    if worst.split()[-1] == best.split()[-1]:
        worst = worst.split()[0]
    return f" ({100 * described.interval.level:.0f} % interval: {worst} to {best})"


def _doubt(measure: Measure) -> str:
    """Whether chance alone may explain a lower error."""
    if or_nan(measure.of_hold) >= 1.0 or measure.interval is None or measure.interval[1] < 1.0:
        return ""
    return " The interval includes no difference: this may be chance."


def _seen(described: SetSummary, best: PredictorSummary) -> str:
    """Predictors that look as good only because they know these people."""
    seen = [p.name for p in described.predictors if p.seen and _error(p) <= _error(best)]
    return f" No fair comparison, because fitted to people of this set: {', '.join(seen)}." if seen else ""


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _people(number: int) -> str:
    return "one person" if number == 1 else f"{number} people"
