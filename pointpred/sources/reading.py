"""Options for reading a recording: everything that its file may not contain."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Literal, get_args

import msgspec

from pointpred.errors import ParameterError
from pointpred.records import CPI, DPI

Cut = Literal["clicks", "bursts", "whole"]
Unit = Literal["pix", "height", "norm", "cm", "m", "deg"]
TimeUnit = Literal["s", "ms", "us", "ns", "iso"]
FIELDS = ("t", "x", "y", "user", "trial", "buttons", "target_x", "target_y", "target_w", "dx", "dy")
"""The fields to which columns of a table can be mapped."""
NEEDED = ("t", "x", "y")


MOST_PX = 1e9
"""Most pixels in a unit: the bound of positions."""


class Reading(msgspec.Struct, frozen=True, kw_only=True):
    """Options for reading foreign recordings; own recordings contain all of this.

    ``cut``: how a stream without trials is cut (``segmentation``), ``None`` for the format's default;
    ``pause_s`` > 0 s ends a burst; trials of fewer than ``least_samples`` >= 2 or shorter
    than ``least_s`` >= 0 s are skipped.
    ``unit`` of positions if the experiment chose it (PsychoPy), ``None`` for the file's; ``screen`` width and
    height in px, needed for the units height and norm, ``px_per_unit`` for deg; ``dpi`` in [1, 1e5] px per
    inch, for positions in cm or m; ``cpi`` in [1, 1e6] counts per inch of the device, stored in the
    provenance; ``target``: the selector of the page's element that is the goal (jsPsych).

    For any table: ``columns`` names, for some of ``FIELDS``, the column that holds it, by its name or by its
    place counted from 0; other fields are guessed from the usual names, or unknown if t, x and y are all
    named. ``time_unit`` of the column t, ``iso`` for dates and times; ``y_up`` if y grows upwards;
    ``px_per_unit`` in (0, 1e9] px in a unit of x, y and the target; ``records``: the path to the rows in a
    file of nested objects, as ``data.trials``.
    """

    cut: Cut | None = None
    pause_s: float = 0.3
    least_samples: int = 2
    least_s: float = 0.0
    unit: Unit | None = None
    screen: tuple[float, float] | None = None
    dpi: float = 96.0
    cpi: float | None = None
    target: str | None = None
    columns: dict[str, str | int] | None = None
    time_unit: TimeUnit | None = None
    y_up: bool = False
    px_per_unit: float | None = None
    records: str | None = None

    def __post_init__(self) -> None:
        bounds = (
            ("cut", self.cut, self.cut in (None, "clicks", "bursts", "whole"), "clicks, bursts or whole"),
            (
                "unit",
                self.unit,
                self.unit in (None, *get_args(Unit)),
                "pix, height, norm, cm, m or deg",
            ),
            ("pause_s", self.pause_s, self.pause_s > 0, "above 0 s"),
            ("least_samples", self.least_samples, self.least_samples >= 2, "at least 2"),
            ("least_s", self.least_s, self.least_s >= 0, "at least 0 s"),
            ("dpi", self.dpi, DPI[0] <= self.dpi <= DPI[1], f"in [{DPI[0]:g}, {DPI[1]:g}] px per inch"),
            (
                "cpi",
                self.cpi,
                self.cpi is None or CPI[0] <= self.cpi <= CPI[1],
                f"in [{CPI[0]:g}, {CPI[1]:g}] counts per inch",
            ),
            (
                "time_unit",
                self.time_unit,
                self.time_unit in (None, "s", "ms", "us", "ns", "iso"),
                "s, ms, us, ns or iso",
            ),
            (
                "px_per_unit",
                self.px_per_unit,
                self.px_per_unit is None or 0 < self.px_per_unit <= MOST_PX,
                f"above 0 and at most {MOST_PX:g} px in a unit",
            ),
            ("screen", self.screen, self.screen is None or min(self.screen) > 0, "above 0 px both ways"),
        )
        for name, value, good, bound in bounds:
            if not good:
                raise ParameterError(f"{name} must be {bound}, received {value!r}", field=name, value=value)
        _check_columns(self.columns or {})


def columns_of(text: str) -> dict[str, str | int]:
    """Parse a mapping such as ``t=time,x=px,y=py``; raises ParameterError.

    A comma that is not followed by a field belongs to the column's name.

    >>> columns_of("t=time, ms,x=0")
    {'t': 'time, ms', 'x': '0'}
    """
    columns: dict[str, str | int] = {}
    for part in re.split(r",(?=\s*\w+=)", text):
        field, equals, column = part.strip().partition("=")
        if not equals or field in columns:
            why = f"{field} is named twice" if equals else f"{part!r} has no ="
            raise ParameterError(f"columns must be like t=time,x=px,y=py: {why}", field="columns", value=text)
        columns[field.strip()] = column.strip()
    return columns


def _check_columns(columns: dict[str, str | int]) -> None:
    """Raise ParameterError for an unknown field, and for a column mapped to two fields."""
    owners: dict[str, str] = {}
    for field, column in columns.items():
        if field not in FIELDS:
            raise ParameterError(
                f"columns: unknown field {field!r}; known: {', '.join(FIELDS)}", field="columns", value=field
            )
        if not str(column).strip():
            raise ParameterError(
                f"columns: {field} needs the name of a column, received none", field="columns", value=field
            )
        if str(column) in owners:
            raise ParameterError(
                f"columns: {str(column)!r} is both {owners[str(column)]} and {field}; name a column once",
                field="columns",
                value=column,
            )
        owners[str(column)] = field


AS_IS = Reading()


def row_name(row: int) -> str:
    """A row's name in messages: the header and the lines above it are not counted."""
    return f"data row {row} (counted from 0)"


def user_of(path: Path) -> str:
    """The user named by a file's folder, as in ``user7/session_2`` or ``P3/Data.csv``."""
    folder = path.absolute().parent.name
    return folder if folder[-1:].isdigit() else "unknown"
