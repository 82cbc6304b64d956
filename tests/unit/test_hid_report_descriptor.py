"""Report descriptors: the boot mouse of HID 1.11 appendix E.10, real mice, and broken bytes."""

import pytest

from pointpred.devices.hid import ReportField, parse_descriptor
from pointpred.errors import RecordingError

BOOT = (
    "05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02 95 01 75 05 81 01"
    "05 01 09 30 09 31 15 81 25 7f 75 08 95 02 81 06 c0 c0"
)
"""The boot mouse, HID 1.11 appendix E.10."""
A4TECH = (
    "05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 07 15 00 25 01 75 01 95 07 81 02 75 01 95 01 81 01"
    "05 01 09 30 09 31 09 38 15 81 25 7f 75 08 95 03 81 06 c0 c0"
)
"""A4Tech PS/2+USB Mouse (3 09da 0006): seven buttons, x, y and wheel of 8 bits."""


def test_a_field_is_sign_extended_over_byte_borders() -> None:
    field = ReportField(12, 12, signed=True)
    for value in (-2048, -1, 0, 1, 2047):
        report = (value & 0xFFF) << 12 | 0xABC
        assert field.value(report) == value
    assert ReportField(4, 4, signed=False).value(0xF0) == 15


@pytest.mark.parametrize(
    ("report", "expected"),
    [([0, 0, 0], (0, 0, 0)), ([5, 127, 129], (127, -127, 5)), ([2, 255, 1], (-1, 1, 2))],
)
def test_the_boot_mouse(report: list[int], expected: tuple[int, int, int]) -> None:
    assert parse_descriptor(bytes.fromhex(BOOT)).decode(bytes(report)) == (*expected, 7, 0, 0)


def test_a_wheel_after_x_and_y() -> None:
    mouse = parse_descriptor(bytes.fromhex(A4TECH))
    assert mouse.decode(bytes([0x51, 10, 0xF6, 1])) == (
        10,
        -10,
        17,
        31,
        1,
        0,
    )  # buttons 1, 5; 7 has no W3C bit
    with pytest.raises(RecordingError, match="3 bytes, expected 4") as refused:
        mouse.decode(bytes(3))
    assert (refused.value.code, refused.value.value) == ("short_report", 3)


def test_a_field_without_negative_minimum_is_not_signed() -> None:
    forward = "05 01 09 02 a1 01 09 30 15 00 26 ff 00 75 08 95 01 81 06 09 31 15 80 25 7f 81 06 c0"
    assert parse_descriptor(bytes.fromhex(forward)).decode(bytes([0xFF, 0xFF])) == (255, -1, 0, 0, 0, 0)


def test_buttons_on_one_report_and_motion_on_another() -> None:
    split = (
        "05 01 09 02 a1 01 85 01 05 09 19 01 29 08 15 00 25 01 75 01 95 08 81 02"
        "85 02 05 01 09 30 09 31 16 00 80 26 ff 7f 75 10 95 02 81 06 c0"
    )
    mouse = parse_descriptor(bytes.fromhex(split))
    assert mouse.numbered
    assert mouse.decode(bytes([1, 3])) == (0, 0, 3, 31, 0, 0)
    assert mouse.decode(bytes([2, 0x2C, 0x01, 0xD4, 0xFE])) == (300, -300, 0, 0, 0, 0)
    assert mouse.decode(bytes([7, 0, 0, 0, 0])) is None


def test_push_pop_extended_usages_and_long_items() -> None:
    twisted = (
        "fe 02 f0 aa bb"  # a long item of two bytes
        "05 01 09 02 a1 01 15 81 25 7f 75 08 95 01 a4"
        "05 09 15 00 25 01 75 01 95 08 19 01 29 08 81 02 b4"  # buttons between push and pop
        "0b 30 00 01 00 81 06 0b 31 00 01 00 81 06 c0"  # x and y as four-byte usages
    )
    assert parse_descriptor(bytes.fromhex(twisted)).decode(bytes([4, 0xFE, 3])) == (-2, 3, 4, 31, 0, 0)


def test_the_last_usage_repeats_when_there_are_fewer_than_fields() -> None:
    lonely = "05 01 09 02 a1 01 09 30 15 81 25 7f 75 08 95 02 81 06 09 31 95 01 81 06 c0"
    assert parse_descriptor(bytes.fromhex(lonely)).decode(bytes([1, 2, 3]))[:2] == (1, 3)  # type: ignore[index]


def test_a_page_declared_after_its_usages_holds_for_them() -> None:
    """As the Linux kernel reads it (HID 1.11, 6.2.2.8): what counts is the page at the main item."""
    late = "05 09 09 30 09 31 05 01 15 81 25 7f 75 08 95 02 81 06"
    assert parse_descriptor(bytes.fromhex(late)).decode(bytes([1, 0xFE])) == (1, -2, 0, 0, 0, 0)
    own = "05 09 0b 30 00 01 00 09 31 05 01 15 81 25 7f 75 08 95 02 81 06"
    assert parse_descriptor(bytes.fromhex(own)).decode(bytes([1, 0xFE])) == (1, -2, 0, 0, 0, 0)


