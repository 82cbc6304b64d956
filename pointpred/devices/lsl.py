"""Lab Streaming Layer: its clock beside ours, a stream in the place of a device, and one of predictions."""

from __future__ import annotations

import re
import time
import uuid
from collections.abc import Sequence
from math import isfinite
from typing import Any, Self

import msgspec
import numpy as np

from pointpred.devices.cursor_paths import PositionReport
from pointpred.devices.source import ClosedOnExit, DeviceSource, Report
from pointpred.errors import SourceError
from pointpred.extras import missing_extra
from pointpred.records import PHASES, Pair, PointerEvent, PredictionRow, prediction_row

PURPOSE = "Lab Streaming Layer"
TRIES = 5
KNOWN = ("x", "y", "dx", "dy", "buttons")
ASIDE = re.compile(r"mouse|cursor|pointer|position|pos|pixels?|(?<=[xy])px$")
"""Parts of labels such as MouseX, x_px or pos-x beside the name of the channel."""
WAIT_S = 5.0
MOST_AT_ONCE = 1024
BUFFER = 600
"""Buffer of Lab Streaming Layer: s for a stream of known rate, hundreds of samples for another."""

OUTLET, KIND = "pointpred", "Prediction"
"""Name and type of the stream that is sent."""
CHANNELS = {
    "t": "s",
    "x": "px",
    "y": "px",
    "sxx": "px2",
    "sxy": "px2",
    "syy": "px2",
    "tail": "1",
    "remaining_s": "s",
    "phase": "code",
}
"""The channels of a sample, with units."""


def library() -> Any:
    """The module pylsl; raises MissingExtraError, and SourceError where its library cannot be loaded."""
    try:
        import pylsl
    except ImportError as error:
        raise missing_extra("live", f"{PURPOSE} needs pylsl") from error
    except (RuntimeError, OSError) as error:
        raise SourceError(f"{PURPOSE} cannot be loaded: {' '.join(str(error).split())}") from error
    return pylsl


def ahead_s(lsl: Any) -> float:
    """How far this computer's monotonic clock is ahead of Lab Streaming Layer's, s; the same on most systems.

    Of some looks the quickest one counts: it is off by less than the microseconds that it took.
    """
    looks = []
    for _ in range(TRIES):
        before, theirs, after = time.perf_counter(), lsl.local_clock(), time.perf_counter()
        looks.append((after - before, 0.5 * (before + after) - theirs))
    return float(min(looks)[1])


class Channels(msgspec.Struct, frozen=True):
    """The channel of each quantity of a stream; ``None`` if absent."""

    x: int
    y: int
    dx: int | None = None
    dy: int | None = None
    buttons: int | None = None


class LslInlet(ClosedOnExit):
    """A ``DeviceSource`` over the samples of one stream.

    Assumes a stream of numbers with a position in px, y downwards. Times are moved to this computer's
    monotonic clock by the stream's own time correction, which is kept up to date, and never go back.
    ``unreadable`` counts samples whose position is no number. Limitations: what the network loses, and what
    is not taken within ten minutes, is not counted; a stream that its sender took down is waited for where
    it has a source id, else ``take`` raises SourceError. Memory: ten minutes of the stream.

    Parameters: ``name`` of the stream; ``wait_s`` to look for it. Entering raises SourceError with what to
    do next, and MissingExtraError.
    """

    lost = resynchronised = 0
    plugged = True

    def __init__(self, name: str, *, wait_s: float = WAIT_S) -> None:
        self.name, self.path = name, f"lsl:{name}"
        self.unreadable = 0
        self.clock = "this computer's monotonic clock, to which a stream's stamps are moved"
        self.words = ""
        """The meaning of its positions; known once open."""
        self.offset_s = 0.0
        """Offset of its first stamps to this computer's Lab Streaming Layer clock, s."""
        self.counts = False
        """Whether its samples have counts; known once open."""
        self._wait_s = wait_s
        self._inlet: Any = None
        self._place: tuple[float, float] | None = None

    def __enter__(self) -> Self:
        lsl = library()
        if "'" in self.name:
            raise SourceError(f"{self.name}: a stream is found by a name without an apostrophe")
        streams = lsl.resolve_byprop("name", self.name, 1, self._wait_s)
        if not streams:
            raise SourceError(_nothing(self.name, lsl.resolve_streams(min(1.0, self._wait_s))))
        flags = lsl.proc_clocksync | lsl.proc_monotonize
        inlet = lsl.StreamInlet(streams[0], max_buflen=BUFFER, processing_flags=flags)
        try:
            about = inlet.info(self._wait_s)
            if about.channel_format() == lsl.cf_string:
                raise SourceError(f"{self.name}: its samples are words, expected numbers")
            labels = about.get_channel_labels() or []
            self._channels = channels_of(self.name, about.channel_count(), labels)
            inlet.open_stream(self._wait_s)
            self.offset_s = float(inlet.time_correction(self._wait_s))
        except RuntimeError as error:
            raise SourceError(f"{self.name}: the stream cannot be opened: {type(error).__name__}") from error
        self._ahead_s, self._inlet = ahead_s(lsl), inlet
        self.counts = None not in (self._channels.dx, self._channels.dy)
        self.clock = (
            f"this computer's monotonic clock; the stamps of {about.hostname()} are corrected by "
            f"{1e3 * self.offset_s:+.3f} ms at first"
        )
        self.words = f"positions of the stream {self.name!r}, {_channel_words(self._channels, labels)}"
        return self

    def take(self, timeout_s: float) -> list[Report]:
        """Everything that came since the last call; waits at most ``timeout_s`` until something came."""
        if self._inlet is None:
            raise SourceError("the stream is not open; use it in a 'with' statement")
        try:
            sample, stamp = self._inlet.pull_sample(timeout_s)
            if sample is None:
                return []
            samples, stamps = self._inlet.pull_chunk(0.0, MOST_AT_ONCE)
        except RuntimeError as error:
            raise SourceError(f"{self.name}: the stream has ended ({type(error).__name__})") from error
        pairs = zip([sample, *samples], [stamp, *stamps], strict=True)
        reports = [self._report(values, at + self._ahead_s) for values, at in pairs]
        valid: list[Report] = [report for report in reports if report is not None]
        self.unreadable += len(reports) - len(valid)
        return valid

    def close(self) -> None:
        """Leave the stream; may be called twice."""
        if self._inlet is not None:
            self._inlet.close_stream()
        self._inlet = None

    def _report(self, values: Sequence[float], t: float) -> PositionReport | None:
        """A sample as an event; ``None`` where its place is no number."""
        places = self._channels
        x, y = float(values[places.x]), float(values[places.y])
        if not (isfinite(x) and isfinite(y)):
            return None
        before, self._place = self._place or (x, y), (x, y)
        dx = dy = None
        if (
            places.dx is not None
            and places.dy is not None
            and isfinite(values[places.dx] + values[places.dy])
        ):
            dx, dy = float(values[places.dx]), float(values[places.dy])
        pressed = 0.0 if places.buttons is None else values[places.buttons]
        buttons = int(pressed) if isfinite(pressed) and pressed > 0 else 0
        event = PointerEvent(t, x, y, dx, dy, buttons)
        moved = (x - before[0], y - before[1]) if dx is None or dy is None else (dx, dy)
        return PositionReport(t, *moved, buttons, event=event)


