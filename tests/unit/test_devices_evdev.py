"""The decoder of input events against the importer of recordings, and the clock against one that is set."""

from __future__ import annotations

import errno
import fcntl
import struct
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.devices import evdev
from pointpred.devices.evdev import (
    EVENT,
    EVIOCSCLOCKID,
    Clock,
    EvdevFrame,
    EvdevSource,
    FrameDecoder,
    pressed,
)
from pointpred.errors import SourceError
from pointpred.recordings.formats.evdev_frames import Frames, frames

SYN, KEY, REL, MSC = 0, 1, 2, 4
LEFT, RIGHT = 0x110, 0x111

moves = st.tuples(st.just(REL), st.sampled_from([0, 1]), st.integers(-400, 400))
presses = st.tuples(st.just(KEY), st.sampled_from([LEFT, RIGHT, 0x1E]), st.integers(0, 2))
others = st.tuples(st.just(MSC), st.just(4), st.integers(0, 9))
frame = st.lists(moves | presses | others, max_size=4).map(lambda events: [*events, (SYN, 0, 0)])


def timed(events: list[tuple[int, int, int]]) -> bytes:
    """Events 250 us after each other, across the end of a second."""
    return b"".join(
        EVENT.pack(*divmod(999_000 + 250 * i, 1_000_000), *event) for i, event in enumerate(events)
    )


@given(st.lists(frame, min_size=1, max_size=12), st.lists(st.integers(1, 70), min_size=1))
def test_however_the_bytes_are_cut_the_frames_are_those_of_the_importer(
    made: list[list[tuple[int, int, int]]], cuts: list[int]
) -> None:
    events = [(REL, 0, 1), (SYN, 0, 0), *(event for each in made for event in each)]
    data, decoder, got = timed(events), FrameDecoder(), []
    turn = 0
    while data:
        cut = cuts[turn % len(cuts)]
        got += decoder.feed(data[:cut])
        data, turn = data[cut:], turn + 1
    stream = frames(Path("made"), [(999_000 + 250 * i, *event) for i, event in enumerate(events)])
    assert isinstance(stream, Frames)
    assert [(f.dx, f.dy, f.buttons) for f in got] == [tuple(row[3:6]) for row in stream.events.table.tolist()]
    first = got[0].stamp_us
    assert [round(t * 1e6) for t in stream.events.t] == [f.stamp_us - first for f in got]
    assert decoder.aside + len(got) == 1 + len(made)


def test_a_wheel_that_tells_fine_steps_is_not_counted_twice() -> None:
    decoder = FrameDecoder()
    coarse = [(REL, 8, 1), (REL, 6, -2), (SYN, 0, 0)]
    fine = [
        (REL, 11, 30),
        (SYN, 0, 0),
        (REL, 11, 90),
        (REL, 8, 1),
        (REL, 12, -120),
        (REL, 6, -1),
        (SYN, 0, 0),
    ]
    told = decoder.feed(timed([*coarse, *fine]))
    assert [(f.wheel, f.pan) for f in told] == [(1.0, -2.0), (0.25, 0.0), (0.75, -1.0)]


def test_what_the_kernel_dropped_is_void_and_the_buttons_are_asked_for() -> None:
    answers = [2, None]
    decoder = FrameDecoder(ask=lambda: answers.pop(0))
    hole = [(REL, 0, 9), (SYN, 3, 0), (REL, 0, 50), (KEY, LEFT, 1), (SYN, 0, 0)]
    told = decoder.feed(timed([(KEY, LEFT, 1), (SYN, 0, 0), *hole, (REL, 1, 4), (SYN, 0, 0), *hole]))
    assert [(f.dx, f.dy, f.buttons) for f in told] == [(0, 0, 1), (0, 0, 2), (0, 4, 2), (0, 0, 2)]
    assert decoder.resynchronised == 2