def test_a_late_page_leaves_usages_of_other_pages_alone() -> None:
    mixed = "05 01 09 30 06 00 ff 09 31 05 0c 15 81 25 7f 75 08 95 02 81 06"
    assert parse_descriptor(bytes.fromhex(mixed)).decode(bytes([7, 8])) == (7, 0, 0, 0, 0, 0)


def test_of_alternative_usages_the_first_counts() -> None:
    delimited = "05 01 a9 01 09 30 a9 00 a9 01 09 31 a9 00 15 81 25 7f 75 08 95 02 81 06 95 01 09 31 81 06"
    assert parse_descriptor(bytes.fromhex(delimited)).decode(bytes([4, 5, 6])) == (4, 6, 0, 0, 0, 0)


def test_a_usage_stands_after_every_usage_of_the_range_before_it() -> None:
    ranged = "05 01 19 32 29 34 09 30 15 81 25 7f 75 08 95 04 81 06"  # z, rx, ry, then x
    assert parse_descriptor(bytes.fromhex(ranged)).decode(bytes([1, 2, 3, 4])) == (4, 0, 0, 0, 0, 0)


def test_constant_fields_say_nothing() -> None:
    constant = "05 01 15 81 25 7f 75 08 95 01 09 30 81 07 09 30 81 06"
    assert parse_descriptor(bytes.fromhex(constant)).decode(bytes([1, 2])) == (2, 0, 0, 0, 0, 0)


def test_buttons_with_a_gap_between_them() -> None:
    """Buttons 1 to 3, one constant bit, button 5: Microsoft's way (the ResolutionMultiplierMouse)."""
    gap = "05 09 19 01 29 03 15 00 25 01 75 01 95 03 81 02 95 01 81 01 09 05 81 02 95 03 81 01"
    mouse = parse_descriptor(bytes.fromhex(gap + "05 01 09 30 15 81 25 7f 75 08 95 01 81 06"))
    assert [mouse.decode(bytes([1 << bit, 0]))[2] for bit in range(6)] == [1, 2, 4, 0, 16, 0]  # type: ignore[index]


def test_unnumbered_fields_of_a_numbered_device_never_come() -> None:
    mixed = "05 01 09 30 15 81 25 7f 75 08 95 01 81 06 85 03 09 31 81 06"
    mouse = parse_descriptor(bytes.fromhex(mixed))
    assert mouse.decode(bytes([0, 7])) is None
    assert mouse.decode(bytes([3, 7])) == (0, 7, 0, 0, 0, 0)
    assert mouse.decode(b"") is None


def test_reserved_items_and_fields_of_no_size_are_passed_over() -> None:
    odd = "0d 01 05 01 09 30 15 81 25 7f 75 00 95 01 81 06 09 31 75 08 81 06"
    assert parse_descriptor(bytes.fromhex(odd)).decode(bytes([9])) == (0, 9, 0, 0, 0, 0)


@pytest.mark.parametrize(
    ("data", "at"),
    [
        ("05 01 09 02 a1 01 09 30 16 81", 8),  # ends inside an item
        ("05 01 b4", 2),  # pops more than it pushes
        ("77 ff ff ff 7f", 0),  # a field of too many bits
        ("05 01 96 01 30", 2),  # an item of too many fields
        ("76 00 01 96 00 30 81 01", 6),  # a report too long
        ("05 01 85 00", 2),  # report ID 0
        ("a1 01 c0 c0", 3),  # a collection ends that never began
        ("05 01 09 02 a1 01 a1 00 c0", 9),  # a collection never ends
        ("05 01 09 30 15 05 25 01 75 08 95 01 81 06", 12),  # from 5 to 1
        ("fe", 0),
        ("fe 03 f0 aa bb", 0),
        ("c0" * 4097, 4096),
    ],
)
def test_broken_descriptors(data: str, at: int) -> None:
    with pytest.raises(RecordingError, match=r"\d") as refused:
        parse_descriptor(bytes.fromhex(data))
    assert (refused.value.code, refused.value.value) == ("bad_descriptor", at)


@pytest.mark.parametrize("data", ["05 01 09 06 a1 01 c0", "05 01 09 30 15 00 26 ff 7f 75 10 95 01 81 02", ""])
def test_a_keyboard_a_tablet_and_no_bytes_are_no_mouse(data: str) -> None:
    with pytest.raises(RecordingError, match="without x and y of a pointer") as refused:
        parse_descriptor(bytes.fromhex(data))
    assert refused.value.code == "not_a_mouse"
