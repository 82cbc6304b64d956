"""What every kind of observer says of itself: one class a kind, one file a class."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Self

if TYPE_CHECKING:
    from pointpred.records import FloatArray
    from pointpred_observers.plants.entries import Document
    from pointpred_observers.proofs.bounds import ErrorBound
    from pointpred_observers.proofs.error_system import ErrorSystem
    from pointpred_observers.simulations.result import Simulation
    from pointpred_observers.simulations.signals import Setting


class Observer:
    """A design: frozen matrices, and what is proved of them.

    ``plant`` is the one that it was designed for. ``margins``: how far each audited inequality holds, by its
    name; none for an observer without certificate. ``gap``: how far the least objective of the search could
    lie below that of this design, relative to it; infinite if nothing is proved.
    """

    __slots__ = ()
    kind: ClassVar[str]
    certificate: Any = None
    """Has the design's ``margins``, ``bound``, ``P`` and ``gap``; ``None`` where the design has them."""

    @property
    def plant(self) -> Any:
        """The plant of the design."""
        raise NotImplementedError

    @property
    def margins(self) -> dict[str, float]:
        """How far each inequality holds."""
        return {} if self.certificate is None else self.certificate.margins

    @property
    def gap(self) -> float:
        """How far the design could be from the best one, relative."""
        return float("inf") if self.certificate is None else self.certificate.gap

    @property
    def bounds(self) -> dict[str, ErrorBound]:
        """What is proved, by what it bounds: the "error", and of a regulator "x - Pi w" and "Pi w"."""
        return {} if self.certificate is None else {"error": self.certificate.bound}

    @property
    def bound(self) -> ErrorBound:
        """The bound of the error of the estimate, the first of ``bounds``."""
        return next(iter(self.bounds.values()))

    @property
    def lyapunov(self) -> dict[str, FloatArray]:
        """The P of the inequalities, by how the names of their margins begin."""
        return {} if self.certificate is None else {"": self.certificate.P}

    @property
    def chosen(self) -> dict[str, FloatArray]:
        """The matrices that the design chose."""
        return {}

    @classmethod
    def design(cls, *args: Any, **options: Any) -> Observer:
        """The observer of a plant, with its certificate; the options are those of the kind."""
        raise NotImplementedError

    def error_system(self) -> ErrorSystem:
        """The system that the error obeys, for ``l2_gain``, ``certify_decay`` and simulations."""
        raise NotImplementedError

    def stage(self, *args: Any, **settings: Any) -> Any:
        """The observer in a loop; its settings are those of the kind."""
        raise NotImplementedError

    def simulated(self, plant: Any, setting: Setting) -> Simulation:
        """A plant beside the observer; see ``simulate``."""
        raise NotImplementedError

    def document(self) -> Document:
        """What a file holds of it; raises ParameterError for what no file can hold."""
        raise NotImplementedError

    def audited(self) -> Self:
        """The same made again of its matrices: every equality, inequality and bound computed again."""
        from pointpred_observers.plants.documents import functions_of

        again: Self = self.document().made(functions_of(self))
        return again
