"""What a scoring run prints and sends: typed records, and the table of a set as text.

The records are the JSON document of ``pointpred score --json``. ``None`` stands where a number means nothing:
a mean over no trials, a share of an error of 0. Mappings by a share of the time or of the path have that
share as their key, and its digits as the key in JSON. Read a document with
``msgspec.json.decode(data, type=Document)``.
"""

from __future__ import annotations

from math import isfinite, nan

import msgspec

from pointpred.recording import Skip
from pointpred.registry import ablation
from pointpred.scoring.results import WITH_TARGETS
from pointpred.scoring.statistics import Contrast

VERSION = 1

Number = float | None
Interval = tuple[float, float] | None
"""Lower and upper bound of a bootstrap interval; ``None`` where there is none."""


def number(value: float) -> Number:
    """A finite number, or ``None``."""
    return float(value) if isfinite(value) else None


def interval(low: float, high: float) -> Interval:
    """Both bounds, or ``None`` where one is not finite."""
    return (float(low), float(high)) if isfinite(low) and isfinite(high) else None


def or_nan(value: Number) -> float:
    """The number, NaN for ``None``."""
    return nan if value is None else value


class Measure(msgspec.Struct, frozen=True):
    """One error of a predictor: the mean over trials, beside that of ``hold``."""

    px: Number
    """Mean error, px, or counts of the device where the set's ``unit`` is ``counts``."""
    of_hold: Number
    """Mean error over the mean error of ``hold`` on the same trials."""
    skill: Number
    """1 - ``of_hold``."""
    interval: Interval
    """Of ``of_hold``; ``None`` on the single axis, which the analysis of variance covers."""


class InsideAtTime(msgspec.Struct, frozen=True):
    """Claims read at one share of the time; mappings have a key for each level of probability."""

    trials: int
    """Trials with a claim at that moment."""
    inside: dict[float, Number]
    """Share of them that ended inside the region or the interval claimed."""
    interval: dict[float, Interval]
    """Of ``inside``."""


class Calibration(msgspec.Struct, frozen=True):
    """How often predicted regions held the endpoint, over the trials in which any was claimed."""

    claimed: Number
    """Share of the time with a region, over all trials."""
    inside: dict[float, Number]
    """Share of that time with the endpoint inside the region of each level."""
    ranked_score_px: Number
    """Continuous ranked probability score, px, mean of both axes."""
    by_time: dict[float, InsideAtTime] | None
    """By share of the time from onset to arrival."""


class TimeLeft(msgspec.Struct, frozen=True):
    """Error of the predicted time left, beside a clock that uses the set's median movement time."""

    claimed: Number
    """Share of the time with a claim; elsewhere the clock is scored."""
    s: Number
    """Time-averaged absolute error, s."""
    clock_s: Number
    """That of the clock, s."""
    of_clock: Number
    """Their ratio."""
    interval: Interval
    """Of ``of_clock``."""
    inside: dict[float, Number] | None
    """Share of the time with the arrival inside the interval of each level; ``None`` without intervals."""
    by_time: dict[float, InsideAtTime] | None
    """By share of the time from onset to arrival."""


class HitShare(msgspec.Struct, frozen=True):
    """Share of trials whose prediction lies in the target, at one share of the time."""

    share: Number
    interval: Interval


class Hits(msgspec.Struct, frozen=True):
    """How often the predicted point lies in the target."""

    trials: int
    """Trials whose target is known."""
    by_time: dict[float, HitShare]


class Measures(msgspec.Struct, frozen=True):
    """Everything that is measured of one predictor on one group of trials."""

    time_averaged: Measure
    by_time: dict[float, Measure]
    """By share of the time from onset to arrival."""
    by_path: dict[float, Measure]
    """By share of the way along the line from start to end."""
    single_axis: dict[float, Measure]
    """By share of the way along the longer axis: the error along that axis alone."""
    calibration: Calibration | None
    """``None`` where no region was claimed."""
    time_left: TimeLeft | None
    """``None`` where no time was claimed."""
    hits: Hits | None
    """``None`` where no target is known."""


