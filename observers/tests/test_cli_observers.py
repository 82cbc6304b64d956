"""``pointpred observers``: what is written, printed and refused, as somebody at a terminal meets it."""

from __future__ import annotations

import csv
import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import pointpred_observers as o
from pointpred_observers.cli.observer_results import EXAMPLES
from pointpred_observers.files import decoded, encoded
from tests.conftest import Left

GUIDE = Path(__file__).parents[1] / "docs" / "own-plant.md"

Command = Callable[..., Left]


@pytest.fixture
def motor(command: Command, tmp_path: Path) -> Path:
    assert command("observers", "example", "motor", "--out", tmp_path / "motor.json").code == 0
    left = command("observers", "design", tmp_path / "motor.json", "--decay", "5")
    assert (left.code, "motor_design.json" in left.err) == (0, True)
    return tmp_path / "motor_design.json"


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_example_is_a_plant_that_can_be_changed(command: Command, name: str) -> None:
    left = command("observers", "example", name)
    assert left.code == 0
    assert encoded(decoded(left.out)) == left.out.encode()


def test_the_motor_of_the_guide_is_the_one_that_is_written(command: Command) -> None:
    page = GUIDE.read_text(encoding="utf-8")
    (block,) = re.findall(r"```json\n(.*?)```", page, re.DOTALL)
    assert encoded(decoded(block)).decode() == command("observers", "example", "motor").out
    (call,) = re.findall(r">>> motor = (Persidskii\(.*?\n\.\.\. \))", page, re.DOTALL)
    motor = eval(call.replace("\n...", "\n"), {"Persidskii": o.Persidskii})
    assert encoded(motor) == encoded(decoded(block))


def test_design_audit_and_simulate_from_files(command: Command, motor: Path, tmp_path: Path) -> None:
    audited = command("observers", "audit", motor, "--json", "-")
    numbers = json.loads(audited.out)
    assert audited.code == 0
    assert numbers["margins"] == o.audit(o.load(motor))
    assert numbers["bounds"]["error"]["decay"] >= 5.0
    pytest.importorskip("matplotlib")
    left = command(
        "observers", "simulate", motor, "--input", "sin(2*t)", "--noise", "0.01", "--start", "0.5,0,0",
        "--seconds", "4",
        "--plot", tmp_path / "motor.png", "--out", tmp_path / "motor.csv",
    )  # fmt: skip
    assert left.code == 0
    assert "RMSE" in left.out
    assert (tmp_path / "motor.png").read_bytes().startswith(b"\x89PNG")
    design = o.load(motor)
    result = o.simulate(
        design.observer.plant, design, times=0.01 * np.arange(401), input=lambda t: np.sin(2.0 * t),
        noise=0.01, start=[0.5, 0.0, 0.0],
    )  # fmt: skip
    with (tmp_path / "motor.csv").open(newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(row["x2_estimate"]) for row in rows] == result.estimate[:, 1].tolist()
    assert [float(row["u1"]) for row in rows] == result.input[:, 0].tolist()


KINDS = [
    ("motor", "reduced", ()),
    ("motor", "full", ("--kind", "full")),
    ("pendulum", "reduced", ()),
    ("pendulum", "regulator", ("--kind", "regulator", "--decay", "0.5")),
    ("tank", "reduced", ("--decay", "0.1")),
    ("wing", "unknown-input", ("--decay", "0.5")),
]


@pytest.mark.parametrize(("name", "kind", "options"), KINDS, ids=[f"{row[0]} {row[1]}" for row in KINDS])
def test_every_kind_is_designed_and_simulated(
    command: Command, tmp_path: Path, name: str, kind: str, options: tuple[str, ...]
) -> None:
    plant, design = tmp_path / "plant.json", tmp_path / "design.json"
    command("observers", "example", name, "--out", plant)
    left = command("observers", "design", plant, *options, "--out", design)
    assert left.code == 0, left.err
    assert kind in left.out
    length = ("--seconds", "50" if name == "tank" else "2")
    extra = ("--unknown-input", "1", "--parameter", "k=2+0.5*sin(t)") if name == "wing" else ()
    run = command("observers", "simulate", design, *length, *extra, "--json", "-")
    assert run.code == 0, run.err
    assert all(
        one["last"] < one["first"] + 1e-9 or one["first"] == 0.0 for one in json.loads(run.out)["states"]
    )


