"""Emulated HID mice: real report descriptors and how each mouse writes a report.

The bytes of the descriptors are facts from the Linux kernel's HID selftests
(tools/testing/selftests/hid/tests/test_mouse.py); the class that holds them there is named beside each.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Callable

import msgspec

from tests.devices.umockdev import Testbed

USB = "/devices/pci0000:00/0000:00:14.0/usb1"


class Mouse(msgspec.Struct, frozen=True):
    """A mouse: what it is called and its descriptor."""

    name: str
    descriptor: bytes
    vendor: int = 0x1234
    product: int = 0x0001
    serial: str = ""
    protocol: str = "00"


class Plugged(msgspec.Struct, frozen=True):
    """A mouse in a testbed: its node, where it stands in /sys, and the descriptor to write reports to."""

    testbed: Testbed
    node: str
    syspath: str
    hand: int

    def send(self, report: bytes) -> None:
        """Send one report."""
        os.write(self.hand, report)

    def unplug(self) -> None:
        """Pull it out: the node goes, and whoever reads it is hung up."""
        self.testbed.remove(self.syspath)
        self.testbed.hang_up(self.node)


def plug(testbed: Testbed, mouse: Mouse, number: int = 0) -> Plugged:
    """Plug a mouse in as /dev/hidraw``number``, at a port of its own; each number once in a testbed."""
    port = number + 1
    ids = f"{mouse.vendor:04X}:{mouse.product:04X}"
    device = f"{USB}/1-{port}"
    hid = f"{device}/1-{port}:1.0/0003:{ids}.{number + 1:04X}"
    node, size = f"/dev/hidraw{number}", struct.pack("<I", len(mouse.descriptor))
    testbed.add(
        f"P: {hid}/hidraw/hidraw{number}\nN: hidraw{number}\n"
        f"E: DEVNAME={node}\nE: MAJOR=240\nE: MINOR={number}\nE: SUBSYSTEM=hidraw\n"
        f"A: dev=240:{number}\\n\nL: device=../../../{hid.rsplit('/', 1)[1]}\n\n"
        f"P: {hid}\nE: HID_ID=0003:0000{mouse.vendor:04X}:0000{mouse.product:04X}\nE: HID_NAME={mouse.name}\n"
        f"E: HID_PHYS=usb-0000:00:14.0-{port}/input0\nE: HID_UNIQ={mouse.serial}\nE: SUBSYSTEM=hid\n"
        f"H: report_descriptor={mouse.descriptor.hex().upper()}\n\n"
        f"P: {device}/1-{port}:1.0\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\\n\n"
        f"A: bInterfaceProtocol={mouse.protocol}\\n\n\n"
        f"P: {device}\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nA: idVendor={mouse.vendor:04x}\\n\n"
        f"A: idProduct={mouse.product:04x}\\n\nA: bcdDevice=0100\\n\nA: product={mouse.name}\\n\n\n",
        {
            node: f"HIDIOCGRDESCSIZE 0 {size.hex()}\n"
            f"HIDIOCGRDESC 0 {(size + mouse.descriptor.ljust(4096, bytes(1))).hex()}\n"
            f"HIDIOCGRAWINFO 0 {struct.pack('<IHH', 3, mouse.vendor, mouse.product).hex()}\n"
        },
    )
    return Plugged(testbed, node, f"/sys{device}", testbed.hand(node))


Encode = Callable[[int, int, int, int, int], list[bytes]]
"""dx, dy, buttons 1 to 3 as bits 0 to 2, wheel, pan -> the reports the mouse sends."""

BUTTONS = Mouse(  # ButtonMouse: the boot mouse's three bytes
    "boot-like",
    bytes.fromhex(
        "05010902a1010902a1020901a100050919012903150025017501950381027505950181030501093009311581257f75089502"
        "8106c0c0c0"
    ),
)
WHEEL = Mouse(  # WheelMouse: the wheel outside the pointer's collection
    "wheel",
    bytes.fromhex(
        "05010902a1010509190129031500250195037501810295017505810305010901a100093009311581257f750895028106c0"
        "09381581257f750895018106c0"
    ),
)
TWO_WHEELS = Mouse(  # TwoWheelMouse: 16 buttons, x and y of 16 bits, wheel and AC Pan of 8
    "two wheels",
    bytes.fromhex(
        "05010902a1010901a10005091901291015002501951075018102050116018026ff7f75109502093009318106"
        "1581257f7508950109388106050c0a380295018106c0c0"
    ),
)
SPLIT = Mouse(  # MIDongleMIWirelessMouse: buttons and wheels on report 1, packed 12-bit x and y on report 2
    "MI wireless",
    bytes.fromhex(
        "05010902a10185010901a1009505750105091901290515002501810295017503810175089501050109381581257f8106"
        "050c0a380295018106c085020901a100750c95020501093009311601f826ff078106c0c0"
        "050c0901a1018503150025017501950109cd81060a8301810609b5810609b6810609ea810609e981060a250281060a24028106c0"
    ),
    0x2717,
    0x003B,
)
MULTIPLIER = Mouse(  # ResolutionMultiplierMouse: a feature of another report ID in the middle of the fields
    "resolution multiplier",
    bytes.fromhex(
        "05010902a10105010902a10285110901a10005091901290395037501250181029501810109058102950381010501"
        "09300931950275081581257f8106a10285120948950175021500250135014504b102350045007506b101851109381581257f"
        "75088106c0050c75080a38028106c0c0c0"
    ),
)
TWO_MULTIPLIERS = Mouse(  # ResolutionMultiplierHWheelMouse: everything of 16 bits behind report ID 26
    "two resolution multipliers",
    bytes.fromhex(
        "05010902a10105010902a102851a0901a1000509190129059505750115002501810275039501810105010930093195027510"
        "16018026ff7f8106a1028512094895017502150025013501450cb102851a0938350045009501751016018026ff7f8106c0"
        "a102851209487502150025013501450cb102350045007504b101851a050c9501751016018026ff7f0a38028106c0c0c0c0"
    ),
)
UNIFYING = (
    Mouse(  # mse_descriptor of drivers/hid/hid-logitech-dj.c: 16 buttons and packed 12 bits on report 2
        "Logitech Unifying",
        bytes.fromhex(
            "05010902a10185020901a1000509190129101500250195107501810205011601f826ff07750c9502093009318106"
            "1581257f7508950109388106050c0a380295018106c0c0"
        ),
        0x046D,
        0xC52B,
    )
)
SYZBOT = Mouse(  # BadReportDecoderMouse: generated garbage, features without a size
    "garbage", bytes.fromhex("9601000601002a90a02700000000b3813e25031bdde840503b5d8c3dda")
)


def _clipped(value: int, bits: int) -> int:
    return value & ((1 << bits) - 1)


def _split(dx: int, dy: int, buttons: int, wheel: int, pan: int) -> list[bytes]:
    xy = (_clipped(dx, 12) | _clipped(dy, 12) << 12).to_bytes(3, "little")
    return [struct.pack("<BBbb", 1, buttons, wheel, pan), b"\x02" + xy]


def _unifying(dx: int, dy: int, buttons: int, wheel: int, pan: int) -> list[bytes]:
    xy = (_clipped(dx, 12) | _clipped(dy, 12) << 12).to_bytes(3, "little")
    return [struct.pack("<BH", 2, buttons) + xy + struct.pack("<bb", wheel, pan)]


ENCODERS: list[tuple[Mouse, Encode, int]] = [
    (BUTTONS, lambda dx, dy, b, w, p: [struct.pack("<Bbb", b, dx, dy)], 127),
    (WHEEL, lambda dx, dy, b, w, p: [struct.pack("<Bbbb", b, dx, dy, w)], 127),
    (TWO_WHEELS, lambda dx, dy, b, w, p: [struct.pack("<Hhhbb", b, dx, dy, w, p)], 32767),
    (SPLIT, _split, 2047),
    (UNIFYING, _unifying, 2047),
    (MULTIPLIER, lambda dx, dy, b, w, p: [struct.pack("<BBbbbb", 0x11, b, dx, dy, w, p)], 127),
    (TWO_MULTIPLIERS, lambda dx, dy, b, w, p: [struct.pack("<BBhhhh", 0x1A, b, dx, dy, w, p)], 32767),
]
"""Each mouse that can be read, how it writes a report, and the largest count it can say."""
