"""Generated recordings of any length: the sample's simulated movements, each turned, sized and timed anew.

Cheap, because nothing is simulated again: a movement of the sample is drawn, thinned to the rate asked for,
mirrored, turned by any angle, made larger or smaller and faster or slower, and put on whole pixels. The same
seed gives the same recording. The movements say nothing about people; they only have people's shape.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from pointpred.datasets import sample
from pointpred.recording import Provenance, Recording, Trial
from pointpred.recordings import write_in_parts
from pointpred.records import EventColumns

PEOPLE_TRIALS = 1000
"""Trials of one person."""
PART_EVENTS = 65_536
SIZE, TEMPO = (0.5, 1.6), (0.7, 1.5)


def generate(folder: Path, trials: int, rate_hz: int, seed: int = 17) -> Path:
    """Write a recording of so many trials at 1000 / n Hz, and return its samples file."""
    name = f"generated_{trials}_{rate_hz}hz"
    samples, _ = write_in_parts(_parts(name, trials, rate_hz, seed), folder / f"{name}.parquet")
    return samples


def _parts(name: str, trials: int, rate_hz: int, seed: int) -> Iterator[Recording]:
    base = sample()
    thin = 1000 // rate_hz
    rows = [_thinned(base, k, thin) for k in range(len(base.trials))]
    lengths = np.array([len(one) for one in rows])
    table = base.events.table[np.concatenate(rows)]
    begins = np.concatenate([[0], np.cumsum(lengths)[:-1]])
    random = np.random.default_rng(seed)
    first = 0
    while first < trials:
        most = min(trials - first, PART_EVENTS // int(lengths.mean()))
        drawn = random.integers(0, len(rows), most)
        yield _part(name, table, begins[drawn], lengths[drawn], first, random)
        first += most


def _thinned(base: Recording, trial: int, thin: int) -> np.ndarray:
    """Every so many rows of a trial, and its last two: the click."""
    first, stop = int(base.offsets[trial]), int(base.offsets[trial + 1])
    rows: np.ndarray = np.unique(np.append(np.arange(first, stop, thin), [stop - 2, stop - 1]))
    return rows


def _part(
    name: str,
    table: np.ndarray,
    begins: np.ndarray,
    lengths: np.ndarray,
    first: int,
    random: np.random.Generator,
) -> Recording:
    """Successive trials, all at once."""
    count, offsets = len(begins), np.concatenate([[0], np.cumsum(lengths)])
    trial = np.repeat(np.arange(count), lengths)
    events = table[np.repeat(begins - offsets[:-1], lengths) + np.arange(offsets[-1])]
    start = events[offsets[:-1]][trial]
    angle, mirror = random.uniform(0.0, 2.0 * np.pi, count)[trial], random.choice([-1.0, 1.0], count)[trial]
    size = np.exp(random.uniform(*np.log(SIZE), count))[trial]
    tempo = np.exp(random.uniform(*np.log(TEMPO), count))[trial]
    x, y = size * (events[:, 1] - start[:, 1]), mirror * size * (events[:, 2] - start[:, 2])
    out = np.full((len(events), 6), np.nan)
    out[:, 0] = np.round(tempo * (events[:, 0] - start[:, 0]), 4)
    out[:, 1] = np.round(960.0 + np.cos(angle) * x - np.sin(angle) * y)
    out[:, 2] = np.round(540.0 + np.sin(angle) * x + np.cos(angle) * y)
    out[:, 5] = events[:, 5]
    ends = out[offsets[1:] - 1, 1:3].tolist()
    trials = tuple(
        Trial(f"person {(first + k) // PEOPLE_TRIALS:05d}", str(first + k), *end, 24.0)
        for k, end in enumerate(ends)
    )
    begin = np.zeros(len(out), dtype=np.bool_)
    begin[offsets[:-1]] = True
    provenance = Provenance("generated", simulated=True)
    return Recording(name, EventColumns(out, begin), offsets.astype(np.int64), trials, provenance=provenance)
