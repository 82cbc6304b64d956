"""``pointpred serve`` as a process, for tests of several workers and of proxies."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any
from urllib.request import urlopen

from prometheus_client.parser import text_string_to_metric_families

from tests.server.running import PATIENCE_S


class Served:
    """A service that has announced itself; ``log`` has the entries that it wrote."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self.process = process
        self.log: list[dict[str, Any]] = []
        self._reading = threading.Thread(target=self._read_log)
        self._reading.start()
        assert process.stdout is not None
        self.announced = process.stdout.readline().strip()
        self.address = self.announced.partition("?")[0]

    @property
    def port(self) -> int:
        return int(self.address.rstrip("/").rpartition(":")[2])

    def children(self) -> list[int]:
        """The process numbers of its workers, the smallest first."""
        children = []
        for folder in Path("/proc").iterdir():
            try:
                line = (folder / "cmdline").read_bytes().split(b"\0")
                status = (folder / "stat").read_text()
            except (OSError, ValueError):
                continue
            parent = status.rpartition(")")[2].split()[1]
            if b"pointpred_server.workers.worker" in line and int(parent) == self.process.pid:
                children.append(int(folder.name))
        return sorted(children)

    def metrics(self, token: str = "") -> dict[tuple[str, str], float]:
        """Every sample of ``/metrics``: by its name and the value of its label, if it has one."""
        query = f"?token={token}" if token else ""
        with urlopen(f"{self.address}metrics{query}", timeout=PATIENCE_S) as answer:
            families = text_string_to_metric_families(answer.read().decode())
            return {
                (sample.name, ",".join(sample.labels.values())): sample.value
                for family in families
                for sample in family.samples
            }

    def wait_until_ready(self) -> None:
        until = time.monotonic() + 2 * PATIENCE_S
        while time.monotonic() < until:
            try:
                with urlopen(f"{self.address}readyz", timeout=PATIENCE_S):
                    return
            except OSError:
                time.sleep(0.05)
        raise AssertionError(f"not ready: {self.log}")

    def messages(self) -> list[str]:
        return [entry["message"] for entry in self.log]

    def stop(self, number: int = signal.SIGTERM) -> int:
        """Send it a signal; returns its exit code."""
        self.process.send_signal(number)
        code = self.process.wait(PATIENCE_S)
        self._reading.join(PATIENCE_S)
        return code

    def kill(self) -> None:
        """End it, whatever it does."""
        self.process.kill()
        self.process.wait()
        self._reading.join(PATIENCE_S)

    def _read_log(self) -> None:
        assert self.process.stderr is not None
        for line in self.process.stderr:
            self.log.append(json.loads(line) if line.startswith("{") else {"message": line.strip()})


@contextmanager
def served(*options: str, **environment: str) -> Iterator[Served]:
    """Serve on a free port until the block ends."""
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0", *options]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=os.environ | environment
    )
    with process, ExitStack() as stack:  # leaving the process closes its pipes
        stack.callback(process.kill)
        service = Served(process)
        stack.callback(service.kill)
        yield service