def test_both_bounds_of_a_regulator_are_written_and_named(command: Command, tmp_path: Path) -> None:
    """Neither bounds x: the table had those of the slower one as if they bounded it."""
    plant = o.Persidskii([[0.0, 1.0], [-1.0, -1.0]], None, None, "sin", [0.0, 1.0], None, [1.0, 0.0])
    design = o.design(plant, "regulator", decay=1.0, observer_decay=3.0)
    o.save(design, tmp_path / "design.json")
    written = json.loads(command("observers", "audit", tmp_path / "design.json", "--json", "-").out)
    error, estimate = design.observer.bound, design.feedback.certificate.bound
    assert list(written["bounds"]) == ["x - Pi w", "Pi w"]
    for name, bound in (("x - Pi w", error), ("Pi w", estimate)):
        one = written["bounds"][name]
        assert (one["decay"], one["overshoot"]) == (bound.decay, bound.overshoot)
        assert tuple(one["gains"].values()) == bound.gains
    shown = " ".join(command("observers", "audit", tmp_path / "design.json").out.split())
    for words in ("proved of x - Pi w", "proved of Pi w", f"{error.decay:.6g}", f"{estimate.decay:.6g}"):
        assert words in shown


def test_plants_with_a_generator(command: Command, tmp_path: Path) -> None:
    for name in ("oven", "heating", "spring", "oscillator"):
        command("observers", "example", name, "--out", tmp_path / f"{name}.json")
    left = command("observers", "design", tmp_path / "oven.json", tmp_path / "heating.json")
    assert (left.code, "driven observer" in left.out) == (0, True)
    words = ("--upper", "1", "--first", "w1", "--decay", "0.5")
    generator, spring = tmp_path / "oscillator.json", tmp_path / "spring.json"
    needs = (
        "spring.json: equations need the file of their generator as GENERATOR, --upper and --first, received"
    )
    refused(command, 2, f"{needs} no GENERATOR and no --first", "design", spring)
    refused(command, 2, f"{needs} no GENERATOR", "design", spring, *words)
    refused(command, 2, f"{needs} no --first", "design", spring, generator, "--upper", "1")
    left = command("observers", "design", tmp_path / "spring.json", generator, *words)
    assert (left.code, "interlaced observer" in left.out) == (0, True)
    for name in ("oven", "spring"):
        left = command(
            "observers", "simulate", tmp_path / f"{name}_design.json", "--seconds", "20", "--json", "-"
        )
        assert left.code == 0
        assert all(one["last"] < 0.2 for one in json.loads(left.out)["states"])


def test_a_warning_is_a_plain_line(command: Command, tmp_path: Path) -> None:
    """It was printed with a path of the source, and a line of it."""
    command("observers", "example", "wing", "--out", tmp_path / "wing.json")
    assert command("observers", "design", tmp_path / "wing.json", "--decay", "0.5").code == 0
    design = tmp_path / "wing_design.json"
    left = command("observers", "simulate", design, "--parameter", "k=2+sin(t)*2")
    assert (left.code, "RMSE" in left.out) == (0, True)
    assert left.err.startswith("schedule leaves the box of the design at ")
    assert left.err.endswith("what is proved of the error does not cover them\n")
    assert left.err.count("\n") == 1


def refused(command: Command, code: int, words: str, *arguments: str | Path) -> None:
    left = command("observers", *arguments)
    assert left.code == code
    assert left.out == ""
    assert words in left.err
    assert left.err.count("\n") == 1


