"""Further processes that run a module of this package, whatever the current folder holds."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pointpred


def command(module: str, *arguments: str) -> list[str]:
    """What runs a module; its environment must be ``environment()``."""
    return [sys.executable, "-P", "-m", module, *arguments]


def environment() -> dict[str, str]:
    """The environment of this process, in which the same package is imported first."""
    package = str(Path(pointpred.__file__).parent.parent)
    paths = os.pathsep.join(filter(None, (package, os.environ.get("PYTHONPATH"))))
    return os.environ | {"PYTHONPATH": paths}
