"""Further processes that run a module of this distribution, whatever the current folder holds."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pointpred
import pointpred_server


def command(module: str, *arguments: str) -> list[str]:
    """What runs a module; its environment must be ``environment()``."""
    return [sys.executable, "-P", "-m", module, *arguments]


def environment() -> dict[str, str]:
    """The environment of this process, in which the same packages are imported first."""
    packages = [str(Path(file).parent.parent) for file in (pointpred.__file__, pointpred_server.__file__)]
    paths = os.pathsep.join(filter(None, (*packages, os.environ.get("PYTHONPATH"))))
    return os.environ | {"PYTHONPATH": paths}
