"""Any bytes as events of a kernel input node: frames that do not depend on how the bytes are cut."""

from __future__ import annotations

from pointpred.devices.evdev import EVENT, Clock, FrameDecoder
from pointpred.recordings.formats.evdev_contacts import (
    EV_ABS,
    EV_KEY,
    EV_REL,
    EV_SYN,
    EvdevAbout,
    EvdevContacts,
)
from pointpred.recordings.formats.evdev_frames import SYN_DROPPED, SYN_REPORT


def check(data: bytes) -> str:
    """An input is a byte, the size of the pieces, and the bytes of the node, of a mouse or a touch screen."""
    size = 1 + data[0] if data else 1
    whole, cut = FrameDecoder(), FrameDecoder()
    places = FrameDecoder(contacts=EvdevContacts(EvdevAbout()))
    for told in places.feed(data[1:]):
        assert told.place is None or 0 <= told.place.buttons < 32
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
    touched = [(EV_ABS, 0x39, 5), (EV_ABS, 0x35, 7), (EV_ABS, 0x36, 8), (EV_KEY, 0x14A, 1), (EV_SYN, 0, 0)]
    lifted = [(EV_ABS, 0x2F, 1), (EV_ABS, 0x39, -1), (EV_SYN, 2, 0), (EV_SYN, 0, 0)]
    frames = [EVENT.pack(5, 250000 + place, *event) for place, event in enumerate(moved + pressed)]
    fingers = [EVENT.pack(5, 250000 + place, *event) for place, event in enumerate(touched + lifted)]
    return [b"\x07" + b"".join(frames), b"\x17" + b"".join(frames[:5]), b"\x17" + b"".join(fingers)]
