"""What ``pointpred camera`` reads, writes, prints and draws: samples, their truth, images, estimates."""

from __future__ import annotations

import csv
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.console import results, table
from pointpred.drawing import GREY, Panel, beside, drawn, picture
from pointpred.errors import ParameterError, RecordingError
from pointpred.files import write_whole
from pointpred.records import FloatArray
from pointpred_observers.camera import CameraColumns, CameraTable, Gravity
from pointpred_observers.camera.scenario import Trajectory

UP = ("ux", "uy", "uz")
"""Columns of the direction opposite to gravity in the camera's frame, where the attitude is known."""
TRUTH = ("t", "depth_m", "vx", "vy", "vz")
MOMENTS = 11
HEADINGS = ("t s", "Z observer m", "Z filter m", "v_z observer m/s", "v_z filter m/s", "believe")
UNITS = {"chi": "1/m", "eta": "1/s", "vx": "m/s", "vy": "m/s", "vz": "m/s"}
Names = tuple[str, ...]
Errors = dict[str, dict[str, float | None]]
SHOWN = (("depth Z [m]", None), ("v_x [m/s]", "vx"), ("v_y [m/s]", "vy"), ("v_z [m/s]", "vz"))


def read_table(source: Path, names: Names, more: Names = ()) -> FloatArray:
    """The columns of a CSV file, in any order, and ``more`` if all of these are there.

    Raises RecordingError naming file, line and column.
    """
    try:
        with source.open(newline="", encoding="utf-8-sig") as stream:
            reader = csv.DictReader(stream)
            header = reader.fieldnames or []
            if missing := [name for name in names if name not in header]:
                reason = f"the header lacks {', '.join(missing)}; needs {', '.join(names)}"
                raise RecordingError(f"{source}: {reason}")
            wanted = (*names, *more) if all(name in header for name in more) else names
            rows = []
            for number, row in enumerate(reader, start=2):
                if None in row:
                    raise RecordingError(f"{source}, line {number}: has more fields than the header")
                rows.append([_number_in(source, number, name, row[name]) for name in wanted])
    except (UnicodeDecodeError, csv.Error) as unusable:
        raise RecordingError(f"{source}: is no CSV file in UTF-8: {unusable}") from unusable
    if len(rows) < 2:
        raise RecordingError(f"{source}: needs at least 2 rows, received {len(rows)}")
    return np.array(rows)


def _number_in(source: Path, number: int, name: str, text: str | None) -> float:
    if text is None or not text.strip():
        if name in ("x", "y"):
            return float("nan")
        raise RecordingError(f"{source}, line {number}: {name} is empty, only x and y may be")
    try:
        return float(text)
    except ValueError as unusable:
        raise RecordingError(f"{source}, line {number}: {name} is no number: {text!r:.40}") from unusable


def read_truth(source: Path) -> FloatArray:
    """The truth beside samples; raises RecordingError for numbers that no camera has, naming file and row."""
    table = read_table(source, TRUTH)
    for row, values in enumerate(table.tolist()):
        for name, value in zip(TRUTH, values, strict=True):
            if not isfinite(value):
                raise RecordingError(f"{source}: row {row}: {name} must be finite, received {value!r}")
        if not values[1] > 0.0:
            raise RecordingError(f"{source}: row {row}: depth_m must be positive, received {values[1]!r}")
    return table


def truth_table(truth: Trajectory) -> FloatArray:
    """What ``run`` compares with."""
    return np.column_stack([truth.t, truth.p[:, 2], truth.v])


def read_samples(source: Path, up: str | None = None) -> CameraColumns:
    """Samples of ``camera simulate``, or of anybody who writes the same columns.

    ``up``: gravity is still in them; the direction opposite to it at the first sample as X,Y,Z, or "rest"
    where the camera rests there. With the columns ux, uy, uz the attitude of each row is known.
    """
    table = read_table(source, CameraColumns.names, UP)
    columns, known = CameraColumns(table[:, :9]), table[:, 9:] if table.shape[1] > 9 else None
    if up is None and known is None:
        return columns
    try:
        first = None if up in (None, "rest") else [float(one) for one in str(up).split(",", 2)]
    except ValueError as unusable:
        raise ParameterError(f"--up needs X,Y,Z or rest, received {up!r}") from unusable
    return Gravity(up=first).run(columns, known)


