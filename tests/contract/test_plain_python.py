"""The compiled laws agree with the plain-Python run of the same source."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pointpred import REGISTRY, EventColumns, build, run

SCRIPT = """
import sys
import numpy as np
import pointpred.compiled
from pointpred import REGISTRY, EventColumns, build, run

assert not pointpred.compiled.COMPILED
events = EventColumns(np.load(sys.argv[1]))
np.savez(sys.argv[2], **{name: run(build(name, cpi=2000.0), events).table for name in REGISTRY})
"""


@pytest.fixture(scope="module")
def signal() -> np.ndarray:
    """A jittered reach with a correction, a pause and a second reach with counts: 500 rows."""
    random = np.random.default_rng(2)
    t = np.cumsum(random.choice([0.001, 0.002, 0.008], 500))
    t[300:] += 0.5
    s = np.clip(np.concatenate([t[:300] / t[299], (t[300:] - t[300]) / (t[-1] - t[300])]), 0.0, 1.0)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    table = np.full((500, 6), np.nan)
    table[:, 0] = t
    table[:, 1] = np.round(600 * way)
    table[:, 2] = np.round(-250 * way)
    table[300:, 3] = np.diff(table[299:, 1])
    table[300:, 4] = np.diff(table[299:, 2])
    table[:, 5] = 0.0
    return table


@pytest.fixture(scope="module")
def plain(signal: np.ndarray, tmp_path_factory: pytest.TempPathFactory) -> dict[str, np.ndarray]:
    """The answers of every pipeline in a process that compiles nothing."""
    folder = tmp_path_factory.mktemp("plain")
    there, back = folder / "signal.npy", folder / "answers.npz"
    np.save(there, signal)
    environment = {**os.environ, "POINTPRED_COMPILED": "0", "PYTHONWARNINGS": "error"}
    command = [sys.executable, "-c", SCRIPT, str(there), str(back)]
    subprocess.run(command, check=True, env=environment, cwd=Path(__file__).parent)
    with np.load(back) as answers:
        return dict(answers)


@pytest.mark.parametrize("name", list(REGISTRY))
def test_compiled_agrees_with_plain_python(
    name: str, signal: np.ndarray, plain: dict[str, np.ndarray]
) -> None:
    compiled = run(build(name, cpi=2000.0), EventColumns(signal)).table
    np.testing.assert_allclose(compiled, plain[name], rtol=1e-6, atol=1e-6)
