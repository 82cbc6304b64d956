"""``pointpred measures``: what it prints and writes, and what it says where something is missing."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from PIL import Image

from pointpred.datasets import sample
from pointpred.measures import COLUMNS, measure
from pointpred.recording import Recording, Trial
from pointpred.recordings import write
from tests.building import reach, text_file


def study(folder: Path, distances: tuple[float, ...] = (200.0, 400.0), name: str = "study") -> Path:
    """Two people, three trials a distance: ends that spread, every third beside the target."""
    parts, trials = [], []
    for number in range(6 * len(distances)):
        far, off = distances[number % len(distances)], (-4.0, 0.0, 13.0)[number // len(distances) % 3]
        parts.append(reach((0.0, 0.0), (far + off, off)))
        about: dict[str, str | float] = {"distance": float(number % len(distances)), "phase": "main"}
        trials.append(
            Trial("ann" if number < 3 * len(distances) else "bob", str(number), far, 0.0, 20.0, None, about)
        )
    return write(Recording.of(name, parts, trials), folder / f"{name}_samples.csv")[0]


def test_the_document_and_the_tables_hold_the_same(command: Any, tmp_path: Path) -> None:
    out, document = tmp_path / "trials.csv", tmp_path / "all.json"
    left = command("measures", study(tmp_path), "--out", out, "--json", document)
    assert left.code == 0, left.err
    assert f"measures: {out}" in left.err
    trials = pd.read_csv(out)
    assert list(trials.columns[:5]) == ["dataset", "user", "trial", "distance", "phase"]
    assert list(trials.columns[5:]) == list(COLUMNS[3:])
    (one,) = json.loads(document.read_text())["sets"]
    assert (one["name"], one["trials"], one["users"], one["regression"]) == ("study", 12, 2, None)
    assert [(row["user"], row["distance"], row["trials"]) for row in one["groups"]] == [
        (user, distance, 3) for user in ("ann", "bob") for distance in (0.0, 1.0)
    ]
    assert one["throughput"]["error_rate"] == pytest.approx(trials["error"].mean()) == pytest.approx(1 / 3)
    lines = left.out.splitlines()
    assert lines[0] == "study: 12 trials, 2 people"
    assert lines[1].startswith("medians: from start to selection 0.74 s, until the onset ")
    assert [line.split()[:4] for line in lines if line.startswith("0 ")] == [["0", "20", "6", "33.3%"]]
    assert [line.split()[:3] for line in lines if line.startswith("bob")] == [["bob", "6", "33.3%"]]
    said = next(line for line in lines if line.startswith("all: "))
    assert f"{one['throughput']['throughput_bits_s']:.2f} bits/s" in said


def test_parquet_holds_what_python_makes(command: Any, tmp_path: Path) -> None:
    assert command("measures", "--out", tmp_path / "t.parquet").code == 0
    assert pd.read_parquet(tmp_path / "t.parquet").equals(measure(sample()).to_pandas())


def test_a_table_of_trials_is_written_again_with_force(command: Any, tmp_path: Path) -> None:
    for _ in range(2):
        assert command("measures", study(tmp_path), "--out", tmp_path / "t.csv", "--force").code == 0
    left = command("measures", study(tmp_path), "--out", tmp_path / "study_samples.csv", "--force")
    assert left.code == 2


@pytest.mark.parametrize("ending", ["svg", "png", "pdf"])
def test_the_line_is_drawn_for_each_set(command: Any, tmp_path: Path, ending: str) -> None:
    file = tmp_path / f"fitts.{ending}"
    left = command("measures", "sample", study(tmp_path, (200.0, 300.0, 450.0)), "--plot", file)
    assert left.code == 0, left.err
    assert "time = 0.701 s + 0.177 s/bit x ID, R2 = 0.948, 8 conditions" in left.out
    if ending == "svg":
        svg = file.read_text(encoding="utf-8")
        assert "simulated-circle: 0.70 + 0.177 ID, R² = 0.948" in svg
        assert "study: " in svg
    elif ending == "png":
        with Image.open(file) as picture:
            assert len(np.unique(np.asarray(picture.convert("L")))) > 20
    else:
        assert file.read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--out", "t.txt"], 2, "--out must name a file that ends in .csv, .parquet, received t.txt"),
        (["--plot", "t.jpg"], 2, "--plot must name a file that ends in .svg, .png, .pdf, received t.jpg"),
        (["--by", "device"], 2, "no column 'device'; the conditions are: distance, phase"),
        (["--by", "trial"], 0, "12 of 12 conditions of a person hold one trial"),
        (
            ["--by", "phase"],
            0,
            "2 of 2 conditions of a person hold targets at distances that differ (200",
        ),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_what_cannot_be_done_is_said(
    command: Any, tmp_path: Path, words: list[str], code: int, said: str
) -> None:
    left = command("measures", study(tmp_path), *words)
    assert (left.code, said in left.err) == (code, True), left.err


def test_recordings_without_targets_are_measured_and_not_drawn(command: Any, tmp_path: Path) -> None:
    rows = "".join(f"u,1,{k / 100},{x:.0f},5\n" for k, x in enumerate(reach((0.0, 0.0), (300.0, 0.0)).x))
    file = text_file(tmp_path / "plain.csv", "user,trial,t_s,x_px,y_px\n" + rows)
    left = command("measures", file, "--json", "-")
    assert left.code == 0
    (one,) = json.loads(left.out)["sets"]
    assert (one["trials"], one["throughput"], one["groups"]) == (1, None, [])
    assert "no throughput" in command("measures", file).err
    left = command("measures", file, "--plot", tmp_path / "f.svg")
    assert (left.code, "nothing to draw" in left.err) == (1, True)


def test_nothing_measured_is_a_failure_with_reasons(command: Any, tmp_path: Path) -> None:
    text_file(tmp_path / "bad.csv", "nothing\n")
    left = command("measures", tmp_path / "bad.csv", "--json", "-")
    assert left.code == 1
    assert json.loads(left.out)["unread"][0]["file"].endswith("bad.csv")
    assert "no trial could be measured" in left.err


def test_practice_is_left_out_where_asked(command: Any, tmp_path: Path) -> None:
    out = tmp_path / "all.csv"
    every = json.loads(command("measures", "sample", "--json", "-").out)["sets"][0]["trials"]
    left = command("measures", "sample", "--where", "distance_mm == 75", "--out", out, "--json", "-")
    found = json.loads(left.out)["sets"][0]["trials"]
    assert 0 < found < every
    assert set(pd.read_csv(out)["distance_mm"]) == {75.0}
    wrong = command("measures", "sample", "--where", "distance_m == 75")
    assert wrong.code == 2
    assert "did you mean distance_mm" in wrong.err
