"""The word ``sample`` is the embedded sample wherever a recording is read, unless a file has that name."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from pointpred.cli.reading_options import reading, recordings_in
from pointpred.datasets import sample
from pointpred.recordings import read, write
from tests.unit.test_training import reaches


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_score_and_convert_read_the_sample(command: Any, folder: Path) -> None:
    left = command("score", "sample", "--predictors", "hold", "--json", "-")
    (one,) = json.loads(left.out)["sets"]
    assert (left.code, one["name"], one["simulated"]) == (0, sample().name, True)
    assert command("convert", "sample", "--out", "copy_samples.csv").code == 0
    assert len(read(folder / "copy_samples.csv").trials) == len(sample().trials)


def test_convert_joins_the_sample_with_files(command: Any, folder: Path) -> None:
    write(sample(), folder / "mine_samples.parquet")
    for people, users in (("column", 10), ("file", 2)):
        out = f"{people}_samples.parquet"
        left = command("convert", "sample", "mine_samples.parquet", "--join", people, "--out", out)
        assert left.code == 0, left.err
        trials = read(folder / out).trials
        assert len(trials) == 2 * len(sample().trials)
        assert len({one.user for one in trials}) == users


def test_train_reads_the_sample(command: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    heard: list[str] = []

    def stop(recordings: list[Any], *_: Any, **__: Any) -> None:
        heard.extend(one.name for one in recordings)
        raise KeyboardInterrupt

    monkeypatch.setattr("pointpred.training.train.train_custom", stop)
    command("train", "sample", "--out", "me.npz")
    assert heard == [sample().name]


def test_a_file_of_that_name_comes_first(folder: Path) -> None:
    write(reaches(3), folder / "mine_samples.csv")
    (folder / "sample").mkdir()
    for file in folder.glob("mine_*.csv"):
        file.rename(folder / "sample" / file.name)
    (one,) = recordings_in(Path("sample"), reading())
    assert len(one.trials) == 3


@pytest.mark.parametrize(
    "words",
    [
        ["score", "sample", "none.csv"],
        ["train", "none.csv", "--out", "me.npz"],
        ["convert", "none.csv", "--out", "a_samples.csv"],
        ["replay", "none.csv", "--to", "ws://127.0.0.1:1"],
    ],
)
def test_a_file_that_is_not_there_is_named(command: Any, words: list[str]) -> None:
    left = command(*words)
    assert (left.code, left.out) == (2, "")
    assert left.err.startswith("pointpred: no such file: none.csv")


def test_a_report_is_told_of_last_and_not_advertised(
    command: Any, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    order: list[str] = []
    monkeypatch.setattr("pointpred.scoring.report.write_report", lambda *_, **__: order.append("drawn"))
    left = command("score", "sample", "--predictors", "hold", "--report", "out.html")
    assert left.code == 0
    assert order == ["drawn"]
    assert "--report" not in left.out + left.err
    assert left.err.splitlines()[-1] == "report written: out.html"
    assert "--report" in command("score", "sample", "--predictors", "hold").out


def test_a_replay_says_nothing_of_delays_and_of_a_gain(command: Any) -> None:
    left = command("live", "--replay", "sample", "--trial", "1", "--speed", "max")
    assert left.code == 0
    assert "delay" not in left.out + left.err
    assert "gain: " not in left.out
    (device,) = (line for line in left.err.splitlines() if line.startswith("device: "))
    assert device.count("sample") == 1
