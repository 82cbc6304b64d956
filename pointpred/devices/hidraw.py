"""Mice through hidapi's ``hidraw``: which there are, and every report as the device sent it.

The desktop keeps its mouse. Names and report descriptors come from hidapi's list and sysfs, which anyone may
read.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path
from typing import Any, Self

import msgspec

from pointpred.devices.hid import PositionValues, ReportDecoder, parse_descriptor, place_of
from pointpred.devices.source import BROWSER, MOST_WAITING, DeviceInfo, PlaceReports, ReaderSource, Report
from pointpred.devices.surface import OWN_UNITS, ContactReports
from pointpred.devices.udev import hid_rule, permission_advice
from pointpred.errors import RecordingError, SourceError
from pointpred.extras import install_command

EXCLUSIVE = {"win32": "Windows", "cygwin": "Windows", "darwin": "macOS"}
"""Systems that let no program read the reports of a mouse."""
CLASS = Path("/sys/class/hidraw")

WAIT_MS = 100
"""How long a read waits before it looks whether the source was closed."""
RETURN_S = 0.25
"""How often a device that is gone is looked for."""


class HidDevice(msgspec.Struct, frozen=True):
    """A HID device as hidapi lists it; ``identity`` is what stays when it is unplugged and comes back."""

    path: str
    name: str
    vendor: int
    product: int
    serial: str
    interface: int

    @property
    def identity(self) -> tuple[int, int, str, int, str]:
        """Equal for the same device in another port, and for two of a kind without serial numbers."""
        return self.vendor, self.product, self.serial, self.interface, self.name

    @property
    def described(self) -> str:
        """Path and name, as errors say it."""
        return f"{self.path} ({self.name})"


def hidraw() -> Any:
    """The module of hidapi for the kernel's hidraw nodes.

    Raises SourceError, naming what to do, on systems that keep mice to themselves and without hidapi.
    """
    if sys.platform != "linux":
        system = EXCLUSIVE.get(sys.platform, f"this system ({sys.platform})")
        raise SourceError(
            f"{system} keeps mice to itself, no program can read their reports; 'pointpred live' without "
            f"--device follows the cursor there, or {BROWSER}"
        )
    try:
        import hidraw as module
    except ImportError as error:
        raise SourceError(
            f"hidapi cannot be used ({error}); install it: {install_command('live')}"
        ) from error
    return module


def hid_devices() -> list[HidDevice]:
    """Every HID device, mouse or not, in the order of its path; raises SourceError as ``hidraw`` does."""
    devices: dict[str, HidDevice] = {}
    for entry in hidraw().enumerate():  # an entry for each top-level collection of a device
        path, vendor, product = os.fsdecode(entry["path"]), entry["vendor_id"], entry["product_id"]
        name = entry["product_string"] or f"HID device {vendor:04x}:{product:04x}"
        serial, interface = entry["serial_number"] or "", entry["interface_number"]
        devices.setdefault(path, HidDevice(path, name, vendor, product, serial, interface))
    return sorted(devices.values(), key=lambda device: (len(device.path), device.path))


def not_a_mouse(device: HidDevice) -> str | None:
    """Why a device is no mouse that can be read, from its report descriptor; ``None`` where it is one."""
    try:
        data = (CLASS / Path(device.path).name / "device/report_descriptor").read_bytes()
    except OSError as error:
        return f"its report descriptor cannot be read: {error.strerror}"
    try:
        parse_descriptor(data)
    except RecordingError as error:
        return str(error)
    return None


def list_hid(everything: bool = False) -> list[DeviceInfo]:
    """The HID mice, each with why it cannot be opened and what to do; or ``everything``, keyboards and all.

    Raises SourceError where no program can read HID devices: Windows, macOS, or hidapi is missing.
    """
    infos = []
    for device in hid_devices():
        why = not_a_mouse(device)
        if why is None:
            infos.append(device_info(device))
        elif everything:
            infos.append(DeviceInfo(device.path, device.name, "hid", False, why, "choose another device."))
    return infos


def device_info(device: HidDevice) -> DeviceInfo:
    """The description of a mouse, and whether it may be opened."""
    if not Path(device.path).exists():
        advice = "plug the device in; in a container, hand the node into it."
        return DeviceInfo(device.path, device.name, "hid", False, "there is no such node", advice)
    if not os.access(device.path, os.R_OK | os.W_OK):  # hidapi opens for both, and only ever reads here
        advice = permission_advice(udev_rule(device))
        return DeviceInfo(device.path, device.name, "hid", False, "permission denied", advice)
    return DeviceInfo(device.path, device.name, "hid", True)


def udev_rule(device: HidDevice) -> str:
    """The udev rule that gives the user at the screen access to a device."""
    return hid_rule(device.vendor, device.product, is_mouse_interface(device))


def is_mouse_interface(device: HidDevice) -> bool:
    """Whether its USB interface declares itself a mouse (HID 1.11, section 4.3: protocol 2)."""
    try:
        file = CLASS / Path(device.path).name / "device/../bInterfaceProtocol"
        protocol = file.read_text(encoding="utf-8")
    except OSError:  # not USB
        return False
    return protocol.strip() == "02"


def wanted_device(path: str | None, vendor: int | None, product: int | None) -> HidDevice:
    """The device that is meant: by its path, by its numbers, or the first mouse that may be opened.

    Raises SourceError that says what there is instead, and what to do next.
    """
    devices = hid_devices()
    if path is not None:
        for device in devices:
            if device.path == path:
                return device
        known = ", ".join(device.described for device in devices) or "none"
        raise SourceError(f"{path} is no HID device, there are: {known}; see 'pointpred devices list'")
    mice = [
        device
        for device in devices
        if vendor in (None, device.vendor)
        and product in (None, device.product)
        and not_a_mouse(device) is None
    ]
    if not mice:
        wanted = f" {vendor or 0:04x}:{product or 0:04x}" if (vendor, product) != (None, None) else ""
        raise SourceError(
            f"no HID mouse{wanted} found among {len(devices)} HID devices; plug one in, or see why each is "
            f"none with 'pointpred devices list --all'. Containers have no devices of their own: {BROWSER}"
        )
    return next((device for device in mice if device_info(device).openable), mice[0])


class HidSource(ReaderSource):
    """Reports of one HID mouse, pen or touch screen, stamped at the read by a thread of its own.

    Assumes Linux, and a report descriptor with relative x or y, or with a pointer's absolute ones. hidraw has
    no times: a stamp is as late as the scheduler and Python's lock let the thread run. The kernel holds 64
    reports (8 ms of the fastest mice) and drops later ones uncounted: a process that computes for long beside
    this thread may lose some. Wheels count the device's own steps: where the kernel has switched a resolution
    multiplier on, a notch is several. Of two alike without serial numbers, the one that stays is not taken
    for the other; where both are pulled out, the first to come back is.

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
        self._contacts = ContactReports()
        self._places = PlaceReports(OWN_UNITS)

    def __enter__(self) -> Self:
        self._check_unused()
        self._device = wanted_device(*self._wanted)
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
        self._contacts = ContactReports()
        self._places = PlaceReports(self._reports.surface or OWN_UNITS)
        self._device, self.path, self.name, self.plugged = device, device.path, device.name, True

    @property
    def counts(self) -> bool:
        """Whether it has relative motion; known once open."""
        return self._reports.counts

    @property
    def places(self) -> bool:
        """Whether it tells positions; known once open."""
        return self._reports.surface is not None

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
        if decoded is None:
            return
        if isinstance(decoded, PositionValues) or not self._reports.counts:
            place = place_of(self._contacts, decoded)
            if place is not None:
                self._queue.put(self._places.report(t, place, decoded.wheel, decoded.pan))
        else:
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
        if (place := self._contacts.lifted()) is not None:
            self._queue.put(self._places.report(time.monotonic(), place))
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
