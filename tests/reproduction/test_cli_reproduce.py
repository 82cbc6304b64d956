"""``pointpred reproduce``: what it prints, draws and writes, and what it refuses before any work."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from pointpred import extras
from pointpred.recordings import write
from pointpred.reproduction import catalogue
from pointpred.reproduction.catalogue import ENTRIES
from pointpred.reproduction.trials import CONDITION, novice_and_expert
from pointpred.simulation import simulate_circle


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_the_list_has_every_number_and_what_it_may_read(command: Callable) -> None:
    left = command("reproduce")
    assert left.code == 0
    lines = {line.split()[0]: line for line in left.out.splitlines()[1:]}
    assert set(ENTRIES) <= set(lines)
    assert "can read a recording" in lines["2.12"]
    assert lines["1.1"].rstrip().endswith("diagram")


def test_a_figure_is_drawn_with_its_numbers_beside_the_print(command: Callable, tmp_path: Path) -> None:
    left = command("reproduce", "2.11", "--json", "numbers.json")
    assert left.code == 0, left.err
    assert (tmp_path / "thesis-2.11.svg").read_text(encoding="utf-8").startswith("<svg")
    numbers = json.loads((tmp_path / "numbers.json").read_text())
    assert numbers["number"] == "2.11"
    named = {value["name"]: value for value in numbers["values"]}
    assert named["T^ at the peak"] == {
        "name": "T^ at the peak", "printed": "1", "ours": pytest.approx(1.0), "unit": "", "agrees": True,
    }  # fmt: skip
    assert "What differs: Nothing differs." in left.out
    again = command("reproduce", "2.11")
    assert again.code == 2
    assert "--force" in again.err
    assert command("reproduce", "2.11", "--force").code == 0


def test_a_diagram_says_which_part_of_the_library_it_is(command: Callable, tmp_path: Path) -> None:
    left = command("reproduce", "2.4")
    assert left.code == 0
    assert "switched-printed" in left.out
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("3.44",), "did you mean"),
        (("2.11", "x.csv"), "leave x.csv out"),
        (("2.2", "missing.csv"), "missing.csv"),
        (("2.11", "--out", "figure.png"), ".svg"),
        (("2.11", "--out", "nowhere/figure.svg"), "nowhere"),
    ],
)
def test_what_cannot_be_made_is_refused_in_one_line(
    command: Callable, tmp_path: Path, arguments: tuple[str, ...], words: str
) -> None:
    left = command("reproduce", *arguments)
    assert left.code == 2
    assert words in left.err
    assert len(left.err.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


def test_a_missing_extra_is_named_with_its_command_before_any_work(
    command: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(extras, "find_spec", lambda name: None if name == "matplotlib" else name)
    left = command("reproduce", "2.11")
    assert left.code == 1
    assert "matplotlib" in left.err
    assert extras.install_command("report") in left.err
    assert list(tmp_path.iterdir()) == []


def test_the_list_and_the_diagrams_need_no_extra() -> None:
    """With every optional library gone, in a process of its own."""
    names = {name for libraries in extras.EXTRAS.values() for name in libraries}
    code = (
        f"import sys; sys.modules.update(dict.fromkeys({names!r}))\n"
        "from pointpred.cli import main\n"
        "main(['reproduce'])"
    )
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    assert "2.13" in ran.stdout


def test_without_the_observers_the_figures_that_need_them_are_named(
    command: Callable, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(catalogue, "find_spec", lambda name: None)
    monkeypatch.setattr(catalogue, "ENTRIES", {entry.number: entry for entry in catalogue.LISTED})
    said = "figures of chapters 3 and 4 and of the camera paper need pointpred-observers: "
    wanted = f"{said}{extras.install_command(of='pointpred-observers')}"
    listed = command("reproduce")
    assert listed.code == 0
    assert wanted in listed.err
    left = command("reproduce", "3.4")
    assert left.code == 2
    assert wanted in left.err
    assert command("reproduce", "2.4").code == 0


def test_a_recording_takes_the_place_of_simulated_people(command: Callable, tmp_path: Path) -> None:
    recording = simulate_circle(novice_and_expert(), [CONDITION], seed=5, trials=4, name="study")
    provenance = msgspec.structs.replace(recording.provenance, simulated=False)
    recording = msgspec.structs.replace(recording, provenance=provenance)
    file = write(recording, tmp_path / "study_samples.csv")[0]
    for number in ("2.2", "2.9"):
        left = command("reproduce", number, file)
        assert left.code == 0, left.err
        assert "from: study" in left.out
        assert (tmp_path / f"thesis-{number}.svg").exists()


@pytest.mark.parametrize(("number", "hint"), [("", ""), ("3.40", "did you mean 3.4")])
def test_a_number_that_is_none_gets_one_sentence(command: Callable, number: str, hint: str) -> None:
    left = command("reproduce", number)
    assert left.code == 2
    assert f"no figure or table {number!r}; {hint}" in left.err
    assert left.err.endswith("'pointpred reproduce' lists all\n")
    assert hint or "; 'pointpred" in left.err
