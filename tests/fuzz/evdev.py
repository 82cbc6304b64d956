"""Any bytes as events of a kernel input node: frames that do not depend on how the bytes are cut."""

from __future__ import annotations

from pointpred.devices.evdev import EVENT, Clock, FrameDecoder
from pointpred.recordings.formats.evdev_contacts import EV_KEY, EV_REL, EV_SYN
from pointpred.recordings.formats.evdev_frames import SYN_DROPPED, SYN_REPORT


def check(data: bytes) -> str:
    """An input is a byte, the size of the pieces, and the bytes of the node."""
    size = 1 + data[0] if data else 1
    whole, cut = FrameDecoder(), FrameDecoder()
    frames = whole.feed(data[1:])
    pieces = [one for at in range(1, len(data), size) for one in cut.feed(data[at : at + size])]
    assert pieces == frames
    assert (whole.unreadable, whole.resynchronised) == (cut.unreadable, cut.resynchronised)
    clock, last = Clock(), float("-inf")
    for place, frame in enumerate(frames):
        t = clock.seconds(frame.stamp_us, now=100.0 + place / 100)
        assert t >= last
        last = t
    return "read" if frames else "nothing"


def seeds() -> list[bytes]:
    moved = [(EV_REL, 0, 3), (EV_REL, 1, -2), (EV_REL, 8, 1), (EV_REL, 11, 120), (EV_SYN, SYN_REPORT, 0)]
    pressed = [(EV_KEY, 0x110, 1), (EV_SYN, SYN_REPORT, 0), (EV_SYN, SYN_DROPPED, 0), (EV_SYN, SYN_REPORT, 0)]
    frames = [EVENT.pack(5, 250000 + place, *event) for place, event in enumerate(moved + pressed)]
    return [b"\x07" + b"".join(frames), b"\x17" + b"".join(frames[:5])]
