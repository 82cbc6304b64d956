"""The accelerometer on the mouse among the streams of an XDF file: its channels, its unit, its samples."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from pointpred.records import FloatArray

KINDS = ("acc", "accel", "accelerometer", "acceleration")
LABEL = re.compile(r"acc(el(eration|erometer)?)?[ _.:-]*([xyz])\b", re.IGNORECASE)
STANDARD_GRAVITY_M_S2 = 9.80665
UNITS = {
    "m/s^2": 1.0,
    "m/s²": 1.0,
    "m/s2": 1.0,
    "m/s/s": 1.0,
    "g": STANDARD_GRAVITY_M_S2,
    "mg": 1e-3 * STANDARD_GRAVITY_M_S2,
}
"""m/s^2 in a unit, by what the header says of a channel."""
SCALES = {"m/s^2": 1.0, "g": STANDARD_GRAVITY_M_S2, "mg": 1e-3 * STANDARD_GRAVITY_M_S2}
GRAVITY_OFF = 0.2
"""Where the header says nothing, gravity at rest tells the unit, if it is within this share."""
MOST_M_S2 = 1e4
"""Bound of a sample along an axis, as in ``pointpred/differentiators/force_samples.py``."""


def channels_of(name: str, kind: str, labels: Sequence[str], count: int) -> tuple[int, int, int] | None:
    """The channels x, y, z of an accelerometer in a stream of ``count`` channels; ``None`` for another.

    By labels such as ``acc_x``; else a stream of three whose type, or part of whose name, says it.

    >>> channels_of("Mouse IMU", "IMU", ["gyr_x", "gyr_y", "gyr_z", "acc_x", "acc_y", "acc_z"], 6)
    (3, 4, 5)
    >>> channels_of("Sensor", "ACC", ["X", "Y", "Z"], 3)
    (0, 1, 2)
    """
    axes = [match.group(3).lower() if (match := LABEL.match(label.strip())) else "" for label in labels]
    if sorted(filter(None, axes)) == ["x", "y", "z"]:
        return axes.index("x"), axes.index("y"), axes.index("z")
    if count == 3 and (kind.lower() in KINDS or "acceleromet" in name.lower()):
        return 0, 1, 2
    return None


def scale_of(units: Sequence[str], force: FloatArray) -> tuple[float | None, str]:
    """m/s^2 in the unit of a stream, and how it is known; ``None`` and why, where it is not.

    ``units``: what the header says of each channel, ``force`` the samples, shape (samples, 3).
    """
    stated = {unit.strip() for unit in units} - {""}
    if stated:
        scales = {UNITS.get(unit.lower()) for unit in stated}
        words = ", ".join(sorted(stated))
        scale = scales.pop() if len(scales) == 1 else None
        if scale is None:
            return None, f"its unit {words!r} is none of {', '.join(UNITS)}"
        return scale, f"unit {words} as stated"
    middle = float(np.median(np.hypot.reduce(force, axis=1))) if len(force) else 0.0
    for unit, scale in SCALES.items():
        if abs(middle * scale / STANDARD_GRAVITY_M_S2 - 1.0) <= GRAVITY_OFF:
            return scale, f"unit {unit}, since gravity is {middle:.3g} in it"
    return (
        None,
        f"it states no unit, and its median of {middle:.3g} is gravity in none of {', '.join(SCALES)}",
    )


def usable(table: FloatArray) -> tuple[FloatArray, str]:
    """The samples that are numbers within their bounds and not before the one before; what was left out.

    ``table`` has shape (samples, 4): time in s, force in m/s^2.
    """
    finite = np.isfinite(table).all(axis=1) & (np.abs(table[:, 1:]) <= MOST_M_S2).all(axis=1)
    table = table[finite]
    latest = np.maximum.accumulate(table[:, 0]) if len(table) else table[:, 0]
    forwards = table[:, 0] >= latest
    out = int(np.count_nonzero(~finite)), int(np.count_nonzero(~forwards))
    words = [f"{out[0]} samples are no numbers up to {MOST_M_S2:g} m/s^2"] if out[0] else []
    words += [f"{out[1]} samples are stamped before the one before them"] if out[1] else []
    return table[forwards], " and ".join(words) + (": left out" if words else "")
