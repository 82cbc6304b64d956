"""A rendered camera: a textured plane one metre ahead, seen along a known trajectory."""

from __future__ import annotations

import numpy as np

from pointpred_observers.camera.scenario import Trajectory

TEXTURE_PX, METRES = 1024, 2.0
WIDTH, HEIGHT = 320, 240


def texture(seed: int) -> np.ndarray:
    """Noise on several scales, so that something can be followed from near and from far."""
    import cv2

    random = np.random.default_rng(seed)
    total = np.zeros((TEXTURE_PX, TEXTURE_PX))
    for size in (3.0, 6.0, 12.0, 24.0, 48.0):
        layer = random.normal(size=(TEXTURE_PX, TEXTURE_PX))
        spread = int(3 * size)
        rolled = np.pad(layer, spread, mode="wrap")
        layer = cv2.GaussianBlur(rolled, (0, 0), size)[spread:-spread, spread:-spread]
        total += layer / layer.std()
    return np.clip(128.0 + 30.0 * total, 0.0, 255.0).astype(np.uint8)


def poses(truth: Trajectory) -> tuple[np.ndarray, np.ndarray]:
    """Rotation of the camera to the first frame, and its place there, integrated from w and v."""
    from scipy.spatial.transform import Rotation

    turn, place = [np.eye(3)], [np.zeros(3)]
    for k in range(len(truth.t) - 1):
        h = truth.t[k + 1] - truth.t[k]
        mean = 0.5 * (truth.w[k] + truth.w[k + 1])
        turn.append(turn[-1] @ Rotation.from_rotvec(h * mean).as_matrix())
        place.append(place[-1] + 0.5 * h * (turn[-2] @ truth.v[k] + turn[-1] @ truth.v[k + 1]))
    return np.array(turn), np.array(place)


def render(truth: Trajectory, focal_px: float, seed: int = 0) -> list[np.ndarray]:
    """An image at each time of a trajectory that starts 1 m in front of the plane, facing it."""
    import cv2

    picture = texture(seed)
    scale = METRES / TEXTURE_PX
    to_metres = np.array([[scale, 0.0, -0.5 * METRES], [0.0, scale, -0.5 * METRES], [0.0, 0.0, 1.0]])
    lens = np.array(
        [[focal_px, 0.0, 0.5 * (WIDTH - 1)], [0.0, focal_px, 0.5 * (HEIGHT - 1)], [0.0, 0.0, 1.0]]
    )
    images = []
    for turn, place in zip(*poses(truth), strict=True):
        plane = np.column_stack([turn.T[:, 0], turn.T[:, 1], turn.T @ (np.array([0.0, 0.0, 1.0]) - place)])
        homography = lens @ plane @ to_metres
        images.append(
            cv2.warpPerspective(
                picture, homography, (WIDTH, HEIGHT), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_WRAP
            )
        )
    return images
