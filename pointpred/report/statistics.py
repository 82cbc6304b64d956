"""The analysis of variance in words and as tables."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pointpred.report.tables import number, table, text
from pointpred.scoring.anova import Effect
from pointpred.scoring.results import AXIS_FRACTIONS, PATH_FRACTIONS
from pointpred.scoring.statistics import AnovaSeries, AxisProfile

ALPHA = 0.05
COLUMNS = tuple(AXIS_FRACTIONS.index(fraction) for fraction in PATH_FRACTIONS)


def p_words(p: float) -> str:
    """A probability as papers print it.

    >>> p_words(0.0004), p_words(0.0312)
    ('p < 0.001', 'p = 0.031')
    """
    return "p < 0.001" if p < 0.001 else f"p = {p:.3f}"


def f_words(effect: Effect) -> str:
    """F, degrees of freedom, p and effect size of one term."""
    return (
        f"F({effect.df1}, {effect.df2}) = {effect.f:.2f}, {p_words(effect.p_corrected)}, "
        f"partial η² = {effect.eta2:.2f}"
    )


def sentences(effects: tuple[tuple[Effect, ...], ...]) -> list[str]:
    """A sentence a term: where along the path it is significant, and where most."""
    said = []
    terms = dict.fromkeys(effect.factors for at in effects for effect in at)
    for term in terms:
        found = {i: effect for i, at in enumerate(effects) for effect in at if effect.factors == term}
        good = [i for i, effect in found.items() if effect.p_corrected < ALPHA]
        top = max(good or found, key=lambda i: found[i].f)
        name = " x ".join(term)
        if good:
            where = f"significant at {_spans(good)} of the path, most at {AXIS_FRACTIONS[top]:.0%}"
            said.append(f"{name}: {where}: {f_words(found[top])}.")
        else:
            said.append(f"{name}: not significant anywhere; largest F at {AXIS_FRACTIONS[top]:.0%}: "
                        f"{f_words(found[top])}.")  # fmt: skip
    return said


def _spans(places: list[int]) -> str:
    """Runs of neighbouring fractions: 10 to 75 %, 90 %."""
    runs: list[list[int]] = []
    for place in places:
        if runs and place == runs[-1][-1] + 1:
            runs[-1].append(place)
        else:
            runs.append([place])
    return ", ".join(
        f"{AXIS_FRACTIONS[run[0]]:.0%}" + (f" to {AXIS_FRACTIONS[run[-1]]:.0%}" if len(run) > 1 else "")
        for run in runs
    )


def anova_table(caption: str, effects: tuple[tuple[Effect, ...], ...]) -> str:
    """F, p and effect size of every term at PATH_FRACTIONS; significant cells are bold."""
    terms = dict.fromkeys(effect.factors for at in effects for effect in at)
    rows = []
    for term in terms:
        cells = []
        for i in COLUMNS:
            found = next((effect for effect in effects[i] if effect.factors == term), None)
            cells.append("–" if found is None else _cell(found))
        rows.append((text(" x ".join(term)), *cells))
    head = ("share of the path", *(f"{fraction:.0%}" for fraction in PATH_FRACTIONS))
    return table(caption, head, rows)


def _cell(effect: Effect) -> str:
    first = f"{effect.f:.2f}"
    if effect.p_corrected < ALPHA:
        first = f"<strong>{first}</strong>"
    return (
        f"{first}<small>F({effect.df1}, {effect.df2})</small>"
        f"<small>{text(p_words(effect.p_corrected))}</small><small>η² {effect.eta2:.2f}</small>"
    )


def mae_table(caption: str, profiles: Sequence[AxisProfile]) -> str:
    """Mean absolute error along the longer axis with outliers, and with the quartile in their place."""
    rows = []
    for profile in profiles:
        pairs = zip(profile.mae[list(COLUMNS)], profile.mae_replaced[list(COLUMNS)], strict=True)
        cells = (f"{number(float(mae), 1)}<small>{number(float(rest), 1)}</small>" for mae, rest in pairs)
        rows.append((text(profile.name), *cells))
    head = ("share of the longer axis", *(f"{fraction:.0%}" for fraction in PATH_FRACTIONS))
    return table(caption, head, rows)


def leads(profiles: Sequence[AxisProfile], *, replaced: bool = False) -> str:
    """Where along the path each predictor has the lowest MAE: the direction that F does not give."""
    means = np.array([profile.mae_replaced if replaced else profile.mae for profile in profiles])
    best = means.argmin(axis=0)
    said = [
        f"{profile.name} at {_spans(np.flatnonzero(best == i).tolist())}"
        for i, profile in enumerate(profiles)
        if (best == i).any()
    ]
    return f"Lowest MAE: {'; '.join(said)} of the path."


def statistics_html(
    name: str, series: AnovaSeries, profiles: Sequence[AxisProfile], *, thesis: bool = False
) -> str:
    """The whole analysis of a set: design, words, both tables, what could not enter.

    ``profiles`` are those of the models compared; ``thesis``: they are the thesis's two.
    """
    levels = (
        f"{text(factor)} ({', '.join(text(level) for level in of)})"
        for factor, of in zip(series.factors, series.levels, strict=True)
    )
    notes = "".join(f"<li>{text(note, 400)}</li>" for note in series.notes)
    compared = " and ".join(text(model) for model in series.models)
    parts = [f"<p>Models compared: the thesis's two, {compared}.</p>" if thesis else ""]
    if any(series.effects):
        parts.append(
            f"<p>Repeated-measures ANOVA of the single-axis error, {series.users} people. Within factors: "
            f"{'; '.join(levels)}. F from statsmodels' AnovaRM, p with the Greenhouse-Geisser correction, "
            f"which matters where a factor has more than two levels. Bold: p below {ALPHA}. The shares of "
            "the path are not independent of each other, and p is not corrected for their number.</p>"
        )
        for title, effects, replaced in (
            ("All errors", series.effects, False),
            ("Outliers replaced by the quartile bound", series.effects_replaced, True),
        ):
            lines = [*sentences(effects), leads(profiles, replaced=replaced)]
            said = "".join(f"<li>{text_long(line)}</li>" for line in lines)
            parts.append(f"<h4>{title}</h4><ul>{said}</ul>")
            parts.append(anova_table(f"{name}: analysis of variance, {title.lower()}", effects))
    if notes:
        parts.append(f"<p>Of the analysis:</p><ul>{notes}</ul>")
    return "".join(parts)


def text_long(line: str) -> str:
    """A sentence of ours with names of theirs in it, escaped word by word."""
    return " ".join(text(word) for word in line.split(" "))
