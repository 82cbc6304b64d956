"""Regions given targets hold the share of ends that they claim, for simulated people who aim at targets."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from pointpred import PointerEvent, build
from pointpred.records import FloatArray
from pointpred.regions import reach
from pointpred.targets import Target, around
from pointpred.targets.posterior import EFFECTIVE
from tests.building import way

KNOWN = 30
"""Movements after which regions are judged."""
MOVEMENTS = 75
PEOPLE = 2
LEVELS = (0.5, 0.8)
OFF = 0.12
"""Allowed difference of shares: three deviations of a share of about 230 ends, of which those of a movement
are alike."""


def page(random: np.random.Generator) -> list[Target]:
    """Twelve targets of any size in four columns."""
    sizes = zip(random.uniform(30.0, 90.0, 12), random.uniform(20.0, 60.0, 12), strict=True)
    return [around(i, 250.0 * (i % 4), 200.0 * (i // 4), *map(float, size)) for i, size in enumerate(sizes)]


def moved(random: np.random.Generator, start: FloatArray, end: FloatArray) -> FloatArray:
    """A movement with a bow, which falls short and corrects itself, every 10 ms in whole px."""
    far = float(np.hypot(*(end - start)))
    seconds = (0.25 + 0.12 * np.log2(1.0 + far / 40.0)) * np.exp(random.normal(0.0, 0.15))
    s = np.linspace(0.0, 1.0, round(100.0 * seconds) + 1)
    share = random.normal(0.95, 0.05)
    along = share * way(np.minimum(s / 0.75, 1.0)) + (1.0 - share) * way(np.clip((s - 0.6) / 0.4, 0.0, 1.0))
    u = (end - start) / far
    beside = random.normal(0.0, 0.05) * far * np.sin(np.pi * along)
    return np.round(start + np.outer(along * far, u) + np.outer(beside, (-u[1], u[0])))


def movements(random: np.random.Generator, targets: list[Target]) -> Iterator[tuple[float, FloatArray]]:
    """When each movement of a person begins, s, and where the cursor is; to ends drawn about targets."""
    t, at = 0.0, np.array([375.0, 200.0])
    for _ in range(MOVEMENTS):
        target = targets[int(random.integers(len(targets)))]
        size = np.array([target.width, target.height])
        end = (target.x, target.y) + 0.5 * size + random.standard_normal(2) * size / EFFECTIVE
        if np.hypot(*(end - at)) < 60.0:
            continue
        places = moved(random, at, end)
        yield t, places
        t, at = t + 0.01 * len(places) + 0.6, places[-1]


@pytest.mark.parametrize("name", ["minimum-jerk", "switched", "kinematic-adaptive"])
def test_regions_hold_the_share_of_ends_that_they_claim(name: str) -> None:
    """At three moments of each movement: the ellipse of the prediction, and the level set of the mixture."""
    held: dict[tuple[str, float], list[bool]] = {(kind, p): [] for kind in ("ellipse", "set") for p in LEVELS}
    for seed in range(PEOPLE):
        random = np.random.default_rng(seed)
        pipeline = build(name, targets=(targets := page(random)))
        for number, (t, places) in enumerate(movements(random, targets)):
            judged = {int(share * len(places)) for share in (0.3, 0.6, 0.85)} if number >= KNOWN else ()
            for i, place in enumerate(places.tolist()):
                prediction = pipeline.update(PointerEvent(t + 0.01 * i, *place))
                if i not in judged:
                    continue
                mixture = pipeline.mixture
                assert prediction is not None
                assert prediction.scale is not None
                assert prediction.tail is not None
                assert mixture is not None
                off = places[-1] - (prediction.x, prediction.y)
                sxx, sxy, syy = prediction.scale
                far = off @ np.linalg.solve([[sxx, sxy], [sxy, syy]], off)
                for level in LEVELS:
                    held["ellipse", level].append(far <= reach(level, prediction.tail))
                    held["set", level].append(mixture.region(level).contains(*places[-1].tolist()))
            pipeline.reset()
    for (_, level), inside in held.items():
        assert len(inside) > 200
        assert np.mean(inside) == pytest.approx(level, abs=OFF)
