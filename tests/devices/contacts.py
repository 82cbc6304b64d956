"""Absolute devices by the kernel's input events: a KVM mouse, a pen, a touch screen, and their logs."""

from __future__ import annotations

import msgspec

from tests.devices.evdev_mice import InputEvent, Mouse

SYN, KEY, ABS = 0, 1, 3
REPORT, X, Y, SLOT, MT_X, MT_Y, ID = 0, 0, 1, 0x2F, 0x35, 0x36, 0x39
LEFT, PEN, FINGER, TOUCH, STYLUS = 0x110, 0x140, 0x145, 0x14A, 0x14B
Frame = list[tuple[int, int, int]]
Told = tuple[float, float, int, bool]
"""Shares of the surface, buttons, whether a contact begins."""


class Device(msgspec.Struct, frozen=True):
    """What a device says of itself, its frames, and the places they tell (``None``: none)."""

    name: str
    keys: list[int]
    direct: bool
    ranges: dict[int, tuple[int, int, int]]
    frames: list[tuple[Frame, Told | None]]

    @property
    def node(self) -> Mouse:
        """As evemu describes it."""
        axes = sum(1 << code for code in self.ranges)
        bitmaps = {0: 0xB, 1: sum(1 << key for key in self.keys), 3: axes}
        return Mouse(self.name, "0003 1234 0001 0111", bitmaps, 2 * self.direct, self.ranges)

    @property
    def told(self) -> list[Told]:
        """The places in order."""
        return [told for _, told in self.frames if told is not None]

    def events(self, step_us: int = 10_000) -> list[InputEvent]:
        """The frames, each so much later than the one before."""
        return [
            (5, at * step_us, *event)
            for at, (frame, _) in enumerate(self.frames)
            for event in [*frame, (SYN, REPORT, 0)]
        ]


KVM = Device(
    "QEMU USB Tablet",
    [LEFT, LEFT + 1, LEFT + 2],
    False,
    {X: (0, 32767, 0), Y: (0, 32767, 0)},
    [
        ([(ABS, X, 0)], None),  # y is not known
        ([(ABS, Y, 32767)], (0, 1, 0, False)),
        ([(KEY, LEFT, 1)], (0, 1, 1, False)),
        ([(ABS, X, 32767), (ABS, Y, 0)], (1, 0, 1, False)),
        ([(4, 4, 9)], None),
        ([(KEY, LEFT, 0)], (1, 0, 0, False)),
    ],
)
TABLET = Device(
    "Some Pen",
    [PEN, TOUCH, STYLUS],
    False,
    {X: (0, 20000, 100), Y: (0, 10000, 100)},
    [
        ([(KEY, PEN, 1), (ABS, X, 5000), (ABS, Y, 10000)], (0.25, 1, 0, True)),
        ([(ABS, X, 10000)], (0.5, 1, 0, False)),
        ([(KEY, TOUCH, 1), (KEY, STYLUS, 1)], (0.5, 1, 3, False)),
        ([(ABS, Y, 0)], (0.5, 0, 3, False)),
        ([(KEY, STYLUS, 0), (KEY, TOUCH, 0)], (0.5, 0, 0, False)),
        ([(KEY, PEN, 0), (ABS, X, 0), (ABS, Y, 0)], None),
        ([(KEY, PEN, 1), (ABS, X, 20000)], (1, 0, 0, True)),
        ([(ABS, Y, 5000)], (1, 0.5, 0, False)),
        ([(KEY, PEN, 0)], None),
    ],
)
SCREEN = Device(
    "Some Touch Screen",
    [TOUCH],
    True,
    dict.fromkeys((X, Y, MT_X, MT_Y), (0, 1000, 5)) | {SLOT: (0, 9, 0), ID: (0, 65535, 0)},
    [
        (
            [(ABS, ID, 7), (ABS, MT_X, 0), (ABS, MT_Y, 500), (KEY, TOUCH, 1), (ABS, X, 0), (ABS, Y, 500)],
            (0, 0.5, 1, True),
        ),
        ([(ABS, MT_X, 100), (ABS, X, 100)], (0.1, 0.5, 1, False)),
        ([(ABS, SLOT, 1), (ABS, ID, 8), (ABS, MT_X, 900), (ABS, MT_Y, 900)], None),  # a second finger
        ([(ABS, SLOT, 0), (ABS, MT_X, 200), (ABS, X, 200)], (0.2, 0.5, 1, False)),
        ([(ABS, ID, -1), (ABS, X, 900), (ABS, Y, 900)], (0.2, 0.5, 0, False)),
        ([(ABS, SLOT, 1), (ABS, MT_X, 800), (ABS, X, 800)], (0.8, 0.9, 1, True)),
        ([(ABS, MT_X, 700), (ABS, X, 700)], (0.7, 0.9, 1, False)),
        ([(ABS, ID, -1), (KEY, TOUCH, 0)], (0.7, 0.9, 0, False)),
    ],
)
DEVICES = (KVM, TABLET, SCREEN)


