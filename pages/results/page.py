"""The text of ``docs/evidence/results.md``, from the summaries of all sets."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from importlib.metadata import version
from typing import Any

from pages.held_out import SET_OUT
from pages.markdown import table
from pages.results import claims as results_claims
from pages.results import ktm as results_ktm
from pages.results.verdict import OVERVIEW, verdict
from pointpred.console import counted
from pointpred.datasets import DataSet

Json = dict[str, Any]

PROTOCOL = """Written by `make results`; do not edit. The protocol stands in [scoring.md](scoring.md). In
short: every trial counts, from the onset of the movement to the selecting click or the last sample; the
truth is the last position; where a predictor does not answer, the cursor's position is scored in its place.
**Every number is the mean error over trials divided by that of `hold`** (no prediction, the cursor's own
position), unless px is written beside it: below 1 a predictor helps, above 1 it does harm. Sets are
never pooled. A cell says `all / clean`: over all trials, and over
the clean ones, as the set itself judges or, where it does not, by the rule in scoring.md.

Brackets hold 95 % bootstrap intervals: people are drawn with replacement, or trials where a set has one
person only (the interval then says nothing about other people). `answers` is the share of events with a
prediction. The cost is processor time of the whole pipeline, differentiator included, in microseconds an
event, on the machine that wrote this page. All else repeats to the last digit with the same versions."""

LEARNED = """What has learned from recordings is judged on a recorded set by coefficients that did not see the
set (*set left out*: fitted to the other sets) and by coefficients that did not see the person (*people left
out*: five folds of the people of all sets, each judged by a fit to the other four), never by those that come
with the package, which saw them all. These stand only on sets that they did not see, as the simulated one. Of
the regions of a left-out set the calibration comes from people of the other sets, as judged by fits that knew
the set. Features and settings were chosen on these same held-out people and sets
([experiments.md](experiments.md)): the scores are a little too good."""

OUT = " left out)"

AXIS = ("0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.0")


def page(
    sets: Sequence[Json],
    figures: Mapping[str, Mapping[str, str]],
    known: Mapping[str, DataSet],
    absent: Sequence[str],
    unread: Mapping[str, str],
    choices: Sequence[str] = (),
) -> str:
    """The whole page."""
    libraries = ", ".join(f"{name} {version(name)}" for name in ("pointpred", "numpy", "numba"))
    seeds = ", ".join(sorted({str(one["interval"]["seed"]) for one in sets}))
    draws = ", ".join(sorted({str(one["interval"]["draws"]) for one in sets}))
    about = f"Versions: {libraries}. Bootstrap: {draws} draws, seed {seeds}."
    missing = [f"`{name}`" for name in absent]
    said = [f"Sets of the catalogue that were not at hand: {', '.join(missing)}."] if missing else []
    said += [f"Not read: {reason}." for reason in unread.values()]
    parts = [
        "# Results",
        *verdict(sets),
        PROTOCOL,
        LEARNED,
        about,
        *said,
        contents(sets, choices),
        OVERVIEW,
        overview(sets),
    ]
    for one in sets:
        parts += section(one, figures.get(one["name"], {}), known.get(one["name"]))
    parts += choices
    return "\n\n".join(parts) + "\n"


def contents(sets: Sequence[Json], choices: Sequence[str] = ()) -> str:
    """A link to each section."""
    lines = [OVERVIEW.lstrip("# "), *(title(one) for one in sets), *(c.lstrip("# ") for c in choices[:1])]
    return "\n".join(f"- [{line}](#{anchor(line)})" for line in lines)


def anchor(heading: str) -> str:
    """The anchor that GitHub gives a heading.

    >>> anchor("simulated-circle (simulated)")
    'simulated-circle-simulated'
    """
    return "".join(c for c in heading.lower().replace(" ", "-") if c.isalnum() or c in "-_")


def title(one: Json) -> str:
    """The set's name; people who were simulated are called so."""
    return f"{one['name']} (simulated)" if one["simulated"] else str(one["name"])


def overview(sets: Sequence[Json]) -> str:
    """A row a predictor, a column a set; the package's own coefficients never saw a simulated set."""
    found: dict[str, list[str]] = {}
    learners = {
        p["name"].removesuffix(SET_OUT) for one in sets for p in one["predictors"] if SET_OUT in p["name"]
    }
    for place, one in enumerate(sets):
        for p in one["predictors"]:
            name = p["name"] + SET_OUT if p["name"] in learners else p["name"]
            row = found.setdefault(name, ["-"] * len(sets))
            row[place] = number(p["time_averaged"]["of_hold"])
    rows = [(f"`{name}`", *cells) for name, cells in found.items()]
    return table(("predictor", *(title(one) for one in sets)), rows)


