"""The measures of recorded trials, a row a trial: an Arrow table, which pandas, R and a spreadsheet take."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import hypot, isfinite, log2, nan

import msgspec
import numpy as np
import pyarrow as pa

from pointpred.measures import paths, speeds
from pointpred.recording import Recording, Skip, Trial
from pointpred.records import FloatArray
from pointpred.scoring.trials import prepare

Cell = str | float | int | bool | None
COLUMNS = (
    *("dataset", "user", "trial"),
    *("target_x", "target_y", "target_w", "target_distance_px", "id_bits", "error"),
    *("response_time_s", "initiation_time_s", "movement_time_s", "dwell_time_s"),
    *("path_px", "mad_px", "auc_px2", "x_flips", "y_flips", "sample_entropy"),
    *("peak_speed_px_s", "peak_speed_time_s", "peak_speed_share"),
    *("peak_acceleration_px_s2", "peak_acceleration_time_s", "peak_acceleration_share"),
    *("submovements_meyer", "submovements_persistent"),
    *("tre", "tac", "mdc", "odc", "mv_px", "me_px", "mo_px"),
    *("amplitude_px", "effective_distance_px", "end_along_px", "end_across_px"),
)
"""What is measured, in the order of the table; the trial's conditions stand behind ``trial``."""
NAMES = COLUMNS[:3]
"""Which trial it is, in words."""
WHOLE = {"x_flips", "y_flips", "submovements_meyer", "submovements_persistent", "tre", "tac", "mdc", "odc"}
TOLERANCE = 0.2
"""Windows are similar within this share of the standard deviation of all steps of a recording."""
MISSED = {"0": True, "false": True, "no": True, "1": False, "true": False, "yes": False}


class Movement(msgspec.Struct, frozen=True):
    """One trial from onset to selection, as ``pointpred.scoring.prepare`` cuts it, and what it was for.

    ``t``, ``x``, ``y``: its samples, s and px; ``before``: those of the trial before them, (n, 3). ``start``
    is where the trial began, ``source`` where the task axis begins: the centre of the target before, where
    the recording tells it, else ``start``.
    """

    trial: Trial
    t: FloatArray
    x: FloatArray
    y: FloatArray
    before: FloatArray
    began_s: float
    arrived_s: float
    start: tuple[float, float]
    source: tuple[float, float]


def movements(recording: Recording) -> tuple[list[Movement], tuple[Skip, ...]]:
    """The movements of a recording, and which trials hold none and why.

    A trial begins at its first sample, or at ``started_s`` at ``start_x``, ``start_y`` where it has these
    conditions, as those of the page's Circle have. ``from_x``, ``from_y`` are the centre of the target
    before. Positions among conditions count only in recordings that are in px, y down.
    """
    prepared = prepare(recording)
    place = {id(trial): k for k, trial in enumerate(recording.trials)}
    in_px = recording.provenance.unit == "px" and recording.provenance.y_axis == "down"
    found = []
    for k, scored in enumerate(prepared.trials):
        rows, trial = prepared.rows(k), scored.trial
        whole = recording.rows(place[id(trial)]).table
        first = whole[0]
        began = _number(trial, "started_s")
        start = _place(trial, "start") if in_px and began <= first[0] else None
        source = _place(trial, "from") if in_px else None
        start = start or (float(first[1]), float(first[2]))
        found.append(
            Movement(
                trial,
                rows.t,
                rows.x,
                rows.y,
                whole[whole[:, 0] < rows.t[0], :3],
                began if began <= first[0] else float(first[0]),
                float(prepared.events.t[prepared.arrivals[k]]),
                start,
                source or start,
            )
        )
    return found, prepared.skipped


def measure(recordings: Recording | Iterable[Recording]) -> pa.Table:
    """The measures of every trial that holds a movement: the columns of ``COLUMNS`` and the conditions.

    A condition whose name a measure has is called ``NAME_column``; one that holds numbers and text is text.
    Cells are empty where something is not known, as the target. ``.to_pandas()`` makes a DataFrame.
    """
    given = [recordings] if isinstance(recordings, Recording) else recordings
    return table_of((recording.name, movements(recording)[0]) for recording in given)


def table_of(sets: Iterable[tuple[str, Sequence[Movement]]]) -> pa.Table:
    """The same of movements at hand: the name of each recording with its movements."""
    rows: list[dict[str, Cell]] = []
    conditions: list[dict[str, str | float]] = []
    for dataset, found in sets:
        rows += _rows(dataset, found)
        conditions += [one.trial.condition for one in found]
    arrays = {name: pa.array([row[name] for row in rows], pa.string()) for name in NAMES}
    for name in dict.fromkeys(name for condition in conditions for name in condition):
        cells = [condition.get(name) for condition in conditions]
        if any(isinstance(cell, str) for cell in cells):
            cells = [f"{cell:.17g}" if isinstance(cell, float) else cell for cell in cells]
        arrays[f"{name}_column" if name in COLUMNS else name] = pa.array(cells)
    for name in COLUMNS[len(NAMES) :]:
        kind = pa.bool_() if name == "error" else pa.int64() if name in WHOLE else pa.float64()
        arrays[name] = pa.array([row[name] for row in rows], kind)
    return pa.table(arrays)


