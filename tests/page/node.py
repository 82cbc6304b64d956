"""The page's own modules, run by Node."""

from __future__ import annotations

import json
import math
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

NODE = shutil.which("node")
HERE = Path(__file__).parent
PATIENCE_S = 120.0
"""A machine that others keep busy may take long to answer."""

needed = pytest.mark.skipif(NODE is None, reason="no node on this machine")


def run(script: str, given: Any) -> Any:
    """What a module beside this file writes to its output as JSON, of what it is given as JSON.

    NaN is null on the way there and NaN again on the way back, where it stands in a row.
    """
    assert NODE is not None
    done = subprocess.run(
        [NODE, str(HERE / script)],
        input=json.dumps(_sent(given), allow_nan=False),
        capture_output=True,
        text=True,
        timeout=PATIENCE_S,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def _sent(value: Any) -> Any:
    if isinstance(value, float) and math.isnan(value):
        return None
    if isinstance(value, dict):
        return {name: _sent(one) for name, one in value.items()}
    return [_sent(one) for one in value] if isinstance(value, list | tuple) else value
