"""Recordings at addresses: memory, archives, a web server, and what is said where nothing can be read."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import fsspec
import numpy as np
import pytest
from typer.testing import CliRunner

from pointpred.cli.app import app
from pointpred.datasets import sample
from pointpred.errors import MissingExtraError, RecordingError
from pointpred.recordings import addresses, read_any, write
from tests.hosts import file_host


@pytest.fixture
def study(tmp_path: Path) -> Path:
    """A folder with a samples and a trials file."""
    write(sample().part(0, 12), tmp_path / "study.csv")
    return tmp_path


@pytest.fixture
def web(study: Path) -> Iterator[str]:
    """The same folder by HTTP."""
    with file_host(study) as origin:
        yield origin


def same(address: str, study: Path) -> bool:
    (there,), (here,) = read_any(address), read_any(study / "study_samples.csv")
    events = np.array_equal(there.events.table, here.events.table, equal_nan=True)
    return events and (there.name, there.trials, there.notes) == (here.name, here.trials, here.notes)


def test_a_file_and_the_trials_beside_it_are_read_from_memory_an_archive_and_the_web(
    study: Path, web: str
) -> None:
    memory = fsspec.filesystem("memory")
    with zipfile.ZipFile(study / "all.zip", "w") as archive:
        for file in study.glob("*.csv"):
            memory.pipe(f"/addresses/{file.name}", file.read_bytes())
            archive.write(file, file.name)
    assert read_any(study / "study_samples.csv")[0].trials[0].target_w > 0.0  # from the trials file
    assert same("memory://addresses/study_samples.csv", study)
    assert same(f"zip://study_samples.csv::{study / 'all.zip'}", study)
    assert same(f"{web}/study_samples.csv", study)
    assert same("memory://addresses", study)  # a folder


@pytest.mark.parametrize("name", ["study/../../outside.csv", "study//../outside.csv"])
def test_nothing_is_written_outside_the_folder_of_the_copy(
    study: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    copies = tmp_path / "copies"
    copies.mkdir()
    monkeypatch.setattr(addresses, "_folder", lambda: str(copies))
    with zipfile.ZipFile(study / "all.zip", "w") as archive:
        archive.write(study / "study_samples.csv", "study/study_samples.csv")
        archive.writestr(name, "t,x,y\n")
    with pytest.raises(RecordingError, match=r"'\.\./.*outside.csv' leads out of its folder") as caught:
        read_any(f"zip://study::{study / 'all.zip'}")
    assert caught.value.value == name.removeprefix("study").lstrip("/")
    assert not [path for path in copies.rglob("*") if path.is_file()]


def test_the_command_line_names_the_address_and_not_the_copy(study: Path, web: str) -> None:
    (study / "empty.csv").touch()
    good, bad = f"{web}/study_samples.csv", f"{web}/empty.csv"
    result = CliRunner().invoke(app, ["score", good, bad, "--predictors", "linear", "--json", "-"])
    assert result.exit_code == 0, result.output
    assert f"left out: {bad}: the file is empty" in " ".join(result.stderr.split())
    assert "pointpred-remote" not in result.output


@pytest.mark.parametrize(
    ("address", "error", "sentence"),
    [
        ("memory://addresses/none.csv", RecordingError, "memory://addresses/none.csv: no such file"),
        (
            "nowhere://a.csv",
            RecordingError,
            "nowhere://a.csv: cannot be read: ValueError: Protocol",
        ),
        ("http://127.0.0.1:1/a.csv", RecordingError, "http://127.0.0.1:1/a.csv: cannot be read"),
        ("s3://bucket/a.csv", MissingExtraError, "s3://bucket/a.csv: Install s3fs"),
    ],
)
def test_what_cannot_be_read_is_said(address: str, error: type[Exception], sentence: str) -> None:
    if address.startswith("s3") and find_spec("s3fs"):
        pytest.skip("s3fs is installed")
    with pytest.raises(error, match=sentence):
        read_any(address)


def test_without_the_extra_an_error_names_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred.extras.find_spec", lambda name: None)
    with pytest.raises(MissingExtraError, match=r"reading memory://a.csv needs fsspec.*\[remote\]"):
        read_any("memory://a.csv")


def test_a_real_path_is_no_address(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("s3:").mkdir()
    Path("s3:/a.csv").touch()
    assert addresses.address_in(Path("s3://a.csv")) is None
    assert addresses.address_in(Path("C:/a.csv")) is None


def test_absolute_addresses_and_those_within_others_are_kept_as_they_were_given(
    study: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with zipfile.ZipFile(study / "all.zip", "w") as archive:
        archive.write(study / "study_samples.csv", "study_samples.csv")
    for address in (
        f"file://{study}/study_samples.csv",
        f"zip://study_samples.csv::file://{study}/all.zip",
    ):
        assert len(read_any(Path(address))[0].events) == len(read_any(address)[0].events)
        result = CliRunner().invoke(
            app, ["convert", address, "--out", str(study / f"out_{len(address)}.csv")]
        )
        assert result.exit_code == 0, result.output
    asked: list[str] = []
    monkeypatch.setattr(addresses, "local_copy", lambda address: asked.append(address) or study)
    for kept in ("hdfs:///study.csv", "https://host/get?u=https://other/x", "s3://bucket//a.csv"):
        result = CliRunner().invoke(app, ["convert", kept, "--out", str(study / "none.csv")])
        assert asked.pop() == kept, result.output