def test_records_that_are_no_events_void_their_frame_and_are_counted() -> None:
    decoder = FrameDecoder()
    wrong = EVENT.pack(0, 1_000_000, REL, 0, 5) + EVENT.pack(0, 0, 0x20, 0, 5)
    end = EVENT.pack(0, 1, SYN, 0, 0)
    assert decoder.feed(wrong + EVENT.pack(0, 0, REL, 0, 5) + end) == []
    assert decoder.unreadable == 2
    assert decoder.feed(EVENT.pack(0, 0, REL, 0, 5) + end) == [EvdevFrame(1, 5, 0, 0, 0.0, 0.0)]


@given(st.binary(max_size=400))
def test_no_bytes_break_the_decoder(data: bytes) -> None:
    for told in FrameDecoder().feed(data):
        assert 0 <= told.buttons < 32


def test_a_bitmap_of_keys_is_a_mask_of_buttons() -> None:
    keys = bytearray(96)
    for code in (LEFT, 0x112, 0x115, 0x1E):
        keys[code // 8] |= 1 << code % 8
    assert pressed(bytes(keys)) == 1 | 4 | 16
    assert pressed(b"") == 0


def test_requests_have_the_numbers_of_the_kernel_s_header() -> None:
    """EVIOCSCLOCKID is _IOW('E', 0xa0, int) in linux/input.h, EVIOCGKEY(n) _IOC(_IOC_READ, 'E', 0x18, n)."""
    write, read = 1, 2
    assert write << 30 | struct.calcsize("i") << 16 | ord("E") << 8 | 0xA0 == EVIOCSCLOCKID
    assert read << 30 | evdev.KEY_BYTES << 16 | ord("E") << 8 | 0x18 == evdev.EVIOCGKEY


def test_the_monotonic_clock_is_asked_for_and_its_stamps_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    monkeypatch.setattr(fcntl, "ioctl", lambda *words: asked.append(words) or 0)
    clock = Clock()
    clock.ask(5)
    assert asked == [(5, EVIOCSCLOCKID, struct.pack("i", 1))]
    assert "monotonic" in clock.words
    assert clock.seconds(12_000_250, now=500.0) == 12.00025


def test_a_refused_clock_says_so_and_survives_being_set(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*words: object) -> int:
        raise OSError(errno.ENOTTY, "no such request")

    monkeypatch.setattr(fcntl, "ioctl", refuse)
    clock = Clock()
    clock.ask(5)
    assert "real-time" in clock.words
    assert "monotonic" not in clock.words  # nobody may take these stamps for that clock's
    times = []
    for i in range(4000):
        now = 100.0 + 0.001 * i
        stamp = 1_700_000_000_000_000 + 1000 * i + (3_600_000_000 if 1000 <= i < 2000 else 0)
        times.append(clock.seconds(stamp, now + 0.0003))
    assert clock.steps == 2
    assert times == pytest.approx([100.0003 + 0.001 * i for i in range(4000)], abs=1e-6)


@pytest.mark.parametrize(("pause_s", "back_us"), [(10.0, 5_000_000), (0.001, 500_000)])
def test_a_clock_set_back_does_not_hold_the_time(pause_s: float, back_us: int) -> None:
    clock = Clock()
    for i in range(1000):
        now = 100.0 + 0.001 * i + (pause_s if i >= 500 else 0.0)
        stamp = 1_700_000_000_000_000 + round(1e6 * (now - 100.0)) - (back_us if i >= 500 else 0)
        assert clock.seconds(stamp, now) == pytest.approx(now, abs=1e-5)
    assert clock.steps == 1


def test_elsewhere_than_on_linux_the_browser_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    for platform in ("win32", "darwin"):
        monkeypatch.setattr(evdev.sys, "platform", platform)
        with (
            pytest.raises(
                SourceError, match=f"Linux only, this is {platform}; open the live page in a browser"
            ),
            EvdevSource("/dev/input/event0"),
        ):
            pass


def test_a_machine_without_nodes_has_an_empty_list(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(evdev, "NODES", tmp_path / "input")
    assert evdev.list_evdev() == []


def test_a_source_must_be_entered_first() -> None:
    with pytest.raises(SourceError, match="'with' statement"):
        EvdevSource("/dev/input/event0").take(0.0)
