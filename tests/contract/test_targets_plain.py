"""A chooser's compiled laws agree with the plain-Python run of the same source."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

SCRIPT = """
import json
from pointpred import PointerEvent, build
from pointpred.targets import Chooser, around
from math import cos, sin

pipeline, told = build("minimum-jerk"), []
pipeline.register([around(i, 300 * cos(i), 300 * sin(i), 20 + 9 * i) for i in range(7)])
chooser = Chooser(pipeline, precision=0.4)
for i in range(180):
    movement, s = i // 60, (i % 60) / 59
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    t = 0.012 * i + 0.5 * movement
    event = PointerEvent(t, 290.0 * way * cos(2.1 + movement), 310.0 * way * sin(2.1 + movement))
    given = pipeline.update(event)
    row = [given.x, given.y, *given.scale, given.tail, given.remaining_s] if given else []
    shares = list(pipeline.shares.values())
    told.append([shares + row, [(c.id, c.action) for c in chooser.update()]])
print(json.dumps(told))
"""


def told(compiled: str) -> list[list[list[float]]]:
    environment = os.environ | {"POINTPRED_COMPILED": compiled}
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT],
        env=environment, capture_output=True, text=True, check=True,
    )  # fmt: skip
    answer: list[list[list[float]]] = json.loads(done.stdout)
    return answer


def test_plain_python_proposes_the_same() -> None:
    fast, plain = told("1"), told("0")
    assert [row[1] for row in fast] == [row[1] for row in plain]
    assert any(row[1] for row in fast)
    for here, there in zip(fast, plain, strict=True):
        assert here[0] == pytest.approx(there[0], rel=1e-9, abs=1e-12)
