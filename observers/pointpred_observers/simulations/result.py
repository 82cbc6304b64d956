"""What a simulation gives: the signals of plant and observer at the samples, and their figure."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import numpy as np

from pointpred.drawing import Panel, beside, drawn, written
from pointpred.errors import ParameterError
from pointpred.extras import missing_extra
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.paths import writable
from pointpred_observers.plants.persidskii import Persidskii

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STATES_MOST = 8
"""Most states with a panel of their own."""
ENDINGS = (".svg", ".png", ".pdf")


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
    unknown_input: FloatArray
    unknown_input_estimate: FloatArray
    driving: FloatArray
    driving_estimate: FloatArray
    bound: FloatArray

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
        *,
        bound: FloatArray | None = None,
        driving: FloatArray | None = None,
        driving_estimate: FloatArray | None = None,
    ) -> Simulation:
        """That of a Persidskii plant, which has no unknown inputs."""
        none = np.zeros((len(times), 0))
        return cls(
            times,
            state,
            estimate,
            output,
            known,
            tuple(f"x{i + 1}" for i in range(plant.n)),
            title,
            plant.time == "discrete",
            none,
            none,
            none if driving is None else driving,
            none if driving_estimate is None else driving_estimate,
            np.zeros(0) if bound is None else bound,
        )

    @property
    def error(self) -> FloatArray:
        """The estimate minus the state, (N, n)."""
        return self.estimate - self.state

    def rmse(self, after: float = -np.inf) -> FloatArray:
        """The root of the mean squared error of each state over the samples from ``after`` on, (n)."""
        if not is_number(after):
            raise ParameterError(f"after must be a number, received {after!r}", field="after", value=after)
        late = self.t >= after
        if not late.any():
            raise ParameterError(
                f"after must lie below the last sample, {self.t[-1]:g}, received {after!r}", field="after"
            )
        mean: FloatArray = np.sqrt(np.nanmean(self.error[late] ** 2, axis=0))
        return mean

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
        shown = min(self.state.shape[1], STATES_MOST)
        pairs = [(self.names[i], self.state[:, i], self.estimate[:, i]) for i in range(shown)]
        for i in range(self.unknown_input.shape[1]):
            name = f"unknown input {i + 1}" if self.unknown_input.shape[1] > 1 else "unknown input"
            pairs.append((name, self.unknown_input[:, i], self.unknown_input_estimate[:, i]))
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
        raise ParameterError(
            f"a plot is written to a file that ends in {', '.join(ENDINGS)}, received {target}", field="file"
        )
    return target
