"""The machine that measures, as a page names it."""

from __future__ import annotations

import os
import platform
from pathlib import Path


def machine(cpuinfo: Path = Path("/proc/cpuinfo"), *, load: bool = False) -> str:
    """The processor as far as the system names it, its cores, and Python; ``load``: how busy it is."""
    lines = cpuinfo.read_text(encoding="utf-8").splitlines() if cpuinfo.exists() else []
    named = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    model = named or platform.processor() or platform.machine()
    cores = os.cpu_count() or 1
    text = f"{model}, {cores} core{'s' if cores > 1 else ''}, Python {platform.python_version()}"
    return f"{text}, load average before the run {os.getloadavg()[0]:.1f}" if load else text
