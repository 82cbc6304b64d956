"""``libinput record``: YAML with the kernel's events of one or more devices."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import yaml

from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.sources.decoding import read_text, stem_of
from pointpred.sources.evdev_frames import RawEvent, frames, recording
from pointpred.sources.joining import join
from pointpred.sources.reading import AS_IS, Reading

TITLE = "libinput record YAML"
LOADER: Any = getattr(yaml, "CBaseLoader", yaml.BaseLoader)


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` was written by libinput record."""
    return b"\ndevices:" in head and (b"libinput:" in head or b"evdev:" in head or b"ndevices:" in head)


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read the evdev events of every device that moves, as counts; ``row`` counts a device's events.

    Raw HID reports (``hid``) repeat what evdev says and are left aside; devices that never move are named
    in a note. Raises RecordingError when no device moves or the YAML is broken.
    """
    text = read_text(path)
    try:
        content = yaml.load(text, Loader=LOADER)
    except (yaml.YAMLError, ValueError, TypeError, RecursionError) as error:
        raise RecordingError(f"{path}: no YAML: {' '.join(str(error).split())}") from error
    devices = content.get("devices") if isinstance(content, dict) else None
    if not isinstance(devices, list) or not devices:
        raise RecordingError(f"{path}: no devices, expected a list of them under devices:")
    parts: list[Recording] = []
    still: list[str] = []
    for index, device in enumerate(devices):
        name = _name(device, index)
        stream = frames(path, list(_events(path, name, device)))
        if isinstance(stream, str):
            still.append(f"device {name}: {stream}")
            continue
        clock = "kernel stamps, us from the recording's start, monotonic"
        parts.append(recording(path, "libinput", name, stream, reading, clock))
    if not parts:
        raise RecordingError(f"{path}: {'; '.join(still)}")
    labels = [str(index) for index in range(len(parts))]
    return join(stem_of(path), parts, labels, notes=still)


def _name(device: Any, index: int) -> str:
    """The name a device gives itself."""
    about = device.get("evdev") if isinstance(device, dict) else None
    return str(about.get("name", index)) if isinstance(about, dict) else str(index)


def _events(path: Path, name: str, device: Any) -> Iterator[RawEvent]:
    """The evdev events of one device."""
    entries = device.get("events") if isinstance(device, dict) else None
    for number, entry in enumerate(entries if isinstance(entries, list) else []):
        block = entry.get("evdev", []) if isinstance(entry, dict) else None
        try:
            for seconds, micros, kind, code, value in block or []:
                yield int(seconds) * 1_000_000 + int(micros), int(kind), int(code), int(value)
        except (TypeError, ValueError) as error:
            raise RecordingError(
                f"{path}: device {name}: entry {number} is {str(block)[:60]!r}, expected "
                "evdev: lists of [sec, usec, type, code, value]"
            ) from error