class UserError(msgspec.Struct, frozen=True):
    """Time-averaged error of one person."""

    trials: int
    px: Number
    of_hold: Number


class PredictorSummary(msgspec.Struct, frozen=True):
    """One predictor on one set; the measures of all trials stand beside the name, as in ``Measures``."""

    name: str
    seen: bool
    """Whether the predictor was fitted to people of this set: its errors are then too low."""
    coverage: Number
    """Share of events with a prediction; elsewhere the cursor's position was scored."""
    us_per_event: Number
    """Processor time of the whole pipeline, microseconds an event."""
    failed: tuple[Skip, ...]
    """Trials in which the pipeline failed, scored as if it had not answered."""
    time_averaged: Measure
    by_time: dict[float, Measure]
    by_path: dict[float, Measure]
    single_axis: dict[float, Measure]
    calibration: Calibration | None
    time_left: TimeLeft | None
    hits: Hits | None
    groups: dict[str, Measures]
    """The same for each group of ``SetSummary.groups``."""
    by_user: dict[str, UserError]
    learns: bool = False
    """Whether it learns from one movement of a person to the next."""
    ablates: str = ""
    """The predictor that this one is without the memory of ends and distances; "" for any other."""

    def __repr__(self) -> str:
        error = self.time_averaged
        return f"<PredictorSummary {self.name}: {error.px} px, {_text(error.of_hold)} of the error of hold>"


class Repeats(msgspec.Struct, frozen=True):
    """How much of a set somebody can know by memory alone."""

    ends: float
    """Share of trials that end within 3 % of the distance from an end of the person's last 128 movements."""
    distances: float
    """Share of trials as long, within 3 %, as one of the person's last 12 movements."""


class Resampling(msgspec.Struct, frozen=True):
    """How every interval of a set was made."""

    level: float
    resampled: str
    """``users``, or ``trials`` where there is one person."""
    draws: int
    seed: int


class GroupSummary(msgspec.Struct, frozen=True):
    """A group of trials."""

    label: str
    basis: str
    """The rule that puts trials into the group."""
    trials: int
    column: str = ""
    level: str = ""
    """Where the group is a level of a column that was asked for."""


class SetSummary(msgspec.Struct, frozen=True):
    """One scored recording."""

    name: str
    simulated: bool
    """Whether the people were simulated."""
    unit: str
    """Of positions and errors: ``px``, or ``counts`` where the recording holds no cursor."""
    trials: int
    users: int
    events: int
    skipped: tuple[Skip, ...]
    notes: tuple[str, ...]
    """What the reader of the recording mended."""
    interval: Resampling
    groups: dict[str, GroupSummary]
    """Groups beside all trials."""
    predictors: tuple[PredictorSummary, ...]
    """``hold`` first."""
    candidates: dict[str, int] | None = None
    """With targets: what the candidates were, in words, and of how many trials; ``None``: without targets."""
    contrasts: tuple[Contrast, ...] = ()
    """Of the pairs that were asked for."""
    repeats: Repeats | None = None
    """``None`` where no predictor learns from one movement to the next."""

    def __repr__(self) -> str:
        about = f"{self.trials} trials of {self.users} people"
        errors = ", ".join(f"{one.name} {_text(one.time_averaged.of_hold)}" for one in self.predictors)
        return f"<SetSummary {self.name}: {about}; of the error of hold: {errors}>"


class Unread(msgspec.Struct, frozen=True):
    """A file that could not be read, or a recording that could not be scored."""

    file: str
    reason: str


class Document(msgspec.Struct, frozen=True):
    """What ``pointpred score --json`` writes."""

    version: int
    sets: tuple[SetSummary, ...]
    unread: tuple[Unread, ...] = ()


HEADINGS = (
    "predictor",
    "share of hold's error",
    "95 % interval",
    "clean",
    "time 30 %",
    "time 50 %",
    "time 70 %",
    "time 90 %",
    "path 50 %",
    "path 75 %",
    "path 90 %",
    "answers",
    "us/event",
)
"""Columns of the table of a set. All but the last two are errors as a share of the error of ``hold``."""
WITHOUT_MEMORY = "  without memory"
"""In the place of a predictor's name, below the same with its memory of ends and distances."""
FEW_PEOPLE = 10
SEEN = "fitted to people of this set: too good; see docs/evidence/results.md"


