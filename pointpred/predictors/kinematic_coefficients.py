"""The coefficients of the learned predictor: a versioned file, read once and shared read-only."""

from __future__ import annotations

import hashlib
import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import ParameterError
from pointpred.predictors import kinematic_calibration as calibration
from pointpred.predictors import kinematic_features as features
from pointpred.predictors import kinematic_net as net

VERSION = 1
"""Of what the file holds and of what its numbers mean; a file of another version is refused."""
OWN = Path(__file__).with_name("kinematic.npz")
"""The file that comes with the package."""
LARGEST_BYTES = 2 * 1024 * 1024
LAYERS = 3


def write(
    path: Path,
    mean: FloatArray,
    scale: FloatArray,
    layers: list[tuple[Any, Any]],
    table: FloatArray,
    card: dict[str, Any],
) -> None:
    """Write coefficients and their card; the same numbers make the same bytes."""
    arrays: dict[str, Any] = {"version": np.int64(VERSION), "mean": mean, "scale": scale, "table": table}
    for number, (weights, offset) in enumerate(layers):
        arrays[f"weights{number}"] = np.asarray(weights, np.float32)
        arrays[f"offset{number}"] = np.asarray(offset, np.float32)
    arrays["card"] = np.frombuffer(json.dumps(card, sort_keys=True).encode(), np.uint8)
    with path.open("wb") as file:
        np.savez(file, **arrays)


@cache
def read(path: Path) -> FloatArray:
    """The coefficients of a file as one array that nobody may write to.

    Raises ParameterError for a file that cannot be read, is of another version or does not fit.
    """
    try:
        if path.stat().st_size > LARGEST_BYTES:
            raise ValueError(f"more than {LARGEST_BYTES} bytes")
        with np.load(path, allow_pickle=False) as file:
            held = {name: np.asarray(file[name]) for name in file.files}
        parts = _parts(held)
    except (OSError, ValueError, KeyError, EOFError) as unusable:
        raise ParameterError(
            f"coefficients must be a file of version {VERSION}: {path}: {unusable}"
        ) from unusable
    flat = np.concatenate([np.ravel(part) for part in parts]).astype(np.float64)
    flat.flags.writeable = False
    return flat


def _parts(held: dict[str, Any]) -> list[Any]:
    """The arrays in the order in which ``kinematic_net`` reads them; ValueError where one does not fit."""
    if int(held["version"]) != VERSION:
        raise ValueError(f"is of version {int(held['version'])}")
    first, second = held["weights0"].shape[1], held["weights1"].shape[1]
    wanted: list[tuple[str, tuple[int, ...]]] = [
        ("mean", (features.FEATURES,)),
        ("scale", (features.FEATURES,)),
    ]
    for number, (rows, width) in enumerate(
        ((features.FEATURES, first), (first, second), (second, net.OUTPUTS))
    ):
        wanted += [(f"weights{number}", (rows, width)), (f"offset{number}", (width,))]
    wanted.append(("table", (calibration.KNOTS, calibration.FACTORS)))
    for name, shape in wanted:
        if held[name].shape != shape or not np.isfinite(held[name]).all():
            raise ValueError(f"{name} must hold finite numbers of shape {shape}, has {held[name].shape}")
    return [np.array([first, second], np.float64), *(held[name] for name, _ in wanted)]


def card(path: Path = OWN) -> dict[str, Any]:
    """What the file says of itself: sets, users, seeds, scores."""
    with np.load(path, allow_pickle=False) as file:
        said: dict[str, Any] = json.loads(file["card"].tobytes())
    return said


def digest(path: Path = OWN) -> str:
    """A short digest of the file's bytes."""
    return hashlib.blake2b(path.read_bytes(), digest_size=8).hexdigest()
