"""What a simulation gives: the signals of plant and observer at the samples, and their figure."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec
import numpy as np

from pointpred.drawing import Panel, beside, drawn, written
from pointpred.errors import ParameterError
from pointpred.extras import missing_extra
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import wrong
from pointpred_observers.paths import writable
from pointpred_observers.plants.persidskii import Persidskii

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STATES_MOST = 8
"""Most states with a panel of their own."""
ENDINGS = (".svg", ".png", ".pdf")
NONE: Any = msgspec.field(default_factory=lambda: np.zeros((0, 0)))


class Simulation(msgspec.Struct, frozen=True):
    """A plant and its observer at N samples; NaN where there is no estimate.

    ``t`` (N) in s, or the indices; ``state`` and ``estimate`` (N, n); ``output`` (N, p) as measured, noise
    included; ``input`` (N, m) what acts on the plant and is known. ``unknown_input`` and
    ``unknown_input_estimate`` (N, d), ``driving`` and ``driving_estimate`` (N, q) the generator's state:
    empty where there is none. ``bound`` (N) what the certificate proves of the norm of the error; empty where
    it says nothing: with noise or disturbances, for another plant than the design's, with slopes that hold on
    a domain only, and for other observers than reduced-order and full-order ones; the error of sampling comes
    on top of it. ``names`` of the states.
    """

    t: FloatArray
    state: FloatArray
    estimate: FloatArray
    output: FloatArray
    input: FloatArray
    names: tuple[str, ...]
    title: str
    discrete: bool
    unknown_input: FloatArray = NONE
    unknown_input_estimate: FloatArray = NONE
    driving: FloatArray = NONE
    driving_estimate: FloatArray = NONE
    bound: FloatArray = msgspec.field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        for name in ("unknown_input", "unknown_input_estimate", "driving", "driving_estimate"):
            if getattr(self, name).size == 0:
                msgspec.structs.force_setattr(self, name, np.zeros((len(self.t), 0)))

    @classmethod
    def of(
        cls,
        plant: Persidskii,
        times: FloatArray,
        state: FloatArray,
        estimate: FloatArray,
        output: FloatArray,
        known: FloatArray,
        title: str,
        **more: FloatArray | None,
    ) -> Simulation:
        """That of a Persidskii plant; ``more``: other fields, where they are known."""
        names, discrete = tuple(f"x{i + 1}" for i in range(plant.n)), plant.time == "discrete"
        there = {name: one for name, one in more.items() if one is not None}
        return cls(times, state, estimate, output, known, names, title, discrete, **there)

    @property
    def error(self) -> FloatArray:
        """The estimate minus the state, (N, n)."""
        return self.estimate - self.state

    def rmse(self, after: float = -np.inf) -> FloatArray:
        """The root of the mean squared error of each state over the samples from ``after`` on, (n)."""
        if not is_number(after):
            raise wrong("after", "must be a number", after)
        late = self.t >= after
        if not late.any():
            raise wrong("after", f"must lie below the last sample, {self.t[-1]:g}", after)
        return np.asarray(np.sqrt(np.nanmean(self.error[late] ** 2, axis=0)))

    def plot(self, file: Path | str | None = None) -> Figure:
        """A figure of matplotlib: each state with its estimate, unknown inputs, the norm of the error.

        Parameters: ``file`` to write as well, .svg, .png or .pdf by its ending. Raises ParameterError for
        another ending and for a folder that does not exist; MissingExtraError without matplotlib; OSError.
        """
        target = None if file is None else check_ending(file)
        panels = self.panels()
        try:
            with drawn(self.title, panels, 1 if len(panels) <= 4 else 2) as figure:
                if target is not None:
                    written(figure, target, self.title)
                return figure
        except ModuleNotFoundError as missing:
            raise missing_extra("report", "a plot needs matplotlib") from missing

    def panels(self) -> list[Panel]:
        """The axes of the figure and their lines."""
        x = "sample" if self.discrete else "t [s]"
        pairs = [*zip(self.names[:STATES_MOST], self.state.T, self.estimate.T, strict=False)]
        unknown, several = self.unknown_input.T, self.unknown_input.shape[1] > 1
        names = [f"unknown input {i + 1}" if several else "unknown input" for i in range(len(unknown))]
        pairs += zip(names, unknown, self.unknown_input_estimate.T, strict=True)
        panels = [
            Panel(name, beside(self.t, (true, "true", "truth"), (estimate, "estimate", "first")), x)
            for name, true, estimate in pairs
        ]
        norm = np.linalg.norm(self.error, axis=1)
        lines = beside(self.t, (np.where(norm > 0.0, norm, np.nan), "norm", "second"))
        if self.bound.size:
            lines += beside(self.t, (self.bound, "proved bound", "limit"))
        return [*panels, Panel("error", lines, x, logarithmic=bool((norm > 0.0).any()))]


def check_ending(file: Path | str) -> Path:
    """The file of a plot; raises ParameterError for an ending that no plot has, and without a folder."""
    target = writable(file)
    if target.suffix not in ENDINGS:
        words = f"a plot is written to a file that ends in {', '.join(ENDINGS)}, received {target}"
        raise ParameterError(words, field="file")
    return target
