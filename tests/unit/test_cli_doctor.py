"""``pointpred doctor``: each line is true, and each that is bad says what to do next."""

from __future__ import annotations

import json
import socket
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from pointpred import compiled, extras
from pointpred.cli.doctor import CHECKS, Finding, run_check
from pointpred.devices.source import DeviceInfo
from pointpred.errors import SourceError

DOCTOR = import_module("pointpred.cli.doctor")
SERVE = import_module("pointpred_server.cli.serve")


def findings(command: Any) -> dict[str, dict[str, Any]]:
    left = command("doctor", "--json")
    told = json.loads(left.out)
    assert told["version"] == 1
    assert left.code == (1 if any(one["state"] == "broken" for one in told["findings"]) else 0)
    return {one["name"]: one for one in told["findings"]}


def test_every_look_is_told_and_what_is_not_good_says_what_to_do(command: Any) -> None:
    found = findings(command)
    optional = {"extra report", "pointpred-observers"}
    assert {"python", "prediction", "laws", *optional, "cursor", "port"} <= found.keys()
    assert found["prediction"]["state"] == "good"
    for one in found.values():
        assert (one["state"] == "good") == (one["advice"] is None), one


def test_the_table_says_the_same(command: Any) -> None:
    left = command("doctor")
    assert left.code == 0
    assert left.err == ""
    for name in findings(command):
        assert name in left.out


def test_a_missing_extra_has_its_install_line(command: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extras, "find_spec", lambda module: None if module == "statsmodels" else module)
    one = findings(command)["extra report"]
    assert one["found"] == "without statsmodels"
    assert one["state"] == "missing"
    assert extras.install_command("report") in one["advice"]


@pytest.mark.parametrize("folder", ["no/such/folder", "a_file"])
def test_a_folder_that_is_none_is_broken(
    command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, folder: str
) -> None:
    (tmp_path / "a_file").write_text("")
    monkeypatch.setenv("POINTPRED_RECORDINGS", str(tmp_path / folder))
    one = findings(command)["folder, recordings for tests and training"]
    assert one["state"] == "broken"
    assert str(tmp_path / folder) in one["found"]
    assert "unset it" in one["advice"]


def test_a_folder_that_is_there_is_good(
    command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("POINTPRED_RECORDINGS", str(tmp_path))
    one = findings(command)["folder, recordings for tests and training"]
    assert (one["state"], one["found"]) == ("good", str(tmp_path))


def test_a_port_in_use_is_told_with_the_one_that_is_taken(
    command: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        used = taken.getsockname()[1]
        monkeypatch.setattr(SERVE, "PORT", used)
        said = findings(command)["port"]["found"]
        assert said.startswith(f"{used} is in use; 'pointpred serve' takes ")
        monkeypatch.setattr(SERVE, "TRIES", 1)
        one = findings(command)["port"]
    assert one["state"] == "broken"
    assert "--port 0" in one["advice"]


def test_laws_that_are_not_compiled_are_told_with_what_to_do(
    command: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compiled, "COMPILED", True)
    assert findings(command)["laws"]["state"] == "good"
    monkeypatch.setattr(compiled, "COMPILED", False)
    for value, advice in (("0", "unset POINTPRED_COMPILED"), ("1", "install a C compiler")):
        monkeypatch.setenv("POINTPRED_COMPILED", value)
        one = findings(command)["laws"]
        assert one["state"] == "missing"
        assert one["advice"].startswith(advice)


def test_without_a_screen_the_cursor_says_so(command: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "XDG_SESSION_TYPE"):
        monkeypatch.delenv(name, raising=False)
    one = findings(command)["cursor"]
    assert one["state"] == "missing"
    assert "DISPLAY is not set" in one["advice"]


def test_a_look_that_fails_is_a_finding() -> None:
    def cellar() -> list[Finding]:
        raise SourceError("the door is locked")

    (one,) = run_check(cellar)
    assert (one.name, one.state) == ("cellar", "broken")
    assert "the door is locked" in one.found
    assert all(look.__doc__ for look in CHECKS)


@pytest.mark.parametrize(
    ("mice", "state", "found", "advice"),
    [
        ([], "missing", "none found", "plug one in"),
        ([DeviceInfo("/dev/a", "A", "hid", True)], "good", "1 mouse, 0 closed", None),
        (
            [DeviceInfo("/dev/a", "A", "hid", False, "permission denied", "write the rule")],
            "missing",
            "1 mouse, 1 closed: permission denied",
            "write the rule",
        ),
        (
            [DeviceInfo("/dev/a", "A", "hid", True), DeviceInfo("/dev/b", "B", "hid", False, "why", "do")],
            "good",
            "2 devices, 1 closed",
            None,
        ),
    ],
)
def test_mice_are_counted_and_closed_ones_say_what_to_do(
    monkeypatch: pytest.MonkeyPatch, mice: list[DeviceInfo], state: str, found: str, advice: str | None
) -> None:
    monkeypatch.setattr("pointpred.devices.hidraw.list_hid", lambda: mice)
    one = DOCTOR.devices()[0]
    assert (one.name, one.state, one.found) == ("mice, hidraw", state, found)
    assert (one.advice or "").startswith(advice or "")
    assert (advice is None) == (one.advice is None)
