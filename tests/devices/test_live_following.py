"""How ``pointpred live`` drives a session and ends it."""

from __future__ import annotations

import subprocess
import sys
import threading

import pytest

from pointpred import build
from pointpred.live.run import SessionThread, ViewThread
from pointpred.live.session import LiveSession
from tests.devices.live_fakes import FakeMouse


def following() -> SessionThread:
    return SessionThread(LiveSession(FakeMouse(), None, build("hold")))


@pytest.mark.parametrize("seconds", [float("inf"), 1e12])
def test_more_seconds_than_a_clock_counts_are_no_end(monkeypatch: pytest.MonkeyPatch, seconds: float) -> None:
    raised: list[BaseException | None] = []
    monkeypatch.setattr(threading, "excepthook", lambda failure: raised.append(failure.exc_value))
    driven = following()
    before = set(threading.enumerate())
    driven.start(seconds)
    for timer in [one for one in set(threading.enumerate()) - before if isinstance(one, threading.Timer)]:
        timer.join(60.0)
    assert (raised, driven.stopping.is_set()) == ([], False)
    driven.stop()


def test_it_ends_by_itself_after_the_seconds_given() -> None:
    driven = following()
    driven.start(0.01)
    assert driven.stopping.wait(60.0)
    driven.stop()


def test_nothing_waits_for_the_seconds_of_a_session_that_was_stopped() -> None:
    driven = following()
    before = set(threading.enumerate())
    driven.start(3600.0)
    (timer,) = [one for one in set(threading.enumerate()) - before if isinstance(one, threading.Timer)]
    driven.stop()
    timer.join(60.0)
    assert not timer.is_alive()


def test_what_breaks_the_session_ends_it_and_is_raised_when_it_is_stopped() -> None:
    def fail(pairs: object) -> None:
        raise ZeroDivisionError("a mistake of ours")

    failures: list[str] = []
    session = LiveSession(FakeMouse(), None, build("hold"), watchers=[fail])
    driven = SessionThread(session, failures.append)
    driven.start(None)
    assert driven.stopping.wait(60.0)
    with pytest.raises(ZeroDivisionError, match="a mistake of ours"):
        driven.stop()
    assert len(failures) == 1


@pytest.mark.parametrize("error", [OSError("no space left"), SystemExit(1)], ids=["full", "closed"])
def test_a_view_that_breaks_ends_the_session(error: BaseException) -> None:
    def show() -> None:
        raise error

    stopping = threading.Event()
    view = ViewThread(show, stopping)
    view.join()
    assert (view.error, stopping.is_set()) == (error, True)


HANDED_ELSEWHERE = """
import signal, threading
from pointpred.live.run import end_on_signal, wait

stopping, waiting = threading.Event(), threading.Event()
other = threading.Thread(target=waiting.wait, daemon=True)
other.start()
with end_on_signal(stopping):
    threading.Timer(0.2, signal.pthread_kill, (other.ident, signal.SIGTERM)).start()
    wait(stopping)
print("ended in order")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="threads have no signals of their own there")
def test_a_signal_that_another_thread_is_handed_ends_it() -> None:
    """The system may hand a signal to any thread, and the main thread, which waits, is not woken by it."""
    ended = subprocess.run(
        [sys.executable, "-c", HANDED_ELSEWHERE], capture_output=True, text=True, timeout=60, check=False
    )
    assert (ended.returncode, ended.stdout) == (0, "ended in order\n"), ended.stderr
