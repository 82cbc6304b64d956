"""The motion of a point in a camera's image: (8), (12) and (15) of the camera paper, the signs corrected.

Coordinates: x right, y down, z forward along the optical axis; m = (x, y) = (X/Z, Y/Z) of a fixed point,
v and w the camera's linear and angular velocity in its own frame, chi = 1/Z, eta = v_z/Z, and ``a`` the
acceleration of the motion in that frame, gravity removed: v' = a - w x v.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.plants.boxes import Box
from pointpred_observers.plants.varying import ParameterVaryingSystem

C = np.eye(2, 4)
"""The image gives x and y of (x, y, chi, eta)."""
SCHEDULED = ("zero", "eta", "a_z", "w_x", "w_y", "dw_x", "dw_y")
"""The seven scheduling variables; ``zero`` is y w_x - x w_y + eta."""


def interaction(x: float, y: float) -> FloatArray:
    """The effect of the angular velocity on an image point: the last three columns of (8)."""
    return np.array([[x * y, -(1.0 + x * x), y], [1.0 + y * y, -x * y, -x]])


def dynamics(point: Mapping[str, float]) -> FloatArray:
    """A of (15) at a point with x, y, w_x, w_y, eta and a_z."""
    x, y, eta = point["x"], point["y"], point["eta"]
    zero = y * point["w_x"] - x * point["w_y"] + eta
    a = np.zeros((4, 4))
    a[2, 2], a[:, 3], a[3, 2] = zero, (x, y, 0.0, zero), point["a_z"]
    return a


def unknown_input(point: Mapping[str, float]) -> FloatArray:
    """F of (15): how d = (chi v_x, chi v_y) enters."""
    return np.array([[-1.0, 0.0], [0.0, -1.0], [0.0, 0.0], [point["w_y"], -point["w_x"]]])


def decoupled(point: Mapping[str, float]) -> FloatArray:
    """T A, in which x and y appear in ``zero`` only: seven scheduling variables instead of eight.

    >>> decoupled({"zero": -0.5, "eta": -0.4, "a_z": 0.1})[2:, 2:].tolist()
    [[-0.5, 0.0], [0.1, -0.4]]
    """
    matrix = np.zeros((4, 4))
    matrix[2, 2], matrix[3, 2], matrix[3, 3] = point["zero"], point["a_z"], point["eta"]
    return matrix


def camera_system() -> ParameterVaryingSystem:
    """(15) for the design of an observer: its zeros are ``zero`` and ``eta`` for any gains."""
    return ParameterVaryingSystem(
        dynamics,
        unknown_input,
        C,
        rates={"w_x": "dw_x", "w_y": "dw_y"},
        decoupled=decoupled,
        sizes=np.ones(4),
    )


def camera_box(
    eta: tuple[float, float],
    *,
    turn: tuple[float, float],
    a_z: tuple[float, float],
    w: tuple[float, float],
    dw: tuple[float, float],
) -> Box:
    """A box of the seven scheduling variables from bounds on physical quantities.

    ``eta`` = v_z/Z 1/s, below 0 for a receding camera; ``turn`` = y w_x - x w_y 1/s, the rotation's part of
    the first zero; ``a_z`` m/s^2; ``w`` rad/s and ``dw`` rad/s^2 for x and y alike.

    >>> still = (0.0, 0.0)
    >>> camera_box((-0.5, -0.25), turn=(-0.125, 0.125), a_z=still, w=still, dw=still).bounds["zero"]
    (-0.625, -0.125)
    """
    try:
        zero = (eta[0] + turn[0], eta[1] + turn[1])
    except (TypeError, IndexError) as unusable:
        raise ParameterError(f"eta and turn need (low, high), received {eta!r} and {turn!r}") from unusable
    pairs = (zero, eta, a_z, w, w, dw, dw)
    return Box(dict(zip(SCHEDULED, pairs, strict=True)))
