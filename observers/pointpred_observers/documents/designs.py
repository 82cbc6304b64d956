"""Designs of unknown-input observers as JSON."""

from __future__ import annotations

from typing import Self

import numpy as np

from pointpred.errors import ParameterError
from pointpred_observers.documents.entries import (
    Document,
    Functions,
    Rows,
    Values,
    finite,
    gap_of,
    matrices_of,
    plain,
)
from pointpred_observers.documents.plants import ParameterVaryingDocument
from pointpred_observers.matrices import matrix
from pointpred_observers.unknown_input.corners import CornerSystem
from pointpred_observers.unknown_input.observer import UnknownInputObserver


class UnknownInputDocument(Document, tag="unknown-input observer", frozen=True):
    """An ``UnknownInputObserver``: plant and box, a gain for each corner, and the matrices of Theorem 1."""

    plant: ParameterVaryingDocument
    gains: list[Rows]
    sigma: float
    certificate: Values
    gap: float | None = None

    @classmethod
    def of(cls, thing: UnknownInputObserver) -> Self:
        """The document of a design, whose A and F must be affine in each variable."""
        system, proof = thing.system, thing.certificate
        if not isinstance(system, CornerSystem) or system.box.bounds != thing.box.bounds:
            system = CornerSystem.of(system, thing.box)
        if proof.force is None:
            raise ParameterError(
                "the certificate lacks the matrix F of the theorem: design the observer again"
            )
        return cls(
            plant=ParameterVaryingDocument.of(system),
            gains=thing.gains.matrices.tolist(),
            sigma=proof.sigma,
            certificate=plain({"P": proof.p, "F": proof.force}),
            gap=finite(proof.gap),
        )

    def made(self, functions: Functions) -> UnknownInputObserver:
        """The design, audited at every corner."""
        system = self.plant.made(functions)
        n, p = system.c.shape[1], len(system.c)
        values = matrices_of(self.certificate, {"P": (n, n), "F": (n, n)})
        gains = np.array([matrix("gains", one, n, p) for one in self.gains])
        return UnknownInputObserver.certified(
            system, system.box, gains, values["P"], values["F"], self.sigma, gap_of(self.gap)
        )
