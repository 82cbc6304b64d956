"""A moving camera: its velocity and the depth of a point, by an unknown input observer and by a filter."""

from pointpred.camera.bounds import consistent, cramer_rao, normalised_errors
from pointpred.camera.depth import Depth, DepthColumns, DepthObserver
from pointpred.camera.model import camera_box, camera_system, depth_rate, point_rate
from pointpred.camera.pipeline import CameraEstimate, CameraPipeline, CameraTable
from pointpred.camera.point_filter import PointEstimate, PointFilter, PointTrack
from pointpred.camera.samples import CameraColumns, CameraSample, Noise, simulate
from pointpred.camera.scenario import SCENARIOS, Scenario, Trajectory, trajectory
from pointpred.camera.velocity import WAYS, UnknownInputs, velocities

__all__ = [
    "SCENARIOS",
    "WAYS",
    "CameraColumns",
    "CameraEstimate",
    "CameraPipeline",
    "CameraSample",
    "CameraTable",
    "Depth",
    "DepthColumns",
    "DepthObserver",
    "Noise",
    "PointEstimate",
    "PointFilter",
    "PointTrack",
    "Scenario",
    "Trajectory",
    "UnknownInputs",
    "camera_box",
    "camera_system",
    "consistent",
    "cramer_rao",
    "depth_rate",
    "normalised_errors",
    "point_rate",
    "simulate",
    "trajectory",
    "velocities",
]
