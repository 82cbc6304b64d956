"""Absolute HID devices: positions, contacts and buttons of real descriptors, beside hid-tools where it is."""

from __future__ import annotations

import random

import pytest

from pointpred.devices.hid import PositionValues, parse_descriptor, place_of
from pointpred.devices.surface import ALWAYS, DEFAULT_PX, MISSED, Axis, ContactReports, Place, Surface
from pointpred.errors import RecordingError
from tests.devices.mice import BUTTONS, Mouse
from tests.devices.surfaces import KVM, PAD, PEN, REPORTS, TOUCH, TWO_FINGERS, kvm, pen, touch, two_fingers
from tests.fuzz.hid import check, joined

NAMES = {0x10030: "x", 0x10031: "y", 0xD0042: "tip", 0xD0032: "in range", 0xD0051: "contact"}


def places(device: Mouse, reports: list[bytes]) -> list[Place | None]:
    decoder = parse_descriptor(device.descriptor)
    contacts = ContactReports()
    found = []
    for report in reports:
        values = decoder.decode(report)
        assert values is not None
        found.append(place_of(contacts, values))
    return found


def test_an_absolute_mouse_is_always_there() -> None:
    decoder = parse_descriptor(KVM.descriptor)
    assert decoder.decode(kvm(0, 32767, 3, -1)) == PositionValues(
        0, ((ALWAYS, 0.0, 1.0, True, 0),), 3, 31, -1, 0
    )
    assert decoder.surface == Surface(Axis(0, 32767), Axis(0, 32767))
    told = places(KVM, [kvm(0, 0), kvm(32767, 0, 1), kvm(32767, 32767)])
    assert told == [(0, 0, 0, False), (1, 0, 1, False), (1, 1, 0, False)]


def test_a_pen_is_there_while_it_is_in_range() -> None:
    assert parse_descriptor(PEN.descriptor).surface == Surface(
        Axis(0, 32767, pytest.approx(20.72 * 25.4)), Axis(0, 32767, pytest.approx(11.665 * 25.4))
    )
    told = places(
        PEN,
        [
            pen(0, 0, near=False),
            pen(32767, 0),
            pen(32767, 0, tip=True),
            pen(0, 0, barrel=True),
            pen(0, 0, near=False),
            pen(0, 0, near=False),
            pen(0, 32767),
        ],
    )
    right, left = (1, 0, 0), (0, 0, 2)
    assert told[:5] == [None, (*right, True), (1, 0, 1, False), (*left, False), (0, 0, 0, False)]
    assert told[5:] == [None, (0, 1, 0, True)]  # without a button nothing is released


def test_a_finger_is_there_while_it_touches_and_others_are_passed_over() -> None:
    reports = [touch(0, 0, tip=False), touch(4095, 0, finger=2), touch(9, 9, finger=5), touch(0, 0, finger=2)]
    reports += [touch(9, 9, finger=5, tip=False), touch(0, 0, finger=2, tip=False), touch(0, 4095, finger=6)]
    assert places(TOUCH, reports) == [
        None,
        (1, 0, 1, True),
        None,
        (0, 0, 1, False),
        None,
        (0, 0, 0, False),
        (0, 1, 1, True),
    ]


def test_a_finger_whose_lifting_was_lost_is_given_up() -> None:
    told = places(TOUCH, [touch(0, 0, finger=2), *[touch(4095, 0, finger=5)] * (MISSED + 2)])
    assert told == [(0, 0, 1, True), *[None] * MISSED, (1, 0, 1, True), (1, 0, 1, False)]


def test_of_two_fingers_in_a_report_the_first_is_followed_wherever_it_stands() -> None:
    one, two = (1, 19967, 0, True), (2, 0, 11263, True)
    told = places(
        TWO_FINGERS,
        [
            two_fingers(one, two),
            two_fingers(two, one),
            two_fingers(two, (1, 0, 11263, False)),
            two_fingers(two),
            two_fingers(),
        ],
    )
    assert told[:3] == [(1, 0, 1, True), (1, 0, 1, False), (1, 0, 0, False)]
    assert told[3:] == [(0, 1, 1, True), (0, 1, 0, False)]
    assert parse_descriptor(TWO_FINGERS.descriptor).surface.size_mm is None  # type: ignore[union-attr]


def test_an_empty_slot_lifts_no_finger() -> None:
    first, third, empty = (0, 19967, 0, True), (3, 7, 7, True), (0, 0, 0, False)
    told = places(TWO_FINGERS, [two_fingers(first, third), two_fingers(third, empty), two_fingers(first)])
    assert told == [(1, 0, 1, True), None, (1, 0, 1, False)]


