"""One point tracked through images by pyramidal Lucas-Kanade, with OpenCV."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pointpred.errors import EventError, ParameterError
from pointpred.extras import missing_extra
from pointpred.parameter import Parameter, check
from pointpred_observers.camera.samples import CameraColumns

Image = NDArray[np.uint8]


class PointTracker:
    """Tracks one point from image to image.

    Assumes grey images of one size, a point on a textured surface, and a motion of less than a few windows
    between two images. Errors accumulate like a random walk; the filter's assumption of independent noise is
    an approximation. A point that backward tracking does not lead back to its origin is not reported; the
    next image is compared with the last good one.

    Parameters: ``x``, ``y`` px from the image's centre, the point in the first image; ``window_px`` side of
    the compared window; ``back_px``, the largest error of tracking back. Memory: one image. Returns px from
    the image's centre, or ``None``. Raises MissingExtraError, ParameterError; EventError for anything but a
    grey image of the first one's size.

    Reference: Lucas, Kanade 1981; Kalal, Mikolajczyk, Matas 2010 (forward-backward error).
    """

    parameters = (
        Parameter("x", "px", -1e5, 1e5, "where the point is in the first image, from its centre"),
        Parameter("y", "px", -1e5, 1e5, "where the point is in the first image, from its centre"),
        Parameter("window_px", "px", 5, 201, "side of the window that is compared"),
        Parameter("back_px", "px", 1e-3, 100.0, "largest miss of a point that is followed back"),
    )
    LEVELS = 3

    def __init__(self, *, x: float = 0.0, y: float = 0.0, window_px: int = 31, back_px: float = 0.5) -> None:
        check(self.parameters, {"x": x, "y": y, "window_px": window_px, "back_px": back_px})
        self._opencv = _opencv()
        self.start = (float(x), float(y))
        self.window_px, self.back_px = int(window_px), float(back_px)
        self._image: Image | None = None
        self._point = np.zeros((1, 1, 2), np.float32)

    def reset(self) -> None:
        """Forget every image: the next one shows the point at its start position."""
        self._image = None

    def update(self, image: Image, /) -> tuple[float, float] | None:
        """Consume one image; ``None`` if the point was not found."""
        middle = self._middle(image)
        if self._image is None:
            inside = np.abs(self.start) <= middle
            if not inside.all():
                raise ParameterError(f"the point must lie in the image, received {self.start}")
            self._image, self._point = image.copy(), np.array([[self.start + middle]], np.float32)
            return self.start
        there, followed = self._follow(self._image, image, self._point)
        if not followed:
            return None
        again, followed = self._follow(image, self._image, there)
        if not followed or np.linalg.norm(again - self._point) > self.back_px:
            return None
        self._image, self._point = image.copy(), there
        x, y = (there[0, 0] - middle).tolist()
        return x, y

    def _follow(self, before: Image, after: Image, point: Any) -> tuple[Any, bool]:
        window = (self.window_px, self.window_px)
        kind = self._opencv.TERM_CRITERIA_EPS | self._opencv.TERM_CRITERIA_COUNT
        there, status, _ = self._opencv.calcOpticalFlowPyrLK(
            before, after, point, None, winSize=window, maxLevel=self.LEVELS, criteria=(kind, 50, 1e-3)
        )
        return there, bool(status[0, 0] == 1)

    def _middle(self, image: Image) -> Any:
        """Half the size of an image, so that pixel centres are whole numbers; checks the image."""
        grey = isinstance(image, np.ndarray) and image.ndim == 2 and image.dtype == np.uint8
        if not grey or min(image.shape) < self.window_px:
            received = getattr(image, "shape", image), getattr(image, "dtype", type(image))
            raise EventError(f"an image must be grey, 8 bits, larger than the window, received {received}")
        if self._image is not None and image.shape != self._image.shape:
            raise EventError(f"an image must have the shape {self._image.shape}, received {image.shape}")
        return 0.5 * (np.array(image.shape[::-1], np.float64) - 1.0)


def tracked(
    tracker: PointTracker, images: list[Image], readings: CameraColumns, every: int = 1
) -> CameraColumns:
    """The readings with x and y from the images, one image every ``every`` rows; NaN if the point was lost.

    Raises ParameterError if the number of images does not match the rows.
    """
    table = readings.table.copy()
    rows = range(0, len(table), every)
    if len(images) != len(rows):
        raise ParameterError(
            f"{len(rows)} images are needed, one every {every} of {len(table)} rows, received {len(images)}"
        )
    table[:, 1:3] = np.nan
    for row, image in zip(rows, images, strict=True):
        point = tracker.update(image)
        if point is not None:
            table[row, 1:3] = point
    return CameraColumns(table)


def _opencv() -> Any:
    try:
        import cv2
    except ImportError as missing:
        raise missing_extra("camera", "following a point in images needs OpenCV") from missing
    return cv2
