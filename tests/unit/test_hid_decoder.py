"""Descriptors made up by the hundred: what was written into a report is read out of it, or refused."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred.devices.hid import parse_descriptor
from tests.devices.mice import ENCODERS, SYZBOT, Encode, Mouse
from tests.devices.surfaces import REPORTS
from tests.fuzz.corpus import corpus
from tests.fuzz.hid import check, joined

USAGES = {"x": "05010930", "y": "05010931", "wheel": "05010938", "pan": "050c0a3802"}
NAMES = ("x", "y", "buttons", "mask", "wheel", "pan")

Part = tuple[str, int, int]
"""What, how many bits (or buttons, or bits of padding), and the value it is to say."""


def signed(bits: int) -> st.SearchStrategy[int]:
    return st.integers(-(1 << (bits - 1)), (1 << (bits - 1)) - 1)


axis = st.sampled_from(sorted(USAGES)).flatmap(
    lambda name: st.integers(2, 32).flatmap(
        lambda bits: st.tuples(st.just(name), st.just(bits), signed(bits))
    )
)
buttons = st.integers(1, 20).flatmap(
    lambda many: st.tuples(st.just("buttons"), st.just(many), st.integers(0, (1 << many) - 1))
)
padding = st.tuples(st.just("padding"), st.integers(1, 40), st.just(0))
other = st.tuples(st.just("other"), st.integers(1, 16), st.integers(0, 1))
feature = st.tuples(st.just("feature"), st.integers(1, 16), st.just(0))
parts = st.lists(st.one_of(axis, buttons, padding, other, feature), min_size=1, max_size=9)


def item(prefix: int, value: int) -> str:
    """A short item with as many bytes of data as its value needs."""
    for size, code in ((1, 1), (2, 2), (4, 3)):
        if -(1 << (8 * size - 1)) <= value < 1 << (8 * size - 1):
            return f"{prefix | code:02x}" + (value & ((1 << 8 * size) - 1)).to_bytes(size, "little").hex()
    raise AssertionError(value)


def described(part: Part) -> tuple[str, int]:
    """The items that describe a part of a report, and the bits it takes."""
    name, size, _ = part
    if name == "buttons":
        many = item(0x28, size)
        return f"05091901{many}15002501" + item(0x74, 1) + item(0x94, size) + "8102", size
    if name in USAGES:
        low, high = -(1 << (size - 1)), (1 << (size - 1)) - 1
        range_of = item(0x14, low) + item(0x24, high)
        return USAGES[name] + range_of + item(0x74, size) + item(0x94, 1) + "8106", size
    if name == "feature":  # lies in a report of its own, whatever its report ID
        return "0501094835014504" + item(0x74, size) + item(0x94, 1) + "b10235004500", 0
    flags = "8103" if name == "padding" else "8102"
    return ("06a0ff0901" if name == "other" else "") + item(0x74, size) + item(0x94, 1) + flags, size


@given(parts, st.none() | st.integers(1, 255))
def test_what_was_written_is_read(made: list[Part], number: int | None) -> None:
    if not {"x", "y"} & {name for name, _, _ in made}:
        made = [*made, ("x", 8, -5)]
    text, report, at = "05010902a101" + (f"85{number:02x}" if number else ""), number or 0, 8 if number else 0
    expected = dict.fromkeys(NAMES, 0)
    for part in made:
        name, size, value = part
        items, bits = described(part)
        text += items
        report |= (value & ((1 << bits) - 1)) << at if bits else 0
        if name == "buttons":
            for bit in range(min(size, 5)):
                w3c = (1, 2, 4, 8, 16)[bit]
                if not expected["mask"] & w3c:
                    expected["buttons"] |= w3c * (value >> bit & 1)
                    expected["mask"] |= w3c
        elif name in USAGES and name not in {earlier for earlier, _, _ in made[: made.index(part)]}:
            expected[name] = value
        at += bits
    size = (at + 7) // 8
    mouse = parse_descriptor(bytes.fromhex(text + "c0"))
    data = report.to_bytes(size, "little")
    assert mouse.decode(data) == tuple(expected[name] for name in NAMES)
    assert mouse.decode(data + b"\xff\xff") == tuple(expected[name] for name in NAMES)
    assert mouse.longest == size
    assert check(joined(bytes.fromhex(text + "c0"), data)) == "read", "the second reading agrees"


@given(st.binary(max_size=120), st.binary(max_size=12))
def test_any_bytes_are_refused_or_read(descriptor: bytes, report: bytes) -> None:
    check(joined(descriptor, report))


edits = st.lists(
    st.tuples(st.floats(0, 1, exclude_max=True), st.integers(0, 3), st.binary(max_size=4)), max_size=6
)


@settings(max_examples=300)
@given(
    st.sampled_from([mouse.descriptor for mouse, *_ in (*ENCODERS, *REPORTS)]), edits, st.binary(max_size=16)
)
def test_a_damaged_descriptor_is_refused_or_read(
    descriptor: bytes, changes: list[tuple[float, int, bytes]], report: bytes
) -> None:
    for place, drop, put in changes:
        at = int(place * len(descriptor))
        descriptor = descriptor[:at] + put + descriptor[at + drop :]
    check(joined(descriptor, report))


@pytest.mark.parametrize(("mouse", "encode", "most"), ENCODERS, ids=[m.name for m, _, _ in ENCODERS])
def test_real_descriptors_at_their_bounds(mouse: Mouse, encode: Encode, most: int) -> None:
    decoder = parse_descriptor(mouse.descriptor)
    for dx, dy in ((most, -most), (-most, most), (1, -1), (0, 0)):
        said = [decoder.decode(report) for report in encode(dx, dy, 0, 0, 0)]
        assert (sum(one[0] for one in said if one), sum(one[1] for one in said if one)) == (dx, dy)
        assert all(check(joined(mouse.descriptor, report)) == "read" for report in encode(dx, dy, 7, 1, 1))


def test_the_corpus_of_the_fuzzer_is_read_or_refused_as_ever() -> None:
    came = Counter(map(check, corpus("hid")))
    assert came.total() > 100
    assert {"refused", "read", "short", "another report"} <= came.keys()


def test_garbage_is_refused() -> None:
    assert check(joined(SYZBOT.descriptor, b"")) == "refused"
