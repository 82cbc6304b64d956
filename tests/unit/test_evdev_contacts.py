"""Absolute devices by input events: places, contacts, refusals, and logs of each in every format."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.devices.evdev import EVENT, FrameDecoder
from pointpred.devices.surface import Axis
from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.recordings import Reading, read_any
from pointpred.recordings.formats.evdev_contacts import EvdevAbout, EvdevContacts
from pointpred.recordings.formats.evdev_frames import FrameBuilder
from tests.building import text_file
from tests.devices import surfaces
from tests.devices.contacts import (
    ABS,
    DEVICES,
    FINGER,
    ID,
    KEY,
    KVM,
    LEFT,
    MT_X,
    MT_Y,
    PEN,
    REPORT,
    SCREEN,
    SLOT,
    STYLUS,
    SYN,
    TABLET,
    TOUCH,
    Device,
    Frame,
    Told,
    X,
    Y,
    evemu,
    evtest,
    getevent,
    libinput,
)
from tests.devices.mice import BUTTONS

DROPPED, MT_REPORT = 3, 2
LOGS: list[Callable[[Device], str]] = [evemu, evtest, libinput, getevent]
MM = {TABLET.name: 100, SCREEN.name: 200}
"""Their heights."""
UNIT = EvdevAbout(ranges={code: Axis(0, 10) for code in (X, Y, MT_X, MT_Y)})


def told(frames: list[Frame]) -> list[Told]:
    builder = FrameBuilder(Path("made"), UNIT)
    for at, frame in enumerate(frames):
        for event in [*frame, (SYN, REPORT, 0)]:
            builder.add(at, (at * 1000, *event))
    return [place for _, place in builder.places]


def one(path: Path, reading: Reading | None = None) -> Recording:
    (recording,) = read_any(path, reading or Reading(cut="whole"))
    return recording


@pytest.mark.parametrize("device", DEVICES, ids=[device.name for device in DEVICES])
@pytest.mark.parametrize("log", LOGS)
def test_every_log_of_a_device_has_its_places(
    tmp_path: Path, device: Device, log: Callable[[Device], str]
) -> None:
    recording = one(text_file(tmp_path / "log.txt", log(device)))
    x, y, buttons, begins = np.array(device.told).T
    width, height = (1920.0, 1080.0) if device is KVM else (200 / 25.4 * 96, MM[device.name] / 25.4 * 96)
    np.testing.assert_allclose(recording.events.x, width * x, atol=1e-9)
    np.testing.assert_allclose(recording.events.y, height * y, atol=1e-9)
    assert recording.events.buttons.tolist() == buttons.tolist()
    assert np.isnan(recording.events.dx).all()
    assert np.flatnonzero(recording.events.begin).tolist() == (np.flatnonzero(begins).tolist() or [0])
    assert recording.trials[0].condition["device"] == device.name
    assert recording.provenance.unit == ("units of the device" if device is KVM else "mm")
    times = [at for at, (_, place) in enumerate(device.frames) if place is not None]
    assert recording.trials[-1].condition["begins_s"] == pytest.approx(
        (times[np.flatnonzero(begins)[-1]] - times[0]) * 0.01 if device is not KVM else 0.0
    )


@pytest.mark.parametrize("device", DEVICES, ids=[device.name for device in DEVICES])
def test_px_are_those_of_a_unit_where_they_are_given(tmp_path: Path, device: Device) -> None:
    recording = one(
        text_file(tmp_path / "log.txt", evemu(device)), Reading(cut="whole", px_per_unit=(0.5, 2.0))
    )
    (_, across, _), (_, down, _) = device.ranges[X], device.ranges[Y]
    x, y, *_ = np.array(device.told).T
    np.testing.assert_allclose(recording.events.x, 0.5 * across * x, atol=1e-9)
    np.testing.assert_allclose(recording.events.y, 2.0 * down * y, atol=1e-9)
    assert "positions: 0.5 px across and 2 px down in a unit of the device" in recording.notes
    assert not any("no effect" in note for note in recording.notes)


def test_counts_say_that_px_of_a_unit_have_no_effect(tmp_path: Path) -> None:
    moves = [f"E: 6.0{at}0000 0002 0000 {2 + at}\nE: 6.0{at}0000 0000 0000 0" for at in range(3)]
    recording = one(text_file(tmp_path / "log", "\n".join(["N: mouse", *moves])), Reading(px_per_unit=2.0))
    assert recording.events.dx.tolist() == [2, 3, 4]
    assert "px_per_unit has no effect: mouse moves by counts" in recording.notes


def hid_log(device: surfaces.Mouse, reports: list[bytes]) -> str:
    """A recording as hid-recorder writes it."""
    lines = [
        f"R: {len(device.descriptor)} {device.descriptor.hex(' ')}",
        f"N: {device.name}",
        "I: 3 0001 0001",
    ]
    lines += [
        f"E: {at // 100}.{at % 100:02d}0000 {len(one)} {one.hex(' ')}" for at, one in enumerate(reports)
    ]
    return "\n".join(lines) + "\n"


def test_hid_recorder_has_the_places_of_a_tablet_a_touch_screen_and_a_kvm_mouse(tmp_path: Path) -> None:
    pen = [surfaces.pen(1000 * at, 0) for at in range(5)]
    lifted = [surfaces.pen(0, 0, near=False), *(surfaces.pen(32767, 1000 * at, tip=True) for at in range(5))]
    recording = one(text_file(tmp_path / "pen", hid_log(surfaces.PEN, [*pen, *lifted])))
    assert np.diff(recording.offsets).tolist() == [5, 5]
    width = 20.72 * 96
    np.testing.assert_allclose(recording.rows(0).x, [at * 1000 / 32767 * width for at in range(5)])
    np.testing.assert_allclose(recording.rows(1).x, width)
    assert recording.events.buttons.tolist() == [0] * 5 + [1] * 5
    assert "positions: px of the surface, 526.3 x 296.3 mm at 96 px per inch" in recording.notes
    assert "contacts, each a movement of its own or several: 2" in recording.notes

    fingers = [surfaces.touch(at * 100, 4095) for at in range(4)] + [surfaces.touch(0, 0, tip=False)]
    recording = one(text_file(tmp_path / "touch", hid_log(surfaces.TOUCH, fingers * 2)))
    assert np.diff(recording.offsets).tolist() == [5, 5]
    assert recording.rows(0).buttons.tolist() == [1, 1, 1, 1, 0]

    recording = one(
        text_file(tmp_path / "kvm", hid_log(surfaces.KVM, [surfaces.kvm(at, at) for at in range(4)]))
    )
    np.testing.assert_allclose(recording.events.y, np.arange(4) / 32767 * 1080)
    assert recording.provenance.origin == "top left"


def test_a_device_of_hid_recorder_that_moves_by_counts_is_a_mouse(tmp_path: Path) -> None:
    mouse = BUTTONS.descriptor.replace(b"\x09\x01\xa1\x00", b"\x85\x02\x09\x01\xa1\x00")
    both = surfaces.Mouse("receiver", mouse + surfaces.PEN.descriptor)
    places = [surfaces.pen(100 * at, 0) for at in range(3)]
    recording = one(text_file(tmp_path / "pen", hid_log(both, places)))
    assert recording.provenance.unit == "mm"
    recording = one(
        text_file(tmp_path / "both", hid_log(both, [*places, bytes([2, 0, 5, 1]), bytes([2, 0, 1, 1])]))
    )
    assert recording.provenance.unit == "counts"
    assert recording.events.dx.tolist() == [5, 1]
    assert "positions of a device that moves by counts left aside: 3" in recording.notes


def test_pauses_cut_a_contact_and_clicks_do_not_join_two(tmp_path: Path) -> None:
    text = evemu(SCREEN)
    for cut, trials in (("bursts", 2), ("whole", 2), ("clicks", 0)):
        reading = Reading(cut=cut)  # type: ignore[arg-type]
        path = text_file(tmp_path / f"{cut}.evemu", text)
        recording = one(path, reading)
        assert len(recording.trials) == trials
    assert {skip.reason for skip in recording.skipped} == {"a button is held", "no click ends it"}


def test_old_drivers_list_every_contact_in_each_frame() -> None:
    def listed(*fingers: tuple[int, int]) -> Frame:
        rows = [[(ABS, MT_X, x), (ABS, MT_Y, y), (SYN, MT_REPORT, 0)] for x, y in fingers]
        return [event for row in rows or [[(SYN, MT_REPORT, 0)]] for event in row]

    other = [(4, 5, 0)]
    frames = [listed((0, 5)), listed((1, 5), (9, 9)), other, listed(), listed((9, 9)), listed()]
    assert told(frames) == [
        (0, 0.5, 1, True),
        (0.1, 0.5, 1, False),
        (0.1, 0.5, 0, False),
        (0.9, 0.9, 1, True),
        (0.9, 0.9, 0, False),
    ]


def test_a_contact_that_was_there_before_the_log_is_read() -> None:
    frames: list[Frame] = [
        [(ABS, MT_X, 3)],
        [(ABS, MT_Y, 5)],
        [(ABS, ID, -1)],
        [(ABS, ID, 4), (ABS, MT_X, 6)],
    ]
    assert told(frames) == [(0.3, 0.5, 1, True), (0.3, 0.5, 0, False), (0.6, 0.5, 1, True)]


def test_a_single_touch_is_there_while_it_touches() -> None:
    frames: list[Frame] = [
        [(KEY, TOUCH, 1), (ABS, X, 1), (ABS, Y, 2)],
        [(KEY, TOUCH, 0)],
        [(ABS, X, 9)],
        [(KEY, TOUCH, 1)],
    ]
    assert told(frames) == [(0.1, 0.2, 1, True), (0.1, 0.2, 0, False), (0.9, 0.2, 1, True)]


def test_lost_events_end_a_contact_and_make_its_trial_unusable(tmp_path: Path) -> None:
    lost: Frame = [(ABS, MT_X, 9), (SYN, DROPPED, 0), (ABS, MT_Y, 9)]
    down: Frame = [(ABS, ID, 1), (ABS, MT_X, 0), (ABS, MT_Y, 0), (KEY, TOUCH, 1)]
    frames = [down, [(ABS, MT_X, 1)], lost, [(ABS, MT_X, 5)], down, [(ABS, MT_X, 3)]]
    assert told(frames) == [
        (0, 0, 1, True),
        (0.1, 0, 1, False),
        (0.1, 0, 0, False),
        (0, 0, 1, True),
        (0.3, 0, 1, False),
    ]
    device = Device("lossy", [TOUCH], True, SCREEN.ranges, [(frame, None) for frame in frames])
    recording = one(text_file(tmp_path / "lossy", evemu(device)))
    assert [skip.reason for skip in recording.skipped] == ["the kernel dropped events (SYN_DROPPED)"]
    assert len(recording.trials) == 1


@pytest.mark.parametrize(
    ("keys", "direct", "said"),
    [
        ([TOUCH, FINGER, LEFT], False, "it is a touch pad"),
        ([0x130, 0x131], False, "its absolute positions are not a pointer's"),
        ([TOUCH, FINGER, LEFT], True, None),
        ([TOUCH, FINGER, PEN], False, None),
        ([LEFT], False, None),
        ([], True, None),
        ([], False, "its absolute positions are not a pointer's"),
    ],
)
@pytest.mark.parametrize("log", LOGS[:3])
def test_touch_pads_and_joysticks_are_refused(
    tmp_path: Path, log: Callable[[Device], str], keys: list[int], direct: bool, said: str | None
) -> None:
    frames: list[Frame] = [[(ABS, X, at * 10), (ABS, Y, at)] for at in range(5)]
    device = Device("some device", keys, direct, KVM.ranges, [(frame, None) for frame in frames])
    path = text_file(tmp_path / "log", log(device))
    if said is None:
        assert len(one(path).events) == 5
    else:
        with pytest.raises(RecordingError, match=f"device some device: {said}"):
            one(path)


def test_a_touch_pad_is_known_by_its_fingers_without_a_description(tmp_path: Path) -> None:
    frames: list[Frame] = [[(KEY, FINGER, 1), (ABS, X, at), (ABS, Y, at)] for at in range(5)]
    device = Device("", [], False, {}, [(frame, None) for frame in frames])
    lines = [line for line in evemu(device).splitlines() if line.startswith("E:")]
    with pytest.raises(RecordingError, match="it is a touch pad"):
        one(text_file(tmp_path / "log", "\n".join(lines)))


def test_a_mouse_with_a_touch_surface_moves_by_counts(tmp_path: Path) -> None:
    device = Device(
        "mouse", [LEFT], False, KVM.ranges, [([(ABS, X, at), (ABS, Y, at)], None) for at in range(5)]
    )
    still = evemu(device).replace("B: 03", "B: 02 03 00 00 00 00 00 00 00\nB: 03", 1)
    with pytest.raises(RecordingError, match="no relative motion in 15 events"):
        one(text_file(tmp_path / "still", still))
    moves = [
        f"E: 6.0{at}0000 0002 000{axis} {2 + at}\nE: 6.0{at}0000 0000 0000 0" for at, axis in ((0, 0), (1, 1))
    ]
    moving = "\n".join([still.strip(), *moves])
    assert one(text_file(tmp_path / "moving", moving)).events.dx.tolist() == [2, 0]


axis = st.tuples(st.just(ABS), st.sampled_from([X, Y, SLOT, MT_X, MT_Y, ID]), st.integers(-1, 4))
key = st.tuples(st.just(KEY), st.sampled_from([LEFT, PEN, TOUCH, STYLUS]), st.integers(0, 1))
mark = st.tuples(st.just(SYN), st.sampled_from([MT_REPORT, DROPPED]), st.just(0))


@given(st.lists(st.lists(axis | axis | key | mark, max_size=6), max_size=12))
def test_the_decoder_of_a_node_tells_the_places_of_the_importer(frames: list[Frame]) -> None:
    events = [event for frame in frames for event in [*frame, (SYN, REPORT, 0)]]
    builder, decoder = (
        FrameBuilder(Path("made"), UNIT),
        FrameDecoder(ask=lambda: 0, contacts=EvdevContacts(UNIT)),
    )
    for at, event in enumerate(events):
        builder.add(at, (at, *event))
    data = b"".join(EVENT.pack(0, at, *event) for at, event in enumerate(events))
    assert [(frame.stamp_us, frame.place) for frame in decoder.feed(data) if frame.place] == builder.places
