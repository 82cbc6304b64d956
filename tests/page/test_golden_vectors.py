"""The laws in JavaScript answer as those of Python do, in Node, Chromium and Firefox."""

from __future__ import annotations

import json
import math
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from pointpred import REGISTRY
from tests.page import golden
from tests.page.browsers import KINDS, posted

NODE = shutil.which("node")
NEAR = 1e-9
"""Share of the movement; of a second or of the time left, and of the region, where these are longer."""


def without_nan(value: Any) -> Any:
    if isinstance(value, float) and math.isnan(value):
        return None
    if isinstance(value, dict):
        return {name: without_nan(one) for name, one in value.items()}
    return [without_nan(one) for one in value] if isinstance(value, list | tuple) else value


@pytest.fixture(scope="module")
def cases() -> bytes:
    return json.dumps(without_nan(golden.cases()), allow_nan=False).encode()


def assert_same(result: Any) -> None:
    assert "error" not in result, result["error"]
    assert {one["name"] for one in result["streams"]} == set(REGISTRY)
    for one in result["streams"]:
        assert one["unequal"] == [], one
        assert max(one[kind] for kind in ("place", "scale", "left", "tail")) <= NEAR, one
    assert result["targets"]["unequal"] == []
    assert result["targets"]["worst"] <= NEAR


@pytest.mark.skipif(NODE is None, reason="no node on this machine")
def test_node_answers_as_python_does(cases: bytes) -> None:
    assert NODE is not None
    script = Path(__file__).parent / "laws_in_node.mjs"
    done = subprocess.run([NODE, str(script)], input=cases, capture_output=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr.decode()
    assert_same(json.loads(done.stdout))


@pytest.mark.parametrize("kind", KINDS)
def test_browsers_answer_as_python_does(kind: str, cases: bytes, tmp_path: Path) -> None:
    assert_same(posted(kind, "laws_in_browser.html", cases, tmp_path / "profile"))
