"""Measure predictions given the registered targets: ``python -m evidence targets [FOLDER]``.

Each predictor without targets and with those of the recording, on the sets of POINTPRED_RECORDINGS that have
targets, the trials of each person in order. Neither the learned predictor nor the evidence for a target, as
``python -m evidence intent targets`` fitted it, knows the set. FOLDER: coefficients as
``python -m evidence.held_out FOLDER`` writes them; unless given, those of the cache, fitted where they are
missing. A few minutes on two processors.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from evidence import FIGURES
from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.held_out import HeldOut, held_out, stored, trained_predictors, training_sets
from evidence.intent.targets import WITHOUT
from evidence.scored import named
from evidence.targets.level_sets import Read, read
from evidence.thinning import save
from pointpred import build
from pointpred.drawing import GREY, PALETTE, canvas, legend_outside, picture
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.recordings import read as read_recording
from pointpred.records import FloatArray, PredictionColumns
from pointpred.scoring import PredictorErrors, Prepared, prepare, replay, resolution
from pointpred.scoring.measures import time_left
from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.measures.time_left import clock_s
from pointpred.scoring.measures.trial_measures import measure_trials
from pointpred.scoring.replay import given_targets
from pointpred.scoring.results import TIME_FRACTIONS
from pointpred.scoring.target_layouts import with_candidates
from pointpred.targets import Target
from pointpred.targets.aim import Aim
from pointpred.training import data

SETS = ("fitts_xp", "pvplib23714", "gofitts_demo", "freihaut2021")
PREDICTORS = ("hold", "minimum-jerk", "kinematic", "kinematic-adaptive")
CLAIMING = PREDICTORS[2:]
"""Those that state regions and a time left without targets, too."""
LEARNT = 20
"""Movements of a person after which regions and the time left are judged once more."""
AT = tuple(DECILES.index(share) for share in (0.3, 0.5, 0.7))
NONE = {"a tenth": 0.1, "a third": 1.0 / 3.0, "all": 1.0}
"""Share of the movements whose right target is not registered."""
SURE = 1e-6
"""The share of movements to none of the targets where the only one registered is the right one."""
DRAWN = ("fitts_xp, mouse, circle", "fitts_xp, mouse, random", "gofitts_demo", "freihaut2021")
Rows = dict[str, list[tuple[str, ...]]]


def parts(recording: Recording) -> Iterator[tuple[str, Recording]]:
    """The recording by device and layout, where it has several; their names."""
    keys = [
        tuple(str(trial.condition.get(name, "")) for name in ("device", "layout"))
        for trial in recording.trials
    ]
    for key in sorted(set(keys)):
        chosen = [k for k, own in enumerate(keys) if own == key]
        rows, trials = [recording.rows(k) for k in chosen], [recording.trials[k] for k in chosen]
        words = ", ".join(word for i, word in enumerate(key) if word and len({one[i] for one in keys}) > 1)
        name = recording.name + (f", {words}" if words else "")
        yield name, Recording.of(recording.name, rows, trials, provenance=recording.provenance)


def evidence_of(name: str) -> FloatArray:
    """Coefficients of the evidence that were fitted without a set."""
    return np.array(json.loads(WITHOUT.read_text(encoding="utf-8"))[name])


def pattern(name: str, recording: Recording, held: HeldOut) -> Pipeline | None:
    """A predictor that was not fitted to the set; ``None`` where there is none."""
    if name in trained_predictors() and recording.name in training_sets():
        unseen = held.of_set(name, recording)
        return None if unseen is None else named(name, unseen)
    return build(name, **resolution(recording, None, None))


def told(plain: Pipeline, set: str, **settings: Any) -> Pipeline:
    """The predictor given the targets of each trial."""
    twin = plain.fresh()
    twin.aim = Aim(coefficients=evidence_of(set), **settings)
    return given_targets(twin)


def right_of(prepared: Prepared, k: int) -> Target:
    """The candidate that a trial was for."""
    assert prepared.candidates is not None
    trial = prepared.trials[k].trial

    def off(one: Target) -> float:
        return float(
            np.hypot(one.x + one.width / 2 - trial.target_x, one.y + one.height / 2 - trial.target_y)
        )

    return min(prepared.candidates.targets[k], key=off)


def changed(prepared: Prepared, missing: float | None) -> Prepared:
    """The right target taken away in a share of the trials, the same in each run; ``None``: it alone left."""
    assert prepared.candidates is not None
    generator, targets = np.random.default_rng(5), []
    for k, candidates in enumerate(prepared.candidates.targets):
        right = right_of(prepared, k)
        if missing is None:
            targets.append((right,))
        else:
            gone = generator.random() < missing
            targets.append(tuple(one for one in candidates if not (gone and one is right)))
    candidates = msgspec.structs.replace(prepared.candidates, targets=tuple(targets))
    return msgspec.structs.replace(prepared, candidates=candidates)


def oracle(prepared: Prepared) -> PredictorErrors:
    """Somebody who knows how far the movement goes, and keeps the direction from its start to the cursor."""
    table = np.full((len(prepared.events), len(PredictionColumns.names)), np.nan)
    for k, trial in enumerate(prepared.trials):
        a, b = int(prepared.offsets[k]), int(prepared.offsets[k + 1])
        at = prepared.events.table[a:b, 1:3]
        way = at - at[0]
        far = np.hypot(*way.T)[:, None]
        table[a:b, 1:3] = np.where(far > 0.0, at[0] + trial.distance_px * way / np.maximum(far, 1e-9), at)
    table[:, 0], table[:, PredictionColumns.names.index("phase")] = prepared.events.t, 0.0
    clock = clock_s([trial.arrival_s for trial in prepared.trials])
    count = len(prepared.trials)
    measures, _ = measure_trials(prepared, 0, count, prepared.events, PredictionColumns(table), clock)
    return measures.predictor_errors("oracle", float("nan"), (), measures.claimed())


def order_of(prepared: Prepared) -> FloatArray:
    """The place of each trial among those of its person, from 0."""
    seen: dict[str, int] = {}
    order = []
    for one in prepared.trials:
        order.append(seen.get(one.trial.user, 0))
        seen[one.trial.user] = order[-1] + 1
    return np.array(order, dtype=np.float64)


def measured(held: HeldOut, job: tuple[str, Recording]) -> Rows:
    """The rows of every table for one part of a set."""
    name, recording = job
    prepared = with_candidates(prepare(recording, threads=1))
    assert prepared.candidates is not None
    kinds = " and ".join(prepared.candidates.kinds)
    order = order_of(prepared)
    people = len({one.trial.user for one in prepared.trials})
    patterns = {one: pattern(one, recording, held) for one in PREDICTORS}
    run = partial(replay, threads=1)
    floor = run(prepared, build("hold"))
    hold, hold_by_time = floor.time_averaged.mean(), floor.by_time.mean(axis=0)

    def of_hold(errors: PredictorErrors) -> float:
        return float(errors.time_averaged.mean() / hold)

    def by_time(errors: PredictorErrors) -> FloatArray:
        shares: FloatArray = errors.by_time.mean(axis=0) / hold_by_time
        return shares

    rows: Rows = {"errors": [], "by time": [], "none": [], "learned": [], "regions": [], "left": []}
    row = [name, kinds, str(len(prepared.trials)), str(people)]
    known = oracle(prepared)
    rows["by time"].append((name, "oracle", "-", *texts(by_time(known))))
    for predictor, plain in patterns.items():
        if plain is None:
            return {}
        told_one = told(plain, recording.name)
        without, given = run(prepared, plain), run(prepared, told_one)
        row += [] if predictor == "hold" else [f"{of_hold(without):.3f}"]
        row += [f"{of_hold(given):.3f}"]
        rows["by time"].append((name, predictor, "without", *texts(by_time(without))))
        rows["by time"].append((name, predictor, "with", *texts(by_time(given))))
        unlearned = run(prepared, told(plain, recording.name, learn=0))
        rows["learned"].append((name, predictor, f"{of_hold(unlearned):.3f}", f"{of_hold(given):.3f}"))
        if predictor == "hold":
            continue
        missing = (run(changed(prepared, share), told_one) for share in NONE.values())
        more = [f"{of_hold(one) - of_hold(without):.3f}" for one in missing]
        rows["none"].append((name, predictor, *more))
        if predictor in CLAIMING:
            ends = run(changed(prepared, None), told(plain, recording.name, elsewhere=SURE))
            looked = read(prepared, told_one, plain)
            for words, some in (("all", order >= 0), (f"after {LEARNT}", order >= LEARNT)):
                key = (name, predictor, words)
                rows["left"].append((*key, *(of_clock(one, some) for one in (without, given, ends))))
                rows["regions"].append((*key, *held_by(without, given, looked, some)))
    rows["errors"].append((*row, f"{of_hold(known):.3f}"))
    print(f"{name}: {len(prepared.trials)} movements", flush=True)
    return rows


def texts(values: FloatArray) -> list[str]:
    """Numbers as tables have them."""
    return [f"{value:.3f}" for value in values]


def of_clock(errors: PredictorErrors, some: FloatArray) -> str:
    """The error of the time left over that of the clock."""
    if errors.time_left is None:
        return "-"
    left = errors.time_left[some]
    return f"{left[:, time_left.ERROR].sum() / left[:, time_left.CLOCK].sum():.3f}"


def held_by(without: PredictorErrors, given: PredictorErrors, looked: Read, some: FloatArray) -> list[str]:
    """Shares of ends inside the ellipse without targets, that with targets and the level set, and areas."""
    ellipses = [one.inside_by_time[:, AT, :2] for one in (without, given) if one.inside_by_time is not None]
    cells = [
        " / ".join(f"{100 * share:.0f}" for share in np.nanmean(inside[some, :, level], axis=0))
        for level in range(2)
        for inside in (*ellipses, looked.inside)
    ]
    return [*cells, *(f"{np.nanmedian(one[some]):.2f}" for one in (looked.narrower, looked.level_set))]


def draw(by_time: Table) -> None:
    """Error by time with and without targets, a panel a part."""
    rows = {tuple(row[:3]): row[3:] for row in by_time.rows}
    shown = [name for name in DRAWN if (name, "oracle", "-") in rows]
    with canvas(1, len(shown), width=11.0, height=3.6, share=True) as (figure, axes):
        for ax, name in zip(axes, shown, strict=True):
            times = [100 * share for share in TIME_FRACTIONS]
            ax.plot(times, rows[name, "oracle", "-"], color=GREY, label="knows the distance")
            for place, predictor in enumerate(PREDICTORS[1:]):
                for given, style in (("without", "--"), ("with", "-")):
                    label = f"{predictor}, {given}"
                    values = rows[name, predictor, given]
                    ax.plot(times, values, style, color=PALETTE[place], label=label)
            ax.set_title(name.replace("random", "scattered"))
            ax.grid(True)
        legend_outside(figure, axes[0], above=True, columns=4)
        figure.supxlabel("% of the time from onset to arrival")
        figure.supylabel("error / hold")
        alt = "Error over that of hold against time, without and with the targets, for four sets."
        image = picture(figure, alt, "Error by time, without and with targets.", wide=True)
    save(image.svg, FIGURES / "given-targets.svg")


TIMES = "30 / 50 / 70 % of the time"
HEADS = {
    "errors": (
        *("set", "targets", "movements", "people", "`hold` + targets"),
        *(f"`{name}`{more}" for name in PREDICTORS[1:] for more in ("", " + targets")),
        "oracle",
    ),
    "by time": ("set", "predictor", "targets", *(f"{share:.0%}" for share in TIME_FRACTIONS)),
    "none": ("set", "predictor", *NONE),
    "learned": ("set", "predictor", "not learned", "learned"),
    "regions": (
        *("set", "predictor", "movements"),
        *(
            f"{level} %: {what}"
            for level in (50, 80)
            for what in ("ellipse without", "ellipse with", "level set with")
        ),
        *("ellipse, with over without", "level set over ellipse"),
    ),
    "left": ("set", "predictor", "movements", "without", "with", "true end"),
}


def main(held: HeldOut, recordings: Sequence[Recording]) -> None:
    """Measure every part of every set, and draw."""
    jobs = [job for one in recordings for job in parts(one)]
    longest = sorted(range(len(jobs)), key=lambda k: -len(jobs[k][1].events))
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        found = dict(zip(longest, pool.map(partial(measured, held), [jobs[k] for k in longest]), strict=True))
    tables = {
        name: Table.of(heads, [row for k in range(len(jobs)) for row in found[k].get(name, ())])
        for name, heads in HEADS.items()
    }
    draw(tables["by time"])
    keep("targets", tables)


if __name__ == "__main__":
    arguments = parse(__doc__, metavar="folder", most=1)
    where = data.folder()
    sets = [read_recording(next(where.rglob(f"{name}_samples.parquet"))) for name in SETS]
    main(stored(Path(arguments[0])) if arguments else held_out(where), sets)
