"""``pointpred benchmark``: sets fetched from a host of this machine, kept, scored, and what cannot be had."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pointpred.benchmark import benchmark_sets, judged_on
from pointpred.datasets import DataSet, RemoteFile, sample
from pointpred.recordings.reading import Reading
from tests.building import lines_file, reach
from tests.hosts import file_host

FILE = "moves.csv"


def table(folder: Path) -> None:
    """Two people, three movements each, as somebody's own table in ms."""
    rows = ["who,n,ms,px,py"]
    for k in range(6):
        movement = reach((10.0, 20.0), (300.0 + 20 * k, 200.0)).table[:, :3].tolist()
        rows += [f"p{k // 3},{k},{1e3 * t:.0f},{x:.1f},{y:.1f}" for t, x, y in movement]
    lines_file(folder / FILE, *rows)


def entry(name: str, origin: str, path: str, digest: str) -> DataSet:
    columns: dict[str, str | int] = {"t": "ms", "x": "px", "y": "py", "user": "who", "trial": "n"}
    return DataSet(
        name, "Test", "https://example.org", "MIT, 2026 Ann", "Ann 2026", 2, 6, "", "",
        files=(RemoteFile(FILE, f"{origin}/{path}", digest),),
        reading=Reading(columns=columns, time_unit="ms"),
    )  # fmt: skip


@pytest.fixture
def offered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], None]:
    """Make the catalogue one of two sets, of which the second is not where it is said to be."""
    (tmp_path / "host").mkdir()
    table(tmp_path / "host")
    digest = hashlib.sha256((tmp_path / "host" / FILE).read_bytes()).hexdigest()

    def offer(origin: str) -> None:
        sets = entry("jrcalgo", origin, FILE, digest), entry("away", origin, "gone.csv", digest)
        monkeypatch.setattr("pointpred.benchmark.listing", lambda: sets)

    return offer


def test_sets_are_fetched_once_checked_and_scored(
    command: Any, offered: Callable[[str], None], tmp_path: Path
) -> None:
    words = ("benchmark", "--folder", tmp_path / "kept", "--predictors", "linear,kinematic")
    with file_host(tmp_path / "host") as origin:
        offered(origin)
        first = command(*words, "--json", tmp_path / "first.json")
    assert first.code == 0, first.err
    said = first.err.splitlines()
    assert [line.partition(":")[0] for line in said[:2]] == ["jrcalgo", "away"]
    assert all("MIT, 2026 Ann. Please cite Ann 2026" in line for line in said[:2])
    assert said[2].startswith(f"{tmp_path / 'kept' / 'jrcalgo' / FILE}: ")
    assert "digest as recorded" in said[2]
    assert "left out: away: " in first.err
    assert "404" in first.err
    assert said[-1] == "Not scored, for the reasons above: away"
    lines = first.out.splitlines()
    assert [line for line in lines if line.startswith("kinematic *  ")]
    assert "*: set left out, fitted to other sets only" in lines
    assert lines[0].startswith("jrcalgo: 6 trials, 2 people; hold is ")
    rows = lines[lines.index("All sets: time-averaged error, share of hold's [95 % interval]") + 1 :]
    assert [row.split("  ")[0].strip() for row in rows] == [
        *("predictor", "hold", "linear"), "kinematic (set left out)",
    ]  # fmt: skip
    document = json.loads((tmp_path / "first.json").read_text())
    (one,) = document["sets"]
    assert [unread["file"] for unread in document["unread"]] == ["away"]
    shares = [p["time_averaged"] for p in one["predictors"]]
    for row, share in zip(rows[1:], shares, strict=True):
        low, high = share["interval"]
        assert row.endswith(f"{share['of_hold']:.2f} [{low:.2f}, {high:.2f}]")
    again = command(*words, "--json", "-")  # the host is gone
    assert again.code == 0, again.err
    assert "already there" in again.err
    assert [p["time_averaged"] for p in json.loads(again.out)["sets"][0]["predictors"]] == shares


def test_a_file_that_was_changed_is_neither_replaced_nor_scored(
    command: Any, offered: Callable[[str], None], tmp_path: Path
) -> None:
    offered("http://127.0.0.1:9")
    (tmp_path / "kept" / "jrcalgo").mkdir(parents=True)
    (tmp_path / "kept" / "jrcalgo" / FILE).write_text("mine")
    left = command("benchmark", "--folder", tmp_path / "kept", "--predictors", "hold")
    assert left.code == 1
    assert "expected sha256" in left.err
    assert "no set could be scored" in left.err
    assert (tmp_path / "kept" / "jrcalgo" / FILE).read_text() == "mine"


def test_a_report_has_a_table_and_a_figure_of_all_sets(
    command: Any, offered: Callable[[str], None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reported: list[Any] = []

    def write_report(scores: Any, path: Path) -> None:  # takes seconds; other tests look at what it writes
        reported.extend(scores)
        path.mkdir()

    monkeypatch.setattr("pointpred.scoring.report.write_report", write_report)
    with file_host(tmp_path / "host") as origin:
        offered(origin)
        words = ("--folder", tmp_path / "kept", "--predictors", "linear", "--report", tmp_path / "paper")
        left = command("benchmark", *words)
    assert left.code == 0, left.err
    assert [(one.name, one.worst is not None) for one in reported] == [("jrcalgo", True)]
    rows = (tmp_path / "paper" / "all-sets.csv").read_text().splitlines()
    assert rows[0] == "predictor,jrcalgo,jrcalgo from,jrcalgo to"
    assert [row.partition(",")[0] for row in rows[1:]] == ["hold", "linear"]
    assert {file.suffix for file in (tmp_path / "paper").glob("all-sets.*")} == {
        *(".csv", ".tex", ".svg", ".pdf")
    }


def test_only_what_learned_from_people_is_judged_by_other_coefficients() -> None:
    names = ["hold", "switched", "kinematic", "kinematic-adaptive"]
    assert judged_on(sample(), names) == names
    assert [entry.name for entry in benchmark_sets()] == ["kh2017", "gofitts_demo", "jrcalgo"]