def section(one: Json, figures: Mapping[str, str], entry: DataSet | None) -> list[str]:
    """Everything about one set."""
    parts = [f"## {title(one)}"]
    if entry is not None:
        parts.append(f"{entry.title}. {entry.sampling}; {entry.targets}. {entry.citation}, {entry.licence}.")
    clean = one["groups"].get("clean_trials", {}).get("trials")
    judged = f", {clean} of them clean" if clean else ", none of them clean"
    people = "1 person" if one["users"] == 1 else f"{one['users']} people"
    parts.append(
        f"{people}, {counted(one['trials'], 'trial')}{judged}, {counted(one['events'], 'event')}; "
        f"{counted(len(one['skipped']), 'trial')} skipped. Resampled: {one['interval']['resampled']}."
    )
    parts += [*told_apart(one), *skipped(one), *(f"{note[0].upper()}{note[1:]}." for note in one["notes"])]
    if not one["trials"]:
        return [*parts, "No trial could be scored."]
    parts += ["### Time-averaged error", averaged(one)]
    parts += ["### By time from onset to arrival", series(one, "by_time")]
    parts += ["### By path", series(one, "by_path")]
    parts += ["### Mean absolute error on the longer axis, px, by path along it", single_axis(one)]
    parts += results_claims.section(one)
    if one.get("ktm"):
        parts += [
            "### The protocol of template matching",
            results_ktm.WORDS,
            *results_ktm.section(one["ktm"]),
        ]
    return [*parts, "### Figures", *figures.values()]


def told_apart(one: Json) -> list[str]:
    """What the groups of trials are, those with the same basis together."""
    named: dict[str, list[str]] = {}
    for group in one["groups"].values():
        named.setdefault(group["basis"], []).append(group["label"])
    told = [f"{' and '.join(keys)}: {basis}" for basis, keys in named.items()]
    return [f"How trials were told apart. {'; '.join(told)}."] if told else []


def skipped(one: Json) -> list[str]:
    """Skipped trials, and trials in which a predictor failed, counted by reason."""
    lines = []
    if one["skipped"]:
        reasons = Counter(skip["reason"] for skip in one["skipped"])
        lines.append("Skipped: " + "; ".join(f"{reason} ({n})" for reason, n in reasons.most_common()) + ".")
    for predictor in one["predictors"]:
        if predictor["failed"]:
            first = predictor["failed"][0]
            trials = counted(len(predictor["failed"]), "trial")
            lines.append(
                f"`{predictor['name']}` failed in {trials}, scored there as if it had not answered; the "
                f"first: trial {first['trial']}, {first['reason']}."
            )
    return lines


def averaged(one: Json) -> str:
    """The first table of a set: intervals, groups, coverage, cost."""
    groups = list(one["groups"])
    rows = []
    for predictor in one["predictors"]:
        whole = predictor["time_averaged"]
        cells = [predictor["groups"][key]["time_averaged"] for key in groups]
        rows.append(
            (
                f"`{predictor['name']}`",
                number(whole["px"], 1),
                share(whole),
                *(share(cell) for cell in cells),
                f"{predictor['coverage']:.0%}",
                number(predictor["us_per_event"]),
            )
        )
    heads = (f"{group['label']} ({group['trials']})" for group in one["groups"].values())
    return table(("predictor", "px", "all trials", *heads, "answers", "us/event"), rows)


def series(one: Json, kind: str) -> str:
    """Error of hold in px, then every predictor's share of it, all and clean side by side."""
    fractions = list(one["predictors"][0][kind])
    floor = one["predictors"][0]
    head = ("predictor", *(f"{float(fraction):.0%}" for fraction in fractions))
    rows = [("`hold`, px", *_beside(floor, kind, fractions, lambda cell: number(cell["px"], 0)))]
    for predictor in one["predictors"][1:]:
        cells = _beside(predictor, kind, fractions, lambda cell: number(cell["of_hold"]))
        rows.append((f"`{predictor['name']}`", *cells))
        if OUT in predictor["name"]:
            bounds = (predictor[kind][fraction]["interval"] for fraction in fractions)
            spread = ("-" if b is None else f"[{b[0]:.2f}, {b[1]:.2f}]" for b in bounds)
            rows.append((f"`{predictor['name']}`, interval", *spread))
    return table(head, rows)


def _beside(
    predictor: Json, kind: str, fractions: Sequence[str], say: Callable[[Json], str]
) -> tuple[str, ...]:
    """A cell a fraction: all trials, and the clean ones."""
    clean = predictor["groups"].get("clean_trials")
    return tuple(
        say(predictor[kind][fraction]) + (f" / {say(clean[kind][fraction])}" if clean else "")
        for fraction in fractions
    )


def single_axis(one: Json) -> str:
    """The thesis's protocol in px."""
    rows = [
        (f"`{predictor['name']}`", *(number(predictor["single_axis"][f]["px"], 1) for f in AXIS))
        for predictor in one["predictors"]
    ]
    return table(("predictor", *(f"{float(fraction):.0%}" for fraction in AXIS)), rows)


def share(cell: Json) -> str:
    """A ratio with its interval."""
    if cell["interval"] is None:
        return number(cell["of_hold"])
    low, high = cell["interval"]
    return f"{number(cell['of_hold'])} [{low:.2f}, {high:.2f}]"


def number(value: float | None, digits: int = 2) -> str:
    """A number, or a dash where there is none."""
    return "-" if value is None else f"{value:.{digits}f}"
