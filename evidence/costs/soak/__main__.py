"""Soak the service for so many MINUTES, 60 unless given.

A real service that records, and around it clients of every kind: steady, bursty, paused, coming and going,
never reading, hostile, and people with a browser. It prints what it sees and the time left, stops cleanly
with Ctrl-C and judges what it has, and exits with 1 where something wanted does not hold.
"""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from urllib.request import urlopen

import msgspec

from evidence.arguments import parse
from evidence.costs.load.servers import wait_until_ready
from evidence.costs.soak.sessions import Plan, Report
from evidence.costs.soak.verdicts import Second, Usage, Verdict, judge, percentile_ms, usage_of
from evidence.data import Table, Tables, file_of, write
from evidence.machine import machine
from pointpred.errors import ParameterError

FILE = file_of("costs", "soak")
MINUTES = 60.0
GROUPS = ("steady", "varied", "hostile", "visitors")
PROGRESS_S = 15.0
SETTLE_S = 12.0
"""After the last client has left, for what was cut to end."""
END_S = 600.0
"""So long comparing an hour of recordings may take."""
LOST = "pointpred_recorder_events_lost_total"


@contextmanager
def service(recordings: Path, log: Path) -> Iterator[tuple[subprocess.Popen[str], int]]:
    """A service that records, ready to answer; and its port."""
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0", "--metrics-port", "0"]
    command += ["--record", str(recordings)]
    with log.open("w", encoding="utf-8") as errors:
        process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=errors, text=True, start_new_session=True
        )
        try:
            assert process.stdout is not None
            address = process.stdout.readline().strip()
            if not address:
                raise SystemExit(f"the service did not start: {log.read_text(encoding='utf-8')[-500:]}")
            wait_until_ready(address)
            yield process, int(address.rstrip("/").rpartition(":")[2])
        finally:
            process.terminate()
            process.wait(60)
            if process.stdout:
                process.stdout.close()


class Soak:
    """The processes of clients, and what is seen of the service meanwhile."""

    def __init__(self, plan: Plan) -> None:
        self.seconds: list[Second] = []
        self.counts: Counter[str] = Counter()
        self.wrong: list[str] = []
        self._delays: Counter[int] = Counter()
        self._pid = plan.pid
        self._lock = threading.Lock()
        self._begun = time.monotonic()
        self._groups = [self._start(group, plan) for group in GROUPS]

    def _start(self, group: str, plan: Plan) -> subprocess.Popen[str]:
        command = [
            sys.executable,
            "-m",
            "evidence.costs.soak.players",
            group,
            msgspec.json.encode(plan).decode(),
        ]
        if group != "steady":  # whose delays are judged: the others give way to it
            command = ["nice", "-n", "5", *command]
        process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, start_new_session=True
        )
        threading.Thread(target=self._listen, args=(process, group == "steady"), daemon=True).start()
        return process

    def _listen(self, process: subprocess.Popen[str], judged: bool) -> None:
        assert process.stdout is not None
        for line in process.stdout:
            report = msgspec.json.decode(line, type=Report, strict=False)
            with self._lock:
                self.counts.update(report.counts)
                self.wrong += report.wrong
                if judged:
                    self._delays.update(report.delays)

    def look(self) -> Usage:
        """What the service holds now."""
        return usage_of(self._pid, time.monotonic() - self._begun)

    def watch(self, until_s: float) -> None:
        """Look once a second; raises RuntimeError where a process of clients has ended."""
        printed_at = 0.0
        while (at := time.monotonic() - self._begun) < until_s:
            time.sleep(1.0)
            with self._lock:
                delays, self._delays = dict(self._delays), Counter()
            self.seconds.append(Second(self.look(), delays))
            ended = [name for name, one in zip(GROUPS, self._groups, strict=True) if one.poll() is not None]
            if ended:
                raise RuntimeError(f"the clients '{ended[0]}' ended early")
            if at - printed_at >= PROGRESS_S:
                printed_at = at
                self._tell(until_s - at)

    def _tell(self, left_s: float) -> None:
        usage, recent = self.seconds[-1].usage, self.seconds[-int(PROGRESS_S) :]
        print(
            f"{left_s / 60:5.1f} min left: memory {usage.memory_mb:.1f} MB, threads {usage.threads}, "
            f"descriptors {usage.descriptors}, p99 {percentile_ms(recent, 99):.2f} ms, "
            f"{self.counts['sessions compared']} sessions compared, {self.counts['attacks']} attacks, "
            f"{len(self.wrong)} complaints",
            file=sys.stderr,
        )

    def stop(self) -> None:
        """Have the clients leave and compare the rest."""
        for process in self._groups:
            assert process.stdin is not None
            with suppress(OSError):
                process.stdin.close()
        for name, process in zip(GROUPS, self._groups, strict=True):
            try:
                if process.wait(END_S):
                    self.wrong.append(f"the clients '{name}' failed with {process.returncode}")
            except subprocess.TimeoutExpired:
                process.kill()
                self.wrong.append(f"the clients '{name}' did not end")
        time.sleep(0.5)  # for the last lines to be read


