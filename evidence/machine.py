"""The machine that measures, as a page names it."""

from __future__ import annotations

import os
import platform
from datetime import UTC, datetime
from pathlib import Path


def machine(*, load: bool = False) -> str:
    """The computer, how busy it is where ``load``, and the date."""
    busy = f", load average before the run {os.getloadavg()[0]:.1f}" if load else ""
    return f"{computer()}{busy}; {datetime.now(UTC):%Y-%m-%d}"


def computer(cpuinfo: Path = Path("/proc/cpuinfo")) -> str:
    """The processor as far as the system names it, its cores, and Python."""
    lines = cpuinfo.read_text(encoding="utf-8").splitlines() if cpuinfo.exists() else []
    named = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    model = named or platform.processor() or platform.machine()
    cores = os.cpu_count() or 1
    return f"{model}, {cores} core{'s' if cores > 1 else ''}, Python {platform.python_version()}"