def channels_of(name: str, count: int, labels: Sequence[str | None]) -> Channels:
    """Which channels are the position, by their labels, or the first two where there are no labels.

    Raises SourceError for fewer than two channels, and for labels without x and y.

    >>> channels_of("mouse", 3, ["MouseY", "MouseX", "Buttons"])
    Channels(x=1, y=0, dx=None, dy=None, buttons=2)
    """
    if count < 2:
        raise SourceError(f"{name}: {count} channel, expected two or more, with x and y")
    if not any(labels):
        return Channels(0, 1)
    places: dict[str, int] = {}
    for place, label in enumerate(labels[:count]):  # a description may name more than there are
        word = ASIDE.sub("", re.sub("[^a-z]", "", (label or "").lower()))
        word = "buttons" if word == "button" else word
        if word in KNOWN:
            places.setdefault(word, place)
    if not {"x", "y"} <= places.keys():
        names = ", ".join(label or "-" for label in labels)
        raise SourceError(f"{name}: its channels are {names}; expected channels labelled x and y")
    return Channels(**places)


def _channel_words(channels: Channels, labels: Sequence[str | None]) -> str:
    if not any(labels):
        return "its first two channels: none has a label"
    known = {name: getattr(channels, name) for name in KNOWN}
    return "channels " + ", ".join(f"{name} = {labels[at]}" for name, at in known.items() if at is not None)


def _nothing(name: str, others: Sequence[Any]) -> str:
    """Why no stream was found, and the streams present."""
    names = ", ".join(sorted(f"{one.name()} ({one.channel_count()} channels)" for one in others)) or "none"
    return (
        f"no stream of {PURPOSE} is called {name!r}; streams on this network: {names}. Start the program "
        "that sends it; a firewall may keep its announcements away"
    )


class LslOutlet:
    """A stream that others on the network may read: a ``Watcher`` that sends each prediction with its event.

    A sample has the channels of ``CHANNELS``: the event's time ``t`` on the source's clock, and the rest of
    its prediction, NaN where nothing was justified or is not known. ``phase`` counts the words of ``phases``
    in the description. The stamp is the time of the event where the source counts on this computer's clock,
    else the time of sending. The description says which clock ``t`` is on (``clock/source``), what leads from
    ``t`` to the stamp where that is fixed (``clock/offset_s``), and for an event that came by a stream itself
    what its first stamps were corrected by (``clock/correction_s``). Assumes that one thread calls ``take``.
    Memory: what Lab Streaming Layer keeps for readers.
    Raises MissingExtraError and SourceError.
    """

    def __init__(self, predictor: str, source: DeviceSource) -> None:
        lsl = library()
        self._source, self._now = source, lsl.local_clock
        self._ahead_s = ahead_s(lsl)
        about = lsl.StreamInfo(
            OUTLET, KIND, len(CHANNELS), lsl.IRREGULAR_RATE, lsl.cf_double64, f"{OUTLET}-{uuid.uuid4().hex}"
        )
        about.set_channel_labels(list(CHANNELS))
        about.set_channel_units(list(CHANNELS.values()))
        described = about.desc()
        described.append_child_value("predictor", predictor)
        described.append_child_value("phases", " ".join(PHASES))
        clock = described.append_child("clock")
        clock.append_child_value("source", source.clock)
        if self._dated:
            clock.append_child_value("offset_s", repr(-self._ahead_s))
        clock.append_child_value("correction_s", repr(float(getattr(source, "offset_s", 0.0))))
        self._outlet = lsl.StreamOutlet(about)

    @property
    def _dated(self) -> bool:
        """Whether the times of events are those of this computer's clock; a recording's are its own."""
        return "monotonic" in self._source.clock

    def take(self, pairs: Sequence[Pair]) -> None:
        """Send what came."""
        if pairs:
            answers = [PredictionRow(*prediction_row(one, event.t)) for event, one in pairs]
            rows = np.array([[getattr(row, name) for name in CHANNELS] for row in answers])
            stamps = rows[:, 0] - self._ahead_s if self._dated else np.full(len(rows), self._now())
            self._outlet.push_chunk(rows, stamps.tolist())
