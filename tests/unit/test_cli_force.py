"""No command replaces a file without --force."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

WRITING = {
    "convert": ("tests/data/sources/gofitts.sd3", "--out"),
    "measures": ("sample", "--out"),
    "measures drawn": ("sample", "--plot"),
    "reproduce": ("2.11", "--json"),
    "score": ("sample", "--predictors", "hold", "--json"),
    "score a report": ("sample", "--predictors", "hold", "--report"),
    "simulate": ("--people", "1", "--out"),
    "train": ("sample", "--out"),
    "train with numbers": ("sample", "--out", "NEW", "--json"),
    "replay": ("sample", "--to", "ws://127.0.0.1:9", "--json"),
}


@pytest.mark.parametrize("name", WRITING)
def test_a_file_that_is_there_stays(command: Callable[..., Any], tmp_path: Path, name: str) -> None:
    endings = {"convert": ".csv", "simulate": ".csv", "train": ".npz", "measures": ".csv"}
    ending = (endings | {"measures drawn": ".svg"}).get(name, ".out")
    target = tmp_path / f"mine_samples{ending}"
    target.write_text("mine", encoding="utf-8")
    words = [str(tmp_path / "new.npz") if word == "NEW" else word for word in WRITING[name]]
    left = command(name.split()[0], *words, target)
    assert left.code == 2
    assert "exists" in left.err
    assert "--force" in left.err
    assert target.read_text(encoding="utf-8") == "mine"


def test_results_are_replaced_with_force(command: Callable[..., Any], tmp_path: Path) -> None:
    target = tmp_path / "scores.json"
    target.write_text("mine", encoding="utf-8")
    left = command("score", "sample", "--predictors", "hold", "--json", target, "--force")
    assert left.code == 0, left.err
    assert target.read_text(encoding="utf-8").startswith("{")


def test_a_report_in_a_folder_is_replaced_with_force_only(
    command: Callable[..., Any], tmp_path: Path
) -> None:
    (tmp_path / "paper").mkdir()
    page = tmp_path / "paper" / "report.html"
    page.write_text("mine", encoding="utf-8")
    words = ("score", "sample", "--predictors", "hold", "--report", page.parent)
    left = command(*words)
    assert left.code == 2
    assert f"{page} exists" in left.err
    assert page.read_text(encoding="utf-8") == "mine"