def evemu(device: Device) -> str:
    """A recording as evemu writes it."""
    lines = ["# EVEMU 1.3", f"N: {device.name}", "I: 0003 1234 0001 0111"]
    lines.append("P: " + (2 * device.direct).to_bytes(8, "little").hex(" "))
    for kind, bitmap in device.node.bitmaps.items():
        data = bitmap.to_bytes(96, "little")
        lines += [f"B: {kind:02x} {data[at : at + 8].hex(' ')}" for at in range(0, 96, 8)]
    lines += [f"A: {code:02x} {low} {high} 0 0 {res}" for code, (low, high, res) in device.ranges.items()]
    lines += [f"E: {s}.{us:06d} {k:04x} {code:04x} {value}" for s, us, k, code, value in device.events()]
    return "\n".join(lines) + "\n"


def evtest(device: Device) -> str:
    """What evtest prints."""
    lines = ["Input driver version is 1.0.1", f'Input device name: "{device.name}"', "Supported events:"]
    lines += ["  Event type 0 (EV_SYN)", "  Event type 1 (EV_KEY)"]
    lines += [f"    Event code {key} (KEY)" for key in device.keys]
    lines.append("  Event type 3 (EV_ABS)")
    for code, (low, high, res) in device.ranges.items():
        lines += [f"    Event code {code} (AXIS)", "      Value      0", f"      Min    {low:5d}"]
        lines += [f"      Max    {high:5d}", *([f"      Resolution    {res:4d}"] if res else [])]
    lines += ["Properties:", *(["  Property type 1 (INPUT_PROP_DIRECT)"] if device.direct else [])]
    lines.append("Testing ... (interrupt to exit)")
    for s, us, kind, code, value in device.events():
        stamp = f"Event: time {s}.{us:06d}, "
        end = "-------------- SYN_REPORT ------------"
        lines.append(stamp + (f"type {kind} (T), code {code} (C), value {value}" if kind else end))
    return "\n".join(lines) + "\n"


def libinput(device: Device) -> str:
    """What libinput record writes."""
    lines = ["version: 1", "ndevices: 1", "libinput:", '  version: "1.25.0"', "devices:"]
    lines += ["- node: /dev/input/event5", "  evdev:", f'    name: "{device.name}"', "    codes:"]
    lines += [f"      1: {device.keys} # EV_KEY", f"      3: {list(device.ranges)}", "    absinfo:"]
    lines += [
        f"      {code}: [{low}, {high}, 0, 0, {res}]" for code, (low, high, res) in device.ranges.items()
    ]
    lines += [f"    properties: {[1] if device.direct else []}", "  hid: []", "  events:", "  - evdev:"]
    lines += [
        f"    - [{s:3d}, {us:6d}, {k:3d}, {code:3d}, {value:7d}]" for s, us, k, code, value in device.events()
    ]
    return "\n".join(lines) + "\n"


def getevent(device: Device) -> str:
    """What Android's ``getevent -tp`` prints."""
    lines = ["add device 1: /dev/input/event5", f'  name:     "{device.name}"', "  events:"]
    lines += [
        f"    ABS (0003): {code:04x}  : value 0, min {low}, max {high}, fuzz 0, flat 0, resolution {res}"
        for code, (low, high, res) in device.ranges.items()
    ]
    lines += [
        f"[{s:8d}.{us:06d}] /dev/input/event5: {k:04x} {code:04x} {value & 0xFFFFFFFF:08x}"
        for s, us, k, code, value in device.events()
    ]
    return "\n".join(lines) + "\n"
