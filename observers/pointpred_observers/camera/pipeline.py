"""Observer, velocity and Kalman filter together: samples in, depth and velocity out, with validity flags."""

from __future__ import annotations

from math import nan
from typing import Self

import msgspec
import numpy as np

from pointpred.columns import Columns
from pointpred.errors import EventError
from pointpred_observers.camera.depth import Depth, DepthColumns, DepthObserver
from pointpred_observers.camera.point_filter import PointEstimate, PointFilter
from pointpred_observers.camera.samples import CameraColumns, CameraSample
from pointpred_observers.camera.velocity import UnknownInputFilter, velocities

SURE = 2.0
"""Standard deviations by which the filter's eta must exceed -decay to clear ``detectable``."""


class CameraEstimate(msgspec.Struct, frozen=True):
    """Estimates after a sample: the observer's depth and velocity, and the Kalman filter's (``peer``).

    ``detectable``: the observer's own zeros lie below -decay and the filter does not contradict. If it is
    false the observer's errors do not decay: use ``peer`` if it is not ``None``.
    """

    depth: Depth
    velocity: tuple[float, float, float]
    detectable: bool
    peer: PointEstimate | None


class CameraTable(Columns[tuple[float, ...]]):
    """Estimates as columns, NaN if unknown; ``peer_`` columns are the filter's."""

    names = (
        *("t", "chi", "eta", "vx", "vy", "vz", "detectable", "certified", "image"),
        *("peer_chi", "peer_eta", "peer_vx", "peer_vy", "peer_vz", "peer_depth_spread"),
    )

    def _record(self, row: list[float]) -> tuple[float, ...]:
        return tuple(row)


class CameraPipeline:
    """A ``Stage[CameraSample, CameraEstimate]``: the unknown input observer with the filter as a check.

    The observer alone cannot distinguish an approaching from a receding camera if it was started with the
    wrong sign. The filter can, once the images determine the depth: if its eta lies above -decay by two
    standard deviations, ``detectable`` is false whatever the observer's estimate.

    Parameters: ``observer``; ``peer``; ``noise_px`` px, the standard deviation of the image, for the filter
    of the velocity. Raises EventError and EventOrderError and is then unchanged.
    """

    def __init__(self, observer: DepthObserver, peer: PointFilter, *, noise_px: float = 1.0) -> None:
        self.observer, self.peer = observer, peer
        self.unknown = UnknownInputFilter(focal_px=observer.focal_px, noise_px=noise_px)

    def reset(self) -> None:
        """Forget every sample."""
        for stage in (self.observer, self.peer, self.unknown):
            stage.reset()

    def fresh(self) -> Self:
        """The same parameters, without memory."""
        return type(self)(self.observer.fresh(), self.peer.fresh(), noise_px=self.unknown.noise_px)

    def update(self, sample: CameraSample, /) -> CameraEstimate:
        """Consume one sample; a refused one changes nothing."""
        memory = self.observer.remembered()  # it has moved on when the filter refuses the sample
        depth = self.observer.update(sample)
        try:
            peer = self.peer.update(sample)
        except EventError:
            self.observer.recall(memory)
            raise
        d = self.unknown.update(sample, depth.eta)[:2]
        vx, vy, vz = velocities(np.array([d]), DepthColumns([depth]))[0].tolist()
        denied = peer is not None and peer.eta - SURE * peer.eta_spread > -self.observer.decay
        return CameraEstimate(depth, (vx, vy, vz), depth.detectable and not denied, peer)

    def run(self, samples: CameraColumns) -> CameraTable:
        """Consume a table; when a row is refused the error names it and nothing is consumed."""
        rows, stages = [], (self.observer, self.peer, self.unknown)
        before = [stage.remembered() for stage in stages]
        for number, sample in enumerate(samples):
            try:
                rows.append(_row(self.update(sample)))
            except EventError as refused:
                for stage, memory in zip(stages, before, strict=True):
                    stage.recall(memory)
                words = f"row {number}: {refused}"
                raise type(refused)(words, field=refused.field, value=refused.value) from refused
        return CameraTable(np.array(rows).reshape(-1, len(CameraTable.names)))


def _row(one: CameraEstimate) -> tuple[float, ...]:
    depth, peer, other = one.depth, one.peer, (nan,) * 6
    if peer is not None:
        other = (peer.chi, peer.eta, *peer.state[3:].tolist(), peer.depth_spread)
    flags = (float(one.detectable), float(depth.certified), float(depth.image))
    return (depth.t, depth.chi, depth.eta, *one.velocity, *flags, *other)
