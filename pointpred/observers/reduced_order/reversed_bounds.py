"""Error bounds that Theorems 3.3.1 and 3.3.2 imply, by generalised eigenvalues."""

from __future__ import annotations

from math import log, sqrt
from typing import Any

import numpy as np

from pointpred.observers.bounds import ErrorBound, eigenvalues


def continuous_bound(P: Any, Xi: Any, gamma: float) -> ErrorBound:
    """The bound of Theorem 3.3.1 with the least generalised eigenvalue c of (Xi, P): never a worse one.

    V' <= -c V + delta'P delta / gamma, so that abs(e) <= sqrt(max P / min P) (exp(-c t / 2) abs(e0) +
    abs(delta) / sqrt(c gamma)).

    >>> continuous_bound([[4.0]], [[1.0]], 1.0)(0.0, 0.0, delta=1.0)
    2.0
    """
    p, c = eigenvalues("P", P), _generalised(P, Xi)
    overshoot = sqrt(p[-1] / p[0])
    return ErrorBound(overshoot, 0.5 * c, (overshoot / sqrt(c * gamma),), ("delta",))


def discrete_bound(P: Any, Xi: Any, Gamma: Any, *, sharp: bool = False) -> ErrorBound:
    """The bound that Theorem 3.3.2 implies and the print leaves out, for delta; the rate is per step.

    V(k+1) <= (1 - c) V(k) + max Gamma abs(delta)^2 with c = min Xi / max P, so that abs(e) <= sqrt(max
    P / min P) (1 - c)^(k/2) abs(e0) + sqrt(max Gamma / (c min P)) abs(delta). ``sharp`` takes the
    least generalised eigenvalue of (Xi, P) for c, which is never smaller.

    >>> discrete_bound([[1.0]], [[0.75]], [[3.0]])(2.0, 1.0, delta=0.5)  # 1/4 + 2 * 0.5
    1.25
    """
    p, xi, gamma = eigenvalues("P", P), eigenvalues("Xi", Xi), eigenvalues("Gamma", Gamma)
    c = _generalised(P, Xi) if sharp else float(xi[0] / p[-1])
    rate = -0.5 * log(max(1.0 - c, 1e-300))
    return ErrorBound(sqrt(p[-1] / p[0]), rate, (sqrt(gamma[-1] / (c * p[0])),), ("delta",))


def _generalised(P: Any, Xi: Any) -> float:
    """The least c with Xi >= c P."""
    root = np.linalg.inv(np.linalg.cholesky(np.atleast_2d(np.asarray(P, np.float64))))
    return float(np.linalg.eigvalsh(root @ np.atleast_2d(Xi) @ root.T)[0])
