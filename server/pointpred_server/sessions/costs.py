"""What a client's messages cost, in seconds of the processor: ``python -m tests.server.longest_messages``.

They are numbers that were measured once, not times taken while the service runs: the same messages are always
within the limits, or always beyond them, however busy the machine is.
"""

from __future__ import annotations

from typing import NamedTuple

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.pipeline import Pipeline

AT_ONCE_S = 1e-3
"""What costs more is done by another thread, while other sessions go on, ..."""
SLICE_S = 2.5e-3
"""... in slices of so much: between two of them other sessions have their turn."""
TEXT_BYTE_S = 2e-8
"""A character of a text, which is decoded, whatever comes of it: of the numbers that take longest."""
TARGET_S = 1e-6
"""A target that is registered."""
BUILD_S = 250e-6
"""A pipeline that is built: by ``hello``, ``configure`` and ``person``, ..."""
PERSON_S = 1.3e-3
"""... and one that gets to know a person with many places and habits."""
TRIAL_S, TRIAL_EVENT_S = 1e-3, 1e-6
"""The end of a trial, and each event of it."""
REFUSED_S = 120e-6
"""A frame of which something is refused: what it was is then looked for ..."""
REFUSED_BYTE_S = 6e-10
"""... with copies of the memory of the stages."""

_FRAME_S = 20e-6  # read, decoded and answered
_EVENT_S = 0.9e-6  # by the slowest predictor, where the last one is answered
_SUBSTEP_S = 20e-9
_ASSISTED_S = 6e-6
_ANSWER_S = 2e-6  # a prediction sent for each event,
_LIKELIEST_S = 5e-6  # with the likeliest targets
_TARGET_S = 0.2e-6  # a target, at each event
_PLACES_S = 120e-6  # as many places as are remembered, read at each event
_BYTE_S = 5e-11  # a byte of memory, which is copied for each frame


class Costs(NamedTuple):
    """Of a frame, of each event in it, and of a frame with one event, s."""

    frame_s: float
    event_s: float
    single_s: float

    def of(self, events: int) -> float:
        """Of a frame with so many events, s."""
        return self.frame_s + events * self.event_s

    def slices_of(self, events: int) -> list[slice]:
        """Parts of a frame with so many events, none of which costs much more than ``SLICE_S``."""
        most = max(1, int(SLICE_S / self.event_s))
        return [slice(first, min(first + most, events)) for first in range(0, events, most)]


def costs_of(pipeline: Pipeline, *, targets: int, places: bool, assisted: bool, each: bool) -> Costs:
    """What frames of events cost in a session.

    ``targets``: how many are registered; ``places``: whether they are asked for; ``assisted``: whether the
    service moves the cursor; ``each``: whether each event is answered.
    """
    event_s = _EVENT_S + _TARGET_S * targets + _SUBSTEP_S * _substeps(pipeline)
    event_s += _ASSISTED_S if assisted else 0.0
    event_s += (_ANSWER_S + (_LIKELIEST_S if targets else 0.0)) if each else 0.0
    event_s += _PLACES_S if places else 0.0
    frame_s = _FRAME_S + _BYTE_S * memory_of(pipeline)
    return Costs(frame_s, event_s, frame_s + event_s)


def memory_of(pipeline: Pipeline) -> int:
    """Bytes of what both stages remember."""
    return sum(stage.memory_bytes for stage in (pipeline.differentiator, pipeline.predictor))


def _substeps(pipeline: Pipeline) -> float:
    differentiator = pipeline.differentiator
    if not isinstance(differentiator, HomogeneousDifferentiator):
        return 0.0
    return differentiator.gap_s / differentiator.step_s