def errors_of(estimates: CameraTable, truth: FloatArray) -> Errors:
    """RMSE of observer and peer against the truth, where each has an estimate."""
    if len(truth) != len(estimates) or np.abs(truth[:, 0] - estimates.t).max() > 1e-6:
        raise ParameterError(f"TRUTH: needs the {len(estimates)} times of the samples, received others")
    chi, eta = 1.0 / truth[:, 1], truth[:, 4] / truth[:, 1]
    wanted = {"chi": chi, "eta": eta, "vx": truth[:, 2], "vy": truth[:, 3], "vz": truth[:, 4]}
    errors: Errors = {"observer": {}, "peer": {}}
    for name, values in wanted.items():
        for who, prefix in (("observer", ""), ("peer", "peer_")):
            error = getattr(estimates, prefix + name) - values
            finite = error[error == error]
            errors[who][name] = float(np.sqrt(np.mean(finite**2))) if len(finite) else None
    return errors


def summary(estimates: CameraTable, errors: Errors | None) -> dict[str, Any]:
    """The run as JSON: the last estimates, shares of the flags, errors where a truth was given."""
    last = dict(zip(CameraTable.names, estimates.table[-1].tolist(), strict=True))
    running = estimates.peer_chi == estimates.peer_chi
    return {
        "version": 1,
        "samples": len(estimates),
        "images": int(estimates.image.sum()),
        "detectable": float(estimates.detectable.mean()),
        "filter_started_s": float(estimates.t[running][0]) if running.any() else None,
        "last": {name: value if value == value else None for name, value in last.items()},
        "rmse": errors,
    }


def show(estimates: CameraTable, errors: Errors | None) -> None:
    """Print moments spread evenly over the run, and errors where a truth was given."""
    moments = np.linspace(0, len(estimates) - 1, min(MOMENTS, len(estimates))).astype(int)
    rows = [_moment(estimates, int(row)) for row in moments]
    results().print(table(HEADINGS, rows, right=HEADINGS))
    if errors is None:
        return
    named = [f"{name} {unit}" for name, unit in UNITS.items()]
    rows = [(who.replace("peer", "filter"), *map(_number, one.values())) for who, one in errors.items()]
    below = table(("", *named), rows, right=named)
    below.title, below.title_justify = "RMSE beside the truth", "left"
    results().print(below)


def _moment(estimates: CameraTable, row: int) -> tuple[str, ...]:
    running = estimates.peer_chi[row] == estimates.peer_chi[row]
    spread = f" +- {estimates.peer_depth_spread[row]:.3f}" if running else ""
    believe = "filter" if running else ("observer, unchecked" if estimates.detectable[row] else "nobody")
    return (
        f"{estimates.t[row]:.2f}",
        _number(1.0 / estimates.chi[row]),
        _number(1.0 / estimates.peer_chi[row]) + spread,
        _number(estimates.vz[row]),
        _number(estimates.peer_vz[row]),
        believe + ("" if estimates.detectable[row] else "; observer not detectable"),
    )


def _number(value: float | None) -> str:
    return "-" if value is None or value != value else f"{value:.4f}"


def plot(estimates: CameraTable, truth: FloatArray | None, target: Path, title: str) -> None:
    """Write an SVG file with four panels; grey: where the observer's errors do not fade."""
    blind, panels = estimates.detectable == 0.0, []
    for place, (label, name) in enumerate(SHOWN, start=1):
        observer = 1.0 / estimates.chi if name is None else getattr(estimates, name)
        peer = 1.0 / estimates.peer_chi if name is None else getattr(estimates, f"peer_{name}")
        true = [] if truth is None else [truth[:, place]]
        lines = beside(estimates.t, *((one, "truth", "truth") for one in true))
        lines += beside(estimates.t, (observer, "observer", "second"), (peer, "filter (peer)", "first"))
        panels.append(Panel(label, lines, limits=_range(peer, observer, *true)))
    said = f"{title}; grey: not detectable" if blind.any() else title
    with drawn(said, panels, 2) as figure:
        for ax in figure.axes:
            across = ax.get_xaxis_transform()
            ax.fill_between(estimates.t, 0.0, 1.0, blind, color=GREY, alpha=0.15, lw=0.0, transform=across)
        caption = "Depth and velocity over time by observer and filter."
        write_whole(target, picture(figure, caption, title, wide=True).svg.encode())


def _range(*lines: FloatArray) -> tuple[float, float]:
    """What is worth seeing: the middle 96 % of each line, and some air."""
    finite = [line[line == line] for line in lines]
    ends = [np.percentile(line, (2.0, 98.0)) for line in finite if len(line)]
    if not ends:
        return 0.0, 1.0
    low, high = float(np.min(ends)), float(np.max(ends))
    air = 0.1 * max(high - low, 1e-3)
    return low - air, high + air
