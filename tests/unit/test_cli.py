"""The command line as a person and a script meet it: help, errors in one line, exit codes."""

from __future__ import annotations

import inspect
import json
import os
import re
import subprocess
import sys
from typing import Any

import pytest
import typer
from typer.main import get_command

import pointpred
from evidence.reference.pages import walked
from pointpred import __version__
from pointpred.cli import predictors as predictors_module
from pointpred.cli.app import SUMMARIES, app
from pointpred.cli.help_text import add_help
from pointpred.registry import REGISTRY, parameters

COMMANDS = ("score", "measures", "simulate", "convert", "predictors", "serve")
GROUPED = (("datasets", "list"), ("datasets", "fetch"))


def test_version(command) -> None:
    assert command("--version") == (0, f"pointpred {__version__}\n", "")


@pytest.mark.parametrize("words", [*((name,) for name in COMMANDS), *GROUPED], ids=" ".join)
def test_help_teaches_by_example(command, words: tuple[str, ...]) -> None:
    left = command(*words, "--help")
    assert left.code == 0
    examples = [line for line in left.out.splitlines() if line.strip().startswith("pointpred ")]
    assert any(line.strip().startswith(f"pointpred {' '.join(words)}") for line in examples)


EVERY = {tuple(words.split()[1:]): one for words, one in walked(get_command(app), "pointpred")}


def test_there_are_no_more_options_than_somebody_can_look_through() -> None:
    named = {word for one in EVERY.values() for each in one.params for word in each.opts if word[:2] == "--"}
    assert len(named) <= 70


@pytest.mark.parametrize("name", SUMMARIES)
def test_the_list_of_commands_says_what_each_says_of_itself(name: str) -> None:
    listed = vars(get_command(app))["commands"][name]
    assert (listed.loaded().help or "").split("\n\n")[0] == listed.help == SUMMARIES[name]


@pytest.mark.parametrize("columns", ["60", "80", "100"])
@pytest.mark.parametrize("words", EVERY, ids=" ".join)
def test_examples_can_be_copied_whatever_the_terminal(
    command, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...], columns: str
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    left = command(*words, "--help")
    written = (inspect.getdoc(EVERY[words].callback) or "").partition("Try:")[2].split("\n")
    examples = [line.strip() for line in written if line.strip()]
    shown = [line.strip() for line in left.out.partition("Try:")[2].splitlines() if line.strip()]
    assert shown == examples != []


@pytest.mark.parametrize("words", EVERY, ids=" ".join)
def test_help_at_80_columns_is_not_cut_and_names_no_type_of_python(
    command, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...]
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    help_text = command(*words, "--help").out
    assert "…" not in help_text
    assert re.findall(r"<(?:bool|str|int|float|list|path|file|dir|auto)[^>=]*>", help_text) == []


def test_brackets_of_a_docstring_are_shown(capsys: pytest.CaptureFixture[str]) -> None:
    def one() -> None:
        """Install pointpred[train]."""

    small = typer.Typer()
    small.command()(one)
    add_help(small)
    get_command(small).main(["--help"], standalone_mode=False)
    assert "pointpred[train]." in capsys.readouterr().out


