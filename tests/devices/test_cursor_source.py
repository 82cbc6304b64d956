"""The screen's cursor as a source: with stand-ins for Windows and macOS, for real under Xvfb."""

from __future__ import annotations

import ctypes
import sys
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

import pointpred.cli.app  # noqa: F401 - its libraries look at the system when they load
from pointpred.devices import selection
from pointpred.devices.cursor_paths import PositionPath
from pointpred.devices.screen_cursor import (
    SCALED,
    CursorSource,
    MacCursor,
    ScreenCursor,
    WindowsCursor,
    cursor_info,
    system_cursor,
)
from pointpred.errors import ParameterError, SourceError
from pointpred.live.outputs import NEEDS_COUNTS, NEEDS_CPI, CurveLearner, curve_learner
from tests.devices.screens import Screen


class Still:
    """A cursor that a test puts at places, one a look; it ends with an error."""

    words = "px of a test"
    size = (800, 600)

    def __init__(self, *places: tuple[float, float, int]) -> None:
        self._places = iter(places)
        self._pressed = 0
        self.closed = False

    def position(self) -> tuple[float, float]:
        try:
            x, y, self._pressed = next(self._places)
        except StopIteration:
            raise SourceError("the screen is gone") from None
        return x, y

    def buttons(self) -> int:
        return self._pressed

    def close(self) -> None:
        self.closed = True


class Time:
    """A clock that only sleeping moves on."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds


def test_looks_are_even_and_say_only_what_is_new() -> None:
    cursor, clock = Still((5, 5, 0), (5, 5, 0), (7, 4, 0), (7, 4, 0), (7, 4, 1)), Time()
    with CursorSource(lambda: cursor, rate_hz=125.0, clock=clock, sleep=clock.sleep) as source:
        source._thread.join()  # type: ignore[union-attr]
        events = PositionPath(source.words).events(source.take(0.0))
        assert [(round(e.t, 9), e.x, e.y, e.dx, e.dy, e.buttons) for e in events] == [
            (0.016, 7.0, 4.0, None, None, 0),
            (0.032, 7.0, 4.0, None, None, 1),
        ]
        with pytest.raises(SourceError, match="the screen is gone"):
            source.take(0.0)
        assert (cursor.closed, source.lost, source.plugged) == (True, 0, True)


def test_a_cursor_that_cannot_be_read_at_first_is_let_go() -> None:
    cursor = Still()
    with pytest.raises(SourceError), CursorSource(lambda: cursor):
        raise AssertionError("it opened")
    assert cursor.closed


@pytest.mark.parametrize("rate_hz", [0.0, 1001.0, float("nan")])
def test_a_rate_out_of_bounds_is_refused(rate_hz: float) -> None:
    with pytest.raises(ParameterError, match="rate_hz"):
        CursorSource(Still, rate_hz=rate_hz)


class User32:
    """What of user32.dll is used; ``place`` is ``None`` on the lock screen."""

    def __init__(self, *, swapped: bool = False, aware: int = 2) -> None:
        self.place: tuple[int, int] | None = (-100, 40)
        self.pressed: set[int] = set()
        self.contexts: list[int] = []
        self.GetThreadDpiAwarenessContext = self._function(lambda: 18)
        self.GetAwarenessFromDpiAwarenessContext = self._function(lambda context: aware)
        self.SetProcessDpiAwarenessContext = self._function(lambda context: self.contexts.append(context))
        self._metrics = {0: 2560, 1: 1440, 23: int(swapped)}

    @staticmethod
    def _function(law: Any) -> Any:
        return lambda *given: law(*given)

    def GetSystemMetrics(self, number: int) -> int:  # noqa: N802
        return self._metrics[number]

    def GetAsyncKeyState(self, key: int) -> int:  # noqa: N802
        return -32768 if key in self.pressed else 1  # pressed since the last question is not pressed now

    def GetCursorPos(self, point: Any) -> int:  # noqa: N802
        if self.place is None:
            return 0
        point._obj.x, point._obj.y = self.place
        return 1


def test_windows_counts_px_of_the_screen_from_its_top() -> None:
    user32 = User32()
    cursor = WindowsCursor(user32)
    assert user32.contexts == [-4]
    assert cursor.size == (2560, 1440)
    assert cursor.position() == (-100.0, 40.0)
    user32.place = (3, 900)
    assert cursor.position() == (3.0, 900.0)
    assert cursor.buttons() == 0
    user32.pressed = {0x01, 0x04, 0x06}
    assert cursor.buttons() == 1 | 4 | 16
    user32.place = None
    assert (cursor.position(), cursor.refused) == ((3.0, 900.0), 1)
    with pytest.raises(SourceError, match="browser"):
        WindowsCursor(user32)


def test_windows_says_where_it_scales_and_swapped_buttons_are_the_person_s() -> None:
    assert WindowsCursor(User32(aware=1)).words == SCALED
    old = User32(swapped=True)
    del old.SetProcessDpiAwarenessContext
    cursor = WindowsCursor(old)
    assert cursor.words == SCALED
    old.pressed = {0x02}
    assert cursor.buttons() == 1


class Quartz(ModuleType):
    """What of pyobjc's Quartz is used."""

    kCGEventSourceStateCombinedSessionState = 0  # noqa: N815
    place: tuple[float, float] | None = (12.5, 700.25)
    pressed: tuple[int, ...] = ()

    def CGMainDisplayID(self) -> int:  # noqa: N802
        return 7

    def CGDisplayBounds(self, display: int) -> Any:  # noqa: N802
        assert display == 7
        return SimpleNamespace(size=SimpleNamespace(width=1440.0, height=900.0))

    def CGEventCreate(self, source: None) -> Any:  # noqa: N802
        return self.place

    def CGEventGetLocation(self, event: Any) -> Any:  # noqa: N802
        return SimpleNamespace(x=event[0], y=event[1])

    def CGEventSourceButtonState(self, state: int, number: int) -> bool:  # noqa: N802
        assert state == self.kCGEventSourceStateCombinedSessionState
        return number in self.pressed


