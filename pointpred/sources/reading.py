"""What a reader must be told because the file does not say it."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import msgspec

from pointpred.errors import ParameterError
from pointpred.events import CPI, DPI

Cut = Literal["clicks", "bursts", "whole"]
Unit = Literal["pix", "height", "norm", "cm", "m"]


class Reading(msgspec.Struct, frozen=True, kw_only=True):
    """How foreign recordings are read; own recordings carry all of this themselves.

    ``cut``: how a stream without trials is cut (``segmentation``), ``None`` for what the format is made for;
    ``pause_s`` > 0 s ends a burst; trials of fewer than ``least_samples`` >= 2 or shorter
    than ``least_s`` >= 0 s are skipped.
    ``unit`` of positions where the experiment chose it (PsychoPy); ``screen`` width and height in px, needed
    for the units height and norm; ``dpi`` in [1, 1e5] px per inch, for positions in cm or m; ``cpi`` in
    [1, 1e6] counts per inch of the device, kept in the provenance.
    """

    cut: Cut | None = None
    pause_s: float = 0.3
    least_samples: int = 2
    least_s: float = 0.0
    unit: Unit = "pix"
    screen: tuple[float, float] | None = None
    dpi: float = 96.0
    cpi: float | None = None

    def __post_init__(self) -> None:
        bounds = (
            ("cut", self.cut, self.cut in (None, "clicks", "bursts", "whole"), "clicks, bursts or whole"),
            (
                "unit",
                self.unit,
                self.unit in ("pix", "height", "norm", "cm", "m"),
                "pix, height, norm, cm or m",
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
            ("screen", self.screen, self.screen is None or min(self.screen) > 0, "above 0 px both ways"),
        )
        for name, value, good, bound in bounds:
            if not good:
                raise ParameterError(f"{name} must be {bound}, received {value!r}")


AS_IS = Reading()


def row_name(row: int) -> str:
    """How messages name a row: the header and the line above it are not counted."""
    return f"data row {row} (counted from 0)"


def user_of(path: Path) -> str:
    """The user a file's folder is named after, as in ``user7/session_2`` or ``P3/Data.csv``."""
    folder = path.absolute().parent.name
    return folder if folder[-1:].isdigit() else "unknown"
