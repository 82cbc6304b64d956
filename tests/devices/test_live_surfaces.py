"""``pointpred live`` follows emulated tablets, touch screens and KVM mice, by hidraw and by evdev."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pointpred.recording import Recording
from pointpred.recordings import Reading, read_any
from tests.devices import evdev_mice, mice, surfaces
from tests.devices.contacts import DEVICES, KVM, SCREEN, TABLET, Device
from tests.devices.live_process import PATIENCE_S, READING, started, until_recorded, until_said
from tests.devices.mice import TWO_WHEELS, Mouse
from tests.devices.surfaces import PEN, TOUCH, kvm, pen, touch
from tests.devices.umockdev import Testbed

STEP_S = 0.01
SIZES = {  # px of each surface at 96 px per inch; of unknown size, 1920 x 1080
    surfaces.KVM.name: (1920.0, 1080.0),
    PEN.name: (20.72 * 96, 11.665 * 96),
    TOUCH.name: (200 / 25.4 * 96, 160 / 25.4 * 96),
    TABLET.name: (200 / 25.4 * 96, 100 / 25.4 * 96),
    SCREEN.name: (200 / 25.4 * 96, 200 / 25.4 * 96),
}
PLACES = [(0.125 * at, 0.5 - 0.0625 * at) for at in range(8)]


def numbers(most: int) -> list[tuple[int, int]]:
    """The places in units of a device."""
    return [(round(x * most), round(y * most)) for x, y in PLACES]


HIDS: list[tuple[Mouse, int, list[bytes], list[int]]] = [
    (surfaces.KVM, 32767, [kvm(x, y, at > 3) for at, (x, y) in enumerate(numbers(32767))], [8]),
    (
        PEN,
        32767,
        [
            *(pen(x, y, tip=at > 1) for at, (x, y) in enumerate(numbers(32767)[:5])),
            pen(0, 0, near=False),
            *(pen(x, y) for x, y in numbers(32767)[5:]),
        ],
        [6, 3],
    ),
    (
        TOUCH,
        4095,
        [
            *(touch(x, y, finger=1) for x, y in numbers(4095)[:4]),
            touch(9, 9, finger=1, tip=False),
            *(touch(x, y, finger=2) for x, y in numbers(4095)[4:]),
        ],
        [5, 4],
    ),
]
"""A device, its range, the reports that tell ``PLACES``, and the events of each contact."""


def followed(
    testbed: Testbed, tmp_path: Path, events: int, play: Callable[[], None], *arguments: str
) -> tuple[Recording, str]:
    """What a session recorded of a device, and what it said; a contact is one trial."""
    file, errors = tmp_path / "session.csv", tmp_path / "errors"
    with started(testbed, errors, *arguments, "--record", str(file)) as process:
        until_said(errors, READING, process)
        play()
        until_recorded(file, events, process)
        process.send_signal(signal.SIGTERM)
        out, _ = process.communicate(timeout=PATIENCE_S)
        assert process.returncode == 0, errors.read_text()
    assert " 0 lost, 0 unreadable, 0 refused" in out
    (recording,) = read_any(file, Reading(cut="whole"))
    return recording, errors.read_text()


@pytest.mark.parametrize(("device", "most", "reports", "sizes"), HIDS, ids=[each[0].name for each in HIDS])
def test_hid_devices_are_followed(
    testbed: Testbed, tmp_path: Path, device: Mouse, most: int, reports: list[bytes], sizes: list[int]
) -> None:
    plugged = mice.plug(testbed, device)

    def play() -> None:
        for report in reports:
            plugged.send(report)
            time.sleep(STEP_S)

    recording, said = followed(testbed, tmp_path, sum(sizes), play, "--device", "hidraw0")
    assert np.diff(recording.offsets).tolist() == sizes
    lifted = {5, 4} & {sizes[0] - 1} if len(sizes) > 1 else set()
    places = [place for at, place in enumerate(recording.events) if at not in lifted]
    width, height = SIZES[device.name]
    told = [(event.x, event.y) for event in places]
    np.testing.assert_allclose(told, np.array(numbers(most)) / most * (width, height), atol=1e-6)
    assert all(event.dx is None for event in places)
    if lifted:  # the buttons are released where the contact was
        (at,) = lifted
        assert recording.events.buttons[at] == 0
        assert recording.events.x[at] == recording.events.x[at - 1]
    assert "no counts" in said
    assert "positions: the device's own" in said


@pytest.mark.parametrize("device", DEVICES, ids=[device.name for device in DEVICES])
def test_input_nodes_are_followed(testbed: Testbed, tmp_path: Path, device: Device) -> None:
    node = evdev_mice.plug(testbed, 4, device.node)
    expected = device.told
    begins = [at for at, place in enumerate(expected) if place[3]]
    if device is KVM:  # the kernel tells where it is when it is opened
        expected = [(0, 0, 0, False), *expected]

    def play() -> None:
        evdev_mice.play(testbed, node, device.events())

    recording, _ = followed(testbed, tmp_path, len(expected), play, "--device", node)
    width, height = SIZES[device.name]
    x, y, buttons, _ = np.array(expected).T
    np.testing.assert_allclose(recording.events.x, width * x, atol=1e-6)
    np.testing.assert_allclose(recording.events.y, height * y, atol=1e-6)
    assert recording.events.buttons.tolist() == buttons.tolist()
    assert recording.offsets[:-1].tolist() == (begins or [0])
    if device is not KVM:
        assert recording.provenance.origin.startswith("the device's own, px of the surface, ")


def test_the_first_to_move_may_be_a_tablet(testbed: Testbed, tmp_path: Path) -> None:
    mice.plug(testbed, TWO_WHEELS, 0)
    plugged = mice.plug(testbed, PEN, 1)
    _, _, reports, sizes = HIDS[1]

    def play() -> None:
        for report in reports:
            plugged.send(report)
            time.sleep(STEP_S)

    recording, _ = followed(testbed, tmp_path, sum(sizes) - 1, play)
    assert recording.provenance.origin.startswith("the device's own, px of the surface, 526.3 x 296.3 mm")
    assert np.diff(recording.offsets).tolist() == [sizes[0] - 1, sizes[1]]
    width, height = SIZES[PEN.name]
    x, y = numbers(32767)[1]  # the first place is where it was, not a motion
    assert recording.events.x[0] == pytest.approx(x / 32767 * width)
    assert recording.events.y[0] == pytest.approx(y / 32767 * height)


def test_an_option_that_needs_counts_is_refused(testbed: Testbed, tmp_path: Path) -> None:
    mice.plug(testbed, surfaces.KVM)
    errors = tmp_path / "errors"
    with started(
        testbed, errors, "--device", "hidraw0", "--transfer", "constant:4", "--cpi", "800"
    ) as process:
        process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 2
    assert "--transfer needs a mouse's counts, and this device tells its positions" in errors.read_text()


def test_a_touch_pad_says_why_it_is_not_read(testbed: Testbed, tmp_path: Path) -> None:
    mice.plug(testbed, surfaces.PAD)
    node = evdev_mice.plug(testbed, 4, evdev_mice.TOUCHPAD)
    for device in ("hidraw0", node):
        errors = tmp_path / "errors"
        with started(testbed, errors, "--device", device) as process:
            process.communicate(timeout=PATIENCE_S)
        assert process.returncode == 1
        assert "it is a touch pad" in " ".join(errors.read_text().split())


def test_an_unplugged_pen_is_lifted_and_begins_anew(testbed: Testbed, tmp_path: Path) -> None:
    plugged = mice.plug(testbed, PEN)

    def play() -> None:
        for x, y in numbers(32767)[:3]:
            plugged.send(pen(x, y, tip=True))
            time.sleep(0.1)  # what waits in the node is gone with it
        plugged.unplug()
        time.sleep(1.0)  # until it is missed
        again = mice.plug(testbed, PEN, 1)
        time.sleep(2.0)  # until a busy machine has opened it
        for x, y in numbers(32767)[3:]:
            again.send(pen(x, y))
            time.sleep(STEP_S)

    recording, _ = followed(testbed, tmp_path, 3 + 1 + 5, play, "--device", "hidraw0")
    assert np.diff(recording.offsets).tolist() == [4, 5]
    assert recording.events.buttons.tolist() == [1, 1, 1, 0, 0, 0, 0, 0, 0]
