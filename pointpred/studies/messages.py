"""What the page of a study sends: one message a request, tagged by its type; every field is bounded."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec
from msgspec import Meta, Struct

from pointpred.protocol.client_messages import Bounded, EventRow

MOST_ROWS = 60_000
"""Samples of one movement that are kept: a minute at 1 kHz. The page counts those beyond it as lost."""
MOST_BYTES = 6 * 2**20
"""Of a request's body: twice what so many samples take as JSON."""

Short = Annotated[str, Meta(max_length=512)]
Extent = Annotated[float, Meta(ge=0.0, le=1e6)]
Count = Annotated[int, Meta(ge=0, le=10**6)]


class PageAbout(Struct, frozen=True, forbid_unknown_fields=True):
    """The browser, screen and device of a participant, as the page knows them; lengths in px."""

    browser: Short
    language: Short
    pointer: Short
    """``fine`` or ``coarse``: what the main pointing device is, as the browser says."""
    screen: tuple[Extent, Extent]
    window: tuple[Extent, Extent]
    pixel_ratio: Extent
    frame_ms: Extent
    """The median time from one frame of the screen to the next."""
    clock_step_ms: Extent
    """The least step of the browser's clock."""


class Agreed(Struct, frozen=True, forbid_unknown_fields=True, tag="consent"):
    """The participant agrees to the consent text."""

    page: PageAbout


class Opened(Struct, frozen=True, forbid_unknown_fields=True, tag="page"):
    """A page was opened again."""

    page: PageAbout


class Answered(Struct, frozen=True, forbid_unknown_fields=True, tag="answers"):
    """Answers to the questions before or after the task, by their names."""

    when: Literal["before", "after"]
    answers: dict[Short, Annotated[str, Meta(max_length=10_000)]]


class Moved(Struct, frozen=True, forbid_unknown_fields=True, tag="trial"):
    """A finished movement, ``number`` counted from 0 over all of the participant's.

    ``rows`` follow the selection ``start``, the last one is the selection that ends it; positions are px from
    the upper left corner of the picture, whose middle is ``centre``. ``at`` is the time of day of the start,
    s since 1970. ``clicks``: presses until it ended; ``hit``: whether the first was inside. ``lost``: samples
    that were not kept.
    """

    number: Count
    centre: tuple[Bounded, Bounded]
    start: EventRow
    rows: Annotated[list[EventRow], Meta(min_length=1, max_length=MOST_ROWS)]
    at: Annotated[float, Meta(ge=0.0, le=1e11)]
    hit: bool
    clicks: Annotated[int, Meta(ge=1, le=10**6)]
    lost: Count = 0


Message = Agreed | Opened | Answered | Moved


def decode(body: bytes) -> Message:
    """The message in a request's body; raises ValueError."""
    message: Message = msgspec.json.decode(body, type=Message)
    return message
