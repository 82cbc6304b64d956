"""An extra that is missing: the command that installs it is one a shell takes, for the Python that runs."""

from __future__ import annotations

import json
import shlex
import sys
from importlib.metadata import PackageNotFoundError
from pathlib import Path
from typing import Any

import pytest

from pointpred import extras
from pointpred.errors import MissingExtraError, RecordingError
from pointpred.recordings.writing import write
from pointpred.training import train
from tests.unit.test_training import reaches


class Installed:
    """A distribution that was installed from somewhere."""

    def __init__(self, record: object) -> None:
        self.record = record

    def read_text(self, name: str) -> str | None:
        assert name == "direct_url.json"
        return None if self.record is None else json.dumps(self.record)


def installed(monkeypatch: pytest.MonkeyPatch, record: object) -> list[str]:
    monkeypatch.setattr(extras, "distribution", lambda name: Installed(record))
    return shlex.split(extras.install_command("report"))


def test_a_checkout_is_installed_again_with_the_extra(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    folder = tmp_path / "my sources"
    words = installed(monkeypatch, {"url": folder.as_uri(), "dir_info": {"editable": True}})
    assert words == [sys.executable, "-m", "pip", "install", "-e", f"{folder}[report]"]


def test_another_distribution_of_the_checkout_lies_in_a_folder_of_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    record = {"url": tmp_path.as_uri(), "dir_info": {"editable": True}}
    monkeypatch.setattr(extras, "distribution", lambda name: Installed(record))
    words = shlex.split(extras.install_command(of="pointpred-observers"))
    assert words[-2:] == ["-e", str(tmp_path / "observers")]
    monkeypatch.setattr(extras, "distribution", lambda name: Installed(None))
    assert shlex.split(extras.install_command(of="pointpred-observers"))[-1] == "pointpred-observers"


@pytest.mark.parametrize("record", [None, {"url": "file:///a", "dir_info": {}}, {"url": "https://a/b.whl"}])
def test_a_package_is_installed_by_its_name(monkeypatch: pytest.MonkeyPatch, record: object) -> None:
    assert installed(monkeypatch, record) == [sys.executable, "-m", "pip", "install", "pointpred[report]"]


def test_sources_that_were_never_installed_have_a_command_too(monkeypatch: pytest.MonkeyPatch) -> None:
    def none(name: str) -> Any:
        raise PackageNotFoundError(name)

    monkeypatch.setattr(extras, "distribution", none)
    assert shlex.split(extras.install_command("train"))[-1] == "pointpred[train]"


def test_training_without_scipy_says_so_before_it_reads_anything(
    command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(extras, "find_spec", lambda name: None if name == "scipy" else name)
    monkeypatch.setattr("pointpred.cli.train.in_memory", lambda *_: pytest.fail("read first"))
    file = write(reaches(60), tmp_path / "me_samples.csv")[0]
    left = command("train", file, "--out", tmp_path / "me.npz")
    assert left.code == 1
    assert len(left.err.splitlines()) == 1
    assert extras.install_command("train") in left.err
    with pytest.raises(MissingExtraError, match="scipy"):
        train.train_custom([reaches(60)], tmp_path / "me.npz")


def test_too_few_movements_are_refused_before_any_work(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(train, "training_data", lambda *_: pytest.fail("worked first"))
    with pytest.raises(RecordingError, match="50 movements at least, there are 49"):
        train.train_custom([reaches(49)], tmp_path / "me.npz")
