"""What ``pointpred camera run`` prints: moments of the run, what to believe, and errors beside a truth."""

from __future__ import annotations

from typing import Any

import numpy as np
from rich.table import Table

from pointpred.console import results
from pointpred_observers.camera import CameraTable

MOMENTS = 11
HEADINGS = ("t s", "Z observer m", "Z filter m", "v_z observer m/s", "v_z filter m/s", "believe")
NAMES = ("chi", "eta", "vx", "vy", "vz")
UNITS = {"chi": "1/m", "eta": "1/s", "vx": "m/s", "vy": "m/s", "vz": "m/s"}
Errors = dict[str, dict[str, float | None]]


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
    table = Table(box=None, pad_edge=False)
    for heading in HEADINGS:
        table.add_column(heading, justify="right")
    for row in np.linspace(0, len(estimates) - 1, min(MOMENTS, len(estimates))).astype(int):
        table.add_row(*_moment(estimates, int(row)))
    results().print(table)
    if errors is None:
        return
    below = Table(box=None, pad_edge=False, title="RMSE beside the truth", title_justify="left")
    below.add_column("")
    for name in NAMES:
        below.add_column(f"{name} {UNITS[name]}", justify="right")
    for who, values in errors.items():
        below.add_row(who.replace("peer", "filter"), *(_number(values[name]) for name in NAMES))
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
