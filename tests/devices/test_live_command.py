"""``pointpred live`` where something is missing: what a person reads says what to do next."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest

from pointpred.cli import counts_per_inch
from pointpred.devices import selection
from pointpred.devices.first_moving import FirstMoving
from pointpred.devices.source import DeviceInfo
from pointpred.live import follow
from pointpred.transfer import ConstantGain, save_transfer

CLOSED = DeviceInfo(
    "/dev/hidraw3", "Some mouse", "hid", False, "Permission denied", "put this line into /etc/udev/rules.d/x"
)


def found(monkeypatch: pytest.MonkeyPatch, *devices: DeviceInfo) -> None:
    monkeypatch.setattr(selection, "list_hid", lambda everything=False: list(devices))
    monkeypatch.setattr(selection, "list_evdev", list)


def test_help_teaches_by_example(command: Any) -> None:
    left = command("live", "--help")
    assert left.code == 0
    assert any(line.strip().startswith("pointpred live") for line in left.out.splitlines())


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--predictor", "switchd"], "did you mean 'switched'?"),
        (["--host", "0.0.0.0"], "--host and --port need --serve"),
        (["--transfer", "magic"], "'magic' names no transfer function"),
        (["--cpi", "-1"], "cpi"),
        (["--record", "no/such/folder/a.csv"], "no/such/folder/a.csv"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_use_is_one_line_and_2(
    command: Any, monkeypatch: pytest.MonkeyPatch, arguments: list[str], said: str
) -> None:
    found(monkeypatch)
    left = command("live", *arguments)
    assert (left.code, left.out) == (2, "")
    assert said in left.err


def test_a_recording_is_never_written_over(command: Any, tmp_path: Path) -> None:
    (tmp_path / "kept.csv").write_text("precious")
    left = command("live", "--record", tmp_path / "kept.csv")
    assert left.code == 2
    assert "is there already" in left.err
    assert (tmp_path / "kept.csv").read_text() == "precious"


@pytest.mark.parametrize("asked", ["kept.csv", "kept_samples.csv"])
def test_predictions_beside_a_recording_are_never_written_over(
    command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, asked: str
) -> None:
    def choose(*asked: str | None) -> None:
        raise AssertionError("a device was looked for")

    monkeypatch.setattr(follow, "choose", choose)
    (tmp_path / "kept_predictions.csv").write_text("precious")
    left = command("live", "--record", tmp_path / asked)
    assert left.code == 2
    assert "kept_predictions.csv is there already" in left.err
    assert not (tmp_path / asked).exists()


def test_without_a_device_the_browser_is_named(command: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    found(monkeypatch)
    left = command("live", "--cpi", "800")
    assert left.code == 1
    assert "no mouse was found" in left.err
    assert "pointpred devices list" in left.err
    assert "pointpred serve" in left.err


def test_without_permission_the_rule_is_printed(command: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    found(monkeypatch, CLOSED)
    left = command("live", "--cpi", "800")
    assert left.code == 1
    assert "/dev/hidraw3 (Some mouse): Permission denied" in left.err
    assert "/etc/udev/rules.d/x" in left.err


@pytest.mark.parametrize(("system", "name"), [("win32", "Windows"), ("darwin", "macOS")])
def test_systems_that_keep_their_mice_are_told_to_use_the_page(
    command: Any, monkeypatch: pytest.MonkeyPatch, system: str, name: str
) -> None:
    monkeypatch.setattr(sys, "platform", system)
    for arguments in ([], ["--device", "/dev/hidraw0"]):
        left = command("live", "--cpi", "800", *arguments)
        assert left.code == 1
        assert name in left.err
        assert "pointpred serve" in left.err


def test_every_device_that_opens_may_be_the_one_and_a_mouse_that_is_there_twice_is_so_once(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    one, two = (DeviceInfo(f"/dev/hidraw{i}", f"mouse {i}", "hid", True) for i in range(2))
    node = DeviceInfo("/dev/input/event4", "mouse 1", "evdev", True)
    found(monkeypatch, CLOSED, one, two)
    below = tmp_path / "0003:046D:C077.0001"
    (below / "input/input9/event4").mkdir(parents=True)
    places = {two.path: below, node.path: below / "input/input9/event4", one.path: tmp_path / "another"}
    monkeypatch.setattr(selection, "_sysfs", lambda kind, one: places[one.path])
    assert selection.once_each([CLOSED, node, one, two]) == [node, one]
    source = selection.choose(None)
    assert isinstance(source, FirstMoving)
    assert [one.path for one in source._candidates()] == ["/dev/hidraw0", "/dev/hidraw1"]
    assert source.closed == (CLOSED,)
    assert selection.choose("mouse 1").path == two.path


def test_a_screen_asked_for_is_an_error_where_there_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    with pytest.raises(OSError, match="DISPLAY is not set"):
        follow.mouse_path("screen", None, 800.0, 96.0)


@pytest.mark.parametrize(
    ("where", "function", "cpi", "space"),
    [
        ("auto", None, 800.0, "motor"),
        ("auto", ConstantGain(4.0), 800.0, "transfer"),
        ("transfer", ConstantGain(4.0), 800.0, "transfer"),
        ("motor", ConstantGain(4.0), 800.0, "motor"),
    ],
)
def test_the_cursor_is_known_from_what_there_is(
    monkeypatch: pytest.MonkeyPatch, where: Any, function: Any, cpi: float, space: str
) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    opened = follow.mouse_path(where, function, cpi, 96.0)
    opened.close()
    assert opened.path.space == space


def test_a_transfer_function_without_a_resolution_is_wrong_use() -> None:
    with pytest.raises(ValueError, match="--transfer and --cpi"):
        follow.mouse_path("transfer", ConstantGain(4.0), None, 96.0)


def test_a_saved_function_brings_the_resolution_it_was_learnt_with(
    command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    save_transfer(tmp_path / "desk.json", ConstantGain(4.0), cpi=1234.0, dpi=96.0)
    asked: list[float | None] = []

    class Opened:
        def __enter__(self) -> Opened:
            return self

        def __exit__(self, *about: object) -> None:
            """Nothing is open."""

    def resolution(source: object, cpi: float | None) -> float | None:
        asked.append(cpi)
        raise KeyboardInterrupt

    monkeypatch.setattr(follow, "choose", lambda *asked: Opened())
    monkeypatch.setattr(counts_per_inch, "counts_per_inch", resolution)
    assert command("live", "--transfer", tmp_path / "desk.json").code == 130
    assert asked == [1234.0]
