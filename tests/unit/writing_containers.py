"""Files of every container of tables, of one known truth, written without the readers under test."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import numpy as np
from openpyxl import Workbook
from scipy.io import savemat

NAMES = ("time_ms", "x", "y", "user", "trial")
TRIALS = {
    (user, trial): [(8.0 * at, 100.0 + at * at * trial, 300.5 - 3 * at) for at in range(12)]
    for user in ("p1", "p2")
    for trial in (1, 2)
}
"""Samples (ms, px, px) of each user's trials."""
ROWS = [(*sample, user, trial) for (user, trial), samples in TRIALS.items() for sample in samples]


def nested() -> dict[str, object]:
    """The same as an object of people, their trials and their samples."""
    people = [
        {
            "user": user,
            "trials": [
                {
                    "trial": trial,
                    "samples": [dict(zip(NAMES, sample, strict=False)) for sample in TRIALS[user, trial]],
                }
                for trial in (1, 2)
            ],
        }
        for user in ("p1", "p2")
    ]
    return {"study": "our own", "people": people}


def write_json(path: Path) -> None:
    rows = [dict(zip(NAMES, row, strict=True)) for row in ROWS]
    path.write_text(json.dumps({"study": "our own", "data": {"samples": rows}}), encoding="utf-8")


def write_matlab(path: Path) -> None:
    columns = {name: np.array([row[at] for row in ROWS]) for at, name in enumerate(NAMES) if name != "user"}
    users = np.array([row[3] for row in ROWS], dtype=object)
    savemat(path, {"data": {**columns, "user": users}, "rate": 125.0}, do_compression=True)


def write_workbook(path: Path) -> None:
    book = Workbook()
    book.active.title = "about"
    book.active.append(["our own", "file"])
    sheet = book.create_sheet("mouse")
    sheet.append(NAMES)
    for row in ROWS:
        sheet.append(row)
    book.save(path)


def chunk(tag: int, content: bytes) -> bytes:
    return b"\x04" + struct.pack("<IH", len(content) + 2, tag) + content


def stream_header(number: int, name: str, kind: str, labels: list[str], values: str = "double64") -> bytes:
    channels = "".join(f"<channel><label>{label}</label></channel>" for label in labels)
    text = (
        f"<?xml version='1.0'?><info><name>{name}</name><type>{kind}</type><channel_count>{len(labels)}"
        f"</channel_count><nominal_srate>0</nominal_srate><channel_format>{values}</channel_format>"
        f"<desc><channels>{channels}</channels></desc></info>"
    )
    return chunk(2, struct.pack("<I", number) + text.encode())


def stream_samples(number: int, times: list[float], rows: list[tuple[float, ...]]) -> bytes:
    samples = b"".join(
        b"\x08" + struct.pack(f"<{1 + len(row)}d", time, *row) for time, row in zip(times, rows, strict=True)
    )
    return chunk(3, struct.pack("<I", number) + b"\x04" + struct.pack("<I", len(times)) + samples)


def clock_offset(number: int, time: float, offset: float) -> bytes:
    return chunk(4, struct.pack("<Idd", number, time, offset))


def write_xdf(path: Path, offset: float | None = None) -> None:
    """One stream of a mouse, its trials as a channel, beside one of another device."""
    times = [100.0 + 0.008 * at for at in range(len(ROWS))]
    rows = [(float(x), float(y), float(10 * int(user[1]) + trial)) for _, x, y, user, trial in ROWS]
    parts = [
        b"XDF:",
        chunk(1, b"<?xml version='1.0'?><info><version>1.0</version></info>"),
        stream_header(1, "Amplifier", "EEG", ["C3", "C4"], "double64"),
        stream_header(2, "Pointer", "Mouse", ["x", "y", "trial"]),
        *(clock_offset(2, time, offset) for time in (99.0, 101.0, 103.0) if offset is not None),
    ]
    for at in range(0, len(rows), 12):
        parts += [
            stream_samples(2, times[at : at + 12], rows[at : at + 12]),
            stream_samples(1, [times[at]], [(1.0, 2.0)]),
        ]
    path.write_bytes(b"".join(parts))


def write_delimited(path: Path) -> None:
    """Semicolons and decimal commas."""
    lines = [";".join(str(cell).replace(".", ",") for cell in row) for row in (NAMES, *ROWS)]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


WRITERS = {
    "csv": write_delimited,
    "json": write_json,
    "mat": write_matlab,
    "xlsx": write_workbook,
    "xdf": write_xdf,
}
