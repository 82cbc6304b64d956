"""``pointpred camera simulate`` and ``run``: what they write, what they print, and what they refuse."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pointpred_observers.camera import CameraColumns, Gravity
from pointpred_observers.cli import write_table
from pointpred_observers.cli.camera_files import read_samples

FOCAL = ("--focal-px", "800")


@pytest.fixture
def simulated(tmp_path: Path, command: Callable) -> Path:
    out = tmp_path / "paper.csv"
    left = command("camera", "simulate", *FOCAL, "--out", out, "--seconds", "6")
    assert left.code == 0, left.err
    assert left.out.split() == [str(out), str(tmp_path / "paper_truth.csv")]
    table = read_samples(out).table.copy()
    table[7::10, 1:3] = np.nan  # images that are missing
    write_table(out, CameraColumns.names, table)
    return out


def test_what_is_written_is_read_back_bit_for_bit(simulated: Path) -> None:
    samples = read_samples(simulated)
    assert len(samples) == 199
    assert 0 < np.isnan(samples.x).sum() < 40
    again = simulated.with_name("again.csv")
    write_table(again, CameraColumns.names, samples.table)
    assert again.read_bytes() == simulated.read_bytes()


def test_run_tells_depth_velocity_errors_and_what_to_believe(simulated: Path, command: Callable) -> None:
    truth, plot, out = (simulated.with_name(name) for name in ("paper_truth.csv", "p.svg", "p.json"))
    start = ("--start", "0.25,-0.4")
    left = command("camera", "run", simulated, *FOCAL, *start, truth, "--plot", plot, "--json", out)
    assert left.code == 0, left.err
    assert "observer, unchecked" in left.out
    assert left.out.count("filter") > 5
    said = json.loads(out.read_text())
    assert said["samples"] == 199
    assert said["filter_started_s"] < 3.0
    assert said["rmse"]["peer"]["vz"] < 0.05 < said["rmse"]["observer"]["vz"]
    assert abs(1.0 / said["last"]["peer_chi"] - 2.99) < 0.15
    drawn = plot.read_text()
    assert drawn.startswith("<svg")
    assert "truth" in drawn
    assert "depth Z" in drawn


def test_an_approaching_camera_is_told_to_be_so(tmp_path: Path, command: Callable) -> None:
    out = tmp_path / "near.csv"
    command("camera", "simulate", "approaching", *FOCAL, "--out", out)
    left = command("camera", "run", out, *FOCAL, "--start", "4,-0.4")
    assert "filter; observer not detectable" in left.out.splitlines()[-1]


@pytest.mark.parametrize("scenario", ["stationary", "rotating"])
def test_a_camera_that_rests_checks_no_wrong_start(tmp_path: Path, command: Callable, scenario: str) -> None:
    """Told to recede by 0.4 m/s, the observer has no witness: the filter never starts, nothing is flagged."""
    out = tmp_path / "rest.csv"
    command("camera", "simulate", scenario, *FOCAL, "--out", out, "--seconds", "4")
    left = command("camera", "run", out, *FOCAL, "--start", "2,-0.4")
    rows = left.out.splitlines()[1:]
    assert len(rows) == 11
    assert all(row.rstrip().endswith("observer, unchecked") for row in rows)


@pytest.mark.parametrize("given", ["0,-1,0", "rest", "columns"])
def test_gravity_is_removed(simulated: Path, command: Callable, given: str) -> None:
    """Of a camera that turns too little to matter here: the depth is that of the file without gravity."""
    samples, g = read_samples(simulated), 9.80665
    up = np.array([0.0, -1.0, 0.0])
    table, names = samples.table.copy(), CameraColumns.names
    if given == "rest":  # the first sample is taken at rest
        table[0, 6:] = 0.0
    turned = Gravity(up=up).run(CameraColumns(np.hstack([table[:, :6], np.zeros((len(table), 3))])))
    ups = -turned.table[:, 6:] / g
    table[:, 6:] += g * ups
    if given == "columns":
        table, names = np.hstack([table, ups]), (*names, "ux", "uy", "uz")
    felt = simulated.with_name("felt.csv")
    write_table(felt, names, table)
    options = () if given == "columns" else ("--up", given)
    last = []
    for file, more in ((simulated, ()), (felt, options)):
        left = command("camera", "run", file, *FOCAL, "--start", "1,-0.3", "--json", "-", *more)
        assert left.code == 0, left.err
        last.append(json.loads(left.out)["last"]["chi"])
    assert last[0] == pytest.approx(last[1], rel=0.03 if given == "rest" else 1e-9)
    for wrong in ("up", "0,-1", "0,0,0"):
        assert "up" in command("camera", "run", felt, *FOCAL, "--up", wrong).err


@pytest.mark.parametrize(
    ("change", "code", "said"),
    [
        (("--start", "0"), 2, "--start: the depth must be positive"),
        (("--start", "1,2,3"), 2, "--start needs a depth in m, or DEPTH,VELOCITY"),
        (("--focal-px", "-1"), 2, "focal_px must lie in"),
        (("--noise", "nan"), 2, "--noise must not be negative, received nan"),
    ],
)
def test_wrong_use_is_told_in_a_line(
    simulated: Path, command: Callable, change: tuple[str, str], code: int, said: str
) -> None:
    left = command("camera", "run", simulated, *FOCAL, *change)
    assert left.code == code
    assert said in left.err
    assert left.err.count("\n") == 1


def test_files_that_cannot_be_used_name_the_place(simulated: Path, command: Callable) -> None:
    lines = simulated.read_text().splitlines()

    def run(changed: list[str]) -> str:
        simulated.write_text("\n".join(changed) + "\n")
        left = command("camera", "run", simulated, *FOCAL)
        assert left.code == 1
        return left.err

    assert "the header lacks az" in run([line.rpartition(",")[0] for line in lines])
    assert "line 5: wx is no number: 'fast'" in run([*lines[:4], "0.09,1,1,fast,0,0,0,0,0", *lines[5:]])
    assert "line 5: t is empty, only x and y may be" in run([*lines[:4], ",1,1,0,0,0,0,0,0", *lines[5:]])
    assert "row 3: t must increase" in run([*lines[:4], lines[3], *lines[5:]])
    assert "needs at least 2 rows, received 1" in run(lines[:2])


def test_what_is_no_csv_is_named(simulated: Path, command: Callable) -> None:
    simulated.write_bytes(b"\x89PNG\r\n\x1a\n\0")
    left = command("camera", "run", simulated, *FOCAL)
    assert left.code == 1
    assert f"{simulated}: is no CSV file in UTF-8" in left.err
    assert left.err.count("\n") == 1


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("0.0,0,0,0,0", "row 0: depth_m must be positive, received 0.0"),
        ("0.0,1,0,0,inf", "row 0: vz must be finite, received inf"),
        ("0.0,1,0,0,0,7", "line 2: has more fields than the header"),
    ],
)
def test_a_truth_that_cannot_be_is_named(simulated: Path, command: Callable, line: str, said: str) -> None:
    truth = simulated.with_name("paper_truth.csv")
    lines = truth.read_text().splitlines()
    truth.write_text("\n".join([lines[0], line, *lines[2:]]) + "\n")
    left = command("camera", "run", simulated, *FOCAL, truth)
    assert left.code == 1
    assert f"{truth}" in left.err
    assert said in left.err
    assert left.err.count("\n") == 1


@pytest.mark.parametrize("option", ["--plot", "--json"])
def test_results_replace_no_input(simulated: Path, command: Callable, option: str) -> None:
    truth = simulated.with_name("paper_truth.csv")
    for source in (simulated, truth):
        before = source.read_bytes()
        left = command("camera", "run", simulated, *FOCAL, truth, option, source)
        assert left.code == 2
        assert f"{option} {source} would replace" in left.err
        assert source.read_bytes() == before


def test_simulate_replaces_nothing_unasked(simulated: Path, command: Callable) -> None:
    left = command("camera", "simulate", *FOCAL, "--out", simulated)
    assert left.code == 2
    assert "exists: choose another --out, or --force" in left.err
    assert command("camera", "simulate", *FOCAL, "--out", simulated, "--force", "--seconds", "1").code == 0
    assert "SCENARIO must be one of" in command("camera", "simulate", "x", *FOCAL).err
    assert "Missing option" in command("camera", "simulate").err
