"""Of several mice the one that moves first is followed; the others are closed, and named where they move."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pytest
from msgspec.structs import replace

from pointpred import build
from pointpred.devices.cursor_paths import MotorPath
from pointpred.devices.first_moving import SILENCE_S, Candidate, FirstMoving
from pointpred.devices.source import Report
from pointpred.errors import SourceError
from pointpred.live.follow import device_note
from pointpred.live.session import LiveSession
from tests.devices.live_fakes import FakeMouse, reach

STEP = Report(0.0, 1, 0)
CLICK = Report(0.0, 0, 0, 1)


class Mouse(FakeMouse):
    """A mouse with a place of its own, which may be opened again; it does not wait."""

    def __init__(self, path: str) -> None:
        super().__init__()
        self.path = path
        self.name = f"mouse of {path}"
        self.opened = 0

    def __enter__(self) -> Mouse:
        self.opened += 1
        self.closed = False
        return self

    def close(self) -> None:
        self.closed = True

    def take(self, timeout_s: float) -> list[Report]:
        return super().take(0.0)


def first_of(*mice: Mouse) -> FirstMoving:
    def make(mouse: Mouse) -> Callable[[], Mouse]:
        return lambda: mouse

    return FirstMoving(lambda: [Candidate(mouse.path, make(mouse)) for mouse in mice])


def settled(source: FirstMoving) -> None:
    """Wait until devices that are being closed are closed."""
    for thread in source._closing:
        thread.join()


def rest(source: FirstMoving) -> None:
    """Let so much time pass without a report that other devices are listened to."""
    assert source.take(SILENCE_S) == []


@contextmanager
def following_first() -> Iterator[tuple[FirstMoving, Mouse, Mouse]]:
    """A source over two mice that follows the first, and both."""
    first, other = Mouse("event4"), Mouse("event5")
    with first_of(first, other) as source:
        first.put([STEP])
        source.take(0.0)
        yield source, first, other


def test_one_count_of_motion_decides_and_the_others_are_closed() -> None:
    silent, moving = Mouse("event4"), Mouse("event5")
    with first_of(silent, moving) as source:
        assert (source.plugged, source.path) == (True, "event4, event5")
        moving.put([CLICK])
        assert source.take(0.0) == []
        moving.put([CLICK, STEP])
        assert source.take(0.0) == [STEP]
        settled(source)
        assert (source.path, source.name, source.clock) == ("event5", moving.name, moving.clock)
        assert (silent.closed, moving.closed) == (True, False)
        moving.put([CLICK])
        assert source.take(0.0) == [CLICK]
        assert source.note.startswith("following event5 (mouse of event5), the first of 2")
    assert moving.closed


def test_another_that_moves_later_is_named_once_and_not_followed() -> None:
    with following_first() as (source, first, other):
        rest(source)
        settled(source)
        assert (other.opened, other.closed) == (2, False)
        for _ in range(2):
            other.put([STEP])
            assert source.take(0.0) == []
        assert source.path == "event4"
        assert source.note.count("event5 (mouse of event5) moves too and is not followed") == 1
        first.put([STEP])
        assert source.take(0.0) == [STEP]
        settled(source)
        assert other.closed


def test_where_the_followed_one_is_unplugged_the_next_that_moves_is_followed() -> None:
    with following_first() as (source, first, other):
        first.plugged = False
        assert not source.plugged
        assert source.take(0.0) == []
        first.put([CLICK])
        assert source.take(0.0) == [CLICK]  # the last that it says
        other.put([STEP])
        assert source.take(0.0) == [STEP]
        settled(source)
        assert (source.path, source.plugged, first.closed, other.closed) == ("event5", True, True, False)


def test_the_followed_one_that_comes_back_is_followed_on() -> None:
    with following_first() as (source, first, other):
        first.plugged = False
        source.take(0.0)
        first.plugged = True
        first.put([STEP])
        assert source.take(0.0) == [STEP]
        settled(source)
        assert (source.path, other.closed) == ("event4", True)


def test_the_followed_one_that_comes_back_and_rests_gives_way() -> None:
    with following_first() as (source, first, other):
        first.plugged = False
        source.take(0.0)
        first.plugged = True
        assert source.take(0.0) == []
        other.put([STEP])
        assert source.take(0.0) == [STEP]
        assert source.path == "event5"


def test_the_only_one_is_read_at_once_and_gives_way_while_it_has_never_moved() -> None:
    only, late = Mouse("event4"), Mouse("event5")
    here = [only]
    source = FirstMoving(lambda: [Candidate(mouse.path, lambda mouse=mouse: mouse) for mouse in here])
    with source:
        only.put([CLICK])
        assert source.take(0.0) == [CLICK]
        here.append(late)  # plugged in later
        rest(source)
        late.put([STEP])
        assert source.take(0.0) == [STEP]
        assert source.path == "event5"


def test_small_and_shaky_movements_are_seen_and_teach_as_before() -> None:
    """Thirty counts each way, with a tremor of two counts."""
    touchpad, mouse = Mouse("event4"), Mouse("event5")
    for k in range(8):
        for i, report in enumerate(reach(float(k), (30.0 * (-1.0) ** k, 4.0), 0.4)):
            mouse.put(
                [replace(report, dy=report.dy + (2.0 if i % 40 == 0 else -2.0 if i % 40 == 20 else 0.0))]
            )
    pipeline = build("kinematic-adaptive", cpi=200.0)
    with first_of(touchpad, mouse) as source:
        session = LiveSession(source, MotorPath(cpi=200.0), pipeline)
        session.advance(0.0)
    assert (session.moved, source.path, session.refused) == (True, "event5", 0)
    pipeline.reset()
    assert pipeline.person


def test_losses_of_all_that_were_followed_count() -> None:
    with following_first() as (source, first, other):
        first.unreadable, first.plugged = 3, False
        other.put([STEP])
        source.take(0.0)
        other.unreadable = 4
        assert source.unreadable == 7


def test_one_that_cannot_be_opened_or_fails_leaves_the_others() -> None:
    class Closed(Mouse):
        def __enter__(self) -> Closed:
            raise SourceError("event3: permission denied")

    class Failing(Mouse):
        def take(self, timeout_s: float) -> list[Report]:
            raise SourceError("reading ended")

    good, failing = Mouse("event5"), Failing("event4")
    with first_of(Closed("event3"), failing, good) as source:
        good.put([STEP])
        assert source.take(0.0) == [STEP]
    with pytest.raises(SourceError, match="permission denied"), first_of(Closed("event3")):
        raise AssertionError("it opened")


def test_silence_is_told_with_who_is_listened_to_until_one_count_comes() -> None:
    one, two = Mouse("event4"), Mouse("event5")
    with first_of(one, two) as source:
        session = LiveSession(source, None, build("hold"))
        session.note = device_note(session)
        session.advance(0.0)
        assert session.state().note is None
        session.silent_s = SILENCE_S
        note = session.state().note
        assert note is not None
        for part in ("event4 (mouse of event4)", "event5 (mouse of event5)", "permission", "--device"):
            assert part in note
        two.put([STEP])
        session.advance(0.0)
        note = session.state().note
        assert note is not None
        assert note.startswith("following event5")


def test_a_single_device_that_is_silent_is_told_as_well() -> None:
    session = LiveSession(Mouse("event4"), None, build("hold"))
    session.note = device_note(session)
    session.advance(SILENCE_S)
    assert "event4" in (session.state().note or "")
    session.source.plugged = False  # type: ignore[misc]
    assert session.state().note is None