def test_a_mouse_beside_a_pen_has_counts_in_its_own_reports() -> None:
    both = parse_descriptor(
        BUTTONS.descriptor.replace(b"\x09\x01\xa1\x00", b"\x85\x02\x09\x01\xa1\x00") + PEN.descriptor
    )
    assert both.decode(bytes([2, 1, 5, 0xFF])) == (5, -1, 1, 7, 0, 0)
    values = both.decode(pen(32767, 0))
    assert isinstance(values, PositionValues)
    assert values.contacts == ((0, 1.0, 0.0, True, 0),)


def test_buttons_on_reports_of_their_own_are_those_of_the_place() -> None:
    split = Mouse(
        "split",
        bytes.fromhex(
            "05010902a1018501050919012903150025017501950381029505 8103"
            "8502050109300931150026ff0f751095028102c0"
        ),
    )
    told = places(split, [b"\x01\x01", b"\x02\xff\x0f\x00\x00", b"\x01\x04", b"\x02\x00\x00\xff\x0f"])
    assert told == [None, (1, 0, 1, False), (1, 0, 4, False), (0, 1, 4, False)]


def test_values_beyond_a_bounded_range_say_that_nothing_is_there() -> None:
    bounded = PEN.descriptor.replace(bytes.fromhex("26ff7f8102"), bytes.fromhex("26ff7f8142"))
    assert places(PEN, [pen(40000, 0)])[0] is not None
    assert places(Mouse("bounded", bounded), [pen(40000, 0)]) == [None]


def test_a_touch_pad_and_a_range_without_length_are_refused() -> None:
    flat = KVM.descriptor.replace(bytes.fromhex("26ff7f35"), bytes.fromhex("26000035"))
    for descriptor, why in ((PAD.descriptor, "it is a touch pad"), (flat, "expected those of a mouse")):
        with pytest.raises(RecordingError, match=why) as refused:
            parse_descriptor(descriptor)
        assert refused.value.code == "not_a_mouse"


@pytest.mark.parametrize("exponent", ["55 0d", "55 fd"])
def test_a_power_of_ten_has_four_bits_or_a_byte(exponent: str) -> None:
    descriptor = PEN.descriptor.replace(bytes.fromhex("550d"), bytes.fromhex(exponent))
    assert parse_descriptor(descriptor).surface.x.mm == pytest.approx(526.288)  # type: ignore[union-attr]


def test_a_surface_has_the_px_of_its_size_or_of_a_screen() -> None:
    known, unknown = Surface(Axis(0, 9, 254.0), Axis(0, 9, 127.0)), Surface(Axis(0, 9, 1e6), Axis(0, 9, 1e6))
    assert known.scale(100.0, (800.0, 600.0))[:2] == (1000.0, 500.0)
    assert unknown.scale(100.0, (800.0, 600.0))[:2] == (800.0, 600.0)
    assert unknown.scale(100.0)[:2] == DEFAULT_PX
    assert "unknown size" in unknown.scale(100.0).words


@pytest.mark.parametrize(("device", "report"), REPORTS, ids=[device.name for device, _ in REPORTS])
def test_positions_are_those_of_a_second_reading(device: Mouse, report: bytes) -> None:
    generator = random.Random(5)
    for _ in range(50):
        assert check(joined(device.descriptor, report)) == "read"
        report = report[:1] + generator.randbytes(len(report) - 1)


@pytest.mark.parametrize(("device", "report"), REPORTS, ids=[device.name for device, _ in REPORTS])
def test_positions_are_those_of_hid_tools(device: Mouse, report: bytes) -> None:
    pytest.importorskip("hidtools")
    from hidtools.hid import ReportDescriptor

    decoder, theirs = (
        parse_descriptor(device.descriptor),
        ReportDescriptor.from_bytes(list(device.descriptor)),
    )
    generator = random.Random(7)
    for _ in range(50):
        found: dict[str, list[float]] = {name: [] for name in NAMES.values()}
        for field in theirs.get(report[0], len(report)):
            if (name := NAMES.get(field.usage)) is not None:
                least, most = (field.logical_min, field.logical_max) if name in "xy" else (0, 1)
                found[name].append((field.get_values(list(report))[0] - least) / (most - least))
        ours = decoder.decode(report)
        assert isinstance(ours, PositionValues)
        assert [one.x for one in ours.contacts] == pytest.approx(found["x"], abs=1e-12)
        assert [one.y for one in ours.contacts] == pytest.approx(found["y"], abs=1e-12)
        assert not found["tip"] or [one.tip for one in ours.contacts] == found["tip"]
        assert not found["contact"] or [one.number for one in ours.contacts] == found["contact"]
        report = (report[:1] if decoder.numbered else b"") + generator.randbytes(
            len(report) - decoder.numbered
        )