def lost_events(log: Path) -> int:
    """Events that the recorder lost, by the service's own count; ``log`` says where that is."""
    address = re.search(r"Metrics: (http[^\s\"]+)", log.read_text(encoding="utf-8"))
    assert address is not None
    with urlopen(address[1]) as answer:
        lines = answer.read().decode().splitlines()
    return int(next(float(line.split()[1]) for line in lines if line.startswith(LOST)))


def errors_in(log: Path) -> list[str]:
    """What the service logged as an error: no client may cause that."""
    return [line for line in log.read_text(encoding="utf-8").splitlines() if '"level": "error"' in line]


def table_of(verdicts: list[Verdict]) -> Table:
    """What the page shows."""
    rows = [(one.condition, one.wanted, one.result, "yes" if one.holds else "no") for one in verdicts]
    return Table.of(("condition", "wanted", "measured", "holds"), rows)


def main(minutes: float, file: Path = FILE) -> int:
    """Soak, judge, write; returns the exit code."""
    where = machine(load=True)
    signal.signal(signal.SIGTERM, lambda *_: signal.raise_signal(signal.SIGINT))
    with tempfile.TemporaryDirectory(prefix="pointpred-soak-") as folder:
        recordings, scratch, log = (Path(folder) / name for name in ("recordings", "sent", "log"))
        scratch.mkdir()
        with service(recordings, log) as (process, port):
            before = usage_of(process.pid, 0.0)
            soak = Soak(Plan(port, process.pid, str(log), str(scratch), str(recordings)))
            try:
                soak.watch(60.0 * minutes)
            except KeyboardInterrupt:
                print("stopped: judging what there is", file=sys.stderr)
            except (RuntimeError, OSError) as error:
                soak.wrong.append(str(error))
            soak.stop()
            time.sleep(SETTLE_S)
            after, lost = soak.look(), lost_events(log)
        if process.returncode not in {0, -signal.SIGTERM}:
            soak.wrong.append(f"the service ended with {process.returncode}")
        soak.wrong += errors_in(log)
    verdicts = judge(soak.seconds, soak.wrong, soak.counts, before, after, lost)
    numbers = {
        "minutes": soak.seconds[-1].usage.at_s / 60,
        "processor_share": soak.seconds[-1].usage.processor_s / soak.seconds[-1].usage.at_s,
    }
    write(Tables({"verdicts": table_of(verdicts)}, where, numbers), file)
    for line in soak.wrong[:20]:
        print(line, file=sys.stderr)
    for one in verdicts:
        print(f"{'holds' if one.holds else 'FAILS'}: {one.condition}, wanted {one.wanted}: {one.result}")
    print(f"wrote {file}")
    return 0 if all(one.holds for one in verdicts) else 1


def minutes_of(arguments: list[str]) -> float:
    """The length of the soak; raises ParameterError."""
    try:
        minutes = float(arguments[0]) if arguments else MINUTES
    except ValueError:
        minutes = 0.0
    if not 0.5 <= minutes <= 10_000:
        raise ParameterError(f"a soak lasts 0.5 to 10,000 minutes, received {arguments[0]!r}")
    return minutes


if __name__ == "__main__":
    sys.exit(main(minutes_of(parse(__doc__, metavar="MINUTES", most=1))))
