"""Error bounds of every differentiator: ``python -m pages.differentiators.measure``."""

from __future__ import annotations

import contextlib
import itertools
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

from pages.arguments import parse
from pages.data import Table, keep
from pages.differentiators.bounds import BOUNDS, measure, named
from pages.differentiators.signals import SIGNALS, Signal, exact, minimum_jerk, quantised
from pointpred.differentiators import (
    DIFFERENTIATORS,
    Differentiator,
    HomogeneousDifferentiator,
    KalmanDifferentiator,
)
from pointpred.errors import ParameterError

WEIGHT = 0.3
"""What a relative acceleration error counts beside a relative velocity error."""


class Movement(NamedTuple):
    """A minimum-jerk reach, by distance m and duration s."""

    distance: float
    duration: float

    @property
    def peaks(self) -> tuple[float, float]:
        """Largest velocity m/s and acceleration m/s^2."""
        share = 10.0 / np.sqrt(3.0)
        return 1.875 * self.distance / self.duration, share * self.distance / self.duration**2


MOVEMENTS = (Movement(0.05, 0.4), Movement(0.1, 0.7), Movement(0.2, 0.6), Movement(0.3, 0.9))
SOURCES = {
    "cursor, 60 Hz": (60.0, False),
    "cursor, 125 Hz": (125.0, False),
    "cursor, 1 kHz": (1000.0, False),
    "counts, 125 Hz": (125.0, True),
    "counts, 1 kHz": (1000.0, True),
}
GRIDS: dict[type[Differentiator], dict[str, tuple[float, ...]]] = {
    HomogeneousDifferentiator: {
        "gain_lambda": (5.0, 7.0, 10.0, 14.0, 20.0, 28.0, 40.0, 56.0),
        "gain_xi": (1.1, 1.2, 1.5, 2.0),
        "alpha": (0.0, -0.05, -0.1, -0.15, -0.2, -0.25),
    },
    KalmanDifferentiator: {"jerk_density": (3.0, 10.0, 30.0, 100.0, 300.0, 1000.0)},
}


def bounds() -> Table:
    """The table of error bounds with what was measured."""
    rows = []
    for name, one in itertools.product(DIFFERENTIATORS, SIGNALS):
        signal = SIGNALS[one]()
        got, most = measure(named(name, signal), signal), BOUNDS[name][one]
        pairs = [
            (got.velocity_rms, most.velocity_rms),
            (got.velocity_largest, most.velocity_largest),
            (got.acceleration_rms, most.acceleration_rms),
            (got.acceleration_largest, most.acceleration_largest),
        ]
        cells = [f"{_short(measured)} ({_short(bound)})" for measured, bound in pairs]
        late = "-" if got.delay_s is None else f"{1e3 * got.delay_s:+.1f} ({1e3 * (most.delay_s or 0.0):.1f})"
        rows.append((name, one, *cells, late, f"{1e3 * got.settling_s:.0f}"))
    velocity, acceleration = "velocity RMS m/s", "acceleration RMS m/s^2"
    header = (
        "differentiator",
        "signal",
        velocity,
        "largest",
        acceleration,
        "largest",
        "peak late ms",
        "settles ms",
    )
    return Table.of(header, rows)


def between() -> Table:
    """HOMD with the printed gains: the position between two samples on a line, or held at the newer one."""
    rows = []
    for rate, kind, step_s in itertools.product((1000.0, 125.0, 60.0), ("line", "hold"), (0.0015, 0.00025)):
        errors = measure(
            HomogeneousDifferentiator(between=kind, step_s=step_s),
            exact(minimum_jerk, rate),
        )
        late = f"{1e3 * (errors.delay_s or 0.0):+.1f}"
        rms = (_short(errors.velocity_rms), _short(errors.acceleration_rms))
        rows.append((f"{rate:g}", kind, f"{1e3 * step_s:g}", *rms, late))
    return Table.of(
        ("rate Hz", "between", "step ms", "velocity RMS m/s", "acceleration RMS m/s^2", "peak late ms"), rows
    )


