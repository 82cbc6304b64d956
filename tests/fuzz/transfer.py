"""Any text as a saved transfer function, and as one that a user names."""

from __future__ import annotations

import json

import numpy as np

from pointpred.errors import PointpredError
from pointpred.transfer.files import load_transfer, named_transfer
from tests.fuzz.files import as_file
from tests.fuzz.refusals import refused

SPEEDS = np.array([0.0, 0.01, 0.3, 5.0])


def check(data: bytes) -> str:
    """The bytes as a file, and as text on a command line."""
    came = []
    with as_file(data) as path:
        for read, argument in ((load_transfer, path), (named_transfer, data.decode(errors="replace"))):
            try:
                saved = read(argument)  # type: ignore[operator]
                assert np.isfinite(saved.function.gain(SPEEDS)).all()
                came.append("read")
            except PointpredError as error:
                came.append(refused(error))
    return " ".join(came)


def seeds() -> list[bytes]:
    files = (
        {"version": 1, "kind": "constant", "numbers": [4], "cpi": 800},
        {"version": 1, "kind": "sigmoid", "numbers": [1, 15, 0.05, 0.6], "dpi": 96},
        {"version": 1, "kind": "polynomial", "numbers": [1, 2, 3], "speed_low": 0.01, "speed_high": 1},
    )
    return [json.dumps(file).encode() for file in files] + [
        b"constant:4",
        b"sigmoid:1,15,0.05,0.6",
        b"sigmoid",
    ]
