"""Report descriptors: the boot mouse of HID 1.11 appendix E.10, real mice, and broken bytes."""

import pytest

from pointpred.errors import RecordingError
from pointpred.sources.report_descriptor import Field, parse_descriptor

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
    field = Field(12, 12, signed=True)
    for value in (-2048, -1, 0, 1, 2047):
        report = (value & 0xFFF) << 12 | 0xABC
        assert field.value(report) == value
    assert Field(4, 4, signed=False).value(0xF0) == 15


@pytest.mark.parametrize(
    ("report", "expected"),
    [([0, 0, 0], (0, 0, 0, 7)), ([5, 127, 129], (127, -127, 5, 7)), ([2, 255, 1], (-1, 1, 2, 7))],
)
def test_the_boot_mouse(report: list[int], expected: tuple[int, int, int, int]) -> None:
    assert parse_descriptor(bytes.fromhex(BOOT)).decode(bytes(report)) == expected


def test_a_wheel_after_x_and_y_does_not_disturb() -> None:
    mouse = parse_descriptor(bytes.fromhex(A4TECH))
    assert mouse.decode(bytes([0x51, 10, 0xF6, 1])) == (10, -10, 17, 31)  # buttons 1, 5; 7 has no W3C bit
    with pytest.raises(RecordingError, match="report of 3 bytes, expected 4"):
        mouse.decode(bytes(3))


def test_a_field_without_negative_minimum_is_not_signed() -> None:
    forward = "05 01 09 02 a1 01 09 30 15 00 26 ff 00 75 08 95 01 81 06 09 31 15 80 25 7f 81 06 c0"
    assert parse_descriptor(bytes.fromhex(forward)).decode(bytes([0xFF, 0xFF])) == (255, -1, 0, 0)


def test_buttons_on_one_report_and_motion_on_another() -> None:
    split = (
        "05 01 09 02 a1 01 85 01 05 09 19 01 29 08 15 00 25 01 75 01 95 08 81 02"
        "85 02 05 01 09 30 09 31 16 00 80 26 ff 7f 75 10 95 02 81 06 c0"
    )
    mouse = parse_descriptor(bytes.fromhex(split))
    assert mouse.numbered
    assert mouse.decode(bytes([1, 3])) == (0, 0, 3, 31)
    assert mouse.decode(bytes([2, 0x2C, 0x01, 0xD4, 0xFE])) == (300, -300, 0, 0)
    assert mouse.decode(bytes([7, 0, 0, 0, 0])) is None


def test_push_pop_extended_usages_and_long_items() -> None:
    twisted = (
        "fe 02 f0 aa bb"  # a long item of two bytes
        "05 01 09 02 a1 01 15 81 25 7f 75 08 95 01 a4"
        "05 09 15 00 25 01 75 01 95 08 19 01 29 08 81 02 b4"  # buttons between push and pop
        "0b 30 00 01 00 81 06 0b 31 00 01 00 81 06 c0"  # x and y as four-byte usages
    )
    assert parse_descriptor(bytes.fromhex(twisted)).decode(bytes([4, 0xFE, 3])) == (-2, 3, 4, 31)


def test_the_last_usage_repeats_when_there_are_fewer_than_fields() -> None:
    lonely = "05 01 09 02 a1 01 09 30 15 81 25 7f 75 08 95 02 81 06 09 31 95 01 81 06 c0"
    assert parse_descriptor(bytes.fromhex(lonely)).decode(bytes([1, 2, 3]))[:2] == (1, 3)  # type: ignore[index]


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ("05 01 09 02 a1 01 09 30 16 81", "ends inside the item at byte 8"),
        ("05 01 09 06 a1 01 c0", "without relative x or y"),
        ("05 01 09 30 15 00 26 ff 7f 75 10 95 01 81 02", "without relative x or y"),  # a tablet: absolute
        ("b4", "pops more than it pushes"),
        ("27 ff ff ff ff 77 ff ff ff 7f 97 ff ff ff 7f 81 06", "fields of"),
        ("", "without relative x or y"),
    ],
)
def test_broken_descriptors(data: str, message: str) -> None:
    with pytest.raises(RecordingError, match=message):
        parse_descriptor(bytes.fromhex(data))
