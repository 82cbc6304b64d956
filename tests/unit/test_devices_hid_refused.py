"""What a user reads where no mouse can be read: it says what to do next."""

from __future__ import annotations

import json
import sys
import threading
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from pointpred.devices import hidraw
from pointpred.devices.hidraw import HidSource, list_hid
from pointpred.devices.udev import shipped_rules
from pointpred.errors import SourceError
from tests.devices.mice import TWO_WHEELS

ENTRY = {
    "path": b"/dev/hidraw7",
    "vendor_id": 0x46D,
    "product_id": 0xC077,
    "product_string": "Mouse",
    "serial_number": "",
    "interface_number": 0,
}


class Handle:
    """A device of a made-up hidapi: it says its reports, then waits or fails."""

    def __init__(self, reports: list[list[int]], then: Callable[[], list[int]], descriptor: bytes) -> None:
        self.reports, self.then, self.descriptor, self.closed = list(reports), then, descriptor, 0

    def open_path(self, path: bytes) -> None:
        assert path == ENTRY["path"]

    def get_report_descriptor(self) -> list[int]:
        return list(self.descriptor)

    def read(self, size: int, wait_ms: int) -> list[int]:
        assert wait_ms > 0
        return self.reports.pop(0)[:size] if self.reports else self.then()

    def close(self) -> None:
        self.closed += 1


@pytest.fixture
def plugged(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Handle]:
    """Put a made-up hidapi in place of the real one."""

    def plug(
        reports: list[list[int]] = [],  # noqa: B006 - never changed
        then: Callable[[], list[int]] = list,
        descriptor: bytes = TWO_WHEELS.descriptor,
        entries: list[dict[str, Any]] = [ENTRY],  # noqa: B006
    ) -> Handle:
        handle = Handle(reports, then, descriptor)
        module = SimpleNamespace(enumerate=lambda: entries, device=lambda: handle)
        monkeypatch.setitem(sys.modules, "hidraw", module)
        monkeypatch.setattr(hidraw, "not_a_mouse", lambda device: None)
        monkeypatch.setattr(hidraw.Path, "exists", lambda path: True)
        monkeypatch.setattr(hidraw.os, "access", lambda path, mode: True)
        return handle

    return plug


@pytest.mark.parametrize(
    ("platform", "name"), [("win32", "Windows"), ("darwin", "macOS"), ("freebsd14", r"\(freebsd14\)")]
)
def test_systems_that_keep_mice_to_themselves(
    monkeypatch: pytest.MonkeyPatch, platform: str, name: str
) -> None:
    monkeypatch.setattr(sys, "platform", platform)
    for attempt in (list_hid, HidSource().__enter__, HidSource("/dev/hidraw0").__enter__):
        with pytest.raises(
            SourceError, match=f"{name} keeps mice to itself.*'pointpred serve'.*browser client"
        ):
            attempt()


def test_the_command_line_names_the_cursor_where_mice_are_kept(
    monkeypatch: pytest.MonkeyPatch, command: Any
) -> None:
    assert command("devices", "list", "--json").code == 0  # imports what there is for this system only
    monkeypatch.setattr(sys, "platform", "darwin")
    left = command("devices", "list", "--json")
    assert left.code == 0
    assert [(one["path"], one["kind"]) for one in json.loads(left.out)["devices"]] == [("cursor", "cursor")]
    left = command("devices", "watch")
    assert (left.code, left.out) == (1, "")
    assert "Quartz" in left.err


def test_hidapi_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "hidraw", None)
    with pytest.raises(SourceError, match=r"hidapi cannot be used .*-m pip install .*\[live\]"):
        list_hid()


def test_no_devices(plugged: Callable[..., Handle]) -> None:
    plugged(entries=[])
    assert list_hid() == []
    with pytest.raises(SourceError, match=r"no HID mouse found among 0 HID devices; plug one in.*Containers"):
        HidSource().__enter__()
    plugged()
    with pytest.raises(SourceError, match="no HID mouse 1234:0000 found among 1 HID devices"):
        HidSource(vendor=0x1234).__enter__()


