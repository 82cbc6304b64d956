"""Names and targets from a hostile world: nothing is replaced, nothing crashes, nothing steers a terminal."""

from __future__ import annotations

import json
import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest
import typer

from pointpred.console import plain
from tests.building import text_file

HEADER = "user,trial,t_s,x_px,y_px\n"
ROWS = "u,1,0,0,0\nu,1,0.1,1,0\nu,1,0.2,60,0\nu,1,0.3,101,0\n"
COMMAND = (sys.executable, "-m", "pointpred", "score", "--predictors", "hold")


def named(folder: Path, file: str, name: str) -> Path:
    header = json.dumps({"version": 1, "name": name})
    return text_file(folder / file, f"# pointpred:{header}\n{HEADER}{ROWS}")


@pytest.fixture
def good(tmp_path: Path) -> Path:
    text_file(tmp_path / "good_trials.csv", "user,trial,target_x\nu,1,100\n")
    return text_file(tmp_path / "good.csv", HEADER + ROWS)


@pytest.mark.parametrize("option", ["--json", "--report"])
@pytest.mark.parametrize("target", ["good.csv", "link.csv", "good_trials.csv", "other.csv"])
def test_no_recording_is_replaced_by_its_scores(
    command, good: Path, tmp_path: Path, option: str, target: str
) -> None:
    (tmp_path / "other.csv").write_text(HEADER + ROWS)
    (tmp_path / "link.csv").symlink_to(good)
    before = (tmp_path / target).read_bytes()
    left = command("score", good, "--predictors", "hold", option, tmp_path / target)
    assert left.code == 2
    assert f"{option} {tmp_path / target} would replace" in left.err
    assert (tmp_path / target).read_bytes() == before


def test_json_and_report_need_two_files_and_both_may_be_written_again(
    command, good: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    left = command("score", good, "--json", out, "--report", tmp_path / "." / "out")
    assert left.code == 2
    assert "--report and --json both name" in left.err
    for _ in range(2):
        both = ("--json", out, "--report", tmp_path / "out.html", "--force")
        assert command("score", good, "--predictors", "hold", *both).code == 0


def test_a_name_is_no_path(command, tmp_path: Path) -> None:
    source = tmp_path / "in"
    source.mkdir()
    for file, name in (("a.csv", "lab/x"), ("b.csv", "../../x"), ("c.csv", "lab:x"), ("d.csv", "\x00")):
        named(source, file, name)
    left = command("convert", source, "--out", tmp_path / "all.csv")
    assert left.code == 0, left.err
    written = sorted(file.name for file in tmp_path.glob("*_samples.csv"))
    assert written == [
        "_.._x_all_samples.csv",
        "__all_samples.csv",
        "lab_x_2_all_samples.csv",
        "lab_x_all_samples.csv",
    ]


@pytest.mark.parametrize("name", ["[/x]", "[red]x[/red]", "a\x1b[2Jb\x07"])
def test_a_name_neither_crashes_nor_steers_a_terminal(name: str, tmp_path: Path) -> None:
    path = named(tmp_path, "study.csv", name)
    ours, theirs = pty.openpty()
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "150"}
    left = subprocess.run([*COMMAND, path], stdout=theirs, stderr=theirs, env=environment, check=False)
    os.close(theirs)
    said = b""
    while True:
        try:
            said += os.read(ours, 1 << 16)
        except OSError:  # the other end is closed and everything is read
            break
    os.close(ours)
    assert left.returncode == 0
    assert plain(name).encode() in said
    assert b"\x1b[2J" not in said
    assert b"\x07" not in said


def test_a_file_name_that_is_no_text_is_scored_on_any_terminal(good: Path, tmp_path: Path) -> None:
    path = os.fsencode(tmp_path) + b"/bad\xff\xc3\xa9.csv"
    Path(os.fsdecode(path)).write_text(HEADER + ROWS)
    broken = os.fsencode(tmp_path) + b"/broken\xff.csv"
    Path(os.fsdecode(broken)).write_text("nothing\n")
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    for more in ((), ("--json", "-")):
        left = subprocess.run(
            [*COMMAND, path, broken, *more], capture_output=True, env=environment, check=False
        )
        assert left.returncode == 0, left.stderr
        assert b"Traceback" not in left.stderr
    document = json.loads(left.stdout.decode("utf-8"))
    assert document["sets"][0]["name"] == "bad\N{REPLACEMENT CHARACTER}\N{LATIN SMALL LETTER E WITH ACUTE}"
    assert document["unread"][0]["file"].endswith("broken\N{REPLACEMENT CHARACTER}.csv")


def test_closed_streams_are_no_failure(good: Path) -> None:
    for closed in (">&-", "2>&-", "<&-"):
        left = subprocess.run(
            ["sh", "-c", f'"$@" {closed}', "sh", *COMMAND, good], capture_output=True, check=False
        )
        assert left.returncode == 0, left.stderr
        assert b"Traceback" not in left.stderr


def test_a_pipe_is_refused_in_words(command, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    left = command("score", tmp_path / "pipe.csv")
    assert left.code == 1
    assert "write it to a file first" in left.err


def test_simulate_refuses_an_unknown_ending_before_it_works(command, tmp_path: Path) -> None:
    left = command("simulate", "--people", "1000", "--out", tmp_path / "x.txt")
    assert (left.code, left.out) == (2, "")
    assert "cannot write .txt, expected .parquet or .csv" in left.err


def test_everything_in_a_folder_is_accounted_for(
    command, good: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "dangling.csv").symlink_to(tmp_path / "nowhere")
    (tmp_path / "again").symlink_to(tmp_path)
    (tmp_path / "closed").mkdir()
    os.mkfifo(tmp_path / "pipe")
    seen = os.scandir

    def scandir(place: str) -> object:
        if str(place).endswith("closed"):
            raise PermissionError(13, "Permission denied", place)
        return seen(place)

    monkeypatch.setattr(os, "scandir", scandir)
    left = command("score", tmp_path, "--predictors", "hold", "--json", "-")
    (one,) = json.loads(left.out)["sets"]
    assert one["skipped"] == []
    assert one["notes"] == [
        "again is a link to a folder: not followed",
        "closed cannot be read: Permission denied",
        "dangling.csv is a link to nothing",
        "pipe is no file that can be read twice",
    ]


def test_an_interrupted_command_says_so_without_a_traceback(command, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise typer.Abort

    monkeypatch.setattr("pointpred.cli.score.predictor_names", interrupted)
    left = command("score")
    assert left.code == 130
    assert left.err.strip() == "pointpred: interrupted"