def test_macos_counts_points_from_the_top() -> None:
    quartz = Quartz("Quartz")
    cursor = MacCursor(quartz)
    assert (cursor.position(), cursor.size, cursor.buttons()) == ((12.5, 700.25), (1440, 900), 0)
    assert "points" in cursor.words
    quartz.pressed = (1, 2)
    assert cursor.buttons() == 2 | 4
    quartz.place = None
    with pytest.raises(SourceError, match="Accessibility"):
        cursor.position()


@pytest.fixture
def windows(monkeypatch: pytest.MonkeyPatch) -> User32:
    user32 = User32()
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(ctypes, "windll", SimpleNamespace(user32=user32), raising=False)
    return user32


def test_without_a_device_windows_and_macos_follow_the_cursor(
    windows: User32, monkeypatch: pytest.MonkeyPatch, command: Any
) -> None:
    assert isinstance(system_cursor(), WindowsCursor)
    left = command("live", "--seconds", "0.05", "--predictor", "hold", "--cpi", "800")
    assert left.code == 0, left.err
    assert "device: the screen's cursor (cursor), no counts" in left.err
    assert "cursor of Windows in px" in left.err
    assert "--cpi is not used" in left.err
    listed = command("devices", "list")
    assert "untested on this platform" in " ".join(listed.out.split())
    monkeypatch.setattr(sys, "platform", "darwin")
    monkeypatch.setitem(sys.modules, "Quartz", Quartz("Quartz"))
    assert isinstance(system_cursor(), MacCursor)
    assert isinstance(selection.choose(None), CursorSource)
    assert cursor_info().openable


@pytest.mark.parametrize("option", [("--cursor", "motor"), ("--transfer", "constant:4")])
def test_what_needs_counts_is_refused_for_a_cursor(windows: User32, command: Any, option: Any) -> None:
    left = command("live", *option)
    assert left.code == 2
    assert f"{option[0]} needs a mouse's counts" in left.err


def test_macos_without_quartz_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "darwin")
    monkeypatch.setitem(sys.modules, "Quartz", None)
    with pytest.raises(SourceError, match=r"needs pyobjc .*-m pip install .*\[live\]"):
        system_cursor()
    assert not cursor_info().openable


def test_under_x11_it_follows_what_xdotool_does(screen: Screen) -> None:
    screen.place(3, 1000)
    with CursorSource(lambda: ScreenCursor(screen.name)) as source:
        assert source.take(0.0) == []
        screen.place(700, 200)
        (event,) = PositionPath(source.words).events(source.take(60.0))
        assert (event.x, event.y, event.dx, event.buttons) == (700.0, 200.0, None, 0)
        screen._say("mousedown 3")
        (event,) = PositionPath(source.words).events(source.take(60.0))
        assert (event.x, event.y, event.buttons) == (700.0, 200.0, 2)
        screen._say("mouseup 3")


def test_a_transfer_function_is_learned_where_positions_come_with_counts() -> None:
    for counts, cpi, learned in ((False, 800.0, NEEDS_COUNTS), (True, None, NEEDS_CPI)):
        assert curve_learner(PositionPath("px", counts=counts), cpi, 96.0) == learned
    assert isinstance(curve_learner(PositionPath("px", counts=True), 800.0, 96.0), CurveLearner)
