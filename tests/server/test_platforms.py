"""Nothing needs what only Unix has: the package runs with what Windows would give it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import pointpred
from pointpred.recordings.writing import file_names
from pointpred_server import listening
from pointpred_server.listening import listen
from tests.server import elsewhere

DEVICES = {"con", "prn", "aux", "nul"} | {f"{port}{n}" for port in ("com", "lpt") for n in range(10)}


def test_everything_is_imported_served_recorded_and_scored_without_unix(tmp_path: Path) -> None:
    command = [sys.executable, "-X", "warn_default_encoding", elsewhere.__file__, str(tmp_path)]
    root = str(Path(pointpred.__file__).parent.parent)
    ended = subprocess.run(command, capture_output=True, text=True, env=os.environ | {"PYTHONPATH": root})
    assert ended.returncode == 0, ended.stderr
    told = json.loads(ended.stdout)
    assert told["modules"] > 200
    assert told == {**told, "page": True, "x": 59.0, "code": 0, "trials": 1}
    assert {path.name.rpartition("_")[2] for path in tmp_path.glob("*.csv")} == {
        "samples.csv",
        "trials.csv",
        "predictions.csv",
    }


def test_a_port_that_the_system_keeps_for_itself_is_passed_over(monkeypatch: pytest.MonkeyPatch) -> None:
    bind, asked = listening._bind, []

    def refuse_first(host: str, port: int) -> object:
        asked.append(port)
        if len(asked) == 1:
            raise PermissionError(13, "Permission denied")
        return bind(host, 0)

    monkeypatch.setattr(listening, "_bind", refuse_first)
    with listen("127.0.0.1", 8765, tries=2):
        assert asked == [8765, 8766]


@pytest.mark.parametrize("name", ["con", "NUL", "Com1", "lpt9", "aux.x", "con ", "prn."])
def test_no_file_has_the_name_of_a_device_of_windows(name: str) -> None:
    (made,) = file_names([name], "all.csv")
    stem = made.split(".")[0].strip().lower()
    assert stem not in DEVICES
    assert made.endswith("_all.csv")


@pytest.mark.parametrize("name", ['a:b?c*d<e>f|g"h', "back\\slash", "tab\tnew\nline", "ends. ", " . "])
def test_no_file_has_characters_that_windows_refuses(name: str) -> None:
    (made,) = file_names([name], "all.csv")
    assert not set(made) & set('<>:"/\\|?*\t\n')
    assert made == made.strip(". ")
