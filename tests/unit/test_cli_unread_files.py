"""What a person is told of a folder in which some files cannot be read."""

from __future__ import annotations

from pathlib import Path

import pytest

from pointpred.cli.score_tables import print_sets
from pointpred.recordings import read_any
from pointpred.scoring import score, summarise


def test_each_file_that_is_not_read_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = [f"{trial},{10 * at},{at},{at}" for trial in range(3) for at in range(5)]
    (tmp_path / "good.csv").write_text(
        "\n".join(["trial,t_ms,x,y", *rows, *(f"{at},0,b,1" for at in range(3))])
    )
    names = [f"bad{at}.json" for at in range(8)]
    for at, name in enumerate(names):
        (tmp_path / name).write_text('{"a": ' + "[" * (at + 1))
    [recording] = read_any(tmp_path)
    print_sets([summarise(scored) for scored in score([recording], ["hold"])])
    said = capsys.readouterr().err
    assert [name for name in names if f"{name}: " not in said] == []
    assert "other reasons" not in said
