"""Mice through hidapi's ``hidraw``: every report as the device sent it, while the desktop keeps its mouse."""

from __future__ import annotations

import time
from typing import Any, Self

from pointpred.devices.hid.report_decoder import ReportDecoder
from pointpred.devices.hid.report_descriptor import parse_descriptor
from pointpred.devices.hidraw.nodes import HidDevice, choose, device_info, hid_devices, hidraw
from pointpred.devices.reader import ReaderSource
from pointpred.devices.source import MOST_WAITING, Report
from pointpred.errors import RecordingError, SourceError

WAIT_MS = 100
"""How long a read waits before it looks whether the source was closed."""
RETURN_S = 0.25
"""How often a device that is gone is looked for."""


class HidSource(ReaderSource):
    """Reports of one HID mouse, stamped at the read by a thread of its own.

    Assumes Linux, and a mouse whose report descriptor has relative x or y. hidraw has no times: a stamp is as
    late as the scheduler and Python's lock let the thread run. The kernel holds 64 reports (8 ms of the
    fastest mice) and drops later ones uncounted: a process that computes for long beside this thread may
    lose some. Wheels count the device's own steps: where the kernel has switched a resolution multiplier on,
    a notch is several. Of two alike without serial numbers, the one that stays is not taken for the other;
    where both are pulled out, the first to come back is.

    Parameters: ``path`` such as ``/dev/hidraw2``; or ``vendor`` and ``product`` numbers; or neither: the
    first mouse that may be opened. At most ``most`` reports wait, then the oldest goes first.
    Memory: the queue. Entering raises SourceError with what to do next; so does ``take`` before entering.
    """

    resynchronised = 0
    clock = "this computer's monotonic clock, at the read: hidraw gives no times"

    def __init__(
        self,
        path: str | None = None,
        *,
        vendor: int | None = None,
        product: int | None = None,
        most: int = MOST_WAITING,
    ) -> None:
        self.path, self.name, self.plugged, self.unreadable = path or "", "", False, 0
        self._wanted = path, vendor, product
        super().__init__(most)
        self._buttons = 0

    def __enter__(self) -> Self:
        self._check_unused()
        self._device = choose(*self._wanted)
        self._open(self._device)
        self._start()
        return self

    def _open(self, device: HidDevice) -> None:
        """Open a device and learn its reports; raises SourceError."""
        info = device_info(device)
        if not info.openable:
            raise SourceError(
                f"{device.described}: {info.why}; {info.advice}", code="cannot_open", value=device.path
            )
        handle: Any = hidraw().device()
        try:
            handle.open_path(device.path.encode())
            self._reports: ReportDecoder = parse_descriptor(bytes(handle.get_report_descriptor()))
        except RecordingError as error:
            handle.close()
            raise SourceError(f"{device.described}: {error}") from error
        except OSError as error:
            handle.close()
            raise SourceError(
                f"{device.described}: {error}; unplug it and plug it in again, 'dmesg' says what the kernel "
                "makes of it"
            ) from error
        self._handle = handle
        self._device, self.path, self.name, self.plugged = device, device.path, device.name, True

    @property
    def _described(self) -> str:
        return super()._described if self._thread is None else self._device.described

    def _read_all(self) -> None:
        """Read while the device is there, wait for it while it is not."""
        while not self._stopping.is_set():
            if self.plugged:
                self._read()
            else:
                self._wait_for_return()

    def _close_device(self) -> None:
        self._handle.close()

    def _read(self) -> None:
        """One report, or none within WAIT_MS; the error of a device that has gone marks it unplugged."""
        try:
            data = self._handle.read(self._reports.longest, WAIT_MS)
        except OSError:
            self._unplug()
            return
        if data:
            self._put(time.monotonic(), bytes(data))

    def _put(self, t: float, data: bytes) -> None:
        """Queue the values of a report; those of a keyboard or a vendor are left out."""
        try:
            decoded = self._reports.decode(data)
        except RecordingError:
            self.unreadable += 1
            return
        if decoded is not None:
            dx, dy, pressed, mask, wheel, pan = decoded
            self._buttons = (self._buttons & ~mask) | pressed
            self._queue.put(Report(t, dx, dy, self._buttons, wheel, pan))

    def _unplug(self) -> None:
        """Report that no button is pressed any more, and remember the devices like it that are still here.

        They are listed before the unplugging is reported: a device that appears later may be this one.
        """
        self._others = {device.path for device in self._alike()} - {self.path}
        self._handle.close()
        self.plugged = False
        if self._buttons:
            self._buttons = 0
            self._queue.put(Report(time.monotonic(), 0, 0))

    def _wait_for_return(self) -> None:
        """Look once for the device; one that udev has not made accessible yet is tried again."""
        alike = self._alike()
        self._others &= {device.path for device in alike}
        for device in alike:
            if device.path not in self._others:
                try:
                    self._open(device)
                    return
                except SourceError:
                    continue
        self._stopping.wait(RETURN_S)

    def _alike(self) -> list[HidDevice]:
        """Devices that cannot be distinguished from this one, itself among them while it is plugged in."""
        return [device for device in hid_devices() if device.identity == self._device.identity]
