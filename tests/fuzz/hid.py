"""Any bytes as a report descriptor and a report: refused, or read as a second reading does.

An input is two bytes with the length of the descriptor, the descriptor, and a report.
"""

from __future__ import annotations

from pointpred.devices.hid import PositionValues, parse_descriptor
from pointpred.devices.surface import ALWAYS
from pointpred.errors import RecordingError
from tests.devices.mice import ENCODERS
from tests.devices.surfaces import REPORTS
from tests.fuzz import naive

MOST_EXPANDED = 200_000
"""Fields the slow second reading is asked to go through."""


def joined(descriptor: bytes, report: bytes) -> bytes:
    """An input of the fuzzer."""
    return len(descriptor).to_bytes(2, "little") + descriptor + report


def check(data: bytes) -> str:
    """Read one input; says what came of it, raises AssertionError or whatever else breaks.

    The bytes are refused with RecordingError, or read as the second, naive reading does.
    """
    length = int.from_bytes(data[:2], "little")
    descriptor, report = data[2 : 2 + length], data[2 + length :]
    try:
        ours = parse_descriptor(descriptor)
    except RecordingError:
        return "refused"
    if _expanded(descriptor) > MOST_EXPANDED:
        return "too large to be read twice"
    theirs, contacts = naive.places(descriptor)
    assert theirs.keys() == ours.layouts.keys()
    for number, places in theirs.items():
        layout = ours.layouts[number]
        assert 0 < layout.size <= ours.longest
        assert all(first + bits <= 8 * layout.size for first, bits, _ in places.values())
    number = report[0] if ours.numbered and report else 0
    try:
        decoded = ours.decode(report)
    except RecordingError:
        assert len(report) < ours.layouts[number].size
        return "short"
    if decoded is None:
        assert number not in theirs
        return "another report"
    expected = {name: naive.read(place, report) for name, place in theirs[number].items()}
    pressed = sum(bit * expected.get(name, 0) for name, bit in naive.W3C.items())
    mask = sum(bit for name, bit in naive.W3C.items() if name in expected)
    x, y, wheel, pan = (expected.get(name, 0) for name in ("x", "y", "wheel", "pan"))
    if number in contacts:
        check_contacts(decoded, contacts[number], report, pressed, mask)
        return "read"
    assert decoded == (x, y, pressed, mask, wheel, pan)
    return "read"


def check_contacts(
    decoded: object, contacts: list[naive.Contact], report: bytes, pressed: int, mask: int
) -> None:
    """Absolute positions, and what lies beside them, as the second reading finds them."""
    assert isinstance(decoded, PositionValues)
    assert len(decoded.contacts) == len(contacts)
    for ours, theirs in zip(decoded.contacts, contacts, strict=True):
        values = {name: naive.read((at[0], at[1], bool(at[2])), report) for name, at in theirs.items()}
        for name, share in (("x", ours.x), ("y", ours.y)):
            least, most, bounded = theirs[name][3:]
            assert share == (values[name] - least) / (most - least)
            assert not (ours.there and bounded and not least <= values[name] <= most)
        assert ours.tip == values.get("tip", 0)
        known = {"tip", "in range"} & values.keys()
        assert ours.number == (values.get("contact", 0) if known else ALWAYS)
        if "any barrel" in values and not mask & 2:
            pressed |= 2 * values["any barrel"]
    assert decoded.buttons == pressed


def _expanded(descriptor: bytes) -> int:
    """A bound on the usages and fields of a naive reading."""
    counts = usages = total = 0
    for prefix, raw in naive.items(descriptor):
        value = int.from_bytes(raw, "little") & 0xFFFF
        counts = value if prefix == 0x94 else counts
        usages += value + 1 if prefix == 0x28 else 1
        total += counts + usages if prefix == 0x80 else 0
    return total + usages


def seeds() -> list[bytes]:
    """The descriptors of the tests, each with reports that set every bit."""
    return [
        joined(mouse.descriptor, report)
        for mouse, encode, most in ENCODERS
        for report in encode(most, -most, 7, 1, 1)
    ] + [joined(device.descriptor, report) for device, report in REPORTS]
