"""The kinds of fields that messages have, with their bounds."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta

from pointpred import person
from pointpred.events import CPI, DPI, LARGEST, LATEST_S
from pointpred.targets.rectangles import SMALLEST_PX

Moment = Annotated[float, Meta(ge=-LATEST_S, le=LATEST_S)]
Bounded = Annotated[float, Meta(ge=-LARGEST, le=LARGEST)]
Positive = Annotated[float, Meta(gt=0.0, le=LARGEST)]
Extent = Annotated[float, Meta(ge=SMALLEST_PX, le=LARGEST)]
Weight = Annotated[float, Meta(ge=0.0, le=LARGEST)]
Share = Annotated[float, Meta(ge=0.0, le=1.0)]
Cpi = Annotated[float, Meta(ge=CPI[0], le=CPI[1])]
Dpi = Annotated[float, Meta(ge=DPI[0], le=DPI[1])]
Buttons = Annotated[int, Meta(ge=0, le=65535)]
Name = Annotated[str, Meta(min_length=1, max_length=128)]
Known = Annotated[str, Meta(max_length=person.LARGEST)]
"""What is known of a person, as ``Pipeline.person`` gives it."""
