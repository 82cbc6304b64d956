"""Runs the cases of the Autobahn suite against a service whose sessions send back what they receive.

The suite itself needs Python 2; kosoku runs its cases in Python 3. ``python -m tests.server.autobahn`` writes
the table of ``docs/evidence/attacks.md``.
"""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Mapping
from typing import NamedTuple
from unittest.mock import patch

from msgspec import structs

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.machine import machine
from pointpred.clock import Instant
from pointpred.protocol.server_messages import Limits
from pointpred_server.sessions.lifecycle import Session, State
from tests.server.running import running

FAMILIES = {"1": 16, "2": 11, "3": 7, "4": 10, "5": 20, "6": 145, "7": 37, "9": 54, "10": 1}
"""How many cases each family has."""
TITLES = {
    "1": "framing",
    "2": "pings and pongs",
    "3": "reserved bits",
    "4": "opcodes",
    "5": "fragmentation",
    "6": "UTF-8",
    "7": "closing",
    "9": "limits, performance",
    "10": "automatic fragmentation",
}
PASSED = {"OK", "NON-STRICT", "INFORMATIONAL"}
"""Not strict: the connection is ended for the violation, but what came before it is not answered first."""
MESSAGE_BYTES = 2**20
"""As much as the protocol below the sessions takes, so that the cases of 1 MiB apply."""
AT_ONCE = 16
AGAIN = 3


class Verdict(NamedTuple):
    """What the suite says of a case: of the messages, of the close, and the close code that it received."""

    messages: str
    close: str
    code: int | None


INCOMPLETE = "a close frame inside a fragmented message is a protocol error to the library websockets"
TOO_LARGE = "a message above 1 MiB ends the session"
EXCEPTIONS: Mapping[str, tuple[str, int]] = {
    "7.1.5": (INCOMPLETE, 1002),
    **{f"9.{kind}.{number}": (TOO_LARGE, 1009) for kind in (1, 2) for number in (4, 5, 6)},
    **{f"9.{kind}.{number}": (TOO_LARGE, 1009) for kind in (3, 4) for number in range(1, 10)},
}
"""Cases that need not pass: why, and the close code that the service then sends."""


class EchoSession(Session):
    """Sends every frame back; it ends only by what the protocol below it, or the client, does."""

    def __init__(self, name: str, limits: Limits, now: Instant, *further: object) -> None:
        super().__init__(
            name, structs.replace(limits, max_frame_bytes=MESSAGE_BYTES), now, state=State.STREAMING
        )

    def _receive(self, frame: str | bytes, now: Instant) -> None:
        self.outbox.add(frame)

    def receive_piece(self, now: Instant) -> None:
        """The suite sends more than a session may."""


def holds(case: str, verdict: Verdict) -> bool:
    """Whether a case passes, or ends as the table of exceptions says."""
    if verdict.messages in PASSED and verdict.close in PASSED:
        return True
    return case in EXCEPTIONS and verdict.code == EXCEPTIONS[case][1]


async def run() -> dict[str, Verdict]:
    """Every case of ``FAMILIES`` by its number; one that fails is run again, alone.

    The suite allows a second for many answers, which a machine that others use may not have.
    """
    with (
        patch("pointpred_server.service.PointingSession", EchoSession),
        running(max_sessions=2 * AT_ONCE) as here,
    ):
        url = f"ws://127.0.0.1:{here.port}/v1/stream"
        verdicts = await _run(url, [f"{family}.*" for family in FAMILIES], AT_ONCE)
        for _ in range(AGAIN):
            if broken := [case for case, verdict in verdicts.items() if not holds(case, verdict)]:
                verdicts |= await _run(url, broken, 1)
    return verdicts


async def _run(url: str, cases: list[str], at_once: int) -> dict[str, Verdict]:
    import kosoku

    try:
        results = await kosoku.run_fuzzingclient(url, cases, concurrency=at_once)
    except kosoku.FailureError as failure:
        results = failure.results
    return {
        one.case_id: Verdict(one.behavior.value, one.behavior_close.value, one.remote_close_code)
        for one in results
    }


def main() -> None:
    """Write the table of the families, and that of the exceptions."""
    verdicts = asyncio.run(run())
    rows: list[list[str]] = []
    reasons: dict[tuple[str, int], list[str]] = {}
    for family, title in TITLES.items():
        cases = {case: one for case, one in verdicts.items() if case.startswith(f"{family}.")}
        counts = Counter(one.messages if one.close in PASSED else "FAILED" for one in cases.values())
        rest = [case for case, one in cases.items() if not {one.messages, one.close} <= PASSED]
        broken = [case for case in rest if not holds(case, cases[case])]
        for case in set(rest) - set(broken):
            reasons.setdefault(EXCEPTIONS[case], []).append(case)
        passed = [counts[name] for name in ("OK", "NON-STRICT", "INFORMATIONAL")]
        rows.append(
            [f"{family} {title}", *map(str, (len(cases), *passed, len(rest) - len(broken), len(broken)))]
        )
    columns = ("family", "cases", "pass", "not strict", "informational", "do not apply", "fail")
    exceptions = [
        [", ".join(sorted(cases, key=lambda case: [int(part) for part in case.split(".")])), str(code), why]
        for (why, code), cases in reasons.items()
    ]
    tables = {
        "families": Table.of(columns, rows),
        "exceptions": Table.of(("cases", "close code", "why"), exceptions),
    }
    keep("attacks", tables, part="conformance", machine=machine())


if __name__ == "__main__":
    parse(__doc__)
    main()
