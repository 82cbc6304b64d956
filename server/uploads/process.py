"""A process that opens and scores uploaded recordings: sessions do not share its interpreter, nor its memory.

``python -m pointpred_server.uploads.process``: a line that says what to do and the body in, a line about the
response and the response out, until the input ends. It runs with low priority, may take so much memory beyond
what is loaded, and is killed where a recording takes too long; the next one starts another.
"""

from __future__ import annotations

import logging
import os
import signal
import subprocess
import sys
import threading
import weakref
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO, Literal

import msgspec

from pointpred_server.child_processes import command, environment
from pointpred_server.uploads.receiving import UploadError

log = logging.getLogger("pointpred.service")

SCORE_S = 60.0
"""So long a recording may take."""
MEMORY_BYTES = 2**30
"""So much memory it may take, beyond the code."""
NICENESS = 10
TOO_LARGE = (
    f"a recording scored here may take {SCORE_S:g} s and {MEMORY_BYTES // 2**20} MiB of memory; "
    "'pointpred score' takes larger ones"
)
ENDED = (
    "the process that opens recordings ended unexpectedly; send the recording again, "
    "and use 'pointpred score' if that happens again"
)
STATUS = Path("/proc/self/status")

Task = Literal["score", "open"]


class Order(msgspec.Struct):
    """What to do with a body of so many bytes."""

    task: Task
    size: int
    predictors: tuple[str, ...]
    query: dict[str, str]


class Outcome(msgspec.Struct):
    """The HTTP status, the bytes of the response, where it failed, if it did, and whether memory ran out."""

    status: int
    size: int
    failed: str | None = None
    exhausted: bool = False


class UploadProcess:
    """The process, as the serving one sees it, started by the first recording; for one thread at a time."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._busy = threading.Lock()
        self._ended = False

    def run(
        self, task: Task, body: bytes, predictors: tuple[str, ...], query: Mapping[str, str]
    ) -> tuple[Outcome, bytes]:
        """The response to an upload.

        Raises UploadError where it takes too long, the service stops, or the process ends for another reason.
        """
        with self._busy:
            return self._run(Order(task, len(body), predictors, dict(query)), body)

    def _run(self, order: Order, body: bytes) -> tuple[Outcome, bytes]:
        self._check_not_ended()
        process = self._started()
        if self._ended:  # while it was started
            self._kill()
        self._check_not_ended()
        too_long = threading.Event()

        def stop() -> None:
            too_long.set()
            process.kill()

        timer = threading.Timer(SCORE_S, stop)
        timer.start()
        try:
            outcome, response = _ask(process, order, body)
        except (OSError, EOFError, msgspec.DecodeError):
            self._kill()
            self._check_not_ended()
            if too_long.is_set():
                raise UploadError("too_large", TOO_LARGE, 413) from None
            how = {"error": f"exit code {process.returncode}"}
            log.error("the process that opens recordings ended unexpectedly", extra=how)
            raise UploadError("internal", ENDED, 500) from None
        finally:
            timer.cancel()
        if outcome.exhausted:  # it keeps most of what it took: the next recording begins with another one
            self._kill()
        return outcome, response

    def _check_not_ended(self) -> None:
        if self._ended:
            raise UploadError("stopping", "the service stops", 503) from None

    def end(self, timeout_s: float = 1.0) -> None:
        """Kill it, and wait for that; a recording that is being scored is refused."""
        self._ended = True
        if (process := self._process) is not None:
            process.kill()
        if self._busy.acquire(timeout=timeout_s):  # the thread that waits for it notices at once
            self._kill()
            self._busy.release()

    def _kill(self) -> None:
        if self._process is not None:
            _close(self._process)
            self._process = None

    def _started(self) -> subprocess.Popen[bytes]:
        if self._process is not None and self._process.poll() is not None:
            self._kill()
        if self._process is None:
            self._process = subprocess.Popen(
                command("pointpred_server.uploads.process"),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                # The other pools of Arrow reserve as much as is allowed before anything is read.
                env=environment() | {"ARROW_DEFAULT_MEMORY_POOL": "system"},
            )
            weakref.finalize(self, _close, self._process)
        return self._process


def _close(process: subprocess.Popen[bytes]) -> None:
    """Kill a process, wait for that, and close its pipes."""
    process.kill()
    process.wait()
    for pipe in (process.stdin, process.stdout):
        with suppress(OSError):  # of a body that was not read
            assert pipe is not None
            pipe.close()


def _ask(process: subprocess.Popen[bytes], order: Order, body: bytes) -> tuple[Outcome, bytes]:
    """Have one order done; raises OSError or EOFError where the process has ended."""
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write(msgspec.json.encode(order) + b"\n" + body)
    process.stdin.flush()
    outcome = msgspec.json.decode(process.stdout.readline(), type=Outcome)
    response = process.stdout.read(outcome.size)
    if len(response) < outcome.size:
        raise EOFError
    return outcome, response


def main() -> None:
    """Do what the input says until it ends."""
    output = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever a library prints is no response
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal sends it to the whole group: the parent decides
    if hasattr(os, "nice"):
        os.nice(NICENESS)
    from pointpred_server.uploads.answers import answer

    _bound_memory()
    source: BinaryIO = sys.stdin.buffer
    while line := source.readline():
        order = msgspec.json.decode(line, type=Order)
        outcome, response = answer(order, source.read(order.size))
        output.write(msgspec.json.encode(outcome) + b"\n" + response)
        output.flush()


def _bound_memory() -> None:
    """Bound the memory of this process, where the system can."""
    if not STATUS.exists():
        return
    import resource

    lines = STATUS.read_text(encoding="utf-8").splitlines()
    loaded = next(int(line.split()[1]) * 1024 for line in lines if line.startswith("VmData:"))
    resource.setrlimit(resource.RLIMIT_DATA, (loaded + MEMORY_BYTES, resource.RLIM_INFINITY))


if __name__ == "__main__":
    main()