def _rows(dataset: str, found: Sequence[Movement]) -> Iterator[dict[str, Cell]]:
    """A row a movement of one recording."""
    steps = [np.diff(paths.time_normalised(one.t, one.x, one.y)[:, 1]) for one in found]
    spread = np.concatenate(steps).std(ddof=1) if steps else nan
    for one, series in zip(found, steps, strict=True):
        entropy = paths.sample_entropy(series, TOLERANCE * float(spread))
        row = {
            **_of_target(one),
            "dataset": dataset,
            "user": one.trial.user,
            "trial": one.trial.trial,
            **_of_time(one),
            **_of_path(one),
            "sample_entropy": entropy,
            **_of_speed(one),
        }
        yield {key: None if isinstance(cell, float) and cell != cell else cell for key, cell in row.items()}


def _of_time(one: Movement) -> dict[str, Cell]:
    onset, end = float(one.t[0]), float(one.t[-1])
    return {
        "response_time_s": end - one.began_s,
        "initiation_time_s": onset - one.began_s,
        "movement_time_s": end - onset,
        "dwell_time_s": end - one.arrived_s,
    }


def _of_path(one: Movement) -> dict[str, Cell]:
    along, deviation = paths.deviations(one.x, one.y)
    return {
        "path_px": float(np.hypot(np.diff(one.x), np.diff(one.y)).sum()),
        "mad_px": paths.maximum_deviation(deviation),
        "auc_px2": paths.area_under_curve(along, deviation),
        "x_flips": paths.flips(one.x),
        "y_flips": paths.flips(one.y),
    }


def _of_speed(one: Movement) -> dict[str, Cell]:
    t, x, y = np.vstack([one.before, np.column_stack([one.t, one.x, one.y])]).T
    found = speeds.velocities(t, x, y, float(one.t[0]))
    speed, acceleration = found.speed, found.acceleration
    fastest, hardest = int(speed.argmax()), int(acceleration.argmax())
    took = float(one.t[-1] - one.t[0])
    line = found.along(float(one.x[-1] - one.x[0]), float(one.y[-1] - one.y[0]))
    return {
        "peak_speed_px_s": float(speed[fastest]),
        "peak_speed_time_s": float(found.t[fastest]),
        "peak_speed_share": float(found.t[fastest]) / took,
        "peak_acceleration_px_s2": float(acceleration[hardest]),
        "peak_acceleration_time_s": float(found.t[hardest]),
        "peak_acceleration_share": float(found.t[hardest]) / took,
        "submovements_meyer": speeds.meyer_submovements(*line),
        "submovements_persistent": speeds.persistent_submovements(speed),
    }


def _of_target(one: Movement) -> dict[str, Cell]:
    """What depends on the target: difficulty, error, accuracy along the task axis, where the end lies."""
    trial, (x, y), (end_x, end_y) = one.trial, one.start, (float(one.x[-1]), float(one.y[-1]))
    (from_x, from_y), (to_x, to_y), width = one.source, (trial.target_x, trial.target_y), trial.target_w
    distance = hypot(to_x - from_x, to_y - from_y)
    row: dict[str, Cell] = dict.fromkeys(COLUMNS)
    row |= {"target_x": to_x, "target_y": to_y, "target_w": width, "error": _missed(trial)}
    row["amplitude_px"] = hypot(end_x - x, end_y - y)
    if not (isfinite(distance) and distance > 0.0):
        return row
    ux, uy = (to_x - from_x) / distance, (to_y - from_y) / distance
    row |= {
        "target_distance_px": distance,
        "effective_distance_px": (end_x - x) * ux + (end_y - y) * uy,
        "end_along_px": (end_x - to_x) * ux + (end_y - to_y) * uy,
        "end_across_px": (end_y - to_y) * ux - (end_x - to_x) * uy,
    }
    if width > 0.0:
        row["id_bits"] = log2(distance / width + 1.0)
        row |= paths.accuracy(one.x, one.y, one.source, (to_x, to_y), width)._asdict()
        if row["error"] is None:
            row["error"] = hypot(end_x - to_x, end_y - to_y) > width / 2.0
    return row


def _missed(trial: Trial) -> bool | None:
    """Whether the recording says that the trial missed, by its condition ``hit``; ``None``: it does not."""
    hit = trial.condition.get("hit")
    return MISSED.get(hit.lower() if isinstance(hit, str) else f"{hit:g}") if hit is not None else None


def _number(trial: Trial, name: str) -> float:
    """A condition that is a number, else NaN."""
    value = trial.condition.get(name)
    return float(value) if isinstance(value, float | int) else nan


def _place(trial: Trial, name: str) -> tuple[float, float] | None:
    """The place whose coordinates two conditions hold, in px; ``None`` where one is missing."""
    x, y = _number(trial, f"{name}_x"), _number(trial, f"{name}_y")
    return (x, y) if isfinite(x) and isfinite(y) else None
