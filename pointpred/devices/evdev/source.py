"""Mice through the kernel's own decoding: ``/dev/input/event*`` read as it is, nothing compiled needed."""

from __future__ import annotations

import os
import select
import time
from pathlib import Path
from typing import Self

from pointpred.devices.evdev import nodes
from pointpred.devices.evdev.clock import Clock
from pointpred.devices.evdev.frame_decoder import EVENT, Frame, FrameDecoder, pressed
from pointpred.devices.reader import ReaderSource
from pointpred.devices.source import MOST_WAITING, Report

EVIOCGKEY = 0x80604518
"""_IOC(read, 'E', 0x18, 96): the keys pressed, a bit each."""
KEY_BYTES = 96
AT_ONCE = 256 * EVENT.size
WATCH_S = 0.25
"""How often a node is looked for: one that is gone, or one that should come back."""


class EvdevSource(ReaderSource):
    """Reports of one input node, stamped by the kernel; the desktop keeps its mouse.

    Assumes Linux. Motion that the kernel dropped (SYN_DROPPED) is lost: it is counted in ``resynchronised``
    and nothing is made up for it. The same device is known again by its name, numbers and serial; two alike
    without a serial are told apart by which one stayed.

    Parameters: ``path`` such as ``/dev/input/event5``; ``most`` reports wait, then the oldest goes first.
    Memory: the queue. Entering raises SourceError with what to do next; so does ``take`` before entering.
    """

    def __init__(self, path: str, *, most: int = MOST_WAITING) -> None:
        self.path, self.name, self.plugged = path, "", False
        super().__init__(most)
        self._clock = Clock()
        self._decoder = FrameDecoder()
        self._file, self._stop, self._real = -1, -1, path
        self._unreadable = self._resynchronised = 0  # of devices that were here before

    def __enter__(self) -> Self:
        self._check_unused()
        self._node = nodes.check(self.path)
        self.name = self._node.name
        try:
            self._open(self.path)
        except OSError as error:
            raise nodes.refusal(self._node, error) from error
        self._stopped, self._stop = os.pipe()
        self._start()
        return self

    @property
    def clock(self) -> str:
        """Which clock the kernel stamps with."""
        return self._clock.words

    @property
    def unreadable(self) -> int:
        """Records that cannot be events; the frame of each is void."""
        return self._unreadable + self._decoder.unreadable

    @property
    def resynchronised(self) -> int:
        """Recoveries after the kernel had dropped events."""
        return self._resynchronised + self._decoder.resynchronised

    @property
    def clock_steps(self) -> int:
        """How often a clock that may be set was set."""
        return self._clock.steps

    def close(self) -> None:
        """Stop reading; may be called twice. What was read can still be taken."""
        if self._thread is None or self._stop < 0:
            return
        os.write(self._stop, b".")
        super().close()
        os.close(self._stop)
        os.close(self._stopped)
        self._stop = -1

    def _open(self, path: str) -> None:
        """Open a node; raises OSError."""
        self._file = nodes.open_node(path)
        self.path, self._real = path, os.path.realpath(path)
        self._clock.ask(self._file)
        self._unreadable, self._resynchronised = self.unreadable, self.resynchronised
        self._decoder = FrameDecoder(self._pressed() or 0, self._pressed)
        self.plugged = True

    def _pressed(self) -> int | None:
        """The buttons pressed now; ``None`` where the kernel does not say."""
        import fcntl

        try:
            return pressed(fcntl.ioctl(self._file, EVIOCGKEY, bytes(KEY_BYTES)))
        except OSError:
            return None

    def _read_all(self) -> None:
        """Read while the device is there, wait while it is not."""
        while not (self._read_device() if self.plugged else self._wait_for_device()):
            pass

    def _close_device(self) -> None:
        if self.plugged:
            os.close(self._file)

    def _read_device(self) -> bool:
        """Read until the device is gone (false) or the source is closed (true)."""
        looked = time.monotonic()
        while True:
            ready, _, _ = select.select([self._file, self._stopped], [], [], WATCH_S)
            if self._stopped in ready:
                return True
            now = time.monotonic()
            try:
                data = os.read(self._file, AT_ONCE) if ready else None
            except BlockingIOError:
                data = None
            except OSError:  # ENODEV, or another error of a vanished device
                data = b""
            if data == b"" or (now - looked >= WATCH_S and not Path(self.path).exists()):
                self._unplug(now)
                return False
            if data:
                self._put(self._decoder.feed(data), now)
            looked = now if now - looked >= WATCH_S else looked

    def _put(self, frames: list[Frame], now: float) -> None:
        """Queue what was read at ``now``."""
        for frame in frames:
            t = self._clock.seconds(frame.stamp_us, now)
            self._queue.put(Report(t, frame.dx, frame.dy, frame.buttons, frame.wheel, frame.pan))

    def _unplug(self, now: float) -> None:
        """The device has gone: it presses nothing any more.

        The devices like it are listed before the unplugging is reported, so that later arrivals can be told
        apart.
        """
        self._twins = self._alike() - {self._real}
        os.close(self._file)
        self.plugged = False
        if self._decoder.buttons:
            self._queue.put(Report(max(now, self._clock.last), 0, 0))

    def _alike(self) -> set[str]:
        """The nodes of devices that cannot be told from this one."""
        return {each.path for each in nodes.nodes() if each.identity == self._node.identity}

    def _wait_for_device(self) -> bool:
        """Look for the device until it is back (false) or the source is closed (true)."""
        while not select.select([self._stopped], [], [], WATCH_S)[0]:
            present = self._alike()
            self._twins &= present
            for path in sorted(present - self._twins):
                try:
                    self._open(path)
                except OSError:  # not there any more, or not opened to us yet: udev comes later
                    continue
                return False
        return True
