"""The tables of a report as HTML. Every string that comes from a recording is escaped here."""

from __future__ import annotations

import html
from collections import Counter
from collections.abc import Iterable, Sequence

from pointpred.report.style import HOLD
from pointpred.scoring.results import PATH_FRACTIONS, TIME_FRACTIONS
from pointpred.scoring.summary import Measure, PredictorSummary, SetSummary

LONGEST = 80


def text(value: object, longest: int = LONGEST) -> str:
    """A string safe in HTML: escaped, unprintable characters replaced, cut to ``longest`` characters.

    >>> text("<b>")
    '&lt;b&gt;'
    """
    shown = "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in str(value))
    return html.escape(shown if len(shown) <= longest else shown[: longest - 1] + "…")


def table(
    caption: str,
    head: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    marked: frozenset[int] = frozenset(),
    words: bool = False,
) -> str:
    """A table of cells that are HTML already, the first names its row; ``marked`` rows are the reference.

    ``words``: cells hold words rather than numbers.
    """
    lines = [
        f'<tr{" class=reference" if i in marked else ""}><th scope="row">{row[0]}</th>'
        + "".join(f"<td>{cell}</td>" for cell in row[1:])
        + "</tr>"
        for i, row in enumerate(rows)
    ]
    said = text(caption, 200)
    top = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    return (
        f'<div class="scroll" tabindex="0" role="region" aria-label="{said}">'
        f"<table{' class=words' if words else ''}><caption><span>{said}</span></caption>"
        f"<thead><tr>{top}</tr></thead>"
        f"<tbody>{''.join(lines)}</tbody></table></div>"
    )


def number(value: float | None, digits: int = 2) -> str:
    """A number for a cell, a dash where there is none."""
    return "–" if value is None else f"{value:.{digits}f}"


def cell(measure: Measure, unit: str) -> str:
    """Share of hold above the error itself."""
    return f"{number(measure.of_hold)}<small>{number(measure.px, 1)} {unit}</small>"


def section(anchor: str, title: str, body: str) -> str:
    """A part of a set that is closed at first; a link to its anchor opens it. Nothing where it is empty."""
    return (
        f'<details><summary><h3>{title}</h3></summary><div id="{anchor}">{body}</div></details>'
        if body
        else ""
    )


def summary_table(described: SetSummary) -> str:
    """Time-averaged error with interval, coverage and cost, a row a predictor; failures, if any."""
    failures = any(predictor.failed for predictor in described.predictors)
    rows = [_summary_row(predictor, failures) for predictor in described.predictors]
    head = ("predictor", f"error, {described.unit}", "error/hold", "95% interval", "answered", "µs/event")
    caption = f"{described.name}: time-averaged error, the lowest first; hold is no prediction"
    return table(caption, (*head, *["failed"] * failures), rows, marked=_reference(described))


def _summary_row(predictor: PredictorSummary, failures: bool) -> tuple[str, ...]:
    """Hold has no interval: it is what the others are compared with."""
    averaged = predictor.time_averaged
    bounds = None if predictor.name == HOLD else averaged.interval
    return (
        text(predictor.name) + ("<small>fitted to this set</small>" if predictor.seen else ""),
        number(averaged.px, 1),
        number(averaged.of_hold),
        "–" if bounds is None else f"{bounds[0]:.2f} to {bounds[1]:.2f}",
        "–" if predictor.coverage is None else f"{predictor.coverage:.0%}",
        number(predictor.us_per_event),
        *[str(len(predictor.failed))] * failures,
    )


def series_table(described: SetSummary, kind: str) -> str:
    """Error at each fraction of the time (``by_time``) or of the path (``by_path``)."""
    fractions, what = {"by_time": (TIME_FRACTIONS, "time"), "by_path": (PATH_FRACTIONS, "path")}[kind]
    rows = [
        (text(p.name), *(cell(getattr(p, kind)[fraction], described.unit) for fraction in fractions))
        for p in described.predictors
    ]
    return table(
        f"{described.name}: error at shares of the {what}, as a share of hold and in {described.unit}",
        (f"share of the {what}", *(f"{fraction:.0%}" for fraction in fractions)),
        rows,
        marked=_reference(described),
    )


def _reference(described: SetSummary) -> frozenset[int]:
    return frozenset(i for i, p in enumerate(described.predictors) if p.name == HOLD)


def groups_table(described: SetSummary) -> str:
    """The time-averaged error in each group of trials, and how the trials were told apart."""
    groups = described.groups
    head = [f"{text(group.label)}<small>trials: {group.trials}</small>" for group in groups.values()]
    rows = [
        (text(p.name), *(cell(p.groups[key].time_averaged, described.unit) for key in groups))
        for p in described.predictors
    ]
    caption = f"{described.name}: time-averaged error by group, as a share of hold and in {described.unit}"
    basis = "".join(f"<li>{text(group.label)}: {text(group.basis, 200)}</li>" for group in groups.values())
    return table(caption, ("predictor", *head), rows, marked=_reference(described)) + f"<ul>{basis}</ul>"


def skipped_table(described: SetSummary, most: int = 20) -> str:
    """Trials left out, by reason; single trials where they are few."""
    skipped = described.skipped
    if not skipped:
        return "<p>No trial was skipped.</p>"
    caption = f"{described.name}: trials skipped: {len(skipped)}"
    if len(skipped) <= most:
        rows = [(text(s.user or "–"), text(s.trial), text(s.reason), number(s.row, 0)) for s in skipped]
        return table(caption, ("user", "trial", "reason", "data row, from 0"), rows, words=True)
    counted = Counter(s.reason for s in skipped)
    first = {reason: next(s.trial for s in skipped if s.reason == reason) for reason in counted}
    common = counted.most_common(most)
    grouped = [(text(reason), str(count), text(first[reason])) for reason, count in common]
    rest = len(skipped) - sum(count for _, count in common)
    if rest:
        grouped.append((f"{len(counted) - most} other reasons", str(rest), "–"))
    return table(caption, ("reason", "trials", "first of them"), grouped, words=True)
