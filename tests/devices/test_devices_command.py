"""``pointpred devices`` against emulated mice, as a person runs it."""

from __future__ import annotations

import contextlib
import json
import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.devices.mice import SPLIT, SYZBOT, WHEEL, Mouse, plug
from tests.devices.umockdev import Testbed

MODULE = (sys.executable, "-m", "pointpred", "devices")
NOBODY = 65534


AS_NOBODY = f"""
import contextlib, io, os
from pointpred.cli import main

with contextlib.suppress(SystemExit), contextlib.redirect_stdout(io.StringIO()):
    main(["devices", "watch", "--seconds", "0.01"])  # as root: imports what a stranger may not read here
os.setgroups([])
os.setgid({NOBODY})
os.setuid({NOBODY})
main(["devices", "watch", "/dev/hidraw0"])
"""


def start(testbed: Testbed, *arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [*MODULE, *arguments],
        env={**testbed.environment(), "COLUMNS": "160"},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_the_list_names_every_mouse(testbed: Testbed) -> None:
    for number, mouse in enumerate((WHEEL, SYZBOT, SPLIT)):
        plug(testbed, mouse, number)
    out, err = start(testbed, "list").communicate(timeout=60)
    rows = [line.split() for line in out.splitlines()]
    assert ["/dev/hidraw0", "hid", "wheel", "yes"] in rows
    assert ["/dev/hidraw2", "hid", "MI", "wireless", "yes"] in rows
    assert "garbage" not in out
    assert err == ""
    out, _ = start(testbed, "list", "--all", "--json").communicate(timeout=60)
    found = {one["path"]: one for one in json.loads(out)["devices"]}
    assert found["/dev/hidraw1"]["why"].startswith("report descriptor without x and y of a pointer: ")
    assert not found["/dev/hidraw1"]["openable"]


def test_the_udev_rules_have_a_line_for_mice_that_do_not_call_themselves_so(testbed: Testbed) -> None:
    plug(testbed, SPLIT, 0)
    plug(testbed, Mouse("plain", WHEEL.descriptor, 0x46D, 0xC077, protocol="02"), 1)
    out, err = start(testbed, "udev").communicate(timeout=60)
    rules = [line for line in out.splitlines() if line and not line.startswith("#")]
    assert rules[2:] == ['KERNEL=="hidraw*", SUBSYSTEM=="hidraw", KERNELS=="*:2717:003B.*", TAG+="uaccess"']
    assert "/etc/udev/rules.d/70-pointpred.rules" in err


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can become somebody without permission")
def test_somebody_without_permission_reads_the_line_to_write(testbed: Testbed) -> None:
    plug(testbed, Mouse("plain", WHEEL.descriptor, 0x46D, 0xC077, protocol="02"))
    Path(os.path.realpath(testbed.root + "/dev/hidraw0")).chmod(0o600)
    process = testbed.python(AS_NOBODY)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (1, "")
    assert "/dev/hidraw0 (plain): permission denied; put this line into" in err
    assert (
        '\n  KERNEL=="hidraw*", SUBSYSTEM=="hidraw", ATTRS{modalias}=="usb:v046DpC077*", '
        'ATTRS{bInterfaceProtocol}=="02", TAG+="uaccess"\n'
    ) in err


def test_watching_counts_until_it_is_interrupted(testbed: Testbed) -> None:
    mouse = plug(testbed, WHEEL)
    process = start(testbed, "watch", "/dev/hidraw0")
    assert process.stderr is not None
    assert process.stdout is not None
    assert process.stderr.readline().startswith("wheel at /dev/hidraw0; this computer's monotonic clock")
    for _ in range(7):
        mouse.send(bytes([1, 2, 0xFF, 1]))
    line = ""
    while "reports 7" not in line:
        line = process.stdout.readline()
        assert line
    assert "x, y +14, -7 counts; wheel, pan +7, +0 steps; pressed left" in line
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 0
    assert out.endswith("/dev/hidraw0: 7 reports, 0 lost, 0 unreadable, +14 and -7 counts\n")
    assert err == ""


def test_watching_for_a_while(testbed: Testbed) -> None:
    plug(testbed, WHEEL)
    started = time.monotonic()
    out, _ = start(testbed, "watch", "--seconds", "0.3").communicate(timeout=60)
    assert time.monotonic() - started > 0.3
    assert "/dev/hidraw0 sent nothing: move the mouse" in out


def test_watching_in_a_terminal_draws_a_table(testbed: Testbed) -> None:
    mouse = plug(testbed, WHEEL)
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        [*MODULE, "watch", "--seconds", "60"],  # it is ended before, once it has drawn what was sent
        env={**testbed.environment(), "TERM": "xterm"},
        stdout=theirs,
        stderr=subprocess.PIPE,
        text=True,
    )
    os.close(theirs)
    assert process.stderr is not None
    assert process.stderr.readline().startswith("wheel at /dev/hidraw0")
    mouse.send(bytes([4, 2, 0xFF, 1]))
    drawn, interrupted = "", False
    with contextlib.suppress(OSError):  # a terminal whose other end is closed ends like this
        while said := os.read(ours, 4096):
            drawn += said.decode(errors="replace")
            if "middle" in drawn and not interrupted:
                process.send_signal(signal.SIGINT)
                interrupted = True
    os.close(ours)
    assert process.wait(60) == 0
    assert "unreadable" in drawn
    assert "+2, -1 counts" in drawn
    assert "middle" in drawn
    process.stderr.close()
