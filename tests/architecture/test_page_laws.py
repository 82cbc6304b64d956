"""The modules of the page are what the translator makes of the laws."""

from __future__ import annotations

from pathlib import Path

import pytest

from translation.modules import texts, write

FOLDER = Path(__file__).parents[2] / "server" / "pointpred_server" / "web" / "laws"


def test_the_files_in_the_repository_are_up_to_date() -> None:
    expected = texts()
    present = {path.relative_to(FOLDER).as_posix() for path in FOLDER.rglob("*") if path.is_file()}
    assert present == set(expected), "run `make laws`"
    for name, content in expected.items():
        assert (FOLDER / name).read_bytes() == content, f"{name} is out of date: run `make laws`"


def test_writing_removes_what_is_no_longer_made(tmp_path: Path) -> None:
    old = tmp_path / "predictors" / "gone.js"
    old.parent.mkdir()
    old.write_text("export const GONE = 1;")
    write(tmp_path)
    assert not old.exists()
    assert (tmp_path / "predictors" / "switched.js").is_file()


@pytest.mark.parametrize("name", ["registry.js", "predictors/switched.js", "arithmetic.js", "kinematic.f32"])
def test_what_the_page_needs_is_written(name: str) -> None:
    assert name in texts()
