"""Camera samples, their truth and images as files: what ``pointpred camera`` writes and reads."""

from __future__ import annotations

import csv
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.errors import ParameterError, RecordingError
from pointpred.extras import missing_extra
from pointpred.records import FloatArray
from pointpred_observers.camera import CameraColumns, CameraTable, Trajectory

TRUTH = ("t", "depth_m", "vx", "vy", "vz")
IMAGES = (".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm")
Names = tuple[str, ...]


def write_table(target: Path, names: Names, table: FloatArray) -> None:
    """A CSV file with a header; what is not there (NaN) is an empty field."""
    with target.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(names)
        writer.writerows([["" if v != v else repr(v) for v in row] for row in table.tolist()])


def read_table(source: Path, names: Names) -> FloatArray:
    """The columns of a CSV file, in any order; raises RecordingError naming file, line and column."""
    try:
        with source.open(newline="", encoding="utf-8-sig") as stream:
            reader = csv.DictReader(stream)
            missing = [name for name in names if name not in (reader.fieldnames or [])]
            if missing:
                reason = f"the header lacks {', '.join(missing)}; needs {', '.join(names)}"
                raise RecordingError(f"{source}: {reason}")
            rows = []
            for number, row in enumerate(reader, start=2):
                if None in row:
                    raise RecordingError(f"{source}, line {number}: has more fields than the header")
                rows.append([_number(source, number, name, row[name]) for name in names])
    except (UnicodeDecodeError, csv.Error) as unusable:
        raise RecordingError(f"{source}: is no CSV file in UTF-8: {unusable}") from unusable
    if len(rows) < 2:
        raise RecordingError(f"{source}: needs at least 2 rows, received {len(rows)}")
    return np.array(rows)


def _number(source: Path, number: int, name: str, text: str | None) -> float:
    if text is None or not text.strip():
        if name in ("x", "y"):
            return float("nan")
        raise RecordingError(f"{source}, line {number}: {name} is empty, only x and y may be")
    try:
        return float(text)
    except ValueError as unusable:
        raise RecordingError(f"{source}, line {number}: {name} is no number: {text!r:.40}") from unusable


def read_truth(source: Path) -> FloatArray:
    """The truth beside samples; raises RecordingError for numbers that no camera has, naming file and row."""
    table = read_table(source, TRUTH)
    for row, values in enumerate(table.tolist()):
        for name, value in zip(TRUTH, values, strict=True):
            if not isfinite(value):
                raise RecordingError(f"{source}: row {row}: {name} must be finite, received {value!r}")
        if not values[1] > 0.0:
            raise RecordingError(f"{source}: row {row}: depth_m must be positive, received {values[1]!r}")
    return table


def truth_table(truth: Trajectory) -> FloatArray:
    """What ``run`` compares with."""
    return np.column_stack([truth.t, truth.p[:, 2], truth.v])


def read_samples(source: Path) -> CameraColumns:
    """Samples of ``camera simulate``, or of anybody who writes the same columns."""
    return CameraColumns(read_table(source, CameraColumns.names))


def read_images(folder: Path) -> list[Any]:
    """The images of a folder in the order of their names, grey."""
    files = sorted(path for path in folder.iterdir() if path.suffix.lower() in IMAGES)
    if not files:
        raise ParameterError(f"--images {folder}: holds no image ({', '.join(IMAGES)})")
    try:
        import cv2
    except ImportError as missing:
        raise missing_extra("camera", "reading images needs OpenCV", of="pointpred-observers") from missing
    images = []
    for path in files:
        image = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        if image is None:
            raise RecordingError(f"{path}: is no image that can be read")
        images.append(image)
    return images


def errors_of(estimates: CameraTable, truth: FloatArray) -> dict[str, dict[str, float | None]]:
    """RMSE of observer and peer against the truth, where each has an estimate."""
    if len(truth) != len(estimates) or np.abs(truth[:, 0] - estimates.t).max() > 1e-6:
        raise ParameterError(f"TRUTH: needs the {len(estimates)} times of the samples, received others")
    chi, eta = 1.0 / truth[:, 1], truth[:, 4] / truth[:, 1]
    wanted = {"chi": chi, "eta": eta, "vx": truth[:, 2], "vy": truth[:, 3], "vz": truth[:, 4]}
    table: dict[str, dict[str, float | None]] = {}
    for who, prefix in (("observer", ""), ("peer", "peer_")):
        table[who] = {}
        for name, values in wanted.items():
            error = getattr(estimates, prefix + name) - values
            finite = error[error == error]
            table[who][name] = float(np.sqrt(np.mean(finite**2))) if len(finite) else None
    return table
