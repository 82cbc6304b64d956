"""Several devices, of which the first that moves is followed."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from itertools import dropwhile
from typing import Self

import msgspec

from pointpred.devices.source import ClosedOnExit, DeviceInfo, DeviceSource, Report
from pointpred.errors import SourceError

SLICE_S = 0.01
"""How often devices that are listened to are looked at: what they report waits in their queues meanwhile."""
SILENCE_S = 3.0
"""After so long without a report, other devices are listened to as well."""


class Candidate(msgspec.Struct, frozen=True):
    """A device that may be followed: where it is, and what opens it."""

    path: str
    make: Callable[[], DeviceSource]


class FirstMoving(ClosedOnExit):
    """A ``DeviceSource`` over several devices, which becomes the first of them that moves by one count.

    All candidates are open until one moves; then the others are closed, and it is followed until it is
    unplugged. After that whichever moves first is followed, itself included. While it reports nothing for
    ``silence_s``, the others are opened again: one that moves is named in ``note`` and not followed. What a
    device reports before the motion by which it is chosen is left out. Where there is one candidate only, it
    is read from the start, and followed as long as no other moves before it.

    Parameters: ``candidates`` lists the devices, the preferred ones first; it is asked again at each silence,
    so that a device that was plugged in later is seen. ``silence_s`` is counted in the time that ``take``
    waited. Memory: the queues of the open devices. Entering raises SourceError where none can be opened.
    """

    def __init__(
        self, candidates: Callable[[], Sequence[Candidate]], *, silence_s: float = SILENCE_S
    ) -> None:
        self.note = ""
        """The newest remark: which device is followed, or which other one moves."""
        self.closed: tuple[DeviceInfo, ...] = ()
        """Devices that cannot be opened, for messages."""
        self._candidates, self._silence_s = candidates, silence_s
        self._followed: DeviceSource | None = None
        self._moved = self._away = False  # of the one that is followed: since it was plugged in
        self._listened: tuple[DeviceSource, ...] = ()
        self._named: set[str] = set()
        self._silent_s = 0.0
        self._past = (0, 0, 0)
        self._closing: list[threading.Thread] = []

    def __enter__(self) -> Self:
        refused = self._open_candidates()
        if not self._listened:
            raise refused or SourceError("no mouse was found; plug one in")
        if len(self._listened) == 1:
            self._followed, self._listened = self._listened[0], ()
        return self

    @property
    def devices(self) -> tuple[DeviceSource, ...]:
        """The device that is followed, or all that are listened to while none is."""
        followed = self._followed
        return self._listened if followed is None else (followed,)

    @property
    def name(self) -> str:
        """What the device calls itself; how many there are while none has moved."""
        devices = self.devices
        return devices[0].name if len(devices) == 1 else f"the first to move of {len(devices)} devices"

    @property
    def path(self) -> str:
        """Where the device is; all places while none has moved."""
        return ", ".join(one.path for one in self.devices)

    @property
    def clock(self) -> str:
        """Which clock stamps the reports."""
        devices = self.devices
        return devices[0].clock if len(devices) == 1 else "the clock of the device that moves first"

    @property
    def plugged(self) -> bool:
        """Whether the device, or any that may become it, is there now."""
        return any(one.plugged for one in self.devices)

    @property
    def lost(self) -> int:
        """Reports dropped because nobody took them in time."""
        return self._past[0] + sum(one.lost for one in self.devices)

    @property
    def unreadable(self) -> int:
        """Reports that could not be decoded."""
        return self._past[1] + sum(one.unreadable for one in self.devices)

    @property
    def resynchronised(self) -> int:
        """Recoveries after the kernel had dropped events."""
        return self._past[2] + sum(one.resynchronised for one in self.devices)

    def take(self, timeout_s: float) -> list[Report]:
        """Everything that came since the last call; waits at most ``timeout_s`` until something came."""
        followed = self._followed
        if followed is None or not followed.plugged:
            reports = self._wait(timeout_s)
        else:
            self._away = False
            reports = followed.take(timeout_s)
            self._moved |= moves(reports)
            if self._listened:
                reports = reports or self._note_others()
                if moves(reports) and self._followed is followed:
                    self._close_others(followed)
        self._silent_s = 0.0 if reports else self._silent_s + timeout_s
        if self._silent_s >= self._silence_s:
            self._silent_s = 0.0
            self._open_candidates()
        return reports

    def close(self) -> None:
        """Stop reading; may be called twice."""
        followed = self._followed
        self._close((*self._listened, *(() if followed is None else (followed,))))
        while self._closing:
            self._closing.pop().join()

    def _wait(self, timeout_s: float) -> list[Report]:
        """Reports of the first device that moves; raises SourceError where the last one has failed."""
        until = time.monotonic() + timeout_s
        while True:
            if (followed := self._followed) is not None:
                if reports := followed.take(0.0):  # it is back, or its last report: no button is pressed
                    self._moved |= moves(reports)
                    return reports
                if not self._away:
                    self._away, self._moved = True, False
                    self._open_candidates()
            for source in self._listened:
                if moving := from_motion(self._take_from(source)):
                    self._follow(source)
                    return moving
            left = until - time.monotonic()
            if left <= 0.0:
                return []
            time.sleep(min(left, SLICE_S))

    def _take_from(self, source: DeviceSource) -> list[Report]:
        """What a device that is listened to reports; one that failed is left out while others are here."""
        try:
            return source.take(0.0)
        except SourceError:
            if self.devices == (source,):
                raise
            self._listened = tuple(one for one in self._listened if one is not source)
            self._close((source,))
            return []

    def _follow(self, source: DeviceSource) -> None:
        """Follow this device from now on."""
        before = self._followed
        others = tuple(one for one in self._listened if one is not source)
        if before is not None:
            self._past = (self.lost, self.unreadable, self.resynchronised)
            others = (*others, before)
        self._followed, self._moved, self._named = source, True, {source.path}
        if others:
            which = f"the first of {len(others) + 1} devices that moved"
            self.note = f"following {source.path} ({source.name}), {which}"
        self._note_others()
        self._listened = others
        self._close_others(source)

    def _close_others(self, followed: DeviceSource) -> None:
        """Close every device but the one that is followed."""
        others = tuple(one for one in self._listened if one is not followed)
        self._listened = ()
        self._close(others)

    def _note_others(self) -> list[Report]:
        """Name the other devices that move, each once; where the first has never moved, one is followed."""
        for source in self._listened:
            if source is self._followed or not (moving := from_motion(self._take_from(source))):
                continue
            if not self._moved:
                self._follow(source)
                return moving
            if source.path not in self._named:
                self._named.add(source.path)
                other = f"{source.path} ({source.name}) moves too and is not followed; --device chooses it"
                self.note = f"{self.note}; {other}" if self.note else other
        return []

    def _open_candidates(self) -> SourceError | None:
        """Open every candidate that is not open; the error of the last that cannot be."""
        gone = tuple(one for one in self._listened if not one.plugged)
        self._listened = tuple(one for one in self._listened if one.plugged)
        self._close(gone)
        followed = () if self._followed is None else (self._followed.path,)
        here, refused = {*followed, *(one.path for one in self._listened)}, None
        for candidate in self._candidates():
            if candidate.path in here:
                continue
            try:
                self._listened = (*self._listened, candidate.make().__enter__())
            except SourceError as error:
                refused = error
        return refused

    def _close(self, sources: Sequence[DeviceSource]) -> None:
        """Close devices on a thread of its own: a reader may take 0.1 s to end, and reports wait."""
        self._closing = [thread for thread in self._closing if thread.is_alive()]
        for source in sources:
            self._closing.append(threading.Thread(target=source.close, name="closing a device"))
            self._closing[-1].start()


def moves(reports: Sequence[Report]) -> bool:
    """Whether reports hold motion, were it one count."""
    return any(report.dx or report.dy for report in reports)


def from_motion(reports: Sequence[Report]) -> list[Report]:
    """Reports from the first motion on.

    >>> [report.t for report in from_motion([Report(0.0, 0, 0), Report(0.1, 0, 1), Report(0.2, 0, 0)])]
    [0.1, 0.2]
    """
    return list(dropwhile(lambda report: not (report.dx or report.dy), reports))
