"""``pointpred reproduce`` of chapters 3 and 4 and of the camera paper."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_they_are_listed_beside_the_others(command: Callable) -> None:
    left = command("reproduce")
    assert left.code == 0
    lines = {line.split()[0]: line for line in left.out.splitlines()[1:]}
    assert "can read sniffer.csv" in lines["3.11"]
    assert {"4.4", "camera-table-1"} <= lines.keys()


def test_a_table_is_not_drawn(command: Callable) -> None:
    left = command("reproduce", "camera-table-1", "--out", "table.svg")
    assert left.code == 2
    assert "is a table" in left.err


def test_the_sniffer_data_are_taken_from_their_folder_and_checked(command: Callable, tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    rows = rng.uniform(1.0, 9.0, (40, 4))
    table = np.column_stack([rows, rows @ [1.0, -2.0, 3.0, 4.0]])
    np.savetxt(tmp_path / "sniffer.csv", table, delimiter=",", header="a,b,c,d,y")
    left = command("reproduce", "3.10", tmp_path, "--json", "-")
    assert left.code == 0, left.err
    document = json.loads(left.out)
    assert document["data"] == "sniffer.csv"
    ends = [value["ours"] for value in document["values"] if "recursive" in value["name"]]
    assert ends == pytest.approx([1.0, -2.0, 3.0, 4.0], abs=1e-6)
    np.savetxt(tmp_path / "sniffer.csv", table[:, :3], delimiter=",", header="a,b,c")
    left = command("reproduce", "3.11", tmp_path)
    assert left.code == 1
    assert "five columns" in left.err
    (tmp_path / "sniffer.csv").unlink()
    assert "Weisberg" in command("reproduce", "3.11", tmp_path).err