def footnotes(summary: SetSummary) -> list[str]:
    """Warnings about predictors whose errors are too low, and of intervals over few people, a line each.

    A bootstrap interval over n people is too narrow by about the root of (n - 1) / n, and by its few values.
    """
    notes = [f"{one.name}: {SEEN}" for one in summary.predictors if one.seen]
    if 1 < summary.users < FEW_PEOPLE:
        level = f"{summary.interval.level:.0%}"
        notes.append(
            f"{summary.users} people are few: their {level} intervals are narrower than they should be"
        )
    elif summary.users == 1 and summary.trials > 1:
        notes.append("one person: intervals are over the trials and say nothing about other people")
    return notes


def about_targets(summary: SetSummary) -> str:
    """What rows with targets were told, in words; "" where nobody asked for them."""
    if summary.candidates is None:
        return ""
    if not summary.candidates:
        return "With targets: nothing, since no trial has targets that are known beside its own."
    kinds = dict(summary.candidates)
    if without := summary.trials - sum(kinds.values()):
        kinds["none"] = without
    listed = ", ".join(f"{kind} ({trials} of {summary.trials} trials)" for kind, trials in kinds.items())
    return f"With targets: all targets of a trial's block are candidates: {listed}."


def about_memory(summary: SetSummary) -> str:
    """How much of a set memory alone can know, beside predictors that learn; "" where there are none."""
    learners = [one.name for one in summary.predictors if one.learns and not one.ablates]
    learners = [name for name in learners if not name.endswith(WITH_TARGETS)]
    if summary.repeats is None or not learners:
        return ""
    ends, distances = (f"{share:.0%}" for share in (summary.repeats.ends, summary.repeats.distances))
    ablated = dict.fromkeys(one.ablates.removesuffix(WITH_TARGETS) for one in summary.predictors)
    without = [spelled for name in ablated if name and (spelled := ablation(name))]
    rows = f" Without this memory: {', '.join(without)}." if without else ""
    return (
        f"Memory: {ends} of ends and {distances} of distances here repeat earlier ones of the person, which "
        f"{', '.join(learners)} {'learns' if len(learners) == 1 else 'learn'}.{rows}"
    )


def named(predictor: PredictorSummary) -> str:
    """What the table of a set calls a predictor: one that stands below the same with memory is shorter."""
    if not predictor.ablates:
        return predictor.name
    return WITHOUT_MEMORY + (WITH_TARGETS if predictor.ablates.endswith(WITH_TARGETS) else "")


def rows(summary: SetSummary, group: str = "") -> list[tuple[str, ...]]:
    """The table of a set, or of one of its groups: a row of text a predictor, a cell for each of HEADINGS.

    What is not measured of a group is "-" there: clean trials, answers, the cost.
    """
    trials = summary.groups[group].trials if group else summary.trials
    several = trials > 1  # one trial drawn again and again is no interval
    return [_row(predictor, group, several) for predictor in summary.predictors]


def _row(predictor: PredictorSummary, group: str, several: bool) -> tuple[str, ...]:
    shown = predictor.groups[group] if group else predictor
    interval = shown.time_averaged.interval if several else None
    clean = None if group else predictor.groups.get("clean_trials")
    chosen = [
        *(shown.by_time[fraction] for fraction in (0.3, 0.5, 0.7, 0.9)),
        *(shown.by_path[fraction] for fraction in (0.5, 0.75, 0.9)),
    ]
    return (
        named(predictor),
        _text(shown.time_averaged.of_hold),
        "-" if interval is None else f"{interval[0]:.2f} to {interval[1]:.2f}",
        _text(None if clean is None else clean.time_averaged.of_hold),
        *(_text(cell.of_hold) for cell in chosen),
        "-" if group or predictor.coverage is None else f"{predictor.coverage:.0%}",
        "-" if group else _text(predictor.us_per_event),
    )


def _text(value: float | None) -> str:
    return "-" if value is None else f"{value:.2f}"