def test_help_flows_into_the_width_of_the_terminal(command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    lines = [line.strip() for line in command("simulate", "--help").out.splitlines()]
    assert "2000 counts per inch. The recording is marked as simulated, and so is every" in lines


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["scor"], "scor"),
        (["predictors", "hol"], "did you mean 'hold'?"),
        (["score", "--predictors", "hold,swiched"], "unknown predictor 'swiched'"),
        (["score", "--predictors", "foo"], "unknown predictor 'foo'. Known: hold, "),
        (["score", "--predictors", " , "], "--predictors needs names"),
        (["score", "--threads", "0"], "--threads"),
        (["score", "no_such_file.csv"], "no_such_file.csv"),
        (["score", "--json", "no/such/folder/out.json"], "no/such/folder/out.json"),
        (["serve", "--port", "70000"], "--port"),
        (["serve", "--colour", "red"], "--colour"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_use_is_one_readable_line_and_2(command, arguments: list[str], said: str) -> None:
    left = command(*arguments)
    assert left.code == 2
    assert left.out == ""
    assert said in left.err
    assert left.err.startswith("pointpred: ")
    assert len(left.err.splitlines()) == 1


def test_a_host_that_can_be_none_is_told_in_words(command) -> None:
    left = command("serve", "--host", "a..b", "--port", "0")
    assert left.code == 1
    assert "'a..b'" in left.err


def test_without_a_command_it_says_what_to_do_first(command) -> None:
    left = command()
    assert (left.code, left.err) == (2, "")
    assert "  pointpred score " in left.out
    assert "pointpred --help" in left.out


def test_the_shell_completes_commands_options_and_names(monkeypatch: pytest.MonkeyPatch) -> None:
    for typed, wanted in (
        ("pointpred sco", {"score"}),
        ("pointpred devices w", {"watch"}),
        ("pointpred score --predic", {"--predictors"}),
        ("pointpred predictors kinematic-a", {"kinematic-adaptive"}),
        ("pointpred score --predictors hold,min", {"hold,minimum-jerk"}),
        ("pointpred datasets fetch gofitts", {"gofitts_demo"}),
    ):
        words = {"COMP_WORDS": typed, "COMP_CWORD": str(len(typed.split()) - 1)}
        asked = {**os.environ, **words, "_POINTPRED_COMPLETE": "complete_bash"}
        command = [sys.executable, "-m", "pointpred"]
        done = subprocess.run(command, env=asked, capture_output=True, text=True, check=True)
        assert set(done.stdout.split()) == wanted


def test_the_traceback_is_there_for_who_asks(command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POINTPRED_DEBUG", "1")
    from pointpred.cli import main
    from pointpred.errors import ParameterError

    with pytest.raises(ParameterError):
        main(["predictors", "hol"])


def test_interrupt_while_modules_load_leaves_with_130(command, monkeypatch: pytest.MonkeyPatch) -> None:
    class Loading:
        @property
        def main(self) -> None:
            raise KeyboardInterrupt

    monkeypatch.setitem(sys.modules, "pointpred.cli.app", Loading())
    assert command("predictors") == (130, "", "pointpred: interrupted\n")


def test_interrupt_leaves_with_130(command, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(name: str) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(predictors_module, "describe", interrupted)
    assert command("predictors").code == 130


def test_predictors_lists_every_name(command) -> None:
    left = command("predictors")
    assert left.code == 0
    first_words = {line.split()[0] for line in left.out.splitlines() if line.strip()}
    assert REGISTRY.keys() <= first_words


@pytest.mark.parametrize("name", REGISTRY)
def test_predictors_shows_every_parameter(command, name: str) -> None:
    left = command("predictors", name)
    assert left.code == 0
    shown = {line.split()[0] for line in left.out.splitlines() if line.strip()}
    assert parameters(name).keys() <= shown


def test_predictors_as_json_says_what_the_registry_says(command) -> None:
    document = json.loads(command("predictors", "--json").out)
    assert document["version"] == 1
    assert [one["name"] for one in document["predictors"]] == list(REGISTRY)
    for one in document["predictors"]:
        said = {p["name"]: (p["unit"], p["low"], p["high"], p["default"]) for p in one["parameters"]}
        meant = {k: (p.unit, p.low, p.high, value) for k, (p, value) in parameters(one["name"]).items()}
        assert said == meant


def test_a_reader_who_leaves_early_is_no_failure() -> None:
    run = subprocess.Popen(
        [sys.executable, "-m", "pointpred", "predictors", "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    assert run.stdout is not None
    assert run.stderr is not None
    run.stdout.close()
    complaint = run.stderr.read()
    run.stderr.close()
    assert (run.wait(), complaint) == (0, b"")


HEAVY = ("pandas", "matplotlib", "statsmodels", "fastapi", "uvicorn", "pyarrow")


@pytest.mark.parametrize(
    ("arguments", "allowed"),
    [
        (["--help"], ()),
        (["predictors"], ()),
        (["score", "--json", os.devnull], ("pyarrow",)),
        (["serve", "--help"], ()),
    ],
    ids=lambda value: " ".join(value),
)
def test_nothing_heavy_is_imported_without_need(arguments: list[str], allowed: tuple[str, ...]) -> None:
    code = (
        "import sys\nfrom pointpred.cli import main\n"
        f"try: main({arguments!r})\nexcept SystemExit as left: assert not left.code, left.code\n"
        f"found = [name for name in {HEAVY!r} if name in sys.modules]\n"
        "sys.stderr.write(f'HEAVY {found}')"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    found = run.stderr.rpartition("HEAVY ")[2]
    assert found == str([name for name in HEAVY if name in allowed])


def test_the_list_of_commands_loads_no_command_and_no_arrays() -> None:
    code = (
        "import sys\nfrom pointpred.cli import main\n"
        "try: main(['--help'])\nexcept SystemExit: pass\n"
        "loaded = {'numpy', 'pydantic', 'pointpred.registry', 'pointpred.cli.score'} & set(sys.modules)\n"
        "sys.stderr.write(f'{loaded}')"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stderr == "set()"


def test_the_package_loads_nothing_before_the_command_can_catch_an_interrupt() -> None:
    code = "import sys, pointpred.cli; print({'numpy', 'typer'} & set(sys.modules))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == "set()\n"


def test_rooms_of_the_package_are_its_attributes() -> None:
    package: Any = pointpred
    assert package.__getattr__("targets") is sys.modules["pointpred.targets"]
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = package.nothing
