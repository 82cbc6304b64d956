"""The system that an error obeys, as the linear systems at the corners of what is uncertain."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from math import inf
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import Coordinates
from pointpred_observers.numerics.eigenvalues import require_decay, vertices
from pointpred_observers.numerics.matrices import (
    TIMES,
    dimensions,
    instance,
    listed,
    matrix,
    one_of,
    positive,
)


class ErrorSystem(msgspec.Struct, frozen=True):
    """e' = A e + B delta, z = C e, with (A, B) anywhere between the corners.

    In discrete time e' is the next e. ``A`` (corners, n, n), ``B`` (corners, n, m), ``C`` (outputs, n);
    ``names`` of the corners, "" for a linear system's only one; ``disturbances`` names the parts of delta and
    their widths, in the order of B's columns. The corners hold while the arguments of f stay within
    ``domain``, and so does every proof that is made of them.

    Raises ParameterError for shapes that do not fit each other, entries that are not finite, and a ``time``
    other than "continuous" and "discrete".
    """

    A: FloatArray
    B: FloatArray
    C: FloatArray
    names: tuple[str, ...]
    disturbances: dict[str, int]
    time: str
    domain: float = inf

    def __post_init__(self) -> None:
        a, b = stack("A", self.A), stack("B", self.B)
        if a.shape[1] != a.shape[2] or b.shape[:2] != a.shape[:2]:
            raise ParameterError(
                "A and B need the shapes (corners, n, n) and (corners, n, m), "
                f"received {a.shape} and {b.shape}",
                field="A",
            )
        c, names = matrix("C", self.C, None, a.shape[1]), tuple(listed("names", self.names))
        for name, value in (("A", a), ("B", b), ("C", c), ("names", names)):
            msgspec.structs.force_setattr(self, name, value)
        if len(names) != len(a):
            raise ParameterError(
                f"names must be {len(a)}, one for each corner, received {names!r}", field="names"
            )
        widths = list(instance("disturbances", self.disturbances, dict).values())
        if not all(is_number(one) and one == int(one) >= 0 for one in widths) or sum(widths) != b.shape[2]:
            raise ParameterError(
                f"the widths of disturbances must add up to the {b.shape[2]} columns of B, received "
                f"{self.disturbances!r}",
                field="disturbances",
            )
        one_of("time", self.time, TIMES)
        if self.domain != inf:
            positive("domain", self.domain)

    @property
    def n(self) -> int:
        """The number of states."""
        return int(self.A.shape[1])

    def places(self) -> dict[str, slice]:
        """The columns of B by disturbance."""
        ends = [int(one) for one in np.cumsum([0, *self.disturbances.values()])]
        return {name: slice(*pair) for name, pair in zip(self.disturbances, pairwise(ends), strict=True)}

    def seen_as(self, C: Any) -> ErrorSystem:
        """The same system with the output z = C e; raises ParameterError for another width."""
        return msgspec.structs.replace(self, C=matrix("C", C, None, self.n))

    def disturbed_by(self, *names: str) -> ErrorSystem:
        """The same system with only these disturbances; raises ParameterError for an unknown one."""
        places = self.places()
        if not names or set(names) - set(places):
            raise ParameterError(
                f"the disturbances are {', '.join(places)}, received {', '.join(names) or 'none'}"
            )
        b = np.concatenate([self.B[:, :, places[name]] for name in names], axis=2)
        widths = {name: self.disturbances[name] for name in names}
        return msgspec.structs.replace(self, B=b, disturbances=widths)

    def inward(self, units: Coordinates) -> ErrorSystem:
        """The same system with its states and time in these units."""
        x, t = units.states, units.seconds
        a, b = t * self.A * x / x[:, None], t * self.B / x[:, None]
        return msgspec.structs.replace(self, A=a, B=b, C=self.C * x)

    def slowest(self) -> float:
        """The largest real part of an eigenvalue, 1/s (logarithm of its modulus, 1/step), at any corner.

        Raises InfeasibleError naming an eigenvalue that does not decay, and its corner.
        """
        return require_decay(zip(self.names, self.A, strict=True), self.time, "the error system")


def stack(name: str, value: Any) -> FloatArray:
    """Matrices of one shape, one for each corner; raises ParameterError for anything else."""
    corners = [matrix(name, one) for one in listed(name, value)]
    if not corners or dimensions(value) != 3:
        raise ParameterError(
            f"{name} must be a list of matrices of one shape, one for each corner, received {value!r:.80}",
            field=name,
            value=value,
        )
    return np.array(corners)


def sloped_system(
    A: FloatArray,
    F: FloatArray,
    H: FloatArray,
    B: Mapping[str, FloatArray],
    *,
    slopes: tuple[tuple[float, float], ...] | None,
    time: str,
    through: Mapping[str, FloatArray] | None = None,
    domain: float = inf,
) -> ErrorSystem:
    """The error system e' = A e + F (f(s + H e + R delta) - f(s)) + B delta for every f with these slopes.

    By the mean value theorem the difference is D (H e + R delta) with D diagonal between the slopes.
    ``through`` are the R of some of the disturbances. The slopes hold within ``domain``: the system has it
    wherever f matters. Raises ParameterError where f matters and its slopes are missing or not bounded.

    >>> system = sloped_system(
    ...     -np.eye(1), np.ones((1, 1)), np.eye(1), {"d": np.eye(1)}, slopes=((0.0, 0.5),), time="continuous"
    ... )
    >>> dict(zip(system.names, system.A.ravel().tolist(), strict=True))
    {'D = diag(0)': -1.0, 'D = diag(0.5)': -0.5}
    """
    drive = np.hstack([*B.values()])
    inner = np.hstack([(through or {}).get(name, np.zeros((len(H), b.shape[1]))) for name, b in B.items()])
    widths = {name: int(b.shape[1]) for name, b in B.items()}
    if not F.any():
        return ErrorSystem(A[None], drive[None], np.eye(len(A)), ("",), widths, time)
    corners = vertices(slopes)
    return ErrorSystem(
        np.array([A + F @ d @ H for d in corners.values()]),
        np.array([drive + F @ d @ inner for d in corners.values()]),
        np.eye(len(A)),
        tuple(f"D = diag({name})" for name in corners),
        widths,
        time,
        domain,
    )
