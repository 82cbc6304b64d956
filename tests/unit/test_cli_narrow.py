"""What a terminal of 80 columns shows: a row of a table is a line, and nothing is cut."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from pointpred import console
from pointpred.cli import score_tables
from pointpred.cli.doctor import Finding
from pointpred.datasets import listing
from pointpred.devices.udev import RELOAD, RULES_FILE, hid_rule, permission_advice
from pointpred.recording import Recording
from pointpred.recordings import write
from pointpred.records import EventColumns
from pointpred.registry import REGISTRY
from pointpred.scoring import HEADINGS, rows, score, summarise
from tests import building

COLUMNS = 80


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    """Results go to a terminal of 80 columns, wherever they really go."""

    def narrow() -> console.Console:
        return console.PlainConsole(width=COLUMNS, force_terminal=True, color_system=None)

    for name, module in list(sys.modules.items()):
        if name.startswith(("pointpred.cli.", "pointpred.console")) and hasattr(module, "results"):
            monkeypatch.setattr(module, "results", narrow)


def recording(trials: int) -> Recording:
    t = [0.0, 0.1, 0.2, 0.3]
    parts = [EventColumns.of(t=t, x=[0.0, 1.0, 60.0, 101.0 + i], y=[0.0] * 4) for i in range(trials)]
    return building.recording(parts, "walk")


def lines_of(text: str) -> list[str]:
    lines = text.splitlines()
    assert max(map(len, lines)) <= COLUMNS
    assert "…" not in text
    return lines


@pytest.mark.usefixtures("terminal")
def test_scores_have_a_line_each(capsys: pytest.CaptureFixture[str]) -> None:
    described = summarise(score([recording(3)], list(REGISTRY))[0])
    score_tables.print_sets([described])
    lines = lines_of(capsys.readouterr().out)
    first = next(i for i, line in enumerate(lines) if line.startswith("predictor "))
    table = lines[first + 1 : first + 1 + len(REGISTRY)]
    assert [line.split()[0] for line in table] == list(REGISTRY)
    assert all(line.split()[-1].endswith("%") for line in table)


@pytest.mark.usefixtures("terminal")
def test_measures_have_a_line_each(command: Any) -> None:
    lines = lines_of(command("measures").out)
    assert sum(line.startswith("p") and line[1:3].isdigit() for line in lines) == 10
    assert sum(line.endswith(" ID  bits/s") for line in lines) == 2


@pytest.mark.usefixtures("terminal")
def test_datasets_have_a_line_each_and_how_to_get_them(command: Any) -> None:
    lines = lines_of(command("datasets", "list").out.replace(listing()[8].page, ""))
    for one in listing():
        (row,) = (line for line in lines if line.split()[0] == one.name)
        assert (f"fetch {one.name}" in row) == one.fetchable
        assert one.fetchable or any(line.startswith(f"{one.name}:") for line in lines)


@pytest.mark.usefixtures("terminal")
@pytest.mark.parametrize("words", [["predictors"], ["predictors", "switched"]])
def test_predictors_fit(command: Any, words: list[str]) -> None:
    assert lines_of(command(*words).out)


@pytest.mark.usefixtures("terminal")
def test_choices_of_targets_fit(command: Any, tmp_path: Path) -> None:
    from pointpred.datasets import sample

    whole = sample()
    some = Recording.of("some", [whole.rows(k) for k in range(13)], whole.trials[:13])
    file = write(some, tmp_path / "some_samples.csv")[0]
    left = command("score", file, "--targets", "--predictors", "hold")
    assert left.code == 0
    lines = lines_of(left.out)
    assert sum(line.startswith("nearest to the cursor ") for line in lines) == 2 * sum(
        line.startswith("some: ") and " movement" in line for line in lines
    )
    assert any(line.startswith("hold + targets ") for line in lines)


@pytest.mark.usefixtures("terminal")
def test_lines_to_copy_are_never_wrapped(capsys: pytest.CaptureFixture[str]) -> None:
    rule = hid_rule(0x46D, 0xC077, mouse_interface=True)
    closed = [
        Finding("mice, hidraw", "missing", "closed", permission_advice(rule)),
        Finding("port", "missing", "in use", "take another one"),
    ]
    import_module("pointpred.cli.doctor").show(closed)
    lines = [line.strip() for line in capsys.readouterr().out.splitlines()]
    assert len(rule) > COLUMNS
    assert rule in lines
    assert f"pointpred devices udev | sudo tee {RULES_FILE}" in lines
    assert RELOAD in lines
    assert any(line.endswith("-> take another one") for line in lines)


def test_one_trial_has_no_interval() -> None:
    place = HEADINGS.index("95 % interval")
    for trials, wanted in ((1, False), (2, True)):
        cells = [row[place] for row in rows(summarise(score([recording(trials)], ["hold", "linear"])[0]))]
        assert [cell != "-" for cell in cells] == [wanted, wanted]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["score", "--threads", "0"], ["--threads", "at least 1", "'0'"]),
        (["score", "--threads", "many"], ["--threads", "whole number", "'many'"]),
        (["live", "--seconds", "x"], ["--seconds", "a number", "'x'"]),
        (["live", "--cursor", "there"], ["--cursor", "'there'", "'motor'"]),
        (["serve", "--port", "70000"], ["port", "at most 65535", "--port or POINTPRED_PORT"]),
        (["convert"], ["source"]),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_a_wrong_value_is_answered_in_our_words(command: Any, arguments: list[str], said: list[str]) -> None:
    left = command(*arguments)
    assert left.code == 2
    assert [word for word in said if word not in left.err] == []
    assert "Input should" not in left.err
    assert "error" not in left.err.lower()