def test_without_permission_the_exact_line_is_printed(
    plugged: Callable[..., Handle], monkeypatch: pytest.MonkeyPatch
) -> None:
    plugged()
    monkeypatch.setattr(hidraw.os, "access", lambda path, mode: False)
    line = 'KERNEL=="hidraw*", SUBSYSTEM=="hidraw", KERNELS=="*:046D:C077.*", TAG+="uaccess"'
    (found,) = list_hid()
    assert (found.openable, found.why) == (False, "permission denied")
    assert found.advice is not None
    with pytest.raises(SourceError) as refused:
        HidSource().__enter__()
    for said in (found.advice, str(refused.value)):
        assert f"\n  {line}\n" in said
        assert "/etc/udev/rules.d/70-pointpred.rules" in said
        assert "sudo udevadm control --reload && sudo udevadm trigger" in said
    monkeypatch.setattr(hidraw, "is_mouse_interface", lambda device: True)
    assert 'ATTRS{modalias}=="usb:v046DpC077*", ATTRS{bInterfaceProtocol}=="02"' in str(list_hid()[0].advice)


def test_a_node_that_is_listed_but_not_there(
    plugged: Callable[..., Handle], monkeypatch: pytest.MonkeyPatch
) -> None:
    plugged()
    monkeypatch.setattr(hidraw.Path, "exists", lambda path: False)
    assert "there is no such node" in str(list_hid()[0].why)


def test_the_shipped_rules_open_mice_only() -> None:
    rules = [line for line in shipped_rules().splitlines() if line and not line.startswith("#")]
    assert len(rules) == 2
    assert all('TAG+="uaccess"' in rule and "MODE" not in rule for rule in rules)
    assert any('bInterfaceProtocol}=="02"' in rule for rule in rules)


def test_a_bad_descriptor_and_a_refusal_of_hidapi(plugged: Callable[..., Handle]) -> None:
    handle = plugged(descriptor=bytes.fromhex("05010902a101b4"))
    with pytest.raises(SourceError, match=r"/dev/hidraw7 \(Mouse\): .*pops more than it pushes at byte 6"):
        HidSource().__enter__()
    assert handle.closed == 1

    def refuse(path: bytes) -> None:
        raise OSError("open failed")

    handle.open_path = refuse  # type: ignore[method-assign]
    with pytest.raises(SourceError, match="open failed; unplug it and plug it in again, 'dmesg' says"):
        HidSource().__enter__()


def test_losses_of_a_full_queue_are_counted(plugged: Callable[..., Handle]) -> None:
    said = threading.Event()
    reports = [[0, 0, number, 0, 0, 0, 0, 0] for number in range(10)]
    plugged(reports, lambda: said.set() or [])
    with HidSource(most=4) as source:
        assert said.wait(30.0)
        taken = source.take(0.0)
    assert [each.dx for each in taken] == [6, 7, 8, 9]
    assert (source.lost, source.unreadable) == (6, 0)


def test_what_breaks_the_thread_is_told_to_whoever_takes(plugged: Callable[..., Handle]) -> None:
    def fail() -> list[int]:
        raise ZeroDivisionError("a mistake of ours")

    plugged([[0, 0, 5, 0, 0, 0, 0, 0]], fail)
    with HidSource() as source:
        assert [each.dx for each in source.take(30.0)] == [5]
        with pytest.raises(SourceError, match=r"\(Mouse\): reading ended: a mistake of ours"):
            source.take(30.0)


def test_a_source_is_used_once_and_opened_first(plugged: Callable[..., Handle]) -> None:
    plugged()
    source = HidSource()
    with pytest.raises(SourceError, match="'with' statement"):
        source.take(0.0)
    with source, pytest.raises(SourceError, match="open already"):
        source.__enter__()
    source.close()


def test_the_name_of_a_device_writes_no_rule_of_its_own(plugged: Callable[..., Handle], command: Any) -> None:
    plugged(entries=[{**ENTRY, "product_string": 'x\nKERNEL=="sd*", MODE="0666"\x1b[2J'}])
    left = command("devices", "udev")
    assert left.code == 0
    rules = [line for line in left.out.splitlines() if line and not line.startswith("#")]
    assert [rule.partition(", ")[0] for rule in rules] == [
        'KERNEL=="hidraw*"',
        'KERNEL=="event*"',
        'KERNEL=="hidraw*"',
    ]
    assert "\x1b" not in left.out
