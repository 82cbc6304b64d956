"""What ``pointpred camera run`` prints: moments of the run, what to believe, and errors beside a truth."""

from __future__ import annotations

from typing import Any

import numpy as np
from rich.table import Table

from pointpred.camera import CameraTable
from pointpred.console import results

MOMENTS = 11
HEADINGS = ("t s", "Z observer m", "Z filter m", "v_z observer m/s", "v_z filter m/s", "believe")
NAMES = ("chi", "eta", "vx", "vy", "vz")
UNITS = {"chi": "1/m", "eta": "1/s", "vx": "m/s", "vy": "m/s", "vz": "m/s"}
Errors = dict[str, dict[str, float | None]]


def summary(found: CameraTable, errors: Errors | None) -> dict[str, Any]:
    """The run as JSON: the last estimates, shares of the flags, errors where a truth was given."""
    last = dict(zip(CameraTable.names, found.table[-1].tolist(), strict=True))
    told = found.peer_chi == found.peer_chi
    return {
        "version": 1,
        "samples": len(found),
        "images": int(found.image.sum()),
        "detectable": float(found.detectable.mean()),
        "filter_started_s": float(found.t[told][0]) if told.any() else None,
        "last": {name: value if value == value else None for name, value in last.items()},
        "rmse": errors,
    }


def show(found: CameraTable, errors: Errors | None) -> None:
    """Print moments spread evenly over the run, and errors where a truth was given."""
    table = Table(box=None, pad_edge=False)
    for heading in HEADINGS:
        table.add_column(heading, justify="right")
    for row in np.linspace(0, len(found) - 1, min(MOMENTS, len(found))).astype(int):
        table.add_row(*_moment(found, int(row)))
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


def _moment(found: CameraTable, row: int) -> tuple[str, ...]:
    told = found.peer_chi[row] == found.peer_chi[row]
    spread = f" +- {found.peer_depth_spread[row]:.3f}" if told else ""
    believe = "filter" if told else ("observer, unchecked" if found.detectable[row] else "nobody")
    return (
        f"{found.t[row]:.2f}",
        _number(1.0 / found.chi[row]),
        _number(1.0 / found.peer_chi[row]) + spread,
        _number(found.vz[row]),
        _number(found.peer_vz[row]),
        believe + ("" if found.detectable[row] else "; observer not detectable"),
    )


def _number(value: float | None) -> str:
    return "-" if value is None or value != value else f"{value:.4f}"
