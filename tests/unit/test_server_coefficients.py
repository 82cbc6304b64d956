"""Coefficients that a client asks for by name: it never names a path, and never learns one."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pointpred import PointerEvent, build
from pointpred.clock import Instant
from pointpred.errors import ParameterError
from pointpred.predictors.kinematic import coefficient_file
from pointpred.protocol.server_messages import Limits
from pointpred_server.cli.serve import settings_of
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.settings import Settings, named_files
from tests.unit.talking import Talk, events, hello

ROWS = [[0.01 * i, 1.0 * i * i, 0.5 * i * i, None, None, 0] for i in range(30)]
NAMES = ["kinematic", "kinematic-adaptive"]


def other(path: Path) -> Path:
    """The package's coefficients, changed."""
    with np.load(coefficient_file.OWN) as own:
        np.savez(path, **{**own, "offset2": own["offset2"] + np.float32(0.5)})
    return path


def talk_with(files: dict[str, Path], greet: dict[str, Any]) -> tuple[Talk, list[Any]]:
    talk = Talk(greet=False)
    talk.session = PointingSession("name", Limits(), Instant(0.0), coefficients=files)
    return talk, talk.say(greet)


def batch(name: str, **parameters: Any) -> tuple[float, float]:
    pipeline = build(name, **parameters)
    answers = [pipeline.update(PointerEvent(*row)) for row in ROWS]
    assert answers[-1] is not None
    return answers[-1].x, answers[-1].y


@pytest.mark.parametrize("name", NAMES)
def test_a_client_asks_for_them_by_name(name: str, tmp_path: Path) -> None:
    path = other(tmp_path / "me.npz")
    talk, _ = talk_with({"me": path}, hello(name, parameters={"coefficients": "me"}))
    (answer,) = talk.say(events(*ROWS))
    assert (answer["x"], answer["y"]) == batch(name, coefficients=path) != batch(name)
    talk.say({"type": "configure", "predictor": name})
    (answer,) = talk.say(events(*ROWS))
    assert (answer["x"], answer["y"]) == batch(name)
    talk.say({"type": "configure", "parameters": {"coefficients": "me"}})
    (answer,) = talk.say(events(*ROWS))
    assert (answer["x"], answer["y"]) == batch(name, coefficients=path)


@pytest.mark.parametrize("wanted", ["you", "", "me ", 7, True, ["me"]])
def test_an_unknown_name_is_a_bad_field_and_the_known_ones_are_named(wanted: Any, tmp_path: Path) -> None:
    path = other(tmp_path / "me.npz")
    _, (error,) = talk_with({"me": path}, hello(parameters={"coefficients": wanted}, predictor="kinematic"))
    assert error["code"] == "bad_field"
    assert error["path"].startswith("$.parameters")
    if isinstance(wanted, str):
        assert error["path"] == "$.parameters.coefficients"
        assert "me" in error["message"]


@pytest.mark.parametrize("files", [{}, {"me": coefficient_file.OWN}])
def test_a_client_never_names_a_path(files: dict[str, Path]) -> None:
    own = str(coefficient_file.OWN)
    for wanted in (own, f"../{coefficient_file.OWN.name}", "/etc/passwd"):
        _, (error,) = talk_with(files, hello("kinematic", parameters={"coefficients": wanted}))
        assert (error["code"], error["path"]) == ("bad_field", "$.parameters.coefficients")


def test_a_file_that_has_gone_is_told_without_its_path(tmp_path: Path) -> None:
    path = other(tmp_path / "me.npz")
    path.unlink()
    _, (error,) = talk_with({"me": path}, hello("kinematic", parameters={"coefficients": "me"}))
    assert (error["code"], error["path"]) == ("bad_field", "$.parameters.coefficients")
    assert str(tmp_path) not in error["message"]


def test_others_have_no_such_parameter(tmp_path: Path) -> None:
    _, (error,) = talk_with({"me": other(tmp_path / "me.npz")}, hello(parameters={"coefficients": "me"}))
    assert (error["code"], error["path"]) == ("bad_field", "$.parameters.coefficients")


def test_settings_read_the_files_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = other(tmp_path / "me.npz")
    assert Settings(coefficients={"me": path}).coefficients == {"me": path}
    monkeypatch.setenv("POINTPRED_COEFFICIENTS", json.dumps({"me": str(path)}))
    assert Settings().coefficients == {"me": path}
    monkeypatch.setenv("POINTPRED_COEFFICIENTS", f"me={path}, you={path}")
    assert Settings().coefficients == {"me": path, "you": path}
    for unreadable in ("me", f"me={path},me={path}", '{"me":', f"me={tmp_path / 'missing.npz'}"):
        monkeypatch.setenv("POINTPRED_COEFFICIENTS", unreadable)
        with pytest.raises(ParameterError, match="POINTPRED_COEFFICIENTS"):
            settings_of()
    monkeypatch.delenv("POINTPRED_COEFFICIENTS")
    (tmp_path / "text.npz").write_text("none")
    shutil.copy(path, tmp_path / "odd name.npz")
    for wrong in (
        {"me": tmp_path / "missing.npz"},
        {"me": tmp_path / "text.npz"},
        {"odd name": path},
        {"": path},
    ):
        with pytest.raises(ParameterError, match="coefficients"):
            settings_of(coefficients=wrong)


def test_the_flag_names_files(tmp_path: Path) -> None:
    assert named_files(["me=a.npz", "you=b=c.npz"]) == {"me": Path("a.npz"), "you": Path("b=c.npz")}
    for wrong in (["me"], ["=a"], ["me="], ["me=a", "me=b"]):
        with pytest.raises(ValueError, match="NAME=FILE"):
            named_files(wrong)
        with pytest.raises(ParameterError, match="NAME=FILE"):
            settings_of(coefficients=wrong)
