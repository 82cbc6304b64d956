"""Options for reading a recording: everything that its file may not contain."""

from __future__ import annotations

import codecs
import re
from pathlib import Path
from typing import Annotated, Literal, get_args

import msgspec

from pointpred.errors import ParameterError
from pointpred.records import CPI, DPI, LARGEST

Cut = Literal["clicks", "bursts", "whole"]
People = Literal["file", "folder", "column"]
"""What says who moved, where many files make one recording: the file's name, its folder's, or its users."""
TimeUnit = Literal["s", "ms", "us", "ns", "iso"]
FIELDS = ("t", "x", "y", "user", "trial", "buttons", "target_x", "target_y", "target_w", "dx", "dy")
"""The fields to which columns of a table can be mapped."""
NEEDED = ("t", "x", "y")
KEYS = ("user", "trial")
"""The fields that several columns may name together, as ``block+trial``; others may be their sum."""


def told(meaning: str, *, table: bool = False, metavar: str | None = None) -> msgspec.Meta:
    """What a command says of a field; ``table``: it is for tables of one's own."""
    return msgspec.Meta(description=meaning, extra={"table": table, "metavar": metavar})


class Reading(msgspec.Struct, frozen=True, kw_only=True):
    """Options for reading foreign recordings; own recordings contain all of this.

    The fields that say what they mean are options of every command that reads recordings. ``cut``: ``None``
    for the format's default; trials of a stream with fewer than ``least_samples`` >= 2 or shorter than
    ``least_s`` >= 0 s are skipped. ``cpi`` in [1, 1e6] is stored in the provenance; ``dpi`` in [1, 1e5] is
    for positions in cm or m. ``px_per_unit`` in (0, 1e9], one number or those across and down, is for
    positions in another unit than px and than the file says (PsychoPy, any table).

    For any table: ``columns`` names, for some of ``FIELDS``, the column that holds it, by its name or by its
    place counted from 0; other fields are guessed from the usual names, or unknown if t, x and y are all
    named. Columns joined by + name a user or a trial together, and are added up for any other field;
    ``pos.0`` is the first of several numbers in the cells of ``pos``.
    """

    cut: Annotated[
        Cut | None, told("How to cut a stream into trials: clicks, bursts (at pauses of 0.3 s) or whole.")
    ] = None
    cpi: Annotated[float | None, told("Counts per inch of the device.")] = None
    dpi: Annotated[float, told("Pixels per inch of the screen (96).")] = 96.0
    columns: Annotated[
        dict[str, str | int] | None,
        told(
            "Which column is which, by name or by place from 0; also user, trial, buttons, target_x, "
            "target_y, target_w, dx, dy. Not given: guessed from the usual names.",
            table=True,
            metavar="t=NAME,x=NAME,y=NAME",
        ),
    ] = None
    time_unit: Annotated[
        TimeUnit | None, told("Unit of the column t: s, ms, us, ns, or iso (date and time).", table=True)
    ] = None
    y_up: Annotated[bool, told("y grows upwards.", table=True)] = False
    px_per_unit: Annotated[
        float | tuple[float, float] | None,
        told(
            "Pixels in one unit of x, y and the target (1); X,Y where they differ across and down.",
            table=True,
            metavar="NUMBER",
        ),
    ] = None
    encoding: Annotated[
        str | None,
        told(
            "Encoding of the text, as gb18030 or shift_jis; not given: UTF-8, else Windows-1252.",
            metavar="NAME",
        ),
    ] = None
    sort: Annotated[
        bool, told("Sort the samples of each trial or stream by time, however late they are.")
    ] = False
    target: Annotated[str | None, told("Selector of the element that is the goal, as '#left' (jsPsych).")] = (
        None
    )
    least_samples: int = 2
    least_s: float = 0.0

    def __post_init__(self) -> None:
        bounds = (
            ("cut", self.cut in (None, *get_args(Cut)), "clicks, bursts or whole"),
            ("least_samples", self.least_samples >= 2, "at least 2"),
            ("least_s", self.least_s >= 0, "at least 0 s"),
            ("dpi", DPI[0] <= self.dpi <= DPI[1], f"in [{DPI[0]:g}, {DPI[1]:g}] px per inch"),
            (
                "cpi",
                self.cpi is None or CPI[0] <= self.cpi <= CPI[1],
                f"in [{CPI[0]:g}, {CPI[1]:g}] counts per inch",
            ),
            ("encoding", _is_encoding(self.encoding), "the name of an encoding, as gb18030"),
            ("time_unit", self.time_unit in (None, *get_args(TimeUnit)), "s, ms, us, ns or iso"),
            (
                "px_per_unit",
                len(self.gain) == 2 and all(0 < gain <= LARGEST for gain in self.gain),
                f"above 0 and at most {LARGEST:g} px in a unit",
            ),
        )
        for name, good, bound in bounds:
            if not good:
                value = getattr(self, name)
                raise ParameterError(f"{name} must be {bound}, received {value!r}", field=name, value=value)
        _check_columns(self.columns or {})

    @property
    def gain(self) -> tuple[float, float]:
        """Pixels in a unit across and down; 1 where ``px_per_unit`` does not say it."""
        px = 1.0 if self.px_per_unit is None else self.px_per_unit
        return px if isinstance(px, tuple) else (px, px)


def _is_encoding(name: str | None) -> bool:
    """Whether Python knows an encoding of text of this name."""
    try:
        if name is not None:
            codecs.getincrementaldecoder(name)
            "".encode(name)
    except (LookupError, ValueError):
        return False
    return True


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


def px_per_unit_of(text: str) -> float | tuple[float, float]:
    """Parse pixels in a unit, ``38`` or those across and down, ``960,540``; raises ParameterError."""
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) not in (1, 2):
        message = f"px_per_unit must be a number of px, or two as X,Y, received {text!r}"
        raise ParameterError(message, field="px_per_unit", value=text)
    return numbers[0] if len(numbers) == 1 else (numbers[0], numbers[1])


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
