"""Runs the cases of the Autobahn suite against a service whose sessions send back what they receive.

The suite itself needs Python 2; kosoku runs its cases, unchanged, in Python 3.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from pointpred.protocol.server_messages import Limits
from pointpred.server.service import Service
from pointpred.server.sessions.lifecycle import Session
from tests.server.running import running

FAMILIES = {"1": 16, "2": 11, "3": 7, "4": 10, "5": 20, "6": 145, "7": 37, "9": 54, "10": 1}
"""How many cases each family has."""
PASSED = {"OK", "NON-STRICT", "INFORMATIONAL"}
"""Not strict: the connection is ended for the violation, but what came before it is not answered first."""
MESSAGE_BYTES = 2**20
"""As much as the protocol below the sessions takes, so that the cases of 1 MiB apply."""
AT_ONCE = 16


class Verdict(NamedTuple):
    """What the suite says of a case: of the messages, of the close, and the close code that it received."""

    messages: str
    close: str
    code: int | None


PINGS = "of pings that arrive together the newest is answered, as RFC 6455 section 5.5.3 allows"
INCOMPLETE = "a close frame inside a fragmented message is a protocol error to the library websockets"
TOO_LARGE = "a message above 1 MiB, or in more than 64 fragments, ends the session"
EXCEPTIONS: Mapping[str, tuple[str, int]] = {
    "2.10": (PINGS, 1000),
    "2.11": (PINGS, 1000),
    "7.1.5": (INCOMPLETE, 1002),
    **{f"9.{kind}.{number}": (TOO_LARGE, 1009) for kind in (1, 2) for number in (4, 5, 6)},
    **{f"9.{kind}.{number}": (TOO_LARGE, 1009) for kind in (3, 4) for number in range(1, 10)},
}
"""Cases that need not pass: why, and the close code that the service then sends."""


class EchoSession(Session):
    """Sends every frame back; it ends only by what the protocol below it, or the client, does."""

    def _receive(self, frame: str | bytes, now: float) -> None:
        self.last_received = now
        self.outbox.add(frame)


def echo(service: Service) -> None:
    """Have a service open echo sessions."""

    def open_session(now: float) -> EchoSession:
        session = EchoSession("echo", Limits(max_frame_bytes=MESSAGE_BYTES), now)
        service._add(session)
        return session

    service.open_session = open_session  # type: ignore[assignment, method-assign]


def holds(case: str, verdict: Verdict) -> bool:
    """Whether a case passes, or ends as the table of exceptions says."""
    if verdict.messages in PASSED and verdict.close in PASSED:
        return True
    return case in EXCEPTIONS and verdict.code == EXCEPTIONS[case][1]


async def run() -> dict[str, Verdict]:
    """Every case of ``FAMILIES`` by its number."""
    import kosoku

    with running(echo, max_sessions=2 * AT_ONCE) as here:
        url = f"ws://127.0.0.1:{here.port}/v1/stream"
        try:
            results = await kosoku.run_fuzzingclient(
                url, [f"{family}.*" for family in FAMILIES], concurrency=AT_ONCE
            )
        except kosoku.FailureError as failure:
            results = failure.results
    return {
        one.case_id: Verdict(one.behavior.value, one.behavior_close.value, one.remote_close_code)
        for one in results
    }
