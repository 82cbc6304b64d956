"""The protocol of kinematic template matching: a movement against a library of the same person's others."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import msgspec
import numpy as np

from pointpred.pipeline import Pipeline, run
from pointpred.predictors import TemplatePredictor
from pointpred.predictors.ktm.predictor import TEMPLATES_MOST
from pointpred.predictors.ktm.templates import profile_of
from pointpred.recording import Skip
from pointpred.records import BoolArray, EventColumns, FloatArray
from pointpred.registry import build
from pointpred.scoring.summary.bootstrap import ratio_intervals
from pointpred.scoring.summary.document import Interval, interval
from pointpred.scoring.trials import Prepared

FRACTIONS = (0.50, 0.75, 0.90)
"""Shares of the straight distance from the start; the error is read where each is first reached."""
HIT_PX = 16.0
MOVEMENTS_LEAST = 16
"""A person with fewer movements has no library worth the name."""
LIBRARY = "ktm, library"
"""What template matching with the library is called beside names of the registry."""


class Selection(msgspec.Struct, frozen=True):
    """The trials of a set that are tested, and for each the trials that are its templates."""

    prepared: Prepared
    tested: tuple[int, ...]
    libraries: dict[str, tuple[int, ...]]
    """For each user the trials of the library; the tested one is left out of it."""
    longest_s: float
    left_out: tuple[Skip, ...]
    """Trials and users that take no part."""


class ProtocolErrors(msgspec.Struct, frozen=True):
    """Errors in px of one predictor, a row a tested trial, a column for each of FRACTIONS."""

    name: str
    errors: FloatArray
    distances: FloatArray
    """(trials,): straight distance px"""

    def mean_px(self) -> FloatArray:
        """Mean error."""
        return np.asarray(self.errors.mean(axis=0))

    def share(self) -> FloatArray:
        """Mean error over mean distance."""
        return np.asarray(self.mean_px() / self.distances.mean())

    def hits(self) -> FloatArray:
        """Share of trials whose error is at most 16 px."""
        return np.asarray((self.errors <= HIT_PX).mean(axis=0))

    def skill(self, floor: ProtocolErrors) -> FloatArray:
        """1 - mean error / mean error of ``floor``."""
        return 1.0 - self.mean_px() / floor.mean_px()


class ProtocolPredictor(msgspec.Struct, frozen=True):
    """The numbers of one predictor; mappings by each of FRACTIONS of the straight distance."""

    name: str
    px: dict[float, float]
    """Mean error, px."""
    of_distance: dict[float, float]
    """Mean error over mean distance."""
    hits: dict[float, float]
    """Share of trials whose error is at most HIT_PX."""
    skill: dict[float, float]
    """1 - mean error over that of ``hold``."""
    of_library: dict[float, float]
    """Mean error over that of template matching with the library."""
    interval: dict[float, Interval]
    """Of ``of_library``, over people, or over trials where there is one person."""


class ProtocolSummary(msgspec.Struct, frozen=True):
    """What was tested on one set by one rule of drawing, and what came of it."""

    monotone: bool
    """Whether only movements that never come nearer to their start again were tested, as published."""
    tested: int
    """Trials tested."""
    users: int
    templates: tuple[int, int] | None
    """Fewest and most templates of a library; ``None`` where there is no library."""
    left_out: int
    """Trials and users that take no part."""
    distance_px: float | None
    """Mean straight distance, px."""
    predictors: tuple[ProtocolPredictor, ...]
    """``hold``, template matching with the library, the others; empty where nothing was tested."""


def summarise_protocol(
    selection: Selection, results: Sequence[ProtocolErrors], *, monotone: bool
) -> ProtocolSummary:
    """The numbers of each predictor: ``hold`` first, then template matching with the library."""
    sizes = [len(library) - 1 for library in selection.libraries.values()]
    users = [selection.prepared.trials[k].trial.user for k in selection.tested]
    floor, matched = results[:2] if selection.tested else (None, None)
    return ProtocolSummary(
        monotone,
        len(selection.tested),
        len(selection.libraries),
        (min(sizes), max(sizes)) if sizes else None,
        len(selection.left_out),
        None if floor is None else float(floor.distances.mean()),
        ()
        if floor is None or matched is None
        else tuple(_summarise(one, floor, matched, users) for one in results),
    )


def _summarise(
    one: ProtocolErrors, floor: ProtocolErrors, matched: ProtocolErrors, users: Sequence[str]
) -> ProtocolPredictor:
    bounds = ratio_intervals(one.errors, matched.errors, users)

    def by_share(values: FloatArray) -> dict[float, float]:
        return dict(zip(FRACTIONS, values.tolist(), strict=True))

    pairs = zip(FRACTIONS, bounds.low, bounds.high, strict=True)
    return ProtocolPredictor(
        one.name,
        by_share(one.mean_px()),
        by_share(one.share()),
        by_share(one.hits()),
        by_share(one.skill(floor)),
        by_share(one.mean_px() / matched.mean_px()),
        {share: interval(low, high) for share, low, high in pairs},
    )


def never_nearer(rows: EventColumns) -> bool:
    """Whether the distance from the start never decreases: the movements the authors draw.

    As in their program, the step from the first event to the second is not looked at: it cannot decrease.

    >>> never_nearer(EventColumns.of([0, 1, 2], [0, 5, 5], [0, 0, 1])), never_nearer(
    ...     EventColumns.of([0, 1, 2], [0, 5, 4], [0, 0, 1]))
    (True, False)
    """
    return bool((np.diff(np.hypot(rows.x - rows.x[0], rows.y - rows.y[0])) >= 0.0).all())


def select(
    prepared: Prepared,
    *,
    only_monotone: bool = True,
    share: float = 0.1,
    seed: int = 0,
    least: int = MOVEMENTS_LEAST,
) -> Selection:
    """Draw the trials that are tested: a share of each user's library at random, without repetition.

    ``only_monotone``: trials whose distance from the start ever decreases are replaced by others, as
    published; they stay in the libraries. A library holds all movements of its user, at most 1000 at random.
    Users with fewer than ``least`` movements and trials that make no template (fewer than 4 points of
    different time, less than 50 ms) take no part.
    """
    random = np.random.default_rng(seed)
    t, first, last = prepared.events.t, prepared.offsets[:-1], prepared.offsets[1:] - 1
    longest_s = float(np.max(t[last] - t[first], initial=0.2))
    mine: dict[str, list[int]] = {}
    left_out: list[Skip] = []
    for k, scored in enumerate(prepared.trials):
        who, rows = scored.trial, prepared.rows(k)
        if len(np.unique(rows.t)) < 4 or rows.t[-1] - rows.t[0] < 0.05:
            left_out.append(Skip(who.trial, "makes no template", user=who.user))
        else:
            mine.setdefault(who.user, []).append(k)
    tested: list[int] = []
    libraries: dict[str, tuple[int, ...]] = {}
    for user, trials in mine.items():
        if len(trials) < least:
            why = f"{len(trials)} movements of this person, a library needs {least}"
            left_out.append(Skip("*", why, user=user))
            continue
        library = np.sort(random.permutation(trials)[:TEMPLATES_MOST])
        libraries[user] = tuple(library.tolist())
        may = [k for k in library.tolist() if not only_monotone or never_nearer(prepared.rows(k))]
        count = min(len(may), max(1, int(share * len(library))))
        tested += np.sort(random.permutation(may)[:count]).tolist()
    return Selection(prepared, tuple(tested), libraries, longest_s, tuple(left_out))


def with_library(selection: Selection) -> ProtocolErrors:
    """Template matching with the library, each tested trial left out of it."""
    profiles = {
        user: np.concatenate([profile_of(selection.prepared.rows(k), selection.longest_s) for k in trials])
        for user, trials in selection.libraries.items()
    }

    def answers() -> Iterator[tuple[int, FloatArray]]:
        differentiator = build("ktm").differentiator
        for k in selection.tested:
            user = selection.prepared.trials[k].trial.user
            others = np.delete(profiles[user], selection.libraries[user].index(k), axis=0)
            predictor = TemplatePredictor(templates=0, longest_s=selection.longest_s, library=others)
            pipeline = Pipeline(LIBRARY, differentiator.fresh(), predictor)
            yield k, run(pipeline, selection.prepared.rows(k)).table

    return _read(LIBRARY, selection, dict(answers()))


def without_library(selection: Selection, pattern: Pipeline) -> ProtocolErrors:
    """Any pipeline on the tested trials; one that learns has seen the user's trials before them, in order."""
    tested, answers = set(selection.tested), {}
    pipelines: dict[str, Pipeline] = {}
    for k, scored in enumerate(selection.prepared.trials):
        pipeline = pipelines.setdefault(scored.trial.user, pattern.fresh())
        if pattern.learns or k in tested:
            table = run(pipeline, selection.prepared.rows(k)).table
            if k in tested:
                answers[k] = table
    return _read(pattern.name, selection, answers)


