"""What ``pointpred live`` says of a session, of made-up mice."""

from __future__ import annotations

from pointpred import build
from pointpred.devices.source import MOST_WAITING, Report
from pointpred.live import terminal
from pointpred.live.session import LiveSession
from tests.devices.live_fakes import FakeMouse


def session_of(mouse: FakeMouse) -> LiveSession:
    session = LiveSession(mouse, None, build("hold"))
    session.advance(0.0)
    return session


def test_a_device_of_which_nothing_could_be_read_says_so_at_the_end() -> None:
    mouse = FakeMouse()
    mouse.unreadable = 41
    said = terminal.summary(session_of(mouse))
    assert said.startswith("0 reports: nothing that /dev/nowhere sent could be read; 0 lost, 41 unreadable")


def test_a_device_that_was_read_or_sent_nothing_is_not_blamed() -> None:
    read = FakeMouse([Report(0.0, 1, 0)])
    read.unreadable = 41
    assert terminal.summary(session_of(read)).startswith("1 report; 0 lost, 41 unreadable")
    assert terminal.summary(session_of(FakeMouse())).startswith("0 reports; 0 lost, 0 unreadable")


def test_losses_are_told_by_kind_in_every_view() -> None:
    mouse = FakeMouse(Report(0.0, 1, 0) for _ in range(MOST_WAITING + 7))
    mouse.unreadable, mouse.resynchronised = 3, 2
    session = session_of(mouse)
    told = "7 lost, 3 unreadable, 0 refused, 2 gaps in the kernel"
    state = session.state()
    assert terminal.losses(state) == told
    assert dict(terminal.state_rows(state))["losses"] == told
    assert f"; {told}; " in terminal.line(state, session.newest)
    assert f"; {told}; " in terminal.summary(session)


def test_what_was_refused_comes_with_its_reason() -> None:
    session = session_of(FakeMouse([Report(1.0, 1, 0), Report(0.5, 1, 0)]))
    said = terminal.losses(session.state())
    assert said.startswith("0 lost, 0 unreadable, 1 refused, 0 gaps in the kernel (")
    assert "0.5" in said
