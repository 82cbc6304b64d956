"""A report says which line installs what it needs, before anything is scored."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from pointpred import extras
from pointpred.cli.app import app
from pointpred.errors import MissingExtraError
from pointpred.scoring.report import write_report


@pytest.fixture
def bare(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extras, "find_spec", lambda name: None if name == "statsmodels" else name)


def test_a_report_without_its_extra_names_the_line(bare: None, tmp_path: Path) -> None:
    with pytest.raises(MissingExtraError, match=r"statsmodels\. .*-m pip install .*\[report\]"):
        write_report([], tmp_path / "out.html")


def test_the_command_says_so_at_once(bare: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred.scoring.score", lambda *_, **__: pytest.fail("scored first"))
    ran = CliRunner().invoke(app, ["score", "--report", str(tmp_path / "out.html")])
    assert ran.exit_code != 0
    assert isinstance(ran.exception, MissingExtraError | SystemExit)
    assert not (tmp_path / "out.html").exists()
