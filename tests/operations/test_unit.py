"""The unit of systemd in deploy/: systemd accepts it, it is hardened, and our own command line reads it."""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
from configparser import RawConfigParser
from pathlib import Path

import pytest
from typer.testing import CliRunner

from pointpred.cli.app import app
from pointpred_server.listening import END_S
from pointpred_server.service import WRITE_S
from pointpred_server.settings import Settings
from tests.operations.monitoring import DEPLOY

UNIT, ENVIRONMENT = DEPLOY / "pointpred@.service", DEPLOY / "pointpred.env"
EXPOSURE = 1.2
"""Of 10, as systemd 252 rates it; docs/guide/operations.md names it."""

needs_systemd = pytest.mark.skipif(
    shutil.which("systemd-analyze") is None,
    reason="systemd-analyze (Debian package systemd) is not installed",
)


def service_section() -> dict[str, str]:
    """What the template sets; of a name that is given twice, the last one."""
    parser = RawConfigParser(strict=False, interpolation=None)
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    parser.read(UNIT)
    return dict(parser["Service"])


@needs_systemd
def test_systemd_accepts_the_unit(tmp_path: Path) -> None:
    """With a program that exists: the example's own is installed by whoever copies it."""
    unit = tmp_path / UNIT.name
    program = shlex.split(service_section()["ExecStart"])[0]
    unit.write_text(UNIT.read_text().replace(program, str(shutil.which("true"))))
    done = subprocess.run(["systemd-analyze", "verify", unit], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")


@needs_systemd
def test_the_unit_is_as_hardened_as_the_guide_says() -> None:
    command = [
        "systemd-analyze",
        "security",
        "--offline=true",
        "--no-pager",
        f"--threshold={EXPOSURE * 10:g}",
        UNIT,
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if "unrecognized option" in done.stderr:
        pytest.skip("this systemd cannot rate a unit that is not loaded; 250 or later can")
    assert done.returncode == 0, done.stdout.splitlines()[-1]
    guide = (DEPLOY.parent / "docs" / "guide" / "operations.md").read_text(encoding="utf-8")
    assert f"rates the exposure {EXPOSURE} of 10" in guide


def test_the_command_of_the_unit_is_one_of_ours() -> None:
    program, *words = shlex.split(service_section()["ExecStart"].replace("%i", "8765"))
    assert Path(program).name == "pointpred"
    ports = dict(zip(words[1::2], words[2::2], strict=True))
    assert (ports["--port"], ports["--metrics-port"]) == ("8765", "18765")
    result = CliRunner().invoke(app, [*words, "--help"])
    assert result.exit_code == 0, result.output
    result = CliRunner().invoke(
        app, [*words, "--port", "99999"]
    )  # read, and refused before anything is opened
    assert "--port" in str(result.exception)
    assert "No such option" not in result.output


def test_the_environment_file_names_settings_that_exist_and_holds_no_token(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    lines = re.findall(r"^#?(POINTPRED_(\w+))=(.*)$", ENVIRONMENT.read_text(), re.MULTILINE)
    assert {name.lower() for _, name, _ in lines} <= Settings.model_fields.keys()
    for variable, _, value in lines:
        if variable == "POINTPRED_TOKEN":
            assert value == ""
        else:
            monkeypatch.setenv(variable, value)
    settings = Settings()
    assert (settings.host, settings.token) == ("127.0.0.1", None)
    assert "TOKEN" not in UNIT.read_text().replace("POINTPRED_TOKEN among them", "")


def test_systemd_waits_longer_than_the_service_takes_to_stop() -> None:
    section = service_section()
    assert float(section["TimeoutStopSec"]) > END_S + WRITE_S