def best() -> Table:
    """The best HOMD gains for each movement and source, beside the printed ones."""
    kind, rows = HomogeneousDifferentiator, []
    for source in SOURCES:
        for movement in MOVEMENTS:
            setting = min(_settings(kind), key=lambda s, m=movement, o=source: _cost(kind, s, o, (m,)))
            place = (source, f"{movement.distance:g} m in {movement.duration:g} s")
            values = tuple(f"{value:g}" for value in setting.values())
            rows.append(
                (
                    *place,
                    *values,
                    _percent(kind, setting, source, (movement,)),
                    _percent(kind, {}, source, (movement,)),
                )
            )
    return Table.of(("source", "movement", "lambda", "xi", "alpha", "error", "printed gains"), rows)


def recommended() -> Table:
    """The setting of each differentiator that is best over all movements of a source."""
    rows = []
    for source, kind in itertools.product(SOURCES, GRIDS):
        setting = min(_settings(kind), key=lambda s, k=kind, o=source: _cost(k, s, o, MOVEMENTS))
        values = ", ".join(f"{name} {value:g}" for name, value in setting.items())
        rows.append(
            (
                source,
                _name(kind),
                values,
                _percent(kind, setting, source, MOVEMENTS),
                _percent(kind, {}, source, MOVEMENTS),
            )
        )
    return Table.of(("source", "differentiator", "best", "error", "with defaults"), rows)


def _settings(kind: type[Differentiator]) -> Iterator[dict[str, float]]:
    """All of a grid that can be built: gains whose velocity chatters at rest are refused."""
    grid = GRIDS[kind]
    for values in itertools.product(*grid.values()):
        one = dict(zip(grid, values, strict=True))
        with contextlib.suppress(ParameterError):
            kind(**one)
            yield one


def _errors(
    kind: type[Differentiator], parameters: dict[str, float], signal: Signal, movement: Movement
) -> np.ndarray:
    """RMS over the whole signal, which begins and ends at rest, as shares of the movement's peaks."""
    motions = kind(cpi=signal.cpi, **parameters).run(signal.events)
    off = (motions.vx - signal.velocity, motions.ax - signal.acceleration)
    return np.array([np.sqrt(np.mean(o**2)) / peak for o, peak in zip(off, movement.peaks, strict=True)])


def _mean_errors(
    kind: type[Differentiator], parameters: dict[str, float], source: str, movements: tuple[Movement, ...]
) -> np.ndarray:
    rate, counts = SOURCES[source]
    paths = [(m, partial(minimum_jerk, distance=m.distance, duration=m.duration)) for m in movements]
    signals = [(m, quantised(path, rate, counts=counts, length_s=m.duration + 0.4)) for m, path in paths]
    return np.mean([_errors(kind, parameters, signal, m) for m, signal in signals], axis=0)


def _cost(
    kind: type[Differentiator], parameters: dict[str, float], source: str, movements: tuple[Movement, ...]
) -> float:
    velocity, acceleration = _mean_errors(kind, parameters, source, movements)
    return float(velocity + WEIGHT * acceleration)


def _percent(
    kind: type[Differentiator], parameters: dict[str, float], source: str, movements: tuple[Movement, ...]
) -> str:
    velocity, acceleration = 100.0 * _mean_errors(kind, parameters, source, movements)
    return f"{velocity:.1f} %, {acceleration:.0f} %"


def _name(kind: type[Differentiator]) -> str:
    return next(name for name, one in DIFFERENTIATORS.items() if one is kind)


def _short(value: float) -> str:
    if value < 1e-8:
        return "0"
    return f"{value:.0f}" if value >= 100.0 else f"{value:.2g}"


PARTS = {"bounds": bounds, "between": between, "best": best, "recommended": recommended}


def main() -> None:
    """Measure every table."""
    for name, measured in PARTS.items():
        keep("differentiators", {name: measured()})


if __name__ == "__main__":
    parse(__doc__)
    main()