def _read(name: str, selection: Selection, answers: dict[int, FloatArray]) -> ProtocolErrors:
    errors = np.empty((len(selection.tested), len(FRACTIONS)))
    for row, k in zip(errors, selection.tested, strict=True):
        row[:] = errors_at(selection.prepared.rows(k), answers[k])
    distances = [selection.prepared.trials[k].distance_px for k in selection.tested]
    return ProtocolErrors(name, errors, np.array(distances))


def errors_at(rows: EventColumns, answers: FloatArray) -> FloatArray:
    """2-D error in px at each of FRACTIONS; where nothing was answered, that of the cursor.

    >>> line = EventColumns.of([0, 1, 2, 3, 4], [0, 20, 60, 80, 100], [0, 0, 0, 0, 0])
    >>> table = np.full((5, 10), np.nan)
    >>> table[3, 1:3] = 97.0, 4.0
    >>> errors_at(line, table).tolist()
    [40.0, 5.0, 0.0]
    """
    silent: BoolArray = np.isnan(answers[:, 1])
    said_x, said_y = np.where(silent, rows.x, answers[:, 1]), np.where(silent, rows.y, answers[:, 2])
    errors = np.hypot(said_x - rows.x[-1], said_y - rows.y[-1])
    away = np.hypot(rows.x - rows.x[0], rows.y - rows.y[0])
    at = [int((away >= share * away[-1]).argmax()) for share in FRACTIONS]
    return np.asarray(errors[at])
