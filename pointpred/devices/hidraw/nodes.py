"""Which HID mice there are, what they are called, and what to do where one cannot be opened.

Names and report descriptors come from hidapi's list and sysfs, which anyone may read.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import msgspec

from pointpred.devices.hid.report_descriptor import parse_descriptor
from pointpred.devices.source import DeviceInfo
from pointpred.devices.udev import hid_rule, permission_advice
from pointpred.errors import RecordingError, SourceError
from pointpred.extras import install_command

EXCLUSIVE = {"win32": "Windows", "cygwin": "Windows", "darwin": "macOS"}
"""Systems that let no program read the reports of a mouse."""
BROWSER = (
    "run 'pointpred serve' and use a browser: its page reads the pointer, and docs/guide/browser.md names "
    "the browser client for pages of your own"
)
CLASS = Path("/sys/class/hidraw")


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


def choose(path: str | None, vendor: int | None, product: int | None) -> HidDevice:
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
