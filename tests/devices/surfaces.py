"""Absolute HID devices: real report descriptors and how each writes a report.

The bytes of the descriptors are facts from the Linux kernel's HID selftests (test_tablet.py and
test_multitouch.py in tools/testing/selftests/hid/tests) and from QEMU (hw/usb/dev-hid.c); the class or name
there is beside each.
"""

from __future__ import annotations

import struct

from tests.devices.mice import Mouse

KVM = Mouse(  # qemu_tablet_hid_report_descriptor: absolute x and y in a mouse's collection, no size
    "QEMU USB Tablet",
    bytes.fromhex(
        "05010902a1010901a1000509190129051500250195057501810295017503810105010930093115 0026ff7f350046ff7f"
        "751095028102050109381581257f3500450075089501 8106c0c0"
    ),
    0x0627,
    0x0001,
)
PEN = Mouse(  # TestXPPen_Artist24_28bd_093a: 20.72 by 11.665 inches
    "XP-Pen Artist 24",
    bytes.fromhex(
        "050d0902a10185070920a1000942094409451500250175019503810295028103093295018102950281037510"
        "95013500a4050109306513550d46f05026ff7f8102093146912d26ff7f8102b40930450026ff1f8142093d1581257f"
        "750895018102093e1581257f8102c0c0"
    ),
    0x28BD,
    0x093A,
)
TOUCH = Mouse(  # TestData_modul_7374_1232: a finger a report, 200 by 160 mm
    "data-modul touch screen",
    bytes.fromhex(
        "050d0904a10185010922a1000942150025017501950181020932810209378102251f7505095181020501550e65113500"
        "751046d00726ff0f0930810246400609318102050d750885020955 2510b102c0c0"
    ),
    0x7374,
    0x1232,
)
TWO_FINGERS = Mouse(  # TestActionStar_2101_1011: two fingers a report, a unit that is no length
    "ActionStar touch screen",
    bytes.fromhex(
        "050d0904a10185010922a1020942150025017501950181020932810209478102950581030951750895018102"
        "05013500550e653375109501093026ff4d4670038102093126ff2b46f101810246 0000c0"
        "a102050d0942150025017501950181020932810209478102950581030951750895018102"
        "05013500550e653375109501093026ff4d4670038102093126ff2b46f101810246 0000c0"
        "050d09547508950181 02050d850209552502 75089501b102c0"
    ),
    0x2101,
    0x1011,
)
PAD = Mouse(  # made up: a touch pad without the mouse that real ones have beside it
    "touch pad",
    bytes.fromhex(
        "050d0905a1010922a10209421500250175019501810295078103050126ff0f7510950109308102 0931 8102c0c0"
    ),
)


def kvm(x: int, y: int, buttons: int = 0, wheel: int = 0) -> bytes:
    """A report of ``KVM``; buttons as HID numbers them."""
    return struct.pack("<BHHb", buttons, x, y, wheel)


def pen(x: int, y: int, *, tip: bool = False, barrel: bool = False, near: bool = True) -> bytes:
    """A report of ``PEN``; ``near``: in range."""
    return struct.pack("<BBHHHbb", 7, tip | barrel << 1 | near << 5, x, y, 900 * tip, -3, 4)


def touch(x: int, y: int, *, finger: int = 0, tip: bool = True) -> bytes:
    """A report of ``TOUCH``."""
    return struct.pack("<BBHH", 1, tip * 7 | finger << 3, x, y)


def two_fingers(*fingers: tuple[int, int, int, bool]) -> bytes:
    """A report of ``TWO_FINGERS``: number, x, y and whether it touches, of each."""
    given = [*fingers, (0, 0, 0, False), (0, 0, 0, False)][:2]
    parts = [struct.pack("<BBHH", tip * 7, number, x, y) for number, x, y, tip in given]
    return b"\x01" + b"".join(parts) + bytes([len(fingers)])


REPORTS: list[tuple[Mouse, bytes]] = [
    (KVM, kvm(32767, 0, 31, -1)),
    (PEN, pen(1000, 32767, tip=True, barrel=True)),
    (TOUCH, touch(4095, 7, finger=3)),
    (TWO_FINGERS, two_fingers((1, 300, 5, True), (2, 7, 8, True))),
]
"""Each device and a report of it."""