def test_what_cannot_be_done_is_one_line_and_an_exit_code(
    command: Command, motor: Path, tmp_path: Path
) -> None:
    plant = tmp_path / "motor.json"
    refused(command, 2, "PLANT must be one of these", "example", "robot")
    refused(command, 2, "exists: choose another --out, or --force", "example", "motor", "--out", plant)
    refused(command, 2, "exists: choose another --out, or --force", "design", plant)
    refused(command, 2, "kind must be one of", "design", plant, "--kind", "kalman", "--force")
    refused(command, 2, "kind 'driven' needs generator", "design", plant, "--kind", "driven", "--force")
    refused(command, 2, "a plant must be a Persidskii system or a linear one", "design", motor)
    refused(command, 2, "design an observer first", "simulate", plant)
    refused(command, 2, "--input must be a function of t", "simulate", motor, "--input", "sin(x)")
    refused(command, 2, "--input: '1/t' has no value at t = 0", "simulate", motor, "--input", "1/t")
    refused(command, 2, "start must be 3 numbers", "simulate", motor, "--start", "1,2")
    refused(command, 2, "--seconds must be finite", "simulate", motor, "--seconds", "0")
    refused(command, 2, "--parameter needs NAME=EXPRESSION", "simulate", motor, "--parameter", "k")
    refused(command, 2, ".svg, .png, .pdf", "simulate", motor, "--plot", tmp_path / "motor.bmp")
    refused(command, 2, "is no JSON", "audit", __file__)
    content = json.loads(motor.read_text(encoding="utf-8"))
    broken = tmp_path / "broken.json"
    broken.write_text(json.dumps({**content, "Upsilon": [[-9.0], [900.0]]}), encoding="utf-8")
    refused(command, 1, "broken.json: Theorem 3.3.1", "audit", broken)
    blind = json.loads(plant.read_text(encoding="utf-8")) | {"C0": [[0.0, 0.0, 1.0]]}
    plant.write_text(json.dumps(blind), encoding="utf-8")
    refused(command, 1, "never shows", "design", plant, "--force")
    assert sorted(one.name for one in tmp_path.iterdir()) == [
        "broken.json",
        "motor.json",
        "motor_design.json",
    ]


def test_an_option_that_would_be_ignored_is_refused(command: Command, motor: Path, tmp_path: Path) -> None:
    plant, tank = tmp_path / "motor.json", tmp_path / "tank.json"
    assert command("observers", "example", "tank", "--out", tank).code == 0
    assert command("observers", "design", tank, "--decay", "0.1").code == 0
    design = tmp_path / "tank_design.json"
    refused(command, 2, "--seconds must be a whole number", "simulate", design, "--seconds", "7.5")
    words = "is no option of kind 'reduced', which has Pi"
    refused(command, 2, f"upper {words}", "design", plant, "--upper", "1", "--force")
    generator = (tank, "--kind", "full")
    refused(command, 2, "generator is no option of kind 'full'", "design", plant, *generator, "--force")


def test_the_help_of_each_command_can_be_followed(command: Command) -> None:
    left = command("observers", "--help")
    assert left.code == 0
    for name in ("design", "audit", "simulate", "example"):
        assert re.search(rf"\b{name}\b", left.out)
        assert f"pointpred observers {name}" in command("observers", name, "--help").out


def test_the_installed_command_does_the_same(motor: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "pointpred", "observers", "audit", str(motor)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "decays at least at [1/s]" in done.stdout


def names(folder: Path, read: Path) -> list[str]:
    """A file by its path, by another path, by a link to it and by another name of it."""
    link, twin = folder / "link.json", folder / "twin.json"
    link.symlink_to(read)
    twin.hardlink_to(read)
    return [str(read), f"{read.parent}/./{read.name}", str(link), str(twin)]


def test_no_command_replaces_what_it_reads(command: Command, tmp_path: Path) -> None:
    plant, design, generator = (tmp_path / f"{name}.json" for name in ("tank", "design", "heating"))
    other = tmp_path / "other.json"
    assert command("observers", "example", "tank", "--out", plant).code == 0
    assert command("observers", "example", "heating", "--out", generator).code == 0
    o.save(o.design(o.load(plant), "full", decay=0.1), design)
    (tmp_path / "motor.json").write_bytes(plant.read_bytes())
    before = {one: one.read_bytes() for one in (plant, design, generator)}
    driven = ("design", plant, generator)
    calls: list[tuple[tuple[str | Path, ...], str, Path]] = [
        (("design", plant, "--out", other), "--json", plant),
        (("design", plant), "--out", plant),
        (driven, "--out", generator),
        ((*driven, "--out", other), "--json", generator),
        (("audit", design), "--json", design),
        (("simulate", design), "--json", design),
        (("simulate", design), "--out", design),
    ]
    for number, (arguments, option, read) in enumerate(calls):
        folder = tmp_path / str(number)
        folder.mkdir()
        for name in names(folder, read):
            force = () if arguments[0] == "audit" else ("--force",)
            words = f"{option} {Path(name)} would replace a file that this command reads; name another file"
            refused(command, 2, words, *arguments, option, name, *force)
    assert {one: one.read_bytes() for one in before} == before
    assert not other.exists()
