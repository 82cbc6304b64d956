"""The files of C and JavaScript are what the translator makes of the laws, and the C is compiled."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

from pointpred.compiled import COMPILED
from translation.entries import entry_texts
from translation.modules import texts, write
from translation.stages import descriptions_text

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "server" / "pointpred_server" / "web" / "lib" / "laws"
C = {"pointpred": ROOT / "pointpred/laws", "pointpred_observers": ROOT / "observers/pointpred_observers/laws"}
TRANSLATE = """
import json, sys
from translation.c_files import texts
print(json.dumps(texts(sys.argv[1])))
"""


@pytest.mark.parametrize("package", C)
def test_the_c_in_the_repository_is_up_to_date_and_compiled(package: str) -> None:
    environment = os.environ | {"POINTPRED_COMPILED": "0"}
    run = [sys.executable, "-c", TRANSLATE, package]
    done = subprocess.run(run, cwd=ROOT, env=environment, stdout=subprocess.PIPE, check=True)
    expected = json.loads(done.stdout)
    assert {path.name for path in C[package].iterdir()} == set(expected), "run `make laws`"
    for name, text in expected.items():
        assert (C[package] / name).read_text("utf-8") == text, f"{name} is out of date: run `make laws`"
    if COMPILED:
        assert import_module(f"{package}._laws").__doc__ in expected["digest.c"], "run `make laws`"


def test_the_javascript_in_the_repository_is_up_to_date() -> None:
    expected = texts()
    present = {path.relative_to(PAGE).as_posix() for path in PAGE.rglob("*") if path.is_file()}
    assert present == set(expected), "run `make laws`"
    for name, content in expected.items():
        assert (PAGE / name).read_bytes() == content, f"{name} is out of date: run `make laws`"


def test_the_entries_in_the_repository_are_up_to_date() -> None:
    expected = entry_texts()
    assert {path.name for path in (PAGE.parent / "entries").iterdir()} == set(expected), "run `make laws`"
    for name, text in expected.items():
        assert (PAGE.parent / "entries" / name).read_text("utf-8") == text, f"{name}: run `make laws`"


def test_the_descriptions_in_the_repository_are_up_to_date() -> None:
    path = PAGE.parent.parent / "page" / "service" / "descriptions.js"
    assert path.read_text("utf-8") == descriptions_text(), "run `make laws`"


def test_writing_removes_what_is_no_longer_made(tmp_path: Path) -> None:
    old = tmp_path / "predictors" / "gone.js"
    old.parent.mkdir()
    old.write_text("export const GONE = 1;")
    write(tmp_path)
    assert not old.exists()
    assert (tmp_path / "predictors" / "switched.js").is_file()


@pytest.mark.parametrize("name", ["registry.js", "predictors/switched.js", "arithmetic.js", "kinematic.js"])
def test_what_the_page_needs_is_written(name: str) -> None:
    assert name in texts()
